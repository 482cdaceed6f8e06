"""No body of a request stops the event loop: others are served while it is read.

Measured is the processor time that passes between two turns of the loop, in all threads
of this process: other programs take nothing of it. The bodies are the largest that each
parser takes, and wrong ones whose fault is found late.
"""

from __future__ import annotations

import asyncio
import gc
import json
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from typing import Any

import msgspec
import numpy as np
import pytest

from reference_server.__main__ import THREAD_SWITCH_S
from reference_server.http.bodies.bounded_parsing import VALUES_MAX
from reference_server.http.codec import JSON, MSGPACK
from reference_server.profiles.ebench.pickle_reader import VALUES_MAX as PICKLED_MAX
from reference_server.profiles.ebench.task_handlers import ENDPOINT
from reference_server.profiles.ebench.task_responses import PICKLE
from tests.support.parsing.asgi_server import TOKEN, AsgiServer, asgi_server
from tests.support.profiles.ebench_client import dump_pickle

pytestmark = pytest.mark.slow("sends large bodies")

STALL_S_MAX = 0.05
TICK_S = 0.002
ATTEMPTS = 3
SIZE = 2**23
CHUNK = 4096
HEADERS = [("host", b"127.0.0.1"), ("authorization", f"Bearer {TOKEN}".encode())]
VALUES = PICKLED_MAX - 1000


def actions(names: str, numbers: int) -> list[Any]:
    return [{"values": {name: [1.5] * numbers for name in names}}] * CHUNK


def predict(of: list[Any]) -> dict[str, Any]:
    return {"session_id": "s", "seq": 1, "actions": of}


def text_of(unit: str) -> bytes:
    head, tail = b'{"session_id":"s","seq":1,"actions":[', b"]}"
    return head + b",".join([unit.encode()] * (SIZE // (len(unit) + 1) - 9)) + tail


def most() -> dict[str, Any]:
    return predict(actions("abc", (VALUES_MAX // CHUNK - 2) // 3 - 1))


def wrong_at_the_end() -> dict[str, Any]:
    return predict([*most()["actions"][:-1], {"values": {"a": ["x"]}}])


def json_of(value: Any) -> bytes:
    return json.dumps(value).encode()


def pickle_of(make: Callable[[], Any]) -> bytes:
    return dump_pickle(make(), 4)


TURN = "/v1/runs/{run_id}/workers/0/predict"
STEP, STEPS = f"{ENDPOINT}/step", f"{ENDPOINT}/step_chunk"
LISTS: list[list[float]] = [[]] * 180
PICKLED: dict[str, tuple[str, Callable[[], Any]]] = {
    "numbers": (STEP, lambda: {"0": [i / 2 for i in range(VALUES // 2)]}),
    "texts": (STEP, lambda: {"0": [f"a{i}" for i in range(VALUES // 3)]}),
    "shared numbers": (STEP, lambda: {"0": {"action": [[1.0] * 170] * 170}}),
    "empty lists": (STEP, lambda: {"0": {"action": [[] for _ in range(VALUES // 2)]}}),
    "long actions": (STEPS, lambda: [{"0": {"action": [0.0, *LISTS]}}] * 999),
    "arrays": (STEPS, lambda: [{"0": {"action": np.zeros(3)}} for _ in range(CHUNK)]),
    "a large array": (STEP, lambda: {"0": {"action": np.zeros(SIZE // 8 - 99)}}),
}
# Name → path, media type, what makes the body.
BODIES: dict[str, tuple[str, str, Callable[[], bytes]]] = {
    "the most values": (TURN, JSON, lambda: json_of(most())),
    "too many values": (TURN, JSON, lambda: json_of(predict(actions("abc", 99)))),
    "a zero with a sign": (
        *(TURN, JSON),
        lambda: json_of(most()).replace(b"1.5", b"-0", 1),
    ),
    "a last value that is wrong": (TURN, JSON, lambda: json_of(wrong_at_the_end())),
    **{
        f"actions that are {unit[:20]}": (TURN, JSON, partial(text_of, unit))
        for unit in ("{}", "1", "[]", '{"values":{"a":[1,2]}}', '"aaaaaaaa"', "9" * 300)
    },
    "MessagePack": (TURN, MSGPACK, lambda: msgspec.msgpack.encode(most())),
    "actions that are nil": (
        *(TURN, MSGPACK),
        lambda: msgspec.msgpack.encode(predict([None] * (SIZE - 99))),
    ),
    **{
        f"pickled {name}": (path, PICKLE, partial(pickle_of, make))
        for name, (path, make) in PICKLED.items()
    },
}


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[AsgiServer]:
    folder: Path = tmp_path_factory.mktemp("server")
    interval_s = sys.getswitchinterval()
    sys.setswitchinterval(THREAD_SWITCH_S)  # as the server does
    with asgi_server(folder, profiles="ebench") as server:
        yield server
    sys.setswitchinterval(interval_s)


@pytest.fixture(scope="module")
def run_id(server: AsgiServer) -> str:
    """A run whose worker 0 has begun its episode."""
    body = {"benchmark_id": "calibration", "policy": {"name": "p"}}
    body |= {"options": {"tasks": ["score"]}}
    headers = [*HEADERS, ("content-type", JSON.encode())]
    submitted = server.answer(
        "POST", "/v1/runs", headers, body=json.dumps(body).encode()
    )
    assert submitted == 201
    run_id = server.json("GET", "/v1/runs", HEADERS)["runs"][0]["run_id"]
    path = f"/v1/runs/{run_id}/workers/0"
    assert server.answer("PUT", path, headers, body=b'{"attach_key":"k"}') == 200
    return str(run_id)


@pytest.mark.parametrize("name", BODIES)
def test_no_body_stops_the_loop(server: AsgiServer, run_id: str, name: str) -> None:
    path, kind, make = BODIES[name]
    body = make()
    path = path.format(run_id=run_id, benchmark_id="calibration")
    headers = [*HEADERS, ("content-type", kind.encode())]
    stalls_s: list[float] = []
    gc.freeze()  # as the server does when it starts
    while len(stalls_s) < ATTEMPTS and min(stalls_s, default=1.0) > STALL_S_MAX:
        with _ticking(server) as stalls:
            server.answer("POST", path, headers, body=body)
        stalls_s.append(max(stalls))
    gc.unfreeze()
    assert min(stalls_s) <= STALL_S_MAX, stalls_s


def test_a_stall_is_seen(server: AsgiServer) -> None:
    """The control."""

    async def work() -> None:
        begun_at = time.process_time()
        while time.process_time() - begun_at < 2 * STALL_S_MAX:
            pass

    with _ticking(server) as stalls:
        server.run(work())
    assert max(stalls) > STALL_S_MAX


@contextmanager
def _ticking(server: AsgiServer) -> Iterator[list[float]]:
    """The processor seconds of each turn of the loop, filled until the end."""
    stalls: list[float] = []

    async def tick() -> None:
        while True:
            begun_at = time.process_time()
            await asyncio.sleep(TICK_S)
            stalls.append(time.process_time() - begun_at)

    ticking = server.start(tick())
    server.run(asyncio.sleep(TICK_S / 2))
    yield stalls
    server.run(asyncio.sleep(2 * TICK_S))
    ticking.cancel()
