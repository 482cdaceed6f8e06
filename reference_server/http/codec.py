"""Bytes to messages and back: media types, validation.

Nothing is parsed before its size is known; nothing is decoded that could hold code.
Every fault of a body becomes a refusal with JSON pointers, never a failure (ERR-012).
"""

from __future__ import annotations

import contextlib
import json
import re
import secrets
from collections.abc import Iterable, Sequence
from datetime import datetime
from functools import lru_cache
from typing import Any, TypeVar, cast

import msgspec
import pybase64
from pydantic import BaseModel, ValidationError
from pydantic_core import ErrorDetails
from starlette.requests import Request
from starlette.responses import Response
from starlette.types import Receive, Scope, Send

from reference_record.formats.json_pointer import pointer_step
from reference_record.texts.pattern_words import in_words
from reference_server.generated.models import SubmitRun
from reference_server.http.bodies.malformed_bodies import explain
from reference_server.rules.manifest import Submission
from reference_server.rules.refusal import Refused

JSON = "application/json"
MSGPACK = "application/msgpack"
# Longer ones are not split: that would cost more than the operation. Browsers send 150.
ACCEPT_CHARS_MAX = 512
# Copying less costs less than sending one part more.
LARGE_BYTES = 2**15
# msgspec reads two kinds of numbers otherwise than the spec: the integer -0, and
# integers beyond the doubles. A match inside a text does no harm. A regular expression
# would look for 309 digits from each digit on, and take seconds for a body full of
# shorter numbers: so every digit is made a zero, and the zeros are searched for.
_MINUS_ZERO = re.compile(rb"-0[\s,\]}]")
_DIGITS_AS_ZEROS = bytes.maketrans(b"123456789", b"0" * 9)
_LONG_INTEGER = b"0" * 309
_BIN_32 = b"\xc6"  # MessagePack: a length of four bytes and that much follow

# Other values of Content-Encoding are passed over: clients have charsets there.
_CODINGS = {"gzip", "x-gzip", "deflate", "compress", "br", "zstd"}

Model = TypeVar("Model", bound=BaseModel)


def decode(body: bytes, media_type: str) -> Any:
    """The structure in a body; refused when malformed (ERR-002, ERR-006, ERR-013).

    ENC-012: MessagePack in every format that it has.
    """
    with refuse_malformed(body, media_type):
        return parse(body, media_type)


def parse(body: bytes, media_type: str) -> Any:
    """As `decode`, inside of `refuse_malformed`."""
    if media_type == MSGPACK:
        return msgspec.msgpack.decode(body, ext_hook=_reject_extension)
    return _from_json(body)


def refuse_malformed(
    body: bytes, media_type: str
) -> contextlib.AbstractContextManager[None]:
    """Make a refusal of what the decoder of a body raises inside of it."""
    return _MalformedRefusal(body, media_type)


class _MalformedRefusal:
    """A class, because a generator would take as long as to decode a small body."""

    __slots__ = ("_body", "_media_type")

    def __init__(self, body: bytes, media_type: str) -> None:
        self._body, self._media_type = body, media_type

    def __enter__(self) -> None:
        pass

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, *_: object
    ) -> None:
        if error is None:
            return
        if isinstance(error, RecursionError):
            raise Refused("malformed_body", "The body is nested too deeply.") from error
        if isinstance(error, msgspec.MsgspecError | UnicodeDecodeError | ValueError):
            text = explain(self._body, error, is_json=self._media_type != MSGPACK)
            text = f"The body is malformed: {text}."
            raise Refused("malformed_body", text) from error


def _from_json(body: bytes) -> Any:
    """ENC-010: 1e-999 is zero."""
    structure = msgspec.json.decode(body)
    if has_unusual_integers(body):
        return json.loads(body, parse_int=_parse_integer)
    return structure


def has_unusual_integers(body: bytes) -> bool:
    """Whether a JSON body may have integers that msgspec reads otherwise."""
    if _MINUS_ZERO.search(body) is not None:
        return True
    return _LONG_INTEGER in body.translate(_DIGITS_AS_ZEROS)


def _parse_integer(digits: str) -> float:
    if digits == "-0":
        return -0.0  # ENC-003: a double with a sign, which an integer has not
    number = int(digits)
    try:
        float(number)
    except OverflowError as error:
        raise ValueError("an integer beyond the range of a double") from error
    return number


def read_submission(data: Any) -> Submission:
    """A submission in the form of `submit_run`; a fault is refused by pointer."""
    return cast("Submission", validate(SubmitRun, data).model_dump())


