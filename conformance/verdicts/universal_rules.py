"""Rules for every response, judged on every exchange of every check.

SVC-003, VER-001, ERR-001, ERR-011 and ERR-012 do not belong to one request. Breaches
are collected here and decide these rules at the end; they do not fail the check in
which they happened. One breach counts for one rule: an error response that is not
a valid problem breaks ERR-001 alone, not the schema (SVC-003) as well.
"""

import re
from collections import Counter
from dataclasses import dataclass, field
from typing import Any

from conformance.exchanges.answer import ParsedAnswer, describe_body
from conformance.exchanges.exchange import Exchange
from conformance.specification.document import PROBLEM_JSON, Operation, Spec
from conformance.verdicts.expect import format_value
from conformance.verdicts.served_operations import ServedOperations

UNIVERSAL_RULES = ("SVC-003", "VER-001", "ERR-001", "ERR-011", "ERR-012")
# Rules that the oracle judges by what their checks make a server answer.
ORACLE_RULES = (
    *("SCORE-005", "SCORE-006", "SCORE-007", "SCORE-008", "SCORE-009", "SCORE-011"),
    *("SCORE-012", "SCORE-013", "SCORE-002", "SCORE-003", "RUN-014", "RUN-021"),
    *("RUN-023", "RUN-025", "EPI-013", "CAL-002", "CAL-003", "CAL-005", "CAL-007"),
    *("CAL-011", "PRED-007", "PRED-009", "PRED-020", "PRED-021", "PRED-023"),
    *("PRED-028", "ATT-022", "PRED-002", "PRED-003", "PRED-004", "PRED-010"),
    *("PRED-011", "PRED-024", "PRED-027", "ATT-003", "ATT-004", "ATT-005"),
    *("ATT-018", "ATT-019", "EPI-001", "EPI-002", "EPI-004", "EPI-008", "EPI-010"),
    *("FAULT-001", "FAULT-009", "PRED-001", "PRED-008", "STOP-001", "STOP-005"),
    *("PRED-006", "PRED-018", "CAL-004", "LEASE-009", "EPI-005", "EPI-006"),
    *("CMP-001", "CMP-002", "CMP-003", "CMP-004", "CMP-005", "CMP-006", "CMP-007"),
    *("CMP-008", "CMP-012"),
)
_BREACHES_KEPT = 3
_VERSION = re.compile(r"[0-9]+\.[0-9]+")


@dataclass
class Breach:
    """One answer that broke a rule.

    rules: those that explain a difference which the oracle found, the most specific
    first; none of a universal rule. before: the exchanges that led to it. is_own:
    whether it broke a rule of the check whose request it answers. waits_for: as that of
    a verdict.
    """

    requirement_id: str
    expected: str
    observed: str
    exchange: Exchange
    rules: list[str] = field(default_factory=list)
    before: list[Exchange] = field(default_factory=list)
    is_own: bool = False
    waits_for: str = ""

    @property
    def check(self) -> str:
        """The rule whose check sent the request."""
        return self.exchange.correlation_id.partition("/")[0]

    def as_plain(self) -> dict[str, Any]:
        """Give it as JSON-ready data."""
        before = [exchange.as_plain() for exchange in self.before]
        return vars(self) | {"exchange": self.exchange.as_plain(), "before": before}

    @classmethod
    def from_plain(cls, plain: dict[str, Any]) -> "Breach":
        """Undo `as_plain`."""
        exchange = Exchange.from_plain(plain["exchange"])
        before = [Exchange.from_plain(item) for item in plain["before"]]
        return cls(**(plain | {"exchange": exchange, "before": before}))


