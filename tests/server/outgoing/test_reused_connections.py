"""Connections between nodes: used again, and cheap however many there are."""

from __future__ import annotations

import asyncio
import contextlib
from collections.abc import AsyncIterator, Callable

import httpcore
import pytest
import uvloop

from reference_server.outgoing import reused_connections
from reference_server.outgoing.outgoing_connection import OutgoingConnection
from reference_server.outgoing.reused_connections import ReusedConnections
from tests.support.waiting import wait_in_loop

LOOPS = (asyncio.new_event_loop, uvloop.new_event_loop)
LOOP_NAMES = ("asyncio", "uvloop")
HOST = "127.0.0.1"
ANSWER = b"HTTP/1.1 200 OK\r\nContent-Length: 2\r\n\r\nok"


class _Server:
    """Answers when `may_answer` is set. writers: of the connections it has had."""

    answer = ANSWER

    def __init__(self) -> None:
        self.writers: list[asyncio.StreamWriter] = []
        self.may_answer = asyncio.Event()
        self._asked, self._left = asyncio.Semaphore(0), asyncio.Semaphore(0)
        self.url = httpcore.URL("http://none")

    @classmethod
    @contextlib.asynccontextmanager
    async def open(cls) -> AsyncIterator[_Server]:
        one = cls()
        async with await asyncio.start_server(one._serve, HOST, 0) as server:
            port = server.sockets[0].getsockname()[1]
            one.url = httpcore.URL(f"http://{HOST}:{port}/path")
            yield one
            for writer in one.writers:
                writer.close()

    async def _serve(
        self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter
    ) -> None:
        self.writers.append(writer)
        with contextlib.suppress(asyncio.IncompleteReadError, ConnectionError):
            while await reader.readuntil(b"\r\n\r\n"):
                self._asked.release()
                await self.may_answer.wait()
                writer.write(self.answer)
        self._left.release()

    async def was_left(self, count: int) -> None:
        """So many connections were closed since the last call."""
        async with asyncio.timeout(30):
            for _ in range(count):
                await self._left.acquire()

    async def was_asked(self, count: int) -> None:
        """So many times since the last call."""
        async with asyncio.timeout(30):
            for _ in range(count):
                await self._asked.acquire()


async def _ask(connections: ReusedConnections, server: _Server) -> None:
    headers = [(b"host", b"node")]
    async with connections.stream("GET", server.url, headers=headers) as response:
        assert await response.aread() == b"ok"


async def test_one_request_after_another_uses_one_connection() -> None:
    async with _Server.open() as server:
        server.may_answer.set()
        connections = ReusedConnections(10, expiry_s=30.0)
        for _ in range(3):
            await _ask(connections, server)
        assert len(server.writers) == 1
        connections.close()