def validate(model: type[Model], data: Any) -> Model:
    """The message in a structure; a fault is refused by pointer.

    ERR-003, ERR-004, ERR-015, ERR-016: as the schema has it. ENC-011: no message has a
    member whose name is not a string.
    """
    try:
        return model.model_validate(data, strict=True)
    except ValidationError as error:
        faults = error.errors(include_url=False)
        if _accept_whole_numbers(data, faults):
            return validate(model, data)
        if _contains_timestamp(data):
            # ENC-008: the one extension that msgspec knows by itself.
            raise Refused(
                "malformed_body", "MessagePack extension types are not supported."
            ) from error
        raise Refused(
            "invalid_request",
            "The body does not match its schema.",
            errors=((pointer(_place(data, f["loc"])), words_of(f)) for f in faults),
        ) from error


def words_of(fault: ErrorDetails) -> str:
    """A fault of a schema as its author reads it."""
    if fault["input"] is None and fault["type"].endswith("_type"):
        return f"is null. {fault['msg']}"
    pattern = fault.get("ctx", {}).get("pattern")
    return fault["msg"] if pattern is None else in_words(pattern, fault["input"])


def pointer(loc: Iterable[str | int]) -> str:
    """RFC 6901."""
    return "".join(f"/{pointer_step(str(part))}" for part in loc)


def media_type_of(request: Request, readable: Sequence[str]) -> str:
    """The body's media type (ERR-007, ERR-019)."""
    coding = request.headers.get("content-encoding", "").strip().lower()
    if coding in _CODINGS:
        raise Refused(
            "unsupported_media_type",
            f"Content-Encoding {coding} is not supported: send the body uncompressed.",
        )
    declared = request.headers.get("content-type", "")
    media_type = declared.partition(";")[0].strip().lower()
    if media_type not in readable:
        raise Refused(
            "unsupported_media_type",
            f"Content-Type {media_type[:100] or '(none)'} is not supported; supported: "
            f"{', '.join(readable)}.",
        )
    return media_type


def negotiate_media_type(request: Request, writable: Sequence[str]) -> str:
    """The media type of the response (ERR-008); of equals the first: JSON (ENC-001)."""
    header = ",".join(request.headers.getlist("accept")) or "*/*"
    if len(header) > ACCEPT_CHARS_MAX:
        raise Refused(
            "not_acceptable",
            f"The header Accept is longer than {ACCEPT_CHARS_MAX} characters.",
        )
    best = _best(header, tuple(writable))
    if not best:
        raise Refused(
            "not_acceptable", f"Supported response types: {', '.join(writable)}."
        )
    return best


@lru_cache(maxsize=64)
def _best(accept: str, writable: Sequence[str]) -> str:
    """The media type to write: the first of equals, empty if none is accepted.

    Results are cached, because clients send the same header again and again.
    """
    ranges = [_range(part) for part in accept.split(",")]
    best, best_q = "", 0.0
    for media_type in writable:
        q = _weight(media_type, ranges)
        if q > best_q:
            best, best_q = media_type, q
    return best


def encode_response(
    content: Any, media_type: str = JSON, status: int = 200
) -> Response:
    """A response. Blobs are Base64 in JSON, `bin` in MessagePack (ENC-002, ENC-004)."""
    first, *others = encode_segments(content, media_type)
    if others:
        return SegmentedResponse([first, *others], status, media_type)
    return EncodedResponse(bytes(first), status, media_type)


class EncodedResponse(Response):
    """An answer in JSON or MessagePack, with the headers that Starlette makes of it.

    Starlette's own way to them takes longer than to encode a turn.
    """

    def __init__(self, body: bytes, status: int, media_type: str) -> None:
        self.status_code, self.media_type = status, media_type
        self.background, self.body = None, body
        self.raw_headers = [
            (b"content-length", b"%d" % len(body)),
            (b"content-type", media_type.encode("latin-1")),
        ]


class SegmentedResponse(Response):
    """An answer whose large images are sent from where they are."""

    def __init__(
        self, parts: Sequence[bytes | memoryview], status: int, media_type: str
    ) -> None:
        super().__init__(None, status, media_type=media_type)
        self.parts = parts
        self.headers["content-length"] = str(sum(map(len, parts)))

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """ASGI: the parts one by one under one Content-Length."""
        start = {"status": self.status_code, "headers": self.raw_headers}
        await send({"type": "http.response.start", **start})
        last = len(self.parts) - 1
        for index, part in enumerate(self.parts):
            more = {"body": part, "more_body": index < last}
            await send({"type": "http.response.body", **more})


