"""The operations of the data plane, carried out: attach, predict, heartbeat, detach.

`rules/lifecycle.py` decides whether a command is accepted, a simulator process executes
it, and `rules/effects.py` changes the run. While a simulator executes nothing is locked
(PRED-022, FAULT-004): each session does one thing at a time, and a repeated request
waits for its end. `session_resources.py` has the simulator, task and timer of a
session. This module knows no HTTP and no SQL.

While work awaits anything, its session may end: then `_ensure_live` ends the work, and
the resources of the session are already freed.
"""

from __future__ import annotations

import asyncio
import logging
import secrets
import time
from collections.abc import Awaitable, Coroutine, Mapping, Sequence
from functools import partial
from typing import Any, TypeVar
from weakref import WeakKeyDictionary

import msgspec

from reference_record.generated.answers import Turn
from reference_server.cells.act_log import ActLog
from reference_server.cells.cell_trial import TrialLeft, TrialVoid
from reference_server.cells.cells import Cells
from reference_server.cells.robot_attempts import RobotAttempts
from reference_server.failover.kept_sessions import (
    EpisodeEnding,
    KeptSession,
    KeptSessions,
    ended_before,
    kept_session,
)
from reference_server.failover.session_recovery import (
    FoundSession,
    can_go_on,
    find_sessions,
)
from reference_server.files.seed_secret import SeedSecret
from reference_server.process.inline_work import InlineWork
from reference_server.records.recordings import RecordingFailed, Recordings
from reference_server.rules import action_space, effects
from reference_server.rules.lifecycle import (
    ACTIVE_STATES,
    Attach,
    Detach,
    Heartbeat,
    NoChange,
    Predict,
    Refuse,
    Replay,
    Wait,
    decide,
    lease_over,
)
from reference_server.rules.refusal import Refused
from reference_server.rules.run import Run, RunHead, Session, SessionEnd, State
from reference_server.runs.admission.disk_bound import DiskBound
from reference_server.runs.memory.run_events import Departure, RunFollower
from reference_server.runs.registry import RunRegistry
from reference_server.runs.run_log import log_attached, log_restored
from reference_server.runs.session_resources import ResourceManager, SessionResources
from reference_server.storage.runs.run_store import StoreFailed
from reference_server.telemetry.counters import COUNTERS
from reference_server.telemetry.spans import Span, session_name, span
from reference_server.views import turn_view
from reference_sim.process.pool import (
    AttemptDiverged,
    Begin,
    ChunkReply,
    EpisodeStart,
    LastingFault,
    NoCapacity,
    NoRoomToRecord,
    RecordingPlan,
    SimulatorFault,
    SimulatorPool,
    TaskUnplayable,
    Timing,
)

log = logging.getLogger("proctor.sessions")

Result = TypeVar("Result")

# How long a session waits after each beginning in a row that failed, the last one from
# then on: what broke may be away for seconds, in which all would fail without pauses.
BEGIN_PAUSES_S = (0.5, 1.5, 4.0, 10.0)
LOOK_S = 0.25
# Errors that end an attempt through no fault of the policy; the episode begins again.
_FAULTS = (SimulatorFault, TaskUnplayable, RecordingFailed)