async def test_a_request_waits_for_its_place_for_a_while(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    async with _Server.open() as server:
        connections = ReusedConnections(1, expiry_s=30.0)
        first = asyncio.create_task(_ask(connections, server))
        await server.was_asked(1)
        with monkeypatch.context() as patched:
            patched.setattr(reused_connections, "PLACE_TIMEOUT_S", 0.01)
            with pytest.raises(httpcore.PoolTimeout):
                await _ask(connections, server)
        second = asyncio.create_task(_ask(connections, server))
        server.may_answer.set()
        await asyncio.gather(first, second)
        assert len(server.writers) == 1
        connections.close()


@pytest.mark.parametrize("new_loop", LOOPS, ids=LOOP_NAMES)
def test_a_slow_reader_leaves_a_connection_on_which_answers_are_read(
    new_loop: Callable[[], asyncio.AbstractEventLoop],
) -> None:
    """An answer that is here as a whole, but not yet taken, ends no reading for good.

    size: more than is received of an answer that is not complete.
    """
    size = 2**18 + 2**16

    async def ask_slowly(connections: ReusedConnections, server: _Server) -> None:
        headers = [(b"host", b"node")]
        async with connections.stream("GET", server.url, headers=headers) as response:
            transport = response._transport
            assert transport is not None
            await wait_in_loop(
                lambda: response._is_answered or not transport.is_reading()
            )
            assert len(await response.aread()) == size

    async def ask_again() -> None:
        async with asyncio.timeout(30), _Server.open() as server:
            server.answer = b"HTTP/1.1 200 OK\r\nContent-Length: %d\r\n\r\n" % size
            server.answer += bytes(size)
            server.may_answer.set()
            connections = ReusedConnections(1, expiry_s=30.0)
            for _ in range(5):
                await ask_slowly(connections, server)
            assert len(server.writers) == 1
            connections.close()

    with asyncio.Runner(loop_factory=new_loop) as runner:
        runner.run(ask_again())


@pytest.mark.parametrize("is_closed_by", ["the node", "its age"])
async def test_a_connection_that_has_ended_is_not_used_again(is_closed_by: str) -> None:
    async with _Server.open() as server:
        server.may_answer.set()
        is_old = is_closed_by == "its age"
        connections = ReusedConnections(10, expiry_s=0.0 if is_old else 30.0)
        await _ask(connections, server)
        if not is_old:
            server.writers[0].close()
            await server.writers[0].wait_closed()
        await _ask(connections, server)
        assert len(server.writers) == 2
        connections.close()


async def test_a_request_that_was_given_up_leaves_no_connection_to_others() -> None:
    """The late answer would be read as the one to the next request."""
    async with _Server.open() as server:
        connections = ReusedConnections(1, expiry_s=30.0)
        given_up = asyncio.ensure_future(_ask(connections, server))
        await server.was_asked(1)
        given_up.cancel()
        with contextlib.suppress(asyncio.CancelledError):
            await given_up
        server.may_answer.set()
        await _ask(connections, server)  # the only place is free again
        assert len(server.writers) == 2
        connections.close()


async def test_many_requests_at_once_look_at_each_connection_a_few_times(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """A pool that looks at all of them each time is busy with nothing else."""
    count, looks = 150, 0
    has_expired = OutgoingConnection.has_expired

    def look(connection: OutgoingConnection, expiry_s: float) -> bool:
        nonlocal looks
        looks += 1
        return has_expired(connection, expiry_s)

    monkeypatch.setattr(OutgoingConnection, "has_expired", look)
    async with _Server.open() as server:
        connections = ReusedConnections(count, expiry_s=30.0)
        for _ in range(2):  # over new connections, and over those that have none
            server.may_answer.clear()
            asked = [
                asyncio.ensure_future(_ask(connections, server)) for _ in range(count)
            ]
            await server.was_asked(count)
            server.may_answer.set()
            await asyncio.gather(*asked)
        assert len(server.writers) == count
        connections.close()
    assert looks <= 6 * count


async def test_connections_that_have_no_use_are_closed_without_another_request() -> (
    None
):
    """A node that has ended, or has nothing to do: its connections take descriptors."""
    count = 20
    async with _Server.open() as server:
        connections = ReusedConnections(count, expiry_s=0.05)
        asked = [asyncio.ensure_future(_ask(connections, server)) for _ in range(count)]
        await server.was_asked(count)
        server.may_answer.set()
        await asyncio.gather(*asked)
        await server.was_left(count)
        connections.close()


async def test_a_connection_that_could_not_be_opened_is_not_kept() -> None:
    async with _Server.open() as server:
        pass
    connections = ReusedConnections(1, expiry_s=30.0)
    with pytest.raises(httpcore.ConnectError):
        await _ask(connections, server)
    assert not connections._idle
    connections.close()


async def test_what_is_under_way_at_the_end_leaves_no_connection() -> None:
    async with _Server.open() as server:
        connections = ReusedConnections(1, expiry_s=30.0)
        asked = asyncio.ensure_future(_ask(connections, server))
        await server.was_asked(1)
        connections.close()
        server.may_answer.set()
        await asked
        await server.was_left(1)
