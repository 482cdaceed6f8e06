"""Policy servers of other projects, each with its mapping of the manual.

The servers are ours, and speak the wire of the public sources (policy_wires.py). The
messages about a server of another protocol are tested here, too.
"""

import contextlib
import errno
import itertools
import re
import socket
import threading
import tomllib
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
import pytest
from websockets.sync.server import serve

from reference_client import ProctorError
from reference_client.policies import BadMapping, BadPolicy, PolicyMapping, load
from reference_client.policies.policy_loader import close_policy
from reference_client.policies.servers.http_policy_client import HttpPolicyClient
from reference_client.policies.servers.server_faults import error_text
from reference_client.policies.servers.server_transport import reporting_repeats
from reference_client.policies.servers.wire_formats import FORMATS, pack, unpack
from reference_client.policies.servers.wire_settings import ServerSettings
from tests.support.client.policy_wires import (
    JOINTS,
    READY,
    TRACE,
    WIRES,
    connected,
    decode,
    encode,
    observation,
    openpi,
    play,
    simplerenv,
    start_http,
    start_websocket,
    start_wire,
    vla_eval,
)
from tests.support.network.accepting_server import AcceptingServer
from tests.support.servers import TIMEOUT_S

DRY = "dry-e0000"


def rounded(chunk: list[Any]) -> list[dict[str, list[float]]]:
    return [{n: np.round(v, 4).tolist() for n, v in one.items()} for one in chunk]


STILL = {"joint_position": JOINTS, "gripper": [0.25]}
EACH_TURN = ["infer"] * 4


@pytest.mark.parametrize(
    ("name", "chunk", "log"),
    [
        ("droid", [{"joint_position": JOINTS, "gripper": [0.0]}] * 8, EACH_TURN),
        (
            "roboarena",
            [{"joint_position": JOINTS, "gripper": [0.0]}],
            [("reset", DRY), ("infer", DRY), ("infer", DRY)] * 2,
        ),
        ("starvla", [STILL] * 3, EACH_TURN),
        (
            "internvla",
            [{"ee_delta": [1, 2, 3, 4, 5, 6], "gripper": [0.5]}],
            [("reset", "a"), "infer", "infer", ("reset", "b"), "infer", "infer"],
        ),
        (
            "vla_eval",
            [STILL],
            [
                *("hello", "episode_start", {"task": {"name": "a"}}),
                *("observation", "observation", "episode_end"),
                *("episode_start", {"task": {"name": "b"}}),
                *("observation", "observation"),
            ],
        ),
        (
            "positronic",
            [STILL | {"gripper": [0.0]}, STILL | {"gripper": [0.5]}],
            ["session", *["session", 0, 50_000_000] * 2],
        ),
        ("xvla", [STILL] * 10, EACH_TURN),
        (
            "simplerenv",
            [{"joint_position": [0, 1, 2, 3, 4, 5, 6], "gripper": [1.0]}],
            [("reset", b""), "infer", "infer"] * 2,
        ),
    ],
)
def test_documented_servers_play(name: str, chunk: list[Any], log: list[Any]) -> None:
    """Two episodes of two turns. Expect its actions, and that it forgets in between."""
    with start_wire(name) as (reference, noted), connected(reference, READY[name]) as p:
        assert rounded(play(p, "a", "b")) == chunk
    assert noted == log


@pytest.mark.parametrize(
    ("status", "is_right"), [(200, True), (204, True), (302, False), (404, False)]
)
def test_a_reset_over_http_may_have_no_answer(status: int, is_right: bool) -> None:
    def talk(path: str, body: bytes, log: list[Any]) -> tuple[int, Any]:
        return (status, b"") if path == "/reset" else simplerenv(path, body, log)

    refused = pytest.raises(ProctorError, match=f"/reset answered {status}")
    with (
        start_http(talk) as (address, _),
        connected(f"http://{address}/query", READY["simplerenv"]) as policy,
        contextlib.nullcontext() if is_right else refused,
    ):
        assert len(play(policy, "a")) == 1


def test_every_documented_policy_server_is_played() -> None:
    assert set(READY) - set(WIRES) == {"gr00t"}


def test_a_wrapped_command_is_found() -> None:
    text = READY["positronic"].replace("command.pos", "command.__cmd__.pos")
    with start_wire("positronic") as (reference, _), connected(reference, text) as p:
        assert rounded(play(p, "wrapped"))[0]["joint_position"] == JOINTS


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("starvla", "failed: unnorm_key not specified."),
        ("vla_eval", "failed: observation_failed: KeyError: 'proprio'."),
        ("positronic", r"failed: Shape mismatch: expected \(7,\)."),
        ("xvla", "answered 422: body.proprio: Field required."),
        ("simplerenv", "failed: KeyError: 'proprio'."),
    ],
)
def test_the_error_text_of_a_server_is_shown(name: str, said: str) -> None:
    with start_wire(name) as (reference, _), connected(reference, READY[name]) as p:
        with pytest.raises(ProctorError, match=said) as caught:
            play(p, "fail")
        assert caught.value.code == "policy_failed"


