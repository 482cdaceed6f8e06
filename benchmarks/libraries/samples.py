"""Captured requests and answers of the reference server, in MessagePack.

There is a turn without images, and one with four raw images of 480 × 640. Every
measurement reads them from a folder. The names are those of the scenarios of the round
trips.
"""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import msgspec

STATE, CAMERAS = "state", "cameras"
FOLDER = "BENCHMARKS_SAMPLES"  # an environment variable of a server


class Sample(msgspec.Struct):
    """One exchange: body and headers of the request, body of the answer."""

    path: str
    headers: dict[str, str]
    body: bytes
    answer: bytes

    def turn(self) -> dict[str, Any]:
        """The turn before it is encoded: pictures are views of memory."""
        turn: dict[str, Any] = msgspec.msgpack.decode(self.answer)
        return with_pictures(turn, memoryview)


def read(folder: Path, name: str) -> Sample:
    return msgspec.msgpack.decode((folder / name).read_bytes(), type=Sample)


def with_pictures(turn: dict[str, Any], become: Callable[[Any], Any]) -> dict[str, Any]:
    """A turn with `become` applied to the data of every image."""
    observation = turn["observation"]
    images = {
        name: image | {"data": become(image["data"])}
        for name, image in observation["images"].items()
    }
    return turn | {"observation": observation | {"images": images}}


def capture(folder: Path) -> None:
    """Write both samples, from a server that is started for it."""
    # The environment of the libraries reads samples, and has no such modules.
    from benchmarks.measured_server import running_server
    from benchmarks.round_trips.contenders import small_client
    from benchmarks.round_trips.observations import action, by_name

    module = "benchmarks.round_trips.still_life.still_life_server"
    with running_server(folder / "bench.sqlite", module) as server:
        for name in (STATE, CAMERAS):
            connection = small_client.Connection(server.url, "msgpack")
            submission = small_client.submission_of(name, "raw")
            path, attached = connection.attach(connection.submit(**submission), "w")
            chunk = [{"values": by_name(action(1))}]
            session = {"session_id": attached.session_id, "seq": attached.seq + 1}
            body = connection.encode({**session, "actions": chunk})
            answer = bytes(connection.send("POST", path, body))
            sample = Sample(path, connection.headers, body, answer)
            (folder / name).write_bytes(msgspec.msgpack.encode(sample))
