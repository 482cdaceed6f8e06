"""Where sessions are played: the data plane's hands.

It asks `protocol` what may happen, lets a simulator process execute, and tells
`progress` what came of it. While a simulator executes nothing is locked: each session
has one task at most, and whoever repeats its request waits for that task.
"""

from __future__ import annotations

import asyncio
import logging
import secrets
import time
from collections.abc import Awaitable
from dataclasses import dataclass
from typing import Any

from reference_server import progress, turns
from reference_server.problems import Refused
from reference_server.protocol import (
    Attach,
    Detach,
    Heartbeat,
    Nothing,
    Predict,
    Refuse,
    Replay,
    Wait,
    decide,
    lease_over,
)
from reference_server.run_book import RunBook
from reference_server.run_state import Run, Session
from reference_sim.catalog import resolve
from reference_sim.runners.local import (
    Beginning,
    NoCapacity,
    SimulatorFault,
    SimulatorHandle,
    SimulatorPool,
    TaskUnplayable,
)

log = logging.getLogger("proctor.stage")


@dataclass(slots=True, eq=False)
class Scene:
    """What a session needs besides its state; keeps its run in memory."""

    run: Run
    handle: SimulatorHandle | None = None
    task: asyncio.Task[dict[str, Any]] | None = None
    timer: asyncio.TimerHandle | None = None
    fault: dict[str, Any] | None = None


