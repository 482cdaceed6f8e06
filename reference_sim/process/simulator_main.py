"""The main program of a simulator process: executes the commands of its parent.

A frame is a length (4 bytes, big-endian) and a MessagePack body; no frame can carry
code. Every command has one reply; during a long chunk, `Busy` frames report that steps
are still being executed.

The process never outlives its parent: a thread waits for the other end of the socket to
be closed, and exits the process then. It is forked by `fork_server.py`, or started with
the descriptor of its socket as `python -m reference_sim.process.simulator_main FD`.
"""

from __future__ import annotations

import logging
import os
import queue
import select
import socket
import sys
import threading
import time
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any, Never

import msgspec

from reference_record.command_line.closed_output import leave_signals_to_parent
from reference_record.recordings.open_attempt import AttemptTurn
from reference_sim import benchmark_registry
from reference_sim.episode import Episode
from reference_sim.gymnasium.own_sources import OWN_SOURCES, with_place
from reference_sim.interface import (
    ChangedSource,
    ProgramFault,
    Simulator,
    SimulatorAway,
    TaskUnplayable,
    WrongReport,
)
from reference_sim.message_frames import LENGTH, frame
from reference_sim.process.observation_encoding import EncodedObservation, encode
from reference_sim.process.recorder import (
    EpisodeRecorder,
    RecordingPlan,
    UnwritableRecording,
    state_digest,
)
from reference_sim.shared_frame_buffer import FRAME_BUFFER, SharedFrameBuffer

RECEIVE_BYTES = 2**16
BUSY_INTERVAL_S = 1.0
REPLAY_NICENESS = 15

_log = logging.getLogger(__name__)


# The messages


class Build(msgspec.Struct, tag="build"):
    """Make the simulator, unless one of the same configuration exists.

    environment: variables set in the parent after this process was started.
    """

    benchmark_id: str
    settings: dict[str, Any]
    environment: dict[str, str]


class Begin(msgspec.Struct, tag="begin"):
    """is_sealed: the seed is secret; what fails is logged without its text.

    unread_frames: the number of frame memory that may be drawn into again; 0 for none.
    """

    task: str
    seed: int
    max_steps: int
    success_rule: str
    split: str = ""
    recording: RecordingPlan | None = None
    is_sealed: bool = False
    unread_frames: int = 0


class Play(msgspec.Struct, tag="play"):
    """seq, think_ms: of the turn, for its recording, which has the command as it is.

    requested: the actions before they were clipped, where that has changed one.
    judged: success and score, which a person gives after the last action.
    """

    actions: Sequence[Mapping[str, Sequence[float]]]
    observe_all: bool
    seq: int = 0
    think_ms: float = 0.0
    requested: Sequence[Mapping[str, Sequence[float]]] | None = None
    judged: tuple[bool, float] | None = None


class ResumeAttempt(msgspec.Struct, tag="resume"):
    """Play an attempt again that another simulator has played so far.

    turns: what it executed, to be executed again without being recorded; digest: of
    its state at step 0. shows_turn: the reply is that to the last turn (ChunkReply),
    instead of what is to be seen after it (EpisodeStart).
    """

    begin: Begin
    digest: str
    turns: Sequence[AttemptTurn]
    shows_turn: bool


class Signal(msgspec.Struct, tag="signal"):
    """kind: `stop` or `alive`, for a robot. Sent at any time, and not answered."""

    kind: str


class Observe(msgspec.Struct, tag="observe"):
    pass


class RecordEnd(msgspec.Struct, tag="record_end"):
    """Record the pictures of what an attempt on a robot has left (PHY-030)."""


class ReplayRecording(msgspec.Struct, tag="replay"):
    """Simulate one recording of a verified record again, with low priority.

    recorded, plan: RecordedResult and ReplayPlan as JSON: what reads them is imported
    when it is needed.
    """

    path: str
    recorded: bytes
    plan: bytes


class Hello(msgspec.Struct, tag="hello", frozen=True):
    pid: int


class Busy(msgspec.Struct, tag="busy", frozen=True):
    """Sent between two steps of a chunk, at most once per BUSY_INTERVAL_S."""


class NewFrameMemory(msgspec.Struct, tag="mapped", frozen=True):
    """Other memory of the frame buffer; sent before the reply that refers to it.

    number: that of the memory; the parent may have mapped it before.
    """

    number: int
    descriptor: int
    size: int


