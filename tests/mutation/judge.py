"""The kit against one mutant: first the rows that do not wait, then all of them.

The first violated rule ends a run of the kit, so that most mutants cost a second or
two. Knows the command line of the kit and its report, nothing of operators.
"""

import contextlib
import json
import os
import signal
import subprocess
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from conformance.specification.ledger import load_ledger

ROOT = Path(__file__).parents[2]
# A server that answers nothing makes many checks wait for their timeouts.
CHECKS_S = 240
KIT_TIMEOUT_S = 400
# Rows that are judged by many generated requests: dear, and rarely the first to fail.
GENERATED = {"ERR-012", "MODEL-001", "MODEL-002"}


@dataclass(frozen=True, slots=True)
class Judgement:
    """outcome: killed, survived, undecided (rows without verdict) or unusable."""

    outcome: str
    failed: list[str]
    conclusion: str
    elapsed_s: float


def judge(
    kit: Sequence[str], start: str, seed: int, likely: Sequence[str] = ()
) -> Judgement:
    """Run the kit against the server of a start command; `likely` rules come first."""
    rules = _in_order(likely)
    quick = _run(kit, start, seed, ["--quick", "--only", ",".join(rules)])
    if quick.outcome in ("killed", "unusable"):
        return quick
    # Checks do less when it has to be quick, so that what passed may fail now.
    return _run(kit, start, seed, [])


def _in_order(likely: Sequence[str]) -> list[str]:
    """All rules: those that are likely to fail, then the cheap ones."""
    rules = [*likely, *(id_ for id_ in load_ledger() if id_ not in likely)]
    known = [id_ for id_ in rules if id_ in load_ledger()]
    return sorted(known, key=lambda id_: id_ in GENERATED)


def _run(
    kit: Sequence[str], start: str, seed: int, selection: Sequence[str]
) -> Judgement:
    with tempfile.TemporaryDirectory(prefix="proctor-mutation-") as report:
        options = ["--fail-fast", "--max-time", str(CHECKS_S), "--seed", str(seed)]
        command = [*kit, "--start-cmd", start, "--report", report, *options]
        is_late = _is_late([*command, *selection])
        file = Path(report, "report.json")
        found = json.loads(file.read_text()) if file.exists() else None
    if found is None:
        return Judgement("unusable", [], "the kit wrote no report", 0.0)
    failed = _rows(found, "failed")
    if found["exit_code"] == 1:
        outcome = "killed"
    elif found["exit_code"] == 0:
        outcome = "survived"
    else:
        outcome = "unusable" if found["problem"] or is_late else "undecided"
    elapsed_s = found["elapsed_s"]
    return Judgement(outcome, failed, found["conclusion"], elapsed_s)


def _rows(report: dict[str, Any], outcome: str) -> list[str]:
    rows = (row for row in report["rows"] if row["outcome"] == outcome)
    return [row["requirement_id"] for row in rows]


def _is_late(command: Sequence[str]) -> bool:
    """Run the kit; ask it to end when it takes too long, so that its server ends."""
    process = subprocess.Popen(
        command,
        cwd=ROOT,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        start_new_session=True,
    )
    for number in (signal.SIGTERM, signal.SIGKILL):
        try:
            process.wait(KIT_TIMEOUT_S if number == signal.SIGTERM else 30)
        except subprocess.TimeoutExpired:
            with contextlib.suppress(ProcessLookupError):
                os.killpg(process.pid, number)
        else:
            return number == signal.SIGKILL
    process.wait()
    return True
