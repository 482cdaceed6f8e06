"""Cells of CSV files that people open in a spreadsheet program.

Such a program executes a text that begins like a formula. It looks past white space and
invisible characters, reads full-width signs like plain ones, and in many countries
separates cells at semicolons or tabs, so that a formula can begin inside of a text.
"""

from __future__ import annotations

import re
from typing import TypeVar

Value = TypeVar("Value")

# White space, control characters and characters without a width.
_IGNORED = r"[\s\x00-\x1f\x7f-\x9f\xad\u200b-\u200f\u2028-\u202e\u2060-\u206f\ufeff]"
_SIGNS = "=+\\-@\uff1d\uff0b\uff0d\uff20\ufe66\ufe62\ufe63\ufe6b\u2212"
# The second place repeats at most so often: the search stays linear.
_FORMULA = re.compile(rf"(^|[;\t\r\n])(?={_IGNORED}{{0,200}}[{_SIGNS}])")
_LEADING_SEPARATOR = re.compile(r"[\t\r\n]")


def as_cell(value: Value) -> Value | str:
    """The value as a spreadsheet shows it: a text that is a formula gets a quote."""
    if not isinstance(value, str):
        return value
    text = _FORMULA.sub(r"\1'", value)
    return f"'{text}" if _LEADING_SEPARATOR.match(text) else text
