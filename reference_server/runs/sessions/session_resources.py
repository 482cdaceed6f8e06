"""The resources that sessions hold: a simulator, a task and a lease timer.

This module lends simulators to sessions and takes them back, and calls back when a
lease could be over. It decides no rule and executes no turn: `session_executor.py`
does.
"""

from __future__ import annotations

import asyncio
import contextvars
import time
import weakref
from collections.abc import Awaitable, Callable, Iterable
from dataclasses import dataclass, field
from typing import Any

import msgspec

from reference_record.generated.answers import Fault
from reference_server.cells.cell_trial import CellTrial
from reference_server.cells.robot_cell import cell_of
from reference_server.failover.kept_sessions import EndedBefore, KeptSession
from reference_server.files.seed_secret import SeedSecret
from reference_server.records.recordings import Recordings
from reference_server.rules.capacity import LentSimulator, held_unused, session_to_end
from reference_server.rules.refusal import Refused
from reference_server.rules.runs.lifecycle import lease_over
from reference_server.rules.runs.run import Run, Session
from reference_server.runs.benchmarks import SimulatorConfigs
from reference_server.runs.memory.ended_sessions import EndedSessions
from reference_server.runs.run_log import log_left
from reference_server.telemetry.slow_waits import LongWait, WaitLog
from reference_server.telemetry.spans import span
from reference_sim.benchmark_registry import SimulatorConfig
from reference_sim.process.pool import NoCapacity, SimulatorHandle, SimulatorPool

# How often sessions that are done are looked at, all of them by one timer, and how
# many of them are packed then: others are served meanwhile.
DONE_LOOK_S = 1.0
PACKED_AT_ONCE = 100


@dataclass(slots=True, eq=False)
class SessionResources:
    """Resources of one session; its run stays in memory until the session is done.

    held_run: the run, until then. handle: its simulator, while it plays an episode.
    acquiring: it is about to get one. task: is done when the work in execution is.
    fault: what broke in the turn in execution, schema Fault. think_s: of the policy,
    before the turn in execution. wait: what the work in execution waits for.
    ended: what the turn in execution shows of the episode that it has ended. kept: what
    a restart finds.
    recorded: index and attempt of what it plays, if that is recorded. packed: the last
    turn and its request, while the run is not in memory. trial: of what a robot plays.
    heard_at: when a request was last waiting for the work in execution.
    """

    run_id: str
    session: Session
    held_run: Run | None
    known_run: weakref.ref[Run]
    handle: SimulatorHandle | None = None
    acquiring: bool = False
    task: asyncio.Future[Any] | None = None
    timer: asyncio.TimerHandle | None = None
    fault: Fault | None = None
    ended: EndedBefore | None = None
    kept: KeptSession | None = None
    think_s: float = 0.0
    wait: LongWait = field(init=False)
    recorded: tuple[int, int] | None = None
    packed: bytes | None = None
    trial: CellTrial | None = None
    heard_at: float = 0.0
    loop: asyncio.AbstractEventLoop = field(default_factory=asyncio.get_running_loop)

    def __post_init__(self) -> None:
        self.wait = LongWait(self.run_id, self.session.worker_id)

    @property
    def run(self) -> Run:
        """The run of a session that is not done, or only just."""
        run = self.run_in_memory
        assert run is not None, "a session that plays keeps its run in memory"
        return run

    @property
    def run_in_memory(self) -> Run | None:
        """None once nothing else uses the run of a session that is done."""
        return self.held_run or self.known_run()

    def ensure_live(self) -> None:
        """Refuse after an await, if the session has ended meanwhile (FAULT-006)."""
        ended_by = self.session.ended_by
        if ended_by is not None:
            raise Refused(
                "session_ended",
                f"The session ended while its turn was executed ({ended_by}).",
                members={"ended_by": ended_by},
            )

    def pack(self) -> bool:
        """Keep a fifth of the bytes; nothing reads the session without its run.

        Not of a turn with pictures, nor of what would not be the same again. Returns
        whether that was tried, which takes time.
        """
        session = self.session
        if session.turn is None or "observations" in session.turn:
            return False
        try:
            packed = msgspec.msgpack.encode((session.turn, session.request))
        except (TypeError, ValueError, OverflowError, msgspec.MsgspecError):
            return True
        if _unpack(packed) == (session.turn, session.request):
            self.packed, session.turn, session.request = packed, None, None
        return True

    def unpack(self) -> None:
        if self.packed is not None:
            self.session.turn, self.session.request = _unpack(self.packed)
            self.packed = None


def _unpack(packed: bytes) -> tuple[Any, Any]:
    """A turn and its request, as `Session` has them."""
    turn, request = msgspec.msgpack.decode(packed)
    return turn, None if request is None else tuple(request)


