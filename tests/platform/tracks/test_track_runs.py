"""Runs that count for a track: admitted at the server, refreshed, refunded."""

from __future__ import annotations

from typing import Any

import pytest

from reference_platform.accounts.organisations import Owner
from reference_platform.parts import Parts
from reference_platform.tracks.track_rules import AskedRun, Phase, Track
from reference_platform.tracks.tracks import UNKNOWN_S
from reference_server.rules.refusal import Refused
from tests.support.platform.approved_accounts import Clock
from tests.support.platform.read_runs import ShownRuns


def asked(number: int) -> AskedRun:
    return AskedRun(f"run_{number}", "ada", "calibration")


async def enter(parts: Parts, ada: str, **changed: Any) -> None:
    now = parts.clock()
    of_track = {n: changed.pop(n) for n in ("entry", "accounts") if n in changed}
    phase = Phase("main", "calibration", now, now + 1e6, **changed)
    parts.tracks.put(Track("letters", "Letters", (phase,), **of_track), "a test")
    parts.tracks.enter("letters", Owner(ada))


@pytest.mark.parametrize(
    ("state", "mode", "admits"),
    [
        ("completed", "pull", True),
        ("stopped", "pull", True),
        ("failed", "pull", True),
        ("running", "pull", False),
        ("queued", "push", False),
    ],
)
async def test_a_run_that_has_ended_makes_room(
    parts: Parts, ada: str, state: str, mode: str, admits: bool
) -> None:
    await enter(parts, ada, at_once=1)
    server = ShownRuns()
    await parts.tracks.admit(asked(1), server)
    server.runs["run_1"] = {"state": state, "mode": mode}
    if admits:
        await parts.tracks.admit(asked(2), server)
    else:
        with pytest.raises(Refused, match="at a time"):
            await parts.tracks.admit(asked(2), server)


async def test_a_run_that_was_never_made_is_not_counted(
    parts: Parts, clock: Clock, ada: str
) -> None:
    """The server was killed between the question and the run."""
    await enter(parts, ada, total=1)
    await parts.tracks.admit(asked(1), ShownRuns())
    with pytest.raises(Refused):
        await parts.tracks.admit(asked(2), ShownRuns())
    clock.now += UNKNOWN_S + 1
    await parts.tracks.admit(asked(2), ShownRuns())
    parts.tracks.withdraw("run_2")
    await parts.tracks.admit(asked(3), ShownRuns())


@pytest.mark.parametrize(
    ("entry", "accounts", "state"),
    [
        ("open", (), "entered"),
        ("review", (), "waiting"),
        ("listed", ("ada",), "entered"),
        ("listed", ("eve",), None),
    ],
)
async def test_who_may_enter(
    parts: Parts, ada: str, entry: Any, accounts: tuple[str, ...], state: str | None
) -> None:
    if state is None:
        with pytest.raises(Refused, match="Only accounts that the host has listed"):
            await enter(parts, ada, entry=entry, accounts=accounts)
        return
    await enter(parts, ada, entry=entry, accounts=accounts)
    entrant = parts.tracks.entrant("letters", ada)
    assert entrant is not None
    assert entrant.state == state
    if state == "waiting":
        with pytest.raises(Refused, match="entered no track"):
            await parts.tracks.admit(asked(1), ShownRuns())
        parts.tracks.decide_entry("letters", ada, accept=True, reason="", actor="boss")
    await parts.tracks.admit(asked(1), ShownRuns())
