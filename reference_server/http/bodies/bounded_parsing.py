"""Large bodies: refused at their first fault, before anything is built of them.

A wrong body of a few megabytes can hold millions of faults, and each costs hundreds of
bytes. So a body beyond `WHOLE_BYTES_MAX` is first read level by level, by the shape of
its message: names, kinds and numbers of entries. Below a level only those parts are
read that the message has. A body that passes is validated like any other (`codec`).

A shape permits more than its message does and never less. Must not know operations.
"""

from __future__ import annotations

import asyncio
import re
import sys
from collections.abc import Hashable, Iterable, Mapping
from dataclasses import dataclass
from functools import cache
from types import UnionType
from typing import Annotated, Any, Literal, Protocol, TypeAlias, Union, cast, get_args
from typing import get_origin as origin_of

import msgspec
from annotated_types import MaxLen
from pydantic import MISSING, BaseModel
from pydantic.fields import FieldInfo
from typing_extensions import TypeAliasType

from reference_server.generated.models import Predict
from reference_server.http import codec
from reference_server.http.bodies import repeated_members
from reference_server.http.bodies.usual_turns import read_usual_turn
from reference_server.http.codec import MSGPACK, Model, pointer
from reference_server.rules.refusal import Refused

# All faults of a body up to this size are found, at once: it costs milliseconds.
WHOLE_BYTES_MAX = 2**14
# Larger ones are read beside the event loop.
INLINE_BYTES_MAX = 2**18
# Where a schema allows more; no setting allows a longer chunk of actions.
ENTRIES_MAX = 4096
# Numbers and texts of one body; an action of a robot has dozens.
VALUES_MAX = 300_000
# JSON does not say how many entries follow. Before a list or map is read, each entry
# is credited with as many marks of its kind, which its own members may have, too.
MARKS_PER_ENTRY = 16
# Marks outside of strings are counted in parts of this size.
MARKS_READ_BYTES = 2**16

_FINITE = msgspec.Meta(ge=-sys.float_info.max, le=sys.float_info.max)
_SCALARS: Mapping[Any, tuple[Any, ...]] = {
    str: (str,),
    bool: (bool,),
    int: (int, float),  # 2.0 is an integer, too
    float: (int, Annotated[float, _FINITE]),
    type(None): (None,),
}
_PLACE = re.compile(r" - at `(?:key` in `)?\$(?P<path>[^`]*)`$")
_INDEX = re.compile(r"\[([0-9]+)\]")
_UNKNOWN = "Object contains unknown field `"
# Faults of the encoding, which msgspec reports where the value is used.
_MALFORMED = ("got `ext`", "Number out of range")

Path: TypeAlias = tuple[str | int, ...]


async def read_message(model: type[Model], body: bytes, media_type: str) -> Model:
    """The message in a body of any size. Raises Refused.

    A turn may be read into another structure with the same members.
    """
    if model is Predict and len(body) <= WHOLE_BYTES_MAX:
        turn = read_usual_turn(body, media_type)
        if turn is not None:
            return cast("Model", turn)
    if len(body) <= INLINE_BYTES_MAX:
        return codec.validate(model, read_structure(model, body, media_type))
    return await asyncio.to_thread(
        lambda: codec.validate(model, read_structure(model, body, media_type))
    )


def read_structure(
    model: type[BaseModel], body: bytes, media_type: str, *, closed: bool = True
) -> Any:
    """The decoded structure of a body, not yet validated (ENC-011). Raises Refused.

    closed: whether members that the model forbids are refused; else those of a large
    body are left out.
    """
    if len(body) <= WHOLE_BYTES_MAX:
        with codec.refuse_malformed(body, media_type):
            structure = codec.parse(body, media_type)
            if closed and media_type == MSGPACK:
                repeated_members.refuse_repeated_msgpack(body, structure)
            elif closed:
                repeated_members.refuse_repeated_json(body, structure)
        return structure
    with codec.refuse_malformed(body, media_type):
        reader = _Reader(media_type, closed=closed)
        try:
            structure = _shape_of(model, closed).read(body, reader, ())
            reader.check_members_of_all(body, structure)
        except Refused:
            reader.decode(body, type=msgspec.Raw)  # ERR-006: a malformed body is that
            raise
    if media_type != MSGPACK and codec.has_unusual_integers(body) and closed:
        return codec.decode(body, media_type)
    return structure