@pytest.mark.parametrize(
    ("value", "text"),
    [
        ({"error": {"message": "out of memory"}}, "out of memory"),
        ({"ok": False, "msg": "no model"}, "no model"),
        ({"status": "error", "detail": {"reason": "x"}}, "x"),
        ({"error": ["a", {"message": "b"}]}, "a; b"),
        ({"traceback": TRACE}, "KeyError: 'proprio'"),
        (
            TRACE.replace("KeyError: 'pro", "jax.Error: two\nlines 'pro"),
            "jax.Error: two",
        ),
        ({"ok": False, "x": 1}, "{'ok': False, 'x': 1}"),
        ("plain\ntext", "plain text"),
    ],
)
def test_an_error_text_is_found_wherever_it_stands(value: Any, text: str) -> None:
    assert error_text(value).startswith(text)


@pytest.mark.parametrize(
    ("name", "expected", "said"),
    [
        (
            "roboarena",
            'action_space = "joint_velocity"',
            "says action_space = 'joint_p",
        ),
        ("starvla", "training_obs_image_size = [256, 256]", "size = \\[224, 224\\]"),
        ("vla_eval", '"action_spec.gripper.format" = "binary"', "format = 'raw'"),
        ("positronic", '"meta.action_fps" = 30.0', "says meta.action_fps = 20.0"),
        ("droid", 'no_such = "x"', "says no_such = None; the mapping expects 'x'"),
    ],
)
def test_unexpected_metadata_are_refused(name: str, expected: str, said: str) -> None:
    document = tomllib.loads(READY[name])
    server = document.get("server", {}) | {"expect": tomllib.loads(expected)}
    mapping = PolicyMapping.of(document | {"server": server})
    with start_wire(name) as (reference, _), pytest.raises(BadPolicy, match=said):
        load(reference, mapping)()


def test_a_model_server_that_restarts_is_sent_the_episode_again() -> None:
    """It closes under its second observation. Expect hello and episode_start again."""
    closed: list[bool] = []

    def talk(connection: Any, log: list[Any]) -> None:
        if not closed:
            closed.append(True)

            class Once:
                def __iter__(self) -> Iterator[Any]:
                    for frame in connection:
                        if log.count("observation") == 1:
                            return
                        yield frame

                send = connection.send

            vla_eval(Once(), log)  # type: ignore[arg-type]
        else:
            vla_eval(connection, log)

    with (
        start_websocket(talk) as (address, log),
        connected(f"vla-eval:ws://{address}", READY["vla_eval"]) as policy,
    ):
        assert rounded(play(policy, "a")) == [STILL]
    begin = ["hello", "episode_start", {"task": {"name": "a"}}, "observation"]
    assert log == begin * 2


def restarts(*greetings: Any) -> Callable[[Any, list[Any]], None]:
    """A server of vla-eval or openpi that closes under the first request of each
    connection but the last, and greets each with another of these."""

    def talk(connection: Any, log: list[Any]) -> None:
        greeting = greetings[len(log)]
        log.append(greeting)
        is_hello = "payload" in greeting
        if not is_hello:
            connection.send(encode(greeting))
        for frame in connection:
            message = decode(frame)
            if message.get("type") == "hello":
                connection.send(encode(greeting | {"seq": message["seq"]}))
            elif len(log) < len(greetings):
                return
            elif not is_hello:
                connection.send(encode({}))
            elif message["type"] == "observation":
                answer = {"type": "action", "payload": {}, "seq": message["seq"]}
                connection.send(encode(greeting | answer))

    return talk


def hello(**payload: Any) -> dict[str, Any]:
    return {"type": "hello", "payload": payload, "timestamp": 0.5}


VARYING = '[server]\nvarying = ["session"]\n'


@pytest.mark.parametrize(
    ("source", "greetings", "server", "said"),
    [
        (
            "openpi:ws://{}",
            [{"model": "x"}, {"model": "y"}],
            "",
            "says model = 'y' on a new connection, and said model = 'x' on the first",
        ),
        ("ws://{}", [{"a": {"b": 1}}, {}], "", r"no a\.b on a new .* said a\.b = 1"),
        ("ws://{}", [{}, {"a": [1]}], "", r"says a = \[1\] .* and said no a on"),
        ("ws://{}", [{"session": 1}, {"session": 2}], "", "`varying` in .server"),
        ("ws://{}", [{"session": 1}, {"session": 2}, {}], VARYING, None),
        ("openpi:ws://{}", [{"m": [1, {"x": 0.5}]}] * 3, "", None),
        (
            "vla-eval:ws://{}",
            [hello(spec={"dims": 7}), hello(spec={"dims": 8})],
            "",
            "says spec.dims = 8 on a new connection, and said spec.dims = 7",
        ),
        ("vla-eval:ws://{}", [hello(spec=1)] * 2, "", None),
    ],
)
def test_each_connection_is_greeted_as_the_first_one_was(
    source: str, greetings: list[Any], server: str, said: str | None
) -> None:
    """A score is that of one policy. Expect the end of the run, or an answer."""
    with (
        start_websocket(restarts(*greetings)) as (address, log),
        connected(source.format(address), MAPPING + server) as policy,
    ):
        policy.reset("x")
        if said is None:
            assert len(policy.act(observation())) == 1
        else:
            with pytest.raises(ProctorError, match=said) as caught:
                policy.act(observation())
            assert caught.value.code == "policy_failed"
    assert log == greetings


