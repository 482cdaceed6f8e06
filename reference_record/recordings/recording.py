"""Defines the channels and messages of a recording, and encodes them as MCAP records.

A recording is one MCAP file for one episode, with all its attempts. It knows neither
HTTP nor databases nor simulators. While the episode is played its messages are
appended to parts (`recording_parts.py`); when it has a result, the parts become one
compressed file (`recording_file.py`).

MCAP is written here and not by its library: a turn is recorded in a few microseconds,
and a part that was cut anywhere is read up to the last whole message.
"""

from __future__ import annotations

import hashlib
import struct
import zlib
from collections.abc import Mapping, Sequence
from functools import lru_cache
from typing import Any

import msgspec

Actions = Sequence[Mapping[str, Sequence[float]]]


class AttemptEvent(msgspec.Struct, omit_defaults=True):
    """An attempt begins at step 0 (event "started"), or is over (event "ended").

    state_digest: the digest of the state at step 0. instruction: what the policy was
    asked to do. stages: names of what the score counts before the goal, in order.
    reason: why it ended.
    """

    attempt: int
    event: str
    at: str
    reason: str | None = None
    state_digest: str | None = None
    instruction: str | None = None
    stages: Sequence[str] = ()


class Turn(msgspec.Struct):
    """A turn that was executed.

    actions: those that were executed, after clipping; each has a reward. steps: how
    many they are. score, success, ended, state_digest: the episode's after them.
    think_ms: the time between the answer to the previous turn and this request.
    """

    attempt: int
    seq: int
    actions: Actions
    rewards: Sequence[float]
    steps: int
    score: float
    success: bool
    ended: bool
    state_digest: str
    simulate_ms: float
    think_ms: float
    at: str


class Fault(msgspec.Struct):
    """A failure. code: simulator_fault or policy_fault. seq: 0 outside of a turn."""

    attempt: int
    seq: int
    code: str
    detail: str
    at: str


class RecordedJudgement(msgspec.Struct):
    """A person judged the attempt. judge: a name that the host gives, of no account.

    met: numbers of the criteria of the rubric that were met. blind: whether the person
    knew nothing of the policy. cell: where the attempt was played, if that is said.
    """

    attempt: int
    judge: str
    success: bool
    score: float
    met: Sequence[int]
    note: str
    blind: bool
    at: str
    cell: str = ""


class EpisodeResult(msgspec.Struct):
    """The result of the episode; the last message."""

    outcome: str
    success: bool
    score: float
    steps: int
    attempts: int
    at: str


class Picture(msgspec.Struct):
    """A camera's picture; `data` is encoded in Base64, because JSON has no bytes."""

    timestamp: dict[str, int]
    frame_id: str
    data: bytes
    format: str


Message = AttemptEvent | Turn | Fault | RecordedJudgement | EpisodeResult | Picture

_NUMBER, _TEXT, _WHOLE, _FLAG = (
    {"type": kind} for kind in ("number", "string", "integer", "boolean")
)
_NUMBERS = {"type": "array", "items": _NUMBER}


def _schema(properties: Mapping[str, Any], optional: Sequence[str] = ()) -> bytes:
    required = [name for name in properties if name not in optional]
    schema = {"type": "object", "properties": properties, "required": required}
    return msgspec.json.encode(schema)