class Built(msgspec.Struct, tag="built", frozen=True):
    pass


class Timing(msgspec.Struct, frozen=True):
    """Seconds. encode_s: of images and tensors."""

    simulate_s: float
    render_s: float
    encode_s: float


class EpisodeStart(msgspec.Struct, tag="beginning", frozen=True, omit_defaults=True):
    """An episode at step 0, or where it was resumed. recorded: see RecordingPlan."""

    instruction: str
    observation: EncodedObservation
    timing: Timing
    recorded: bytes = b""


class ChunkReply(msgspec.Struct, tag="played", frozen=True, omit_defaults=True):
    """The outcome of a chunk.

    steps: of the episode so far. observations: one per executed action if
    `observe_all`, otherwise None (PRED-012). observation: the last one; None if the
    episode ended without `observe_all`. recorded: see RecordingPlan. stopped: why a
    robot was; see StepOutcome.
    """

    executed: int
    rewards: list[float]
    ended: bool
    terminated: bool
    truncated: bool
    success: bool
    score: float
    steps: int
    observation: EncodedObservation | None
    observations: list[EncodedObservation] | None
    timing: Timing
    recorded: bytes = b""
    stopped: str = ""


class ObservationReply(msgspec.Struct, tag="seen", frozen=True):
    observation: EncodedObservation


class EndRecorded(msgspec.Struct, tag="end_recorded", frozen=True):
    """recorded: see RecordingPlan."""

    recorded: bytes = b""


class ReplayReply(msgspec.Struct, tag="replayed", frozen=True):
    """result: `exact`, `outcome` or `diverged`. where: attempt and step, from 1."""

    result: str
    where: tuple[int, int] | None


class FailureReply(msgspec.Struct, tag="failed", frozen=True):
    """no_room: nothing is wrong but the disk, which is full.

    away: the simulator is a program that did not begin; see SimulatorAway.
    lasting: time alone does not mend it. diverged: a resumed attempt is another one.
    """

    error: str
    unplayable: bool = False
    no_room: bool = False
    away: bool = False
    lasting: bool = False
    diverged: bool = False


AnsweredCommand = (
    Build | Begin | ResumeAttempt | Play | Observe | RecordEnd | ReplayRecording
)
SimulatorCommand = AnsweredCommand | Signal
SimulatorReply = (
    Hello
    | Busy
    | NewFrameMemory
    | Built
    | EpisodeStart
    | ChunkReply
    | ObservationReply
    | EndRecorded
    | ReplayReply
    | FailureReply
)

_commands = msgspec.msgpack.Decoder(SimulatorCommand)
_signals = msgspec.msgpack.Decoder(Signal)


class _Tagged(msgspec.Struct):
    type: str


_tags = msgspec.msgpack.Decoder(_Tagged)


# The execution of commands


class _Diverged(Exception):
    """A resumed attempt came to another state than it had."""


# Errors that say what the server has to do, or whose text says all.
_KNOWN = (
    *(TaskUnplayable, UnwritableRecording, SimulatorAway, _Diverged),
    *(ProgramFault, WrongReport),
)


def _failure_of(error: Exception) -> FailureReply:
    return FailureReply(
        str(error),
        unplayable=isinstance(error, TaskUnplayable),
        no_room=isinstance(error, UnwritableRecording) and error.no_room,
        away=isinstance(error, SimulatorAway),
        diverged=isinstance(error, _Diverged),
    )


def _places_of(error: BaseException) -> str:
    """The lines of the environment that an error has passed, without any value."""
    frames = OWN_SOURCES.frames_of(error)
    return "".join(
        f'\n  File "{frame.filename}", line {frame.lineno}, in {frame.name}'
        for frame in frames
    )


class _Clock:
    """Measures the parts of one command's time, which never overlap (PRED-023)."""

    __slots__ = ("_at", "encode_s", "render_s", "simulate_s")

    def __init__(self) -> None:
        self.simulate_s = self.render_s = self.encode_s = 0.0
        self._at = time.perf_counter()

    def lap(self) -> float:
        """Seconds since the last lap."""
        now = time.perf_counter()
        passed, self._at = now - self._at, now
        return passed

    def timing(self) -> Timing:
        return Timing(self.simulate_s, self.render_s, self.encode_s)