def test_workers_are_greeted_alike() -> None:
    """Two servers stand behind one address. Expect no run."""
    with start_websocket(restarts({"model": "x"}, {"model": "y"})) as (address, _):
        mapping = PolicyMapping.of(tomllib.loads(MAPPING))
        make = load(f"openpi:ws://{address}", mapping)
        first = make()
        with pytest.raises(ProctorError, match="says model = 'y'"):
            make()
        close_policy(first)


def head_of(status: int, media_type: str, body: bytes) -> bytes:
    lines = f"HTTP/1.1 {status} X\r\nContent-Type: {media_type}\r\n"
    return f"{lines}Content-Length: {len(body)}\r\n\r\n".encode() + body


@pytest.mark.parametrize(
    ("status", "media_type", "body", "said"),
    [
        (200, "text/plain", b"error", "; it begins with 'error' (text/plain)."),
        (200, "text/html", b"<p>login</p>", "with '<p>login</p>' (text/html)."),
        (200, "application/json", b"", "; it is empty (application/json)."),
        (
            200,
            "a/b; charset=gbk",
            "显存".encode("gbk"),
            "with '显存' (a/b; charset=gbk)",
        ),
        (200, "x/y", b"\xff\x00\x01", r"with b'\xff\x00\x01' (x/y)."),
        (
            500,
            "text/html",
            b"<p>no</p>",
            "500; it begins with '<p>no</p>' (text/html).",
        ),
        (500, "text/plain", b"a\nb", "answered 500: a b."),
        (500, "text/plain; charset=utf-16", "läuft".encode("utf-16"), "500: läuft."),
        (
            500,
            "application/json; charset=gbk",
            '{"error": "显存不足"}'.encode("gbk"),
            "500: 显存不足.",
        ),
        (500, "text/plain; charset=no-such", b"x", "answered 500: x."),
    ],
)
def test_what_a_server_sent_is_shown(
    status: int, media_type: str, body: bytes, said: str
) -> None:
    """An answer that cannot be read, and an error in another charset."""

    def talk(client: socket.socket) -> None:
        client.recv(65536)
        client.sendall(head_of(status, media_type, body))

    with start(talk) as address:
        client = HttpPolicyClient(
            f"http://{address}/act", ServerSettings(format="json")
        )
        with pytest.raises(ProctorError) as caught:
            client.infer({})
        client.close()
    assert said in caught.value.detail


# The wrong server, and one that does not answer

SERVERS = "reference_client.policies.servers"
MAPPING = """
[observation]
x = { from = "state.gripper" }
[action.values]
gripper = { value = [0] }
"""
WAITS = MAPPING + "[server]\ngreeting = false\n"


def says(words: bytes, *, is_open: bool = True) -> Callable[[socket.socket], None]:
    """A server on TCP that speaks first, then reads to the end or closes."""

    def talk(client: socket.socket) -> None:
        client.sendall(words)
        while is_open and client.recv(4096):
            pass

    return talk


def http_1_0(client: socket.socket) -> None:
    client.recv(4096)
    client.sendall(b"HTTP/1.0 404 Not Found\r\nContent-Length: 0\r\n\r\n")


def answers(words: bytes) -> Callable[[socket.socket], None]:
    """A server on TCP that reads a request, answers these bytes and closes."""

    def talk(client: socket.socket) -> None:
        client.recv(4096)
        client.sendall(words)

    return talk


def redirects(status: bytes, place: bytes) -> Callable[[socket.socket], None]:
    return answers(
        b"HTTP/1.1 " + status + b" X\r\nLocation: " + place + b"\r\n"
        b"Content-Length: 0\r\n\r\n"
    )


def closes_with(code: int, reason: str) -> Callable[[Any, Any], None]:
    """A WebSocket server that closes when it has read a message."""

    def talk(connection: Any, _log: Any) -> None:
        connection.recv()
        connection.close(code, reason)

    return talk


def closes_first(code: int, reason: str) -> Callable[[Any, Any], None]:
    def talk_closes_with(connection: Any, _log: Any) -> None:
        connection.close(code, reason)

    return talk_closes_with


def waits(connection: Any, _log: Any) -> None:
    for _ in connection:
        pass


def greets(connection: Any, _log: Any) -> None:
    connection.send(b"\x80")
    waits(connection, _log)


ZMQ = says(b"\xff" + bytes(8) + b"\x7f")
GRPC = says(b"\x00\x00\x12\x04\x00\x00\x00\x00\x00")
SILENT, CLOSING, SSH = says(b""), says(b"", is_open=False), says(b"SSH-2.0-x\r\n")


@contextlib.contextmanager
def start(talk: Any) -> Iterator[str]:
    if talk in (waits, greets, greets_with_error) or "closes_with" in getattr(
        talk, "__qualname__", ""
    ):
        with start_websocket(talk) as (address, _):
            yield address
    elif isinstance(talk, tuple):
        with start_http(lambda _path, _body, _log: talk) as (address, _):
            yield address
    else:
        with contextlib.closing(AcceptingServer(talk)) as server:
            yield f"127.0.0.1:{server.port}"


