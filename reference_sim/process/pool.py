"""A pool of simulator processes on this machine, lent to sessions.

Nothing here blocks the event loop. Each process is used by one session at a time, and
the only lock held while a simulator executes is that of its process.
"""

from __future__ import annotations

import asyncio
import contextlib
import logging
import sys
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import TypeVar

import msgspec

from reference_record.recordings.open_attempt import OpenAttempt
from reference_sim.benchmark_registry import SimulatorConfig
from reference_sim.interface import TaskUnplayable
from reference_sim.process import simulator_main
from reference_sim.process.observation_encoding import EncodedObservation
from reference_sim.process.recorder import RecordingPlan, UnwritableRecording
from reference_sim.process.recording_here import RecordingHere
from reference_sim.process.simulator_main import (
    Begin,
    ChunkReply,
    EpisodeStart,
    ReplayReply,
    Timing,
)
from reference_sim.process.simulator_process import (
    AttemptDiverged,
    ExecStarter,
    ForkStarter,
    LastingFault,
    LocalProcess,
    NoRoomToRecord,
    ReplyT,
    ResourceShortage,
    SimulatorFault,
    SimulatorProcess,
)

__all__ = [
    "AttemptDiverged",
    "Begin",
    "ChunkReply",
    "EpisodeStart",
    "LastingFault",
    "NoCapacity",
    "NoRoomToRecord",
    "RecordingPlan",
    "ReplayReply",
    "SimulatorFault",
    "SimulatorHandle",
    "SimulatorPool",
    "TaskUnplayable",
    "Timing",
]

Given = TypeVar("Given")
Done = TypeVar("Done")

IDLE_MAX = 16  # idle processes kept for reuse, in addition to the spares
FORK_IS_SAFE = sys.platform == "linux"

_log = logging.getLogger(__name__)


class NoCapacity(Exception):
    """The maximum number of simulators is in use, or the machine can run no more."""


class SimulatorHandle:
    """A process lent by the pool. After a SimulatorFault it is dead and returned.

    After NoCapacity and NoRoomToRecord, too; then the simulator did not cause it.
    records_here: the process does not see the folder of recordings.
    """

    def __init__(
        self,
        process: SimulatorProcess,
        give_back: Callable[[SimulatorProcess], None],
        *,
        records_here: bool = False,
    ) -> None:
        self._process = process
        self._give_back = give_back
        self._lent = True
        self._recording = RecordingHere() if records_here else None

    @property
    def pid(self) -> int | None:
        return self._process.pid

    async def begin(self, begin: Begin) -> EpisodeStart:
        """Reset to step 0 of an episode; discards the current one."""
        started = await self._request(await self._begun(begin), EpisodeStart)
        await self._record(started.recorded)
        return started

    async def _begun(self, begin: Begin) -> Begin:
        """The command as the process gets it."""
        unread = self._process.unread_frames
        begin = msgspec.structs.replace(begin, unread_frames=unread)
        if self._recording is None:
            return begin
        plan = await self._in_recording(self._recording.begin, begin.recording)
        return msgspec.structs.replace(begin, recording=plan)

    async def _record(self, recorded: bytes) -> None:
        if self._recording is not None and recorded:
            await self._in_recording(self._recording.append, recorded)

    async def _in_recording(self, work: Callable[[Given], Done], given: Given) -> Done:
        """An error is a fault, as where the process writes, unless the disk is full."""
        try:
            return await asyncio.to_thread(work, given)
        except OSError as error:
            self.discard()
            failed = UnwritableRecording(error)
            kind = NoRoomToRecord if failed.no_room else SimulatorFault
            raise kind(str(failed)) from error

    async def resume(self, begin: Begin, attempt: OpenAttempt) -> EpisodeStart:
        """Play an attempt again up to where it was; what is to be seen there.

        Raises AttemptDiverged.
        """
        begin, turns = await self._begun(begin), attempt.turns
        command = simulator_main.ResumeAttempt(
            begin, attempt.digest, turns, shows_turn=False
        )
        return await self._request(command, EpisodeStart)

    async def resume_turn(self, begin: Begin, attempt: OpenAttempt) -> ChunkReply:
        """The same; what came of its last turn. Raises AttemptDiverged."""
        begin, turns = await self._begun(begin), attempt.turns
        command = simulator_main.ResumeAttempt(
            begin, attempt.digest, turns, shows_turn=True
        )
        return _shown(await self._request(command, ChunkReply))

    async def play(
        self,
        actions: Sequence[Mapping[str, Sequence[float]]],
        *,
        observe_all: bool,
        seq: int = 0,
        think_ms: float = 0.0,
        requested: Sequence[Mapping[str, Sequence[float]]] | None = None,
    ) -> ChunkReply:
        """Execute until the chunk or the episode ends.

        seq, think_ms, requested: of the turn, for its recording.
        """
        command = simulator_main.Play(actions, observe_all, seq, think_ms, requested)
        played = await self._request(command, ChunkReply)
        if played.recorded:
            await self._record(played.recorded)
        return _shown(played)

    async def judge(self, success: bool, score: float, seq: int) -> ChunkReply:
        """Give the attempt, which has ended, the judgement of a person.

        PHY-021: it becomes a turn without an action, the last one of the recording.
        """
        command = simulator_main.Play((), False, seq, judged=(success, score))
        judged = await self._request(command, ChunkReply)
        await self._record(judged.recorded)
        return judged

    async def record_end(self) -> None:
        """Record what an attempt on a robot has left, if anything is recorded."""
        ended = await self._request(
            simulator_main.RecordEnd(), simulator_main.EndRecorded
        )
        await self._record(ended.recorded)

    def signal(self, kind: str) -> None:
        """Send `stop` or `alive` to a robot at once, whatever it executes."""
        if self._lent:
            self._process.signal(kind)

    async def observe(self) -> EncodedObservation:
        """The current observation again."""
        return (
            await self._request(
                simulator_main.Observe(), simulator_main.ObservationReply
            )
        ).observation

    async def replay(self, path: Path, recorded: bytes, plan: bytes) -> ReplayReply:
        """Simulate a recording again; see simulator_main.ReplayRecording."""
        command = simulator_main.ReplayRecording(str(path), recorded, plan)
        return await self._request(command, ReplayReply)

    async def release(self) -> None:
        """Return the process to the pool. Does nothing after discard or a fault."""
        if self._lent:
            self._lent = False
            self._end_recording()
            self._give_back(self._process)

    def discard(self) -> None:
        """Kill the process immediately; a `play` in progress raises."""
        if self._lent:
            self._lent = False
            self._end_recording()
            self._process.end("was discarded")

    def _end_recording(self) -> None:
        if self._recording is not None:
            self._recording.close()

    async def _request(
        self, command: simulator_main.SimulatorCommand, wanted: type[ReplyT]
    ) -> ReplyT:
        if not self._lent:
            raise SimulatorFault("the simulator was released")
        try:
            return await self._process.request(command, wanted)
        except ResourceShortage as shortage:
            raise NoCapacity(str(shortage)) from shortage