class _EpisodeHost:
    """The current simulator and its current episode."""

    def __init__(self, connection: socket.socket) -> None:
        self._connection = connection
        self._world: benchmark_registry.SimulatorConfig | None = None
        self._simulator: Simulator | None = None
        self._episode: Episode | None = None
        self._recorder: EpisodeRecorder | None = None
        self._is_sealed = False
        # Whether its simulator is a robot, which takes signals during a command.
        self.is_physical = False

    def signal(self, kind: str) -> None:
        """Pass a signal on to the robot, if there is one; called in another thread."""
        simulator: Any = self._simulator
        if self.is_physical and simulator is not None:
            simulator.signal(kind)

    def answer(self, received: bytes) -> SimulatorReply | None:
        """received: a command, as MessagePack. None if it is not answered."""
        command = _commands.decode(received)
        if isinstance(command, Signal):  # a simulator is not stopped
            return None
        return self._reply(command, received)

    def _reply(self, command: AnsweredCommand, received: bytes) -> SimulatorReply:
        if self.is_physical:
            self.signal("alive")  # the server is there, and so is its command
        FRAME_BUFFER.acknowledge()
        try:
            return self._execute(command, received)
        except _KNOWN as error:
            return _failure_of(error)
        except ChangedSource as changed:  # the server logs its text
            return FailureReply(f"ChangedSource: {changed}", lasting=True)
        except BaseException as error:  # noqa: BLE001 - also what ends a program
            if self._is_sealed:
                # Its text may name the seed; where it was raised does not.
                text = "simulator failed in a sealed split: %s%s"
                _log.error(text, type(error).__name__, _places_of(error))
            else:
                _log.error("simulator failed", exc_info=True)
            return FailureReply(with_place(f"{type(error).__name__}: {error}", error))

    def _execute(self, command: AnsweredCommand, received: bytes) -> SimulatorReply:
        reply: SimulatorReply
        match command:
            case Play():  # first, as nearly every command is one
                reply = self._play(command, received)
            case Build():
                reply = self._build(command)
            case Begin():
                reply = self._begin(command)
            case ResumeAttempt():
                reply = self._resume(command)
            case Observe():
                # Shown before, and so recorded before.
                reply = ObservationReply(self._observe(_Clock(), record=False))
            case RecordEnd():
                reply = self._record_end()
            case ReplayRecording():
                reply = self._replay(command)
        return reply

    def _build(self, command: Build) -> Built:
        FRAME_BUFFER.forget()
        world = benchmark_registry.SimulatorConfig(
            command.benchmark_id, command.settings
        )
        if world != self._world:
            if self._simulator is not None:
                self._simulator.close()
            self.is_physical = False
            self._simulator = self._world = self._episode = None
            os.environ.update(command.environment)
            self._simulator = benchmark_registry.make(
                world, lambda: _send(self._connection, Busy())
            )
            self.is_physical = getattr(self._simulator, "is_physical", False)
            self._world = world
        return Built()

    def _begin(self, command: Begin) -> EpisodeStart:
        clock = _Clock()
        episode = self._start_episode(command, clock)
        observation = self._observe(clock, always=self.is_physical)
        recorded = b"" if self._recorder is None else self._recorder.take()
        return EpisodeStart(episode.instruction, observation, clock.timing(), recorded)

    def _start_episode(self, command: Begin, clock: _Clock) -> Episode:
        self._is_sealed = command.is_sealed
        simulator, world = self._require_simulator()
        self._end_recording()
        FRAME_BUFFER.begin_episode(command.unread_frames)
        episode = self._episode = Episode(
            simulator,
            command.task,
            command.seed,
            split=command.split,
            max_steps=command.max_steps,
            success_rule=command.success_rule,
            score_is_success=command.task in world.success_scored_tasks,
        )
        clock.simulate_s += clock.lap()
        if command.recording is not None:
            self._recorder = EpisodeRecorder(command.recording, simulator, episode)
        return episode

    def _resume(self, command: ResumeAttempt) -> EpisodeStart | ChunkReply:
        """Raises _Diverged where a state or a reward is not what it was."""
        clock = _Clock()
        episode = self._start_episode(command.begin, clock)
        self._compare(command.digest, 0)
        played: ChunkReply | None = None
        say_busy = self._make_busy_report()
        for number, turn in enumerate(command.turns, 1):
            say_busy()
            is_last = number == len(command.turns)
            shows = command.shows_turn and is_last
            played = self._execute_turn(
                turn.actions,
                clock,
                observe_all=turn.observe_all and shows,
                show=shows,
                record=False,  # recorded with the turn, when it was played first
            )
            self._compare(turn.digest, turn.seq)
            if list(played.rewards) != list(turn.rewards):
                raise _Diverged(f"turn {turn.seq} has other rewards than before")
        if played is not None and command.shows_turn:
            return played
        observation = self._observe(clock, record=False)
        return EpisodeStart(episode.instruction, observation, clock.timing())

    def _compare(self, digest: str, seq: int) -> None:
        simulator, _ = self._require_simulator()
        if state_digest(simulator) != digest:
            raise _Diverged(f"the state after turn {seq} is not what it was before")

    def _play(self, command: Play, received: bytes) -> ChunkReply:
        episode = self._require_episode()
        if command.judged is not None:
            episode.judge(*command.judged)
        played = self._execute_turn(
            command.actions, _Clock(), observe_all=command.observe_all
        )
        if self._recorder is not None:
            self._recorder.add_turn(
                received, played.rewards, episode, played.timing.simulate_s
            )
            if recorded := self._recorder.take():
                return msgspec.structs.replace(played, recorded=recorded)
        return played

    def _record_end(self) -> EndRecorded:
        """Whatever a camera does, the attempt was played and can be judged."""
        if self._recorder is None:
            return EndRecorded()
        try:
            self._observe(_Clock(), always=True)
        except UnwritableRecording:
            raise
        except BaseException:  # noqa: BLE001 - a simulator may raise anything
            _log.warning("no picture of the end of an attempt", exc_info=True)
        return EndRecorded(self._recorder.take())

    def _execute_turn(
        self,
        actions: Sequence[Mapping[str, Sequence[float]]],
        clock: _Clock,
        *,
        observe_all: bool,
        show: bool = True,
        record: bool = True,
    ) -> ChunkReply:
        """show: whether what is to be seen afterwards is drawn. record: as _observe."""
        episode = self._require_episode()
        rewards: list[float] = []
        observations: list[EncodedObservation] = []
        last_busy_at = time.perf_counter()
        for reward in episode.play(actions):
            rewards.append(reward)
            if observe_all:
                clock.simulate_s += clock.lap()
                # More observations than the frame buffer has halves: copied.
                seen = self._observe(clock, frame_buffer=None, record=record)
                observations.append(seen)
            now = time.perf_counter()
            if now - last_busy_at > BUSY_INTERVAL_S:
                last_busy_at = now
                _send(self._connection, Busy())
        clock.simulate_s += clock.lap()
        is_drawn = show and not (episode.ended or observe_all)
        observation = self._observe(clock, record=record) if is_drawn else None
        return ChunkReply(
            executed=len(rewards),
            rewards=rewards,
            ended=episode.ended,
            terminated=episode.terminated,
            truncated=episode.truncated,
            success=episode.success,
            score=episode.score,
            steps=episode.steps,
            observation=observation,
            observations=observations if observe_all else None,
            timing=clock.timing(),
            stopped=episode.stopped,
        )

    def _replay(self, command: ReplayRecording) -> ReplayReply:
        from reference_record.contents.statement import RecordedResult
        from reference_sim.replay import episode_replay

        os.nice(REPLAY_NICENESS - os.nice(0))
        simulator, _ = self._require_simulator()
        self._end_recording()
        self._episode = None
        recorded = msgspec.json.decode(command.recorded, type=RecordedResult)
        plan = msgspec.json.decode(command.plan, type=episode_replay.ReplayPlan)
        path = Path(command.path)
        replay = episode_replay.replay_episode(
            path, simulator, plan, recorded, self._make_busy_report()
        )
        first = replay.where
        where = None if first is None else (first.attempt, first.step)
        return ReplayReply(replay.result, where)

    def _make_busy_report(self) -> Callable[[], None]:
        """Called often, says to the parent now and then that work goes on."""
        said_busy_at = time.perf_counter()

        def say_busy() -> None:
            nonlocal said_busy_at
            if time.perf_counter() - said_busy_at > BUSY_INTERVAL_S:
                said_busy_at = time.perf_counter()
                _send(self._connection, Busy())

        return say_busy

    def _end_recording(self) -> None:
        """Close the recording: the commands that follow are not of its attempt."""
        if self._recorder is not None:
            self._recorder.close()
            self._recorder = None

    def _observe(
        self,
        clock: _Clock,
        frame_buffer: SharedFrameBuffer | None = FRAME_BUFFER,
        *,
        record: bool = True,
        always: bool = False,
    ) -> EncodedObservation:
        """record: as far as the plan asks for it; always: even where it does not."""
        simulator, world = self._require_simulator()
        FRAME_BUFFER.swap()
        observation = simulator.observe()
        clock.render_s += clock.lap()
        if record and self._recorder is not None:
            self._recorder.add_pictures(observation.images, always=always)
        encoded = encode(observation, world.image_codec, frame_buffer)
        clock.encode_s += clock.lap()
        if pending_mapping := FRAME_BUFFER.pending_mapping():
            _send(self._connection, NewFrameMemory(*pending_mapping))
        return encoded

    def _require_simulator(
        self,
    ) -> tuple[Simulator, benchmark_registry.SimulatorConfig]:
        if self._simulator is None or self._world is None:
            raise RuntimeError("no simulator was built")
        return self._simulator, self._world

    def _require_episode(self) -> Episode:
        if self._episode is None:
            raise RuntimeError("no episode was begun")
        return self._episode


