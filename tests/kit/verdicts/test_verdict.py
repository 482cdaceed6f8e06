"""The result of many verdicts: conformant, violated, or not decided."""

import json
from typing import Any

import pytest

from conformance.exchanges.exchange import Exchange
from conformance.verdicts.verdict import Outcome, Verdict, exit_code

LEVELS = {"A-001": "MUST", "A-002": "MUST", "A-003": "SHOULD", "AB-002": "MUST"}


def verdict(requirement_id: str, outcome: str, **changes: Any) -> Verdict:
    return Verdict(requirement_id, Outcome(outcome), **changes)


PASSED, FAILED = verdict("A-001", "passed"), verdict("A-002", "failed")
KNOWN = verdict("A-002", "failed", is_known_failure=True)
NAMED = verdict("AB-002", "failed", is_known_failure=True)


@pytest.mark.parametrize(
    ("rows", "code"),
    [
        ([PASSED], 0),
        ([PASSED, FAILED], 1),
        ([PASSED, KNOWN], 0),
        ([KNOWN], 0),
        ([PASSED, verdict("A-003", "failed")], 0),
        ([FAILED, verdict("A-001", "kit_error")], 1),
        ([PASSED, verdict("A-002", "kit_error")], 2),
        ([PASSED, verdict("A-002", "inconclusive")], 2),
        ([PASSED, verdict("A-002", "not_verified")], 2),
        ([PASSED, verdict("A-002", "not_verified", allowed=True)], 0),
        # A known failure excuses what names it, and nothing else.
        ([KNOWN, verdict("A-001", "not_verified", reason="status 500; see AB-002")], 2),
        ([KNOWN, verdict("A-001", "not_verified")], 2),
        ([NAMED, verdict("A-001", "not_verified", reason="status 500; see AB-002")], 0),
        ([PASSED, verdict("A-002", "not_applicable")], 0),
        # Nothing was judged: that is no conformance.
        ([verdict("A-001", "not_applicable")], 2),
        ([verdict("A-001", "not_verified", allowed=True)], 2),
        ([], 2),
    ],
)
def test_the_exit_code_follows_from_all_rows(rows: list[Verdict], code: int) -> None:
    assert exit_code(rows, LEVELS) == code
    assert exit_code(reversed(rows), LEVELS) == code


def test_a_verdict_survives_json() -> None:
    exchange = Exchange(1, "T/1", "PUT", "http://x", None, {}, b"\xff", 1, 200)
    before = verdict("A-001", "not_verified", allowed=True)
    before.exchanges.append(exchange)
    plain = json.loads(json.dumps(before.as_plain()))
    assert plain["outcome"] == "not_verified"
    assert Verdict.from_plain(plain) == before
