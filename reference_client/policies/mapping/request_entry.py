"""One key of a policy's request: the source of its value, and how that is converted."""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Mapping
from typing import Annotated, Any, Literal

import msgspec
import numpy as np
from msgspec import Meta

from reference_client.api.observation import Observation
from reference_client.policies.image_resize import compress_picture, resize_picture
from reference_client.policies.mapping.members import (
    Array,
    BadMapping,
    Columns,
    Dimensions,
    Factors,
    Flag,
    PictureSize,
    SizeMismatch,
    Text,
    check_factors,
    indices_of,
    read_members,
    width_of_columns,
    wrong_member,
)
from reference_client.policies.servers.wire_formats import pack


def _attempt_id(observation: Observation) -> str:
    """Differs in every attempt of every run, for servers that store by such an id."""
    turn = observation.turn
    if turn is None or not turn.episode:
        return f"dry-{observation.episode_id}"
    # The id of a session is for its server alone.
    session = hashlib.sha256(turn.session_id.encode()).hexdigest()[:16]
    return f"{session}-{observation.episode_id}-{turn.episode.attempt}"


WORDS: Mapping[str, Callable[[Observation], Any]] = {
    "instruction": lambda observation: observation.instruction,
    "episode_id": lambda observation: observation.episode_id,
    "step": lambda observation: observation.step,
    "first_step": lambda observation: observation.step == 0,
    "attempt_id": _attempt_id,
}
_FILES = ("jpeg", "png")
# Kind of source → the members that it reads beside `from` and `encode`.
_READ_BY: Mapping[str, frozenset[str]] = {
    **dict.fromkeys(WORDS, frozenset({"leading"})),
    "step": frozenset({"leading", "scale", "offset"}),
    "state": frozenset({"leading", "take", "scale", "offset", "dtype"}),
    "images": frozenset({"leading", "resize", "pad", "layout", "unit", "dtype"}),
    "tensors": frozenset({"leading", "dtype"}),
}
GROUPS = ("state", "images", "tensors")
_JPEG_CHANNELS = (1, 3)


class RequestEntry(msgspec.Struct, frozen=True):
    """One key of the request, in the order of conversion.

    source: `state.NAME`, `images.NAME`, `tensors.NAME`, or a key of WORDS; several
    states are concatenated. Then: take, scale, offset for vectors; resize, layout, unit
    for images; dtype, leading for both; encode: JSON text for any, a file in memory for
    images.
    """

    source: Annotated[
        tuple[str, ...],
        Meta(
            description=f"state.NAME or a list of such, images.NAME, tensors.NAME, "
            f"{', '.join(WORDS)}"
        ),
    ] = msgspec.field(default=(), name="from")
    value: Any = None
    take: Columns | None = None
    scale: Factors = 1.0
    offset: Factors = 0.0
    dtype: Text | None = None
    resize: PictureSize | None = None
    pad: Flag = True
    layout: Annotated[Literal["hwc", "chw"], Meta(description='"hwc" or "chw"')] = "hwc"
    unit: Flag = False
    leading: Dimensions = 0
    encode: Annotated[
        Literal["json", "json-numpy", "jpeg", "png"] | None,
        Meta(description='"json", "json-numpy", "jpeg" or "png"'),
    ] = None

    def width(self, joined: int) -> int:
        """How many numbers are left of the states, joined. Raises SizeMismatch."""
        width = joined
        if self.take is not None:
            width = width_of_columns("take", self.take, joined)
        check_factors("scale", self.scale, width)
        check_factors("offset", self.offset, width)
        return width

    def check_channels(self, channels: int) -> None:
        """channels: of the image. Raises SizeMismatch."""
        if self.encode == "jpeg" and channels not in _JPEG_CHANNELS:
            raise SizeMismatch(
                f"encode jpeg is for 1 or 3 channels; the image has {channels}"
            )

    def of(self, observation: Observation) -> Any:
        """The value of the key. Raises SizeMismatch."""
        value = self._value(observation)
        if self.encode is None:
            return value
        if self.encode in _FILES:
            return compress_picture(value, self.encode)
        return pack(value, self.encode).decode()

    def _value(self, observation: Observation) -> Any:
        if not self.source:
            return self.value
        if self.source[0] in WORDS:
            word = WORDS[self.source[0]](observation)
            if self.source[0] == "step":
                number = float(word * np.asarray(self.scale) + np.asarray(self.offset))
                word = int(number) if number.is_integer() else number
            return [word] if self.leading else word
        array = (
            self._picture(observation)
            if group_of(self.source[0]) == "images"
            else self._vector(observation)
        )
        if self.dtype is not None:
            array = array.astype(self.dtype)
        return array.reshape((1,) * self.leading + array.shape)

    def _picture(self, observation: Observation) -> Array:
        picture: Array = part_of(observation, self.source[0])
        self.check_channels(picture.shape[-1])
        if self.resize is not None:
            picture = resize_picture(picture, *self.resize, pad=self.pad)
        if self.unit:
            picture = picture.astype(np.float32) / np.float32(255)
        return np.moveaxis(picture, -1, 0) if self.layout == "chw" else picture

    def _vector(self, observation: Observation) -> Array:
        parts = [part_of(observation, name) for name in self.source]
        vector = parts[0] if len(parts) == 1 else np.concatenate(parts)
        if self.source[0].startswith("tensors."):
            return vector
        self.width(len(vector))
        if self.take is not None:
            vector = vector[list(indices_of(self.take))]
        scaled: Array = vector * np.asarray(self.scale) + np.asarray(self.offset)
        return scaled.astype(np.float32) if self.dtype is None else scaled