class _Reader:
    """Reads parts of one body, and counts its values.

    closed: whether members that stand twice are refused.
    """

    def __init__(self, media_type: str, *, closed: bool) -> None:
        self.is_json = media_type != MSGPACK
        self._closed = closed
        self.is_read_whole = True  # so that the members of the structure are all
        self._null = b"null" if self.is_json else b"\xc0"
        self.decode = msgspec.json.decode if self.is_json else msgspec.msgpack.decode
        self._values_left = VALUES_MAX

    def read(self, raw: Any, kind: Any, at: Path) -> Any:
        """The part as its kind; at: its path. Raises Refused."""
        try:
            return self.decode(raw, type=kind)
        except msgspec.ValidationError as error:
            raise _refusal(str(error), at) from error

    def spend(self, values: int) -> None:
        self._values_left -= values
        if self._values_left < 0:
            raise _invalid((), f"must have at most {VALUES_MAX} values")

    def read_member(self, shape: _Shape, raw: Any, at: Path) -> Any:
        """The value of a member; its model decides on null, which may be absence."""
        if bytes(raw) == self._null:
            self.spend(1)
            return None
        return shape.read(raw, self, at)

    def check_members(self, raw: Any, count: int) -> None:
        """ENC-014: a map has no more members than were read; raises ValueError."""
        if self._closed and not self.is_json:
            repeated_members.check_length(raw, count)

    def check_members_of_all(self, body: bytes, structure: Any) -> None:
        """ENC-013: each member has a colon outside of texts; raises ValueError."""
        if self._closed and self.is_json and self.is_read_whole:
            members = repeated_members.count_members(structure)
            if _has_more_outside_strings(body, b":", members):
                raise ValueError("a member stands twice in an object")

    def check_marks(self, raw: Any, mark: bytes, most: int, at: Path) -> None:
        """MessagePack says how many entries follow: msgspec compares that itself."""
        if not self.is_json:
            return
        text = bytes(raw)
        if text.count(mark) > most and _has_more_outside_strings(text, mark, most):
            raise _invalid(at, "has too many entries")


def _has_more_outside_strings(text: bytes, mark: bytes, most: int) -> bool:
    """Whether a JSON text has a mark more than `most` times outside of its strings.

    Part by part, so that memory is bounded and other threads run.
    """
    quoted = text.replace(rb"\\", b"").replace(rb"\"", b"")
    count, is_in_string = 0, False
    for start in range(0, len(quoted), MARKS_READ_BYTES):
        pieces = quoted[start : start + MARKS_READ_BYTES].split(b'"')
        count += b"".join(pieces[is_in_string::2]).count(mark)
        if count > most:
            return True
        is_in_string ^= len(pieces) % 2 == 0
    return False


class _Shape(Protocol):
    """The values that are permitted at one place of a message."""

    def read(self, raw: Any, reader: _Reader, at: Path) -> Any:
        """The plain structure of that place; at: its path. Raises Refused."""


@dataclass(frozen=True, slots=True)
class _Scalar:
    kind: Any

    def read(self, raw: Any, reader: _Reader, at: Path) -> Any:
        reader.spend(1)
        return reader.read(raw, self.kind, at)


class _Text:
    """Anything; only text is kept, and null stands for what is none."""

    def read(self, raw: Any, reader: _Reader, at: Path) -> Any:
        reader.spend(1)
        try:
            return reader.read(raw, str, at)
        except Refused:
            reader.is_read_whole = False
            return None


@dataclass(frozen=True, slots=True)
class _ScalarList:
    items: Any
    most: int

    def read(self, raw: Any, reader: _Reader, at: Path) -> Any:
        reader.check_marks(raw, b",", self.most, at)
        kind = Annotated[list[self.items], msgspec.Meta(max_length=self.most)]  # type: ignore[name-defined]
        scalars = reader.read(raw, kind, at)
        reader.spend(len(scalars))
        return scalars


@dataclass(frozen=True, slots=True)
class _Object:
    """kind: a structure whose members are not read yet.

    is_closed: whether it is refused for a member that it does not know.
    """

    kind: Any
    members: Mapping[str, _Shape]
    is_closed: bool

    def read(self, raw: Any, reader: _Reader, at: Path) -> Any:
        members = self.read_members(reader.read(raw, self.kind, at), reader, at)
        if self.is_closed:
            reader.check_members(raw, len(members))
        return members

    def read_members(self, structure: Any, reader: _Reader, at: Path) -> Any:
        reader.spend(1)
        reader.is_read_whole &= self.is_closed
        return {
            name: reader.read_member(shape, getattr(structure, name), (*at, name))
            for name, shape in self.members.items()
            if getattr(structure, name) is not msgspec.UNSET
        }


@dataclass(frozen=True, slots=True)
class _ObjectList:
    items: _Object
    most: int

    def read(self, raw: Any, reader: _Reader, at: Path) -> Any:
        reader.check_marks(raw, b"{", MARKS_PER_ENTRY * self.most, at)
        if not reader.is_json:  # each map is looked at
            raws = Annotated[list[msgspec.Raw], msgspec.Meta(max_length=self.most)]
            return [
                self.items.read(item, reader, (*at, index))
                for index, item in enumerate(reader.read(raw, raws, at))
            ]
        kind = Annotated[list[self.items.kind], msgspec.Meta(max_length=self.most)]  # type: ignore[name-defined]
        return [
            self.items.read_members(item, reader, (*at, index))
            for index, item in enumerate(reader.read(raw, kind, at))
        ]


