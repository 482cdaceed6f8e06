"""Policy servers that speak GR00T's protocol over ZeroMQ, called by `proctor run`.

The server here is ours, and writes frames by hand; LIBZMQ_HELLO and GOLDEN were
written by libzmq 4.3.5 and msgpack 1.1, as GR00T's server uses them.
"""

import contextlib
import socket
import struct
import threading
from collections.abc import Callable, Iterator
from contextlib import ExitStack, closing
from pathlib import Path
from typing import Any

import msgspec
import numpy as np
import pytest

from reference_client import ProctorError
from reference_client.command.runs import running
from reference_client.policies import BadPolicy, PolicyMapping, load
from reference_client.policies.servers.gr00t.gr00t_client import Gr00tClient
from reference_client.policies.servers.gr00t.npy_messages import (
    BadNpyMessage,
    pack,
    unpack,
)
from reference_client.policies.servers.gr00t.zmq_requester import (
    NotZeroMq,
    ZmqAnswerTimeout,
    ZmqRequester,
)
from tests.support.client.command import Proctor, options
from tests.support.network.accepting_server import AcceptingServer
from tests.support.servers import TIMEOUT_S

# A greeting of ZMTP 3.1 with NULL, and READY of a REP socket.
LIBZMQ_HELLO = (
    bytes.fromhex("ff00000000000000017f03014e554c4c").ljust(64, b"\0")
    + b"\x04\x19\x05READY\x0bSocket-Type\x00\x00\x00\x03REP"
)
# A pair: the actions `arm`, float32 (1, 2, 2), and no information.
GOLDEN = (
    bytes.fromhex(
        "9281a361726d82b15f5f6e6461727261795f636c6173735f5fc3a661735f6e7079c490"
    )
    + b"\x93NUMPY\x01\x00v\x00"
    + b"{'descr': '<f4', 'fortran_order': False, 'shape': (1, 2, 2), }"
    + b" " * 55
    + b"\n"
    + bytes.fromhex("0000003f000000000000403f0000803f80")
)
MAPPING = """
[observation]
"state.arm" = { from = "state.vector" }
"video.front" = { value = 0 }
"language.task" = { from = "instruction" }
[action.values]
score = { from = "arm", columns = "0:1" }
success = { value = 1 }
end = { from = "arm", columns = "1:2" }
delay_s = { value = 0 }
fault = { value = 0 }
vector = { value = [0, 0, 0, 0, 0, 0, 0, 0] }
clipped = { value = [0, 0] }
"""
Answer = Callable[[dict[str, Any], int], bytes | None]


def config(**steps: int) -> bytes:
    """The answer to get_modality_config. steps: of a group, 1 without it."""
    keys = {"video": ["front"], "state": ["arm"], "language": ["task"]}
    groups = {}
    for group, names in keys.items():
        indices = list(range(steps.get(group, 1)))
        said = {"modality_keys": names, "delta_indices": indices}
        groups[group] = {"__ModalityConfig_class__": True, "as_json": said}
    return msgspec.msgpack.encode(groups)


def answer_calls(request: dict[str, Any], _number: int) -> bytes:
    answers = {"get_modality_config": config(), "get_action": GOLDEN}
    return answers.get(request["endpoint"], b"\x80")


