"""Memory of broken-off bodies, and one answer on both ways through the server.

Limits of one connection are tested in test_bounded_connection.py and judged by the kit;
random requests, odd bytes and ids of other accounts are attacks of tests/campaigns/.
"""

import contextlib
import socket
from collections.abc import Iterator
from pathlib import Path

import msgspec
import pytest

from tests.support.servers import TIMEOUT_S, TOKENS, ReferenceServer
from tests.support.waiting import wait_until

pytestmark = pytest.mark.slow("starts servers or kits")


class LiveRun:
    """A server and a run on it with one live session, used by no other test."""

    def __init__(self, server: ReferenceServer) -> None:
        self.server = server
        self.client = server.client()
        self.address = (self.client.base_url.host, self.client.base_url.port)
        body = {"benchmark_id": "calibration", "policy": {"name": "p"}}
        run_id = self.client.post("/v1/runs", json=body).json()["run_id"]
        self.worker = f"/v1/runs/{run_id}/workers/w"
        self.client.put(self.worker, json={"attach_key": "key"})


@pytest.fixture(scope="module")
def live_run(tmp_path_factory: pytest.TempPathFactory) -> Iterator[LiveRun]:
    server = ReferenceServer(tmp_path_factory.mktemp("limits"))
    live_run = LiveRun(server)
    yield live_run
    live_run.client.close()
    server.end()
    assert "Traceback" not in server.log()


def memory(pid: int) -> int:
    """The bytes that a process holds now."""
    status = Path(f"/proc/{pid}/status").read_text()
    return int(status.partition("VmRSS:")[2].split()[0]) * 1024


def test_what_broken_off_bodies_took_is_given_back(live_run: LiveRun) -> None:
    """Refused requests kept their bodies until the next full collection of garbage."""
    pid = live_run.server.process.pid
    live_run.client.get("/v1")
    before = memory(pid)
    head = (
        b"POST /v1/runs/x/workers/w/predict HTTP/1.1\r\nHost: x\r\n"
        b"Authorization: Bearer %b\r\nContent-Type: application/json\r\n"
        b"Content-Length: 8000000\r\n\r\n" % TOKENS["alice"].encode()
    )
    with contextlib.ExitStack() as stack:
        for _ in range(100):
            opened = socket.create_connection(live_run.address, TIMEOUT_S)
            stack.enter_context(opened).sendall(head + b" " * 500_000)
        wait_until(lambda: memory(pid) - before > 40 * 2**20, "the heads are read")
    wait_until(lambda: memory(pid) - before < 20 * 2**20, "the memory is given back")


TURN = {"session_id": "gone", "seq": 1, "actions": [{"values": {}}]}
UNUSUAL_TURNS: list[tuple[dict[str, str], bytes]] = [
    ({}, b'{"session_id": "gone", "seq": 1, "actions": [{"values": {}}]}'),
    ({"Accept": "application/msgpack"}, msgspec.json.encode(TURN)),
    ({"Content-Type": "application/msgpack"}, msgspec.msgpack.encode(TURN)),
    ({"Content-Type": "application/msgpack"}, b"\xc1"),
    ({"Content-Type": "text/plain"}, b"{}"),
    ({"Accept": "text/html"}, msgspec.json.encode(TURN)),
    ({"Proctor-Version": "9.9"}, msgspec.json.encode(TURN)),
    ({"Authorization": "Bearer wrong"}, msgspec.json.encode(TURN)),
    ({"Connection": "close"}, msgspec.json.encode(TURN)),
    ({"Content-Encoding": "gzip"}, b"{}"),
    ({}, b""),
    ({}, b"{"),
    ({}, b'{"seq": 1, "seq": 2}'),
    ({}, b"[" * 5000),
    ({}, b" " * 60_000),
]


@pytest.mark.parametrize(("headers", "body"), UNUSUAL_TURNS)
def test_a_turn_is_answered_alike_on_both_ways(
    live_run: LiveRun, headers: dict[str, str], body: bytes
) -> None:
    """A request that a proxy passed on goes through ASGI; its answer is the same."""
    given = {"Content-Type": "application/json", "X-Request-Id": "one"} | headers
    directly, through_asgi = (
        live_run.client.post(
            f"{live_run.worker}/predict", content=body, headers=given | proxied
        )
        for proxied in ({}, {"X-Forwarded-For": "127.0.0.1"})
    )
    assert directly.is_client_error
    assert directly.status_code == through_asgi.status_code
    assert directly.content == through_asgi.content
    for answer in (directly, through_asgi):
        answer.headers.pop("date")
    assert directly.headers.raw == through_asgi.headers.raw
