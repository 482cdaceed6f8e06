"""Answers in parts: sent at once as far as the socket takes them, and whole."""

from __future__ import annotations

import os
import socket

import pytest

from tests.support.raw_answers import read_answer
from tests.support.server.bounded_server import parts_of, server_of_turns
from tests.support.waiting import wait_until

GET = b"GET /parts?%d HTTP/1.1\r\nHost: x\r\n\r\n"


@pytest.mark.parametrize("size", [1, 2**15, 2**16 + 1, 2**20, 3_000_001])
def test_each_part_arrives_once_and_in_order(size: int) -> None:
    """Three requests at once: the second answer begins behind the first."""
    with server_of_turns() as server, server.connect() as connection:
        connection.sendall((GET % size) * 3)
        for _ in range(3):
            assert read_answer(connection) == (200, b"".join(parts_of(size)))


@pytest.mark.parametrize("taken", [0, 1, 200, 2**16])
def test_what_a_socket_does_not_take_follows(
    taken: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """taken: how many bytes the socket takes at once; 0: it takes none now."""

    def write_some(descriptor: int, parts: list[bytes | memoryview]) -> int:
        if not taken:
            raise BlockingIOError
        return os.write(descriptor, b"".join(parts)[:taken])

    monkeypatch.setattr("os.writev", write_some)
    with server_of_turns() as server, server.connect() as connection:
        for _ in range(2):
            connection.sendall(GET % 2**16)
            assert read_answer(connection) == (200, b"".join(parts_of(2**16)))


def test_one_part_at_a_time_waits_for_a_client_that_does_not_read() -> None:
    size = 2**24
    with server_of_turns() as server, server.connect() as connection:
        connection.sendall(GET % 1)
        assert read_answer(connection)[0] == 200
        connection.sendall(GET % size)
        (one,) = server.connections
        wait_until(lambda: one.flow.write_paused, "the answer is held back")
        assert 0 < one.transport.get_write_buffer_size() <= size
        assert read_answer(connection) == (200, b"".join(parts_of(size)))


def test_a_large_last_part_has_the_time_of_its_size() -> None:
    """It may take longer than a small answer, though nothing is left to be written."""
    size = 2**26
    with server_of_turns() as server, server.connect() as connection:
        connection.sendall(GET % 1)
        assert read_answer(connection)[0] == 200
        connection.sendall(b"GET /large?%d HTTP/1.1\r\nHost: x\r\n\r\n" % size)
        (one,) = server.connections
        wait_until(lambda: one.flow.write_paused, "the answer is held back")
        later = one.loop.time() + 60
        one.loop.call_soon_threadsafe(one.check_deadlines, later)
        assert read_answer(connection) == (200, b"x" * size)


def test_a_client_on_loopback_has_a_window_that_grows() -> None:
    with server_of_turns() as server, server.connect() as connection:
        connection.sendall(GET % 1)
        assert read_answer(connection)[0] == 200
        (one,) = server.connections
        accepted = one.transport.get_extra_info("socket")
        algorithm = accepted.getsockopt(socket.IPPROTO_TCP, socket.TCP_CONGESTION, 16)
        assert algorithm.rstrip(b"\0") == b"reno"
