"""One simulator process, used from an asyncio event loop; and how it is started.

On Linux a fork server (fork_server.py) forks the processes: 4 ms instead of the 75 ms
of a new interpreter with NumPy. As their parent, it can kill by process id without the
risk of killing an unrelated process. Elsewhere forking is not safe, and each process is
a new interpreter.

Why not multiprocessing's forkserver (measured): it imports the caller's main module
into every child, uses pickle, and its busy children outlive a server killed by SIGKILL.
"""

from __future__ import annotations

import asyncio
import errno
import logging
import mmap
import os
import socket
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Protocol, TypeVar, cast

import msgspec

from reference_sim.benchmark_registry import SimulatorConfig
from reference_sim.interface import TaskUnplayable
from reference_sim.message_frames import LENGTH, frame
from reference_sim.process import simulator_main
from reference_sim.process.immediate_future import ImmediateFuture
from reference_sim.process.observation_encoding import EncodedObservation
from reference_sim.shared_frame_buffer import (
    SharedMemoryRegion,
    is_viewed,
    map_memory,
)

# Set by the server (the rendering backend), possibly after the fork server started.
_LATE_ENVIRONMENT = ("MUJOCO_GL", "PROCTOR_GL")
# Prefixes of the settings of the server, of its database driver (PGPASSWORD) and of its
# object storage, which may be secret: a simulator does not get them.
_SETTINGS = "PROCTOR_", "PG", "AWS_SECRET", "AWS_ACCESS_KEY", "AWS_SESSION"
_FORK_SERVER_MODULE, _SIMULATOR_MODULE = (
    "reference_sim.process.fork_server",
    "reference_sim.process.simulator_main",
)
_FRAME_MEMORIES = 2  # that of this episode, and that of the one before
_INBOX_BYTES = 2**15  # more than a turn without images
_START_TIMEOUT_S = 60.0  # long, for an overloaded machine
_EXIT_TIMEOUT_S = 10
_STOP_PASSES_S = 0.2  # between the stop of a robot and the end of its process
_REPLIES = msgspec.msgpack.Decoder(simulator_main.SimulatorReply)
_log = logging.getLogger(__name__)

ReplyT = TypeVar("ReplyT", bound=simulator_main.SimulatorReply)


class SimulatorFault(Exception):
    """The process died, hung, broke the protocol, or its simulator raised."""


class LastingFault(SimulatorFault):
    """Another try later meets the same, such as a file that was edited."""


class AttemptDiverged(Exception):
    """An attempt that is played again is not what it was: it cannot be gone on with."""


class ResourceShortage(SimulatorFault):
    """No simulator caused it: the machine has no files, processes, memory or folder for
    temporary files left, or a program that the server does not start is away."""


class NoRoomToRecord(Exception):
    """The disk is full; neither the simulator nor the policy caused it."""


_SHORTAGE = {errno.EMFILE, errno.ENFILE, errno.EAGAIN, errno.ENOMEM}


# Starting and killing processes


class ProcessStarter(Protocol):
    def start(self, child_end: socket.socket) -> None:
        """Start a process that serves on the socket. Raises OSError."""

    def kill(self, pid: int) -> None:
        """Kill without waiting; harmless if the process has ended."""

    async def close(self) -> None:
        """End every process; returns when all have ended."""


def _inherited_environment() -> dict[str, str]:
    """The environment of this process without its settings, for a simulator.

    Settings hold tokens and database passwords, and the code of a host's own benchmark
    runs in the simulators.
    """
    return {
        name: value
        for name, value in os.environ.items()
        if name in _LATE_ENVIRONMENT or not name.upper().startswith(_SETTINGS)
    }


def spawn(module: str, connection: socket.socket) -> subprocess.Popen[bytes]:
    """Start `python -m module FD` with this end of a socket. Raises OSError.

    Takes a third of a millisecond, so it may be called in the event loop.
    """
    root = str(Path(simulator_main.__file__).parents[2])
    paths = [root, *filter(None, [os.environ.get("PYTHONPATH")])]
    descriptor = connection.fileno()
    return subprocess.Popen(
        [sys.executable, "-P", "-m", module, str(descriptor)],
        env={
            **_inherited_environment(),
            "PYTHONPATH": os.pathsep.join(paths),
            "OPENBLAS_NUM_THREADS": "1",
        },
        pass_fds=[descriptor],
        stdin=subprocess.DEVNULL,
        process_group=0,  # a terminal's Ctrl-C is the server's to handle
    )


