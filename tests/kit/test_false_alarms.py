"""The measurement of false alarms goes on where it was interrupted."""

import json
from pathlib import Path
from typing import Any

import pytest

from tools.measurements import false_alarms
from tools.measurements.false_alarms import FIRST_SEED, measure, read_results

SERVERS = {"reference": "one", "JavaScript": "two"}


def test_no_run_of_a_commit_is_repeated(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    made: list[tuple[str, int]] = []

    def run_kit(server: str, seed: int, _: list[str]) -> dict[str, Any]:
        if seed == FIRST_SEED + 2 and len(made) == 2:
            raise KeyboardInterrupt
        made.append((server, seed - FIRST_SEED))
        return {"exit_code": 0, "elapsed_s": 0.1, "alarms": {}}

    results = tmp_path / "results.jsonl"
    results.write_text(json.dumps({"commit": "older", "seed": FIRST_SEED}) + "\n")
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
    lines = results.read_text().splitlines()
    assert len(lines) == len(read_results("this")) == 6
