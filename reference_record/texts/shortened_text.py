"""A text within a length: its beginning and its end stay, the middle is left out.

An error begins with what happened and ends with where, or with the shape that was
expected; a text that is cut at its end loses the part that helps.
"""

from __future__ import annotations

_GAP = " … "


def shortened(text: str, length: int) -> str:
    """The text if it has at most `length` characters, otherwise its two ends."""
    if len(text) <= length:
        return text
    tail = (length - len(_GAP)) // 2
    head = length - len(_GAP) - tail
    return f"{text[:head]}{_GAP}{text[len(text) - tail :]}"