class RepServer(AcceptingServer):
    """A REP socket: `answer` takes a request and its number; None closes instead."""

    def __init__(self, answer: Answer, hello: bytes = LIBZMQ_HELLO) -> None:
        self._answer = answer
        self._hello = hello
        self.requests: list[dict[str, Any]] = []
        super().__init__(self._answer_all)
        self.address = f"127.0.0.1:{self.port}"

    def _answer_all(self, client: socket.socket) -> None:
        with client.makefile("rb") as received:
            client.sendall(self._hello)
            greeting, ready = received.read(64), received.read(2 + 25)
            assert greeting[:12] == b"\xff" + bytes(8) + b"\x7f\x03\x00"
            if not ready:
                return  # the client has left a server of another protocol
            assert ready.endswith(b"Socket-Type\x00\x00\x00\x03REQ")
            while received.read(2) == b"\x01\x00":
                self.requests.append(msgspec.msgpack.decode(self._body(received)))
                answer = self._answer(self.requests[-1], len(self.requests))
                if answer is None:
                    return
                # A command between the frames, as a heartbeat would be.
                client.sendall(b"\x04\x05\x04PING" + b"\x01\x00")
                client.sendall(b"\x02" + struct.pack(">Q", len(answer)) + answer)

    def _body(self, received: Any) -> bytes:
        digits = 8 if received.read(1) == b"\x02" else 1
        body: bytes = received.read(int.from_bytes(received.read(digits)))
        return body


@pytest.fixture
def start_server() -> Iterator[Callable[..., RepServer]]:
    with ExitStack() as stack:
        yield lambda answer=answer_calls, hello=LIBZMQ_HELLO: stack.enter_context(
            closing(RepServer(answer, hello))
        )


def run(address: str, *tasks: str, workers: int = 1) -> list[str]:
    flags = ["--policy", f"gr00t:{address}", "--mapping", "m.toml"]
    return ["run", "--no-dry-turn", *flags, *options(*tasks), "--workers", str(workers)]


# The messages


def test_what_gr00t_writes_is_read() -> None:
    actions, information = unpack(GOLDEN)
    arm = actions["arm"]
    assert (arm.dtype, arm.tolist()) == (np.float32, [[[0.5, 0], [0.75, 1]]])
    assert information == {}
    assert pack([actions, information]) == GOLDEN


@pytest.mark.parametrize("order", ["C", "F"])
def test_arrays_are_read_as_they_were(order: Any) -> None:
    array = np.asarray(np.arange(6, dtype=">i2").reshape(2, 3), order=order)
    assert unpack(pack({"a": array}))["a"].tolist() == array.tolist()


def _npy(header: str, data: bytes = b"", version: bytes = b"\x01\x00") -> bytes:
    file = b"\x93NUMPY" + version + struct.pack("<H", len(header)) + header.encode()
    return msgspec.msgpack.encode({"__ndarray_class__": True, "as_npy": file + data})


@pytest.mark.parametrize(
    "message",
    [
        b"",
        GOLDEN[:-20],
        b"\x91" * 5000 + b"\xc0",
        msgspec.msgpack.encode({"__ndarray_class__": True}),
        msgspec.msgpack.encode({"__ndarray_class__": True, "as_npy": "text"}),
        msgspec.msgpack.encode({"__ndarray_class__": True, "as_npy": b"PK\x03\x04"}),
        _npy("{'descr': '|O', 'fortran_order': False, 'shape': (1,)}\n", b"cos\n."),
        _npy("{'descr': '<f4', 'fortran_order': False, 'shape': (9**18,)}\n"),
        _npy("{'descr': '<f4', 'fortran_order': False, 'shape': (999999999999,)}\n"),
        _npy("{'descr': '<f4', 'fortran_order': False, 'shape': (1,)}\n", b"123456"),
        _npy("", version=b"\x03\x00"),
        _npy("{'descr': (\n"),
        _npy("\n  x\n y"),
    ],
)
def test_an_invalid_message_is_refused(message: bytes) -> None:
    """Cut, nested, no .npy file, objects, a size that is not there. Expect no array."""
    with pytest.raises(BadNpyMessage, match="GR00T"):
        unpack(message)


def test_unsupported_objects_are_not_sent() -> None:
    with pytest.raises(TypeError, match="not supported"):
        pack({"x": object()})
    with pytest.raises(ValueError, match="Object arrays"):
        pack({"x": np.array([object()])})


# The connection