@pytest.fixture
def short_limits(monkeypatch: pytest.MonkeyPatch) -> None:
    for name in ("OPEN_S", "GREETING_S"):
        monkeypatch.setattr(f"{SERVERS}.websocket_client.{name}", 0.2)
    for name in ("CONNECT_S", "FIRST_ANSWER_S"):
        monkeypatch.setattr(f"{SERVERS}.http_policy_client.{name}", 0.2)
    monkeypatch.setattr(f"{SERVERS}.policy_server_client.FIRST_ANSWER_S", 0.2)
    for module in ("websocket_client", "http_policy_client", "policy_server_client"):
        monkeypatch.setattr(f"{SERVERS}.{module}.FIRST_CONTACT_S", 0.0)
    monkeypatch.setattr(f"{SERVERS}.gr00t.gr00t_client.FIRST_CONTACT_S", 0.0)
    monkeypatch.setattr(f"{SERVERS}.gr00t.zmq_requester.CONNECT_S", 0.2)
    monkeypatch.setattr(f"{SERVERS}.server_faults._PROBE_S", 0.1)


@pytest.mark.parametrize(
    ("source", "talk", "said"),
    [
        ("openpi:ws://{}", waits, "no greeting .* to speak first: .* vla-eval:URL"),
        ("openpi:ws://{}", SILENT, "did not answer .* says nothing; it is busy"),
        ("openpi:ws://{}", CLOSING, "closed the connection|closes connections"),
        ("openpi:ws://{}", ZMQ, "it speaks ZeroMQ, as GR00T's"),
        ("openpi:ws://{}", SSH, "it speaks SSH"),
        ("openpi:ws://{}", GRPC, "it speaks HTTP/2, as gRPC does"),
        ("openpi:ws://127.0.0.1:9", SILENT, "127.0.0.1:9 is unreachable .Connection r"),
        ("gr00t:127.0.0.1:9", SILENT, "127.0.0.1:9 is unreachable .Connection refused"),
        (
            "openpi:ws://{}",
            (404, {"detail": "Not Found"}),
            "HTTP server without a WebSock",
        ),
        (
            "openpi:ws://{}",
            (401, {"detail": "who"}),
            "401 Unauthorized.*which is not set",
        ),
        ("openpi:ws://{}", (503, b"loading"), "answered the .* with 503 .*: loading"),
        (
            "openpi:ws://{}",
            redirects(b"302", b"ws://u:s3cret@other.example:1/x"),
            "answered 302: it is at ws://other.example:1/x",
        ),
        (
            "vla-eval:ws://{}",
            redirects(b"308", b"/ws"),
            r"answered 308: it is at ws://127\.0\.0\.1:\d+/ws",
        ),
        (
            "http://{}/act",
            redirects(b"307", b"/act/"),
            r"answered 307: it is at http://127\.0\.0\.1:\d+/act/",
        ),
        ("openpi:ws://{}", http_1_0, "is no WebSocket server: .*HTTP/1.0 404"),
        ("openpi:wss://{}", (404, b""), "begins with ws://, not wss://"),
        ("openpi:wss://{}", CLOSING, "not speak TLS, the URL begins with ws://"),
        ("openpi:wss://{}", answers(b""), "not speak TLS, the URL begins with ws://"),
        ("https://{}/act", answers(b""), "not speak TLS, the URL begins with http://"),
        ("openpi:ws://{}", answers(b""), "speaks TLS, the URL begins with wss://"),
        ("http://{}/act", answers(b""), "speaks TLS, the URL begins with https://"),
        ("vla-eval:ws://{}", greets, r"speaks first \(b'\\x80'\).* openpi:URL"),
        ("vla-eval:ws://{}", waits, "did not answer within 0.2 s"),
        ("ws://{}", waits, "`greeting = false`"),
        ("WAITS ws://{}", greets, "`greeting = true`"),
        ("http://{}/act", waits, "is a WebSocket server: it is --policy ws://"),
        ("http://{}/act", SILENT, "did not answer within 0.2 s"),
        ("http://{}/act", ZMQ, "within 0.2 s: it speaks ZeroMQ"),
        ("http://{}/act", (302, b""), "answered 302 and names no other place"),
        (
            "http://{}/act",
            (403, {"error": "no"}),
            "answered 403: no; .* PROCTOR_POLICY_K",
        ),
        ("http://{}/act", (503, {"detail": "busy"}), "answered 503: busy"),
        ("proctor:http://{}", waits, "is a WebSocket server"),
        ("proctor:http://{}", SILENT, "did not answer within 0.2 s"),
        ("proctor:http://{}", ZMQ, "it speaks ZeroMQ"),
        ("gr00t:{}", waits, "is no ZeroMQ server|no greeting of ZeroMQ"),
        ("gr00t:{}", SILENT, "no greeting of ZeroMQ within 0.2 s"),
        ("gr00t:{}", SSH, "is no ZeroMQ server: it sent b'SSH-2.0"),
    ],
)
@pytest.mark.usefixtures("short_limits")
def test_another_protocol_is_seen_in_time(source: str, talk: Any, said: str) -> None:
    """Before there is a run. Expect a sentence that names what to do, not a wait."""
    text = WAITS if source.startswith("WAITS") else MAPPING
    if source.startswith("gr00t"):
        text = MAPPING.replace("x =", '"state.x" =')
    if source.startswith("vla-eval"):
        text += "[server]\nanswer_s = 0.2\n"
    mapping = None if "proctor" in source else PolicyMapping.of(tomllib.loads(text))
    with start(talk) as address:
        made = load(source.removeprefix("WAITS ").format(address), mapping)
        with pytest.raises(ProctorError, match=said) as caught:
            getattr(made, "described_name", made)()
    assert caught.value.code == "policy_failed"


