"""Proctor's predict, by a small client: one persistent connection, msgspec's decoders.

`python -m … URL SCENARIO MEDIA CODEC`. MEDIA is json or msgpack; CODEC is raw, jpeg, or
jpeg-files, where images stay encoded. It knows the specification and imports nothing of
the reference implementation.
"""

from __future__ import annotations

import http.client
import sys
import uuid
from collections.abc import Callable
from typing import Any
from urllib.parse import urlsplit

import msgspec
import numpy as np
import simplejpeg
from numpy.typing import NDArray

from benchmarks.round_trips.contenders import turn_client
from benchmarks.round_trips.observations import SCENARIOS, by_name

TOKEN = "bench"  # noqa: S105 - opens nothing but the server of the benchmark


class Image(msgspec.Struct):
    """data: a view of the answer in MessagePack, decoded Base64 in JSON."""

    codec: str
    width: int
    height: int
    channels: int
    data: memoryview


class Observation(msgspec.Struct):
    state: dict[str, list[float]]
    images: dict[str, Image]


class Turn(msgspec.Struct):
    """What a policy needs of it. No observation once the run is done."""

    session_id: str
    seq: int
    executed_steps: int
    done: bool
    observation: Observation | None = None


class Connection:
    """A connection; a response is read into the memory of the last but one."""

    def __init__(self, url: str, media: str) -> None:
        self._http = http.client.HTTPConnection(urlsplit(url).netloc)
        media_type = f"application/{media}"
        self._headers = {
            "Authorization": f"Bearer {TOKEN}",
            "Content-Type": media_type,
            "Accept": media_type,
        }
        coded = msgspec.msgpack if media == "msgpack" else msgspec.json
        self._encode: Callable[[Any], bytes] = coded.Encoder().encode
        self._read_turn: Any = coded.Decoder(Turn).decode
        self._buffers = [bytearray(), bytearray()]

    def submit(self, **body: Any) -> str:
        """Returns the id of the run. body: schema SubmitRun, but for its policy."""
        run = self._control("/v1/runs", body | {"policy": {"name": "benchmarks"}})
        return str(run["run_id"])

    def stop(self, run_id: str) -> None:
        self._control(f"/v1/runs/{run_id}/stop", {})

    def _control(self, path: str, body: Any) -> Any:
        """The control plane speaks JSON."""
        json = {"Content-Type": "application/json", "Accept": "application/json"}
        encoded = msgspec.json.encode(body)
        self._http.request("POST", path, encoded, self._headers | json)
        answer = self._http.getresponse()
        value = msgspec.json.decode(answer.read())
        if answer.status >= 400:
            raise RuntimeError(f"{path}: {value}")
        return value

    def attach(self, run_id: str, worker_id: str) -> tuple[str, Turn]:
        """Where to predict, and the turn 0."""
        path = f"/v1/runs/{run_id}/workers/{worker_id}"
        turn = self.turn("PUT", path, {"attach_key": uuid.uuid4().hex})
        return f"{path}/predict", turn

    def close(self) -> None:
        self._http.close()

    def turn(self, method: str, path: str, body: Any) -> Turn:
        self._http.request(method, path, self._encode(body), self._headers)
        answer = self._http.getresponse()
        read = self._receive(answer)
        if answer.status != 200:
            raise RuntimeError(f"{method} {path}: {bytes(read)!r}")
        turn: Turn = self._read_turn(read)
        return turn

    def _receive(self, answer: http.client.HTTPResponse) -> memoryview:
        self._buffers.reverse()
        length = int(answer.headers["Content-Length"])
        if len(self._buffers[0]) < length:
            self._buffers[0] = bytearray(length)
        view = memoryview(self._buffers[0])[:length]
        got = 0
        while got < length:
            got += answer.readinto(view[got:])
        answer.read()  # says that this answer is over
        return view


def connect(url: str, scenario: str, media: str, codec: str) -> turn_client.Turn:
    shown = SCENARIOS[scenario]
    connection = Connection(url, media)
    submission: dict[str, Any] = {"benchmark_id": f"still_life_{scenario}"}
    if shown.cameras:
        submission["images"] = {
            "codec": codec.partition("-")[0],
            "width": shown.width,
            "height": shown.height,
        }
    predict, attached = connection.attach(connection.submit(**submission), "w")
    body: dict[str, Any] = {"session_id": attached.session_id, "seq": attached.seq}
    unpack = {"raw": pixels, "jpeg": decompressed, "jpeg-files": as_file}[codec]

    def turn(action: list[float]) -> turn_client.ObservationParts:
        body["seq"] += 1
        body["actions"] = [{"values": by_name(action)}]
        observation = connection.turn("POST", predict, body).observation
        assert observation is not None, "the run is over"
        return observation.state, {
            name: unpack(one) for name, one in observation.images.items()
        }

    return turn


def pixels(image: Image) -> NDArray[np.uint8]:
    shape = (image.height, image.width, image.channels)
    return np.frombuffer(image.data, np.uint8).reshape(shape)


def decompressed(image: Image) -> NDArray[np.uint8]:
    decoded: NDArray[np.uint8] = simplejpeg.decode_jpeg(image.data, "RGB")
    return decoded


def as_file(image: Image) -> Image:
    return image


def main() -> None:
    url, scenario, media, codec = sys.argv[1:]
    turn = connect(url, scenario, media, codec)
    unpack = decompressed if codec == "jpeg-files" else None
    turn_client.serve(
        turn_client.TurnClient(turn, scenario, unpack=unpack, exact=codec == "raw")
    )


if __name__ == "__main__":
    main()
