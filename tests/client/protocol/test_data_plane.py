"""The client's hot path: views and no copies, and memory that is never taken away."""

import contextlib
import socket
import threading
from collections.abc import Callable, Iterator
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import Any

import msgspec
import numpy as np
import pytest
from proctor_client import AttachWorker, Heartbeat
from urllib3.util.wait import wait_for_read

from reference_client.api.observation import observation_of
from reference_client.errors import ProctorError, from_failure
from reference_client.generated.messages import Turn
from reference_client.protocol.connection import Connection
from reference_client.protocol.data_plane import JSON, MSGPACK, DataPlane
from reference_client.protocol.retry_policy import FAILURES
from reference_record.generated.answers import Action
from tests.support.client.direct_client import DirectClient
from tests.support.kit.null_servers import TURN
from tests.support.servers import TIMEOUT_S, TOKENS
from tests.support.sim.calibration_action import calibration_action as action

PIXELS = bytes(range(12))


class EchoWorker:
    """One worker of a calibration run on the real server."""

    def __init__(self, plane: DataPlane, run_id: str) -> None:
        self._plane, self._run_id = plane, run_id
        self.turn = plane.attach_worker(run_id, "w", AttachWorker(attach_key="k"))

    def step(self, **values: float) -> Turn:
        session_id, seq = self.turn.session_id, self.turn.seq + 1
        actions: list[Action] = [{"values": action(**values)}]
        self.turn = self._plane.predict(self._run_id, "w", session_id, seq, actions)
        return self.turn


@pytest.fixture
def echo_worker(direct: DirectClient) -> Iterator[EchoWorker]:
    run = direct.submit("echo")
    with Connection(run.endpoint, TOKENS["alice"], requests=1) as connection:
        yield EchoWorker(connection.data(run.endpoint), run.run_id)


def memory_of(turn: Turn) -> Any:
    assert turn.observation
    return turn.observation.images["pattern"].data.obj


@pytest.mark.slow("starts a server or a kit")
def test_an_image_is_a_view_of_the_answer(echo_worker: EchoWorker) -> None:
    turn = echo_worker.step()
    assert isinstance(memory_of(turn), bytearray)
    seen = observation_of(turn).images["pattern"]
    assert np.shares_memory(seen, np.frombuffer(memory_of(turn), np.uint8))
    assert not seen.flags.writeable


@pytest.mark.slow("starts a server or a kit")
def test_a_buffer_in_use_is_not_overwritten(echo_worker: EchoWorker) -> None:
    patterns = []
    for _ in range(6):
        pattern = observation_of(echo_worker.step()).images["pattern"]
        patterns.append((pattern, pattern.copy()))
    assert all(np.array_equal(view, copy) for view, copy in patterns)
    first, last = patterns[0][1], patterns[-1][1]
    assert not np.array_equal(first, last), "or being written over would not show"


@pytest.mark.slow("starts a server or a kit")
def test_an_unused_buffer_is_reused(echo_worker: EchoWorker) -> None:
    assert len({id(memory_of(echo_worker.step())) for _ in range(8)}) <= 3


# A server of a few canned answers


def turn_body(seq: int) -> dict[str, Any]:
    image = {"codec": "raw", "width": 2, "height": 2, "channels": 3, "data": PIXELS}
    observation = {"state": {}, "images": {"c": image}, "tensors": {}}
    changed = {"session_id": "s", "seq": seq, "observation": observation}
    return TURN | changed | {"of_a_later_version": {"x": 1}}


class CannedServer(ThreadingHTTPServer):
    """Answers everything with `body` as `media_type`. asked_in: the media types of what
    was asked. connections: how many were opened. has_length: else the end of a body is
    that of its connection."""

    daemon_threads = True

    def __init__(self, media_type: str, body: bytes) -> None:
        super().__init__(("127.0.0.1", 0), _CannedHandler)
        self.media_type, self.body = media_type, body
        self.request_media_types: list[str] = []
        self.connections = 0
        self.closes_connection, self.has_length = False, True
        self.url = f"http://127.0.0.1:{self.server_address[1]}"


class _CannedHandler(BaseHTTPRequestHandler):
    protocol_version = "HTTP/1.1"
    server: CannedServer

    def setup(self) -> None:
        self.server.connections += 1
        super().setup()

    def _answer(self) -> None:
        self.rfile.read(int(self.headers["Content-Length"] or 0))
        self.server.request_media_types.append(self.headers["Content-Type"])
        self.send_response_only(200)
        self.send_header("Content-Type", self.server.media_type)
        if self.server.has_length:
            self.send_header("Content-Length", str(len(self.server.body)))
        self.end_headers()
        self.wfile.write(self.server.body)
        self.close_connection = self.server.closes_connection  # and says nothing of it

    do_GET = do_PUT = do_POST = _answer  # noqa: N815 - http.server's names


@contextlib.contextmanager
def canned_server(
    media_type: str, body: bytes
) -> Iterator[tuple[CannedServer, DataPlane]]:
    with CannedServer(media_type, body) as server:
        threading.Thread(target=server.serve_forever, args=[0.01], daemon=True).start()
        with Connection(server.url, "t", requests=1) as connection:
            yield server, connection.data(server.url)
        server.shutdown()