class Stage:
    """Every session of this process."""

    def __init__(self, book: RunBook, pool: SimulatorPool, max_chunk: int) -> None:
        self._book = book
        self._pool = pool
        self._max_chunk = max_chunk
        self._scenes: dict[Session, Scene] = {}
        book.forget = self._forget

    # --- operations of the data plane ---

    async def attach(self, run: Run, command: Attach) -> dict[str, Any]:
        """The session's latest turn; turn 0 for a new session."""
        while True:
            verdict = decide(run, command, self.sweep(run))
            match verdict:
                case Refuse():
                    raise Refused.by(verdict)
                case Wait(session):
                    run = await self._after(run, session)
                case Replay(session):
                    return self._again(session)
                case _:
                    break
        old = run.workers.get(command.worker_id)
        session_id = secrets.token_urlsafe(24)  # ATT-009
        session = progress.open_session(run, command, session_id, time.monotonic())
        scene = Scene(run)
        if old is not None:
            before = self._leave(old)
            if before is not None:
                scene.handle = before.handle
        self._scenes[session] = scene
        self._watch(session)
        self._book.notify(run)
        return await self._execute(session, self._open(run, session))

    async def predict(self, run: Run, command: Predict) -> dict[str, Any]:
        """The turn; executed once, however often it is asked for."""
        while True:
            verdict = decide(run, command, self.sweep(run))
            match verdict:
                case Refuse():
                    raise Refused.by(verdict)
                case Wait(session):
                    run = await self._after(run, session)
                case Replay(session):
                    return self._again(session)
                case _:
                    break
        session = run.workers[command.worker_id]
        progress.begin_turn(session, command, time.monotonic())
        return await self._execute(session, self._play(run, session, command))

    def heartbeat(self, run: Run, command: Heartbeat) -> Session:
        """Extends the lease; returns the session."""
        verdict = decide(run, command, self.sweep(run))
        if isinstance(verdict, Refuse):
            raise Refused.by(verdict)
        session = run.workers[command.worker_id]
        progress.touch(session, time.monotonic())
        return session

    async def detach(self, run: Run, command: Detach) -> None:
        verdict = decide(run, command, self.sweep(run))
        if isinstance(verdict, Refuse):
            raise Refused.by(verdict)
        if isinstance(verdict, Nothing):
            return
        session = run.workers[command.worker_id]
        progress.close_session(run, session, "detached", time.time())
        self.let_go([session])
        await self._book.commit(run)

    # --- what the control plane and the clock do to sessions ---

    def sweep(self, run: Run) -> float:
        """End the sessions whose lease is over; returns the moment that decided it."""
        now = time.monotonic()
        over = [s for s in run.workers.values() if lease_over(s, now)]
        live = progress.expire(run, now, time.time())
        self.let_go(over)
        if live:
            self._book.commit_later(run)
        return now

    def let_go(self, sessions: list[Session]) -> None:
        """Free what ended sessions hold; a simulator in execution is killed."""
        for session in sessions:
            scene = self._leave(session)
            if scene is not None and scene.handle is not None:
                self._free(scene.handle, kill=session.busy is not None)

    async def close(self) -> None:
        """End every session without counting anything."""
        self.let_go(list(self._scenes))

    # --- playing ---

    async def _open(self, run: Run, session: Session) -> dict[str, Any]:
        started = time.perf_counter()
        self._still(session)  # a stop may come before its work begins
        scene = self._scenes[session]
        if session.done:
            turn = turns.turn(session, observation=None)
        elif scene.handle is not None:
            try:
                observation = await scene.handle.observe()
            except SimulatorFault as error:  # it died between two turns
                await self._fault(run, session, error)
                return await self._begin_turn_anew(run, session, started)
            turn = turns.turn(session, observation=observation)
        else:
            beginning, queue_s = await self._begin(run, session)
            turn = turns.turn(
                session,
                observation=beginning.observation,
                fault=scene.fault,
                spent=turns.timing(queue_s, beginning.timing),
            )
        self._still(session)
        return self._answer(session, turn, started)

    async def _play(
        self, run: Run, session: Session, command: Predict
    ) -> dict[str, Any]:
        started = time.perf_counter()
        self._still(session)  # a stop may come before its work begins
        scene = self._scenes[session]
        assert scene.handle is not None, "a session with an episode has a simulator"
        scene.fault = None
        actions = progress.clipped(command.actions, run.manifest)
        try:
            played = await scene.handle.play(
                actions, observe_all=command.observe == "all"
            )
        except (SimulatorFault, TaskUnplayable) as error:
            await self._fault(run, session, error)
            return await self._begin_turn_anew(run, session, started)
        self._still(session)
        outcome = progress.Outcome(
            played.executed,
            played.ended,
            played.terminated,
            played.truncated,
            played.success,
            played.score,
        )
        ended = progress.end_turn(run, session, outcome, time.time())
        observation, spent = played.observation, turns.timing(0.0, played.timing)
        if ended is not None:
            # The result is on disk before anybody hears of it.
            await self._book.commit(run)
            self._still(session)
            observation = None
            if session.episode is not None:
                beginning, queue_s = await self._begin(run, session)
                observation = beginning.observation
                spent = turns.timing(queue_s, played.timing, beginning.timing)
            else:
                self._release(session)
        self._still(session)
        turn = turns.turn(
            session,
            observation=observation,
            observations=played.observations if command.observe == "all" else None,
            played=played,
            left=len(actions) - played.executed,
            ended=ended,
            fault=scene.fault,
            spent=spent,
        )
        return self._answer(session, turn, started)

    async def _begin_turn_anew(
        self, run: Run, session: Session, started: float
    ) -> dict[str, Any]:
        """FAULT-001: the same episode and attempt again, at step 0."""
        beginning, queue_s = await self._begin(run, session)
        turn = turns.turn(
            session,
            observation=beginning.observation,
            fault=self._scenes[session].fault,
            spent=turns.timing(queue_s, beginning.timing),
        )
        return self._answer(session, turn, started)

    async def _begin(self, run: Run, session: Session) -> tuple[Beginning, float]:
        """Begin the session's episode, anew after each fault, until it fails the run.

        Returns the beginning and the seconds spent waiting for a simulator.
        """
        scene = self._scenes[session]
        queue_s = 0.0
        while True:
            episode = session.episode
            assert episode is not None
            try:
                if scene.handle is None:
                    waited = time.perf_counter()
                    handle = await self._pool.acquire(world_of(run, self._max_chunk))
                    queue_s += time.perf_counter() - waited
                    if session.ended_by is not None:
                        self._free(handle, kill=False)
                        self._still(session)
                    scene.handle = handle
                beginning = await scene.handle.begin(
                    episode.task,
                    episode.seed,
                    split=episode.split,
                    max_steps=run.manifest["max_steps"],
                    success_rule=run.manifest["success_rule"],
                )
            except (SimulatorFault, TaskUnplayable) as error:
                await self._fault(run, session, error)
                continue
            self._still(session)
            session.instruction = beginning.instruction
            return beginning, queue_s

    async def _fault(self, run: Run, session: Session, error: Exception) -> None:
        """Record a fault; returns when the episode may begin again."""
        self._still(session)
        scene = self._scenes[session]
        if scene.handle is not None:
            self._free(scene.handle, kill=True)
            scene.handle = None
        episode = session.episode
        assert episode is not None
        log.warning("run %s, %s: %s", run.run_id, episode.episode_id, error)
        session.busy = "turning"
        ended = progress.fault(
            run,
            session,
            str(error),
            unplayable=isinstance(error, TaskUnplayable),
            now_wall=time.time(),
        )
        self.let_go(ended)
        await self._book.commit(run)
        self._still(session)
        scene.fault = {
            "episode_id": episode.episode_id,
            "faults": episode.faults,
            "detail": str(error),
        }

    # --- sessions and their simulators ---

    async def _execute(
        self, session: Session, work: Awaitable[dict[str, Any]]
    ) -> dict[str, Any]:
        """Run a session's work as its one task, which outlives a caller that leaves."""
        scene = self._scenes[session]
        scene.task = asyncio.ensure_future(self._guarded(scene, session, work))
        return await asyncio.shield(scene.task)

    async def _guarded(
        self, scene: Scene, session: Session, work: Awaitable[dict[str, Any]]
    ) -> dict[str, Any]:
        """Whatever goes wrong, no session stays busy for ever."""
        try:
            return await work
        except NoCapacity as error:
            self._abort(scene.run, session)
            raise Refused("no_capacity", str(error)) from error
        except Refused:
            self._abort(scene.run, session)
            raise
        except Exception as error:
            log.exception("a turn of run %s failed", scene.run.run_id)
            self._abort(scene.run, session)
            raise Refused(
                "internal_error", "The turn could not be carried out."
            ) from error

    def _abort(self, run: Run, session: Session) -> None:
        """End a session by no fault of its policy: no attempt is counted."""
        if session.ended_by is None:
            session.busy, session.steps = "turning", 0
            progress.close_session(run, session, "unknown", time.time())
            self.let_go([session])
            self._book.commit_later(run)

    async def _after(self, run: Run, session: Session) -> Run:
        """The run when the session's task is over; the caller decides again then."""
        scene = self._scenes.get(session)
        if scene is not None and scene.task is not None:
            await asyncio.wait([scene.task])
        else:
            await asyncio.sleep(0)
        return await self._book.get(run.run_id)

    def _again(self, session: Session) -> dict[str, Any]:
        progress.touch(session, time.monotonic())
        assert session.turn is not None, "a session that is not busy has its turn"
        return session.turn

    def _answer(
        self, session: Session, turn: dict[str, Any], started: float
    ) -> dict[str, Any]:
        now = time.monotonic()
        progress.answer(session, turn, now)
        turns.finish(turn, session, time.perf_counter() - started)
        self._book.notify(self._scenes[session].run)
        return turn

    def _still(self, session: Session) -> None:
        """After an await: is the session still the one to answer?"""
        if session.ended_by is not None:
            raise Refused(
                "session_ended",
                f"The session ended while its turn was executed ({session.ended_by}).",
                members={"ended_by": session.ended_by},
            )

    def _watch(self, session: Session) -> None:
        """Look at the lease when it could be over; one timer per session."""
        scene = self._scenes.get(session)
        if scene is None:
            return
        now = time.monotonic()
        if lease_over(session, now):
            self.sweep(scene.run)
            return
        wait_s = session.expires_at - now
        if wait_s <= 0:  # busy beyond its lease, or at its very end
            wait_s = 0.05
        loop = asyncio.get_running_loop()
        scene.timer = loop.call_later(wait_s + 0.001, self._watch, session)

    def _leave(self, session: Session) -> Scene | None:
        scene = self._scenes.pop(session, None)
        if scene is not None and scene.timer is not None:
            scene.timer.cancel()
        return scene

    def _release(self, session: Session) -> None:
        """The session is done: its simulator serves others, its last turn stays."""
        scene = self._scenes[session]
        if scene.handle is not None:
            self._free(scene.handle, kill=False)
            scene.handle = None

    def _free(self, handle: SimulatorHandle, *, kill: bool) -> None:
        if kill:
            handle.discard()
        else:
            self._book.begin(handle.release())

    def _forget(self, run: Run) -> None:
        sessions = [s for s, scene in self._scenes.items() if scene.run is run]
        for session in sessions:
            run.remember_end(session, "unknown")
        self.let_go(sessions)


def world_of(run: Run, max_chunk: int) -> Any:
    """What a simulator process needs to build this run's simulator."""
    submission = run.submission
    return resolve(
        submission["benchmark_id"],
        submission.get("options"),
        run.images,
        max_chunk=max_chunk,
    ).world
