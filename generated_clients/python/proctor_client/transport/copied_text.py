"""Texts that people copy: a token, an address. A file or a shell adds to their ends.

Editors add a byte order mark and a newline, `.env` files and shells keep quotes, and
pages of the web add characters that cannot be seen.
"""

from __future__ import annotations

import os
import re
import unicodedata

_QUOTES = {'"': '"', "'": "'", "`": "`", "\u201c": "\u201d", "\u2018": "\u2019"}


class EmptyVariable(ValueError):
    """A variable of the environment is set, and has no value; the text names it."""


class BadToken(ValueError):
    """A token cannot be sent; the text names its source, and never the token."""


def trim(text: str) -> str:
    """The text without what is invisible at its ends, and without quotes around it."""
    while True:
        start, end = 0, len(text)
        while start < end and _is_invisible(text[start]):
            start += 1
        while end > start and _is_invisible(text[end - 1]):
            end -= 1
        text = text[start:end]
        if len(text) < 2 or _QUOTES.get(text[0]) != text[-1]:
            return text
        text = text[1:-1]


def read_token(text: str, source: str) -> str | None:
    """The token in a text, or None if it is empty. source: for the error, `--token`.

    Raises BadToken for a character that a header cannot carry.
    """
    token = re.sub(r"(?i)\A(authorization:\s*)?bearer\s+", "", trim(text))
    for position, character in enumerate(token, 1):
        if not "!" <= character <= "~":
            raise BadToken(
                f"the token of {source} has {_describe(character)} at position "
                f"{position} of {len(token)}: copy it again, as it was printed; in a "
                "file it is one line in UTF-8"
            )
    return token or None


def read_variable(name: str) -> str | None:
    """The value of a variable of the environment, or None where it is not set.

    Raises EmptyVariable for an empty one: $(cat FILE) is one where the file is not
    there yet.
    """
    text = os.environ.get(name)
    if text is not None and not trim(text):
        advice = f"give it a value, or `unset {name}`"
        raise EmptyVariable(f"{name} is set and empty: {advice}")
    return text


def token_of(variable: str) -> str | None:
    """The token in a variable of the environment, or None.

    Raises BadToken, also where the variable is empty.
    """
    try:
        return read_token(read_variable(variable) or "", variable)
    except EmptyVariable as error:
        raise BadToken(str(error)) from None


def _is_invisible(character: str) -> bool:
    return character.isspace() or unicodedata.category(character) in ("Cc", "Cf")


def _describe(character: str) -> str:
    """The number of an invisible character, and the kind of any other."""
    if character == " ":
        return "a space"
    if _is_invisible(character):
        return f"an invisible character (U+{ord(character):04X})"
    if "\ud800" <= character <= "\udfff":
        return "a byte that is not UTF-8"
    return "a character that is not ASCII"
