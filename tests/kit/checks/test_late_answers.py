"""A server that is right and slow: no check of the queue may call it wrong."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

from tests.support.kit.kit_outcomes import kit_outcomes

pytestmark = pytest.mark.slow("starts a server and a kit")

SERVER = f"{sys.executable} -m tests.support.kit.server_with_late_answers_to_resume"
RULES = ("LIFE-604", "RUN-008")


def test_late_answer_to_a_resume_is_no_violation(tmp_path: Path) -> None:
    options = ("--start-cmd", SERVER, "--only", ",".join(RULES), "-n", "2")
    outcomes, printed = kit_outcomes(tmp_path, *options)
    assert outcomes == dict.fromkeys(RULES, "inconclusive"), printed
