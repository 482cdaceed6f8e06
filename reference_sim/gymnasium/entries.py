"""Converts an environment's nested spaces to the protocol's flat ones.

An entry is one leaf of a space, with its dotted name. Actions are vectors of floats; an
observation's entry is a vector of the state, an image or a tensor, by its shape and
dtype. This file knows arrays and neither Gymnasium nor files.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from reference_sim.definition import Json
from reference_sim.vector_spaces import VectorPart, unspecified_part, vector

# Where the leaves are: an entry's name, or what holds more of them.
Structure: TypeAlias = "str | dict[str, Structure] | tuple[Structure, ...]"
Array: TypeAlias = NDArray[Any]

IMAGE_SIDE_MIN = 8  # pixels; what is smaller is a table of numbers
TENSOR_DTYPES = frozenset(
    (
        *("bool", "int8", "int16", "int32", "int64"),
        *("uint8", "uint16", "uint32", "uint64"),
        *("float16", "float32", "float64"),
    )
)


class UnsupportedSpace(ValueError):
    """The protocol cannot represent this space; the text says why, in one line."""


@dataclass(frozen=True, slots=True, eq=False)
class Entry:
    """One leaf of a space.

    name: dotted path of its keys; that of the whole space where there are none.
    text: how the environment prints it.
    low, high: bounds per element, of `shape`, float64; infinite where there are none.
    whole: the elements are whole numbers that name choices.
    as_tensor: sent as a tensor, although its shape is that of an image.
    """

    name: str
    text: str
    shape: tuple[int, ...]
    dtype: np.dtype[Any]
    low: Array
    high: Array
    whole: bool = False
    as_tensor: bool = False

    @property
    def size(self) -> int:
        return int(np.prod(self.shape, dtype=np.int64))

    @property
    def kind(self) -> str:
        """Its group in an observation: `state`, `images` or `tensors`."""
        if self._is_image() and not self.as_tensor:
            return "images"
        if len(self.shape) <= 1:
            return "state"
        return "tensors"

    def _is_image(self) -> bool:
        planes = self.shape[2:] in ((), (1,), (3,), (4,)) and len(self.shape) >= 2
        if not planes or self.dtype != np.uint8 or min(self.shape[:2]) < IMAGE_SIDE_MIN:
            return False
        return bool((self.low == 0).all() and (self.high == 255).all())

    @property
    def channels(self) -> int:
        return self.shape[2] if len(self.shape) == 3 else 1

    def bounds(self) -> Json:
        """`minimum` and `maximum`, if any element has one.

        JSON has no infinity: if other elements are bounded, the largest float is used.
        """
        if np.isinf(self.low).all() and np.isinf(self.high).all():
            return {}
        most = float(np.finfo(np.float64).max)
        return {
            "minimum": np.clip(self.low, -most, most).ravel().tolist(),
            "maximum": np.clip(self.high, -most, most).ravel().tolist(),
        }


# Actions


def action_space(entries: Sequence[Entry]) -> Json:
    """Name → VectorSpace."""
    return {entry.name: _action_vector(entry) for entry in entries}


def _action_vector(entry: Entry) -> Json:
    if entry.size == 0:
        raise UnsupportedSpace(f"the action {entry.name!r} is empty ({entry.text})")
    bounds = entry.bounds()
    if entry.whole:
        rule, text = "refuse", _choices(entry)
        part = VectorPart("all", entry.size, "choice", "1")
    else:
        part = unspecified_part(entry.size)
        rule = "clip" if bounds else "unbounded"
        text = f"{entry.text}{_in_c_order(entry)}. Given as {entry.dtype}."
    return vector(part, description=text, **bounds, out_of_range=rule)


def _choices(entry: Entry) -> str:
    low, high = entry.low.ravel(), entry.high.ravel()
    each = "the whole number" if entry.size == 1 else "one whole number each"
    if (low == low[0]).all() and (high == high[0]).all():
        among = f" from {low[0]:.0f} to {high[0]:.0f}"
    else:
        among = " within the bounds"
    return (
        f"{entry.text}{_in_c_order(entry)}: {each} of a choice{among}. "
        "Anything between two choices is rounded to the nearest."
    )


def _in_c_order(entry: Entry) -> str:
    return " in C order" if len(entry.shape) > 1 else ""


def to_environment(entry: Entry, numbers: Sequence[float]) -> Any:
    """A vector of the protocol as the environment's own value, within its bounds."""
    flat = np.asarray(numbers, dtype=np.float64)
    if entry.whole:
        flat = np.rint(flat)
    flat = np.clip(flat, entry.low.ravel(), entry.high.ravel())
    if entry.dtype.kind == "f":
        # An unbounded float32 must not become infinite by the conversion.
        most = float(np.finfo(entry.dtype).max)
        flat = np.clip(flat, -most, most)
    shaped = flat.astype(entry.dtype).reshape(entry.shape)
    return shaped[()] if entry.whole and entry.shape == () else shaped


