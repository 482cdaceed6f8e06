"""Expectations of a check. Only the functions here state that a server is wrong.

A check ends in one of five ways: it returns (passed), or it raises `Violation`
(failed), `SetUpFailed` (a step before the step under test was refused: not verified),
`Inconclusive` (timing did not decide) or `NotApplicable` (not declared by the server).
Any other exception is an error of the kit.
"""

import itertools
import json
import math
from collections.abc import Iterator, Mapping
from typing import Any

from conformance.exchanges.answer import Answer
from conformance.specification.document import load_spec

TIME_WAS_UP = "time limit reached"
VIOLATION_FOUND = "a rule was violated before (--fail-fast)"
# The rule that every request is answered as the rules and earlier requests demand.
ANY_SEQUENCE = "MODEL-001"
# The same for the operations of Core, which servers of this level obey alone.
ANY_CORE_SEQUENCE = "MODEL-003"
# Codes that may never refuse a valid request of a set-up: neither limits, capacity,
# time nor a proxy can be their reason.
_NEVER_FOR_SET_UP = frozenset(
    {
        *("malformed_body", "unsupported_version", "not_found", "method_not_allowed"),
        *("not_acceptable", "idempotency_conflict", "worker_busy", "seq_conflict"),
        *("seq_out_of_order", "session_superseded", "convention_mismatch"),
        *("unsupported_media_type", "illegal_transition", "no_episode"),
    }
)
_LONGEST_TEXT = 600
_PATHS_SHOWN = 5
_BEFORE_DIFFERENCE = 30
_ABSENT = "(absent)"


class Violation(AssertionError):
    """The server broke the rule under test."""

    def __init__(
        self,
        expected: str,
        observed: str,
        exchange: int | None = None,
        *,
        is_alone: bool = False,
    ) -> None:
        """Give both sides; `is_alone`: the report needs only this one exchange."""
        super().__init__(f"expected {expected}; observed {observed}")
        self.expected = expected
        self.observed = observed
        self.exchange = exchange
        self.is_alone = is_alone


class TooLate(Violation):
    """A limit of time was missed: the check is repeated, for a machine may be busy."""

    def __init__(
        self,
        expected: str,
        took_s: float,
        limit_s: float,
        observed: str | None = None,
    ) -> None:
        super().__init__(expected, observed or f"after {took_s:.2f} s")
        self.late_s = took_s - limit_s


class SetUpFailed(Exception):
    """A step before the one under test failed, so the rule is not verified.

    `allowed` marks what the operator chose not to give (a second token, a restart
    hook): it leaves a run conformant. `breaks` names the rule that the observation
    contradicts with certainty, whatever clock and network do: that rule is violated,
    also where its own check passes. `exchange`: the one that showed it.
    """

    def __init__(
        self,
        reason: str,
        *,
        allowed: bool = False,
        breaks: str | None = None,
        exchange: int | None = None,
    ) -> None:
        text = reason if breaks is None else f"{reason}; see {breaks}"
        super().__init__(text)
        self.reason = text
        self.allowed = allowed
        self.breaks = breaks
        self.exchange = exchange


class Inconclusive(Exception):
    """The clock or the network did not let the check decide."""


class NotApplicable(Exception):
    """The server does not declare the subject of the rule."""


class KitError(Exception):
    """The kit sent something that the specification forbids."""


class OwnConnectionFailed(KitError):
    """A connection failed on this side, which proves nothing about the server."""


class ExpectedBody(dict[str, Any]):
    """A body in which a missing member is a violation of the rule under test."""

    def __missing__(self, key: str) -> Any:
        """Raise: the member is missing."""
        raise Violation(f"a member `{key}`", f"members {sorted(self)}")


class ExpectedList(list[Any]):
    """A list in which a missing entry is a violation of the rule under test."""

    def __getitem__(self, index: Any) -> Any:
        """Give an entry, or raise: it is missing."""
        try:
            return super().__getitem__(index)
        except IndexError:
            raise Violation(f"an entry {index}", f"{len(self)} entries") from None