def predict_once(plane: DataPlane, seq: int = 1) -> Turn:
    return plane.predict("r", "w", "s", seq, [{"values": {"a": [0.5]}}])


@pytest.mark.parametrize(
    ("media_type", "encode"),
    [(JSON, msgspec.json.encode), (MSGPACK, msgspec.msgpack.encode)],
)
def test_requests_use_the_last_media_type(media_type: str, encode: Any) -> None:
    with canned_server(media_type, encode(turn_body(1))) as (server, plane):
        for seq in (1, 2):
            turn = predict_once(plane, seq)
            assert turn.observation
            assert bytes(turn.observation.images["c"].data) == PIXELS
        assert server.request_media_types == [JSON, media_type]
        assert server.connections == 1


def test_a_closed_connection_is_opened_again() -> None:
    turn = msgspec.msgpack.encode(turn_body(1))
    with canned_server(MSGPACK, turn) as (server, plane):
        server.closes_connection = True
        for _ in range(3):
            assert predict_once(plane).seq == 1
            # While the policy thinks, the end of the connection arrives.
            opened = plane.http_connection.sock
            assert isinstance(opened, socket.socket)
            assert wait_for_read(opened, TIMEOUT_S)
        assert server.connections == 3


ENCODED = msgspec.json.encode(turn_body(1))


@pytest.mark.parametrize(
    ("media_type", "body"),
    [
        ("text/html", b"<h1>Welcome</h1>"),
        (JSON, b"{"),
        (JSON, ENCODED.replace(b'"seq":1', b'"seq":"1"')),
        (JSON, ENCODED.replace(b'"session_id":"s",', b"")),
        (JSON, ENCODED.replace(b'"data":"', b'"data":"*')),
        (MSGPACK, ENCODED),
    ],
)
def test_an_invalid_turn_is_an_error(media_type: str, body: bytes) -> None:
    with (
        canned_server(media_type, body) as (_, plane),
        pytest.raises(FAILURES) as caught,
    ):
        predict_once(plane)
    assert isinstance(caught.value, Exception)
    error = from_failure(caught.value, "http://x")
    assert (error.code, error.retryable) == ("bad_answer", False)


def fault_of(request: Callable[[], object]) -> ProctorError:
    with pytest.raises(FAILURES) as caught:
        request()
    assert isinstance(caught.value, Exception)
    return from_failure(caught.value, "http://x")


@pytest.mark.parametrize(
    ("media_type", "body"),
    [(JSON, ENCODED), (MSGPACK, msgspec.msgpack.encode(turn_body(1)))],
)
@pytest.mark.parametrize("share", [0.0, 0.5])
def test_a_message_without_a_length_that_breaks_off_is_lost(
    media_type: str, body: bytes, share: float
) -> None:
    with canned_server(media_type, body) as (server, plane):
        server.has_length, server.closes_connection = False, True
        assert predict_once(plane).seq == 1
        server.body = body[: int(share * len(body))]
        beat = Heartbeat(session_id="s")
        faults = [fault_of(lambda: predict_once(plane))]
        if media_type == JSON:
            faults.append(fault_of(lambda: plane.heartbeat("r", "w", beat)))
    assert {(fault.code, fault.retryable) for fault in faults} == {
        ("unreachable", True)
    }


def test_the_connection_on_which_a_page_came_is_left() -> None:
    """It may lead to a portal for ever, also when new ones reach the server."""
    with canned_server("text/html", b"<h1>Sign in</h1>") as (server, plane):
        for _ in range(2):
            assert fault_of(lambda: predict_once(plane)).code == "bad_answer"
        beat = Heartbeat(session_id="s")
        for _ in range(2):
            fault = fault_of(lambda: plane.heartbeat("r", "w", beat))
            assert fault.code == "bad_answer"
        assert server.connections == 4


@pytest.mark.parametrize(
    ("lease_s", "repeated_s", "silence_s"),
    [
        (1.0, 300.0, 10.0),
        (30.0, 300.0, 15.0),
        (600.0, 300.0, 60.0),
        (30.0, 0.0, 60.0),
        (30.0, 40.0, 20.0),
    ],
)
def test_a_silent_connection_is_left_in_time_for_the_lease(
    lease_s: float, repeated_s: float, silence_s: float
) -> None:
    with canned_server(JSON, ENCODED) as (_, plane):
        for _ in range(2):  # before a connection is made, and while it is open
            plane.limit_silence(lease_s, repeated_s)
            predict_once(plane)
            opened = plane.http_connection.sock
            assert isinstance(opened, socket.socket)
            assert opened.gettimeout() == silence_s


def test_a_refused_connection_counts_as_unreachable() -> None:
    with canned_server(JSON, ENCODED) as (server, plane):
        pass
    with pytest.raises(FAILURES) as caught:
        predict_once(plane)
    assert isinstance(caught.value, Exception)
    error = from_failure(caught.value, server.url)
    assert isinstance(error, ProctorError)
    assert (error.code, error.retryable) == ("unreachable", True)
