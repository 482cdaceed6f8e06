"""An HTTP response as a check reads it, and the parser of its body.

Plain data: nothing here sends a request or judges a response.
"""

import codecs
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import httpx
import msgspec

from conformance.specification.document import (
    EVENT_STREAM,
    JSON,
    MSGPACK,
    PROBLEM_JSON,
)


@dataclass(frozen=True)
class Answer:
    """One HTTP answer; `json` is the parsed body, JSON or MessagePack, or None."""

    status: int
    headers: httpx.Headers
    body: bytes
    started_at: float
    ended_at: float
    json: Any
    exchange: int

    @property
    def elapsed_s(self) -> float:
        """Time from sending the request to having read the answer."""
        return self.ended_at - self.started_at

    @property
    def code(self) -> str | None:
        """The problem code, if the body is an object that has one."""
        code = self.json.get("code") if isinstance(self.json, dict) else None
        return code if self.status >= 400 and isinstance(code, str) else None

    @property
    def media_type(self) -> str:
        """Content type without parameters, in lower case."""
        return media_type_of(self.headers)


@dataclass(frozen=True)
class ParsedAnswer:
    """The parts of a response that the universal rules judge."""

    status: int
    headers: Mapping[str, str]
    media_type: str
    body: bytes
    value: Any
    is_readable: bool


def media_type_of(headers: Mapping[str, str]) -> str:
    """Give the content type without parameters, in lower case."""
    return headers.get("content-type", "").partition(";")[0].strip().lower()


# Answers that are files; their value is text with a character for each byte.
_FILES = ("application/zip", "application/octet-stream")
_BYTES_AS_TEXT = "latin-1"


def file_of(answer: Answer) -> bytes:
    """Give the bytes of an answer that is a file; none if it is something else."""
    if answer.media_type not in _FILES or not isinstance(answer.json, str):
        return b""
    return answer.json.encode(_BYTES_AS_TEXT)


def describe_body(answer: Answer | ParsedAnswer) -> str:
    """Say why a body cannot be read as a JSON object, to the server's author."""
    if answer.media_type != JSON:
        return f"its Content-Type is {answer.media_type or 'absent'}, not {JSON}"
    if not answer.body:
        return "its body is empty"
    if answer.body.startswith(codecs.BOM_UTF8):
        return "its body begins with a byte order mark, which JSON has not"
    try:
        value = msgspec.json.decode(answer.body.decode())
    except UnicodeDecodeError as error:
        return f"its body is not UTF-8: byte {error.start} is {error.reason}"
    except (msgspec.DecodeError, RecursionError) as error:
        return f"its body is no JSON: {error}"
    kind = "an object" if isinstance(value, dict) else "JSON, but not an object"
    return f"its body is {kind}"


def parse(media_type: str, body: bytes) -> tuple[Any, bool]:
    """Read a body by its media type; strictly, so that NaN is an error."""
    try:
        if media_type in (JSON, PROBLEM_JSON):
            return msgspec.json.decode(body), True
        if media_type == MSGPACK:
            return msgspec.msgpack.decode(body), True
        if media_type in _FILES:
            return body.decode(_BYTES_AS_TEXT), True
        if media_type == EVENT_STREAM:
            # The bytes that were kept may end in the middle of a character.
            return codecs.getincrementaldecoder("utf-8")().decode(body), True
    except (msgspec.DecodeError, UnicodeDecodeError, RecursionError):
        pass
    return None, False