class SetUpBody(dict[str, Any]):
    """A body of a set-up step, in which a missing member proves nothing."""

    def __missing__(self, key: str) -> Any:
        """Raise: the member is missing."""
        raise SetUpFailed(
            f"response member `{key}` is missing; present: {sorted(self)}"
        )


class SetUpList(list[Any]):
    """A list of a set-up step, in which a missing entry proves nothing."""

    def __getitem__(self, index: Any) -> Any:
        """Give an entry, or raise: it is missing."""
        try:
            return super().__getitem__(index)
        except IndexError:
            text = f"response entry {index} is missing; there are {len(self)}"
            raise SetUpFailed(text) from None


def ok(answer: Answer, status: int = 200) -> Any:
    """Expect success, and give the body."""
    if answer.status != status:
        raise Violation(f"status {status}", describe_answer(answer), answer.exchange)
    return _wrap(answer.json, ExpectedBody)


def refused(
    answer: Answer, code: str, *, pointer: str | None = None, **members: Any
) -> dict[str, Any]:
    """Expect a refusal with this code, its status, and these members."""
    status = load_spec().problems[code]["status"]
    expected = f"status {status} with code `{code}`"
    body = answer.json
    if answer.status != status or answer.code != code or not isinstance(body, dict):
        raise Violation(expected, describe_answer(answer), answer.exchange)
    for name, value in members.items():
        if body.get(name) != value:
            text = f"{name} {format_value(body.get(name))}"
            raise Violation(
                f"{expected} and {name} {format_value(value)}", text, answer.exchange
            )
    if pointer is not None:
        pointers = _pointers(body)
        if pointer not in pointers:
            raise Violation(
                f"{expected} and an entry of `errors` pointing at {pointer}",
                f"pointers {pointers}",
                answer.exchange,
            )
    return ExpectedBody(body)


def refused_for_one(answer: Answer, code: str, *others: str) -> None:
    """Expect the refusal of a request with several faults, for any one of them."""
    refused(answer, str(answer.code) if answer.code in others else code)


def no_server_error(answer: Answer) -> None:
    """Expect a status below 500, or 503."""
    if answer.status >= 500 and answer.status != 503:
        expected, observed = (
            "no status of 500 or above except 503",
            describe_answer(answer),
        )
        raise Violation(expected, observed, answer.exchange, is_alone=True)


def equal(observed: Any, expected: Any, what: str) -> None:
    """Expect a value."""
    if observed == expected:
        return
    if len(format_value(expected)) + len(format_value(observed)) <= _LONGEST_TEXT:
        raise Violation(f"{what} = {format_value(expected)}", format_value(observed))
    differences = sorted(_differences(observed, expected), key=_is_about_time)
    parts = [
        (at, *format_difference(due, seen))
        for at, seen, due in differences[:_PATHS_SHOWN]
    ]
    raise Violation(
        f"{what} with " + ", ".join(f"{at} {due}" for at, due, _ in parts),
        ", ".join(f"{at} {seen}" for at, _, seen in parts),
    )


def members(
    observed: Mapping[str, Any], expected: Mapping[str, Any], what: str = ""
) -> None:
    """Expect members of a body, each with its value."""
    for name, value in expected.items():
        equal(observed[name], value, f"{name} {what}".strip())


def _differences(
    observed: Any, expected: Any, path: str = ""
) -> Iterator[tuple[str, Any, Any]]:
    """Give the places where two values differ: path, observed, expected."""
    if isinstance(observed, dict) and isinstance(expected, dict):
        for name in [*expected, *(n for n in observed if n not in expected)]:
            pair = (observed.get(name, _ABSENT), expected.get(name, _ABSENT))
            yield from _differences(*pair, f"{path}/{name}")
    elif isinstance(observed, list) and isinstance(expected, list):
        if len(observed) != len(expected):
            yield f"{path} number of entries".strip(), len(observed), len(expected)
        pairs = itertools.zip_longest(observed, expected, fillvalue=_ABSENT)
        for index, pair in enumerate(pairs):
            yield from _differences(*pair, f"{path}/{index}")
    elif observed != expected:
        yield path or "/", observed, expected


