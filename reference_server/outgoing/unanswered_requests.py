"""Why another program gave no answer, in words for a log: no Python, no classes."""

from __future__ import annotations

import os

import httpcore
import msgspec


def why_no_answer(error: BaseException) -> str:
    """The text of the system, or of the library, without the class of the error."""
    if isinstance(error, httpcore.TimeoutException | TimeoutError):
        return "it did not answer in time"
    if isinstance(error, msgspec.MsgspecError):
        return f"its answer cannot be read ({error})"
    inner: BaseException | None = error
    while inner is not None:
        if isinstance(inner, OSError) and inner.errno:
            is_of_system = inner.errno > 0  # those of names have texts of their own
            return os.strerror(inner.errno) if is_of_system else str(inner.strerror)
        inner = inner.__cause__ or inner.__context__
    # The library ends some of its sentences with a full stop, and has empty ones.
    return str(error).rstrip(".") or "the connection was cut"
