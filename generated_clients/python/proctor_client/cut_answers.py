"""Says whether an answer broke off, where HTTP itself does not show it.

Written by hand, beside what is generated from the specification.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Protocol

_OPENING = (b"{", b"[", b"")  # of JSON that can break off


class _Received(Protocol):
    """An answer; headers: in whatever case their names are asked for."""

    @property
    def headers(self) -> Mapping[str, str]: ...

    @property
    def data(self) -> bytes: ...


def has_length(headers: Mapping[str, str]) -> bool:
    """Whether a body has a length; else its end is that of the connection."""
    return any(name in headers for name in ("content-length", "transfer-encoding"))


def is_cut(answer: _Received) -> bool:
    """Whether an answer is JSON that breaks off, and has no length that shows it."""
    is_json = "json" in answer.headers.get("content-type", "")
    if not is_json or has_length(answer.headers) or answer.data[:1] not in _OPENING:
        return False
    try:
        json.loads(answer.data)
    except ValueError:
        return True
    return False
