"""Where the time of a request goes: spans, which a trace brings together.

Each part of the server opens a span around each thing that it waits for. The one
recorder of a process decides what happens with them: it is `monitoring/traces.py` where
the setting `traces` names a collector; without a recorder a span costs one comparison.
A span has names and numbers of ours: never a token, a key, a header or a part of a
body. This module knows no HTTP.
"""

from __future__ import annotations

import hashlib
from typing import Protocol, Self, TypeAlias

Value: TypeAlias = str | int | float


class Span(Protocol):
    """A block that takes time; what it begins is a part of it."""

    @property
    def is_recorded(self) -> bool:
        """Whether it is worth to gather what describes it."""

    def set(self, name: str, value: Value) -> None:
        """Describe it. name: an attribute of OpenTelemetry, or one of `proctor.…`."""

    def __enter__(self) -> Self: ...

    def __exit__(self, kind: type[BaseException] | None, *_: object) -> None: ...


class Recorder(Protocol):
    """Creates the spans of a process."""

    def part(self, name: str, *, is_call: bool) -> Span:
        """Begin a span as the function `span` does."""

    def root(self, name: str) -> Span:
        """Begin a span as the function `root_span` does."""

    def traceparent(self, *, only_recorded: bool) -> str | None:
        """The header that the function `traceparent` returns."""


class _NotRecorded:
    """The span of all blocks that are not recorded; it does nothing."""

    __slots__ = ()
    is_recorded = False

    def set(self, name: str, value: Value) -> None:
        pass

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        pass


NOT_RECORDED = _NotRecorded()

_recorder: Recorder | None = None


def record_with(recorder: Recorder | None) -> None:
    """Record spans with this recorder from now on; None ends it."""
    global _recorder  # noqa: PLW0603 - like the log there is one for a process
    _recorder = recorder


def span(name: str, *, is_call: bool = False) -> Span:
    """A part of what is traced now, if anything is.

    is_call: another process does the work, and is sent `traceparent`.
    """
    recorder = _recorder
    if recorder is None:
        return NOT_RECORDED
    return recorder.part(name, is_call=is_call)


def root_span(name: str) -> Span:
    """A span that no request causes: it begins a trace, sampled as requests are."""
    recorder = _recorder
    return NOT_RECORDED if recorder is None else recorder.root(name)


def traceparent(*, only_recorded: bool = False) -> str | None:
    """The header (W3C Trace Context) of a request that is sent on behalf of this one.

    None if nothing is traced. only_recorded: None also if this request is not.
    """
    recorder = _recorder
    return (
        None if recorder is None else recorder.traceparent(only_recorded=only_recorded)
    )


def session_name(session_id: str) -> str:
    """A name for a session that only those can match who know its id.

    A worker proves its session with the id itself, so a collector must not get it.
    """
    return hashlib.sha256(session_id.encode()).hexdigest()[:12]