def _is_about_time(difference: tuple[str, Any, Any]) -> bool:
    """Recognise a value that differs whenever something is done twice."""
    path = difference[0]
    return path.startswith("/timing/") or path.endswith("_at")


def true(condition: object, what: str, observed: Any = None) -> None:
    """Expect a condition that `what` describes."""
    if not condition:
        raise Violation(
            what, "not satisfied" if observed is None else format_value(observed)
        )


def in_time(
    took_s: float, limit_s: float, what: str, *, may_be_noise: bool = True
) -> None:
    """Expect what `what` describes within a limit of time, in seconds.

    may_be_noise: whether a busy machine may miss the limit in every try. It may not
    where the limit is that of something long that is to be left out.
    """
    if took_s > limit_s:
        expected = f"{what} within {limit_s:.2f} s"
        raise TooLate(expected, took_s, limit_s if may_be_noise else -math.inf)


def missed(expected: str, observed: str) -> TooLate:
    """Give the exception to raise when something has not come after a long wait.

    It is waited for again: not even a machine that is much too busy misses it always.
    """
    return TooLate(expected, math.inf, 0.0, observed)


def require(answer: Answer, status: int, step: str) -> Any:
    """Require success of a step that is not under test, or raise SetUpFailed."""
    if answer.status != status:
        text = f"{step}: unexpected response: {describe_answer(answer)}"
        breaks = ANY_SEQUENCE if answer.code in _NEVER_FOR_SET_UP else None
        raise SetUpFailed(text, breaks=breaks, exchange=answer.exchange)
    return _wrap(answer.json, SetUpBody)


def as_set_up(body: dict[str, Any]) -> dict[str, Any]:
    """Give a body whose missing members and entries prove nothing."""
    wrapped: dict[str, Any] = _wrap(body, SetUpBody)
    return wrapped


def describe_answer(answer: Answer) -> str:
    """Describe an answer in one line."""
    if answer.code is not None:
        detail = answer.json.get("detail", "")
        return f"status {answer.status} with code `{answer.code}` ({detail})"
    body = (
        format_value(answer.json)
        if answer.json is not None
        else repr(answer.body[:200])
    )
    return f"status {answer.status} with body {body}"


def format_value(value: Any) -> str:
    """Write a value as JSON, shortened in the middle."""
    text = json.dumps(value, ensure_ascii=False, default=repr)
    if len(text) <= _LONGEST_TEXT:
        return text
    half = _LONGEST_TEXT // 2
    return f"{text[:half]} … {text[-half:]}"


def format_difference(expected: Any, observed: Any) -> tuple[str, str]:
    """Write two values, each around the first place where they differ."""
    due, seen = (
        json.dumps(value, ensure_ascii=False, default=repr)
        for value in (expected, observed)
    )
    if max(len(due), len(seen)) <= _LONGEST_TEXT // 2:
        return due, seen
    pairs = enumerate(zip(due, seen, strict=False))
    same = next((n for n, (a, b) in pairs if a != b), min(len(due), len(seen)))
    begin = max(0, same - _BEFORE_DIFFERENCE)
    return _window(due, begin), _window(seen, begin)


def _window(text: str, begin: int) -> str:
    end = begin + _LONGEST_TEXT // 4
    return f"{'… ' * (begin > 0)}{text[begin:end]}{' …' * (end < len(text))}"


def _pointers(body: dict[str, Any]) -> list[Any]:
    errors = body.get("errors")
    if not isinstance(errors, list):
        return []
    return [item.get("pointer") for item in errors if isinstance(item, dict)]


_LISTS: dict[type[dict[str, Any]], type[list[Any]]] = {
    ExpectedBody: ExpectedList,
    SetUpBody: SetUpList,
}


_PLAIN = frozenset({str, int, float, bool, type(None)})


def _wrap(value: Any, kind: type[dict[str, Any]]) -> Any:
    if isinstance(value, dict):
        wrapped = kind(value)
        for key, item in value.items():
            if type(item) not in _PLAIN:
                wrapped[key] = _wrap(item, kind)
        return wrapped
    if isinstance(value, list):
        return _LISTS[kind](
            item if type(item) in _PLAIN else _wrap(item, kind) for item in value
        )
    return value
