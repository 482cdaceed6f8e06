"""Requests that are too much: refused as documented, and nothing else is disturbed.

Limits of one connection are tested in test_bounded_connection.py; random requests, long
headers and the ids of other accounts are attacks of tests/campaigns/.
"""

import asyncio
import contextlib
import socket
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import httpx
import msgspec
import pytest

from reference_server.generated.problem_codes import PROBLEMS
from tests.support.raw_answers import read_to_end
from tests.support.repository.answer_schemas import check_answer
from tests.support.servers import TIMEOUT_S, TOKENS, ReferenceServer
from tests.support.sim.calibration_action import calibration_action

pytestmark = pytest.mark.slow("starts servers or kits")

LONG_POLLS = 200


class LiveRun:
    """A server and a run on it with one live session, used by no other test."""

    def __init__(self, server: ReferenceServer) -> None:
        self.server = server
        self.client = server.client()
        self.address = (self.client.base_url.host, self.client.base_url.port)
        body = {"benchmark_id": "calibration", "policy": {"name": "p"}}
        self.run = self.client.post("/v1/runs", json=body).json()
        self.path = f"/v1/runs/{self.run['run_id']}"
        self.worker = f"{self.path}/workers/w"
        attached = self.client.put(self.worker, json={"attach_key": "key"})
        self.session_id = attached.json()["session_id"]

    def snapshot(self) -> list[Any]:
        """Everything that can be read of the run."""
        paths = (self.path, f"{self.path}/episodes", f"{self.path}/score")
        return [self.client.get(path).json() for path in paths]

    def action(self) -> dict[str, list[float]]:
        return calibration_action()

    def raw(self, request: bytes) -> bytes:
        """The answer to bytes of any kind; empty when the server only hung up."""
        with socket.create_connection(self.address, TIMEOUT_S) as connection:
            # The server may stop listening before all is said.
            with contextlib.suppress(OSError):
                connection.sendall(request)
            return read_to_end(connection)


@pytest.fixture(scope="module")
def live_run(tmp_path_factory: pytest.TempPathFactory) -> Iterator[LiveRun]:
    server = ReferenceServer(tmp_path_factory.mktemp("limits"))
    live_run = LiveRun(server)
    yield live_run
    live_run.client.close()
    server.end()


@pytest.fixture(autouse=True)
def _live_run_is_unchanged(live_run: LiveRun) -> Iterator[None]:
    before = live_run.snapshot()
    yield
    assert live_run.snapshot() == before
    assert "Traceback" not in live_run.server.log()


def assert_problem(answer: httpx.Response, code: str) -> None:
    body = answer.json()
    assert body["code"] == code, body
    assert answer.status_code == PROBLEMS[code]["status"]
    assert answer.headers["content-type"] == "application/problem+json"
    assert answer.headers["proctor-version"] == "1.0"
    check_answer("Problem", body)


def memory(pid: int) -> int:
    """The bytes that a process holds now."""
    status = Path(f"/proc/{pid}/status").read_text()
    return int(status.partition("VmRSS:")[2].split()[0]) * 1024


# --- size ---


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
        until(lambda: memory(pid) - before > 40 * 2**20)
    until(lambda: memory(pid) - before < 20 * 2**20)


def until(is_true: Callable[[], bool]) -> None:
    deadline = time.monotonic() + TIMEOUT_S
    while not is_true():
        assert time.monotonic() < deadline
        time.sleep(0.05)


# --- form ---


def request(path: str | bytes, lines: bytes = b"", method: bytes = b"GET") -> bytes:
    path = path.encode() if isinstance(path, str) else path
    token = TOKENS["alice"].encode()
    return (
        method + b" " + path + b" HTTP/1.1\r\nHost: x\r\nConnection: close\r\n"
        b"Authorization: Bearer " + token + b"\r\n" + lines + b"\r\n"
    )


def assert_refused_or_fine(answer: bytes) -> None:
    """A problem of the catalogue, or the refusal of the HTTP layer below it."""
    head, _, body = answer.partition(b"\r\n\r\n")
    status = int(head.split(b" ")[1])
    assert status < 500, answer
    if status >= 400 and b"problem+json" in head:
        assert PROBLEMS[msgspec.json.decode(body)["code"]]["status"] == status


ODD = [b"%00", b"%ff", b"%zz", b"%", b"a%2Fb", b"..", b"%2e%2e", b"%0d%0a", b"~" * 9999]
RAW = [*ODD, b"\x00", b"\xff", b"\x80\x81", b"\x7f", b"\x01", b"a b", b"[", b"#", b"\\"]


@pytest.mark.parametrize("odd", RAW, ids=lambda odd: repr(odd[:8]))
def test_odd_bytes_in_a_path_find_nothing(live_run: LiveRun, odd: bytes) -> None:
    token = live_run.path.encode()
    for path in (
        b"/" + odd,
        b"/v1/runs/" + odd,
        b"/v1/benchmarks/" + odd,
        token + b"/" + odd,
        token + b"/workers/" + odd + b"/predict",
        b"/v1/runs?cursor=" + odd,
        token + b"?" + odd + b"=1",
    ):
        assert_refused_or_fine(live_run.raw(request(path)))
    deleted = request(
        live_run.worker.encode() + b"?session_id=" + odd, method=b"DELETE"
    )
    assert_refused_or_fine(live_run.raw(deleted))


