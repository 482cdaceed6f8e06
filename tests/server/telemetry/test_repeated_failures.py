"""A failure that repeats is one line a minute, and the next line counts the others."""

import logging

import pytest

from reference_server.telemetry.repeated_failures import RepeatedFailures


def test_each_cause_is_one_line_a_minute(caplog: pytest.LogCaptureFixture) -> None:
    now = 0.0
    failures = RepeatedFailures(logging.getLogger("proctor.test"), lambda: now)
    for _ in range(3):
        failures.report("it could not be stored", "full")
    failures.report("it could not be stored", "gone")
    now = 61.0
    for _ in range(2):
        failures.report("it could not be stored", "full")
    assert [record.getMessage() for record in caplog.records] == [
        "it could not be stored: full",
        "it could not be stored: gone",
        "it could not be stored: full (2 more since the last such line)",
    ]


def test_few_causes_are_remembered(caplog: pytest.LogCaptureFixture) -> None:
    failures = RepeatedFailures(logging.getLogger("proctor.test"), lambda: 0.0)
    for number in range(1000):
        failures.report("it could not be stored", str(number))
    assert len(failures._reported) <= 64
    assert len(caplog.records) == 1000
