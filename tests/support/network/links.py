"""Connections between programs that a test can cut, hold, delay, or lose answers of.

A `Link` listens and passes each connection on to one address. All links are served by
one thread, `LinkThread`; its other methods may be called from any thread.
"""

from __future__ import annotations

import asyncio
import random
import threading
from collections.abc import Awaitable, Callable, Coroutine
from pathlib import Path
from typing import Any, Self, TypeVar

Found = TypeVar("Found")
BLOCK_BYTES = 2**16
HOST = "127.0.0.1"
Streams = tuple[asyncio.StreamReader, asyncio.StreamWriter]


class Link:
    """One way to a program. connect: to it; raises OSError.

    delay_s: of each block of bytes. loss: the part of the answers, block by block, for
    which the connection is closed instead.
    """

    def __init__(
        self, connect: Callable[[], Awaitable[Streams]], chance: random.Random
    ) -> None:
        self._connect, self._chance = connect, chance
        self.delay_s = self.loss = 0.0
        self._is_cut = False
        self._passes = asyncio.Event()
        self._passes.set()
        self._writers: set[asyncio.StreamWriter] = set()

    def cut(self) -> None:
        """Close all connections, and each new one at once, until `heal`."""
        self._is_cut = True
        self._abort_all()

    def hold(self) -> None:
        """Pass nothing on until `heal`, as a network that loses every packet."""
        self._passes.clear()

    def heal(self) -> None:
        """As at first. What was held is passed on now."""
        self._is_cut, self.delay_s, self.loss = False, 0.0, 0.0
        self._passes.set()

    def _abort_all(self) -> None:
        for writer in list(self._writers):
            writer.transport.abort()

    async def serve(
        self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter
    ) -> None:
        """One connection, until both sides are done."""
        await self._passes.wait()
        try:
            if self._is_cut:
                raise ConnectionError("the link is cut")
            there_reader, there = await self._connect()
        except OSError:
            writer.transport.abort()
            return
        both = {writer, there}
        self._writers |= both
        try:
            await asyncio.gather(
                self._copy(reader, there, 0.0), self._copy(there_reader, writer, 1.0)
            )
        finally:
            self._writers -= both
            for one in both:
                one.transport.abort() if one.is_closing() else one.close()

    async def _copy(
        self,
        reader: asyncio.StreamReader,
        writer: asyncio.StreamWriter,
        of_answers: float,
    ) -> None:
        try:
            while block := await reader.read(BLOCK_BYTES):
                if self.delay_s:
                    await asyncio.sleep(self.delay_s)
                await self._passes.wait()
                if self._chance.random() < self.loss * of_answers:
                    raise ConnectionError
                writer.write(block)
                await writer.drain()
            if writer.can_write_eof():
                writer.write_eof()
        except OSError:
            writer.transport.abort()


class LinkThread:
    """Serves links until its context ends."""

    def __init__(self, seed: int) -> None:
        self._seed = seed
        self._links: list[Link] = []
        self._loop = asyncio.new_event_loop()
        self._thread = threading.Thread(target=self._loop.run_forever, daemon=True)

    def __enter__(self) -> Self:
        self._thread.start()
        return self

    def __exit__(self, *_: object) -> None:
        self.run(self._end())
        self._loop.call_soon_threadsafe(self._loop.stop)
        self._thread.join()
        self._loop.close()

    async def _end(self) -> None:
        for link in self._links:
            link.heal()
            link.cut()
        if tasks := asyncio.all_tasks() - {asyncio.current_task()}:
            await asyncio.wait(tasks)

    def run(self, work: Coroutine[Any, Any, Found]) -> Found:
        """What it returns, once it is done."""
        return asyncio.run_coroutine_threadsafe(work, self._loop).result()

    def call(self, *calls: Callable[[], None]) -> None:
        """Change links, all at one moment."""

        async def do() -> None:
            for one in calls:
                one()

        self.run(do())

    def open_port(self, port_of: Callable[[], int]) -> tuple[Link, int]:
        """A link at a free port to another port, which is asked for each time."""

        async def listen() -> tuple[Link, int]:
            link = self._link(lambda: asyncio.open_connection(HOST, port_of()))
            server = await asyncio.start_server(link.serve, HOST, 0)
            return link, server.sockets[0].getsockname()[1]

        return self.run(listen())

    def open_path(self, path: Path, target: Path) -> Link:
        """A link from one socket of Unix to another one."""

        async def listen() -> Link:
            link = self._link(lambda: asyncio.open_unix_connection(target))
            await asyncio.start_unix_server(link.serve, path)
            return link

        return self.run(listen())

    def _link(self, connect: Callable[[], Awaitable[Streams]]) -> Link:
        self._links.append(Link(connect, random.Random(self._seed)))
        return self._links[-1]