def _shown(played: ChunkReply) -> ChunkReply:
    """The last of several observations is the one after the turn."""
    if not played.observations:
        return played
    return msgspec.structs.replace(played, observation=played.observations[-1])


# The pool


class SimulatorPool:
    """Lends at most `size_max` simulators; keeps `spares` started but not built.

    turn_timeout_s: maximum time without a finished step before a process is killed.
    starts: processes that were started. records_here: they are on other machines, and
    this one writes their recordings.
    """

    records_here = False

    def __init__(
        self,
        size_max: int = 64,
        spares: int = 2,
        turn_timeout_s: float = 60.0,
        *,
        fork: bool = FORK_IS_SAFE,
    ) -> None:
        self._size_max = size_max
        self._spares = spares
        self._turn_timeout_s = turn_timeout_s
        self._starter = ForkStarter() if fork else ExecStarter()
        self._processes: set[SimulatorProcess] = set()
        self._lent: set[SimulatorProcess] = set()
        self._idle: list[SimulatorProcess] = []  # longest idle first
        self._acquiring = 0
        self._filler: asyncio.Task[None] | None = None
        self._last_start_failed = False
        self.starts = 0
        self._closed = False

    @property
    def busy(self) -> int:
        """Simulators lent, or about to be."""
        return len(self._lent) + self._acquiring

    @property
    def size_max(self) -> int:
        return self._size_max

    def is_full_for(self, world: SimulatorConfig) -> bool:
        """Whether a caller has to wait until another session returns its simulator."""
        return self.busy >= self._size_max

    def makes_room(self, lent: SimulatorConfig, world: SimulatorConfig) -> bool:
        """Whether a pool that is full for `world` is not when this one is returned."""
        return True

    @property
    def idle(self) -> int:
        return len(self._idle)

    async def start(self) -> None:
        """Start the spares in the background."""
        self._fill_spares()

    async def close(self) -> None:
        """End every process, also during a command; returns when all have ended."""
        self._closed = True
        if self._filler is not None:
            self._filler.cancel()
            with contextlib.suppress(asyncio.CancelledError):
                await self._filler
        for process in list(self._processes):
            process.end("was ended with the pool")
        await self._starter.close()

    async def check_start(self) -> None:
        """Raises SimulatorFault if no process can be started.

        Starts none, unless the last one could not be started.
        """
        if self._closed or self._last_start_failed:
            self._idle.append(await self._start_process(self._new_process()))

    async def acquire(self, world: SimulatorConfig) -> SimulatorHandle:
        """Raises NoCapacity, or SimulatorFault if the simulator cannot be built."""
        if self.is_full_for(world):
            raise NoCapacity(f"all {self._size_max} simulators are in use")
        return await self._lend(world)

    async def _lend(self, world: SimulatorConfig) -> SimulatorHandle:
        self._acquiring += 1
        try:
            # A process of its own: neither its fault (FAULT-004) nor a long turn
            # (PRED-022) affects another worker.
            process = await self._build(world)
        except ResourceShortage as shortage:  # no fault of the simulator
            raise NoCapacity(str(shortage)) from shortage
        finally:
            self._acquiring -= 1
        self._lent.add(process)
        return SimulatorHandle(process, self._take_back, records_here=self.records_here)

    async def start_beside(self, world: SimulatorConfig) -> SimulatorHandle:
        """A simulator that is not one of the `size_max`, and ends when it is returned.

        For work with low priority that takes nothing from sessions. Raises as
        `acquire`.
        """
        try:
            process = await self._obtain_process(world)
            await process.build(world)
        except ResourceShortage as shortage:
            raise NoCapacity(str(shortage)) from shortage
        return SimulatorHandle(process, lambda used: used.end("was returned"))

    async def _build(self, world: SimulatorConfig) -> SimulatorProcess:
        if (idle := self._pick_idle(world)) is not None:
            self._fill_spares()
            # It may have died unnoticed: this failure implies nothing about `world`.
            try:
                await idle.build(world)
            except ResourceShortage:
                raise
            except SimulatorFault:
                pass
            else:
                return idle
        process = await self._obtain_process(world)
        while not _may_play(process, world):
            process.end("has imported another environment")
            process = await self._obtain_process(world)
        await process.build(world)
        return process

    async def _obtain_process(self, world: SimulatorConfig) -> SimulatorProcess:
        """A process that no session uses, built or not. Raises SimulatorFault."""
        return await self._start_process(self._new_process())

    def _pick_idle(self, world: SimulatorConfig) -> SimulatorProcess | None:
        """An idle process with this configuration, else a spare, else any."""
        idle = self._idle_for(world)
        fitting = [process for process in idle if _may_play(process, world)]
        if not fitting:
            self._make_room(idle)
            return None

        def preference(process: SimulatorProcess) -> int:
            return (process.world is None) + 2 * (process.world == world)

        chosen = max(fitting, key=preference)
        self._idle.remove(chosen)
        return chosen

    def _idle_for(self, world: SimulatorConfig) -> Sequence[SimulatorProcess]:
        """Idle processes that may play this, longest idle first."""
        return self._idle

    def _make_room(self, unfit: Sequence[SimulatorProcess]) -> None:
        """None of these idle processes may play what is asked for."""

    def _take_back(self, process: SimulatorProcess) -> None:
        self._lent.discard(process)
        if self._closed or process.is_busy:
            process.end("was released while it played")
        if process.world is not None and process.world.holds_connection:
            process.end("gives its connection back")
        if process.alive:
            self._idle.append(process)
        while len(self._idle) > self._spares + IDLE_MAX:
            self._idle[0].end("was surplus")

    def _forget(self, process: SimulatorProcess) -> None:
        self._processes.discard(process)
        self._lent.discard(process)
        if process in self._idle:
            self._idle.remove(process)

    async def _start_process(self, process: SimulatorProcess) -> SimulatorProcess:
        if self._closed:
            raise SimulatorFault("the pool of simulators is closed")
        self._processes.add(process)
        try:
            await process.start()
        except SimulatorFault:
            self._last_start_failed = True
            raise
        self._last_start_failed = False
        self.starts += 1
        return process

    def _new_process(self) -> SimulatorProcess:
        return LocalProcess(self._starter, self._turn_timeout_s, self._forget)

    def _fill_spares(self) -> None:
        if self._filler is None or self._filler.done():
            self._filler = asyncio.create_task(self._start_spares())

    async def _start_spares(self) -> None:
        try:
            while sum(process.world is None for process in self._idle) < self._spares:
                self._idle.append(await self._start_process(self._new_process()))
        except SimulatorFault as fault:
            _log.warning("no spare simulator: %s", fault)


def _may_play(process: SimulatorProcess, world: SimulatorConfig) -> bool:
    """Whether what the process has imported cannot be in the way of this simulator.

    Two environments may each have a `helper.py`, and a process imports one of them.
    """
    used_by = process.world
    if used_by is None or used_by == world:
        return True
    return not (used_by.imports_own_files or world.imports_own_files)