class Tally:
    """Counts how often each rule was exercised, and keeps its first breaches."""

    def __init__(self, spec: Spec) -> None:
        self._spec = spec
        self.rules: tuple[str, ...] = ()  # those of the check
        self.exercised: Counter[str] = Counter()
        self.broken: Counter[str] = Counter()
        self.breaches: list[Breach] = []
        self.differences = 0  # those that the oracle found
        self.latest: Breach | None = None
        # check → the rules that answers to its requests broke, as the oracle says
        self.broken_in_check: dict[str, set[str]] = {}
        self.served = ServedOperations()

    def as_plain(self) -> dict[str, Any]:
        """Give it as JSON-ready data."""
        return {
            "exercised": dict(self.exercised),
            "broken": dict(self.broken),
            "breaches": [breach.as_plain() for breach in self.breaches],
            "broken_in_check": {
                check: sorted(rules) for check, rules in self.broken_in_check.items()
            },
            "served": self.served.as_plain(),
        }

    def add_plain(self, plain: dict[str, Any]) -> None:
        """Add the counts of another tally."""
        self.exercised.update(plain["exercised"])
        self.broken.update(plain["broken"])
        self.breaches += map(Breach.from_plain, plain["breaches"])
        for check, rules in plain["broken_in_check"].items():
            self.broken_in_check.setdefault(check, set()).update(rules)
        self.served.add_plain(plain["served"])

    def note_difference(
        self,
        rules: list[str],
        expected: str,
        observed: str,
        exchange: Exchange,
        before: list[Exchange],
    ) -> None:
        """Note that an answer differs from those that the oracle allows.

        rules: those that explain it, the most specific first; of these, one that the
        check judges is meant.
        """
        row = next((rule for rule in rules if rule in self.rules), rules[0])
        self.exercised[row] += 1
        self.broken[row] += 1
        breach = Breach(row, expected, observed, exchange, rules, before)
        judged = {breach.check, *self.rules}
        breach.is_own = row in judged
        breach.waits_for = self.served.operation_without_service(exchange.number)
        self.differences += 1
        self.latest = breach
        for rule in judged:
            self.broken_in_check.setdefault(rule, set()).add(row)
        if self.broken[row] <= _BREACHES_KEPT:
            self.breaches.append(breach)

    def observe(
        self, operation: Operation | None, answer: ParsedAnswer, exchange: Exchange
    ) -> bool:
        """Judge one answer; say whether its body is as the specification describes it.

        `operation` is None for paths outside the specification.
        """
        if exchange.method in ("HEAD", "OPTIONS"):
            return True
        if operation is not None:
            self.served.observe(operation, answer, exchange)
        self._version(answer, exchange)
        self._no_server_error(answer, exchange)
        if answer.status in (429, 503):
            self._retry_after(answer, exchange)
        is_problem = True
        if answer.status >= 400:
            is_problem = self._problem(answer, exchange)
        if operation is None or not is_problem:
            return is_problem
        return self._judge_description(operation, answer, exchange)

    def _record(
        self, row: str, holds: bool, expected: str, observed: str, exchange: Exchange
    ) -> None:
        self.exercised[row] += 1
        if holds:
            return
        self.broken[row] += 1
        if self.broken[row] <= _BREACHES_KEPT:
            self.breaches.append(Breach(row, expected, observed, exchange))

    def _version(self, answer: ParsedAnswer, exchange: Exchange) -> None:
        if answer.status == 304:
            return
        version = answer.headers.get("proctor-version")
        self._record(
            "VER-001",
            version is not None and _VERSION.fullmatch(version) is not None,
            "a Proctor-Version header like 1.0",
            f"status {answer.status} with Proctor-Version {version}",
            exchange,
        )

    def _no_server_error(self, answer: ParsedAnswer, exchange: Exchange) -> None:
        self._record(
            "ERR-012",
            answer.status < 500 or answer.status == 503,
            "no status of 500 or above except 503",
            f"status {answer.status} with body {answer.body[:300]!r}",
            exchange,
        )

    def _retry_after(self, answer: ParsedAnswer, exchange: Exchange) -> None:
        value = answer.headers.get("retry-after", "")
        self._record(
            "ERR-011",
            value.isascii() and value.isdigit(),
            "a Retry-After header with whole seconds",
            f"status {answer.status} with Retry-After {value or 'absent'}",
            exchange,
        )

    def _problem(self, answer: ParsedAnswer, exchange: Exchange) -> bool:
        """Judge ERR-001; say whether the schema of the body is to be judged, too."""
        observed = self._problem_fault(answer)
        self._record(
            "ERR-001",
            observed is None,
            "application/problem+json with a code of x-problems and its status, "
            "`retryable` and `side_effects`",
            f"status {answer.status}: {observed}",
            exchange,
        )
        return observed is None

    def _problem_fault(self, answer: ParsedAnswer) -> str | None:
        if answer.media_type != PROBLEM_JSON:
            return f"media type {answer.media_type or 'absent'}"
        if not isinstance(answer.value, dict):
            return f"body {answer.body[:200]!r}"
        code = answer.value.get("code")
        problem = self._spec.problems.get(code) if isinstance(code, str) else None
        if problem is None:
            return f"code {format_value(code)}"
        if answer.status != problem["status"]:
            return f"code `{code}`, whose status is {problem['status']}"
        for member in ("status", "retryable", "side_effects"):
            if answer.value.get(member) != problem[member]:
                return f"code `{code}` with {member} {answer.value.get(member)!r}"
        return None

    def _judge_description(
        self, operation: Operation, answer: ParsedAnswer, exchange: Exchange
    ) -> bool:
        fault = self._description_fault(operation, answer)
        self._record(
            "SVC-003",
            fault is None,
            f"a response that matches openapi.yaml for `{operation.operation_id}`",
            f"status {answer.status}: {fault}",
            exchange,
        )
        return fault is None

    def _description_fault(
        self, operation: Operation, answer: ParsedAnswer
    ) -> str | None:
        response = operation.response(answer.status)
        if response is None:
            return "status not declared in openapi.yaml"
        content = response.get("content", {})
        if not content:
            return f"body {answer.body[:200]!r}" if answer.body else None
        if answer.media_type not in content:
            return f"media type {answer.media_type or 'absent'}"
        if not answer.is_readable:
            return f"{describe_body(answer)}: {answer.body[:200]!r}"
        faults = self._spec.response_faults(
            operation, answer.status, answer.media_type, answer.value
        )
        return "; ".join(faults[:3]) or None
