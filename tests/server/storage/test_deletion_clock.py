"""A clock that is far ahead deletes nothing before the network may have set it."""

from __future__ import annotations

import time
from pathlib import Path
from types import SimpleNamespace

import pytest

from reference_server.storage.runs import deletion_clock
from reference_server.storage.runs.deletion_clock import WAIT_S, DeletionClock
from tests.support.server.server_parts import (
    ServerParts,
    calibration_run,
    run_scenario,
)

DAY_S = 86_400.0


@pytest.mark.parametrize(
    ("ages_days", "up_s", "is_trusted"),
    [
        ((), 0.0, True),
        ((400.0, 0.5), 0.0, True),
        ((400.0, 1.5), 0.0, False),
        ((400.0,), WAIT_S - 1, False),
        ((400.0,), WAIT_S, True),
    ],
)
def test_a_day_without_a_change_is_trusted_after_an_hour(
    ages_days: tuple[float, ...],
    up_s: float,
    is_trusted: bool,
    tmp_path: Path,
    caplog: pytest.LogCaptureFixture,
) -> None:
    began, now = time.monotonic(), time.time()

    async def story(parts: ServerParts) -> None:
        for number, days in enumerate(ages_days):
            run = calibration_run(run_id=f"run_{number}", state="completed")
            run.updated_at_wall = now - days * DAY_S
            await parts.store.insert(run, None, "")
        clock = DeletionClock(parts.store)
        clock._since = began
        times = SimpleNamespace(monotonic=lambda: began + up_s, time=lambda: now)
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(deletion_clock, "time", times)
            assert await clock.is_trusted() is is_trusted

    run_scenario(tmp_path, story)
    said = [record.getMessage() for record in caplog.records]
    assert ["nothing is deleted for its age" in text for text in said] == (
        [] if is_trusted else [True]
    )
