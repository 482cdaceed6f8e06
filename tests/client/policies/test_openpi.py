"""Policy servers that speak openpi's WebSocket protocol, called by `proctor run`.

The server here is ours, and writes its dialect by hand; GOLDEN was written by
openpi-client 0.1.2, which also read what we write.
"""

import threading
from collections.abc import Callable, Iterator
from contextlib import ExitStack, closing
from typing import Any

import msgspec
import numpy as np
import pytest
from websockets.sync.server import Server, ServerConnection, serve

from reference_client import ProctorError
from reference_client.policies.servers.websocket_client import WebsocketClient
from reference_client.policies.servers.wire_formats import BadMessage, pack, unpack
from reference_client.policies.servers.wire_settings import ServerSettings
from tests.support.client.command import Proctor, options
from tests.support.servers import TIMEOUT_S
from tests.support.waiting import wait_until

# {"actions": float32 2x3, "n": np.float64(1.5), "i": uint8, "t", "l", "b": bool}
GOLDEN = bytes.fromhex(
    "86a7616374696f6e7384c40b5f5f6e6461727261795f5fc3c40464617461c418000000000000803f"
    "0000004000004040000080400000a040c4056474797065a33c6634c4057368617065920203a16ecb"
    "3ff8000000000000a16984c40b5f5f6e6461727261795f5fc3c40464617461c4020102c405647479"
    "7065a37c7531c4057368617065920102a174a178a16c920181a161c0a16284c40b5f5f6e64617272"
    "61795f5fc3c40464617461c4020100c4056474797065a37c6231c40573686170659102"
)
MAPPING = """
[observation]
"observation/state" = { from = "state.vector" }
prompt = { from = "instruction" }
[action]
from = "actions"
[action.values]
score = { columns = "0:1" }
success = { value = 1 }
end = { columns = "1:2" }
delay_s = { value = 0 }
fault = { value = 0 }
vector = { value = [0, 0, 0, 0, 0, 0, 0, 0] }
clipped = { value = [0, 0] }
"""


def frame(**members: Any) -> bytes:
    """A map with one array, in the words of the dialect."""
    actions = np.array([[0.5, 0], [0.75, 1]], np.float32)
    array = {b"__ndarray__": True, b"data": actions.tobytes()}
    array |= {b"dtype": "<f4", b"shape": [2, 2]}
    return msgspec.msgpack.encode({"actions": array} | members)


class OpenpiServer:
    """A policy server: `answer` takes a request's bytes and its number."""

    def __init__(self, answer: Callable[[bytes, int], bytes | str | None]) -> None:
        self._answer = answer
        self.requests: list[Any] = []
        self.keys: list[str | None] = []
        self.close_codes: list[int | None] = []
        self._server: Server = serve(
            self._serve, "127.0.0.1", 0, compression=None, max_size=None
        )
        self.url = f"ws://127.0.0.1:{self._server.socket.getsockname()[1]}"
        threading.Thread(target=self._server.serve_forever, daemon=True).start()

    def _serve(self, socket: ServerConnection) -> None:
        try:
            self._answer_requests(socket)
        finally:
            self.close_codes.append(socket.protocol.close_code)

    def _answer_requests(self, socket: ServerConnection) -> None:
        assert socket.request is not None
        self.keys.append(socket.request.headers.get("Authorization"))
        socket.send(msgspec.msgpack.encode({"model": "fake"}))
        for request in socket:
            assert isinstance(request, bytes)
            self.requests.append(msgspec.msgpack.decode(request))
            answer = self._answer(request, len(self.requests))
            if answer is None:
                socket.close_socket()
                return
            socket.send(answer)
            if isinstance(answer, str):
                socket.close(1011)

    def close(self) -> None:
        self._server.shutdown()


@pytest.fixture
def start_server() -> Iterator[Callable[..., OpenpiServer]]:
    with ExitStack() as stack:
        yield lambda answer: stack.enter_context(closing(OpenpiServer(answer)))


def run(policies: str, *tasks: str, workers: int = 1) -> list[str]:
    flags = ["--policy", f"openpi:{policies}", "--mapping", "m.toml"]
    return ["run", "--no-dry-turn", *flags, *options(*tasks), "--workers", str(workers)]


# The dialect


def _array(data: bytes, **members: Any) -> bytes:
    named = {name.encode(): value for name, value in members.items()}
    return msgspec.msgpack.encode({b"__ndarray__": True, b"data": data, **named})


def test_what_openpi_writes_is_read() -> None:
    read = unpack(GOLDEN)
    assert read["actions"].tolist() == [[0, 1, 2], [3, 4, 5]]
    assert read["actions"].dtype == np.float32
    assert (read["n"], read["t"], read["l"]) == (1.5, "x", [1, {"a": None}])
    assert (read["i"].dtype, read["b"].tolist()) == (np.uint8, [True, False])
    assert pack(read) == GOLDEN
    assert unpack(pack({"n": np.int16(3)})) == {"n": 3}