@pytest.mark.parametrize(
    ("hello", "said"),
    [
        (
            b"HTTP/1.1 400 Bad Request\r\n\r\n",
            "is no ZeroMQ server: it sent b'HTTP/1.1 400",
        ),
        (LIBZMQ_HELLO.replace(b"NULL", b"CURV"), "another version or mechanism"),
        (LIBZMQ_HELLO.replace(b"\x7f\x03", b"\x7f\x01"), "another version or mech"),
        (LIBZMQ_HELLO[:64] + b"\x04\x06\x05ERROR", "refused the connection"),
        (LIBZMQ_HELLO[:64] + b"\x02" + b"\x7f" * 8, "announced a frame of"),
    ],
)
def test_another_protocol_is_reported(
    start_server: Callable[..., RepServer], hello: bytes, said: str
) -> None:
    host, port = start_server(hello=hello).address.split(":")
    with pytest.raises(NotZeroMq, match=said):
        ZmqRequester(host, int(port), answer_s=TIMEOUT_S)


@contextlib.contextmanager
def requester_of(hello: bytes, answers: list[bytes]) -> Iterator[ZmqRequester]:
    """Connected to a server that answers one request with each of these."""

    def answer_all(client: socket.socket) -> None:
        with client.makefile("rb") as received:
            client.sendall(hello)
            received.read(64 + 2 + 25)
            for answer in answers:
                received.read(2 + 3)  # the empty frame, and one of a byte
                client.sendall(answer)
            received.read()  # until the requester leaves

    with (
        closing(AcceptingServer(answer_all)) as server,
        closing(
            ZmqRequester("127.0.0.1", server.port, answer_s=TIMEOUT_S)
        ) as requester,
    ):
        yield requester


def test_the_limit_is_one_for_the_whole_answer() -> None:
    """A byte comes again and again, always in time. Expect the end at the limit."""
    is_over = threading.Event()

    def drip(client: socket.socket) -> None:
        client.sendall(LIBZMQ_HELLO)
        client.makefile("rb").read(64 + 2 + 25 + 5)
        client.sendall(b"\x01\x00\x00\xff")
        while not is_over.wait(0.02):
            client.sendall(b"x")

    with (
        closing(AcceptingServer(drip)) as server,
        closing(ZmqRequester("127.0.0.1", server.port, answer_s=0.2)) as requester,
        pytest.raises((TimeoutError, ZmqAnswerTimeout)),
    ):
        requester.request(b"x")
    is_over.set()


@pytest.mark.parametrize("parts", [b"\x00\x01x", b"\x01\x00" * 9])
def test_a_message_of_several_parts_is_refused(parts: bytes) -> None:
    """Not of this pattern: no empty frame first, or frames without end."""
    with (
        requester_of(LIBZMQ_HELLO, [parts]) as requester,
        pytest.raises(NotZeroMq, match="parts"),
    ):
        requester.request(b"x")


def test_a_message_without_a_request_is_refused() -> None:
    """A command, then each answer twice. Expect the first one alone."""
    answers = [b"\x01\x00\x00\x01x" * 2]
    with requester_of(LIBZMQ_HELLO + b"\x04\x05\x04PING", answers) as requester:
        assert requester.request(b"x") == b"x"
        with pytest.raises(NotZeroMq, match="for which there was no request"):
            requester.request(b"x")


# Evaluations