def part_of(observation: Observation, source: str) -> Array:
    """The array of `state.NAME` and such."""
    group, _, name = source.partition(".")
    return np.asarray(getattr(observation, group)[name])


def group_of(source: str) -> str:
    """`state`, `images` or `tensors`; a word as it is."""
    return source if source in WORDS else source.partition(".")[0]


def read_entry(at: str, table: Any) -> RequestEntry:
    """The entry of a table of the file. Raises BadMapping."""
    entry = read_members(RequestEntry, at, table)
    if bool(entry.source) == (entry.value is not None):
        raise BadMapping(f"{at} needs either `from` or `value`")
    for source in entry.source:
        if source not in WORDS and group_of(source) not in GROUPS:
            raise wrong_member(RequestEntry, at, "from", source)
    if len(entry.source) > 1 and not all(s.startswith("state.") for s in entry.source):
        raise BadMapping(f"{at}: only states can be joined")
    _refuse_unread(at, entry, table)
    if entry.take is not None and not indices_of(entry.take):
        raise wrong_member(RequestEntry, at, "take", table["take"])
    if entry.source == ("step",):
        for member in ("scale", "offset"):
            if isinstance(getattr(entry, member), tuple):
                raise BadMapping(f"{at}: {member} of step is one finite number")
    _check_dtype(at, entry)
    if entry.encode in _FILES and not _is_plain_picture(entry):
        raise BadMapping(f"{at}: encode {entry.encode} is for images alone, as uint8")
    return entry


def _refuse_unread(at: str, entry: RequestEntry, table: Mapping[str, Any]) -> None:
    """A member that changes nothing is a mistake about the rest of the entry."""
    kind = group_of(entry.source[0]) if entry.source else "value"
    read = _READ_BY.get(kind, frozenset()) | {"from", "value", "encode"}
    if unread := sorted(set(table) - read):
        due = ", ".join(sorted(read - {"from", "value"}))
        what = f"from {entry.source[0]}" if entry.source else "with `value`"
        raise BadMapping(
            f"{at}: {unread[0]} is not for an entry {what}, which may have {due}"
        )


def _check_dtype(at: str, entry: RequestEntry) -> None:
    if entry.dtype is None:
        return
    kind = _kind_of_numbers(entry.dtype)
    if kind not in "biuf":
        raise BadMapping(
            f"{at}: numpy has no numbers of dtype {entry.dtype}; float32, float16, "
            "int64 and uint8 are some that it has"
        )
    if entry.unit and kind != "f":
        raise BadMapping(
            f"{at}: unit makes numbers from 0 to 1, of which dtype {entry.dtype} "
            "leaves 0 and 1 alone; it takes a dtype of floats"
        )


def _kind_of_numbers(dtype: str) -> str:
    """The kind of a dtype as numpy has it; V for none."""
    try:
        return np.dtype(dtype).kind
    except (TypeError, ValueError, SyntaxError):
        return "V"


def _is_plain_picture(entry: RequestEntry) -> bool:
    return (
        bool(entry.source)
        and group_of(entry.source[0]) == "images"
        and entry.dtype in (None, "uint8")
        and not (entry.unit or entry.leading)
        and entry.layout == "hwc"
    )
