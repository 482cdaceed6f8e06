"""The kit and a server with limits that are small enough to be judged."""

from __future__ import annotations

import shlex
from pathlib import Path

import pytest

from tests.support.forking.forked_servers import server_command
from tests.support.kit.run_kit import run_kit

pytestmark = pytest.mark.slow("starts servers and kits")


@pytest.mark.parametrize(
    ("flags", "rules"),
    [
        ("--heartbeat-s-max 6 --max-open-runs 8", ["LIM-006", "LIM-007"]),
        ("--max-idempotency-keys 8", ["LIM-009"]),
        ("--max-stored-bytes 99999", ["LIM-010"]),
        ("--max-idempotency-keys 8 --max-stored-bytes 99999", ["LIM-009", "LIM-010"]),
    ],
)
def test_small_limits_of_an_account_are_judged(
    tmp_path: Path, flags: str, rules: list[str]
) -> None:
    server = (*server_command(), *flags.split())
    command = ("--start-cmd", shlex.join(server), "--only", ",".join(rules))
    kit = run_kit(tmp_path, *command)
    assert kit.outcomes == dict.fromkeys(rules, "passed"), kit.output