def test_a_policy_server_is_evaluated(
    proctor: Proctor,
    start_server: Callable[..., RepServer],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Two workers, chunks of two. Expect the score, groups, batch, time and token."""
    monkeypatch.setenv("GR00T_API_TOKEN", "k")
    policies = start_server()
    score = proctor.json(*run(policies.address, *["score"] * 4, workers=2))
    assert (proctor.code, score["score"]) == (0, 0.75)
    endpoints = [one["endpoint"] for one in policies.requests]
    assert endpoints.count("get_modality_config") == 2
    assert endpoints.count("reset") == endpoints.count("get_action") == 4
    assert {one["api_token"] for one in policies.requests} == {"k"}
    first = next(o for o in policies.requests if o["endpoint"] == "get_action")
    data = unpack(msgspec.msgpack.encode(first["data"]))
    seen = data["observation"]
    arm = seen["state"]["arm"]
    assert (arm.shape, arm.dtype) == ((1, 1, 8), np.float32)
    assert seen["language"] == {"task": [["Calibration task score."]]}
    assert (seen["video"]["front"].shape, data["options"]) == ((1, 1), None)


@pytest.mark.parametrize("flags", [(), ("--processes",)])
def test_a_server_that_is_slow_before_the_run_is_said(
    proctor: Proctor,
    start_server: Callable[..., RepServer],
    monkeypatch: pytest.MonkeyPatch,
    flags: tuple[str, ...],
) -> None:
    """It answers as soon as the command has said that it is waited for."""
    is_said, lines = threading.Event(), list[str]()

    def say(_command: Any, line: str) -> None:
        lines.append(line)
        is_said.set()

    def answer(request: dict[str, Any], number: int) -> bytes:
        assert is_said.wait(TIMEOUT_S)
        return answer_calls(request, number)

    monkeypatch.setattr(running._EvaluationCommand, "_say_wait", say)
    monkeypatch.setattr(running, "FIRST_S", 0.0)
    policies = start_server(answer)
    proctor.json(*run(policies.address, "score"), *flags)
    source = "worker-0" if flags else "the first contact"
    said = f"s: {source}: The policy server at {policies.address} has not answered yet."
    assert (proctor.code, lines[0].endswith(said)) == (0, True), lines


def test_a_lost_connection_is_opened_again(
    proctor: Proctor, start_server: Callable[..., RepServer]
) -> None:
    """The server dies under its third request. Expect the request once more, after
    what it reads."""

    def answer(request: dict[str, Any], number: int) -> bytes | None:
        return None if number == 3 else answer_calls(request, number)

    policies = start_server(answer)
    score = proctor.json(*run(policies.address, "score"))
    assert (proctor.code, score["score"]) == (0, 0.75)
    assert policies.requests[2] == policies.requests[4]
    assert policies.requests[3] == policies.requests[0]


def test_another_policy_after_a_restart_ends_the_run(
    start_server: Callable[..., RepServer],
) -> None:
    """It dies under its second request, and then reads other state."""

    def answer(_request: dict[str, Any], number: int) -> bytes | None:
        if number == 2:
            return None
        return config() if number == 1 else config().replace(b"arm", b"leg")

    policies = start_server(answer)
    keys = ["video.front", "state.arm", "language.task"]
    client = Gr00tClient.connect_to(policies.address, keys)
    said = r"says state\.modality_keys = \['leg'\] on a new .*, and said .*\['arm'\]"
    with closing(client), pytest.raises(ProctorError, match=said):
        client.begin_episode(None)
    assert len(policies.requests) == 3


@pytest.mark.parametrize(
    ("answer", "said"),
    [
        (b"\xc1", "is not GR00T's MessagePack"),
        (b"\xc1\xc1", "; it begins with b'\\xc1\\xc1'"),
        (b"\x80", "answered get_action without a pair of maps, but with {}"),
        (b"ERROR", "failed; its own log has the reason."),
        (msgspec.msgpack.encode({"error": "'front'"}), "failed: 'front'."),
        (msgspec.msgpack.encode({"exception": "'top'"}), "failed: 'top'."),
        (msgspec.msgpack.encode({"code": 5, "msg": "'top'"}), "says: 'top'. The "),
        (msgspec.msgpack.encode([{"error": "'top'"}, {}]), "says: 'top'. "),
        (GOLDEN.replace(b"arm", b"leg"), "has no arm, but leg"),
        (pack([{"arm": np.zeros((2, 16, 2))}, {}]), "the shape (2, 16, 2) in `arm`"),
        (pack({"action.arm": np.ones(2)}), "maps, but with {'action.arm': float64 (2"),
    ],
)
def test_an_answer_that_cannot_be_read_ends_it(
    proctor: Proctor, start_server: Callable[..., RepServer], answer: bytes, said: str
) -> None:
    def answer_actions(request: dict[str, Any], number: int) -> bytes:
        is_action = request["endpoint"] == "get_action"
        return answer if is_action else answer_calls(request, number)

    policies = start_server(answer_actions)
    printed = proctor.json(*run(policies.address, "score"))
    assert proctor.code == 1
    assert said in printed["error"]["detail"]


@pytest.mark.parametrize("value", [None, "k"])
def test_a_refused_token_is_named_with_its_variable(
    start_server: Callable[..., RepServer],
    value: str | None,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    refusal = msgspec.msgpack.encode({"error": "Unauthorized: Invalid API token"})
    policies = start_server(lambda _request, _number: refusal)
    if value is None:
        monkeypatch.delenv("GR00T_API_TOKEN", raising=False)
    else:
        monkeypatch.setenv("GR00T_API_TOKEN", value)
    end = r"which is set\." if value else "which is not set, so no key was sent"
    said = f"Invalid API token; its key is taken from GR00T_API_TOKEN, {end}"
    with pytest.raises(ProctorError, match=said):
        Gr00tClient.connect_to(policies.address, [])


@pytest.mark.parametrize(
    ("described", "said"),
    [
        (config(video=2), "reads 2 time steps of video"),
        (b"\x80", "described no video, state and language"),
        (config().replace(b"front", b"wrist"), "reads .*video.wrist; the mapping has "),
    ],
)
def test_a_policy_that_reads_something_else_leaves_no_run(
    proctor: Proctor,
    start_server: Callable[..., RepServer],
    described: bytes,
    said: str,
) -> None:
    policies = start_server(lambda _request, _number: described)
    before = proctor.json("status")
    proctor.json(*run(policies.address, "score"))
    assert proctor.code == 2
    assert proctor.json("status") == before
    keys = ["video.front", "state.arm", "language.task"]
    with pytest.raises((BadPolicy, ProctorError), match=said):
        Gr00tClient.connect_to(policies.address, keys)


def test_a_closed_client_stays_closed(start_server: Callable[..., RepServer]) -> None:
    """Closed while the server computes. Expect an error, and no further request."""
    entered, leave = threading.Event(), threading.Event()

    def answer(_request: dict[str, Any], _number: int) -> bytes:
        entered.set()
        leave.wait(TIMEOUT_S)
        return b"\x80"

    policies = start_server(answer)
    host, port = policies.address.split(":")
    client = Gr00tClient(host, int(port))

    def close() -> None:
        entered.wait(TIMEOUT_S)
        client.close()

    threading.Thread(target=close).start()
    with pytest.raises(ProctorError, match="was left"):
        client.begin_episode(None)
    leave.set()
    assert len(policies.requests) == 1


@pytest.mark.parametrize(
    ("reference", "table", "said"),
    [
        ("gr00t:localhost", MAPPING, "takes an address like gr00t:127.0.0.1:5555"),
        ("gr00t:localhost:70000", MAPPING, "takes an address like"),
        ("gr00t:[::1]:5555", None, "gr00t: needs --mapping FILE"),
        ("gr00t:h:1", MAPPING.replace("video.", "image."), "not 'image.front'"),
    ],
)
def test_a_wrong_reference_is_refused(
    tmp_path: Path, reference: str, table: str | None, said: str
) -> None:
    mapping = None
    if table is not None:
        (tmp_path / "m.toml").write_text(table)
        mapping = PolicyMapping.read(tmp_path / "m.toml")
    with pytest.raises(BadPolicy, match=said):
        load(reference, mapping)