class ForkStarter:
    """Forks by the fork server, which is started at first use and after its death."""

    def __init__(self) -> None:
        self._control: socket.socket | None = None
        self._fork_servers: list[subprocess.Popen[bytes]] = []  # the last one lives

    @property
    def fork_server_pid(self) -> int | None:
        return self._fork_servers[-1].pid if self._control is not None else None

    def start(self, child_end: socket.socket) -> None:
        try:
            self._fork(child_end)
        except ConnectionError:  # the fork server has died
            self._disconnect_fork_server()
            self._fork(child_end)

    def kill(self, pid: int) -> None:
        if self._control is None:
            return
        try:
            self._control.send(str(pid).encode(), socket.MSG_DONTWAIT)
        except OSError:  # it has died, and its children with it
            _log.warning("simulator fork server is not running")

    async def close(self) -> None:
        self._disconnect_fork_server()
        for fork_server in self._fork_servers:
            await asyncio.to_thread(wait_or_kill, fork_server)
        self._fork_servers.clear()

    def _fork(self, child_end: socket.socket) -> None:
        if self._control is None:
            # SEQPACKET preserves messages and reports the peer's end as end-of-file.
            ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
            with theirs:
                self._fork_servers.append(spawn(_FORK_SERVER_MODULE, theirs))
            self._control = ours
        socket.send_fds(
            self._control, [b"fork"], [child_end.fileno()], socket.MSG_DONTWAIT
        )

    def _disconnect_fork_server(self) -> None:
        """Close the socket; the fork server then ends its children and itself."""
        if self._control is not None:
            self._control.close()
            self._control = None


class ExecStarter:
    """Starts a new interpreter for each process."""

    def __init__(self) -> None:
        self._processes: dict[int, subprocess.Popen[bytes]] = {}

    def start(self, child_end: socket.socket) -> None:
        process = spawn(_SIMULATOR_MODULE, child_end)
        self._processes[process.pid] = process
        ended = [p.pid for p in self._processes.values() if p.poll() is not None]
        for pid in ended:
            del self._processes[pid]

    def kill(self, pid: int) -> None:
        if process := self._processes.get(pid):
            process.kill()
            asyncio.get_running_loop().run_in_executor(None, process.wait)  # no zombie

    async def close(self) -> None:
        for process in self._processes.values():
            process.kill()
        for process in self._processes.values():
            await asyncio.to_thread(wait_or_kill, process)
        self._processes.clear()


def wait_or_kill(process: subprocess.Popen[bytes]) -> None:
    try:
        process.wait(_EXIT_TIMEOUT_S)
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait()


# One process


