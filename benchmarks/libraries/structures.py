"""Encoding and decoding of a turn: MessagePack and JSON, with and without images.

Encoded is a turn as the reference server holds it; decoded are the bytes that it sent.
A library without Base64 is combined with pybase64, the standard library with its own.
"""

from __future__ import annotations

import base64
import json
from collections.abc import Callable
from typing import Any

import msgpack
import msgspec
import orjson
import ormsgpack
import pybase64

from benchmarks.libraries.interleaved_timing import Contender
from benchmarks.libraries.samples import Sample, with_pictures
from reference_client.generated.messages import Turn

Contenders = tuple[list[Contender], Any]
_PLAIN_TYPES = (bytes, bytearray, memoryview)
# Decodes into the structures of the client; Base64 by itself.
CHOSEN = "msgspec"
DICTS = "msgspec, into dicts"
JOINED = "msgspec with pybase64"


def msgpack_encoded(sample: Sample) -> Contenders:
    """All encodings must decode to the same; msgspec's are the bytes on the wire."""
    turn = sample.turn()
    assert msgspec.msgpack.encode(turn) == sample.body
    writers: dict[str, Callable[[Any], bytes]] = {
        CHOSEN: msgspec.msgpack.encode,
        "msgpack": msgpack.packb,
        "ormsgpack": ormsgpack.packb,
    }
    return [
        Contender(name, write, lambda: turn, msgspec.msgpack.decode)
        for name, write in writers.items()
    ], turn


def msgpack_decoded(sample: Sample) -> Contenders:
    body = sample.body
    readers: dict[str, Callable[[bytes], Any]] = {
        CHOSEN: msgspec.msgpack.Decoder(Turn).decode,
        DICTS: msgspec.msgpack.decode,
        "msgpack": msgpack.unpackb,
        "ormsgpack": ormsgpack.unpackb,
    }
    return _readings(readers, body), sample.turn()


def json_encoded(sample: Sample) -> Contenders:
    """Only pictures are in Base64: a turn without them is encoded as it is."""
    turn = sample.turn()
    writers: dict[str, Callable[[Any], bytes]] = {
        CHOSEN: msgspec.json.encode,
        "orjson with pybase64": orjson.dumps,
        "json with base64": _to_json,
    }
    if turn["observation"]["images"]:
        writers |= {
            JOINED: lambda turn: msgspec.json.encode(with_pictures(turn, _quoted)),
            "orjson with pybase64": lambda turn: orjson.dumps(
                with_pictures(turn, pybase64.b64encode_as_string)
            ),
            "json with base64": lambda turn: _to_json(with_pictures(turn, _to_base64)),
        }
    return [
        Contender(name, write, lambda: turn, _of_json)
        for name, write in writers.items()
    ], turn


def json_decoded(sample: Sample) -> Contenders:
    """Base64 that breaks its rules would be refused by all."""
    turn = sample.turn()
    text = msgspec.json.encode(turn)
    readers: dict[str, Callable[[bytes], Any]] = {
        CHOSEN: msgspec.json.Decoder(Turn).decode,
        DICTS: msgspec.json.decode,
        "orjson with pybase64": orjson.loads,
        "json with base64": json.loads,
    }
    if turn["observation"]["images"]:
        del readers[DICTS]  # leaves the pictures in Base64
        readers |= {
            JOINED: lambda text: msgspec.convert(
                with_pictures(msgspec.json.decode(text), _by_pybase64), Turn
            ),
            "orjson with pybase64": lambda text: with_pictures(
                orjson.loads(text), _by_pybase64
            ),
            "json with base64": lambda text: with_pictures(
                json.loads(text), _by_base64
            ),
        }
    return _readings(readers, text), turn


def _readings(
    readers: dict[str, Callable[[bytes], Any]], body: bytes
) -> list[Contender]:
    return [
        Contender(name, read, lambda: body, _builtins) for name, read in readers.items()
    ]


def _to_json(turn: dict[str, Any]) -> bytes:
    return json.dumps(turn, separators=(",", ":")).encode()


def _to_base64(data: memoryview) -> str:
    return base64.b64encode(data).decode()


def _by_base64(data: str) -> bytes:
    return base64.b64decode(data, validate=True)


def _quoted(data: memoryview) -> msgspec.Raw:
    """A JSON string that msgspec copies unchanged."""
    return msgspec.Raw(b'"%b"' % pybase64.b64encode(data))


def _by_pybase64(data: str) -> bytes:
    decoded: bytes = pybase64.b64decode(data, validate=True)
    return decoded


def _of_json(text: bytes) -> Any:
    return _builtins(msgspec.json.decode(text, type=Turn))


def _builtins(made: Any) -> Any:
    return msgspec.to_builtins(made, builtin_types=_PLAIN_TYPES)