def greets_with_error(connection: Any, _log: Any) -> None:
    connection.send(encode({"error": "Unauthorized: Invalid API key"}))
    waits(connection, _log)


REFUSED = (401, {"detail": "Not authenticated"})


@pytest.mark.parametrize(
    ("source", "talk", "variable"),
    [
        ("openpi:ws://{}", REFUSED, "OPENPI_API_KEY"),
        ("ws://{}", REFUSED, "PROCTOR_POLICY_KEY"),
        ("openpi:ws://{}", greets_with_error, "OPENPI_API_KEY"),
        ("ws://{}", closes_first(1008, "Missing API key"), "PROCTOR_POLICY_KEY"),
        ("vla-eval:ws://{}", REFUSED, None),
        ("http://{}/act", REFUSED, "PROCTOR_POLICY_KEY"),
        ("http://{}/act", (403, b"no"), "PROCTOR_POLICY_KEY"),
        ("proctor:http://{}", REFUSED, "PROCTOR_POLICY_KEY"),
    ],
)
@pytest.mark.parametrize("value", [None, "k"])
@pytest.mark.usefixtures("short_limits")
def test_a_refused_key_is_named_with_its_variable(
    source: str,
    talk: Any,
    variable: str | None,
    value: str | None,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Expect the variable, and whether it is set: one sentence for all wires."""
    said = "this source of policies sends no key"
    if variable is not None:
        monkeypatch.delenv(variable, raising=False)
        if value:
            monkeypatch.setenv(variable, value)
        end = "which is set." if value else "which is not set, so no key was sent."
        said = f"its key is taken from {variable}, {end}"
    mapping = None if "proctor" in source else PolicyMapping.of(tomllib.loads(MAPPING))
    with start(talk) as address:
        made = load(source.format(address), mapping)
        with pytest.raises(ProctorError) as caught:
            getattr(made, "described_name", made)()
    assert said in caught.value.detail


def sends_one(message: str | bytes) -> Callable[[Any, Any], None]:
    def talk(connection: Any, _log: Any) -> None:
        connection.send(b"\x80")
        connection.recv()
        connection.send(message)
        waits(connection, _log)

    return talk


AS_JSON = "answers JSON, and MessagePack is read: take --policy {}://.*`format = .json"


@pytest.mark.parametrize(
    ("source", "message", "server", "said"),
    [
        ("openpi:ws", '{"actions": [[0]]}', "", AS_JSON.format("ws")),
        ("ws", "[[0]]", "", AS_JSON.format("ws")),
        ("ws", b'{"actions": [[0]]}', "", AS_JSON.format("ws")),
        ("openpi:ws", '{"error": "out of memory"}', "", "failed: out of memory"),
        ("openpi:ws", '"busy"', "", "failed: .busy"),
        ("http", '{"actions": [[0]]}', 'format = "msgpack"', AS_JSON.format("http")),
        ("http", b"\x81\xa1a\x90", "", "answers MessagePack, and JSON is read: .*http"),
    ],
)
def test_an_answer_in_another_format_is_named(
    source: str, message: str | bytes, server: str, said: str
) -> None:
    """The server did not fail. Expect the option of the format."""
    body = message if isinstance(message, bytes) else message.encode()
    talk: Any = (
        start_http(lambda *_: (200, body))
        if source == "http"
        else start_websocket(sends_one(message))
    )
    text = f"{MAPPING}[server]\n{server}\n"
    with (
        talk as (address, _),
        connected(f"{source}://{address}", text) as policy,
        pytest.raises(ProctorError, match=said),
    ):
        policy.act(observation())


@pytest.mark.parametrize(
    ("source", "variable"),
    [
        ("openpi:ws://127.0.0.1:9", "OPENPI_API_KEY"),
        ("ws://127.0.0.1:9", "PROCTOR_POLICY_KEY"),
        ("http://127.0.0.1:9/act", "PROCTOR_POLICY_KEY"),
        ("gr00t:127.0.0.1:9", "GR00T_API_TOKEN"),
    ],
)
def test_a_key_that_cannot_be_sent_is_refused_with_its_variable(
    source: str, variable: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv(variable, "a b")
    monkeypatch.setattr(f"{SERVERS}.gr00t.gr00t_client.FIRST_CONTACT_S", 0.0)
    name = '"state.x" =' if source.startswith("gr00t") else "x ="
    mapping = PolicyMapping.of(tomllib.loads(MAPPING.replace("x =", name)))
    with pytest.raises(BadPolicy, match=f"the token of {variable} has a space"):
        load(source, mapping)()


@pytest.mark.parametrize("source", ["openpi:ws", "vla-eval:ws"])
def test_a_second_answer_is_not_that_of_the_next_request(source: str) -> None:
    """It is there before the next request is sent. Expect a refusal of it."""
    is_there = threading.Event()

    class Twice:
        """Sends each message twice, and waits until the client has read both."""

        def __init__(self, connection: Any) -> None:
            self._connection = connection

        def __iter__(self) -> Iterator[Any]:
            return iter(self._connection)

        def send(self, message: bytes) -> None:
            self._connection.send(message)
            if b"actions" in message:
                self._connection.send(message)
                for _ in range(2):  # the first pong may come before the message
                    self._connection.ping().wait(TIMEOUT_S)
                is_there.set()

    def talk(connection: Any, log: list[Any]) -> None:
        wires = {"openpi:ws": openpi, "vla-eval:ws": vla_eval}
        wires[source](Twice(connection), log)  # type: ignore[arg-type]

    text = READY["droid" if source == "openpi:ws" else "vla_eval"]
    with (
        start_websocket(talk) as (address, log),
        connected(f"{source}://{address}", text) as policy,
    ):
        policy.reset("a")
        policy.act(observation("a"))
        assert is_there.wait(TIMEOUT_S)
        with pytest.raises(ProctorError, match="for which there was no request"):
            policy.act(observation("a", step=1))
    assert log.count("infer") + log.count("observation") == 1


def test_a_second_answer_over_http_is_not_read() -> None:
    """Each request is answered twice, at once. Expect each its own answer."""
    numbers = itertools.count()

    def talk(client: socket.socket) -> None:
        while request := client.recv(65536):
            while not request.endswith(b"{}"):
                request += client.recv(65536)
            body = b'{"n": %d}' % next(numbers)
            head = b"HTTP/1.1 200 OK\r\nContent-Length: %d\r\n\r\n" % len(body)
            client.sendall((head + body) * 2)

    with start(talk) as address:
        settings = ServerSettings(format="json")
        client = HttpPolicyClient(f"http://{address}/act", settings)
        assert [client.infer({})["n"] for _ in range(3)] == [0, 1, 2]
        client.close()


@pytest.mark.parametrize("source", ["openpi:ws://{}", "ws://{}", "http://{}/act"])
def test_an_answer_has_a_limit(source: str) -> None:
    """Expect the limit, its name in the file, and that the late answer is not read."""

    is_over = threading.Event()

    def never(path: str, *_: Any) -> tuple[int, Any]:
        if not path.startswith("GET"):
            is_over.wait(TIMEOUT_S)
        return 200, {}

    text = MAPPING + "[server]\nanswer_s = 0.1\n"
    talk: Any = start_http(never) if "http" in source else start_websocket(greets)
    with talk as (address, _), connected(source.format(address), text) as policy:
        policy.reset("x")
        with pytest.raises(ProctorError, match=r"did not answer within 0\.1 s"):
            policy.act(observation())
        is_over.set()


@pytest.mark.parametrize("source", ["openpi:ws://{}", "ws://{}", "http://{}/act"])
@pytest.mark.parametrize("is_left", [False, True])
def test_a_request_without_an_answer_is_sent_once_more(
    source: str, is_left: bool
) -> None:
    """The way back of the first connection is dead. Expect what was waited for, and
    the answer on another connection; or an error, where that is silent, too."""
    is_over, waits_for, reports = threading.Event(), list[str](), list[str]()
    asked = itertools.count()

    def reply(path: str, *_: Any) -> tuple[int, Any]:
        if not path.startswith("GET") and (next(asked) == 0 or is_left):
            is_over.wait(TIMEOUT_S)
        return 200, {}

    def talk(connection: Any, _log: Any) -> None:
        connection.send(b"\x80")
        for _ in connection:
            reply("infer")
            connection.send(b"\x80")

    def report(waiting: str | None, warning: str = "") -> None:
        reports.extend(filter(None, [waiting, warning]))

    purpose = "step 7 of {0}{red}"  # an id that the server chose may have braces
    text = MAPPING + "[server]\nanswer_s = 0.2\n"
    served: Any = start_http(reply) if "http" in source else start_websocket(talk)
    with (
        contextlib.ExitStack() as stack,
        served as (address, _),
        connected(source.format(address), text) as policy,
        reporting_repeats(report, waits_for.append, purpose),
    ):
        stack.callback(is_over.set)
        policy.reset("x")
        if is_left:
            last = f"it was sent a request of 1 kB for {purpose}. It was tried again"
            with pytest.raises(ProctorError, match=re.escape(last)):
                policy.act(observation())
        else:
            policy.act(observation())
        is_over.set()
    assert next(asked) == 2
    assert "answer within 0.2 s" in reports[0]
    assert f"it was sent a request of 1 kB for {purpose}" in reports[0]
    assert "asked once more" in reports[0]
    assert "may count it twice" in reports[1]
    assert [re.sub("the policy server at [^ ]+", "it", one) for one in waits_for] == [
        *[f"the answer of it to a request of 1 kB for {purpose}"] * 2,
        *([] if is_left else ["this program, which reads the 1 kB that it sent"]),
    ]


@pytest.mark.parametrize("source", ["openpi:ws://{}", "http://{}/act", "gr00t:{}"])
@pytest.mark.usefixtures("short_limits")
def test_a_program_that_can_open_no_more_files_says_so(
    source: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It accuses no server. The thread of a WebSocket needs files of its own."""

    def none_left(*_: Any, **__: Any) -> Any:
        raise OSError(errno.EMFILE, "Too many open files")

    text = MAPPING.replace("x =", '"state.x" =') if "gr00t" in source else MAPPING
    with start(SILENT) as address:
        made = load(source.format(address), PolicyMapping.of(tomllib.loads(text)))
        place = "selectors.DefaultSelector" if "ws" in source else "socket.socket"
        monkeypatch.setattr(place, none_left)
        with pytest.raises(ProctorError, match=r"ulimit -n 4096") as caught:
            made()
        monkeypatch.undo()
    assert "was not reached: this program can open no more files" in str(caught.value)


@pytest.mark.parametrize("source", ["openpi:ws://{}", "http://{}/act", "gr00t:{}"])
@pytest.mark.usefixtures("short_limits")
def test_a_connection_that_a_router_forgets_is_probed(
    source: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    options: list[Any] = []

    class Recorded(socket.socket):
        def setsockopt(self, *option: Any) -> None:
            options.append(option)
            super().setsockopt(*option)

    monkeypatch.setattr(socket, "socket", Recorded)
    text = MAPPING.replace("x =", '"state.x" =') if "gr00t" in source else MAPPING
    served: Any = start_websocket(greets) if "ws" in source else start(SILENT)
    with served as place:
        address = place[0] if "ws" in source else place
        made = load(source.format(address), PolicyMapping.of(tomllib.loads(text)))
        with contextlib.suppress(ProctorError):
            made()
    assert (socket.SOL_SOCKET, socket.SO_KEEPALIVE, 1) in options


def trickles(is_over: threading.Event, head: bytes) -> Callable[[socket.socket], None]:
    """Answers each POST and PUT with this head, and then a byte now and then."""

    def talk(client: socket.socket) -> None:
        request = client.recv(65536)
        if request.startswith(b"GET"):
            client.sendall(b"HTTP/1.1 200 OK\r\nContent-Length: 0\r\n\r\n")
            request = client.recv(65536)
        client.sendall(head)
        while not is_over.wait(0.02):
            client.sendall(b" ")

    return talk


def drips(is_over: threading.Event) -> Callable[[Any, Any], None]:
    """A WebSocket server that greets, and sends an answer in endless fragments."""

    def fragments() -> Iterator[bytes]:
        while not is_over.wait(0.02):
            yield b" "

    def talk(connection: Any, _log: Any) -> None:
        connection.send(b"\x80")
        connection.recv()
        connection.send(fragments())

    return talk


@pytest.mark.parametrize(
    ("source", "head", "said"),
    [
        (
            "http",
            b"HTTP/1.1 200 OK\r\nContent-Length: 999999\r\n\r\n",
            "began its answer, and did not end it within 0.2 s; answer_s in .server",
        ),
        ("http", b"HTTP/1.1 200 OK\r\nX: ", "did not answer within 0.2 s; answer_s"),
        ("openpi:ws", b"", "did not answer within 0.2 s; answer_s in .server"),
    ],
)
def test_the_limit_is_one_for_the_whole_answer(
    source: str, head: bytes, said: str
) -> None:
    """A byte comes again and again, always in time. Expect the end at the limit."""
    is_over = threading.Event()
    text = MAPPING + "[server]\nanswer_s = 0.2\n"
    talk: Any = (
        start(trickles(is_over, head))
        if source == "http"
        else start_websocket(drips(is_over))
    )
    with talk as address, contextlib.ExitStack() as stack:
        stack.callback(is_over.set)
        place = address if source == "http" else address[0]
        policy = stack.enter_context(connected(f"{source}://{place}", text))
        policy.reset("x")
        with pytest.raises(ProctorError, match=said):
            policy.act(observation())


def sends_much(connection: Any, _log: Any) -> None:
    connection.send(b"\x80")
    connection.recv()
    connection.send(bytes(2000))
    waits(connection, _log)


@pytest.mark.parametrize(
    ("source", "start_one"),
    [
        (
            "http://{}/act",
            lambda: start_http(
                lambda path, *_: (200, " " * (2000 if path[0] == "/" else 0))
            ),
        ),
        ("openpi:ws://{}", lambda: start_websocket(sends_much)),
    ],
)
def test_an_answer_has_a_size(
    source: str, start_one: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    for module in ("bounded_answers", "websocket_client"):
        monkeypatch.setattr(f"{SERVERS}.{module}.ANSWER_BYTES_MAX", 1000)
    said = "sends an answer of more than 1000 bytes"
    with (
        start_one() as (address, _),
        connected(source.format(address), MAPPING) as policy,
        pytest.raises(ProctorError, match=said),
    ):
        policy.act(observation())


SECONDS = "a number of seconds above 0, at most 1e9"
WRONG_SECONDS = {
    '"1"': '"1"',
    "true": "true",
    "0": "0",
    "-1": "-1",
    "inf": "Infinity",
    "1e10": "10000000000.0",
}


@pytest.mark.parametrize(
    ("source", "server", "said"),
    [
        ("openpi:ws://h", 'format = "json"', "openpi: does not read format of .server"),
        ("http://h", "greeting = true", "http: does not read greeting"),
        ("gr00t:h:1", "expect = { a = 1 }", "gr00t: does not read expect"),
        ("ws://h", 'format = "yaml"', "format is one of msgpack, msgpack-text, json"),
        *(
            ("ws://h", f"answer_s = {value}", f"answer_s is {SECONDS}; not {shown}$")
            for value, shown in WRONG_SECONDS.items()
        ),
        ("ws://h", "greeting = 1", "greeting is true or false; not 1$"),
        ("ws://h", "varying = [1]", r"varying is a list of names; not \[1\]$"),
        ("ws://h", "greetng = true", "but answer_s, .*; did you mean greeting"),
        ("ws://h", "greeting = false\nready = { a = 1 }", "are of servers that greet"),
        (
            "http://h",
            'envelope = "e"\nformat = "msgpack"',
            "envelope is for the formats",
        ),
        ("m:f", "answer_s = 1.0", r"\[server\] and \[reset\] are of policy servers"),
    ],
)
def test_settings_of_others_are_refused(source: str, server: str, said: str) -> None:
    text = MAPPING.replace("x =", '"state.x" =') + f"[server]\n{server}\n"
    with pytest.raises((BadPolicy, BadMapping), match=f"^arm.toml: .*{said}"):
        load(source, PolicyMapping.of(tomllib.loads(text), "arm.toml"))


@pytest.mark.parametrize("wire_format", FORMATS)
def test_each_format_reads_what_it_writes(wire_format: str) -> None:
    array = np.arange(6, dtype=np.float32).reshape(2, 3)
    given = {"a": array, "n": [np.int64(3), np.float32(0.5), True, None, "x"]}
    read = unpack(pack(given, wire_format), wire_format)
    assert read["n"] == [3, 0.5, True, None, "x"]
    assert np.asarray(read["a"]).tolist() == array.tolist()
    for unsupported in (object(), np.array([object()])):
        with pytest.raises((TypeError, ValueError), match="not supported"):
            pack({"a": unsupported}, wire_format)


def test_a_busy_server_is_awaited_in_episodes(monkeypatch: pytest.MonkeyPatch) -> None:
    """It closes, and then does not answer two handshakes. Expect the answer all the
    same: a server that computes in its event loop answers later."""
    handshakes: list[threading.Event] = []

    def busy(_connection: Any, _request: Any) -> None:
        """Keeps the second and the third waiting until the next one comes."""
        handshakes.append(threading.Event())
        number = len(handshakes)
        for earlier in handshakes[:-1]:
            earlier.set()
        if number in (2, 3):
            handshakes[number - 1].wait(TIMEOUT_S)

    monkeypatch.setattr(f"{SERVERS}.websocket_client.OPEN_S", 0.1)
    monkeypatch.setattr(f"{SERVERS}.server_transport.PAUSE_S", 0.0)
    monkeypatch.setattr(f"{SERVERS}.server_faults._PROBE_S", 0.01)
    with serve(answer_one, "127.0.0.1", 0, process_request=busy) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        address = f"127.0.0.1:{server.socket.getsockname()[1]}"
        with connected(f"openpi:ws://{address}", MAPPING) as policy:
            for step in range(2):
                assert len(policy.act(observation(step=step))) == 1
    assert len(handshakes) == 4


def answer_one(connection: Any) -> None:
    connection.send(b"\x80")
    connection.recv()
    connection.send(b"\x80")


HTTP_HEAD = b"HTTP/1.1 200 OK\r\n"


@pytest.mark.parametrize(
    ("source", "talk", "said"),
    [
        (
            "http://{}/act",
            answers(HTTP_HEAD + b"Content-Length: 191\r\n\r\n" + b"." * 181),
            "broke off its answer: 181 of 191 bytes came",
        ),
        (
            "http://{}/act",
            answers(HTTP_HEAD + b"Transfer-Encoding: chunked\r\n\r\n40\r\nabc"),
            "broke off its answer",
        ),
        ("http://{}/act", answers(b""), "closed the connection without an answer"),
        ("http://{}/act", answers(b"hello\r\n\r\n"), "is no HTTP server .*hello"),
        ("proctor:http://{}", answers(b"no\r\n"), "is no HTTP server .*no"),
        ("ws://{}", closes_with(1009, ""), "too big .code 1009.; let it take larger"),
        ("ws://{}", closes_with(1008, "one at a time"), ": one at a time .code 1008."),
        ("ws://{}", closes_with(1011, ""), r"connection: .* .code 1011.\."),
    ],
)
@pytest.mark.usefixtures("short_limits")
def test_a_cut_answer_is_not_taken_for_another_program(
    source: str, talk: Any, said: str
) -> None:
    """Expect how much came, or the words of the one who closed."""
    text = WAITS if source.startswith("ws") else MAPPING
    mapping = None if "proctor" in source else PolicyMapping.of(tomllib.loads(text))

    def play_one_turn(address: str) -> None:
        made = load(source.format(address), mapping)
        policy = getattr(made, "described_name", made)()
        policy.reset("")
        policy.act(observation())

    with start(talk) as address, pytest.raises(ProctorError, match=said):
        play_one_turn(address)