class SimulatorProcess(asyncio.BufferedProtocol):
    """Sends one command at a time; frames are received into their final buffer.

    Where and how the process is started is that of a subclass.
    """

    def __init__(
        self,
        timeout_s: float,
        on_end: Callable[[SimulatorProcess], None],
    ) -> None:
        self.pid: int | None = None
        self.world: SimulatorConfig | None = None
        self.alive = True
        self._timeout_s = timeout_s
        self._on_end = on_end
        self._request_lock = asyncio.Lock()
        self._loop = asyncio.get_running_loop()
        self._answer: ImmediateFuture[simulator_main.SimulatorReply] = ImmediateFuture(
            self._loop
        )
        self._task, self._steps, self._place = "", 0, ""  # for the text of a fault
        self._last_message_at = self._loop.time()
        self._limit_s, self._timer_at = timeout_s, 0.0
        self._timer: asyncio.TimerHandle | None = None
        self._transport: asyncio.Transport | None = None
        self._inbox = bytearray(_INBOX_BYTES)
        self._large: bytearray | None = None  # a frame that the inbox cannot hold
        self._filled = 0  # bytes of whichever of the two is received into
        self._frame_memory = memoryview(b"")
        self._frames: dict[int, mmap.mmap] = {}  # by number; what is drawn into is last

    async def start(self) -> None:
        """Start the process; returns when it is ready. Raises SimulatorFault."""
        try:
            await self._open_transport(await self._connect())
            self._limit_answer(_START_TIMEOUT_S)
            hello = await self._answer
        except OSError as error:
            raise _fault_of(error) from error
        finally:
            if not self._answer.done() or self._answer.cancelled():
                self.end("did not start")
        if isinstance(hello, simulator_main.Hello):
            self.pid = hello.pid
        else:
            self.end("violated its protocol")
            raise SimulatorFault("the simulator process violated its protocol")

    async def _connect(self) -> socket.socket:
        """Start the process; returns our end of the socket that it serves on.

        Raises OSError and SimulatorFault.
        """
        raise NotImplementedError

    def _kill(self) -> None:
        """Kill the process without waiting; harmless if it has ended or never began."""
        raise NotImplementedError

    def _late_environment(self) -> dict[str, str]:
        """Variables that a simulator needs of this process."""
        return {}

    async def _open_transport(self, ours: socket.socket) -> None:
        connect = (
            self._loop.create_unix_connection
            if ours.family == socket.AF_UNIX
            else self._loop.create_connection
        )
        try:
            await connect(lambda: self, sock=ours)
        finally:
            if self._transport is None:
                ours.close()

    async def build(self, world: SimulatorConfig) -> None:
        environment, settings = self._late_environment(), dict(world.settings)
        self._frame_memory = memoryview(b"")
        self._frames.clear()  # pictures of one run are not drawn over those of another
        self.world = None
        command = simulator_main.Build(world.benchmark_id, settings, environment)
        try:
            await self.request(command, simulator_main.Built)
        except TaskUnplayable:
            self.end("cannot build its simulator")
            raise
        self.world = world

    @property
    def unread_frames(self) -> int:
        """The number of frame memory that no picture is read from; 0 for none."""
        number, memory = next(iter(self._frames.items()), (0, None))
        is_free = memory is not None and not is_viewed(memory)
        return number if is_free else 0

    @property
    def is_busy(self) -> bool:
        return self._request_lock.locked()

    async def request(
        self, command: simulator_main.SimulatorCommand, wanted: type[ReplyT]
    ) -> ReplyT:
        """Raises TaskUnplayable; all other errors end the process."""
        async with self._request_lock:
            if not self.alive or self._transport is None:
                raise SimulatorFault("the simulator process has ended")
            self._answer = ImmediateFuture(self._loop)
            self._place = self._place_of(command)
            self._transport.write(frame(command))
            self._limit_answer(self._timeout_s)
            try:
                reply = await self._answer
            except BaseException:  # also if cancelled: the state is then unknown
                self.end("was cancelled")
                raise
        self._place = ""
        if isinstance(reply, wanted):
            if isinstance(reply, simulator_main.ChunkReply):
                self._steps = reply.steps
            return reply
        if isinstance(reply, simulator_main.FailureReply) and reply.unplayable:
            raise TaskUnplayable(reply.error)
        self.end("failed")
        if not isinstance(reply, simulator_main.FailureReply):
            raise SimulatorFault("wrong answer")
        if reply.no_room:
            raise NoRoomToRecord(reply.error)
        if reply.diverged:
            raise AttemptDiverged(reply.error)
        if reply.away:
            raise ResourceShortage(reply.error)
        raise (LastingFault if reply.lasting else SimulatorFault)(reply.error)

    def _place_of(self, command: simulator_main.SimulatorCommand) -> str:
        """The place of a fault in an episode, in words; its seed may be secret."""
        match command:
            case simulator_main.Begin():
                self._task, self._steps = command.task, 0
            case simulator_main.ResumeAttempt():
                self._task = command.begin.task
                self._steps = sum(len(turn.rewards) for turn in command.turns)
            case simulator_main.Play():
                return f", after {self._steps} steps of {self._task}"
            case _:
                return ""
        return f", while {self._task} began"

    def signal(self, kind: str) -> None:
        """Send `stop` or `alive` to a robot at once, also during a request."""
        transport = self._transport
        if self.alive and transport is not None and not transport.is_closing():
            transport.write(frame(simulator_main.Signal(kind)))

    def end(self, why: str) -> None:
        """Kill the process; a pending request raises SimulatorFault.

        A robot is stopped first: a stop passes through the process in less time than
        its end takes on a busy machine.
        """
        if not self.alive:
            return
        is_robot = self.world is not None and self.world.is_robot
        if is_robot and self._transport is not None:
            self.signal("stop")
            self._loop.call_later(_STOP_PASSES_S, self._kill_now)
        else:
            self._kill_now()
        self.alive = False
        if self._timer is not None:
            self._timer.cancel()
        self._fail(SimulatorFault(f"the simulator process {why}{self._place}"))
        self._on_end(self)

    def _kill_now(self) -> None:
        self._kill()
        if self._transport is not None:
            self._transport.abort()  # ends a process whose id is not yet known

    def _fail(self, fault: SimulatorFault) -> None:
        """Let the pending request, if there is one, raise this fault."""
        self._answer.set_exception(fault)

    def _limit_answer(self, timeout_s: float) -> None:
        """End the process where it is silent for so long from now on."""
        now = self._last_message_at = self._loop.time()
        self._limit_s = timeout_s
        # Most answers come in less than a millisecond, so the timer of the request
        # before stays, and looks at this one when it is due.
        if self._timer is None or self._timer_at > now + timeout_s:
            self._look_at(now + timeout_s)

    def _look_at(self, at: float) -> None:
        if self._timer is not None:
            self._timer.cancel()
        self._timer_at = at
        self._timer = self._loop.call_at(at, self._watch)

    def _watch(self) -> None:
        self._timer = None
        due_at = self._last_message_at + self._limit_s
        if self._answer.done():
            return  # nothing is asked; the next request begins another timer
        if due_at <= self._loop.time():
            self.end(f"made no step for {self._limit_s:g} s and was killed")
        else:
            self._look_at(due_at)

    # --- called by the event loop ---

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        # Not checked by isinstance: uvloop's transports are not of this class.
        self._transport = cast(asyncio.Transport, transport)

    def connection_lost(self, exc: Exception | None) -> None:
        self.end("died")

    def get_buffer(self, sizehint: int) -> memoryview:
        return memoryview(self._large or self._inbox)[self._filled :]

    def buffer_updated(self, nbytes: int) -> None:
        self._filled += nbytes
        if self._large is None:
            self._read_inbox()
        elif self._filled == len(self._large):
            body, self._large, self._filled = self._large, None, 0
            self._receive(body)

    def _read_inbox(self) -> None:
        """Handle every complete frame; an incomplete one moves to the front."""
        inbox, head = self._inbox, LENGTH.size
        while self._filled >= head:
            (length,) = LENGTH.unpack_from(inbox)
            if head + length > len(inbox):
                self._large = bytearray(length)
                self._filled -= head
                self._large[: self._filled] = inbox[head : head + self._filled]
                return
            if head + length > self._filled:
                return
            body = inbox[head : head + length]
            rest = inbox[head + length : self._filled]
            inbox[: len(rest)] = rest
            self._filled = len(rest)
            self._receive(body)

    def _receive(self, body: bytearray) -> None:
        self._last_message_at = self._loop.time()
        try:
            reply = _REPLIES.decode(body)
        except msgspec.DecodeError:
            return self.end("violated its protocol")
        if isinstance(reply, simulator_main.Busy):
            return None
        if isinstance(reply, simulator_main.NewFrameMemory):
            return self._map_frame_memory(reply)
        if self._answer.done():
            return self.end("sent an unexpected message")
        try:
            if (observation := _observation_of(reply)) is not None:
                self._resolve_pixels(observation)
        except (TypeError, ValueError):
            return self.end("violated its protocol")
        return self._answer.set_result(reply)

    def _map_frame_memory(self, mapping: simulator_main.NewFrameMemory) -> None:
        """Read pictures from this memory; only a process of this machine shares any."""
        self.end("violated its protocol")

    def _resolve_pixels(self, observation: EncodedObservation) -> None:
        """Replace the places of images in the frame buffer by views of it."""
        for image in observation["images"].values():
            if place := image.pop("place", None):
                offset, length = place
                image["data"] = self._frame_memory[offset : offset + length]
                if offset < 0 or len(image["data"]) != length:
                    raise ValueError("image offset outside the frame buffer")


