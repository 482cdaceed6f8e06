"""Policy servers of other projects, as small as their wire allows.

Each speaks what the public sources of that project write and read. `WIRES` has one for
each mapping of docs/evaluate/policies/policy-servers.md. A server answers the joints
that it was sent, and notes in `log` what it was asked to do.
"""

import base64
import contextlib
import json
import re
import threading
import tomllib
from collections.abc import Callable, Iterator
from typing import Any

import msgspec
import numpy as np
from websockets.exceptions import ConnectionClosed
from websockets.sync.server import ServerConnection, serve

from reference_client import Observation
from reference_client.api.observation import state_vector
from reference_client.policies import PolicyMapping, load
from reference_client.policies.policy_loader import close_policy
from tests.support.kit.null_servers import Request, run_server
from tests.support.paths import ROOT

TRACE = (
    "Traceback (most recent call last):\n"
    '  File "server.py", line 9, in handler\n'
    "    raise KeyError(name)\n"
    "KeyError: 'proprio'\n"
)
PAGE = (ROOT / "docs" / "evaluate" / "policies" / "policy-servers.md").read_text()
READY = {
    re.findall(r"# (\w+)\.toml", text)[0]: text
    for text in re.findall(r"```toml\n(.*?)```", PAGE, re.DOTALL)
}
JOINTS = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7]
Log = list[Any]
encode = msgspec.msgpack.encode


def decode(frame: Any) -> Any:
    return msgspec.msgpack.decode(frame)


def array(value: Any, *, is_text: bool = False) -> dict[Any, Any]:
    """In the words of msgpack-numpy; is_text: as vla-eval writes it."""
    made = np.asarray(value)
    parts = {
        "__ndarray__": True,
        "data": made.tobytes(),
        "dtype": made.dtype.str,
        "shape": list(made.shape),
    }
    return parts if is_text else {key.encode(): part for key, part in parts.items()}


def numbers(packed: dict[Any, Any]) -> np.ndarray[Any, Any]:
    """An array in either of these words, or in those of json_numpy."""
    if "__numpy__" in packed:
        data = base64.b64decode(packed["__numpy__"])
        return np.frombuffer(data, packed["dtype"]).reshape(packed["shape"])
    words = {k if isinstance(k, str) else k.decode(): v for k, v in packed.items()}
    return np.frombuffer(words["data"], words["dtype"]).reshape(words["shape"])


def openpi(socket: ServerConnection, log: Log) -> None:
    socket.send(encode({"model": "fake"}))
    for frame in socket:
        request = decode(frame)
        log.append("infer")
        joints = numbers(request["observation/joint_position"])
        socket.send(encode({"actions": array([[*joints * 0, 1.0]] * 10)}))


def roboarena(socket: ServerConnection, log: Log) -> None:
    config = {
        "image_resolution": [224, 224],
        "needs_wrist_camera": True,
        "n_external_cameras": 1,
        "needs_stereo_camera": False,
        "needs_session_id": True,
        "action_space": "joint_position",
    }
    socket.send(encode(config))
    for frame in socket:
        request = decode(frame)
        log.append((request.pop("endpoint"), request["session_id"]))
        if log[-1][0] == "reset":
            socket.send("reset successful")
            continue
        assert numbers(request["observation/wrist_image_left"]).shape == (224, 224, 3)
        joints = numbers(request["observation/joint_position"])
        socket.send(encode({"actions": array([[*joints, 1.0]])}))


def starvla(socket: ServerConnection, log: Log) -> None:
    said = {"default_unnorm_key": "franka", "training_obs_image_size": [224, 224]}
    socket.send(encode({"env": "starvla_policy_server"} | said))
    for frame in socket:
        (example,) = decode(frame)["examples"]
        log.append("infer")
        answer = {"status": "ok", "ok": True, "type": "inference_result"}
        if example["lang"] == "fail":
            error = {"message": "unnorm_key not specified"}
            answer |= {"status": "error", "ok": False, "error": error}
        else:
            assert [numbers(i).shape for i in example["image"]] == [(224, 224, 3)] * 2
            state = numbers(example["state"])
            answer["data"] = {"actions": array([np.repeat(state, 3, axis=0)])}
        socket.send(encode(answer))


