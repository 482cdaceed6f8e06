"""The kit against right servers with small limits: no row is violated."""

import json
import shlex
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from tests.support.forking.forked_servers import server_command
from tests.support.paths import ROOT

pytestmark = pytest.mark.slow("runs whole kits")

SHORT = ["--idle-timeout-s-max", "3", "--heartbeat-s-max", "3", "--max-workers", "1"]
SMALL = ["--max-body-bytes", "65536", "--max-chunk", "4"]
FEW = ["--max-open-runs", "30", "--max-idempotency-keys", "40"]


def judge(report: Path, server: list[str], *options: str) -> dict[str, Any]:
    """Run the kit against the reference server with other limits; give its report."""
    start = shlex.join([*server_command(), *server])
    kit = [sys.executable, "-m", "conformance", "--report", str(report), *options]
    subprocess.run(
        [*kit, "--start-cmd", start],
        cwd=ROOT,
        stdout=subprocess.DEVNULL,
        timeout=300,
        check=False,
    )
    found: dict[str, Any] = json.loads((report / "report.json").read_text())
    return found


def reasons(found: dict[str, Any], outcome: str) -> dict[str, str]:
    """Why rows have an outcome, by their rules."""
    return {
        row["requirement_id"]: f"{row['reason']} {row['expected']} {row['observed']}"
        for row in found["rows"]
        if row["outcome"] == outcome and not row["allowed"]
    }


def test_short_leases_and_small_requests_are_in_order(tmp_path: Path) -> None:
    """Leases of 3 s, one worker, chunks of 4. Expect a verdict on every rule that the
    clock lets be judged, and none violated."""
    found = judge(tmp_path, [*SHORT, *SMALL])
    for outcome in ("failed", "kit_error", "not_verified"):
        assert reasons(found, outcome) == {}, outcome
    for rule, reason in reasons(found, "inconclusive").items():
        assert "longer `idle_timeout_s_max`" in reason, rule


def test_a_quota_that_the_kit_uses_up_is_no_violation(tmp_path: Path) -> None:
    """30 open runs and 40 keys. Expect what to do in each row that is left open."""
    found = judge(tmp_path, FEW, "--quick")
    assert found["exit_code"] == 2
    for outcome in ("failed", "kit_error", "inconclusive"):
        assert reasons(found, outcome) == {}, outcome
    left = reasons(found, "not_verified")
    assert left
    for rule, reason in left.items():
        assert "raise it for this account" in reason, rule
