"""Converts observations to the protocol's structure: lists, numbers and bytes.

The server encodes the structure as JSON or MessagePack. The structure owns its bytes: a
simulator may render into the same buffer again.
"""

from __future__ import annotations

import io
from collections.abc import Mapping
from concurrent.futures import ThreadPoolExecutor
from functools import lru_cache, partial
from typing import NotRequired, TypedDict

import numpy as np
import simplejpeg
from numpy.typing import NDArray
from PIL import Image, PngImagePlugin

from reference_record.this_machine import usable_processors
from reference_sim.interface import Observation
from reference_sim.shared_frame_buffer import SharedFrameBuffer

JPEG_QUALITY = 90
PNG_COMPRESS_LEVEL = 1  # larger by a tenth than the default, five times as fast

# Pillow loads plugins lazily: named here, it is loaded before a process is forked.
_PLUGIN = PngImagePlugin
# channels → colour space and chroma subsampling of simplejpeg
_JPEG_COLOURS = {1: ("GRAY", "Gray"), 3: ("RGB", "420")}

_NOTHING = memoryview(b"")


class EncodedImage(TypedDict):
    """place: offset and length in the frame buffer; replaced by `data` on receipt."""

    codec: str
    width: int
    height: int
    channels: int
    data: memoryview
    place: NotRequired[tuple[int, int]]


class EncodedTensor(TypedDict):
    dtype: str
    shape: list[int]
    data: memoryview


class EncodedObservation(TypedDict):
    state: dict[str, list[float]]
    images: dict[str, EncodedImage]
    tensors: dict[str, EncodedTensor]


def encode(
    observation: Observation, codec: str, frame_buffer: SharedFrameBuffer | None = None
) -> EncodedObservation:
    """The structure of the specification's schema Observation, `data` as bytes.

    frame_buffer: raw pixels in it are not copied, but referenced by `place`.
    """
    return {
        "state": {
            name: np.asarray(vector, dtype=np.float64).tolist()
            for name, vector in observation.state.items()
        },
        "images": _encode_images(observation.images, codec, frame_buffer),
        "tensors": {
            name: encode_tensor(tensor) for name, tensor in observation.tensors.items()
        },
    }


def _encode_images(
    images: Mapping[str, NDArray[np.uint8]],
    codec: str,
    frame_buffer: SharedFrameBuffer | None,
) -> dict[str, EncodedImage]:
    """Several cameras are compressed in parallel: encoders release the GIL."""
    if not images:
        return {}
    encode_one = partial(encode_image, codec=codec, frame_buffer=frame_buffer)
    many = len(images) > 1 and codec != "raw"
    spread = _threads().map if many else map
    return dict(zip(images, spread(encode_one, images.values()), strict=True))


@lru_cache(maxsize=1)
def _threads() -> ThreadPoolExecutor:
    """Made at first use, which is after the process was forked."""
    return ThreadPoolExecutor(usable_processors(), thread_name_prefix="encode")


def encode_image(
    pixels: NDArray[np.uint8], codec: str, frame_buffer: SharedFrameBuffer | None = None
) -> EncodedImage:
    """pixels: uint8 (height, width, channels)."""
    height, width, channels = pixels.shape
    image: EncodedImage = {
        "codec": codec,
        "width": width,
        "height": height,
        "channels": channels,
        "data": _NOTHING,
    }
    if codec != "raw":
        image["data"] = _compress(pixels, codec)  # ENC-006, ENC-007
    elif frame_buffer is not None and (place := frame_buffer.place_of(pixels)):
        image["place"] = place
    else:
        image["data"] = memoryview(pixels.tobytes())  # ENC-005
    return image


def encode_tensor(tensor: NDArray[np.generic]) -> EncodedTensor:
    little_endian = tensor.astype(tensor.dtype.newbyteorder("<"), copy=False)
    return {
        "dtype": tensor.dtype.name,
        "shape": list(tensor.shape),
        "data": memoryview(little_endian.tobytes()),  # ENC-004
    }


def _compress(pixels: NDArray[np.uint8], codec: str) -> memoryview:
    if codec == "jpeg":  # ENC-007
        return memoryview(_jpeg(pixels))
    if codec != "png":  # ENC-006
        raise ValueError(f"no image codec {codec!r}")
    image = Image.fromarray(pixels.squeeze(axis=2) if pixels.shape[2] == 1 else pixels)
    file = io.BytesIO()
    image.save(file, "PNG", compress_level=PNG_COMPRESS_LEVEL)
    return file.getbuffer()


def _jpeg(pixels: NDArray[np.uint8]) -> bytes:
    """simplejpeg: in threads, Pillow takes twice as long, for 3 % smaller files."""
    colours = _JPEG_COLOURS.get(pixels.shape[2])
    if colours is None:
        raise ValueError(f"JPEG has no {pixels.shape[2]} channels")
    in_order = np.ascontiguousarray(pixels)
    coded: bytes = simplejpeg.encode_jpeg(in_order, JPEG_QUALITY, *colours)
    return coded
