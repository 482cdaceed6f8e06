"""Each state that lasts is ended by its deadline, and its sandbox is free again."""

from __future__ import annotations

import asyncio
from pathlib import Path
from typing import Any, cast

import pytest

from reference_platform.accounts.organisations import Owner
from reference_platform.images.image_reviews import ImageReviews
from reference_platform.parts import Parts
from reference_platform.submissions.interfaces import Outcome
from reference_platform.submissions.lifecycle import WAITING, Event, State
from reference_platform.submissions.submission_logs import FileLogs
from reference_platform.submissions.submission_supervisor import SubmissionSupervisor
from reference_platform.tracks.track_rules import Phase, Track
from tests.support.platform.approved_accounts import Clock

VERIFIED: tuple[Event, ...] = ("upload", "begin_verification", "pass_verification")
# State → how a submission gets there; a played one when there is a sandbox for it.
WAYS: dict[State, tuple[Event, ...]] = {
    "created": (),
    "uploaded": VERIFIED[:1],
    "verifying": VERIFIED[:1],
    "verified": VERIFIED,
    "queued": (*VERIFIED, "start"),
    "running": (*VERIFIED, "start"),
}
PLAYED = ("verifying", "running")
CLOSES_S = 30 * 86_400.0


class StoppedRunner:
    """A policy that plays until it is stopped. Fits PolicyRunner."""

    def __init__(self) -> None:
        self.playing: dict[str, asyncio.Event] = {}

    async def verify(self, submission: Any, *_: Any) -> Outcome:
        stopped = self.playing[submission.submission_id] = asyncio.Event()
        await stopped.wait()
        del self.playing[submission.submission_id]
        return Outcome(False, "It was stopped.", "owner")

    evaluate = verify

    async def stop(self, submission_id: str) -> None:
        if submission_id in self.playing:
            self.playing[submission_id].set()

    async def remove_files(self, *_: Any, **__: Any) -> None:
        """There are none."""


def submitted(parts: Parts, phase_id: str, *events: Event) -> str:
    store = parts.submissions
    made = store.create(
        "ada", "letters", kind="code", preset="python", phase_id=phase_id
    )
    for event in events:
        if event == "start":
            store.start(made.submission_id, ["ada"])
        else:
            store.move(made.submission_id, event)
    return made.submission_id


def supervisor_of(
    parts: Parts, folder: Path, sandboxes: int
) -> tuple[SubmissionSupervisor, FileLogs, StoppedRunner]:
    closes_at = parts.clock() + CLOSES_S
    phases = (
        Phase("open", "calibration", 0, closes_at, total=2),
        Phase("held", "calibration", 0, closes_at, total=1, seeds="held_out"),
    )
    parts.tracks.put(Track("letters", "Letters", phases), "a test")
    parts.tracks.enter("letters", Owner("ada"))
    logs, runner = FileLogs(folder / "logs", lambda _name: True), StoppedRunner()
    supervisor = SubmissionSupervisor(
        parts.submissions, ImageReviews(parts.database), cast("Any", runner), logs,
        at_once=sandboxes,
    )  # fmt: skip
    return supervisor, logs, runner


@pytest.mark.usefixtures("ada")
@pytest.mark.parametrize("state", [*WAITING])
async def test_a_deadline_ends_each_state(
    parts: Parts, clock: Clock, tmp_path: Path, state: State
) -> None:
    """The clock passes it. Expect the end that the table says, in state and log.

    A policy that is played is stopped, and the next one has its sandbox.
    """
    is_played = state in PLAYED
    supervisor, logs, runner = supervisor_of(parts, tmp_path, int(is_played))
    name, store = submitted(parts, "open", *WAYS[state]), parts.submissions
    await supervisor._look()
    await asyncio.sleep(0)  # what is begun is played
    before, expected = store.get(name), WAITING[state]
    assert before.state == state
    clock.now += expected.deadline_s - 1
    await supervisor._look()
    assert store.get(name) == before
    clock.now += 1
    await supervisor._look()
    ended = store.get(name)
    assert ended.state == {"expire": "expired", "fail": "failed"}[expected.event]
    assert ended.cause == expected.cause
    assert ended.is_counted == (state == "running")  # which the policy caused
    if is_played:
        following = submitted(parts, "open", "upload")
        for _ in range(3):
            await asyncio.sleep(0)  # what is stopped ends, and what is begun is played
            await supervisor._look()
        assert [*runner.playing] == [following]
    assert logs.last_text(name) == f"State {ended.state}: {ended.reason}"


@pytest.mark.usefixtures("ada")
async def test_a_deadline_ends_the_wait_for_seeds(
    parts: Parts, clock: Clock, tmp_path: Path
) -> None:
    """No draw follows the end of a phase. Expect a fault of the platform, uncounted."""
    supervisor, logs, _ = supervisor_of(parts, tmp_path, sandboxes=1)
    name = submitted(parts, "held", *WAYS["queued"])
    clock.now += CLOSES_S + WAITING["queued"].deadline_s - 1
    await supervisor._look()
    assert parts.submissions.get(name).state == "queued"
    clock.now += 1
    await supervisor._look()
    ended = parts.submissions.get(name)
    assert (ended.state, ended.cause) == ("failed", "platform")
    assert not ended.is_counted
    assert logs.last_text(name) == f"State {ended.state}: {ended.reason}"
