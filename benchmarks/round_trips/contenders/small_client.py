"""Proctor's predict, by a small client: one persistent connection, msgspec's decoders.

It knows the specification and imports nothing of the reference implementation. The
server is that of still_life/.
"""

import http.client
import uuid
from collections.abc import Callable
from typing import Any
from urllib.parse import urlsplit

import msgspec
import numpy as np
import simplejpeg
from numpy.typing import NDArray

from benchmarks.measured_server import TOKEN
from benchmarks.round_trips.contender_process import ObservationParts, Turn
from benchmarks.round_trips.observations import SCENARIOS, by_name


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


class TurnMessage(msgspec.Struct):
    """The members that a policy needs. No observation once the run is done."""

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
        self.headers = {
            "Authorization": f"Bearer {TOKEN}",
            "Content-Type": media_type,
            "Accept": media_type,
        }
        coded = msgspec.msgpack if media == "msgpack" else msgspec.json
        self.encode: Callable[[Any], bytes] = coded.Encoder().encode
        self._read_turn: Any = coded.Decoder(TurnMessage).decode
        self._buffers = [bytearray(), bytearray()]

    def submit(self, **body: Any) -> str:
        """Returns the id of the run. body: schema SubmitRun, but for its policy."""
        run = self._control("/v1/runs", body | {"policy": {"name": "benchmarks"}})
        return str(run["run_id"])

    def _control(self, path: str, body: Any) -> Any:
        """The control plane speaks JSON."""
        json = {"Content-Type": "application/json", "Accept": "application/json"}
        encoded = msgspec.json.encode(body)
        self._http.request("POST", path, encoded, self.headers | json)
        answer = self._http.getresponse()
        value = msgspec.json.decode(answer.read())
        if answer.status >= 400:
            raise RuntimeError(f"{path}: {value}")
        return value

    def attach(self, run_id: str, worker_id: str) -> tuple[str, TurnMessage]:
        """Where to predict, and the turn 0."""
        path = f"/v1/runs/{run_id}/workers/{worker_id}"
        turn = self.turn("PUT", path, {"attach_key": uuid.uuid4().hex})
        return f"{path}/predict", turn

    def turn(self, method: str, path: str, body: Any) -> TurnMessage:
        turn: TurnMessage = self._read_turn(self.send(method, path, self.encode(body)))
        return turn

    def send(self, method: str, path: str, body: bytes) -> memoryview:
        """The body of the answer."""
        self._http.request(method, path, body, self.headers)
        answer = self._http.getresponse()
        read = self._receive(answer)
        if answer.status != 200:
            raise RuntimeError(f"{method} {path}: {bytes(read)!r}")
        return read

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


def submission_of(scenario: str, codec: str) -> dict[str, Any]:
    shown = SCENARIOS[scenario]
    submission: dict[str, Any] = {"benchmark_id": f"still_life_{scenario}"}
    if shown.cameras:
        size = {"width": shown.width, "height": shown.height}
        submission["images"] = {"codec": codec, **size}
    return submission


def connect(url: str, scenario: str, media: str, codec: str) -> Turn:
    """codec: raw, jpeg, or jpeg-files, which leaves the images as they are."""
    connection = Connection(url, media)
    run_id = connection.submit(**submission_of(scenario, codec.partition("-")[0]))
    predict, attached = connection.attach(run_id, "w")
    body: dict[str, Any] = {"session_id": attached.session_id, "seq": attached.seq}
    unpack = {"raw": pixels, "jpeg": decompressed, "jpeg-files": as_file}[codec]

    def turn(action: list[float]) -> ObservationParts:
        body["seq"] += 1
        body["actions"] = [{"values": by_name(action)}]
        observation = connection.turn("POST", predict, body).observation
        assert observation is not None, "the run is over"
        return observation.state, {
            name: unpack(image) for name, image in observation.images.items()
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
