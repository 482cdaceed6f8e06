"""Submissions as they are stored: created, counted, stopped, ended by deadlines."""

from __future__ import annotations

import msgspec
import pytest

from reference_platform.accounts.organisations import Owner
from reference_platform.parts import Parts
from reference_platform.submissions.lifecycle import Event, Submission
from reference_platform.tracks.track_rules import AskedRun, Phase, Track
from reference_server.rules.refusal import Refused
from tests.support.platform.approved_accounts import approved
from tests.support.platform.read_runs import ShownRuns

TO_VERIFIED: tuple[Event, ...] = ("upload", "begin_verification", "pass_verification")


def create(
    parts: Parts, account: str, per_day: int | None = None, total: int | None = None
) -> Submission:
    now = parts.clock()
    phase = Phase("main", "calibration", now, now + 1e7, per_day=per_day, total=total)
    parts.tracks.put(Track("letters", "Letters", (phase,)), "a test")
    parts.tracks.enter("letters", Owner(account))
    return parts.submissions.create(account, "letters", policy_name="mine")


def verify(parts: Parts, submission: Submission) -> str:
    for event in TO_VERIFIED:
        parts.submissions.move(submission.submission_id, event)
    return submission.submission_id


async def test_what_cannot_be_started_is_not_uploaded(parts: Parts, ada: str) -> None:
    """A day has room again, and a total never: that is refused before an upload."""
    first = verify(parts, create(parts, ada, per_day=1, total=2))
    parts.submissions.start(first, [ada])
    second = create(parts, ada, per_day=1, total=2)
    assert "The window opens again at" in second.reason
    with pytest.raises(Refused, match="allows 1 run in all"):
        create(parts, ada, per_day=1, total=1)


async def test_its_own_run_is_not_counted_again(parts: Parts, ada: str) -> None:
    """The run of the sandbox is admitted while the submission waits for it, once."""
    url = "http://0123.sandbox.invalid"
    asked = AskedRun("run_1", ada, "calibration", policy_url=url)
    name = verify(parts, create(parts, ada, total=1))
    parts.submissions.start(name, [ada])
    with pytest.raises(Refused):
        await parts.tracks.admit(asked, ShownRuns())
    parts.submissions.move(name, "begin_run")
    await parts.tracks.admit(asked, ShownRuns())
    parts.submissions.note_run(name, "run_1", is_verification=False)
    with pytest.raises(Refused):
        await parts.tracks.admit(asked, ShownRuns())


async def test_a_stop_leaves_no_run_of_its_own(parts: Parts, ada: str) -> None:
    """It is stopped before its run is made, or before the run is known here.

    Expect no run that counts besides it, and its run to be its own.
    """
    url = "http://0123.sandbox.invalid"
    asked = AskedRun("run_1", ada, "calibration", policy_url=url)
    name = verify(parts, create(parts, ada, total=5))
    parts.submissions.start(name, [ada])
    parts.submissions.move(name, "begin_run")
    parts.submissions.stop(name, [ada])
    with pytest.raises(Refused, match="No submission waits for this run"):
        await parts.tracks.admit(asked, ShownRuns())
    assert [run.run_id for run in parts.tracks.runs_of(ada)] == [name]
    parts.submissions.note_run(name, "run_1", is_verification=False)
    stopped = parts.submissions.get(name)
    assert (stopped.state, stopped.run_id) == ("stopped", "run_1")
    assert stopped.verification_run_id != "run_1"


async def test_who_has_not_entered_a_track_is_led_to_its_page(
    parts: Parts, ada: str
) -> None:
    create(parts, ada)
    eve = await approved(parts, "eve")
    with pytest.raises(Refused, match="eve has not entered the track letters") as no:
        parts.submissions.create(eve, "letters", policy_name="mine")
    assert no.value.act == "Enter it on its page, /hosting/tracks/letters."


async def test_a_phase_with_submissions_stays(parts: Parts, ada: str) -> None:
    """A track is put without its phase. Expect a refusal, and none for a new phase."""
    create(parts, ada)
    track = parts.tracks.get("letters")
    other = msgspec.structs.replace(track.phases[0], phase_id="other")
    with pytest.raises(Refused, match="so it stays"):
        parts.tracks.put(msgspec.structs.replace(track, phases=(other,)), "a test")
    more = msgspec.structs.replace(track, phases=(*track.phases, other))
    parts.tracks.put(more, "a test")
    parts.tracks.put(track, "a test")  # nothing was made in the other one


@pytest.mark.parametrize(
    ("track_id", "phase_id", "taken"),
    [
        ("letters", "", "first"),  # of two that close at one time
        ("letters", "test", "test"),
        ("letters", "tset", ("The track letters has no phase tset. There are: "
          "first, late, test.")),
        ("lettres", "", "There is no track lettres. There are: digits, letters."),
    ],
)  # fmt: skip
async def test_the_phase_is_one_that_is_said(
    parts: Parts, ada: str, track_id: str, phase_id: str, taken: str
) -> None:
    now = parts.clock()
    closing = {"late": now + 2e7, "first": now + 1e7, "test": now + 1e7}
    phases = [Phase(name, "calibration", now, at) for name, at in closing.items()]
    for name in ("digits", "letters"):
        parts.tracks.put(Track(name, name, tuple(phases)), "a test")
    parts.tracks.enter("letters", Owner(ada))
    try:
        made = parts.submissions.create(ada, track_id, phase_id=phase_id)
    except Refused as refused:
        answer = refused.sentences
    else:
        answer = made.phase_id
    assert answer == taken


async def test_a_submission_has_one_state_everywhere(parts: Parts, ada: str) -> None:
    """Also among the runs of its track, where it counts against the limits."""
    name = verify(parts, create(parts, ada))
    parts.submissions.start(name, [ada])
    events: tuple[tuple[Event, int], ...] = (("begin_run", 1), ("fail", 0))
    for event, open_runs in events:
        moved = parts.submissions.move(name, event, cause="policy")
        (run,) = parts.tracks.runs_of(ada, "letters")
        assert (run.is_hosted, run.state) == (True, moved.state)
        assert run.is_open == bool(open_runs)
