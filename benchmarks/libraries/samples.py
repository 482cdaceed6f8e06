"""Captured requests and responses of the reference server, byte for byte.

Written to a folder by capture.py and read from there by every measurement: a turn
without images, and one with four raw images of 480 × 640. Uses no library but msgspec,
which decodes the response.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple

import msgspec

STATE, CAMERAS = "state", "cameras"
# Environment variables of a server: the folder of samples, and whether to copy.
FOLDER, COPIES = "BENCHMARKS_SAMPLES", "BENCHMARKS_COPIES"
_HEAD_END = b"\r\n\r\n"
# What every HTTP client writes by itself.
_NOT_GIVEN = ("host", "content-length")


class SampleRequest(NamedTuple):
    """A request, as an HTTP client is given it."""

    path: str
    headers: dict[str, str]
    body: bytes


@dataclass(frozen=True, slots=True)
class Sample:
    """request, answer: head and body, in MessagePack."""

    request: bytes
    answer: bytes

    def write(self, folder: Path, name: str) -> None:
        (folder / f"{name}.request").write_bytes(self.request)
        (folder / f"{name}.answer").write_bytes(self.answer)

    @property
    def sample_request(self) -> SampleRequest:
        head, _, body = self.request.partition(_HEAD_END)
        first, *lines = head.decode("latin-1").split("\r\n")
        headers = dict(line.split(": ", 1) for line in lines)
        given = {n: v for n, v in headers.items() if n.lower() not in _NOT_GIVEN}
        return SampleRequest(first.split()[1], given, body)

    @property
    def body(self) -> bytes:
        return self.answer.partition(_HEAD_END)[2]

    def turn(self) -> dict[str, Any]:
        """As the server has it before it is encoded: pictures are views of memory."""
        turn: dict[str, Any] = msgspec.msgpack.decode(self.body)
        return with_pictures(turn, memoryview)

    def parts(self) -> list[memoryview]:
        """The body in the parts that the server sends: images are separate parts."""
        body, parts, start = self.body, [], 0
        view = memoryview(body)
        for image in self.turn()["observation"]["images"].values():
            found = body.index(image["data"], start)
            end = found + len(image["data"])
            parts += [view[start:found], view[found:end]]
            start = end
        return [*parts, view[start:]]


def read(folder: Path, name: str) -> Sample:
    request, answer = folder / f"{name}.request", folder / f"{name}.answer"
    return Sample(request.read_bytes(), answer.read_bytes())


def with_pictures(turn: dict[str, Any], become: Any) -> dict[str, Any]:
    """A turn with `become` applied to the data of every image."""
    observation = turn["observation"]
    images = {
        name: image | {"data": become(image["data"])}
        for name, image in observation["images"].items()
    }
    return turn | {"observation": observation | {"images": images}}
