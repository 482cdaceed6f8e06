"""`python -m … FOLDER ROUNDS`: the libraries that need no second process.

Runs in the environment that has all the libraries; FOLDER contains the samples. Prints
JSON: a table's row for each piece and library.
"""

import io
import json
import os
import sys
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import msgpack
import msgspec
import numpy as np
import orjson
import ormsgpack
import pybase64
import simplejpeg
from numpy.typing import NDArray
from PIL import Image

from benchmarks.libraries import samples
from benchmarks.libraries.samples import Sample, with_pictures
from benchmarks.libraries.timed_pieces import Piece, Work, rows
from benchmarks.round_trips import observations
from reference_client.generated.messages import Turn

Pixels = NDArray[np.uint8]
Spread = Callable[[Work, Iterable[Any]], Iterable[Any]]
_PLAIN_TYPES = (bytes, bytearray, memoryview)
_QUALITY = 90
_FAR = 2.0  # levels of 256, the mean over a picture


def encodings(state: Sample, cameras: Sample) -> Iterator[Piece]:
    """Decoded are the bytes that the server sent; encoded is the turn that it held.

    All encodings must decode to the same. A library without Base64 is combined with
    pybase64; only pictures are in Base64.
    """
    turn, drawn = state.turn(), cameras.turn()
    readers: dict[str, Work] = {
        "msgspec": msgspec.msgpack.Decoder(Turn).decode,
        "msgpack": msgpack.unpackb,
        "ormsgpack": ormsgpack.unpackb,
    }
    for shown, sample in (("a turn", state), ("four raw images", cameras)):
        name = f"MessagePack, decoding {shown}"
        yield Piece(name, readers, sample.answer, _builtins, sample.turn())
    writers: dict[str, Work] = {
        "msgspec": msgspec.json.encode,
        "orjson": orjson.dumps,
        "json": lambda turn: json.dumps(turn, separators=(",", ":")).encode(),
    }
    yield Piece("JSON, encoding a turn", writers, turn, _of_json, turn)
    to_base64 = pybase64.b64encode_as_string
    of_pictures: dict[str, Work] = {
        "msgspec with pybase64": lambda turn: msgspec.json.encode(
            with_pictures(turn, _quoted)
        ),
        "msgspec": msgspec.json.encode,
        "orjson with pybase64": lambda turn: orjson.dumps(
            with_pictures(turn, to_base64)
        ),
    }
    yield Piece("JSON, encoding four images", of_pictures, drawn, _of_json, drawn)


def _quoted(data: memoryview) -> msgspec.Raw:
    """A JSON string that msgspec copies unchanged."""
    return msgspec.Raw(b'"%b"' % pybase64.b64encode(data))


def _of_json(text: bytes) -> Any:
    return _builtins(msgspec.json.decode(text, type=Turn))


def _builtins(made: Any) -> Any:
    return msgspec.to_builtins(made, builtin_types=_PLAIN_TYPES)


def jpegs(pictures: Sequence[Pixels], spread: Spread, suffix: str) -> Piece:
    """Quality 90, 4:2:0. spread: `map`, or that of threads.

    Both libraries contain libjpeg-turbo, and their files differ: below quality 96
    libjpeg-turbo's own interface, which simplejpeg calls, uses a faster DCT. So each
    must be equally close to the original.
    """

    def of_all(work: Work) -> Work:
        return lambda several: list(spread(work, several))

    def are_near(files: Sequence[bytes]) -> list[bool]:
        return [
            bool(np.abs(_decoded(file).astype(int) - picture).mean() < _FAR)
            for file, picture in zip(files, pictures, strict=True)
        ]

    encoders = {"simplejpeg": of_all(_by_simplejpeg), "Pillow": of_all(_by_pillow)}
    name, expected = f"JPEG, encoding four images{suffix}", [True] * len(pictures)
    return Piece(name, encoders, pictures, are_near, expected)


def _by_simplejpeg(pixels: Pixels) -> bytes:
    coded: bytes = simplejpeg.encode_jpeg(pixels, _QUALITY, "RGB", "420")
    return coded


def _by_pillow(pixels: Pixels) -> bytes:
    file = io.BytesIO()
    Image.fromarray(pixels).save(file, "JPEG", quality=_QUALITY, subsampling="4:2:0")
    return file.getvalue()


def _decoded(data: bytes) -> Pixels:
    pixels: Pixels = simplejpeg.decode_jpeg(data, "RGB")
    return pixels


def main() -> None:
    folder, rounds = Path(sys.argv[1]), int(sys.argv[2])
    state = samples.read(folder, samples.STATE)
    cameras = samples.read(folder, samples.CAMERAS)
    drawn = observations.pictures(observations.SCENARIOS["cameras"])
    pictures = list(drawn.values())
    with ThreadPoolExecutor(os.cpu_count()) as threads:
        pieces = [
            *encodings(state, cameras),
            jpegs(pictures, map, ""),
            jpegs(pictures, threads.map, ", in threads"),
        ]
        print(json.dumps([row for piece in pieces for row in rows(piece, rounds)]))


if __name__ == "__main__":
    main()
