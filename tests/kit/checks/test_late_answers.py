"""A server that is right and slow: no check of the queue may call it wrong."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

from tests.support.paths import ROOT

pytestmark = pytest.mark.slow("starts a server and a kit")

SERVER = f"{sys.executable} -m tests.support.kit.server_with_late_answers_to_resume"
RULES = ("LIFE-604", "RUN-008")


def test_late_answer_to_a_resume_is_no_violation(tmp_path: Path) -> None:
    options = ("--start-cmd", SERVER, "--only", ",".join(RULES), "-n", "2")
    done = subprocess.run(
        [sys.executable, "-m", "conformance", *options, "--report", str(tmp_path)],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=False,
    )
    report = json.loads((tmp_path / "report.json").read_text())
    outcomes = {row["requirement_id"]: row["outcome"] for row in report["rows"]}
    assert outcomes == dict.fromkeys(RULES, "inconclusive"), done.stdout
