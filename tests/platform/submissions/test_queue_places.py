"""The queue of the sandboxes, in the words that a participant reads."""

from __future__ import annotations

from typing import Any

import pytest

from reference_platform.accounts.organisations import Owner
from reference_platform.images.image_reviews import ImageReviews
from reference_platform.parts import Parts
from reference_platform.submissions.lifecycle import Event
from reference_platform.submissions.queue_places import place_text, with_place
from reference_platform.tracks.track_rules import Phase, Seeds, Track
from tests.support.platform.approved_accounts import Clock

AT = 1_800_000_000.0
SINCE = "since 2027-01-15 08:00:00 UTC."
BUSY = f"is busy {SINCE}"
UPLOADED: tuple[Event, ...] = ("upload",)
VERIFYING: tuple[Event, ...] = ("upload", "begin_verification")
QUEUED: tuple[Event, ...] = (*VERIFYING, "pass_verification", "start")


@pytest.mark.parametrize(
    ("before", "busy_since", "said"),
    [
        (0, (), ""),
        (0, (AT,), f"The sandbox {BUSY}"),
        (1, (AT,), f"1 submission is before it. The sandbox {BUSY}"),
        (2, (), "2 submissions are before it."),
        (
            2,
            (AT, AT + 60),
            f"2 submissions are before it. 2 sandboxes are busy, the longest {SINCE}",
        ),
    ],
)
def test_the_place_is_a_sentence(
    before: int, busy_since: tuple[float, ...], said: str
) -> None:
    assert place_text(before, busy_since) == said


def enter(parts: Parts, ada: str) -> None:
    now = parts.clock()
    kinds: tuple[Seeds, ...] = ("benchmark", "held_out")
    phases = [
        Phase(seeds, "calibration", now, now + 1e6, seeds=seeds) for seeds in kinds
    ]
    parts.tracks.put(Track("letters", "Letters", tuple(phases)), "a test")
    parts.tracks.enter("letters", Owner(ada))


def hand_in(parts: Parts, clock: Clock, *events: Event, **how: Any) -> str:
    """The id of a submission that has come so far a second after the one before."""
    clock.now += 1
    how = {"kind": "code", "preset": "python", "phase_id": "benchmark"} | how
    name = parts.submissions.create("ada", "letters", **how).submission_id
    for event in events:
        parts.submissions.move(name, event, digest=f"sha256:{name}")
    return name


def said_of(parts: Parts, name: str) -> str:
    store = parts.submissions
    before = store.get(name)
    return with_place(store, before).reason.removeprefix(before.reason).strip()


async def test_the_order_is_that_of_the_supervisor(
    parts: Parts, clock: Clock, ada: str
) -> None:
    """Verifications come before evaluations. What may not be played counts for none."""
    enter(parts, ada)
    playing = hand_in(parts, clock, *VERIFYING)
    waiting = [hand_in(parts, clock, *QUEUED), hand_in(parts, clock, *UPLOADED)]
    sealed = hand_in(parts, clock, *QUEUED, phase_id="held_out")
    image = hand_in(parts, clock, *UPLOADED, kind="image", preset="")
    last = hand_in(parts, clock, *UPLOADED)
    busy = "The sandbox is busy since 2027-01-15 08:00:01 UTC."
    assert said_of(parts, waiting[1]) == busy
    assert said_of(parts, last) == f"1 submission is before it. {busy}"
    assert said_of(parts, waiting[0]) == f"2 submissions are before it. {busy}"
    for name in (playing, sealed, image):
        assert said_of(parts, name) == ""
    reviews = ImageReviews(parts.database, parts.clock)
    reviews.add(f"sha256:{image}", ada, 1, "")
    reviews.decide(f"sha256:{image}", "approve", "", "boss")
    assert said_of(parts, image) == f"1 submission is before it. {busy}"
    assert said_of(parts, last) == f"2 submissions are before it. {busy}"
