"""Texts of a server as a terminal may show them.

A control sequence in a text can rewrite what stands above it, set the clipboard or the
title, and hide what follows; a mark of direction can reorder a line. A lone surrogate
cannot be written at all. All of them are shown as Python would write them.
"""

from __future__ import annotations

import re

# All of C0 but tab and line feed, DEL, C1, marks of direction, surrogates.
_UNPRINTABLE = re.compile(
    "[\x00-\x08\x0b-\x1f\x7f-\x9f"
    "\u061c\u200e\u200f\u2028-\u202e\u2066-\u2069\ud800-\udfff]"
)


def printable(text: str) -> str:
    """The text with an escape, such as \\x1b, for each character that acts."""
    return _UNPRINTABLE.sub(lambda match: ascii(match[0])[1:-1], text)
