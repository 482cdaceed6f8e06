"""A server that is right and slow: no check of time may call it wrong."""

from __future__ import annotations

import sys
from pathlib import Path

import httpx
import pytest

from conformance.checks.support.expected_states import WAIT_S, expect_changed
from conformance.exchanges.answer import Answer
from conformance.verdicts.expect import Inconclusive, TooLate, Violation
from tests.support.kit.run_kit import run_kit

SERVER = f"{sys.executable} -m tests.support.kit.server_with_late_answers"


@pytest.mark.slow("starts a server and a kit")
@pytest.mark.parametrize(
    ("late", "rules"),
    [
        ("submit", {"LIFE-801"}),
        ("resume", {"LIFE-604", "RUN-008", "RUN-012"}),
        ("predict", {"RUN-020"}),
    ],
)
def test_what_is_answered_late_is_judged(
    tmp_path: Path, late: str, rules: set[str]
) -> None:
    command = f"{SERVER} {late}"
    options = ("--start-cmd", command, "--only", ",".join(rules), "-n", "2")
    kit = run_kit(tmp_path, *options)
    assert kit.rules_with("passed") == rules, kit.output


def unchanged(waited_s: float) -> Answer:
    """Give the answer to a long poll that saw no change."""
    return Answer(304, httpx.Headers(), b"", 0.0, waited_s, None, 1)


def test_a_wait_that_ended_before_its_change_proves_nothing() -> None:
    with pytest.raises(Inconclusive):
        expect_changed(unchanged(WAIT_S), "running", -0.1, 1.0, "an answer")


def test_a_wait_that_ended_long_after_its_change_is_late() -> None:
    with pytest.raises(TooLate):
        expect_changed(unchanged(WAIT_S), "running", 4.0, 1.0, "an answer")


def test_a_wait_that_ended_too_early_is_a_violation() -> None:
    with pytest.raises(Violation, match="304"):
        expect_changed(unchanged(0.5), "running", 0.1, 1.0, "an answer")
