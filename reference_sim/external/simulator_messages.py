"""The messages of spec/simulator.md."""

from __future__ import annotations

import re
import reprlib
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from typing import Any, TypeVar

import msgspec

from reference_record.command_line.spelling import ignored_member
from reference_sim.vector_spaces import is_extension

PROTOCOL = 1
REPLY_BYTES_MAX = 16 << 20
OBSERVATION_EXTRA_BYTES = 1 << 20


def _call_of(class_name: str) -> str:
    return class_name.removesuffix("Call").lower()


class _Request(msgspec.Struct, tag_field="call", tag=_call_of, kw_only=True):
    """A request; its call is its class's name without `Call`. number: from 1 on."""

    number: int = 0


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


class StopCall(_Request):
    """Sent at any time to a robot, and not answered; its number is 0."""


class AliveCall(_Request):
    """As StopCall: the server still waits for the reply to a request."""


class Reply(msgspec.Struct, kw_only=True):
    """A reply. number: that of its request (SIM-025). fault: what is wrong; a reply
    that is a fault needs no other member."""

    number: int | None = None
    fault: str | None = None
    unplayable: bool = False


class Described(Reply):
    protocol: int
    benchmark: dict[str, Any]


class EpisodeBegun(Reply):
    instruction: str
    state: dict[str, list[float]]
    stages: list[str] = []


class StepDone(Reply):
    state: dict[str, list[float]]
    success: bool
    terminated: bool = False
    reward: float = 0.0
    score: float | None = None
    stopped: str = ""


class Pixels(msgspec.Struct):
    """data: None where the pixels are in the offered memory."""

    shape: tuple[int, int, int]
    data: memoryview | None = None


class TensorValue(msgspec.Struct):
    dtype: str
    shape: list[int]
    data: memoryview


class Observed(Reply):
    images: dict[str, Pixels] = {}
    tensors: dict[str, TensorValue] = {}


class Digested(Reply):
    digest: bytes


class Closed(Reply):
    pass


ReplyT = TypeVar("ReplyT", bound=Reply)
Request = DescribeCall | ResetCall | StepCall | ObserveCall | DigestCall | CloseCall
Signal = StopCall | AliveCall

_DECODERS: dict[type[Reply], msgspec.msgpack.Decoder[Any]] = {
    kind: msgspec.msgpack.Decoder(kind)
    for kind in (Described, EpisodeBegun, StepDone, Observed, Digested, Closed)
}
_any_decoder = msgspec.msgpack.Decoder(Reply)


class WrongNumber(ValueError):
    """The reply is that of another request; the text has both numbers."""


class ReportedFault(Exception):
    """The reply is a fault; the text is that of the program."""

    def __init__(self, reply: Reply) -> None:
        super().__init__(reply.fault)
        self.is_unplayable = reply.unplayable


def read_reply(body: bytes | memoryview, wanted: type[ReplyT], number: int) -> ReplyT:
    """The reply to the request with this number.

    Raises WrongNumber, ReportedFault, and msgspec.DecodeError if it lacks a member.
    """
    try:
        reply: ReplyT = _DECODERS[wanted].decode(body)
    except UnicodeDecodeError as error:
        text = f"{_place_of_bytes(body)} is not UTF-8: {error.object[error.start]:#04x}"
        raise msgspec.DecodeError(f"{text} at byte {error.start}") from None
    except msgspec.ValidationError as error:
        _require_answer(_any_decoder.decode(body), number)
        raise msgspec.ValidationError(
            f"{error}{_value_at_fault(body, error)}"
        ) from None
    _require_answer(reply, number)
    return reply


def unknown_members(body: bytes, wanted: type[Reply]) -> Iterator[str]:
    """Each member of a reply that is ignored, and which was probably meant."""
    known = [f for f in wanted.__struct_fields__ if f not in Reply.__struct_fields__]
    members = msgspec.msgpack.decode(body, type=dict[str, msgspec.Raw]) if body else {}
    for name in members:
        if name not in wanted.__struct_fields__ and not is_extension(name):
            yield ignored_member(name, known)


def _value_at_fault(body: bytes | memoryview, error: msgspec.ValidationError) -> str:
    """The value of the member of a reply that has a wrong type (SIM-004)."""
    if (path := re.search(r"`\$\.(\w+)`$", str(error))) is None:
        return ""
    return f": {reprlib.repr(msgspec.msgpack.decode(body)[path[1]])}"


def _place_of_bytes(body: bytes | memoryview) -> str:
    """The path of the member of a reply whose text cannot be decoded."""
    path, is_deeper = "$", True
    while is_deeper:
        is_deeper = False
        for step, value in _parts_of(body):
            try:
                msgspec.msgpack.decode(value)
            except UnicodeDecodeError:
                path, body, is_deeper = f"{path}{step}", value, True
                break
    return f"`{path}`"


def _parts_of(body: bytes | memoryview) -> Iterator[tuple[str, msgspec.Raw]]:
    """The members of a map or the items of a list; none of a value, or of names that
    cannot be decoded either."""
    with suppress(UnicodeDecodeError, msgspec.ValidationError):
        members = msgspec.msgpack.decode(body, type=dict[str, msgspec.Raw])
        yield from ((f".{name}", value) for name, value in members.items())
    with suppress(msgspec.ValidationError):
        items = msgspec.msgpack.decode(body, type=list[msgspec.Raw])
        yield from ((f"[{index}]", value) for index, value in enumerate(items))


def _require_answer(reply: Reply, number: int) -> None:
    if reply.number != number:
        raise WrongNumber(f"{reply.number} instead of {number}")
    if reply.fault is not None:
        raise ReportedFault(reply)
