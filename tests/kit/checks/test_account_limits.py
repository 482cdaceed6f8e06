"""The kit and a server with limits that are small enough to be judged."""

from __future__ import annotations

import json
import shlex
import subprocess
import sys
from pathlib import Path

import pytest

from tests.support.paths import ROOT

pytestmark = pytest.mark.slow("starts servers and kits")


def test_small_limits_of_an_account_are_judged(tmp_path: Path) -> None:
    flags = ("--heartbeat-s-max", "6", "--max-open-runs", "8")
    server = (sys.executable, "-m", "reference_server", *flags)
    command = ("--start-cmd", shlex.join(server), "--only", "LIM-006,LIM-007")
    done = subprocess.run(
        [sys.executable, "-m", "conformance", *command, "--report", str(tmp_path)],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=False,
    )
    report = json.loads((tmp_path / "report.json").read_text())
    outcomes = {row["requirement_id"]: row["outcome"] for row in report["rows"]}
    assert outcomes == {"LIM-006": "passed", "LIM-007": "passed"}, done.stdout
