"""Suggests the name that was probably meant by a mistyped one."""

from __future__ import annotations

import difflib
from collections.abc import Iterable


def did_you_mean(word: str, words: Iterable[str]) -> str:
    """`; did you mean NAME?` if a known name is close, else nothing."""
    close = difflib.get_close_matches(word, [*words], n=1)
    return f"; did you mean {close[0]}?" if close else ""
