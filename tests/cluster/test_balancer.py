"""The balancer of `make cluster`: which node a connection is given to."""

from __future__ import annotations

import asyncio
import contextlib
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager

import pytest

from tools.local_cluster import balancer as balancer_module
from tools.local_cluster.balancer import HOST, Balancer

QUESTION = b"GET /readyz"
OK, REFUSED = (
    f"HTTP/1.1 {status}\r\nContent-Length: 0\r\nConnection: close\r\n\r\n".encode()
    for status in ("200 OK", "503 Service Unavailable")
)


class Node:
    """Answers with its name, and each question of the balancer with `health`.

    health: empty: it says nothing. What begins with "wait" gets no answer.
    """

    def __init__(self, name: bytes) -> None:
        self.name, self.health = name, OK
        self.asked = asyncio.Event()
        self.port = 0

    async def serve(
        self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter
    ) -> None:
        try:
            while line := await reader.readline():
                if line.startswith(QUESTION):
                    self.asked.set()
                    if not self.health:
                        await reader.read()  # until the balancer closes it
                    writer.write(self.health)
                    break
                if not line.startswith(b"wait"):
                    writer.write(self.name + b"\n")
        finally:
            writer.close()


@asynccontextmanager
async def balanced() -> AsyncIterator[tuple[int, Node, Node]]:
    """The port of the balancer, and the two nodes behind it, both ready."""
    nodes = Node(b"first"), Node(b"second")
    servers = [await asyncio.start_server(node.serve, HOST, 0) for node in nodes]
    for node, server in zip(nodes, servers, strict=True):
        node.port = server.sockets[0].getsockname()[1]
    balancer = Balancer([(HOST, node.port) for node in nodes])
    servers.append(await balancer.listen(HOST, 0))
    try:
        yield servers[-1].sockets[0].getsockname()[1], *nodes
    finally:
        await balancer.close()
        for server in servers:
            server.close()


async def name_at(port: int) -> bytes:
    """Of the node that a new connection is given to."""
    reader, writer = await asyncio.open_connection(HOST, port)
    writer.write(b"request\n")
    name = await reader.readline()
    writer.close()
    return name.strip()


@pytest.fixture(autouse=True)
def _hurry(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(balancer_module, "CHECK_EVERY_S", 0.02)
    monkeypatch.setattr(balancer_module, "SILENT_S", 10.0)


@pytest.fixture
def _notices_silence_soon(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(balancer_module, "SILENT_S", 0.3)


async def until_alone(port: int, name: bytes) -> None:
    """Until both of two connections in a row are given to this node."""
    while {await name_at(port), await name_at(port)} != {name}:  # noqa: ASYNC110
        await asyncio.sleep(0.01)


async def test_connections_are_given_to_the_nodes_in_turn() -> None:
    async with balanced() as (port, _first, _second):
        names = [await name_at(port) for _ in range(4)]
        assert names == [b"first", b"second", b"first", b"second"]


@pytest.mark.usefixtures("_notices_silence_soon")
@pytest.mark.parametrize("health", [REFUSED, b""])
async def test_a_node_that_is_not_ready_gets_no_connection_until_it_is(
    health: bytes,
) -> None:
    async with balanced() as (port, first, second):
        first.health = health
        await until_alone(port, b"second")
        first.health, second.health = OK, health
        await until_alone(port, b"first")


async def test_a_node_that_refuses_keeps_the_connections_that_it_has() -> None:
    """It ends: its answers are completed."""
    async with balanced() as (port, first, _second):
        reader, writer = await asyncio.open_connection(HOST, port)
        writer.write(b"request\n")
        assert await reader.readline() == b"first\n"
        first.health = REFUSED
        await until_alone(port, b"second")
        writer.write(b"request\n")
        assert await reader.readline() == b"first\n"
        writer.close()


@pytest.mark.usefixtures("_notices_silence_soon")
async def test_who_waits_for_a_node_that_says_nothing_is_disconnected() -> None:
    """A client may wait for long: a turn may take long."""
    async with balanced() as (port, first, _second):
        reader, writer = await asyncio.open_connection(HOST, port)
        writer.write(b"wait\n")
        first.health = b""
        with contextlib.suppress(ConnectionError):
            assert await reader.read() == b""
        writer.close()


async def test_if_no_node_is_ready_each_is_tried() -> None:
    async with balanced() as (port, first, second):
        first.health = second.health = REFUSED
        for node in (first, second):
            node.asked.clear()
            await node.asked.wait()
        assert {await name_at(port), await name_at(port)} == {b"first", b"second"}