class SessionExecutor(RunFollower):
    """Every session of this process.

    unused_s: how long a session keeps its simulator without a turn, when it has to be
    shared. heartbeat_s_max: how long heartbeats alone extend a lease. recordings: where
    episodes are recorded; None records nothing. disk_bound: at it no episode begins.
    cells: the robots.
    """

    def __init__(
        self,
        registry: RunRegistry,
        pool: SimulatorPool,
        seed_secret: SeedSecret,
        *,
        cells: Cells | None = None,
        unused_s: float = 10.0,
        heartbeat_s_max: float = 3600.0,
        recordings: Recordings | None = None,
        disk_bound: DiskBound | None = None,
    ) -> None:
        self._recordings, self._disk_bound = recordings, disk_bound or DiskBound()
        self._registry, self._writer = registry, registry.writer
        self._robots = RobotAttempts(cells or Cells(ActLog(None)))
        self._admission = registry.admission
        self._heartbeat_s_max = heartbeat_s_max
        self._resources = ResourceManager(
            pool,
            seed_secret,
            registry.work.start,
            self.sweep,
            self._abort,
            unused_s=unused_s,
            ended_sessions=registry.ended_sessions,
            recordings=recordings,
        )
        self._latest_fault = "", ""  # the run, and the text in the log
        # Sessions of runs that were read, until these are loaded.
        self._found: WeakKeyDictionary[Run, list[FoundSession]] = WeakKeyDictionary()
        registry.subscribe(self)

    def require_playable(self, run: Run) -> None:
        """Refuse where the benchmark is not the one that the run was submitted to."""
        self._resources.configs.find(run)

    def why_unplayable(self, run: RunHead) -> str | None:
        return self._resources.configs.why_unplayable(run)

    # --- operations of the data plane ---

    async def attach(self, run: Run, command: Attach) -> Turn:
        """The session's latest turn; turn 0 for a new session."""
        run, again = await self._decide_or_replay(run, command)
        if again is not None:
            return again
        self._admission.take_place(run)
        old = run.workers.get(command.worker_id)
        session_id = secrets.token_urlsafe(24)  # ATT-009
        session = effects.open_session(run, command, session_id, time.monotonic())
        before = None if old is None else self._resources.find(old)
        resources = self._resources.open(run, session, old)
        if before is not None:
            self._robots.take_over(before, resources)
        log_attached(run, session)
        self._registry.notify(run)
        return await self._execute(resources, self._open(resources))

    async def predict(self, run: Run, command: Predict) -> Turn:
        """The turn; executed once, however often it is requested (PRED-002)."""
        run, again = await self._decide_or_replay(run, command)
        if again is not None:
            return again
        session = run.workers[command.worker_id]
        resources = self._resources.find(session)
        assert resources is not None, "a session that has not ended has its resources"
        now = time.monotonic()
        resources.think_s, resources.ended = max(0.0, now - session.answered_at), None
        if effects.mark_played(run):
            self._writer.commit_later(run)  # `_play` waits for it
        effects.begin_turn(session, command, now)
        return await self._execute(resources, self._play(resources, command))

    def heartbeat(self, run: Run, command: Heartbeat) -> Session:
        """Extend the lease (LEASE-003); returns the session."""
        verdict = decide(run, command, self.sweep(run))
        if isinstance(verdict, Refuse):
            raise Refused.from_verdict(verdict)
        session = run.workers[command.worker_id]
        self._extend_lease(session)
        if (resources := self._resources.find(session)) is not None:
            resources.heard_at = time.monotonic()
        return session

    async def detach(self, run: Run, command: Detach) -> None:
        verdict = decide(run, command, self.sweep(run))
        if isinstance(verdict, Refuse):
            raise Refused.from_verdict(verdict)
        if isinstance(verdict, NoChange):
            return
        session = run.workers[command.worker_id]
        resources = self._resources.find(session)
        if resources is not None and self._robots.is_judged(resources):
            await asyncio.shield(self._finish_judged(resources, "detached"))
            return
        was_live = not session.done
        effects.close_session(run, session, "detached", time.time())
        self.release_sessions([session])
        if was_live or run.changed:  # else nothing that a view shows
            await self._writer.commit(run)

    async def _decide_or_replay(
        self, run: Run, command: Attach | Predict
    ) -> tuple[Run, Turn | None]:
        """The run, and the turn to replay if the command was carried out before.

        The command is accepted as the run is now: nothing may be awaited before it is
        carried out.
        """
        while True:
            if run.lost:  # while its caller awaited something else
                run = await self._registry.get(run.run_id)
            verdict = decide(run, command, self.sweep(run))
            match verdict:
                case Refuse():
                    raise Refused.from_verdict(verdict)
                case Wait(session):
                    run = await self._wait_for_turn(run, session)
                case Replay(session):
                    return run, self._replay_turn(session)
                case _:
                    self._registry.refuse_if_ending()
                    return run, None

    # --- ended by the control plane or by the clock ---

    def sweep(self, run: Run) -> float:
        """End the sessions whose lease is over; returns the time that decided it."""
        self._resources.restore_done(run)
        now = time.monotonic()
        if self._robots.plays(run):
            for session in filter(partial(lease_over, now=now), run.live_sessions):
                resources = self._resources.find(session)
                if resources is not None and self._robots.is_judged(resources):
                    self._finish_judged(resources, "lease_ended")
        expired = effects.expire(run, now, time.time())
        if expired.closed:
            self.release_sessions(expired.closed)
        if expired.freed_slot:
            self._writer.commit_later(run)
        return now

    def _finish_judged(
        self, resources: SessionResources, ended_by: SessionEnd
    ) -> asyncio.Task[None]:
        """PHY-032: a person has judged the attempt of a client that is away."""
        session = resources.session
        command = Predict(session.worker_id, session.session_id, session.seq + 1, ())
        session.answered_at = time.monotonic()  # the policy has not thought since
        effects.begin_turn(session, command, session.answered_at)
        return self._start(resources, self._play_last(resources, command, ended_by))

    async def _play_last(
        self, resources: SessionResources, command: Predict, ended_by: SessionEnd
    ) -> None:
        """A turn of no action, which no request asks for, and the session's end."""
        run, session = resources.run, resources.session
        played = await self._execute_chunk(resources, command, (), None)
        now_wall = time.time()
        self._ensure_live(resources)
        await self._finish_recording(resources, played, now_wall, 0)
        effects.end_turn(run, session, played, now_wall)
        effects.close_session(run, session, ended_by, now_wall)
        self.release_sessions([session])
        await self._writer.commit(run)

    def release_sessions(self, sessions: list[Session]) -> None:
        """Free what ended sessions hold; a simulator in execution is killed."""
        self._resources.release_sessions(sessions)

    def record_policy_fault(self, session: Session, fault: str) -> None:
        """Into the recording of what the session plays, before its session ends."""
        resources = self._resources.find(session)
        if self._recordings is None or resources is None or session.episode is None:
            return
        self._recordings.add_fault(
            resources.run, session.episode, session.seq, "policy_fault", fault
        )

    async def prepare(self, run: Run) -> None:
        if self._recordings is not None and run.state in ACTIVE_STATES:
            now = time.monotonic()
            self._found[run] = await find_sessions(run, self._recordings, now)

    def loaded(self, run: Run, stored: State) -> None:
        """Go on with the sessions that the process before had."""
        for found in self._found.pop(run, ()):
            self._restore(run, found)

    def left(self, run: Run, why: Departure) -> None:
        """End the sessions of a run that was lost, without counting anything."""
        if why != "deleted":  # then they have ended before
            self._resources.discard_sessions(run, may_go_on=why == "moved")

    async def close(self) -> None:
        """End every session without counting anything."""
        self._resources.discard_sessions()

    @property
    def sessions(self) -> int:
        """How many have not ended."""
        return len(self._resources)

    @property
    def turns_in_progress(self) -> int:
        """How many sessions this server executes something for."""
        return self._resources.count_busy()

    # --- going on after a restart ---

    def _restore(self, run: Run, found: FoundSession) -> None:
        """A request for the session waits from now on until it is where it was."""
        session = found.session
        try:
            self._admission.take_place(run)
        except Refused:
            return
        if not effects.restore_session(run, session):
            return
        resources = self._resources.open(run, session, None)
        resources.ended, resources.fault = found.ended, found.kept.fault
        if found.turn is None:
            work = self._open_again(resources, found)
        else:
            command = found.begin_turn(time.monotonic())
            resources.think_s = found.turn.think_ms / 1e3
            run.is_played = True
            work = self._play(resources, command, found)
        log_restored(run, session)
        self._writer.commit_later(run)
        self._start(resources, work)

    async def _open_again(
        self, resources: SessionResources, found: FoundSession
    ) -> Turn:
        """The turn with which the session got its episode, as it was answered."""
        started = time.perf_counter()
        self._ensure_live(resources)
        if found.attempt.attempt is None:
            beginning, queue_s = await self._begin(resources)
        else:
            queue_s, begin = await self._prepare_again(resources, found)
            assert resources.handle is not None
            beginning = await resources.handle.resume(begin, found.attempt)
            self._ensure_live(resources)
        before, run = found.ended, resources.run
        played = None if before is None else before.played
        turn = turn_view.turn_view(
            resources.session,
            observation=beginning.observation,
            observations=None if played is None else played.observations,
            played=played,
            left=0 if before is None else before.left,
            ended=None if before is None else run.episodes[before.index],
            fault=found.kept.fault if before is None else None,
            spent=turn_view.timing(queue_s, beginning.timing),
        )
        return self._answer(resources, turn, started)

    async def _play_again(
        self, resources: SessionResources, found: FoundSession
    ) -> ChunkReply:
        """The attempt up to its last turn, and what came of that one."""
        _, begin = await self._prepare_again(resources, found)
        assert resources.handle is not None
        return await resources.handle.resume_turn(begin, found.attempt)

    async def _prepare_again(
        self, resources: SessionResources, found: FoundSession
    ) -> tuple[float, Begin]:
        """A simulator for the attempt that was begun; seconds, and how that was."""
        queue_s = await self._resources.acquire_simulator(resources)
        self._ensure_live(resources)
        plan = await self._plan_recording(resources, found)
        resources.wait.begin("the simulator, which plays the attempt again")
        return queue_s, _begin_command(resources, plan)

    # --- playing ---

    async def _open(self, resources: SessionResources) -> Turn:
        started = time.perf_counter()
        self._ensure_live(resources)  # a stop may come before its work begins
        if resources.session.done:
            turn = turn_view.turn_view(resources.session, observation=None)
            return self._answer(resources, turn, started)
        if resources.handle is None:
            return await self._begin_turn(resources, started)
        try:
            with span("simulator observes") as observed:
                resources.wait.begin("the simulator, which observes")
                _name_session(observed, resources)
                observation = await resources.handle.observe()
        except SimulatorFault as error:  # it died between two turns
            await self._fault(resources, error)
            return await self._begin_turn(resources, started)
        await self._keep(resources)
        self._ensure_live(resources)
        turn = turn_view.turn_view(resources.session, observation=observation)
        return self._answer(resources, turn, started)

    async def _play(
        self,
        resources: SessionResources,
        command: Predict,
        found: FoundSession | None = None,
    ) -> Turn:
        """found: the turn was played by a simulator that is gone, and is its last."""
        started = time.perf_counter()
        self._ensure_live(resources)  # a stop may come before its work begins
        run, session, asked = resources.run, resources.session, command.actions
        resources.fault = None
        actions = action_space.clip_actions(asked, run.manifest)
        try:
            played = await self._execute_chunk(resources, command, actions, found)
            now_wall, executed = time.time(), played.executed
            resources.wait.end()
            COUNTERS.steps += executed
            COUNTERS.simulate_s += played.timing.simulate_s
            clipped = action_space.count_clipped(asked, actions, executed)
            if played.ended:
                self._ensure_live(resources)
                await self._finish_recording(resources, played, now_wall, clipped)
                await self._keep_ending(resources, played, len(actions))
        except (TrialVoid, TrialLeft) as over:
            await self._ensure_stored_as_played(run)
            await self._void(resources, over)
            return await self._begin_turn(resources, started)
        except _FAULTS as error:
            await self._ensure_stored_as_played(run)  # else it took the simulator away
            await self._fault(resources, error)
            return await self._begin_turn(resources, started)
        if run.played_number is None:
            await self._ensure_stored_as_played(run)
        self._ensure_live(resources)
        ended = effects.end_turn(run, session, played, now_wall, clipped)
        observation, spent = played.observation, turn_view.timing(0.0, played.timing)
        if ended is not None:
            # The result is on disk before any response shows it (CRASH-001).
            resources.wait.begin("the database, which stores a result")
            await self._writer.commit(run)
            self._ensure_live(resources)
            observation = None
            if session.episode is not None:
                resources.ended = ended_before(played, len(actions), ended.index)
                if self._robots.plays(run):  # another run may have the robot next
                    self._resources.return_simulator(resources, kill=False)
                beginning, queue_s = await self._begin(resources)
                observation = beginning.observation
                spent = turn_view.timing(queue_s, played.timing, beginning.timing)
            else:  # its simulator serves others, its last turn stays
                self._resources.return_simulator(resources, kill=False)
        turn = turn_view.turn_view(
            session,
            observation=observation,
            observations=played.observations if command.observe == "all" else None,
            played=played,
            left=len(actions) - played.executed,
            ended=ended,  # FAULT-012: a fault at the next beginning is not of this turn
            spent=spent,
        )
        return self._answer(resources, turn, started)

    async def _execute_chunk(
        self,
        resources: SessionResources,
        command: Predict,
        actions: Sequence[Mapping[str, Sequence[float]]],
        found: FoundSession | None,
    ) -> ChunkReply:
        """actions: those of the command, clipped. found: as for `_play`."""
        asked, seq = command.actions, command.seq
        with span("simulator plays") as playing:
            resources.wait.begin(f"the simulator, which plays turn {seq}")
            _name_session(playing, resources)
            if found is not None:
                played = await self._play_again(resources, found)
            else:
                played = await self._robots.play(
                    resources,
                    actions,
                    observe_all=command.observe == "all",
                    seq=seq,
                    think_ms=resources.think_s * 1e3,
                    requested=None if actions == asked else asked,
                )
            _add_times(playing, played.timing, played.executed)
        return played

    async def _ensure_stored_as_played(self, run: Run) -> None:
        """DEL-006: stored while the first turn was played, before it is answered."""
        if run.played_number is None and not await self._writer.is_stored(run):
            raise Refused("unavailable", "The run could not be stored.")

    async def _begin_turn(self, resources: SessionResources, started: float) -> Turn:
        """The turn that shows step 0, at first and after a fault (FAULT-001).

        FAULT-012: it shows nothing of the chunk in which the simulator broke.
        """
        beginning, queue_s = await self._begin(resources)
        turn = turn_view.turn_view(
            resources.session,
            observation=beginning.observation,
            fault=resources.fault,
            spent=turn_view.timing(queue_s, beginning.timing),
        )
        return self._answer(resources, turn, started)

    async def _begin(self, resources: SessionResources) -> tuple[EpisodeStart, float]:
        """Begin the session's episode, again after each fault, until it fails the run.

        Returns the beginning and the seconds spent waiting for a simulator.
        """
        queue_s, failed = 0.0, 0
        while True:
            if failed:
                queue_s += await self._pause(resources, failed)
            episode = resources.session.episode
            assert episode is not None
            self._disk_bound.check()
            try:
                await self._robots.take(resources)
                queue_s += await self._resources.acquire_simulator(resources)
                self._ensure_live(resources)
                await self._robots.wait_until_ready(resources)
                assert resources.handle is not None
                plan = await self._plan_recording(resources)
                with span("simulator begins") as starting:
                    alive = self._robots.kept_alive(resources)
                    resources.wait.begin(
                        f"the simulator, which begins {episode.episode_id}"
                    )
                    _name_session(starting, resources)
                    async with alive:
                        begin = _begin_command(resources, plan)
                        beginning = await resources.handle.begin(begin)
                    _add_times(starting, beginning.timing)
                self._robots.begun(resources, beginning.observation)
            except (TrialVoid, TrialLeft) as over:
                await self._void(resources, over)
                continue
            except _FAULTS as error:
                if resources.trial is not None and resources.trial.was_stopped:
                    await self._void(resources, TrialVoid(str(error)))
                    continue
                await self._fault(resources, error)
                failed = 0 if isinstance(error, LastingFault) else failed + 1
                continue
            self._ensure_live(resources)
            resources.session.instruction = beginning.instruction
            return beginning, queue_s

    async def _pause(self, resources: SessionResources, failed: int) -> float:
        """Give a simulator that cannot begin time to come back; returns the seconds.

        failed: beginnings in a row. Refused as soon as the session has ended.
        """
        pause_s = BEGIN_PAUSES_S[min(failed, len(BEGIN_PAUSES_S)) - 1]
        resources.wait.begin(f"another beginning, after {failed} that failed")
        until = time.monotonic() + pause_s
        while (left_s := until - time.monotonic()) > 0:
            await asyncio.sleep(min(left_s, LOOK_S))
            self._ensure_live(resources)
        return pause_s

    async def _plan_recording(
        self, resources: SessionResources, found: FoundSession | None = None
    ) -> RecordingPlan | None:
        """Where what begins now, or goes on, is recorded; from now on its end is, too.

        From now on a restart finds the session with it. found: goes on.
        """
        episode = resources.session.episode
        if self._recordings is None or episode is None:
            return None
        try:
            plan = await self._recordings.begin(
                resources.run,
                episode,
                is_continued=found is not None,
                pictures=resources.trial is not None and resources.trial.is_drawn,
            )
        except StoreFailed as error:
            raise Refused("unavailable", "The recording cannot be begun.") from error
        await self._keep(resources, found)
        self._ensure_live(resources)
        resources.recorded = episode.index, episode.attempt
        return plan

    async def _keep(
        self, resources: SessionResources, found: FoundSession | None = None
    ) -> None:
        """A restart finds the session, as it is when it gets an episode."""
        kept = None if self._recordings is None else self._recordings.sessions
        if kept is None or not can_go_on(resources.run):
            return
        resources.kept = (
            kept_session(resources.session, resources.ended, resources.fault)
            if found is None
            else found.kept
        )
        await self._write_kept(resources, kept, resources.kept)

    async def _keep_ending(
        self, resources: SessionResources, played: ChunkReply, sent: int
    ) -> None:
        """A restart finds how the episode has ended, if its result is stored."""
        kept = None if self._recordings is None else self._recordings.sessions
        session, episode = resources.session, resources.session.episode
        if kept is None or resources.kept is None or episode is None:
            return
        ended = ended_before(played, sent, episode.index)
        ending = EpisodeEnding(session.seq, session.request, ended)
        session_then = msgspec.structs.replace(resources.kept, ending=ending)
        await self._write_kept(resources, kept, session_then)

    async def _write_kept(
        self, resources: SessionResources, kept: KeptSessions, session: KeptSession
    ) -> None:
        try:
            await kept.keep(resources.run, session)
        except OSError as error:  # only a restart would need it
            log.warning("run %s: a session is not kept: %s", resources.run_id, error)
            kept.remove(resources.run, resources.session.worker_id)

    async def _finish_recording(
        self,
        resources: SessionResources,
        played: ChunkReply,
        now_wall: float,
        clipped: int,
    ) -> None:
        """The recording is complete on disk before its result counts."""
        session, episode = resources.session, resources.session.episode
        if self._recordings is None or episode is None:
            return
        result = effects.result_of(session, played, now_wall, clipped)
        if resources.trial is not None and resources.trial.judgement is not None:
            judgement = resources.trial.judgement
            self._recordings.add_judgement(resources.run, episode, judgement)
        resources.wait.begin("the recording, which is written")
        try:
            with span("finish recording"):
                recording = await self._recordings.finish(
                    resources.run, episode, result
                )
        except StoreFailed as error:
            raise Refused("unavailable", "The recording cannot be stored.") from error
        self._ensure_live(resources)
        episode.recording, resources.recorded = recording, None

    async def _void(
        self, resources: SessionResources, over: TrialVoid | TrialLeft
    ) -> None:
        """PHY-016: a trial does not count; its attempt begins from a new reset."""
        self._ensure_live(resources)
        session, episode = resources.session, resources.session.episode
        assert episode is not None
        if isinstance(over, TrialLeft):  # and the session has not
            raise Refused("unavailable", "No request came for the attempt.")
        self._resources.return_simulator(resources, kill=True)
        if self._recordings is not None and resources.recorded is not None:
            run, attempt = resources.run, episode.attempt
            why = f"void: {over}"
            self._recordings.end_attempt(run, episode.index, attempt, why)
        effects.void_attempt(resources.run, session)
        await self._writer.commit(resources.run)
        self._ensure_live(resources)
        resources.fault = {
            "episode_id": episode.episode_id,
            "faults": episode.faults,
            "detail": f"The trial does not count, and is played again: {over}.",
            "is_void": True,
        }

    async def _fault(self, resources: SessionResources, error: Exception) -> None:
        """Record a fault (FAULT-001); returns when the episode may begin again."""
        self._ensure_live(resources)
        if resources.trial is not None:  # a robot is stopped before all else
            resources.trial.fault(str(error))
        self._resources.return_simulator(resources, kill=True)
        run, session, episode = (
            resources.run,
            resources.session,
            resources.session.episode,
        )
        assert episode is not None
        COUNTERS.simulator_faults += 1
        detail = episode.without_sealed_seed(str(error))
        # One line for what every simulator of the run meets, such as an edited file.
        is_new = (run.run_id, detail) != self._latest_fault
        self._latest_fault = run.run_id, detail
        level = logging.WARNING if is_new else logging.INFO
        log.log(level, "run %s, %s: %s", run.run_id, episode.episode_id, detail)
        if self._recordings is not None:
            seq = session.seq if session.busy == "playing" else 0
            self._recordings.add_fault(run, episode, seq, "simulator_fault", detail)
        session.busy = "turning"
        ended = effects.record_fault(
            run,
            session,
            detail,
            unplayable=isinstance(error, TaskUnplayable),
            now_wall=time.time(),
        )
        self.release_sessions(ended)
        await self._writer.commit(run)
        self._ensure_live(resources)
        resources.fault = {
            "episode_id": episode.episode_id,
            "faults": episode.faults,
            "detail": detail,
        }

    # --- the work of a session ---

    async def _execute(
        self, resources: SessionResources, work: Coroutine[Any, Any, Turn]
    ) -> Turn:
        """Do a session's one work; it goes on if the caller is cancelled.

        PRED-022, FAULT-004: no session waits for the work of another one.
        """
        if self._robots.plays(resources.run):
            task = self._start(resources, work)
            await self._robots.await_turn(resources)
            return await asyncio.shield(task)
        ended: asyncio.Future[None] = resources.loop.create_future()
        resources.task = ended
        guarded = self._run_guarded(resources, work, ended)
        return await InlineWork(guarded, resources.loop)

    def _start(
        self, resources: SessionResources, work: Coroutine[Any, Any, Result]
    ) -> asyncio.Task[Result]:
        task = asyncio.create_task(self._run_guarded(resources, work))
        resources.task = task
        # Its exception is retrieved also when its caller has disconnected.
        task.add_done_callback(lambda task: task.cancelled() or task.exception())
        return task

    async def _run_guarded(
        self,
        resources: SessionResources,
        work: Awaitable[Result],
        ended: asyncio.Future[None] | None = None,
    ) -> Result:
        """Whatever fails, no session stays busy for ever.

        ended: wakes the requests that wait for the work.
        """
        try:
            return await work
        except NoCapacity as error:
            self._abort(resources)
            raise Refused("no_capacity", f"{error}.") from error
        except NoRoomToRecord as error:  # no fault, and no attempt
            self._abort(resources)
            raise Refused("unavailable", f"The server: {error}.") from error
        except (
            AttemptDiverged
        ) as error:  # CRASH-002: as if it had ended with the process
            log.warning("run %s: a session cannot go on: %s", resources.run_id, error)
            self._abort(resources)
            self._ensure_live(resources)
            raise AssertionError("the session has ended") from error
        except Refused:
            self._abort(resources)
            raise
        except Exception as error:
            log.exception("a turn of run %s failed", resources.run.run_id)
            self._abort(resources)
            raise Refused(
                "internal_error", "The turn could not be carried out."
            ) from error
        finally:
            resources.wait.end()
            if ended is not None:
                ended.set_result(None)

    def _abort(self, resources: SessionResources) -> None:
        """End a session whose work failed by no fault of its policy."""
        session = resources.session
        if session.ended_by is None:
            run = resources.run
            must_store = effects.abort_session(run, session, time.time())
            self.release_sessions([session])
            if must_store:
                self._writer.commit_later(run)
            else:
                self._registry.notify(run)

    async def _wait_for_turn(self, run: Run, session: Session) -> Run:
        """The run after the session's task has ended; the caller decides again then."""
        resources = self._resources.find(session)
        if resources is not None and resources.task is not None:
            await self._robots.await_turn(resources)
        else:
            await asyncio.sleep(0)
        return await self._registry.get(run.run_id)

    def _replay_turn(self, session: Session) -> Turn:
        """The stored turn, with the lease that it had; the session's is longer now.

        LEASE-010: a repeat is an answered request.
        """
        self._extend_lease(session)
        assert session.turn is not None, "a session that is not busy has its turn"
        return session.turn

    def _extend_lease(self, session: Session) -> None:
        now = time.monotonic()
        effects.extend_without_turn(session, now, self._heartbeat_s_max)

    def _answer(self, resources: SessionResources, turn: Turn, started: float) -> Turn:
        effects.store_answer(resources.session, turn, time.monotonic())
        turn_view.add_lease_and_total(
            turn, resources.session, time.perf_counter() - started
        )
        if resources.session.done:
            self._end_or_keep(resources.run, resources.session)
        return turn

    def _end_or_keep(self, run: Run, session: Session) -> None:
        """A session that is done is there for a client that repeats its last turn."""
        if not run.is_push:
            self._resources.let_run_go(session)
            return
        # Its worker is this server's own: it repeats nothing, and its lease is a day.
        effects.close_session(run, session, "detached", time.time())
        self.release_sessions([session])

    def _ensure_live(self, resources: SessionResources) -> None:
        """After an await: refuse if the session has ended (FAULT-006)."""
        ended_by = resources.session.ended_by
        if ended_by is not None:
            raise Refused(
                "session_ended",
                f"The session ended while its turn was executed ({ended_by}).",
                members={"ended_by": ended_by},
            )