def encode_segments(
    content: Any, media_type: str = MSGPACK
) -> Sequence[bytes | memoryview]:
    """The encoded content, in parts to be sent one after another.

    Large images are parts of their own: uncopied in MessagePack, and in JSON Base64 by
    pybase64, which takes a tenth of the time that msgspec does. The rest is encoded by
    msgspec with a mark in place of each image, which cannot be guessed, and is cut at
    the marks: this needs no encoder of ours.
    """
    if media_type == MSGPACK:
        encode, frame = msgspec.msgpack.encode, _in_msgpack
    else:
        encode, frame = msgspec.json.encode, _in_json
    large = _large_images(content)
    if not large:
        return [encode(content)]
    placeholder, blobs, images_with_placeholder = secrets.token_bytes(16), [], {}
    for name, image in large.items():
        before, blob, after = frame(image["data"])
        blobs.append(blob)
        images_with_placeholder[name] = image | {
            "data": msgspec.Raw(before + placeholder + after)
        }
    observation = content["observation"]
    images = observation["images"] | images_with_placeholder
    turn = content | {"observation": observation | {"images": images}}
    first, *others = encode(turn).split(placeholder)
    parts: list[bytes | memoryview] = [first]
    for blob, around in zip(blobs, others, strict=True):
        parts += [blob, around]
    return parts


def _in_msgpack(blob: memoryview) -> tuple[bytes, bytes | memoryview, bytes]:
    return _BIN_32 + len(blob).to_bytes(4, "big"), blob, b""


def _in_json(blob: memoryview) -> tuple[bytes, bytes | memoryview, bytes]:
    return b'"', pybase64.b64encode(blob), b'"'


def _large_images(content: Any) -> dict[str, Any]:
    """The images of a turn's observation that are too large to copy, in its order."""
    observation = content.get("observation") if isinstance(content, dict) else None
    images = observation.get("images") if isinstance(observation, dict) else None
    if not isinstance(images, dict):
        return {}
    return {
        name: image
        for name, image in images.items()
        if len(image["data"]) >= LARGE_BYTES
    }


def _range(part: str) -> tuple[str, float]:
    """A media range of Accept and its weight (ERR-019)."""
    name, *parameters = (piece.strip().lower() for piece in part.split(";"))
    for parameter in parameters:
        key, _, value = parameter.partition("=")
        if key.strip() == "q":
            try:
                return name, float(value)
            except ValueError:
                return name, 0.0
    return name, 1.0


def _weight(media_type: str, ranges: Sequence[tuple[str, float]]) -> float:
    """RFC 9110, 12.5.1: of the ranges that match, the most specific one counts."""
    kind = media_type.partition("/")[0]
    for wanted in (media_type, f"{kind}/*", "*/*"):
        weights = [q for name, q in ranges if name == wanted]
        if weights:
            return max(weights)
    return 0.0


def _reject_extension(code: int, _data: memoryview) -> Any:
    raise ValueError(f"extension type {code}")


def _contains_timestamp(data: Any) -> bool:
    """Whether a timestamp stands anywhere, however deep the sender put it."""
    rest = [data]
    while rest:
        value = rest.pop()
        if isinstance(value, datetime):
            return True
        if isinstance(value, dict):
            rest += [*value, *value.values()]
        elif isinstance(value, list | tuple):
            rest += value
    return False


def _place(data: Any, loc: Sequence[int | str]) -> Sequence[int | str]:
    """The path of a fault, without what pydantic adds: the name of a type in a union.

    The last step may be a member that is missing.
    """
    for index, step in enumerate(loc):
        if isinstance(data, dict):
            data = data.get(step)
        elif isinstance(data, list) and isinstance(step, int) and step < len(data):
            data = data[step]
        else:
            return loc[:index]
    return loc


def _accept_whole_numbers(data: Any, faults: Sequence[Any]) -> bool:
    """JSON Schema calls 630.0 an integer; strict models do not. Mend those, in place.

    Returns whether anything was mended. Runs only after a failed validation.
    """
    corrected = False
    for fault in faults:
        number = fault["input"]
        whole = isinstance(number, float) and number.is_integer()
        place = _place(data, fault["loc"])
        if fault["type"] != "int_type" or not whole or not place:
            continue
        *path, last = place
        container = data
        for step in path:
            container = container[step]
        container[last] = int(number)
        corrected = True
    return corrected
