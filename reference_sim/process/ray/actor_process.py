"""A simulator on a Ray cluster, as the server sees it: a process behind a TCP socket.

The launcher starts and kills it; commands and replies are those of a local process.
That its machine is gone is noticed by whatever is first: the end of the connection, its
keepalive, Ray, or the timeout of the turn.
"""

from __future__ import annotations

import asyncio
import contextlib
import logging
import socket
import subprocess
from collections.abc import Callable
from dataclasses import dataclass, field

from reference_sim.message_frames import frame, read_message
from reference_sim.process.ray.launcher_messages import (
    FROM_LAUNCHER,
    ActorEnded,
    ActorReady,
    Connect,
    Connected,
    FindRoom,
    KillActor,
    Rejected,
    Room,
    StartActor,
    ToLauncher,
)
from reference_sim.process.ray.simulator_actor import prepare
from reference_sim.process.simulator_process import (
    ResourceShortage,
    SimulatorProcess,
    spawn,
    wait_or_kill,
)

_MODULE = "reference_sim.process.ray.launcher"
_CONNECT_TIMEOUT_S = 10.0
_JOIN_TIMEOUT_S = 150.0  # Ray itself gives up earlier
_ANSWER_TIMEOUT_S = 5.0
ROOM_UNKNOWN = Room(0, {}, is_free=False, is_known=False)
_log = logging.getLogger(__name__)


class CannotUseRay(ResourceShortage):
    """There is no cluster to use; the text is one sentence."""


@dataclass
class _Actor:
    """ready: set when it listens. on_end: is called when Ray reports its end."""

    ready: asyncio.Future[ActorReady]
    on_end: Callable[[], None] = field(default=lambda: None)


