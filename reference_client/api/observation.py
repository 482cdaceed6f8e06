"""Observation: state vectors, images and tensors, decoded from the answer to a turn.

All are numpy arrays. Raw images and tensors are views of the received bytes: nothing is
copied.
"""

from __future__ import annotations

import io
from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field, replace
from functools import lru_cache
from math import prod
from typing import Any, TypeVar

import msgspec
import numpy as np
import numpy.typing as npt

from reference_client.errors import BAD_ANSWER, ProctorError
from reference_client.generated.messages import Image, Tensor, Turn
from reference_client.generated.messages import Observation as WireObservation
from reference_record.command_line.spelling import did_you_mean
from reference_record.this_machine import usable_processors

Value = TypeVar("Value")

# Types that numpy has; a tensor of another, from a later protocol, is left out.
DTYPES = {
    *("bool", "int8", "int16", "int32", "int64", "uint8", "uint16", "uint32", "uint64"),
    *("float16", "float32", "float64"),
}
# channels → the mode of pillow, and the colour space of simplejpeg
_PNG_MODES = {1: "L", 2: "LA", 3: "RGB", 4: "RGBA"}
_JPEG_COLOURS = {1: "GRAY", 3: "RGB", 4: "RGBA"}
_PIXELS_MAX = 2**26  # a small file may declare any size; pillow has its own limit


class Named(dict[str, Value]):
    """A part of an observation; a KeyError names what it has."""

    def __init__(self, part: str, values: Mapping[str, Value]) -> None:
        super().__init__(values)
        self._part = part

    def __missing__(self, name: str) -> Value:
        has = ", ".join(self) or "nothing"
        meant = did_you_mean(str(name), self)
        raise KeyError(f"{name}: observation.{self._part} has {has}{meant}")


@dataclass(frozen=True, slots=True, eq=False)
class Observation:
    """One observation, in the units and frames of the benchmark's spaces.

    state: name → float64 of shape (size,); read-only.
    images: name → uint8 of shape (height, width, channels), row 0 on top; read-only.
    tensors: name → array of the dtype and shape that the benchmark declares; read-only.
    instruction: the task of this episode, in natural language.
    episode_id: opaque id of the episode.
    step: actions executed in this attempt so far; 0 in an episode's first observation.
    turn: the whole message as received, for policies that forward it.
    """

    state: Mapping[str, npt.NDArray[np.float64]]
    images: Mapping[str, npt.NDArray[np.uint8]]
    tensors: Mapping[str, npt.NDArray[Any]]
    instruction: str
    episode_id: str
    step: int
    turn: Turn | None = field(default=None, repr=False)

    def __reduce__(self) -> tuple[object, ...]:
        """A copy has the turn in its encoding: views of bytes cannot be pickled."""
        encoded = None if self.turn is None else msgspec.msgpack.encode(self.turn)
        arrays = self.state, self.images, self.tensors
        return _copied, (encoded, *arrays, self.instruction, self.episode_id, self.step)


def _copied(encoded: bytes | None, *members: Any) -> Observation:
    turn = None if encoded is None else msgspec.msgpack.decode(encoded, type=Turn)
    return replace(Observation(*members), turn=turn)


def observation_of(turn: Turn) -> Observation:
    """The observation of a turn that is not done.

    Raises ProctorError `bad_answer` if it is missing or does not decode.
    """
    if not turn.episode or not turn.observation:
        raise _broken("the turn", "has no observation, and is not done")
    episode = turn.episode
    return decode_observation(
        turn.observation, episode.instruction, episode.episode_id, episode.step, turn
    )


def decode_observation(
    observation: WireObservation,
    instruction: str,
    episode_id: str,
    step: int,
    turn: Turn | None = None,
) -> Observation:
    """One of a turn's observations; raises as `observation_of`."""
    return Observation(
        state=Named(
            "state", {n: state_vector(v) for n, v in observation.state.items()}
        ),
        images=Named("images", _pictures(observation.images)),
        tensors=Named(
            "tensors",
            {
                name: _array(name, tensor)
                for name, tensor in observation.tensors.items()
                if tensor.dtype in DTYPES
            },
        ),
        instruction=instruction,
        episode_id=episode_id,
        step=step,
        turn=turn,
    )


