"""Text files that people write, as their editors save them.

A byte order mark is dropped; UTF-16 and other encodings are refused in a sentence.
`make generate` copies this file to the kit.
"""

from __future__ import annotations

import codecs
from pathlib import Path

_MARKS = (codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)


class NotText(ValueError):
    """The bytes are not a text in UTF-8; the message says what they are."""


def read_text_file(path: str | Path) -> str:
    """The text of a file. Raises OSError, and NotText."""
    return decode_text(Path(path).read_bytes())


def decode_text(data: bytes) -> str:
    """The text of a file's bytes. Raises NotText."""
    text = data.removeprefix(codecs.BOM_UTF8)
    if text.startswith(_MARKS) or b"\0" in text[:1024]:
        raise NotText("it is in UTF-16 or not a text file; save it as UTF-8")
    try:
        return text.decode("utf-8")
    except UnicodeDecodeError as error:
        line = text.count(b"\n", 0, error.start) + 1
        raise NotText(f"line {line} is not UTF-8; save the file as UTF-8") from error
