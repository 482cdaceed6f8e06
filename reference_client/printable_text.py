"""Texts of a server as a terminal may show them, and streams that can write any text.

A control sequence in a text can rewrite what stands above it, set the clipboard or the
title, and hide what follows; a mark of direction can reorder a line. A lone surrogate
cannot be written at all. All of them are shown as Python would write them.

`make generate` copies this file to the kit.
"""

from __future__ import annotations

import codecs
import contextlib
import io
import os
import re
import sys
from collections.abc import Iterator
from typing import Any

# All of C0 but tab and line feed, DEL, C1, marks of direction, surrogates.
_UNPRINTABLE = re.compile(
    "[\x00-\x08\x0b-\x1f\x7f-\x9f"
    "\u061c\u200e\u200f\u2028-\u202e\u2066-\u2069\ud800-\udfff]"
)
# Replacements for characters that an encoding lacks; others are escaped.
_ASCII = {
    "…": "...",
    "–": "-",
    "—": "-",
    "─": "-",
    "━": "-",
    "·": "|",
    "•": "*",
    "→": "->",
    "≤": "<=",
    "≥": ">=",
    "×": "x",
    "±": "+-",
    "µ": "u",
    "α": "alpha",
    "“": '"',
    "”": '"',
    "‘": "'",
    "’": "'",
    "\u00a0": " ",
    "✓": "yes",
    "✗": "no",
}
_ERRORS = "proctor-ascii"


def printable(text: str) -> str:
    """The text with an escape, such as \\x1b, for each character that acts."""
    return _UNPRINTABLE.sub(lambda match: ascii(match[0])[1:-1], text)


def prepare_output() -> None:
    """Make the standard streams write every text, whatever their encoding.

    A page of codes of Windows, Latin-1 or ASCII lack what our texts and names of people
    have, and a program that has played a run must not end for that.
    """
    codecs.register_error(_ERRORS, _in_ascii)
    for name in ("stdout", "stderr"):
        stream = getattr(sys, name)
        if stream is None:  # closed by the shell: `>&-`
            nowhere = os.open(os.devnull, os.O_WRONLY)
            setattr(sys, name, os.fdopen(nowhere, "w", encoding="utf-8"))
        elif isinstance(stream, io.TextIOWrapper):
            # The file behind a stream may be another one than when it was opened.
            with contextlib.suppress(OSError):
                stream.reconfigure(errors=_ERRORS)


@contextlib.contextmanager
def output_that_may_end(stream: Any) -> Iterator[None]:
    """Write in this block to a stream that may be closed, or on a disk that is full.

    Then nothing more is written to it: messages are not worth the end of a program.
    """
    try:
        yield
    except (OSError, ValueError):
        discard_output(stream)


class LenientStream(io.TextIOBase):
    """Another stream, whose end is not noticed by who prints to it.

    A program may have replaced its standard streams: `write` alone is expected of them.
    None, as in a program without a console, is a stream to nowhere.
    """

    def __init__(self, stream: Any) -> None:
        super().__init__()
        self._stream = stream

    @property
    def encoding(self) -> str:  # type: ignore[override]
        """That of the other stream, as far as it says."""
        return getattr(self._stream, "encoding", None) or "utf-8"

    def write(self, text: str) -> int:
        """Write what can be written."""
        if self._stream is not None:
            with output_that_may_end(self._stream):
                self._stream.write(text)
        return len(text)

    def flush(self) -> None:
        """Flush the other stream, if it can be flushed."""
        with output_that_may_end(self._stream):
            _ask(self._stream, "flush")

    def isatty(self) -> bool:
        """Say whether the other stream is a terminal, as far as it knows."""
        with contextlib.suppress(OSError, ValueError):
            return bool(_ask(self._stream, "isatty"))
        return False

    def fileno(self) -> int:
        """Give the file of the other stream. Raises OSError if it has none."""
        place = _ask(self._stream, "fileno")
        if not isinstance(place, int):
            raise io.UnsupportedOperation("the stream has no file")
        return place


def discard_output(stream: Any) -> None:
    """Write to nowhere what is still written to a stream, also when Python exits.

    A stream without a file is left as it is.
    """
    with contextlib.suppress(OSError, ValueError):
        place = _ask(stream, "fileno")
        if isinstance(place, int):
            os.dup2(os.open(os.devnull, os.O_WRONLY), place)


def _ask(stream: Any, name: str) -> Any:
    """The answer of a method that a replaced stream may lack: then None."""
    method = getattr(stream, name, None)
    return method() if callable(method) else None


def _in_ascii(error: UnicodeError) -> tuple[str, int]:
    if not isinstance(error, UnicodeEncodeError):
        raise error
    text = error.object[error.start : error.end]
    written = (
        _ASCII.get(character) or character.encode("ascii", "backslashreplace").decode()
        for character in text
    )
    return "".join(written), error.end
