"""A load balancer without affinity, which asks the nodes whether they are ready.

Each connection goes to the next node that is ready, and is passed on byte for byte. A
node says at `/readyz` whether it is. One that refuses gets no new connections and keeps
those that it has: a server that ends completes its answers. One that has said nothing
for a while is lost, and its connections are closed: a client that waits there repeats
its request at once, at another node. If no node is ready, each is tried.
"""

import asyncio
import contextlib
import itertools
import time
from collections.abc import Coroutine, Sequence
from dataclasses import dataclass, field

BLOCK_BYTES = 2**16
HOST = "127.0.0.1"
CHECK_EVERY_S = 0.5
# A node that says nothing for so long is lost. Below the lease of a node, so that its
# clients are elsewhere when others claim its runs; above what `/readyz` may take.
SILENT_S = 3.0
_HEADERS = f"Host: {HOST}\r\nConnection: close\r\n\r\n"
_QUESTION = f"GET /readyz HTTP/1.1\r\n{_HEADERS}".encode()
_READY = b" 200 "


@dataclass(eq=False)
class _Target:
    """One node. connections: to their clients, all that it has now."""

    host: str
    port: int
    is_ready: bool = True
    answered_at: float = field(default_factory=time.monotonic)
    connections: set[asyncio.StreamWriter] = field(default_factory=set)

    def note(self, *, is_ready: bool) -> None:
        """It has answered a question, or refused the connection for it."""
        self.is_ready, self.answered_at = is_ready, time.monotonic()

    def note_silence(self) -> None:
        """A question was not answered in time; a later one may have been."""
        if time.monotonic() - self.answered_at >= SILENT_S:
            self.is_ready = False
            for writer in list(self.connections):
                writer.transport.abort()


class Balancer:
    """From `listen` to `close`. nodes: hosts and ports of the nodes."""

    def __init__(self, nodes: Sequence[tuple[str, int]]) -> None:
        self._targets = [_Target(host, port) for host, port in nodes]
        self._firsts = itertools.cycle(range(len(nodes)))
        # asyncio alone drops who waits for one side when the other one has left.
        self._tasks: set[asyncio.Task[None]] = set()

    async def listen(self, host: str, port: int) -> asyncio.Server:
        """Pass connections to this address on. Raises OSError."""
        server = await asyncio.start_server(self._serve, host, port)
        for target in self._targets:
            self._begin(self._ask_for_ever(target))
        return server

    async def close(self) -> None:
        """Ask no node any more, and close what is still connected."""
        for task in self._tasks:
            task.cancel()
        if self._tasks:
            await asyncio.wait(self._tasks)

    def _begin(self, work: Coroutine[None, None, None]) -> None:
        task = asyncio.ensure_future(work)
        self._tasks.add(task)
        task.add_done_callback(self._tasks.discard)

    # --- whether nodes are ready ---

    async def _ask_for_ever(self, target: _Target) -> None:
        """A question that waits for its answer does not delay the next one."""
        while True:
            self._begin(self._ask(target))
            await asyncio.sleep(CHECK_EVERY_S)

    async def _ask(self, target: _Target) -> None:
        try:
            async with asyncio.timeout(SILENT_S):
                target.note(is_ready=await _is_ready(target))
        except TimeoutError:
            target.note_silence()
        except OSError:
            target.note(is_ready=False)

    # --- connections ---

    async def _serve(
        self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter
    ) -> None:
        self._begin(self._pass_on(reader, writer))

    def _in_turn(self) -> list[_Target]:
        """All nodes, the next one first, but those that are not ready behind others."""
        first = next(self._firsts)
        turned = self._targets[first:] + self._targets[:first]
        return sorted(turned, key=lambda target: not target.is_ready)

    async def _pass_on(
        self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter
    ) -> None:
        for target in self._in_turn():
            with contextlib.suppress(OSError):
                there = await asyncio.open_connection(target.host, target.port)
                break
        else:
            writer.transport.abort()
            return
        both = {writer, there[1]}
        target.connections |= both
        try:
            await asyncio.gather(_copy(reader, there[1]), _copy(there[0], writer))
        finally:
            target.connections -= both
            for one in both:
                one.close()


async def _is_ready(target: _Target) -> bool:
    """Whether the node says that it is ready. Raises OSError without an answer."""
    reader, writer = await asyncio.open_connection(target.host, target.port)
    try:
        writer.write(_QUESTION)
        line = await reader.readline()
    finally:
        writer.transport.abort()
    if not line:
        raise ConnectionResetError("the connection was closed without an answer")
    return _READY in line


async def _copy(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
    """Until the sender is done; its end is passed on, too."""
    try:
        while block := await reader.read(BLOCK_BYTES):
            writer.write(block)
            await writer.drain()
        if writer.can_write_eof():
            writer.write_eof()
    except OSError:
        writer.transport.abort()
