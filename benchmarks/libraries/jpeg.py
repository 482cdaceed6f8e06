"""Four images of 480 × 640 as JPEG: quality 90, 4:2:0, one thread and several.

Both libraries contain libjpeg-turbo. Decoders must produce the same pixels from the
same files. Encoders produce different files: below quality 96 libjpeg-turbo's own
interface, which simplejpeg calls, uses a faster DCT. So each must be equally close to
the original, and the sizes are reported. PyTurboJPEG is omitted: it needs the system's
libturbojpeg.
"""

from __future__ import annotations

import io
from collections.abc import Callable, Iterable, Sequence
from typing import Any

import numpy as np
import simplejpeg
from numpy.typing import NDArray
from PIL import Image

from benchmarks.libraries.interleaved_timing import Contender

Pixels = NDArray[np.uint8]
Spread = Callable[[Callable[[Any], Any], Iterable[Any]], Iterable[Any]]
_QUALITY = 90
_FAR = 2.0  # levels of 256, the mean over a picture


def encoded(pictures: Sequence[Pixels], spread: Spread) -> tuple[list[Contender], Any]:
    """spread: `map`, or that of threads."""
    return [
        Contender(
            name,
            _of_all(encode, spread),
            lambda: pictures,
            lambda files: [
                _is_near(_by_simplejpeg(file), picture)
                for file, picture in zip(files, pictures, strict=True)
            ],
        )
        for name, encode in ENCODERS.items()
    ], [True] * len(pictures)


def decoded(pictures: Sequence[Pixels], spread: Spread) -> tuple[list[Contender], Any]:
    files = [_to_simplejpeg(one) for one in pictures]
    expected = [_by_simplejpeg(one).tobytes() for one in files]
    return [
        Contender(name, _of_all(decode, spread), lambda: files, _bytes_of)
        for name, decode in (("simplejpeg", _by_simplejpeg), ("Pillow", _by_pillow))
    ], expected


def _of_all(work: Callable[[Any], Any], spread: Spread) -> Callable[[Any], list[Any]]:
    return lambda several: list(spread(work, several))


def _to_simplejpeg(pixels: Pixels) -> bytes:
    coded: bytes = simplejpeg.encode_jpeg(pixels, _QUALITY, "RGB", "420")
    return coded


def _to_pillow(pixels: Pixels) -> bytes:
    file = io.BytesIO()
    Image.fromarray(pixels).save(file, "JPEG", quality=_QUALITY, subsampling="4:2:0")
    return file.getvalue()


def _by_simplejpeg(data: bytes) -> Pixels:
    pixels: Pixels = simplejpeg.decode_jpeg(data, "RGB")
    return pixels


def _by_pillow(data: bytes) -> Pixels:
    with Image.open(io.BytesIO(data), formats=["JPEG"]) as picture:
        return np.asarray(picture)


def _is_near(pixels: Pixels, original: Pixels) -> bool:
    return bool(np.abs(pixels.astype(int) - original).mean() < _FAR)


def sizes_kb(pictures: Sequence[Pixels]) -> dict[str, float]:
    """Of all files together."""
    return {
        name: sum(len(encode(one)) for one in pictures) / 1000
        for name, encode in ENCODERS.items()
    }


def _bytes_of(pictures: Iterable[Pixels]) -> list[bytes]:
    return [one.tobytes() for one in pictures]


ENCODERS: dict[str, Callable[[Pixels], bytes]] = {
    "simplejpeg": _to_simplejpeg,
    "Pillow": _to_pillow,
}
