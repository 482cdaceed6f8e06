"""Says which name was probably meant by a mistyped one, and which names there are."""

from __future__ import annotations

import difflib
import re
from collections.abc import Iterable, Mapping
from typing import Any


def did_you_mean(word: str, words: Iterable[str], likeness: float = 0.6) -> str:
    """`; did you mean NAME?` if a known name is close, else nothing.

    likeness: at least this one, of which 1 is equal.
    """
    close = difflib.get_close_matches(word, [*words], n=1, cutoff=likeness)
    return f"; did you mean {close[0]}?" if close else ""


def unknown(kind: str, word: str, words: Iterable[str]) -> str:
    """`unknown KIND WORD`, the name that was probably meant, and all names."""
    names = [*words]
    word = word if word.isprintable() else repr(word)
    close = did_you_mean(word, names)
    there_is = " There is " if close else "; there is "
    return f"unknown {kind} {word}{close}{there_is}{', '.join(names)}"


def reason_of(fault: Mapping[str, Any]) -> str:
    """The text of a fault that pydantic names; for a wrong value, with all values."""
    if fault["type"] == "literal_error":
        values = re.findall("'([^']*)'", fault["ctx"]["expected"])
        return unknown("value", str(fault["input"]), values)
    return str(fault["msg"]).removeprefix("Value error, ")