@pytest.mark.parametrize(
    "message",
    [
        b"",
        b"\xc1",
        _array(b"1"),
        _array(b"12", dtype="<f4", shape=[1]),
        _array(b"", dtype="|O", shape=[0]),
    ],
)
def test_an_invalid_message_is_refused(message: bytes) -> None:
    """Cut, of no format, or an array of objects. Expect no array."""
    with pytest.raises(BadMessage, match="is not MessagePack with numpy arrays"):
        unpack(message)


# Evaluations


def test_a_policy_server_is_evaluated(
    proctor: Proctor,
    start_server: Callable[..., OpenpiServer],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Two workers, two turns in one chunk. Expect its score, its key and its words."""
    monkeypatch.setenv("OPENPI_API_KEY", "k")
    timed = frame(server_timing={"infer_ms": 1.0})
    policies = start_server(lambda _request, _number: timed)
    score = proctor.json(*run(policies.url, *["score"] * 4, workers=2))
    assert (proctor.code, score["score"]) == (0, 0.75)
    assert policies.keys == ["Api-Key k"] * 2
    request = policies.requests[0]
    assert request["prompt"] == "Calibration task score."
    assert request["observation/state"][b"dtype"] == "<f4"
    assert len(policies.requests) == 4


@pytest.mark.parametrize("flags", [[], ["--processes"]], ids=["threads", "processes"])
def test_a_policy_server_is_left_with_a_close_frame(
    proctor: Proctor, start_server: Callable[..., OpenpiServer], flags: list[str]
) -> None:
    """Expect code 1000 from each worker: openpi's server logs any other as an error."""
    policies = start_server(lambda _request, _number: frame())
    proctor.json(*run(policies.url, *["score"] * 4, workers=2), *flags)
    assert proctor.code == 0
    wait_until(lambda: len(policies.close_codes) == len(policies.keys), "both close")
    assert policies.close_codes == [1000] * 2


def test_a_closed_client_stays_closed(
    start_server: Callable[..., OpenpiServer],
) -> None:
    """Closed while the server computes. Expect an error, and no new connection."""
    entered, leave = threading.Event(), threading.Event()

    def answer(_request: bytes, _number: int) -> bytes:
        entered.set()
        leave.wait(TIMEOUT_S)
        return frame()

    policies = start_server(answer)
    client = WebsocketClient(policies.url, ServerSettings()).connected()

    def close() -> None:
        entered.wait(TIMEOUT_S)
        client.close()
        leave.set()

    threading.Thread(target=close).start()
    with pytest.raises(ProctorError, match="was left"):
        client.infer({})
    assert len(policies.keys) == 1


def test_a_lost_connection_is_opened_again(
    proctor: Proctor, start_server: Callable[..., OpenpiServer]
) -> None:
    """The server dies under its first request. Expect the request once more."""
    policies = start_server(lambda _request, number: None if number == 1 else frame())
    score = proctor.json(*run(policies.url, "score"))
    assert (proctor.code, score["score"]) == (0, 0.75)
    assert policies.requests[0] == policies.requests[1]


def test_a_remote_traceback_is_reported_in_one_line(
    proctor: Proctor, start_server: Callable[..., OpenpiServer]
) -> None:
    trace = "Traceback (most recent call last):\n  …\nKeyError: 'prompt'\n"
    policies = start_server(lambda _request, _number: trace)
    printed = proctor.json(*run(policies.url, "score"))
    assert proctor.code == 1
    assert "failed: KeyError: 'prompt'." in printed["error"]["detail"]
    assert "resume" in printed


@pytest.mark.parametrize(
    ("answer", "said"),
    [
        (b"\xc1", "is not MessagePack with numpy arrays"),
        (b"\xc1", "; it begins with b'\\xc1'"),
        (b"", "; it is empty"),
        (msgspec.msgpack.encode({"action": [1]}), "has no actions, but action"),
    ],
)
def test_an_answer_that_cannot_be_read_ends_it(
    proctor: Proctor,
    start_server: Callable[..., OpenpiServer],
    answer: bytes,
    said: str,
) -> None:
    policies = start_server(lambda _request, _number: answer)
    printed = proctor.json(*run(policies.url, "score"))
    assert (proctor.code, said in printed["error"]["detail"]) == (1, True)


def test_a_url_without_a_host_is_refused() -> None:
    with pytest.raises(ProctorError, match="invalid WebSocket URL"):
        WebsocketClient("ws://", ServerSettings()).infer({})