def log_to_stderr() -> None:
    logging.basicConfig(format="%(levelname)s simulator %(process)d: %(message)s")


def serve(connection: socket.socket) -> Never:
    """Execute commands until the parent has ended; exits the process."""
    leave_signals_to_parent()
    threading.Thread(target=_exit_with_parent, args=(connection,), daemon=True).start()
    host = _EpisodeHost(connection)
    commands = _CommandReader(connection)
    _send(connection, Hello(os.getpid()))
    while True:
        reply = host.answer(commands.next())
        if host.is_physical:
            commands.read_ahead(host.signal)
        if reply is not None:
            _send(connection, reply)


class _CommandReader:
    """Reads commands one after the other; for a robot, signals ahead of the others."""

    def __init__(self, connection: socket.socket) -> None:
        self._connection = connection
        self._received = bytearray()
        # A process that waits in `recv` itself is also woken when the parent has read
        # its reply, for nothing; one that waits for input to read is not.
        self._input = select.poll()
        self._input.register(connection, select.POLLIN)
        self._ahead: queue.SimpleQueue[bytes] | None = None

    def next(self) -> bytes:
        return self._read() if self._ahead is None else self._ahead.get()

    def read_ahead(self, on_signal: Callable[[str], None]) -> None:
        """From now on a thread reads, and passes each signal on at once."""
        if self._ahead is None:
            self._ahead = queue.SimpleQueue()
            work = (self._ahead, on_signal)
            threading.Thread(target=self._read_all, args=work, daemon=True).start()

    def _read_all(
        self, ahead: queue.SimpleQueue[bytes], on_signal: Callable[[str], None]
    ) -> None:
        while True:
            received = self._read()
            if _tags.decode(received).type == "signal":
                on_signal(_signals.decode(received).kind)
            else:
                ahead.put(received)

    def _read(self) -> bytes:
        """The next command; exits the process if the parent has ended.

        A parent that is killed leaves half a command, or answers that it has not read.
        """
        received, head = self._received, LENGTH.size
        while True:
            if len(received) >= head:
                (length,) = LENGTH.unpack_from(received)
                if len(received) >= head + length:
                    command = bytes(received[head : head + length])
                    del received[: head + length]
                    return command
            self._input.poll()
            try:
                part = self._connection.recv(RECEIVE_BYTES)
            except ConnectionError:
                os._exit(0)
            if not part:
                os._exit(0)
            if not received and len(part) >= head:
                (length,) = LENGTH.unpack_from(part)
                if len(part) == head + length:  # as the parent sends it
                    return part[head:]
            received += part


def _send(connection: socket.socket, message: SimulatorReply) -> None:
    """Send to the parent; exits the process with 0 if the parent has ended."""
    try:
        connection.sendall(frame(message))
    except ConnectionError:
        os._exit(0)


def _exit_with_parent(connection: socket.socket) -> None:
    """Exits when the parent closes the socket, also during a long command.

    Polls for the hang-up only, not for data: commands do not wake this thread.
    """
    hang_up = select.poll()
    # On systems without this flag, POLLHUP is always reported.
    hang_up.register(connection, getattr(select, "POLLRDHUP", 0))
    hang_up.poll()
    os._exit(0)


if __name__ == "__main__":
    log_to_stderr()
    serve(socket.socket(fileno=int(sys.argv[1])))