def state_vector(numbers: Sequence[float]) -> npt.NDArray[np.float64]:
    """A vector of the state as a policy receives it: float64, read-only."""
    vector = np.array(numbers, dtype=np.float64)
    vector.flags.writeable = False
    return vector


def _pictures(images: Mapping[str, Image]) -> dict[str, npt.NDArray[np.uint8]]:
    """Compressed images are decoded in parallel: decoders release the GIL."""
    if not images:
        return {}
    compressed = [image for image in images.values() if image.codec != "raw"]
    spread = _threads().map if len(compressed) > 1 else map
    return dict(zip(images, spread(_pixels, images, images.values()), strict=True))


@lru_cache(maxsize=1)
def _threads() -> ThreadPoolExecutor:
    return ThreadPoolExecutor(usable_processors(), thread_name_prefix="proctor-decode")


def _pixels(name: str, image: Image) -> npt.NDArray[np.uint8]:
    shape = (image.height, image.width, image.channels)
    if image.codec == "raw":
        return _view(name, image.data, np.dtype(np.uint8), shape)
    return _decompress(name, image.data, image.codec, shape)


def _decompress(
    name: str, data: memoryview, codec: str, shape: tuple[int, int, int]
) -> npt.NDArray[np.uint8]:
    """Decodes with the decoder of the declared codec only, never by content."""
    try:
        decode = {"jpeg": _from_jpeg, "png": _from_png}[codec]
        pixels = decode(data, shape)
    except (OSError, SyntaxError, LookupError, ValueError, MemoryError) as error:
        raise _broken(name, f"is not a valid {codec}: {error}") from error
    pixels.flags.writeable = False
    return pixels


def _from_jpeg(data: memoryview, shape: tuple[int, int, int]) -> npt.NDArray[np.uint8]:
    """Twice as fast as pillow, with the same pixels."""
    # Imported here: needed for compressed images only.
    import simplejpeg

    colours = _JPEG_COLOURS[shape[2]]
    size = simplejpeg.decode_jpeg_header(data)[:2]
    if size != shape[:2]:
        raise _other_size(size, shape)
    if prod(size) > _PIXELS_MAX:
        raise ValueError(f"{size} rows and columns exceed the limit of 2^26 pixels")
    pixels: npt.NDArray[np.uint8] = simplejpeg.decode_jpeg(data, colours)
    return pixels


def _from_png(data: memoryview, shape: tuple[int, int, int]) -> npt.NDArray[np.uint8]:
    import PIL.Image

    try:
        with PIL.Image.open(io.BytesIO(data), formats=["PNG"]) as picture:
            if picture.size[::-1] != shape[:2]:
                raise _other_size(picture.size[::-1], shape)
            pixels = np.asarray(picture.convert(_PNG_MODES[shape[2]]), dtype=np.uint8)
    except PIL.Image.DecompressionBombError as error:
        raise ValueError(str(error)) from error
    return pixels.reshape(shape)


def _other_size(size: tuple[int, ...], shape: tuple[int, ...]) -> ValueError:
    """Raised from the header, before pixels are decoded."""
    return ValueError(f"has {size} rows and columns, declared as {shape[:2]}")


def _array(name: str, tensor: Tensor) -> npt.NDArray[Any]:
    """C order, little-endian; a bool is one byte."""
    dtype = np.dtype(tensor.dtype).newbyteorder("<")
    return _view(name, tensor.data, dtype, tuple(tensor.shape))


def _view(
    name: str, data: memoryview, dtype: np.dtype[Any], shape: tuple[int, ...]
) -> npt.NDArray[Any]:
    try:
        array = np.frombuffer(data, dtype).reshape(shape)
    except ValueError as error:
        raise _broken(name, f"does not have its declared size: {error}") from error
    array.flags.writeable = False
    return array


def _broken(name: str, what: str) -> ProctorError:
    return ProctorError(
        BAD_ANSWER,
        f"The observation cannot be decoded: {name} {what}. Report it to the server's "
        "operator.",
        side_effects="possible",
    )