class LocalProcess(SimulatorProcess):
    """A process of this machine, whose pictures are read from shared memory."""

    def __init__(
        self,
        starter: ProcessStarter,
        timeout_s: float,
        on_end: Callable[[SimulatorProcess], None],
    ) -> None:
        super().__init__(timeout_s, on_end)
        self._starter = starter

    async def _connect(self) -> socket.socket:
        ours, theirs = socket.socketpair()
        with theirs:
            try:
                self._starter.start(theirs)
            except BaseException:
                ours.close()
                raise
        return ours

    def _kill(self) -> None:
        if self.pid is not None:
            self._starter.kill(self.pid)

    def _late_environment(self) -> dict[str, str]:
        return {
            name: os.environ[name] for name in _LATE_ENVIRONMENT if name in os.environ
        }

    def _map_frame_memory(self, mapping: simulator_main.NewFrameMemory) -> None:
        region = SharedMemoryRegion(mapping.number, mapping.descriptor, mapping.size)
        try:
            assert self.pid is not None
            memory = self._frames.pop(mapping.number, None)
            if memory is None:
                memory = map_memory(self.pid, region)
            self._frames[mapping.number] = memory
            self._frame_memory = memoryview(memory)
            for number in list(self._frames)[:-_FRAME_MEMORIES]:
                del self._frames[number]
        except (OSError, ValueError) as error:
            if isinstance(error, OSError) and error.errno in _SHORTAGE:
                self._fail(_fault_of(error))
            self.end("could not share memory")


def _fault_of(error: OSError) -> SimulatorFault:
    kind = ResourceShortage if error.errno in _SHORTAGE else SimulatorFault
    return kind(f"no simulator process: {error}")


def _observation_of(reply: simulator_main.SimulatorReply) -> EncodedObservation | None:
    """The observation whose pictures may be in the frame buffer."""
    observation: EncodedObservation | None = getattr(reply, "observation", None)
    return observation
