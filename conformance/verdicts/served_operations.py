"""Which operations a server serves at all, by all answers of a run of the kit.

An operation that is not there, never answers, breaks, or answers in another media type
is one cause, for which many rules wait.
"""

from collections import Counter
from collections.abc import Mapping
from typing import Any

from conformance.exchanges.answer import ParsedAnswer
from conformance.exchanges.exchange import Exchange
from conformance.specification.document import Operation

_UNSERVED_STATUSES = (404, 405, 501)
_NOT_MODIFIED, _NO_CAPACITY = 304, 503


class ServedOperations:
    """Counts by operation: all requests, successes, and signs that it is not served."""

    def __init__(self) -> None:
        self._requests: Counter[str] = Counter()
        self._lost_on_the_way: Counter[str] = Counter()
        self._unanswered: set[str] = set()
        self._successes: Counter[str] = Counter()
        self._signs: dict[str, Counter[str]] = {}
        self._longest_waits_s: dict[str, float] = {}  # in vain
        self._operations: dict[int, str] = {}  # by the number of an exchange
        self._exchanges_with_sign: set[int] = set()

    def as_plain(self) -> dict[str, Any]:
        """Give the counts as JSON-ready data."""
        return {
            "requests": dict(self._requests),
            "lost_on_the_way": dict(self._lost_on_the_way),
            "unanswered": sorted(self._unanswered),
            "successes": dict(self._successes),
            "signs": {name: dict(signs) for name, signs in self._signs.items()},
            "longest_waits_s": self._longest_waits_s,
        }

    def add_plain(self, plain: Mapping[str, Any]) -> None:
        """Add the counts of another check."""
        self._requests.update(plain["requests"])
        self._lost_on_the_way.update(plain["lost_on_the_way"])
        self._unanswered.update(plain["unanswered"])
        self._successes.update(plain["successes"])
        for name, signs in plain["signs"].items():
            self._signs.setdefault(name, Counter()).update(signs)
        for name, waited_s in plain["longest_waits_s"].items():
            self._note_wait(name, waited_s)

    def observe(
        self, operation: Operation, answer: ParsedAnswer, exchange: Exchange
    ) -> None:
        """Note an answer."""
        self._note_request(operation, exchange)
        sign = _sign_in(operation, answer)
        if sign is not None:
            self._note_sign(operation, sign, exchange)
        elif answer.status < 300 or answer.status == _NOT_MODIFIED:
            self._successes[operation.operation_id] += 1

    def lose(self, operation: Operation, exchange: Exchange) -> None:
        """Note a request that got no answer."""
        self._note_request(operation, exchange)
        self._note_wait(operation.operation_id, exchange.elapsed_s)
        self._note_sign(operation, f"no answer ({exchange.error})", exchange)

    def note_unanswered(self, name: str) -> None:
        """Note that the server itself left a request of an operation unanswered."""
        self._unanswered.add(name)

    def note_lost(self, by_operation: Mapping[str, int]) -> None:
        """Count answers that were lost on the way, not by the server."""
        self._lost_on_the_way.update(by_operation)

    def lost_on_the_way(self) -> str | None:
        """Say how many answers were lost on the way, and where to look."""
        lost = Counter(self._lost_on_the_way)
        for name in self._unanswered:
            del lost[name]
        if not lost:
            return None
        return (
            f"{lost.total()} of {self._requests.total()} answers broke off, or were "
            f"those of a gateway, at {', '.join(sorted(lost))}; their checks were "
            "judged again: look at the network, or at a proxy, before the server"
        )

    def _note_request(self, operation: Operation, exchange: Exchange) -> None:
        self._requests[operation.operation_id] += 1
        self._operations[exchange.number] = operation.operation_id

    def _note_wait(self, name: str, waited_s: float) -> None:
        longest_s = self._longest_waits_s.get(name, 0.0)
        self._longest_waits_s[name] = max(longest_s, waited_s)

    def _note_sign(self, operation: Operation, sign: str, exchange: Exchange) -> None:
        name = operation.operation_id
        self._signs.setdefault(name, Counter())[sign] += 1
        self._exchanges_with_sign.add(exchange.number)

    def operation_of(self, exchange: int | None) -> str:
        """Name the operation of an exchange of the check, if it has one."""
        return "" if exchange is None else self._operations.get(exchange, "")

    def operation_without_service(self, exchange: int) -> str:
        """Name the operation of which this exchange of the check is such a sign."""
        is_sign = exchange in self._exchanges_with_sign
        return self.operation_of(exchange) if is_sign else ""

    def cause(self, operation_id: str) -> str | None:
        """Say how an operation is not served; None if a request of it succeeded.

        Also where it has answered most requests: a refusal is an answer, too.
        """
        if operation_id not in self._signs or self._successes[operation_id]:
            return None
        signs = self._signs[operation_id]
        if 2 * signs.total() <= self._requests[operation_id]:
            return None
        [(sign, times)] = signs.most_common(1)
        if "Timeout" in sign:
            sign = f"no answer within {self._longest_waits_s[operation_id]:.0f} s"
        requests = self._requests[operation_id]
        of = "every request" if times == requests else f"{times} of {requests} requests"
        return f"{sign}, for {of}"


def _sign_in(operation: Operation, answer: ParsedAnswer) -> str | None:
    """How an answer is one that a served operation gives to no right request."""
    status, value = answer.status, answer.value
    code = value.get("code") if isinstance(value, dict) else None
    text = f"status {status} with code `{code}`" if code else f"status {status}"
    if status in _UNSERVED_STATUSES or 300 <= status < 400 != _NOT_MODIFIED:
        return text
    if status >= 500:
        return text if status != _NO_CAPACITY else None
    response = operation.response(status)
    if status >= 300 or response is None or not response.get("content"):
        return None
    if answer.media_type not in response["content"]:
        return f"{text} and Content-Type {answer.media_type or 'absent'}"
    return None if answer.is_readable else f"{text} and a body that cannot be read"