def internvla(socket: ServerConnection, log: Log) -> None:
    socket.send(encode({"env": "simpler_env"}))
    for frame in socket:
        request = decode(frame)
        answer = {"status": "ok", "ok": True, "request_id": "default"}
        if "reset" in request:
            log.append(("reset", request["instruction"]))
            socket.send(encode(answer | {"type": "reset_result"}))
            continue
        log.append("infer")
        assert [numbers(i).shape for i in request["images"]] == [(224, 224, 3)]
        raw = {"xyz_delta": [1.0, 2, 3], "rotation_delta": [4.0, 5, 6]}
        action = {name: array(value) for name, value in raw.items()}
        action["open_gripper"] = array([0.5])
        socket.send(encode(answer | {"data": {"raw_action": action}}))


def vla_eval(socket: ServerConnection, log: Log) -> None:
    for frame in socket:
        message = decode(frame)
        log.append(message["type"])

        def send(kind: str, payload: Any, seq: int = message["seq"]) -> None:
            frame = {"type": kind, "payload": payload, "seq": seq, "timestamp": 0.5}
            socket.send(encode(frame))

        payload = message["payload"]
        if message["type"] == "hello":
            assert payload["protocol_version"] == 1
            spec = {"gripper": {"name": "gripper", "dims": 1, "format": "raw"}}
            send("hello", {"protocol_version": 1, "action_spec": spec})
        if message["type"] == "episode_start":
            log.append(payload)
        if message["type"] == "observation":
            if payload["task_description"] == "fail":
                send("error", {"error": "observation_failed: KeyError: 'proprio'"})
                continue
            assert numbers(payload["images"]["agentview"]).shape == (256, 256, 3)
            send("action", {"actions": array(numbers(payload["states"]), is_text=True)})


def positronic(socket: ServerConnection, log: Log) -> None:
    log.append("session")
    socket.send(encode({"status": "loading", "message": "Loading checkpoint 1"}))
    socket.send(encode({"status": "ready", "meta": {"action_fps": 20.0}}))
    for frame in socket:
        request = decode(frame)
        log.append(request["obs_time_ns"])
        if request["task"] == "fail":
            socket.send(encode({"error": "Shape mismatch: expected (7,)"}))
            continue
        joints = array(numbers(request["robot_state.q"]))
        command = {"type": "joint_pos", "positions": joints}
        wrapped = {b"__cmd__": command} if request["task"] == "wrapped" else command
        rows = [
            {"robot_command": wrapped, "target_grip": grip, "timestamp": grip}
            for grip in (0.0, 0.5)
        ]
        socket.send(encode({"result": rows}))


Reply = tuple[int, Any]


def xvla(path: str, body: bytes, log: Log) -> Reply:
    """FastAPI: POST /act with texts of json_numpy in JSON."""
    if path != "/act":
        return 405 if path == "GET /act" else 404, {"detail": "Not Found"}
    request = json.loads(body)
    log.append("infer")
    if request["language_instruction"] == "fail":
        loc = {"loc": ["body", "proprio"], "msg": "Field required"}
        return 422, {"detail": [loc]}
    image = numbers(json.loads(request["image0"]))
    assert (image.shape, request["steps"]) == ((256, 256, 3), 10)
    return 200, {"action": [numbers(json.loads(request["proprio"])).tolist()] * 30}


def simplerenv(path: str, body: bytes, log: Log) -> Reply:
    """The whole request and the whole answer are texts of json_numpy in JSON."""
    if path == "/reset":
        log.append(("reset", body))
        return 200, "reset"
    if path != "/query":
        return 405, {"detail": "Method Not Allowed"}
    request = json.loads(json.loads(body)["use_this"])
    log.append("infer")
    if request["text"] == "fail":
        return 200, {"error": TRACE}
    image = numbers(request["observation"]["image_primary"])
    assert (image.shape, request["modality"]) == ((256, 256, 3), "l")
    row = np.arange(8, dtype=np.float32)
    data = base64.b64encode(row.tobytes()).decode()
    return 200, json.dumps({"__numpy__": data, "dtype": "<f4", "shape": [8]})


