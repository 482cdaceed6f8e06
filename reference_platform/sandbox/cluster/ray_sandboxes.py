"""Sandboxes on a Ray cluster: each on the machine that has room for its limits.

It is the same bubblewrap sandbox, started there by an actor. The machines see the
folder of submissions under its path, and have this package, bubblewrap, and Ray.
"""

from __future__ import annotations

import asyncio
import contextlib
import socket
import sys
from asyncio.subprocess import DEVNULL, PIPE, Process

import msgspec

from reference_platform.sandbox.cluster.node_messages import (
    CONTROL,
    FROM_NODE,
    LISTENS,
    POLICY,
    Acknowledged,
    Close,
    Ended,
    Line,
    Start,
    Started,
    Unavailable,
)
from reference_platform.sandbox.sandbox_interface import (
    MIB,
    Limits,
    NotListening,
    SandboxEnd,
    SandboxSpec,
    SandboxUnavailable,
    WriteLine,
)
from reference_server.process.background_work import shielded
from reference_sim.message_frames import frame, read_message

_CONNECT_S = 10.0
_LAUNCHER_S = 40.0
_LOST = SandboxEnd(
    "The machine of the sandbox was lost.", is_by_platform=False, is_lost=True
)


class _Place(msgspec.Struct):
    """Where a sandbox is controlled, or why there is none."""

    host: str = ""
    port: int = 0
    secret: str = ""
    problem: str = ""


class RayMaker:
    """address: of the cluster, as Ray takes it. place_s: how long it may lack room."""

    def __init__(self, address: str, place_s: float = 600.0) -> None:
        self._address, self._place_s = address, place_s

    def enforcement(self, limits: Limits) -> str:
        return (
            f"On machines of the Ray cluster {self._address} that have room for "
            f"{limits.cpus:g} CPUs and {limits.memory_bytes / MIB:g} MiB, each by its "
            "control groups where it has them, else for each process alone."
        )

    async def start(self, spec: SandboxSpec, write: WriteLine) -> RaySandbox:
        """Raises SandboxUnavailable."""
        limits = spec.limits
        launcher = await asyncio.create_subprocess_exec(
            *(sys.executable, "-m", "reference_platform.sandbox.cluster.ray_launcher"),
            *(self._address, str(limits.cpus), str(limits.memory_bytes)),
            stdin=PIPE, stdout=PIPE, stderr=DEVNULL,
        )  # fmt: skip
        try:
            place = await self._read_place(launcher)
            reader, writer = await _begin(place, spec)
        except OSError as error:
            await _end(launcher)
            raise SandboxUnavailable(f"{_LOST.reason} {error}") from error
        except BaseException:
            await _end(launcher)
            raise
        return RaySandbox(launcher, place, reader, writer, write)

    async def _read_place(self, launcher: Process) -> _Place:
        assert launcher.stdout is not None
        try:
            async with asyncio.timeout(self._place_s):
                line = await launcher.stdout.readline()
        except TimeoutError as error:
            text = (
                f"The Ray cluster gave no place within {self._place_s:g} s: no machine "
            )
            text += "has room, or it does not answer."
            raise SandboxUnavailable(text) from error
        place = msgspec.json.decode(line or b"{}", type=_Place)
        if not place.port:
            text = place.problem or "The process that is connected to Ray has ended."
            raise SandboxUnavailable(text)
        return place


class RaySandbox:
    """A sandbox on another machine. It implements Sandbox."""

    def __init__(
        self,
        launcher: Process,
        place: _Place,
        reader: asyncio.StreamReader,
        writer: asyncio.StreamWriter,
        write: WriteLine,
    ) -> None:
        self._launcher, self._place, self._write = launcher, place, write
        self._reader, self._writer = reader, writer
        self._end: SandboxEnd | None = None
        self._ending = asyncio.ensure_future(self._follow())

    @property
    def end(self) -> SandboxEnd | None:
        return self._end

    def connect(self) -> socket.socket:
        """Raises NotListening."""
        if self._end is not None:
            raise NotListening(self._end.reason)
        try:
            connection = _connect(self._place, POLICY)
            if connection.recv(1) == LISTENS:
                return connection
            connection.close()
        except OSError as error:
            raise NotListening(f"The machine does not answer: {error}") from error
        raise NotListening("The policy does not listen.")

    async def wait(self) -> SandboxEnd:
        return await shielded(self._ending)

    async def close(self, reason: str) -> SandboxEnd:
        with contextlib.suppress(OSError):
            self._writer.write(frame(Close(reason)))
        return await self.wait()

    async def _follow(self) -> SandboxEnd:
        """Lines are acknowledged when they are on the disk of the platform."""
        end = _LOST
        while (message := await read_message(self._reader, FROM_NODE)) is not None:
            if isinstance(message, Line):
                await asyncio.to_thread(self._write, message.source, message.text)
                self._writer.write(frame(Acknowledged()))
            elif isinstance(message, Ended):
                end = message.end
                break
        if end is _LOST:
            await asyncio.to_thread(self._write, "platform", _LOST.reason)
        self._writer.close()
        await _end(self._launcher)
        self._end = end
        return end


def _connect(place: _Place, kind: bytes) -> socket.socket:
    connection = socket.create_connection((place.host, place.port), _CONNECT_S)
    connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
    connection.sendall(bytes.fromhex(place.secret) + kind)
    return connection


async def _begin(
    place: _Place, spec: SandboxSpec
) -> tuple[asyncio.StreamReader, asyncio.StreamWriter]:
    """The connection that controls a sandbox. Raises SandboxUnavailable, OSError."""
    connection = await asyncio.to_thread(_connect, place, CONTROL)
    connection.setblocking(False)
    reader, writer = await asyncio.open_connection(sock=connection)
    writer.write(frame(Start.of(spec)))
    answer = await read_message(reader, FROM_NODE)
    if isinstance(answer, Started):
        return reader, writer
    writer.close()
    reason = answer.reason if isinstance(answer, Unavailable) else _LOST.reason
    raise SandboxUnavailable(reason)


async def _end(launcher: Process) -> None:
    """It kills the actor, and leaves the cluster."""
    assert launcher.stdin is not None
    launcher.stdin.close()
    try:
        async with asyncio.timeout(_LAUNCHER_S):
            await launcher.wait()
    except TimeoutError:
        launcher.kill()
        await launcher.wait()
