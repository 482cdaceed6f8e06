"""One sandbox on this machine, for a platform elsewhere. It knows nothing of Ray.

A program that knows the secret controls it; the sandbox ends with the platform.
"""

from __future__ import annotations

import asyncio
import contextlib
import hmac
import socket
from collections import deque

from reference_platform.sandbox.bubblewrap import BubblewrapMaker
from reference_platform.sandbox.cluster.node_messages import (
    CONTROL,
    LISTENS,
    POLICY,
    SECRET_BYTES,
    SILENT,
    TO_NODE,
    Acknowledged,
    Close,
    Ended,
    FromNode,
    Line,
    Start,
    Started,
    Unavailable,
)
from reference_platform.sandbox.sandbox_interface import (
    NotListening,
    Sandbox,
    SandboxSpec,
    SandboxUnavailable,
    Source,
    WriteLine,
)
from reference_platform.sandbox.sandbox_streams import relay
from reference_sim.message_frames import frame, read_message

_CONTROL_S = 60.0  # until the platform has connected
_SECRET_S = 10.0


async def serve_sandbox(listener: socket.socket, secret: bytes) -> None:
    """Returns when the sandbox has ended, and the platform has gone."""
    node = _Node(secret)
    async with await asyncio.start_server(node.accept, sock=listener):
        with contextlib.suppress(TimeoutError):
            async with asyncio.timeout(_CONTROL_S):
                await node.controlled.wait()
        if node.controlled.is_set():
            await node.over.wait()


class _Node:
    def __init__(self, secret: bytes) -> None:
        self._secret = secret
        self._sandbox: Sandbox | None = None
        # Lines that the platform has not acknowledged; no line is sent when it is gone.
        self._unacknowledged: deque[asyncio.Future[None]] = deque()
        self._is_gone = False
        self.controlled, self.over = asyncio.Event(), asyncio.Event()

    async def accept(
        self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter
    ) -> None:
        with contextlib.suppress(OSError, TimeoutError, asyncio.IncompleteReadError):
            async with asyncio.timeout(_SECRET_S):
                first = await reader.readexactly(SECRET_BYTES + 1)
            secret, kind = first[:SECRET_BYTES], first[SECRET_BYTES:]
            if not hmac.compare_digest(secret, self._secret):
                pass
            elif kind == POLICY:
                await self._lead_to_policy(reader, writer)
            elif kind == CONTROL and not self.controlled.is_set():
                self.controlled.set()
                try:
                    await self._control(reader, writer)
                finally:
                    self.over.set()
        writer.close()

    async def _lead_to_policy(
        self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter
    ) -> None:
        connection = None
        if self._sandbox is not None:
            with contextlib.suppress(NotListening):
                connection = await asyncio.to_thread(self._sandbox.connect)
        writer.write(SILENT if connection is None else LISTENS)
        await writer.drain()
        if connection is not None:
            await relay(reader, writer, connection)

    async def _control(
        self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter
    ) -> None:
        start = await read_message(reader, TO_NODE)
        if not isinstance(start, Start):
            return
        try:
            spec = start.spec()
            _check_seen(spec)
            self._sandbox = await BubblewrapMaker().start(spec, self._writer_of(writer))
        except (SandboxUnavailable, OSError) as error:
            await _send(writer, Unavailable(f"{socket.gethostname()}: {error}"))
            return
        await _send(writer, Started())
        reading = asyncio.ensure_future(self._read(reader, self._sandbox))
        try:
            end = await self._sandbox.wait()
            await _send(writer, Ended(end))
            await reading  # until the platform hangs up
        finally:
            reading.cancel()
            self._let_go()
            await self._sandbox.close("The platform is gone.")

    async def _read(self, reader: asyncio.StreamReader, sandbox: Sandbox) -> None:
        """Messages of the platform; when they end, the sandbox ends."""
        closing = None
        while (message := await read_message(reader, TO_NODE)) is not None:
            if isinstance(message, Acknowledged) and self._unacknowledged:
                self._unacknowledged.popleft().set_result(None)
            elif isinstance(message, Close) and closing is None:
                closing = asyncio.ensure_future(sandbox.close(message.reason))
        self._let_go()
        await sandbox.close("The platform is gone.")

    def _let_go(self) -> None:
        """The platform is gone: no line waits for it."""
        self._is_gone = True
        while self._unacknowledged:
            self._unacknowledged.popleft().set_result(None)

    def _writer_of(self, writer: asyncio.StreamWriter) -> WriteLine:
        """Writes a line as the platform does: called by a thread, and durable then."""
        loop = asyncio.get_running_loop()

        async def send(line: Line) -> None:
            if self._is_gone:
                return
            acknowledged = loop.create_future()
            self._unacknowledged.append(acknowledged)
            with contextlib.suppress(OSError):
                await _send(writer, line)
                await acknowledged

        def write(source: Source, text: str, /) -> None:
            asyncio.run_coroutine_threadsafe(send(Line(source, text)), loop).result()

        return write


async def _send(writer: asyncio.StreamWriter, message: FromNode) -> None:
    writer.write(frame(message))
    await writer.drain()


def _check_seen(spec: SandboxSpec) -> None:
    """Raises SandboxUnavailable: this machine has no such folder."""
    for path in filter(None, (spec.root, *spec.binds.values())):
        if not path.exists():
            raise SandboxUnavailable(
                f"the machine has no {path}; --submissions must be on a folder that "
                "all machines of the cluster share"
            )
