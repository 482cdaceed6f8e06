"""A file that is offered to a simulator as memory for its pictures (SIM-021)."""

import tempfile
from collections.abc import Collection, Mapping
from typing import Any, Self

_GAP = 64  # bytes between images, which are not to be written
_UNTOUCHED = b"\xa5"


class PictureFile:
    """A file with a place for each image, and gaps between them.

    number: as the protocol gives one to each memory. lengths: of the images.
    """

    def __init__(self, number: int, lengths: Mapping[str, int]) -> None:
        self._number, self._lengths = number, lengths
        self._offsets: dict[str, int] = {}
        end = _GAP
        for name, length in lengths.items():
            self._offsets[name] = end
            end += length + _GAP
        self._size = end
        self._file = tempfile.NamedTemporaryFile(buffering=0)  # noqa: SIM115
        self._file.write(_UNTOUCHED * end)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self._file.close()

    def offered(self) -> dict[str, Any]:
        """The member `memory` of a request."""
        return {
            "number": self._number,
            "path": self._file.name,
            "size": self._size,
            "offsets": self._offsets,
        }

    def faults(
        self, written: Collection[str], pixels: Mapping[str, bytes]
    ) -> list[str]:
        """How the file differs from one with these images at their offsets."""
        expected = bytearray(_UNTOUCHED * self._size)
        for name in written:
            begin = self._offsets[name]
            expected[begin : begin + self._lengths[name]] = pixels[name]
        self._file.seek(0)
        seen = self._file.read()
        if seen == expected:
            return []
        pairs = enumerate(zip(seen, expected, strict=False))
        first = next((place for place, (a, b) in pairs if a != b), len(seen))
        return [f"byte {first} of {len(seen)} differs; offsets {self._offsets}"]
