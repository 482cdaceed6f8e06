"""The steps of a held-out phase: when each leaf is due, and what waits for it."""

from __future__ import annotations

import msgspec
import pytest

from reference_platform.accounts.organisations import Owner
from reference_platform.parts import Parts
from reference_platform.submissions.lifecycle import WAITING
from reference_platform.tracks.phase_draws import AppendedLeaf
from reference_platform.tracks.track_rules import Phase, Place, Track, said_time
from reference_server.rules.refusal import Refused
from tests.support.platform.approved_accounts import Clock


class History:
    """It implements `phase_draws.DrawHistory`. kinds: of the leaves."""

    def __init__(self) -> None:
        self.kinds: list[str] = []
        self.is_away = False

    async def append(self, kind: str, draw_id: str, digest: str = "") -> AppendedLeaf:
        assert draw_id == "letters/test"
        if self.is_away:
            raise Refused("unavailable", "The server does not answer.")
        self.kinds.append(kind)
        return AppendedLeaf(len(self.kinds) - 1, "0" * 64)


def seeds_of(parts: Parts, track: Track) -> str:
    """As the page of the track shows them."""
    place = Place(track, track.phases[0])
    return parts.tracks.draws.describe(place, parts.clock())


def test_a_phase_without_submissions_has_no_draw(parts: Parts, clock: Clock) -> None:
    phase = Phase("test", "calibration", 0.0, clock.now, seeds="held_out")
    said = seeds_of(parts, Track("letters", "Letters", (phase,)))
    assert said == "were not drawn, as no submission was started"


async def test_a_draw_comes_after_every_commit(
    parts: Parts, clock: Clock, ada: str
) -> None:
    """HST-029, HST-030: the server is away while a policy is started and at the end.

    Expect the leaves in their order, and no evaluation before the draw.
    """
    now, history, draws = clock.now, History(), parts.tracks.draws
    phase = Phase("test", "calibration", now, now + 100, seeds="held_out")
    track = Track("letters", "Letters", (phase,))
    parts.tracks.put(track, "a test")
    parts.tracks.enter("letters", Owner(ada))
    await draws.advance(Place(track, phase), history, clock.now)
    at = said_time(phase.closes_at)
    assert seeds_of(parts, track) == (
        f"are drawn when the phase closes, at {at}, after every submission was "
        "committed to"
    )
    name = parts.submissions.create(ada, "letters").submission_id
    for event in ("upload", "begin_verification", "pass_verification"):
        parts.submissions.move(name, event)
    history.is_away = True
    parts.submissions.start(name, [ada])
    # The host gives more time; the deadline of what waits follows.
    longer = msgspec.structs.replace(phase, closes_at=now + 1000)
    place = Place(msgspec.structs.replace(track, phases=(longer,)), longer)
    parts.tracks.put(place.track, "a test")
    (changed,) = parts.submissions.wait_for_draws()
    assert f"closes, at {said_time(longer.closes_at)}." in changed.reason
    assert not parts.submissions.wait_for_draws()
    deadline = longer.closes_at + WAITING["queued"].deadline_s
    assert parts.submissions.get(name).deadline_at == deadline
    clock.now = longer.closes_at
    left = "still to be evaluated: 1 submission"
    assert seeds_of(parts, place.track) == (
        f"are drawn now, as the phase has closed; {left}"
    )
    with pytest.raises(Refused):
        await draws.advance(place, history, clock.now)
    assert (history.kinds, draws.may_play(place)) == (["seal"], False)
    history.is_away = False
    for _ in range(3):
        await draws.advance(place, history, clock.now)
    assert history.kinds == ["seal", "commit", "draw"]
    assert draws.may_play(place)
    was_drawn = "were drawn after the phase closed"
    assert seeds_of(parts, place.track) == f"{was_drawn}; {left}"
    (changed,) = parts.submissions.wait_for_draws()
    assert changed.reason.startswith("Its phase has closed, and the seeds are drawn.")
    assert not parts.submissions.wait_for_draws()
    assert draws.seeds_of(place) == {
        "draw_id": "letters/test",
        "tree_size": 2,
        "root_sha256": "0" * 64,
    }
    with pytest.raises(Refused, match="were drawn, so it stays"):
        parts.tracks.put(track, "a test")
    parts.submissions.move(name, "begin_run")
    parts.submissions.move(name, "complete")
    for _ in range(2):
        await draws.advance(place, history, clock.now)
        said = f"{was_drawn}; still to be evaluated: 0 submissions"
        assert seeds_of(parts, place.track) == said
    assert history.kinds == ["seal", "commit", "draw", "open"]