class ResourceManager:
    """The resources of every session that has not ended.

    run_in_background: starts work that no request waits for.
    on_lease_over: is called with the run of a session whose lease is over.
    on_unused: is called with a session that has to end for another account.
    unused_s: how long it may be without a turn while that one waits.
    ended_sessions: is informed why each one ended.
    recordings: where episodes are recorded; None records nothing.
    """

    def __init__(
        self,
        pool: SimulatorPool,
        seed_secret: SeedSecret,
        run_in_background: Callable[[Awaitable[None]], object],
        on_lease_over: Callable[[Run], object],
        on_unused: Callable[[SessionResources], object],
        *,
        unused_s: float,
        ended_sessions: EndedSessions,
        recordings: Recordings | None = None,
    ) -> None:
        self._ended_sessions = ended_sessions
        self._recordings = recordings
        self._pool = pool
        self._run_in_background = run_in_background
        self._on_lease_over, self._on_unused = on_lease_over, on_unused
        self._unused_s = unused_s
        self._by_session: dict[Session, SessionResources] = {}
        # Resources of sessions that are done, by the id of their run.
        self._done: dict[str, list[SessionResources]] = {}
        self._done_timer: asyncio.TimerHandle | None = None
        self.configs = SimulatorConfigs(seed_secret)
        self._wait_log = WaitLog(self._waits)

    def _waits(self) -> list[LongWait]:
        return [resources.wait for resources in self._by_session.values()]

    def __len__(self) -> int:
        return len(self._by_session)

    def count_busy(self) -> int:
        """Sessions whose turn is in execution."""
        return sum(session.busy is not None for session in self._by_session)

    def find(self, session: Session) -> SessionResources | None:
        return self._by_session.get(session)

    def open(
        self, run: Run, session: Session, before: Session | None
    ) -> SessionResources:
        """The resources of a new session, with the simulator of the one before."""
        resources = SessionResources(run.run_id, session, run, weakref.ref(run))
        left = None if before is None else self._remove(before)
        if left is not None:
            resources.handle, resources.recorded = left.handle, left.recorded
        self._by_session[session] = resources
        self._schedule_lease_check(resources)
        self._wait_log.start()
        return resources

    def let_run_go(self, session: Session) -> None:
        """The session is done: only its last turn may be requested again.

        Its lease goes on, for minutes, in which a client can end a thousand runs. So
        it keeps none of them in memory; `restore_done` is for one that comes back.
        """
        resources = self._by_session.get(session)
        if resources is not None:
            self._forget(resources)
            _cancel(resources.timer)
            resources.held_run = resources.task = resources.timer = None
            self._done.setdefault(resources.run_id, []).append(resources)
            self._look_at_done_later()

    def restore_done(self, run: Run) -> None:
        """Give a run that was loaded again its sessions that are done."""
        for resources in self._done.get(run.run_id, ()):
            if resources.known_run() is not run:
                resources.known_run = weakref.ref(run)
                resources.unpack()
                run.workers[resources.session.worker_id] = resources.session

    def _look_at_done_later(self) -> None:
        if self._done_timer is None:
            self._done_timer = asyncio.get_running_loop().call_later(
                DONE_LOOK_S, self._look_at_done, context=contextvars.Context()
            )

    def _look_at_done(self) -> None:
        """End leases, which hold nothing that another request could wait for."""
        self._done_timer = None
        now, left = time.monotonic(), PACKED_AT_ONCE
        for resources in [done for of_run in self._done.values() for done in of_run]:
            if lease_over(resources.session, now):
                self._end_lease(resources)
            elif left and resources.run_in_memory is None:
                left -= resources.pack()
        if self._done:
            self._look_at_done_later()

    def _end_lease(self, resources: SessionResources) -> None:
        run = resources.run_in_memory
        if run is not None:
            self._on_lease_over(run)
        elif resources.session.ended_by is None:  # nothing else of it is to be ended
            resources.session.ended_by = "lease_ended"
            self.release_sessions([resources.session])

    def release_sessions(
        self,
        sessions: Iterable[Session],
        *,
        may_go_on: bool = False,
        cause: str | None = None,
    ) -> None:
        """Free what ended sessions hold; a simulator in execution is killed.

        may_go_on: they have ended here alone, and another process may restore them.
        cause: for the log, where they ended by no act of a client and no lease.
        """
        for session in sessions:
            resources = self._remove(session)
            if resources is not None:
                if resources.trial is not None:  # a robot is stopped before all else
                    resources.trial.leave(session.ended_by or "unknown")
                self._ended_sessions.note(resources.run_id, session)
                if not (may_go_on and self._keeps_sessions):
                    self._forget(resources)
                    self._record_end(resources)
                log_left(resources.run_id, session, cause)
                self.return_simulator(resources, kill=session.busy is not None)

    @property
    def _keeps_sessions(self) -> bool:
        """Whether a restart finds sessions, and goes on with their attempts."""
        return self._recordings is not None and self._recordings.sessions is not None

    def _forget(self, resources: SessionResources) -> None:
        """No restart finds the session any more."""
        kept = None if self._recordings is None else self._recordings.sessions
        run = resources.run_in_memory
        if kept is not None and run is not None:
            kept.remove(run, resources.session.worker_id)

    def _record_end(self, resources: SessionResources) -> None:
        """The attempt in play is over without a score."""
        if self._recordings is not None and resources.recorded is not None:
            index, attempt = resources.recorded
            reason = resources.session.ended_by or "unknown"
            self._recordings.end_attempt(resources.run, index, attempt, reason)

    def discard_sessions(
        self, run: Run | None = None, *, may_go_on: bool = True, cause: str
    ) -> None:
        """End the sessions of a run, or all, without counting anything.

        may_go_on, cause: as for `release_sessions`.
        """
        sessions = [
            session
            for session, resources in self._by_session.items()
            if run is None or resources.run_in_memory is run
        ]
        for session in sessions:
            of_run = self._by_session[session].run_in_memory
            if of_run is not None:
                of_run.record_end(session, "unknown")
        self.release_sessions(sessions, may_go_on=may_go_on, cause=cause)
        if not self._by_session:
            self._wait_log.stop()

    async def acquire_simulator(self, resources: SessionResources) -> float:
        """Lend the session a simulator for its run, unless it has one.

        Returns the seconds that this took. Its session may have ended meanwhile; then
        it has none. Raises Refused, NoCapacity, SimulatorFault and TaskUnplayable.
        """
        if resources.handle is not None:
            return 0.0
        started = time.perf_counter()
        config = self.configs.find(resources.run)
        if resources.trial is not None:
            config = cell_of(resources.trial).simulator_config(config)
        if self._pool.is_full_for(config):
            self._take_from_others(resources, config)
        resources.acquiring = True
        resources.wait.begin("a simulator, which is started")
        try:
            with span("wait for simulator"):
                resources.handle = await self._pool.acquire(config)
        except NoCapacity as error:
            if not (held := self._held_unused(resources.run.account)):
                raise
            members = {"limit": "at_once"}
            text = f"{error}{held}."
            raise Refused("no_capacity", text, members=members) from error
        finally:
            resources.acquiring = False
        if resources.session.ended_by is not None:
            self.return_simulator(resources, kill=False)
        return time.perf_counter() - started

    def _take_from_others(
        self, resources: SessionResources, config: SimulatorConfig
    ) -> None:
        """LIM-005: end a session of another account that does not use its own."""
        lent = [
            LentSimulator(holder.run.account, holder.session)
            for holder in self._by_session.values()
            if (holder.handle is not None or holder.acquiring)
            and self._pool.makes_room(self.configs.find(holder.run), config)
        ]
        waiting, now = resources.run.account, time.monotonic()
        unused = session_to_end(lent, waiting, now, self._unused_s)
        if unused is not None:
            self._on_unused(self._by_session[unused])

    def _held_unused(self, account: str) -> str:
        held = [
            (holder.run_id, session)
            for session, holder in self._by_session.items()
            if holder.handle is not None and holder.run.account == account
        ]
        return held_unused(held, time.monotonic(), self._unused_s)

    def return_simulator(self, resources: SessionResources, *, kill: bool) -> None:
        """Take back the simulator, if there is one: for others, or to end it."""
        handle, resources.handle = resources.handle, None
        if handle is None:
            return
        if kill:
            handle.discard()
        else:
            self._run_in_background(handle.release())

    def _remove(self, session: Session) -> SessionResources | None:
        resources = self._by_session.pop(session, None)
        if resources is not None:
            _cancel(resources.timer)
            self._remove_done(resources)
        return resources

    def _remove_done(self, resources: SessionResources) -> None:
        done = self._done.get(resources.run_id, [])
        if resources in done:
            done.remove(resources)
            if not done:
                del self._done[resources.run_id]
        if not self._done:
            _cancel(self._done_timer)
            self._done_timer = None

    def _schedule_lease_check(self, resources: SessionResources) -> None:
        """Check the lease when it could be over (LEASE-001); one timer per session.

        LEASE-011: no request is needed for that.
        """
        now = time.monotonic()
        if lease_over(resources.session, now):
            self._on_lease_over(resources.run)
            return
        wait_s = resources.session.expires_at - now
        if wait_s <= 0:  # busy beyond its lease, or at its very end
            wait_s = 0.05
        loop = asyncio.get_running_loop()
        resources.timer = loop.call_later(
            wait_s + 0.001,
            self._schedule_lease_check,
            resources,
            context=contextvars.Context(),  # it belongs to no request
        )


def _cancel(timer: asyncio.TimerHandle | None) -> None:
    if timer is not None:
        timer.cancel()
