"""The kit against right servers with small limits: no row is violated."""

import shlex
from pathlib import Path

import pytest

from tests.support.forking.forked_servers import server_command
from tests.support.kit.run_kit import KitRun, run_kit

pytestmark = pytest.mark.slow("runs whole kits")

SHORT = ["--idle-timeout-s-max", "3", "--heartbeat-s-max", "3", "--max-workers", "1"]
SMALL = ["--max-body-bytes", "65536", "--max-chunk", "4"]
FEW = ["--max-open-runs", "30", "--max-idempotency-keys", "40"]


def judge(report: Path, server: list[str], *options: str) -> KitRun:
    """Run the kit against the reference server with other limits."""
    start = shlex.join([*server_command(), *server])
    return run_kit(report, *options, "--start-cmd", start)


def reasons(kit: KitRun, outcome: str) -> dict[str, str]:
    """Why rows have an outcome, by their rules."""
    return {
        rule: f"{row['reason']} {row['expected']} {row['observed']}"
        for rule, row in kit.rows.items()
        if row["outcome"] == outcome and not row["allowed"]
    }


def test_short_leases_and_small_requests_are_in_order(tmp_path: Path) -> None:
    """Leases of 3 s, one worker, chunks of 4. Expect a verdict on every rule that the
    clock lets be judged, and none violated."""
    kit = judge(tmp_path, [*SHORT, *SMALL])
    for outcome in ("failed", "kit_error", "not_verified"):
        assert reasons(kit, outcome) == {}, outcome
    for rule, reason in reasons(kit, "inconclusive").items():
        assert "longer `idle_timeout_s_max`" in reason, rule


def test_a_quota_that_the_kit_uses_up_is_no_violation(tmp_path: Path) -> None:
    """30 open runs and 40 keys. Expect what to do in each row that is left open."""
    kit = judge(tmp_path, FEW, "--quick")
    assert kit.code == 2
    for outcome in ("failed", "kit_error", "inconclusive"):
        assert reasons(kit, outcome) == {}, outcome
    left = reasons(kit, "not_verified")
    assert left
    for rule, reason in left.items():
        assert "raise it for this account" in reason, rule