@dataclass(frozen=True, slots=True)
class _Map:
    """Names that the sender chooses."""

    values: _Shape
    most: int

    def read(self, raw: Any, reader: _Reader, at: Path) -> Any:
        reader.check_marks(raw, b":", MARKS_PER_ENTRY * self.most, at)
        kind = Annotated[dict[str, msgspec.Raw], msgspec.Meta(max_length=self.most)]
        members = reader.read(raw, kind, at)
        reader.check_members(raw, len(members))
        return {
            name: self.values.read(value, reader, (*at, name))
            for name, value in members.items()
        }


@cache
def _shape_of(annotation: Hashable, closed: bool, most: int = ENTRIES_MAX) -> _Shape:
    """The shape of a model, or of the type of one of its members."""
    kind, most = _plain(annotation, most)
    origin, parts = origin_of(kind), get_args(kind)
    if _is_model(kind):
        return _object(kind, closed)
    if origin is dict:
        return _Map(_shape_of(parts[1], closed), most)
    if origin is list and _is_model(parts[0]):
        return _ObjectList(_object(parts[0], closed), most)
    if origin is list:
        return _ScalarList(_scalar(parts[0]), most)
    if kind is Any:
        return _Text()
    return _Scalar(_scalar(kind))


def _plain(annotation: Any, most: int) -> tuple[Any, int]:
    """A type without names, metadata and MISSING, and its most entries."""
    origin, parts = origin_of(annotation), get_args(annotation)
    if isinstance(annotation, TypeAliasType):
        return _plain(annotation.__value__, most)
    if origin is Annotated:
        return _plain(parts[0], _most(parts[1:], most))
    if origin in (Union, UnionType):
        present = [part for part in parts if part is not MISSING]
        if len(present) == 1:
            return _plain(present[0], most)
    return annotation, most


def _object(model: type[BaseModel], closed: bool) -> _Object:
    model.model_rebuild()  # resolves names of models that follow it in their module
    fields = model.model_fields
    is_closed = closed and model.model_config.get("extra") == "forbid"
    kind = msgspec.defstruct(
        model.__name__,
        [
            (name, Union[msgspec.Raw, msgspec.UnsetType], msgspec.UNSET)  # noqa: UP007
            for name in fields
        ],
        forbid_unknown_fields=is_closed,
    )
    members: dict[str, _Shape] = {}
    for name, field in fields.items():
        annotation: Any = field.annotation
        members[name] = _shape_of(
            annotation, closed, _most(field.metadata, ENTRIES_MAX)
        )
    return _Object(kind, members, is_closed)


def _is_model(kind: Any) -> bool:
    return isinstance(kind, type) and issubclass(kind, BaseModel)


def _scalar(annotation: Any) -> Any:
    """The scalar types of an annotation, as msgspec names them."""
    return Union[tuple(dict.fromkeys(_scalars(annotation)))]  # noqa: UP007


def _scalars(annotation: Any) -> Iterable[Any]:
    kind, _ = _plain(annotation, ENTRIES_MAX)
    if origin_of(kind) is Literal:
        return [scalar for part in get_args(kind) for scalar in _SCALARS[type(part)]]
    if origin_of(kind) in (Union, UnionType):
        return [scalar for part in get_args(kind) for scalar in _scalars(part)]
    return _SCALARS[kind]


def _most(metadata: Iterable[Any], otherwise: int) -> int:
    for constraint in metadata:
        if isinstance(constraint, MaxLen):
            return min(constraint.max_length, ENTRIES_MAX)
        if isinstance(constraint, FieldInfo):
            return _most(constraint.metadata, otherwise)
    return otherwise


def _refusal(text: str, at: Path) -> Refused:
    """The refusal that an error of msgspec stands for."""
    place = _PLACE.search(text)
    path = (*at, *_indices(place["path"] if place else ""))
    what = text[: place.start()] if place else text
    if what.startswith(_UNKNOWN):
        name = what.removeprefix(_UNKNOWN).removesuffix("`")
        return _invalid((*path, name), "the schema has no such member")
    if any(fault in what for fault in _MALFORMED):
        return Refused("malformed_body", f"The body is malformed: {what}.")
    return _invalid(path, what)


def _indices(path: str) -> Iterable[int]:
    return map(int, _INDEX.findall(path))


def _invalid(at: Iterable[str | int], text: str) -> Refused:
    return Refused(
        "invalid_request",
        "The body does not match its schema; of a large body one fault is reported.",
        errors=[(pointer(at), text)],
    )
