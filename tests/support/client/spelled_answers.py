"""Answers in spellings that spec/openapi.yaml allows and few servers use.

A number as 5.0E-1, a time with an offset and nine digits, escapes and white space, a
media type in other letters with parameters, an interim answer before and trailers
behind. The module must not know which member an answer has.
"""

import json
import re
from collections.abc import Iterable
from datetime import datetime, timedelta, timezone
from typing import Any

import msgspec

_TIME = re.compile(r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d(\.\d{1,9})?Z")
_OFFSET = timezone(timedelta(hours=5, minutes=30))
_MARK = "\ue000"  # around a number: removed with its quotes
_INTERIM = b"HTTP/1.1 103 Early Hints\r\nLink: </v1>; rel=preload\r\n\r\n"


def spell(status: int, headers: Iterable[tuple[str, str]], body: bytes) -> bytes:
    """The answer as bytes: a success or a problem in JSON, in other spellings."""
    lines = [f"HTTP/1.1 {status} "]  # without a reason
    is_json = False
    for name, value in headers:
        is_media_type = name.lower() == "content-type"
        is_json = is_json or (is_media_type and "json" in value)
        more = ' ; CharSet="utf-8"' if is_media_type else ""
        shown = value.title() if is_media_type else value
        lines.append(f"{name.upper()}:\t{shown}{more}  ")
    head = "\r\n".join(lines).encode()
    if status in (204, 304):
        return _INTERIM + head + b"\r\n\r\n"
    if is_json:
        body = _spell_json(msgspec.json.decode(body))
    middle = len(body) // 2
    parts = [part for part in (body[:middle], body[middle:]) if part]
    chunks = b"".join(b"%X;a=b\r\n%b\r\n" % (len(part), part) for part in parts)
    return b"".join(
        [
            *(_INTERIM, head, b"\r\nTransfer-Encoding: Chunked\r\n\r\n"),
            *(chunks, b"000\r\nX-Digest: none\r\n\r\n"),
        ]
    )


def _spell_json(value: object) -> bytes:
    text = json.dumps(_marked(value), indent=1, separators=(" ,", "\t: "))
    escaped_mark = json.dumps(_MARK)[1:-1]
    numbers = re.sub(f'"{re.escape(escaped_mark)}([^"]*)"', r"\1", text)
    return f"\r\n{numbers}\n ".encode()


def _marked(value: Any) -> Any:
    if isinstance(value, float):
        return f"{_MARK}{value:.17E}"
    if isinstance(value, list):
        return [_marked(item) for item in value]
    if isinstance(value, dict):
        return {name: _marked(item) for name, item in reversed(value.items())}
    if isinstance(value, str) and _TIME.fullmatch(value):
        moment = datetime.fromisoformat(value).astimezone(_OFFSET)
        return moment.strftime("%Y-%m-%dT%H:%M:%S.%f000+05:30")
    return value
