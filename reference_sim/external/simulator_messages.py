"""The messages of spec/simulator.md, and their frames."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from struct import Struct
from typing import Any, TypeVar

import msgspec

PROTOCOL = 1
LENGTH = Struct(">I")
REPLY_BYTES_MAX = 16 << 20
OBSERVATION_EXTRA_BYTES = 1 << 20


def _call_of(class_name: str) -> str:
    return class_name.removesuffix("Call").lower()


class _Request(msgspec.Struct, tag_field="call", tag=_call_of):
    """A request; its call is its class's name without `Call`."""


class DescribeCall(_Request):
    protocols: Sequence[int] = (PROTOCOL,)


class ResetCall(_Request):
    task: str
    seed: int
    split: str


class StepCall(_Request):
    action: Mapping[str, Sequence[float]]


class OfferedMemory(msgspec.Struct):
    """Memory for the pixels; offsets: the place of each image."""

    number: int
    path: str
    size: int
    offsets: Mapping[str, int]


class ObserveCall(_Request, omit_defaults=True):
    images: Sequence[str]
    tensors: Sequence[str]
    width: int
    height: int
    memory: OfferedMemory | None = None


class DigestCall(_Request):
    pass


class CloseCall(_Request):
    pass


class Described(msgspec.Struct):
    protocol: int
    benchmark: dict[str, Any]


class EpisodeBegun(msgspec.Struct):
    instruction: str
    state: dict[str, list[float]]
    stages: list[str] = []


class StepDone(msgspec.Struct):
    state: dict[str, list[float]]
    success: bool
    terminated: bool = False
    reward: float = 0.0
    score: float | None = None


class Pixels(msgspec.Struct):
    """data: None where the pixels are in the offered memory."""

    shape: tuple[int, int, int]
    data: memoryview | None = None


class TensorValue(msgspec.Struct):
    dtype: str
    shape: list[int]
    data: memoryview


class Observed(msgspec.Struct):
    images: dict[str, Pixels] = {}
    tensors: dict[str, TensorValue] = {}


class Digested(msgspec.Struct):
    digest: bytes


class Closed(msgspec.Struct):
    pass


class FaultReply(msgspec.Struct):
    fault: str
    unplayable: bool = False


ReplyT = TypeVar("ReplyT", bound=msgspec.Struct)
Request = DescribeCall | ResetCall | StepCall | ObserveCall | DigestCall | CloseCall

_encoder = msgspec.msgpack.Encoder()
_DECODERS: dict[type[msgspec.Struct], msgspec.msgpack.Decoder[Any]] = {
    kind: msgspec.msgpack.Decoder(kind)
    for kind in (Described, EpisodeBegun, StepDone, Observed, Digested, Closed)
}
_fault_decoder = msgspec.msgpack.Decoder(FaultReply)


def frame(request: Request) -> bytearray:
    """The request with its length in front of it."""
    buffer = bytearray(LENGTH.size)
    _encoder.encode_into(request, buffer, LENGTH.size)
    LENGTH.pack_into(buffer, 0, len(buffer) - LENGTH.size)
    return buffer


def read_reply(body: bytes | memoryview, wanted: type[ReplyT]) -> ReplyT | FaultReply:
    """Raises msgspec.DecodeError, also for a reply that lacks a member."""
    try:
        reply: ReplyT = _DECODERS[wanted].decode(body)
    except msgspec.ValidationError:
        try:
            return _fault_decoder.decode(body)
        except msgspec.ValidationError:
            pass
        raise
    return reply