WIRES: dict[str, tuple[str, Callable[..., Any]]] = {
    "droid": ("openpi:ws://{}", openpi),
    "roboarena": ("openpi:ws://{}", roboarena),
    "starvla": ("openpi:ws://{}", starvla),
    "internvla": ("openpi:ws://{}", internvla),
    "vla_eval": ("vla-eval:ws://{}", vla_eval),
    "positronic": ("ws://{}/api/v1/session", positronic),
    "xvla": ("http://{}/act", xvla),
    "simplerenv": ("http://{}/query", simplerenv),
}


@contextlib.contextmanager
def start_wire(name: str) -> Iterator[tuple[str, Log]]:
    """The reference of a running policy server, and its log."""
    source, talk = WIRES[name]
    is_http = source.startswith("http")
    with (start_http if is_http else start_websocket)(talk) as (address, log):
        yield source.format(address), log


@contextlib.contextmanager
def answering(name: str, answer: Any) -> Iterator[str]:
    """The reference of a server that has one answer to each request."""
    source, _ = WIRES[name]
    ready = {"status": "ready", "meta": {"action_fps": 20.0}}
    said = {"default_unnorm_key": "franka", "training_obs_image_size": [224, 224]}

    def talk(socket: ServerConnection, _log: Log) -> None:
        if not source.startswith("vla-eval"):
            socket.send(encode(ready | said))
        for frame in socket:
            message = decode(frame)
            if not source.startswith("vla-eval"):
                socket.send(encode(answer))
            elif message["type"] != "episode_start":
                is_hello = message["type"] == "hello"
                kind, payload = ("hello", {}) if is_hello else ("action", answer)
                socket.send(encode(message | {"type": kind, "payload": payload}))

    start = start_websocket(talk)
    if source.startswith("http"):
        start = start_http(lambda _path, _body, _log: (200, answer))
    with start as (address, _):
        yield source.format(address)


@contextlib.contextmanager
def start_websocket(
    talk: Callable[[ServerConnection, Log], None],
) -> Iterator[tuple[str, Log]]:
    """Its address; `talk` runs in a thread for each connection."""
    log: Log = []

    def answer(socket: ServerConnection) -> None:
        with contextlib.suppress(ConnectionClosed):
            talk(socket, log)

    with serve(answer, "127.0.0.1", 0, compression=None, max_size=None) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f"127.0.0.1:{server.socket.getsockname()[1]}", log


@contextlib.contextmanager
def start_http(talk: Callable[[str, bytes, Log], Reply]) -> Iterator[tuple[str, Log]]:
    """Its address; `talk` takes the path, with the method if that is not POST."""
    log: Log = []

    def answer(request: Request) -> tuple[int, dict[str, str], bytes]:
        is_post = request.method == "POST"
        path = request.path if is_post else f"{request.method} {request.path}"
        status, value = talk(path, request.body, log)
        body = value if isinstance(value, bytes) else json.dumps(value).encode()
        return status, {}, body

    with run_server(answer) as url:
        yield url.removeprefix("http://"), log


def observation(instruction: str = "Lift.", step: int = 0) -> Observation:
    pictures = {name: np.zeros((96, 128, 3), np.uint8) for name in ("front", "wrist")}
    state = {"joint_position": JOINTS, "gripper": [0.25], "ee_pose": JOINTS}
    return Observation(
        state={name: state_vector(vector) for name, vector in state.items()},
        images=pictures,
        tensors={},
        instruction=instruction,
        episode_id="e0000",
        step=step,
    )


@contextlib.contextmanager
def connected(reference: str, text: str) -> Iterator[Any]:
    policy = load(reference, PolicyMapping.of(tomllib.loads(text)))()
    with contextlib.closing(_Closing(policy)):
        yield policy


class _Closing:
    def __init__(self, policy: Any) -> None:
        self.close: Callable[[], None] = lambda: close_policy(policy)


def play(policy: Any, *instructions: str) -> list[Any]:
    """An episode of two turns for each instruction; returns the last chunk."""
    chunk: list[Any] = []
    for instruction in instructions:
        policy.reset(instruction)
        policy.act(observation(instruction))
        chunk = policy.act(observation(instruction, step=1))
    return chunk