# topic → name of its schema and the schema; the position is the channel's id, from 1.
CHANNELS: Mapping[str, tuple[str, bytes]] = {
    "/attempt": (
        "proctor.Attempt",
        _schema(
            {
                "attempt": _WHOLE,
                "event": {"enum": ["started", "ended"]},
                "at": _TEXT,
                "reason": _TEXT,
                "state_digest": _TEXT,
                "instruction": _TEXT,
                "stages": {"type": "array", "items": _TEXT},
            },
            optional=("reason", "state_digest", "instruction", "stages"),
        ),
    ),
    "/turn": (
        "proctor.Turn",
        _schema(
            {
                "attempt": _WHOLE,
                "seq": _WHOLE,
                "actions": {
                    "type": "array",
                    "items": {"type": "object", "additionalProperties": _NUMBERS},
                },
                "rewards": _NUMBERS,
                "steps": _WHOLE,
                "score": _NUMBER,
                "success": _FLAG,
                "ended": _FLAG,
                "state_digest": _TEXT,
                "simulate_ms": _NUMBER,
                "think_ms": _NUMBER,
                "at": _TEXT,
            }
        ),
    ),
    "/fault": (
        "proctor.Fault",
        _schema(
            {
                "attempt": _WHOLE,
                "seq": _WHOLE,
                "code": {"enum": ["simulator_fault", "policy_fault"]},
                "detail": _TEXT,
                "at": _TEXT,
            }
        ),
    ),
    "/result": (
        "proctor.Result",
        _schema(
            {
                "outcome": {"enum": ["success", "failure", "abandoned"]},
                "success": _FLAG,
                "score": _NUMBER,
                "steps": _WHOLE,
                "attempts": _WHOLE,
                "at": _TEXT,
            }
        ),
    ),
}
# Declared where they are used alone.
FURTHER_CHANNELS: Mapping[str, tuple[str, bytes]] = {
    "/judgement": (
        "proctor.Judgement",
        _schema(
            {
                "attempt": _WHOLE,
                "judge": _TEXT,
                "success": _FLAG,
                "score": _NUMBER,
                "met": {"type": "array", "items": _WHOLE},
                "note": _TEXT,
                "blind": _FLAG,
                "at": _TEXT,
                "cell": _TEXT,
            },
            optional=("cell",),
        ),
    ),
}
CAMERA = "/camera/"
# Viewers of MCAP files know this schema, and so show the pictures.
CAMERA_SCHEMA = (
    "foxglove.CompressedImage",
    _schema(
        {
            "timestamp": {
                "type": "object",
                "properties": {"sec": _WHOLE, "nsec": _WHOLE},
            },
            "frame_id": _TEXT,
            "data": {"type": "string", "contentEncoding": "base64"},
            "format": _TEXT,
        }
    ),
)
TOPIC_IDS = {topic: number for number, topic in enumerate(CHANNELS, 1)}

# --- MCAP ---

MAGIC = b"\x89MCAP0\r\n"
HEADER, FOOTER, SCHEMA, CHANNEL, MESSAGE, CHUNK = range(1, 7)
MESSAGE_INDEX, CHUNK_INDEX, STATISTICS, SUMMARY_OFFSET, DATA_END = 7, 8, 11, 14, 15
RECORD_HEAD = struct.Struct("<BQ")
# channel id, sequence, log time, publish time
MESSAGE_HEAD = struct.Struct("<HIQQ")
# The head of a record and the head of its message, packed in one call for speed.
WHOLE_HEAD = struct.Struct("<BQHIQQ")

encode_message = msgspec.json.Encoder().encode

DIGEST_CHARS = 32


def digest_state(state: bytes) -> str:
    """REC-111: equal for equal states; 128 bits of SHA-256, in hexadecimal."""
    return hashlib.sha256(state).hexdigest()[:DIGEST_CHARS]


def record(kind: int, content: bytes) -> bytes:
    return RECORD_HEAD.pack(kind, len(content)) + content


def checked_record(kind: int, channel: int, at_ns: int, data: bytes) -> bytes:
    """A message; its sequence number is the checksum of its data, for a cut part."""
    length, checksum = MESSAGE_HEAD.size + len(data), zlib.crc32(data)
    return WHOLE_HEAD.pack(kind, length, channel, checksum, at_ns, at_ns) + data


@lru_cache(maxsize=64)
def schema_record(topic: str, number: int) -> bytes:
    known = CHANNELS.get(topic) or FURTHER_CHANNELS.get(topic)
    name, schema = known or CAMERA_SCHEMA
    head = struct.pack("<H", number)
    return record(SCHEMA, head + text(name) + text("jsonschema") + _sized(schema))


@lru_cache(maxsize=64)
def channel_record(topic: str, number: int) -> bytes:
    """The record that declares a channel; its schema has the same number."""
    head = struct.pack("<HH", number, number)
    return record(CHANNEL, head + text(topic) + text("json") + _sized(b""))


def text(value: str) -> bytes:
    return _sized(value.encode())


def _sized(content: bytes) -> bytes:
    return struct.pack("<I", len(content)) + content
