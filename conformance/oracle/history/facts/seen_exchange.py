"""One request with its answer, as the oracle reads it, and a difference that it finds.

Plain data: bodies are decoded, paths are split, evidence is carried along unread.
"""

from __future__ import annotations

import functools
import math
import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any
from urllib.parse import parse_qsl, unquote, urlsplit

import msgspec

_BODY_BYTES_READ = 2**20
UNKNOWN = object()  # a body that the oracle cannot read


@dataclass(frozen=True, slots=True)
class SeenExchange:
    """A request and its answer.

    status: None where no answer came; then the request may have its effect at any time.
    body: of the request, None where there is none, UNKNOWN where it cannot be read.
    evidence: the exchange, as the log has it.
    """

    operation: str
    started_at: float
    ended_at: float
    status: int | None
    value: Any = None
    params: Mapping[str, str] = field(default_factory=dict)
    query: Mapping[str, str] = field(default_factory=dict)
    headers: Mapping[str, str] = field(default_factory=dict)
    body: Any = None
    account: str | None = None
    check: str = ""
    answer_headers: Mapping[str, str] = field(default_factory=dict)
    media_type: str = ""
    evidence: Any = None

    @property
    def code(self) -> str | None:
        """The problem code, if the answer is a problem."""
        if self.status is None or self.status < 400 or not isinstance(self.value, dict):
            return None
        return str(self.value.get("code"))

    @property
    def is_success(self) -> bool:
        """Whether the request was carried out."""
        return self.status is not None and self.status < 300

    @property
    def may_have_effect(self) -> bool:
        """Whether the request was, or may have been, carried out, wholly or in part."""
        if self.status is None or self.is_success:
            return True
        return self.code in ("session_ended", "session_superseded", "unavailable")

    @property
    def request(self) -> Mapping[str, Any]:
        """The members of the request body; none where they are not known."""
        return self.body if isinstance(self.body, dict) else {}

    def is_surely_before(self, other: SeenExchange) -> bool:
        """Whether this was answered before the other one was sent."""
        return self.ended_at < other.started_at

    def may_be_before(self, other: SeenExchange) -> bool:
        """Whether this may have had its effect before the other one was answered."""
        return self.started_at < other.ended_at


@dataclass(frozen=True, slots=True)
class Difference:
    """An answer that contradicts the rules, or an earlier answer.

    rules: the ids of the rules that explain it, the most specific one first.
    witness: the earlier observation that it contradicts, if it is one.
    """

    rules: tuple[str, ...]
    expected: str
    observed: str
    observation: SeenExchange
    witness: SeenExchange | None = None


@functools.cache
def _pattern_of(template: str) -> re.Pattern[str]:
    return re.compile(re.sub(r"\\{([a-z_]+)\\}", r"(?P<\1>[^/]+)", re.escape(template)))


def read_path(template: str, url: str) -> dict[str, str]:
    """Give the parameters in the path of a URL, whose end the template describes."""
    path = urlsplit(url).path
    places = [match.start() for match in re.finditer("/v1(?=/)", path)]
    for start in places[::-1]:
        match = _pattern_of(template).fullmatch(path, start)
        if match is not None:
            return {name: unquote(value) for name, value in match.groupdict().items()}
    return {}


def read_query(url: str) -> dict[str, str]:
    """Give the query parameters of a URL."""
    return dict(parse_qsl(urlsplit(url).query, keep_blank_values=True))


def read_body(content: bytes | None, media_type: str) -> Any:
    """Decode the body of a request; UNKNOWN where this reader cannot."""
    if content == b"":
        return None
    if content is None or len(content) > _BODY_BYTES_READ:
        return UNKNOWN
    try:
        if media_type == "application/msgpack":
            return msgspec.msgpack.decode(content)
        return msgspec.json.decode(content)
    except (msgspec.DecodeError, UnicodeDecodeError, RecursionError):
        return UNKNOWN


def _is_written_alike(one: Any, other: Any) -> bool:
    """Whether two values of one type are surely equal, as most of them are.

    Their bytes differ for 1 and true, which compare as equal; a value that differs from
    itself has equal bytes.
    """
    if not isinstance(one, dict | list):
        return bool(one == other)
    try:
        encode = msgspec.msgpack.encode
        return bool(one == other) and encode(one) == encode(other)
    except (TypeError, ValueError, OverflowError, RecursionError):
        return False


def _as_double(number: float) -> float:
    try:
        return float(number)
    except OverflowError:
        return math.nan


def is_same(one: Any, other: Any) -> bool:
    """Whether two values are equal; numbers are where they are the same double."""
    if type(one) is type(other) and _is_written_alike(one, other):
        return True
    if isinstance(one, dict) and isinstance(other, dict):
        names = one.keys() | other.keys()
        return len(names) == len(one) == len(other) and all(
            is_same(one[name], other[name]) for name in names
        )
    if isinstance(one, list) and isinstance(other, list):
        return len(one) == len(other) and all(map(is_same, one, other))
    if isinstance(one, bool) or isinstance(other, bool):
        return one is other
    if isinstance(one, int | float) and isinstance(other, int | float):
        return one == other or _as_double(one) == _as_double(other)
    return bool(one == other)


def name_of_difference(one: Mapping[str, Any], other: Mapping[str, Any]) -> str:
    """Name the first member in which two objects differ."""
    names = dict.fromkeys([*one, *other])
    differing = (n for n in names if not is_same(one.get(n), other.get(n)))
    return next(differing, "")


LOST = math.inf  # the end of a request without an answer
