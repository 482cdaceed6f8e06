"""One connection cannot hold more bytes, time or requests than its limits allow."""

from __future__ import annotations

import contextlib
import socket
import time
from functools import partial

import pytest

from tests.support.raw_answers import read_answer, read_to_end
from tests.support.server import bounded_server as bounded_servers
from tests.support.server.bounded_server import BoundedServer, bounded_server
from tests.support.waiting import wait_until

GET = b"GET /now HTTP/1.1\r\nHost: x\r\n\r\n"
WAIT = b"GET /wait HTTP/1.1\r\nHost: x\r\n\r\n"
POST = b"POST /body HTTP/1.1\r\nHost: x\r\nContent-Length: %d\r\n\r\n"
CHUNKED = b"POST /body HTTP/1.1\r\nHost: x\r\nTransfer-Encoding: chunked\r\n\r\n"
KIB = 2**10


AGAIN = pytest.mark.slow("waits as long as on the other way")


@pytest.fixture(
    params=[
        pytest.param(False, id="through ASGI"),
        pytest.param(True, id="directly", marks=AGAIN),
    ],
    autouse=True,
)
def _way(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> None:
    """Every bound holds on both ways to an answer."""
    monkeypatch.setattr(bounded_servers, "is_direct", request.param)


def send_all(connection: socket.socket, data: bytes) -> None:
    """Send as much as the server reads before it hangs up."""
    with contextlib.suppress(OSError):
        connection.sendall(data)


def status_of(answer: bytes) -> int:
    return int(answer.split()[1])


# --- what is read ahead ---


def test_a_request_behind_one_in_work_is_not_begun() -> None:
    with bounded_server() as server, server.connect() as connection:
        connection.sendall(WAIT + GET + GET)
        wait_until(lambda: server.paths, "the first request arrived")
        time.sleep(0.05)
        assert server.paths == ["/wait"]
        server.release()
        for _ in range(3):
            assert read_answer(connection) == (200, b"ok")


def test_a_flood_of_pipelined_requests_is_not_kept() -> None:
    with bounded_server() as server, server.connect() as connection:
        connection.settimeout(0.3)
        send_all(connection, WAIT + GET * 400_000)  # 12 MB
        wait_until(lambda: server.paths, "the first request arrived")
        (held,) = (len(one._held) for one in server.connections)
        assert held <= server.limiter.limits.held_bytes
        assert server.paths == ["/wait"]


def test_answers_that_are_not_read_stop_the_requests_behind_them() -> None:
    with bounded_server(body_grace_s=30.0) as server, server.connect() as connection:
        connection.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
        connection.settimeout(0.3)
        large = b"GET /large?1000000 HTTP/1.1\r\nHost: x\r\n\r\n"
        send_all(connection, large * 700)  # less than is held
        assert len(server.paths) < 20  # what the kernel buffers of this machine hold
        for one in server.connections:
            assert one.transport.get_write_buffer_size() < 3 * 10**6


# --- the head ---


@pytest.mark.parametrize(
    ("sent", "status"),
    [
        (b"GET /" + b"a" * 20 * KIB + b" HTTP/1.1\r\n\r\n", 414),
        (b"GET /" + b"a" * 100 * KIB, 414),
        (b"GET / HTTP/1.1\r\nX: " + b"a" * 33 * KIB + b"\r\n\r\n", 431),
        (b"GET / HTTP/1.1\r\nX: " + b"a" * 10 * 2**20, 431),
        (b"GET / HTTP/1.1\r\n" + b"a" * 100 * KIB, 431),
        (b"GET / HTTP/1.1\r\n" + b"a:b\r\n" * 101 + b"\r\n", 431),
        (b"GET / HTTP/1.1\r\n" + b"a:b\r\n" * 10**6, 431),
        (b"\r\n" * 100 * KIB, 431),
        (CHUNKED + b"1\r\na\r\n0\r\n" + b"x: y\r\n" * 10**5, 431),
        (CHUNKED + b"1;" + b"x" * 100 * KIB, 431),
        (CHUNKED + b"1\r\na\r\n" * 10**5, 431),
        (b"nonsense\r\n\r\n", 400),
        (GET[:-2] + b"Host: y\r\n\r\n", 400),
    ],
    ids=range(13),
)
def test_a_head_beyond_the_limits_is_refused(sent: bytes, status: int) -> None:
    with bounded_server() as server, server.connect() as connection:
        send_all(connection, sent)
        answer = read_to_end(connection)
        assert status_of(answer) == status
        assert b"connection: close" in answer.lower()
        assert set(server.paths) <= {"/body"}


def test_a_head_of_just_the_limits_is_read() -> None:
    lines = b"".join(b"x-%d: b\r\n" % number for number in range(98))
    head = b"GET /now HTTP/1.1\r\nHost: x\r\n" + lines
    long = b"x: " + b"a" * (32 * KIB - len(head) - len(b"x: \r\n\r\n")) + b"\r\n"
    request = head + long + b"\r\n"
    assert len(request) == 32 * KIB
    with bounded_server() as server, server.connect() as connection:
        for _ in range(3):
            connection.sendall(request)
            assert read_answer(connection) == (200, b"ok")


@pytest.mark.parametrize("split", range(1, 8))
def test_empty_lines_before_a_request_may_come_in_pieces(split: int) -> None:
    sent = b"\r\n\r\n\r\n\r\n" + GET
    with bounded_server() as server, server.connect() as connection:
        wait_until(lambda: server.connections, "it is connected")
        (one,) = server.connections
        for part in (sent[:split], sent[split:]):
            one.loop.call_soon_threadsafe(one.data_received, part)
        assert read_answer(connection) == (200, b"ok")


def test_trailers_are_no_headers() -> None:
    with bounded_server() as server, server.connect() as connection:
        connection.sendall(CHUNKED + b"3\r\nabc\r\n0\r\nAuthorization: y\r\n\r\n")
        assert read_answer(connection) == (200, b"3")
        (one,) = server.connections
        assert [name for name, _ in one.headers] == [b"host", b"transfer-encoding"]
        connection.sendall(GET)
        assert read_answer(connection) == (200, b"ok")


def test_a_request_behind_a_chunked_body_is_left_to_another_connection() -> None:
    with bounded_server() as server, server.connect() as connection:
        connection.sendall(CHUNKED + b"3\r\nabc\r\n0\r\n\r\n" + GET)
        answer = read_to_end(connection)
        assert answer.count(b"HTTP/1.1 200") == 1
        assert b"connection: close" in answer
        assert server.paths == ["/body"]


@pytest.mark.parametrize("body", [b"", b"abc"])
def test_an_upgrade_is_not_offered(body: bytes) -> None:
    upgrade = b"Connection: Upgrade\r\nUpgrade: h2c\r\nContent-Length: %d\r\n\r\n"
    with bounded_server() as server, server.connect() as connection:
        connection.sendall(b"GET /now HTTP/1.1\r\n" + upgrade % len(body) + body)
        assert read_answer(connection) == (200, b"ok")
        if not body:
            connection.sendall(GET)
            assert read_answer(connection) == (200, b"ok")
        assert len(server.paths) == 2 - bool(body)


# --- time ---


def test_bytes_now_and_then_do_not_extend_the_time_for_a_head() -> None:
    with bounded_server(header_timeout_s=0.3) as server, server.connect() as connection:
        for byte in range(2000):
            try:
                connection.sendall(b"GET / HTTP/1.1\r\n"[byte : byte + 1] or b"a")
            except OSError:
                break
            time.sleep(0.01)
        else:
            pytest.fail("the connection was never closed")
        assert server.paths == []


def test_a_body_that_is_slower_than_the_least_rate_is_not_waited_for() -> None:
    limits = {"body_grace_s": 0.2, "rate_min": 1000}
    with bounded_server(**limits) as server, server.connect() as connection:
        connection.sendall(POST % 10**6)
        for _ in range(300):
            send_all(connection, b"a")
            time.sleep(0.01)
        wait_until(lambda: not server.connections, "the connection is closed")


def test_a_body_that_is_fast_enough_may_take_long() -> None:
    limits = {"body_grace_s": 0.2, "rate_min": 100}
    with bounded_server(**limits) as server, server.connect() as connection:
        connection.sendall(POST % 1000 + b"a" * 400)  # it may take 4 s so far
        for _ in range(6):
            time.sleep(0.06)
            connection.sendall(b"a" * 100)
        assert read_answer(connection) == (200, b"1000")


def test_the_rest_of_a_refused_body_is_read_for_a_while_only() -> None:
    with bounded_server(body_grace_s=0.2) as server, server.connect() as connection:
        connection.sendall(b"POST /now HTTP/1.1\r\nContent-Length: 9999\r\n\r\nabc")
        assert read_answer(connection) == (200, b"ok")
        assert read_to_end(connection) == b""


def test_an_answer_that_is_not_read_is_not_kept() -> None:
    with bounded_server(body_grace_s=0.2) as server, server.connect() as connection:
        connection.sendall(b"GET /large?50000000 HTTP/1.1\r\nHost: x\r\n\r\n")
        wait_until(lambda: server.paths, "the request arrived")
        # Its length counts in the time that it has: 50 MB at 16 KiB/s are long.
        (one,) = server.connections
        wait_until(lambda: one.flow.write_paused, "the answer is held back")
        one.loop.call_soon_threadsafe(setattr, one, "_write_deadline", 0.0)
        wait_until(lambda: not server.connections, "the connection is closed")


def test_a_small_answer_that_is_not_read_is_not_kept() -> None:
    limits = {"body_grace_s": 0.2, "keep_alive_s": 60.0, "rate_min": 10**9}
    with bounded_server(**limits) as server, server.connect() as connection:
        connection.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
        connection.settimeout(0.1)
        send_all(connection, GET * 500_000)
        wait_until(lambda: not server.connections, "the connection is closed")


def test_an_idle_connection_is_closed() -> None:
    with bounded_server(keep_alive_s=0.2) as server, server.connect() as connection:
        connection.sendall(GET)
        assert read_answer(connection) == (200, b"ok")
        assert read_to_end(connection) == b""


def test_a_request_in_work_is_waited_for() -> None:
    limits = {"header_timeout_s": 1.0, "keep_alive_s": 1.0, "body_grace_s": 1.0}
    with bounded_server(**limits) as server, server.connect() as connection:
        connection.sendall(WAIT)
        time.sleep(1.5)
        server.release()
        assert read_answer(connection) == (200, b"ok")


# --- bodies ---


def test_an_unread_body_is_not_kept() -> None:
    with bounded_server() as server, server.connect() as connection:
        connection.sendall(b"POST /now HTTP/1.1\r\nContent-Length: 200000\r\n\r\n")
        connection.sendall(b"a" * 200_000)
        assert read_answer(connection) == (200, b"ok")
        (one,) = server.connections
        assert len(one.cycle.body) == 0


def is_holder(server: BoundedServer, connection: socket.socket) -> bool:
    """Whether the server has received a part of a body from this connection."""
    held = server.limiter.bodies._by_connection
    own = connection.getsockname()
    return any(
        one.transport.get_extra_info("peername") == own
        for one in server.connections
        if one in held
    )


def test_large_bodies_together_have_a_bound() -> None:
    limits = {"small_body_bytes": 1000, "bodies_bytes": 10_000}
    with contextlib.ExitStack() as stack:
        server = stack.enter_context(bounded_server(**limits))
        slow = [stack.enter_context(server.connect()) for _ in range(12)]
        for connection in slow:
            connection.sendall(POST % 5000 + b"a" * 1500)
            wait_until(partial(is_holder, server, connection), "its body arrived")
        refused = [read_answer(one) for one in slow[:6]]
        assert {status for status, _ in refused} == {503}
        assert b'"code":"unavailable"' in refused[0][1]
        for connection in slow[6:]:
            connection.sendall(b"a" * 100)
        small = stack.enter_context(server.connect())
        small.sendall(POST % 900 + b"a" * 900)
        assert read_answer(small) == (200, b"900")


@pytest.mark.parametrize("path", [b"/body", b"/now"])
def test_who_sends_on_after_an_answer_reads_it_and_meets_no_reset(path: bytes) -> None:
    """Uploads side by side, of which some are refused and others answered at once.

    Each looks for its answer when it has sent all. Expect one for each.
    """
    limits: dict[str, float] = {"small_body_bytes": 1000, "bodies_bytes": 2**18}
    limits |= {
        "body_bytes": 2**17,
        "body_grace_s": 0.2,
        "close_s": 0.05,
        "passed_over_rate_min": 2**10,
    }
    size, part = 2**21, b"a" * 2**16
    with contextlib.ExitStack() as stack:
        server = stack.enter_context(bounded_server(**limits))
        uploads = [stack.enter_context(server.connect()) for _ in range(8)]
        for upload in uploads:
            upload.sendall(POST.replace(b"/body", path) % size)
        for number in range(size // len(part)):
            for upload in uploads:
                upload.sendall(part)
            if number < 8:
                time.sleep(0.05)  # some checks of all deadlines
        statuses = [status for status, _ in map(read_answer, uploads)]
    assert set(statuses) <= {200, 503}
    assert 503 in statuses or path == b"/now"


def test_who_sends_nothing_after_a_refusal_is_hung_up_on() -> None:
    limits = {"small_body_bytes": 1000, "bodies_bytes": 1000, "body_grace_s": 0.05}
    with bounded_server(**limits) as server, server.connect() as connection:
        connection.sendall(POST % 5000 + b"a" * 1500)
        assert read_answer(connection)[0] == 503
        wait_until(lambda: not server.connections, "it is closed")


# --- how many ---


def test_an_idle_connection_gives_way_to_a_new_one() -> None:
    with contextlib.ExitStack() as stack:
        server = stack.enter_context(bounded_server(connections=5))
        idle = [stack.enter_context(server.connect()) for _ in range(20)]
        for connection in idle:
            send_all(connection, GET[:3])
        fresh = stack.enter_context(server.connect())
        fresh.sendall(GET)
        assert read_answer(fresh) == (200, b"ok")
        assert len(server.limiter) <= 5
        assert read_to_end(idle[0]) == b""


def test_a_connection_beyond_the_limit_is_refused_as_unavailable() -> None:
    with contextlib.ExitStack() as stack:
        server = stack.enter_context(bounded_server(connections=5))
        for _ in range(5):
            stack.enter_context(server.connect()).sendall(WAIT)
        wait_until(lambda: len(server.paths) == 5, "all are in work")
        beyond = stack.enter_context(server.connect())
        beyond.sendall(GET)
        answer = read_to_end(beyond)
        assert status_of(answer) == 503
        for part in (b"retry-after: 1", b"proctor-version: 1", b"unavailable"):
            assert part in answer.lower()
        silent = stack.enter_context(server.connect())
        assert read_to_end(silent) == b""  # after the time for a refusal
        server.release()


def test_one_address_cannot_have_all_connections() -> None:
    limits = {"connections": 6, "per_address": 4}
    other = {"source_address": ("127.0.0.2", 0)}
    with contextlib.ExitStack() as stack:
        server = stack.enter_context(bounded_server(**limits))
        earlier = stack.enter_context(server.connect(**other))
        earlier.sendall(GET)
        assert read_answer(earlier) == (200, b"ok")
        many = [stack.enter_context(server.connect()) for _ in range(8)]
        for connection in many:
            send_all(connection, WAIT)
        wait_until(lambda: len(server.paths) == 5, "four of them are in work")
        for connection in (earlier, stack.enter_context(server.connect(**other))):
            connection.sendall(GET)
            assert read_answer(connection) == (200, b"ok")
        server.release()
