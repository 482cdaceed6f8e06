"""Connections without a token: pipelines, endless heads, slow and idle connections.

Every flood has a bound on connections and on the bytes that it sends.
"""

from __future__ import annotations

import contextlib
import socket
import time
from collections.abc import Iterator

from conformance.client.connections.raw_connection import open_raw_connection
from tests.campaigns.attack.attack import Attack, Target
from tests.campaigns.players.raw_client import NoAnswer, try_request
from tests.campaigns.players.run_history import Report

GET = b"GET /v1 HTTP/1.1\r\nHost: x\r\n\r\n"
MIB = 2**20
CHUNKED = b"POST /v1/runs HTTP/1.1\r\nHost: x\r\nTransfer-Encoding: chunked\r\n\r\n"
HEADS = {
    "a long path": (b"GET /", b"a" * 4096),
    "a long header": (b"GET /v1 HTTP/1.1\r\nX: ", b"a" * 4096),
    "many headers": (b"GET /v1 HTTP/1.1\r\n", b"x-header: value\r\n" * 256),
    "empty lines": (b"", b"\r\n" * 2048),
    "trailers": (CHUNKED + b"1\r\na\r\n0\r\n", b"x-trailer: value\r\n" * 256),
    "a long chunk size": (CHUNKED + b"1;", b"x" * 4096),
    "small chunks": (CHUNKED, b"1\r\na\r\n" * 700),
}


@contextlib.contextmanager
def many_connections(target: Target, count: int) -> Iterator[list[socket.socket]]:
    """As many connections as the server accepts, up to a number; not blocking."""
    with contextlib.ExitStack() as stack:
        opened = []
        for _ in range(count):
            with contextlib.suppress(OSError):
                client = stack.enter_context(target.client(timeout_s=5.0))
                connection = client.connect()
                connection.setblocking(False)
                opened.append(connection)
        yield opened


def send_to_all(connections: list[socket.socket], data: bytes) -> int:
    """Bytes that the kernel and the server took, without waiting."""
    sent = 0
    for connection in connections:
        with contextlib.suppress(OSError):
            sent += connection.send(data)
    return sent


def flood_pipelines(target: Target) -> Report:
    """Requests in a row whose answers are not read, up to 16 MiB per connection."""
    report, block = Report(), GET * 2000
    with many_connections(target, target.count(8)) as connections:
        left = len(connections) * 16 * MIB
        deadline = target.deadline()
        while left > 0 and time.monotonic() < deadline:
            sent = send_to_all(connections, block)
            left -= sent
            report.sent += sent // len(GET)
            if not sent:
                time.sleep(0.01)
    return report


def send_endless_heads(target: Target) -> Report:
    """Each form of a head that does not end: 16 MiB of it, on several connections."""
    report = Report()
    deadline = target.deadline()
    while time.monotonic() < deadline:
        for name, (start, more) in HEADS.items():
            report.sent += 1
            with open_raw_connection(target.url) as connection:
                sent = start + more * (16 * MIB // len(more))
                ending = connection.send_until_end(sent, 10.0)
            report.answers[str(ending.status or "closed")] += 1
            if not ending.is_closed:
                report.violations.append(f"{name}: {ending}")
        _send_split_lines(target, report)
    return report


def _send_split_lines(target: Target, report: Report) -> None:
    """Empty lines before a request, whose last byte comes later; it is answered."""
    report.sent += 1
    with target.client(timeout_s=10.0) as client:
        connection = client.connect()
        connection.sendall(b"\r\n\r")
        time.sleep(0.05)
        connection.sendall(b"\n" + GET)
        try:
            answer = connection.recv(64)
        except TimeoutError:
            answer = b""
    report.answers[answer[9:12].decode("ascii", "replace") or "no answer"] += 1
    if not answer.startswith(b"HTTP/1.1 200"):
        report.violations.append(f"split empty lines: {answer!r}")


def open_slow_connections(target: Target) -> Report:
    """1,000 heads and bodies that come byte by byte; all must be closed in time.

    The server's time for a head is 2 s here; a body has 1 s more per 16 KiB.
    """
    report = Report()
    starts = (b"", GET[:20], b"POST /v1/runs HTTP/1.1\r\nContent-Length: 9999\r\n\r\n")
    with many_connections(target, 1000) as connections:
        report.sent = len(connections)
        for number, start in enumerate(starts):
            send_to_all(connections[number :: len(starts)], start)
        deadline = time.monotonic() + 8
        left = connections
        while left and time.monotonic() < deadline:
            time.sleep(0.25)
            send_to_all(left, b"a")
            left = [one for one in left if not _is_closed(one)]
        report.figures["still_open"] = len(left)
        if left:
            report.violations.append(f"{len(left)} slow connections were not closed")
    return report


def _is_closed(connection: socket.socket) -> bool:
    try:
        return not connection.recv(4096)
    except BlockingIOError:
        return False
    except OSError:
        return True


def hold_idle_connections(target: Target) -> Report:
    """1,100 connections that send nothing, at a server with 1,024 descriptors."""
    with many_connections(target, 1100) as connections:
        report = Report(sent=len(connections))
        deadline = target.deadline()
        with target.client() as client:
            while time.monotonic() < deadline:
                try:
                    report.add_answer(try_request(client, "GET", "/v1"))
                except NoAnswer:
                    report.hangs += 1
                time.sleep(0.05)
    return report


def burst(target: Target) -> Report:
    """500 connections, each with a request that is sent at the same moment."""
    report = Report()
    deadline = target.deadline()
    with many_connections(target, 500) as connections:
        request = target.client().head("GET", "/v1/runs", {})
        while True:
            report.sent += send_to_all(connections, request) // len(request)
            time.sleep(1.0)
            if time.monotonic() > deadline:
                return report


def vary_long_headers(target: Target) -> Report:
    """Headers that are read, each another and 30 KiB long, up to 60 MiB together."""
    report = Report()
    with target.client() as client:
        deadline = target.deadline()
        for number in range(target.count(2000)):
            long = f"1.{number}" + "0" * 30_000
            name = ("Proctor_Version", "Accept", "Prefer", "If_None_Match")[number % 4]
            header = {name: long.replace("0", ",") if number % 8 > 4 else long}
            report.add_answer(try_request(client, "GET", "/v1/runs", **header))
            if time.monotonic() > deadline:
                break
    return report


ATTACKS = (
    Attack(
        "pipelines",
        "requests in a row, answers unread",
        "8 connections, 16 MiB each",
        flood_pipelines,
        long_size=4,
    ),
    Attack(
        "endless heads",
        "paths, headers, trailers, chunks without end",
        "16 MiB each, one connection",
        send_endless_heads,
    ),
    Attack(
        "long headers",
        "headers of 30 KiB, each another",
        "2,000 requests",
        vary_long_headers,
    ),
    Attack(
        "bursts",
        "requests of many connections at one moment",
        "500 connections, once a second",
        burst,
    ),
    Attack(
        "slow connections",
        "heads and bodies byte by byte",
        "1,000 connections, 8 s",
        open_slow_connections,
        settings={"PROCTOR_REQUEST_TIMEOUT_S": "2"},
    ),
    Attack(
        "idle connections",
        "nothing, at 1,024 descriptors",
        "1,100 connections",
        hold_idle_connections,
        prefix=("sh", "-c", 'ulimit -n 1024; exec "$@"', "sh"),
    ),
)