@pytest.mark.parametrize(
    "sent",
    [
        b"GET\r\n\r\n",
        b"\x16\x03\x01\x00\xa5\x01\x00\x00\r\n\r\n",
        b"PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n",
        request("*"),
        request("/v1", b"no colon\r\n"),
        request("/v1", b"X: \x00\r\n"),
        request("/v1", b": empty\r\n"),
        request("/v1/runs", b"Content-Length: -1\r\n", b"POST"),
        request("/v1/runs", b"Content-Length: 1\r\nContent-Length: 2\r\n", b"POST"),
        request("/v1/runs", b"Transfer-Encoding: chunked\r\n", b"POST") + b"zz\r\n\r\n",
        request("/v1", b"", b"BREW"),
        request("/v1", b"", b"TRACE"),
        request("/v1", b"Upgrade: websocket\r\nConnection: Upgrade\r\n"),
    ],
    ids=lambda sent: repr(sent[-20:]),
)
def test_bytes_that_are_no_request_break_nothing(
    live_run: LiveRun, sent: bytes
) -> None:
    answer = live_run.raw(sent)
    if answer:
        assert_refused_or_fine(answer)


def test_a_body_that_breaks_off_breaks_nothing(live_run: LiveRun) -> None:
    lines = b"Content-Type: application/json\r\nContent-Length: 99\r\n"
    with socket.create_connection(live_run.address, TIMEOUT_S) as connection:
        connection.sendall(request("/v1/runs", lines, b"POST") + b'{"bench')
    bad = request("/v1/runs", lines[:32] + b"Transfer-Encoding: chunked\r\n", b"POST")
    live_run.raw(bad + b"3\r\n{}}\r\nnonsense\r\n\r\n")


@pytest.mark.parametrize(
    "secret", [b"unknown", b"\xc3\xa9", b"\xff", b"a b", b"a" * 10**4], ids=len
)
def test_requests_without_a_valid_token_are_refused(
    live_run: LiveRun, secret: bytes
) -> None:
    headers = {b"Authorization": b"Bearer " + secret}
    with httpx.Client(base_url=live_run.client.base_url, trust_env=False) as anonymous:
        for method, path in (
            ("GET", "/v1/runs"),
            ("GET", live_run.path),
            ("POST", f"{live_run.path}/stop"),
            ("PUT", live_run.worker),
            ("POST", f"{live_run.worker}/predict"),
            ("DELETE", f"{live_run.worker}?session_id={live_run.session_id}"),
        ):
            answer = anonymous.request(method, path, headers=headers)
            assert_problem(answer, "unauthenticated")


# --- slow and waiting requests ---


def test_a_slow_body_delays_no_other_request(live_run: LiveRun) -> None:
    body = b'{"attach_key":"key"}'
    lines = f"Content-Type: application/json\r\nContent-Length: {len(body)}\r\n"
    with socket.create_connection(live_run.address, TIMEOUT_S) as slow:
        slow.sendall(request(live_run.worker, lines.encode(), b"PUT") + body[:1])
        for _ in range(20):
            assert live_run.client.get(live_run.path).status_code == 200
        slow.setblocking(False)
        with pytest.raises(BlockingIOError):
            slow.recv(1)
        slow.settimeout(TIMEOUT_S)
        slow.sendall(body[1:])
        assert slow.recv(12) == b"HTTP/1.1 200"


async def test_many_long_polls_delay_no_other_request(live_run: LiveRun) -> None:
    body = {"benchmark_id": "calibration", "policy": {"name": "p"}}
    path = live_run.client.post("/v1/runs", json=body).headers["location"]
    # run.endpoint names the host that was asked, and so does the ETag.
    etag = live_run.client.get(path, headers={"Host": "x"}).headers["etag"]
    poll_headers = f"If-None-Match: {etag}\r\nPrefer: wait=30\r\n"
    ends = [await asyncio.open_connection(*live_run.address) for _ in range(LONG_POLLS)]
    silent = [await asyncio.open_connection(*live_run.address) for _ in range(50)]
    for _, writer in ends:
        writer.write(request(path, poll_headers.encode()))
        await writer.drain()
    polls = [asyncio.create_task(reader.read()) for reader, _ in ends]
    # All of them arrived before the first of these, which find the server awake.
    for _ in range(20):
        answer = await asyncio.to_thread(live_run.client.get, path)
        assert answer.status_code == 200
    assert not any(poll.done() for poll in polls)
    await asyncio.to_thread(live_run.client.post, f"{path}/stop", json={})
    async with asyncio.timeout(TIMEOUT_S / 2):  # long before they would give up
        answers = await asyncio.gather(*polls)
    for answer_bytes in answers:
        assert answer_bytes.startswith(b"HTTP/1.1 200")
        assert b'"state":"stopped"' in answer_bytes
    for _, writer in [*ends, *silent]:
        writer.close()
        with contextlib.suppress(ConnectionError):
            await writer.wait_closed()


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
