"""Words for a body that cannot be decoded: what it is, and where it breaks.

Called for a body that was refused. It looks at the first bytes, and for two faults that
a decoder reports as something else: half of a surrogate pair, and NaN.
"""

from __future__ import annotations

import re

import msgspec

_BEGINNINGS: tuple[tuple[bytes, str], ...] = (
    (b"\x1f\x8b", "it is compressed with gzip; send it uncompressed"),
    (b"\x28\xb5\x2f\xfd", "it is compressed with zstd; send it uncompressed"),
    *(
        (bytes([0x78, level]), "it is compressed with deflate; send it uncompressed")
        for level in (0x01, 0x5E, 0x9C, 0xDA)
    ),
    (b"\xef\xbb\xbf", "it begins with a byte order mark; send UTF-8 without one"),
    (b"\xff\xfe", "it is UTF-16; send UTF-8"),
    (b"\xfe\xff", "it is UTF-16; send UTF-8"),
    *(
        (bytes([0x80, protocol, first]), "it is a pickle, not JSON or MessagePack")
        for protocol in (2, 3, 4, 5)
        for first in b"}](X\x95\x8cGKJN"
    ),
    (b"PK\x03\x04", "it is a zip archive"),
    (b"\x89PNG", "it is a PNG image"),
    (b"\xff\xd8\xff", "it is a JPEG image"),
)
# Behind an even number of backslashes, which stand for themselves.
_HALF_PAIR = re.compile(
    rb"(?<!\\)(?:\\\\)*(\\u[dD](?:[89abAB][0-9a-fA-F]{2}(?!\\u[dD][c-fC-F])"
    rb"|(?<!\\u[dD][89abAB][0-9a-fA-F]{2}\\u[dD])[c-fC-F][0-9a-fA-F]{2}))"
)
_NO_NUMBER = re.compile(rb"-?(?:NaN|Infinity|nan|inf)\b")
_FORM = re.compile(rb"[A-Za-z0-9_.%+-]{1,64}=")
_AT = re.compile(r"\(byte ([0-9]+)\)")
# Further bytes are not searched: a client that has one of the faults has it early.
SEARCHED_BYTES = 2**16


def explain(body: bytes, error: Exception, *, is_json: bool) -> str:
    """The end of the sentence that begins with `The body is malformed: `.

    error: what the decoder raised, or a ValueError that says all.
    """
    if not isinstance(error, msgspec.MsgspecError | UnicodeDecodeError):
        return str(error)
    return (
        _kind_of(body, is_json=is_json)
        or (_odd_value(body, str(error)) if is_json else "")
        or _words_of(error)
    )


def _kind_of(body: bytes, *, is_json: bool) -> str:
    """The kind of the whole body in words; empty if it is not known."""
    if not body:
        return "it is empty"
    for beginning, text in _BEGINNINGS:
        if body.startswith(beginning):
            return text
    first = body.lstrip()[:1]
    if not is_json:
        is_object = first == b"{" and body.rstrip().endswith(b"}")
        return "it is JSON, not MessagePack" if is_object else ""
    if 0x80 <= body[0] <= 0x9F or 0xDC <= body[0] <= 0xDF:
        return "it is MessagePack, not JSON"
    if _FORM.match(body):
        return "it is a form, not JSON"
    return "it is HTML or XML, not JSON" if first == b"<" else ""


def _odd_value(body: bytes, words: str) -> str:
    """A value of which the decoder does not say what is wrong with it."""
    if "truncated" in words or "surrogate" in words:
        half = _HALF_PAIR.search(body, 0, SEARCHED_BYTES)
        if half is not None:
            text = half[1].decode("ascii")
            return (
                f"a text has {text}, half of a surrogate pair, at byte {half.start(1)}"
            )
    at = _AT.search(words)
    if at is not None and (number := _NO_NUMBER.match(body, int(at[1]))):
        return f"{number[0].decode('ascii')} is not a number of JSON ({at[0][1:-1]})"
    return ""


def _words_of(error: Exception) -> str:
    if isinstance(error, UnicodeDecodeError):
        wrong = error.object[error.start : error.start + 1].hex()
        return f"a text is not UTF-8 (it has the byte 0x{wrong})"
    text = str(error)
    if "truncated" in text:
        return "it ends too early"
    return text.partition(" is malformed: ")[2] or text
