"""The verdict on one requirement, and on all of them together.

passed          the check ran to its end
failed          the server broke the rule
not_verified    the rule was not judged; the reason is given
not_applicable  the server does not declare the subject of the rule
inconclusive    clock or network did not allow a decision
kit_error       an error of the kit, never of the server
"""

import re
from collections.abc import Iterable
from dataclasses import asdict, dataclass, field
from enum import StrEnum
from typing import Any

from conformance.exchanges.exchange import Exchange

_RULE_ID = re.compile(r"\b[A-Z]{2,6}-[0-9]{3}\b")


class Outcome(StrEnum):
    """The result of the judgement of one requirement."""

    PASSED = "passed"
    FAILED = "failed"
    NOT_VERIFIED = "not_verified"
    NOT_APPLICABLE = "not_applicable"
    INCONCLUSIVE = "inconclusive"
    KIT_ERROR = "kit_error"


@dataclass
class Verdict:
    """One row of the report.

    `allowed`: the rule cannot be verified with these options (no restart command, no
    second token, not observable), as opposed to a prerequisite that failed.
    `breaks`: the rule that the failed prerequisite contradicts.
    `waits_for`: the operation whose answer decided, if it is like that of one which the
    server does not serve.
    """

    requirement_id: str
    outcome: Outcome
    reason: str = ""
    allowed: bool = False
    breaks: str = ""
    waits_for: str = ""
    expected: str = ""
    observed: str = ""
    check: str = ""
    story: str = ""
    elapsed_s: float = 0.0
    is_known_failure: bool = False
    exchanges: list[Exchange] = field(default_factory=list)
    left_out: int = 0  # exchanges between these, which were too many to keep

    def as_plain(self) -> dict[str, Any]:
        """Give it as JSON-ready data."""
        plain = asdict(self)
        plain["outcome"] = self.outcome.value
        plain["exchanges"] = [exchange.as_plain() for exchange in self.exchanges]
        return plain

    @classmethod
    def from_plain(cls, plain: dict[str, Any]) -> "Verdict":
        """Undo `as_plain`."""
        exchanges = [Exchange.from_plain(item) for item in plain["exchanges"]]
        outcome = Outcome(plain["outcome"])
        return cls(**(plain | {"exchanges": exchanges, "outcome": outcome}))


def rules_named_in(reason: str) -> set[str]:
    """Give the ids in a text: a row that could not be judged names what it needs."""
    return set(_RULE_ID.findall(reason))


def exit_code(verdicts: Iterable[Verdict], levels: dict[str, str]) -> int:
    """Give 0 where no MUST is violated but known failures, 1, or 2 for not decided."""
    rows = list(verdicts)
    if any(
        row.outcome == Outcome.FAILED
        and levels[row.requirement_id] == "MUST"
        and not row.is_known_failure
        for row in rows
    ):
        return 1
    undecided = (Outcome.KIT_ERROR, Outcome.INCONCLUSIVE)
    if any(row.outcome in undecided for row in rows):
        return 2
    known_failures = {row.requirement_id for row in rows if row.is_known_failure}
    if any(
        row.outcome == Outcome.NOT_VERIFIED
        and not row.allowed
        and not known_failures & rules_named_in(row.reason)
        for row in rows
    ):
        # A prerequisite failed, for another reason than a known failure.
        return 2
    judged = (Outcome.PASSED, Outcome.FAILED)
    return 0 if any(row.outcome in judged for row in rows) else 2