def _begin_command(resources: SessionResources, plan: RecordingPlan | None) -> Begin:
    """The beginning of the session's episode."""
    manifest, episode = resources.run.manifest, resources.session.episode
    assert episode is not None
    return Begin(
        episode.task,
        episode.seed,
        manifest["max_steps"],
        manifest["success_rule"],
        split=episode.split,
        recording=plan,
        is_sealed=episode.is_sealed,
    )


def _name_session(spent: Span, resources: SessionResources) -> None:
    """Whose time it is: a request shows its run alone, and a push run has none."""
    if spent.is_recorded:
        session = resources.session
        spent.set("proctor.run_id", resources.run_id)
        spent.set("proctor.worker_id", session.worker_id)
        spent.set("proctor.session", session_name(session.session_id))
        spent.set("proctor.seq", session.seq)
        if session.episode is not None:
            spent.set("proctor.episode_id", session.episode.episode_id)


def _add_times(spent: Span, timing: Timing, steps: int = 0) -> None:
    """Add the times of the simulator's process; the rest of the span is transport."""
    if spent.is_recorded:
        spent.set("proctor.steps", steps)
        spent.set("proctor.simulate_s", timing.simulate_s)
        spent.set("proctor.render_s", timing.render_s)
        spent.set("proctor.encode_s", timing.encode_s)
