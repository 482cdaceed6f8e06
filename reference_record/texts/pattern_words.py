"""The patterns of the specification in words, for people whose value breaks one."""

from __future__ import annotations

import re

_CLASS = re.compile(r"\[(?P<characters>[^\]]+)\]\{(?P<least>\d+)(?:,(?P<most>\d+))?\}")
_ANYTHING = re.compile(r"\(\?s:\.\{(?P<least>\d+),(?P<most>\d+)\}\)")
_CHARACTERS = {
    "A-Za-z0-9_-": "letters, digits, _ or -",
    "A-Za-z0-9_.-": "letters, digits, _, . or -",
    "A-Za-z0-9_.,-": "letters, digits, _, ., - or commas",
    "0-9": "digits",
    "0-9a-f": "digits or letters from a to f",
    r"\x21-\x7e": "visible ASCII characters without spaces",
}
_WHOLE = {
    r"[a-z][a-z0-9_]{0,63}": (
        "must begin with a letter from a to z, and have 1 to 64 such letters, digits "
        "or _"
    ),
    r"[1-9][0-9]{0,14}": "must be a whole number from 1 on, of at most 15 digits",
    r"[a-z][a-z0-9]{2,31}": (
        "must begin with a letter from a to z, and have 3 to 32 such letters or digits"
    ),
    r"[a-z][a-z0-9_-]{0,63}": (
        "must begin with a letter from a to z, and have 1 to 64 such letters, digits, "
        "_ or -"
    ),
    r"[A-Za-z0-9_-]{1,64}(,[A-Za-z0-9_-]{1,64}){0,15}": (
        "must be 1 to 16 ids, separated by commas, each of 1 to 64 letters, digits, _ "
        "or -"
    ),
    r"[0-9]{1,4}(\.[0-9]{1,40})?([Ee][+-]?[0-9]{1,3})?": "must be a number",
    r"sha256:[0-9a-f]{64}": "must be sha256: and 64 digits or letters from a to f",
    r"[0-9]{1,4}\.[0-9]{1,4}": "must be MAJOR.MINOR, for example 1.0",
    r"wait=[0-9]{1,4}": "must be wait=SECONDS, for example wait=20",
    r"[0-9]+\.[0-9]+": "must be MAJOR.MINOR, for example 1.0",
    r"[!-~]+": "must have visible ASCII characters without spaces alone",
    r"https?://[!-~]+": "must begin with http:// or https://, and have no spaces",
    r"https?://[A-Za-z0-9.:_\[\]-]+(/[A-Za-z0-9._~%/-]*)?": (
        "must be http:// or https:// with a host and, at most, a path: without user, "
        "query or fragment"
    ),
}


def in_words(pattern: str, value: str = "?") -> str:
    """The end of a sentence that begins with the name of the value."""
    pattern = pattern.removeprefix("^").removesuffix("$")
    words = _WHOLE.get(pattern) or _in_numbers(pattern) or f"must match {pattern}"
    return words if value else f"is empty; it {words}"


def _in_numbers(pattern: str) -> str:
    """Words for so many characters of a kind; empty for other patterns."""
    anything = _ANYTHING.fullmatch(pattern)
    if anything:
        return f"must have {anything['least']} to {anything['most']} characters"
    match = _CLASS.fullmatch(pattern)
    if match is None or match["characters"] not in _CHARACTERS:
        return ""
    count = match["least"] + (f" to {match['most']}" if match["most"] else "")
    return f"must be {count} {_CHARACTERS[match['characters']]}"
