"""The measurement of false alarms goes on where it was interrupted."""

import contextlib
import json
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import psutil
import pytest

from tools.measurements import false_alarms
from tools.measurements.false_alarms import (
    FIRST_SEED,
    halt_until_end,
    halted,
    measure,
    page,
    read_results,
    results_of,
)

STARTS_ANOTHER = "import subprocess; subprocess.run(['sleep', '0.5'], check=True)"
SERVERS = {"reference": "one", "JavaScript": "two"}


def test_no_run_of_a_commit_is_repeated(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    made: list[tuple[str, int]] = []

    def run_kit(server: str, seed: int, *_: object) -> dict[str, Any]:
        if seed == FIRST_SEED + 2 and len(made) == 2:
            raise KeyboardInterrupt
        made.append((server, seed - FIRST_SEED))
        return {"exit_code": 0, "elapsed_s": 0.1, "alarms": {}}

    results = tmp_path / "results.jsonl"
    older = {"commit": "older", "options": [], "seed": FIRST_SEED}
    results.write_text(json.dumps(older) + "\n")
    monkeypatch.setattr(false_alarms, "RESULTS", results)
    monkeypatch.setattr(false_alarms, "start_commands", lambda _: SERVERS)
    monkeypatch.setattr(false_alarms, "run_kit", run_kit)
    with pytest.raises(KeyboardInterrupt):
        measure(5, at_once=1, load="quiet", options=[], commit="this")
    measure(5, at_once=2, load="quiet", options=[], commit="this")
    measure(1, at_once=1, load="quiet", options=["--quick"], commit="this")
    assert made.pop() == ("one", 0)
    assert sorted(made, key=lambda run: run[1]) == [
        *(("one", 0), ("one", 1), ("two", 2), ("two", 3), ("one", 4))
    ]
    assert len(results_of(read_results(), "this")) == 6
    assert [one["commit"] for one in read_results()] == ["older", *["this"] * 6]


def test_a_halted_process_goes_on_until_its_end(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    halts: list[int] = []

    @contextlib.contextmanager
    def noted(process: psutil.Process) -> Iterator[None]:
        with halted(process):
            while process.status() not in (psutil.STATUS_STOPPED, psutil.STATUS_ZOMBIE):
                time.sleep(0.001)
            halts.append(process.pid)
            yield

    monkeypatch.setattr(false_alarms, "_BETWEEN_HALTS_S", 0.02)
    monkeypatch.setattr(false_alarms, "_LONGEST_HALT_S", 0.02)
    monkeypatch.setattr(false_alarms, "halted", noted)
    with subprocess.Popen([sys.executable, "-c", STARTS_ANOTHER]) as process:
        halt_until_end(process, seed=1)
        assert process.returncode == 0
    assert len(set(halts)) == 2


def test_page_shows_runs_and_alarms() -> None:
    alarms = {"RUN-001": "failed: why"}
    results = [run_of(["--quick"], alarms), run_of([]), run_of([])]
    text = page(results, "this", "2026-11-28")
    assert "| one | whole | quiet | 2 | 0 | – | 3 s |" in text
    assert "| one | --quick | quiet | 1 | 1 | RUN-001 | 3 s |" in text
    assert text.endswith(", seed 1, quiet:\n  - RUN-001: failed: why\n")


def run_of(options: list[str], alarms: dict[str, str] | None = None) -> dict[str, Any]:
    line = {"server": "one", "seed": 1, "load": "quiet", "elapsed_s": 3.0}
    return line | {"options": options, "alarms": alarms or {}}