def assemble(structure: Structure, values: Mapping[str, Any]) -> Any:
    """Values by name, nested as the space is."""
    if isinstance(structure, str):
        return values[structure]
    if isinstance(structure, dict):
        return {key: assemble(part, values) for key, part in structure.items()}
    return tuple(assemble(part, values) for part in structure)


# Observations


def observation_space(entries: Sequence[Entry]) -> Json:
    """The ObservationSpace, without what cameras add."""
    space: Json = {"state": {}, "images": {}, "tensors": {}}
    for entry in entries:
        if entry.size:
            space[entry.kind][entry.name] = _observed(entry)
    return space


def _observed(entry: Entry) -> Json:
    if entry.kind == "state":
        text = f"{entry.text}, as the environment declares it"
        return vector(unspecified_part(entry.size), description=text, **entry.bounds())
    if entry.kind == "images":
        colours = {1: "grey", 3: "RGB", 4: "RGBA"}[entry.channels]
        return {"channels": entry.channels, "description": f"{entry.text}, {colours}"}
    if entry.dtype.name not in TENSOR_DTYPES:
        raise UnsupportedSpace(f"{entry.name!r} holds {entry.dtype} ({entry.text})")
    shape = list(entry.shape)
    return {"dtype": entry.dtype.name, "shape": shape, "description": entry.text}


def take(structure: Structure, observation: Any) -> dict[str, Any]:
    """The leaves of an observation by name. Raises ValueError where it is shaped
    otherwise than its space."""
    if isinstance(structure, str):
        return {structure: observation}
    arrays: dict[str, Any] = {}
    if isinstance(structure, dict):
        if not isinstance(observation, Mapping) or structure.keys() - observation:
            raise ValueError(f"the observation lacks some of {', '.join(structure)}")
        for key, part in structure.items():
            arrays |= take(part, observation[key])
        return arrays
    if not isinstance(observation, Sequence) or len(observation) != len(structure):
        raise ValueError(f"the observation has not its {len(structure)} parts")
    for part, value in zip(structure, observation, strict=True):
        arrays |= take(part, value)
    return arrays


def as_array(entry: Entry, value: Any) -> Array:
    """A leaf as its space declares it. Raises ValueError if it is not of that shape, or
    holds a number that no encoding can carry."""
    array = np.asarray(value)
    if array.shape != entry.shape:
        raise ValueError(
            f"the observation {entry.name!r} has shape {array.shape}, "
            f"its space {entry.shape}"
        )
    if entry.kind == "state":
        array = array.astype(np.float64).reshape(-1)
        if not np.isfinite(array).all():
            raise ValueError(f"the observation {entry.name!r} is not finite: {array}")
        return array
    array = np.ascontiguousarray(array, dtype=entry.dtype)
    return array.reshape(*entry.shape, 1) if _is_flat_image(entry) else array


def _is_flat_image(entry: Entry) -> bool:
    return entry.kind == "images" and len(entry.shape) == 2


# Several tasks


def joined(first: Sequence[Entry], second: Sequence[Entry]) -> list[Entry]:
    """The combined entries of two tasks' observations, with the wider bounds.

    Raises UnsupportedSpace if they differ in more than bounds.
    """
    if list(map(_form, first)) != list(map(_form, second)):
        raise UnsupportedSpace("its space differs from that of the first task")
    return [
        replace(a, low=np.minimum(a.low, b.low), high=np.maximum(a.high, b.high))
        for a, b in zip(first, second, strict=True)
    ]


def same(first: Sequence[Entry], second: Sequence[Entry]) -> bool:
    """Whether two spaces agree in everything."""
    return list(map(_form, first)) == list(map(_form, second)) and all(
        np.array_equal(a.low, b.low) and np.array_equal(a.high, b.high)
        for a, b in zip(first, second, strict=True)
    )


def _form(entry: Entry) -> tuple[Any, ...]:
    return entry.name, entry.shape, entry.dtype, entry.whole