class LauncherClient:
    """The launcher process, started at first use and again after its death."""

    def __init__(self, connect: Connect) -> None:
        self._connect = connect
        self._opening = asyncio.Lock()
        self._writer: asyncio.StreamWriter | None = None
        self._reading: asyncio.Task[None] | None = None
        self._process: subprocess.Popen[bytes] | None = None
        self._actors: dict[int, _Actor] = {}
        self._questions: dict[int, asyncio.Future[Room]] = {}
        self._last_number = 0

    @property
    def is_open(self) -> bool:
        return self._writer is not None

    async def open(self) -> list[int]:
        """Join the cluster: takes seconds. Returns the machines of `Connected`.

        Raises CannotUseRay.
        """
        async with self._opening:
            if self._writer is not None:
                return []
            await self._end_process()
            ours, theirs = socket.socketpair()
            with theirs:
                self._process = spawn(_MODULE, theirs)
            reader, writer = await asyncio.open_unix_connection(sock=ours)
            writer.write(frame(self._connect))
            try:
                async with asyncio.timeout(_JOIN_TIMEOUT_S):
                    answer = await read_message(reader, FROM_LAUNCHER)
            except TimeoutError:
                answer = Rejected("the Ray cluster does not answer")
            except BaseException:
                writer.close()
                raise
            if not isinstance(answer, Connected):
                writer.close()
                lost = "the connection to the Ray cluster was lost"
                raise CannotUseRay(
                    answer.reason if isinstance(answer, Rejected) else lost
                )
            self._writer = writer
            self._reading = asyncio.create_task(self._read(reader, writer))
            return answer.machines

    async def start_actor(
        self, resources: dict[str, float], on_end: Callable[[], None]
    ) -> tuple[int, ActorReady]:
        """Waits as long as the cluster has no room; the caller may cancel that.

        resources: what it takes of its machine. on_end: is called when it ended later.
        Raises ResourceShortage.
        """
        await self.open()
        self._last_number += 1
        number, loop = self._last_number, asyncio.get_running_loop()
        actor = self._actors[number] = _Actor(loop.create_future())
        self._send(StartActor(number, resources))
        try:
            ready = await actor.ready
        except BaseException:
            self.kill(number)
            raise
        actor.on_end = on_end
        return number, ready

    def kill(self, number: int) -> None:
        """Harmless if it has ended."""
        if self._actors.pop(number, None) is not None:
            self._send(KillActor(number))

    async def find_room(self, resources: dict[str, float]) -> Room:
        """The room for a simulator with these resources, or `ROOM_UNKNOWN`."""
        if self._writer is None:
            return ROOM_UNKNOWN
        self._last_number += 1
        number, loop = self._last_number, asyncio.get_running_loop()
        answer: asyncio.Future[Room] = loop.create_future()
        self._questions[number] = answer
        self._send(FindRoom(number, resources))
        try:
            # No timeout of a task: the work of a session may go on in another one.
            await asyncio.wait([answer], timeout=_ANSWER_TIMEOUT_S)
            return answer.result() if answer.done() else ROOM_UNKNOWN
        finally:
            del self._questions[number]

    async def close(self) -> None:
        """Returns when the launcher has ended, and every actor was killed."""
        if self._writer is not None:
            self._writer.close()
        if self._reading is not None:
            self._reading.cancel()
            with contextlib.suppress(asyncio.CancelledError):
                await self._reading
        await self._end_process()

    async def _end_process(self) -> None:
        process, self._process = self._process, None
        if process is not None:
            await asyncio.to_thread(wait_or_kill, process)

    def _send(self, message: ToLauncher) -> None:
        if self._writer is not None:
            self._writer.write(frame(message))

    async def _read(
        self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter
    ) -> None:
        try:
            while True:
                message = await read_message(reader, FROM_LAUNCHER)
                match message:
                    case ActorReady(number):
                        actor = self._actors.get(number)
                        if actor is not None and not actor.ready.done():
                            actor.ready.set_result(message)
                    case ActorEnded(number, reason):
                        self._end_actor(number, reason)
                    case Room(number):
                        self._answer(number, message)
                    case _:
                        break
            _log.warning("the connection to the Ray cluster was lost")
        finally:
            self._writer = None
            writer.close()
            for number in list(self._actors):
                self._end_actor(number, "the connection to the Ray cluster was lost")
            for number in self._questions:
                self._answer(number, ROOM_UNKNOWN)

    def _answer(self, number: int, room: Room) -> None:
        answer = self._questions.get(number)
        if answer is not None and not answer.done():
            answer.set_result(room)

    def _end_actor(self, number: int, reason: str) -> None:
        actor = self._actors.pop(number, None)
        if actor is None:
            return
        if actor.ready.done():
            actor.on_end()
        else:
            actor.ready.set_exception(ResourceShortage(reason))
            actor.ready.exception()  # no warning if it is no longer awaited


class ActorProcess(SimulatorProcess):
    """One actor. resources: what it takes of its machine."""

    def __init__(
        self,
        launcher: LauncherClient,
        resources: dict[str, float],
        timeout_s: float,
        on_end: Callable[[SimulatorProcess], None],
    ) -> None:
        super().__init__(timeout_s, on_end)
        self._launcher, self._resources = launcher, resources
        self._number: int | None = None

    async def _connect(self) -> socket.socket:
        self._number, ready = await self._launcher.start_actor(
            self._resources, lambda: self.end("died with its machine")
        )
        family = socket.AF_INET6 if ":" in ready.host else socket.AF_INET
        ours = socket.socket(family, socket.SOCK_STREAM, socket.IPPROTO_TCP)
        try:
            ours.setblocking(False)
            prepare(ours)
            async with asyncio.timeout(_CONNECT_TIMEOUT_S):
                loop = asyncio.get_running_loop()
                await loop.sock_connect(ours, (ready.host, ready.port))
                await loop.sock_sendall(ours, ready.secret)
        except OSError as error:  # a timeout, too
            ours.close()
            text = f"no connection to {ready.host}:{ready.port}: {error}"
            raise ResourceShortage(text) from error
        except BaseException:
            ours.close()
            raise
        return ours

    def _kill(self) -> None:
        if self._number is not None:
            self._launcher.kill(self._number)
