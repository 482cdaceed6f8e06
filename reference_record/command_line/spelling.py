"""Says which name was probably meant by a mistyped one, and which names there are."""

from __future__ import annotations

import difflib
import re
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from reference_record.texts.pattern_words import in_words

_VALUE_CHARS_MAX = 80
_WORDS = {"None": "null", "True": "true", "False": "false"}  # as in JSON and TOML


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


def ignored_member(name: str, known: Sequence[str], path: str = "") -> str:
    """A member that is read by no version that is known, and the one that was meant."""
    meant = did_you_mean(name, known) or f"; there is {', '.join(known)}"
    return f"`{path}{name}`, which is ignored{meant}"


def reason_of(fault: Mapping[str, Any]) -> str:
    """The text of a fault that pydantic names: the value, and which ones there are."""
    context, given = fault.get("ctx", {}), shown(fault["input"])
    if fault["type"] == "literal_error":
        values = re.findall("'([^']*)'", context["expected"])
        return unknown("value", str(fault["input"]), values)
    if "pattern" in context:
        return f"{given} {in_words(context['pattern'])}"
    text = str(fault["msg"]).removeprefix("Value error, ")
    wrong = text.partition(", unable to parse")[0]
    return wrong.replace("Input should be", f"{given} must be")


def shown(value: object) -> str:
    """A value in the text of a fault, shortened."""
    text = _WORDS.get(repr(value)) or repr(value)
    return text if len(text) <= _VALUE_CHARS_MAX else f"{text[:_VALUE_CHARS_MAX]}…"
