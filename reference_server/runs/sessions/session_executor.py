"""The operations of the data plane, carried out: attach, predict, heartbeat, detach.

`rules/runs/lifecycle.py` decides whether a command is accepted, a simulator process
executes it, and `rules/runs/effects.py` changes the run. `session_work.py` runs what a
session does, `episode_beginnings.py` begins its episodes, also after a fault,
`attempt_recorder.py` writes its files, and `session_resources.py` has its simulator,
task and timer. This module knows no HTTP and no SQL.

While work awaits anything, its session may end: then `ensure_live` ends the work, and
the resources of the session are already freed.
"""

from __future__ import annotations

import asyncio
import secrets
import time
from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import partial
from weakref import WeakKeyDictionary

from reference_record.generated.answers import Turn
from reference_server.cells.act_log import ActLog
from reference_server.cells.cell_trial import TrialLeft, TrialVoid
from reference_server.cells.cells import Cells
from reference_server.cells.robot_attempts import RobotAttempts
from reference_server.failover.kept_sessions import ended_before
from reference_server.failover.session_recovery import FoundSession, find_sessions
from reference_server.files.seed_secret import SeedSecret
from reference_server.process.background_work import shielded
from reference_server.records.recordings import Recordings
from reference_server.rules.refusal import Refused
from reference_server.rules.runs import action_space, effects
from reference_server.rules.runs.lifecycle import (
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
from reference_server.rules.runs.run import Run, RunHead, Session, SessionEnd, State
from reference_server.runs.admission.disk_bound import DiskBound
from reference_server.runs.memory.run_events import Departure, RunFollower
from reference_server.runs.registry import RunRegistry
from reference_server.runs.run_log import log_attached, log_restored
from reference_server.runs.sessions.attempt_recorder import AttemptRecorder
from reference_server.runs.sessions.episode_beginnings import (
    FAULTS,
    EpisodeBeginnings,
    begin_command,
)
from reference_server.runs.sessions.session_resources import (
    ResourceManager,
    SessionResources,
)
from reference_server.runs.sessions.session_spans import add_times, name_session
from reference_server.runs.sessions.session_work import SessionWork
from reference_server.telemetry.counters import COUNTERS
from reference_server.telemetry.spans import span
from reference_server.views import turn_view
from reference_sim.process.pool import (
    Begin,
    ChunkReply,
    SimulatorFault,
    SimulatorPool,
)

# Why a run left memory → the cause of the end of its sessions.
CAUSES: Mapping[Departure, str] = {
    "moved": "another node has the run",
    "unstored": "the run could not be stored",
    "refused": "the run may not be opened again",
}


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
        self._recordings = recordings
        self._registry, self._writer = registry, registry.writer
        self._robots = RobotAttempts(cells or Cells(ActLog(None)))
        self._admission = registry.admission
        self._heartbeat_s_max = heartbeat_s_max
        self._resources = ResourceManager(
            pool,
            seed_secret,
            registry.work.start,
            self.sweep,
            self._end_unused,
            unused_s=unused_s,
            ended_sessions=registry.ended_sessions,
            recordings=recordings,
        )
        self._recorder = AttemptRecorder(recordings)
        self._work = SessionWork(registry, self._resources, self._robots)
        self._beginnings = EpisodeBeginnings(
            registry.writer,
            self._resources,
            self._robots,
            self._recorder,
            disk_bound or DiskBound(),
        )
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
        return await self._work.execute(resources, self._open(resources))

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
        return await self._work.execute(resources, self._play(resources, command))

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
            await shielded(self._finish_judged(resources, "detached"))
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
                case Refuse(code="worker_busy"):
                    session = run.workers[command.worker_id]
                    raise Refused.from_verdict(_with_end_of_lease(verdict, session))
                case Refuse():
                    raise Refused.from_verdict(verdict)
                case Wait(session):
                    run = await self._work.wait_for_end(run, session)
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
        return self._work.start(
            resources, self._play_last(resources, command, ended_by)
        )

    async def _play_last(
        self, resources: SessionResources, command: Predict, ended_by: SessionEnd
    ) -> None:
        """A turn of no action, which no request asks for, and the session's end."""
        run, session = resources.run, resources.session
        played = await self._execute_chunk(resources, command, (), None)
        now_wall = time.time()
        resources.ensure_live()
        await self._recorder.finish(resources, played, now_wall, 0)
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
        if resources is not None:
            self._recorder.add_policy_fault(resources, fault)

    def _end_unused(self, resources: SessionResources) -> None:
        """LIM-005: its simulator is for a session of another account."""
        self._work.abort(resources, "another account needs its simulator")

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
            may_go_on, cause = why == "moved", CAUSES[why]
            self._resources.discard_sessions(run, may_go_on=may_go_on, cause=cause)

    async def close(self) -> None:
        """End every session without counting anything."""
        self._resources.discard_sessions(cause="the server ends")

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
        self._work.start(resources, work)

    async def _open_again(
        self, resources: SessionResources, found: FoundSession
    ) -> Turn:
        """The turn with which the session got its episode, as it was answered."""
        started = time.perf_counter()
        resources.ensure_live()
        if found.attempt.attempt is None:
            beginning, queue_s = await self._beginnings.begin(resources)
        else:
            queue_s, begin = await self._prepare_again(resources, found)
            assert resources.handle is not None
            beginning = await resources.handle.resume(begin, found.attempt)
            resources.ensure_live()
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
        resources.ensure_live()
        plan = await self._recorder.begin(resources, found)
        resources.wait.begin("the simulator, which plays the attempt again")
        return queue_s, begin_command(resources, plan)

    # --- playing ---

    async def _open(self, resources: SessionResources) -> Turn:
        started = time.perf_counter()
        resources.ensure_live()  # a stop may come before its work begins
        if resources.session.done:
            turn = turn_view.turn_view(resources.session, observation=None)
            return self._answer(resources, turn, started)
        if resources.handle is None:
            return await self._begin_turn(resources, started)
        try:
            with span("simulator observes") as observed:
                resources.wait.begin("the simulator, which observes")
                name_session(observed, resources)
                observation = await resources.handle.observe()
        except SimulatorFault as error:  # it died between two turns
            await self._beginnings.record_fault(resources, error)
            return await self._begin_turn(resources, started)
        await self._recorder.keep(resources)
        resources.ensure_live()
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
        resources.ensure_live()  # a stop may come before its work begins
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
                resources.ensure_live()
                await self._recorder.finish(resources, played, now_wall, clipped)
                await self._recorder.keep_ending(resources, played, len(actions))
        except (TrialVoid, TrialLeft) as over:
            await self._ensure_stored_as_played(run)
            await self._beginnings.void(resources, over)
            return await self._begin_turn(resources, started)
        except FAULTS as error:
            await self._ensure_stored_as_played(run)  # else it took the simulator away
            await self._beginnings.record_fault(resources, error)
            return await self._begin_turn(resources, started)
        if run.played_number is None:
            await self._ensure_stored_as_played(run)
        resources.ensure_live()
        ended = effects.end_turn(run, session, played, now_wall, clipped)
        observation, spent = played.observation, turn_view.timing(0.0, played.timing)
        if ended is not None:
            # The result is on disk before any response shows it (CRASH-001).
            resources.wait.begin("the database, which stores a result")
            await self._writer.commit(run)
            resources.ensure_live()
            observation = None
            if session.episode is not None:
                resources.ended = ended_before(played, len(actions), ended.index)
                if self._robots.plays(run):  # another run may have the robot next
                    self._resources.return_simulator(resources, kill=False)
                beginning, queue_s = await self._beginnings.begin(resources)
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
            name_session(playing, resources)
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
            add_times(playing, played.timing, played.executed)
        return played

    async def _ensure_stored_as_played(self, run: Run) -> None:
        """DEL-006: stored while the first turn was played, before it is answered."""
        if run.played_number is None and not await self._writer.is_stored(run):
            raise Refused("unavailable", "The run could not be stored.")

    async def _begin_turn(self, resources: SessionResources, started: float) -> Turn:
        """The turn that shows step 0, at first and after a fault (FAULT-001).

        FAULT-012: it shows nothing of the chunk in which the simulator broke.
        """
        beginning, queue_s = await self._beginnings.begin(resources)
        turn = turn_view.turn_view(
            resources.session,
            observation=beginning.observation,
            fault=resources.fault,
            spent=turn_view.timing(queue_s, beginning.timing),
        )
        return self._answer(resources, turn, started)

    # --- answers ---

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


def _with_end_of_lease(refused: Refuse, session: Session) -> Refuse:
    """The refusal of a worker that has a session, with the time until which it does."""
    if session.busy or session.held:  # the lease does not run
        return refused
    until = turn_view.lease_view(session)["expires_at"][11:19]
    more = f"Its lease ends at {until} UTC, unless it is used before."
    return replace(refused, detail=f"{refused.detail} {more}")
