"""Where sessions are played: the data plane's hands.

It asks `protocol` what may happen, lets a simulator process execute, and tells
`progress` what came of it. While a simulator executes nothing is locked: each session
has one task at most, and whoever repeats its request waits for that task. What a
session holds meanwhile is in `scenes.py`.

While work awaits anything, its session may end: then `_still` ends the work, and what
the session held is already freed.
"""

from __future__ import annotations

import asyncio
import logging
import secrets
import time
from collections.abc import Awaitable
from typing import Any

from reference_server.http import turn_view
from reference_server.http.problems import Refused
from reference_server.rules import action_space, effects
from reference_server.rules.lifecycle import (
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
from reference_server.rules.run import Run, Session
from reference_server.runs.registry import RunBook
from reference_server.runs.session_resources import Scene, Scenes
from reference_sim.process.pool import (
    Beginning,
    NoCapacity,
    SimulatorFault,
    SimulatorPool,
    TaskUnplayable,
)

log = logging.getLogger("proctor.stage")


class Stage:
    """Every session of this process."""

    def __init__(self, book: RunBook, pool: SimulatorPool) -> None:
        self._book = book
        self._scenes = Scenes(pool, book.begin, self.sweep)
        book.forget = self._scenes.forget

    # --- operations of the data plane ---

    async def attach(self, run: Run, command: Attach) -> dict[str, Any]:
        """The session's latest turn; turn 0 for a new session."""
        run, again = await self._decided(run, command)
        if again is not None:
            return again
        old = run.workers.get(command.worker_id)
        session_id = secrets.token_urlsafe(24)  # ATT-009
        session = effects.open_session(run, command, session_id, time.monotonic())
        scene = self._scenes.open(run, session, old)
        self._book.notify(run)
        return await self._execute(scene, self._open(scene))

    async def predict(self, run: Run, command: Predict) -> dict[str, Any]:
        """The turn; executed once, however often it is asked for."""
        run, again = await self._decided(run, command)
        if again is not None:
            return again
        session = run.workers[command.worker_id]
        scene = self._scenes.of(session)
        assert scene is not None, "a session that has not ended has its scene"
        effects.begin_turn(session, command, time.monotonic())
        return await self._execute(scene, self._play(scene, command))

    def heartbeat(self, run: Run, command: Heartbeat) -> Session:
        """Extends the lease; returns the session."""
        verdict = decide(run, command, self.sweep(run))
        if isinstance(verdict, Refuse):
            raise Refused.by(verdict)
        session = run.workers[command.worker_id]
        effects.touch(session, time.monotonic())
        return session

    async def detach(self, run: Run, command: Detach) -> None:
        verdict = decide(run, command, self.sweep(run))
        if isinstance(verdict, Refuse):
            raise Refused.by(verdict)
        if isinstance(verdict, Nothing):
            return
        session = run.workers[command.worker_id]
        was_live = not session.done
        effects.close_session(run, session, "detached", time.time())
        self.let_go([session])
        if was_live or run.changed:  # else nothing that anybody is shown
            await self._book.commit(run)

    async def _decided(
        self, run: Run, command: Attach | Predict
    ) -> tuple[Run, dict[str, Any] | None]:
        """The run, and the turn to show again if the command was carried out before.

        The command is accepted as the run is now: nothing may be awaited before it is
        carried out.
        """
        while True:
            if run.lost:  # while its caller awaited something else
                run = await self._book.get(run.run_id)
            verdict = decide(run, command, self.sweep(run))
            match verdict:
                case Refuse():
                    raise Refused.by(verdict)
                case Wait(session):
                    run = await self._after(run, session)
                case Replay(session):
                    return run, self._again(session)
                case _:
                    return run, None

    # --- what the control plane and the clock do to sessions ---

    def sweep(self, run: Run) -> float:
        """End the sessions whose lease is over; returns the moment that decided it."""
        now = time.monotonic()
        over = [s for s in run.workers.values() if lease_over(s, now)]
        live = effects.expire(run, now, time.time())
        self.let_go(over)
        if live:
            self._book.commit_later(run)
        return now

    def let_go(self, sessions: list[Session]) -> None:
        """Free what ended sessions hold; a simulator in execution is killed."""
        self._scenes.let_go(sessions)

    async def close(self) -> None:
        """End every session without counting anything."""
        self._scenes.forget()

    # --- playing ---

    async def _open(self, scene: Scene) -> dict[str, Any]:
        started = time.perf_counter()
        self._still(scene)  # a stop may come before its work begins
        if scene.session.done:
            turn = turn_view.turn(scene.session, observation=None)
            return self._answer(scene, turn, started)
        if scene.handle is None:
            return await self._begin_turn(scene, started)
        try:
            observation = await scene.handle.observe()
        except SimulatorFault as error:  # it died between two turns
            await self._fault(scene, error)
            return await self._begin_turn(scene, started)
        self._still(scene)
        turn = turn_view.turn(scene.session, observation=observation)
        return self._answer(scene, turn, started)

    async def _play(self, scene: Scene, command: Predict) -> dict[str, Any]:
        started = time.perf_counter()
        self._still(scene)  # a stop may come before its work begins
        run, session = scene.run, scene.session
        assert scene.handle is not None, "a session with an episode has a simulator"
        scene.fault = None
        actions = action_space.clipped(command.actions, run.manifest)
        try:
            played = await scene.handle.play(
                actions, observe_all=command.observe == "all"
            )
        except (SimulatorFault, TaskUnplayable) as error:
            await self._fault(scene, error)
            return await self._begin_turn(scene, started)
        self._still(scene)
        outcome = effects.Outcome(
            played.executed,
            played.ended,
            played.terminated,
            played.truncated,
            played.success,
            played.score,
        )
        ended = effects.end_turn(run, session, outcome, time.time())
        observation, spent = played.observation, turn_view.timing(0.0, played.timing)
        if ended is not None:
            # The result is on disk before anybody hears of it.
            await self._book.commit(run)
            self._still(scene)
            observation = None
            if session.episode is not None:
                beginning, queue_s = await self._begin(scene)
                observation = beginning.observation
                spent = turn_view.timing(queue_s, played.timing, beginning.timing)
            else:  # its simulator serves others, its last turn stays
                self._scenes.free(scene, kill=False)
        turn = turn_view.turn(
            session,
            observation=observation,
            observations=played.observations if command.observe == "all" else None,
            played=played,
            left=len(actions) - played.executed,
            ended=ended,
            fault=scene.fault,
            spent=spent,
        )
        return self._answer(scene, turn, started)

    async def _begin_turn(self, scene: Scene, started: float) -> dict[str, Any]:
        """The turn that shows step 0, at first and after a fault (FAULT-001)."""
        beginning, queue_s = await self._begin(scene)
        turn = turn_view.turn(
            scene.session,
            observation=beginning.observation,
            fault=scene.fault,
            spent=turn_view.timing(queue_s, beginning.timing),
        )
        return self._answer(scene, turn, started)

    async def _begin(self, scene: Scene) -> tuple[Beginning, float]:
        """Begin the session's episode, anew after each fault, until it fails the run.

        Returns the beginning and the seconds spent waiting for a simulator.
        """
        run, queue_s = scene.run, 0.0
        while True:
            episode = scene.session.episode
            assert episode is not None
            try:
                queue_s += await self._scenes.lend(scene)
                self._still(scene)
                assert scene.handle is not None
                beginning = await scene.handle.begin(
                    episode.task,
                    episode.seed,
                    split=episode.split,
                    max_steps=run.manifest["max_steps"],
                    success_rule=run.manifest["success_rule"],
                )
            except (SimulatorFault, TaskUnplayable) as error:
                await self._fault(scene, error)
                continue
            self._still(scene)
            scene.session.instruction = beginning.instruction
            return beginning, queue_s

    async def _fault(self, scene: Scene, error: Exception) -> None:
        """Record a fault; returns when the episode may begin again."""
        self._still(scene)
        self._scenes.free(scene, kill=True)
        run, session, episode = scene.run, scene.session, scene.session.episode
        assert episode is not None
        log.warning("run %s, %s: %s", run.run_id, episode.episode_id, error)
        session.busy = "turning"
        ended = effects.fault(
            run,
            session,
            str(error),
            unplayable=isinstance(error, TaskUnplayable),
            now_wall=time.time(),
        )
        self.let_go(ended)
        await self._book.commit(run)
        self._still(scene)
        scene.fault = {
            "episode_id": episode.episode_id,
            "faults": episode.faults,
            "detail": str(error),
        }

    # --- the work of a session ---

    async def _execute(
        self, scene: Scene, work: Awaitable[dict[str, Any]]
    ) -> dict[str, Any]:
        """Run a session's work as its one task, which outlives a caller that leaves."""
        scene.task = asyncio.create_task(self._guarded(scene, work))
        # What it fails with is looked at, also when its caller has left.
        scene.task.add_done_callback(lambda task: task.cancelled() or task.exception())
        return await asyncio.shield(scene.task)

    async def _guarded(
        self, scene: Scene, work: Awaitable[dict[str, Any]]
    ) -> dict[str, Any]:
        """Whatever goes wrong, no session stays busy for ever."""
        try:
            return await work
        except NoCapacity as error:
            self._abort(scene)
            raise Refused("no_capacity", str(error)) from error
        except Refused:
            self._abort(scene)
            raise
        except Exception as error:
            log.exception("a turn of run %s failed", scene.run.run_id)
            self._abort(scene)
            raise Refused(
                "internal_error", "The turn could not be carried out."
            ) from error

    def _abort(self, scene: Scene) -> None:
        """End a session by no fault of its policy: no attempt is counted."""
        session = scene.session
        if session.ended_by is None:
            session.busy, session.steps = "turning", 0
            effects.close_session(scene.run, session, "unknown", time.time())
            self.let_go([session])
            if scene.run.changed or scene.run.state not in ("ready", "running"):
                self._book.commit_later(scene.run)
            else:  # a run in play is found ready again, and nothing else has changed
                self._book.notify(scene.run)

    async def _after(self, run: Run, session: Session) -> Run:
        """The run when the session's task is over; the caller decides again then."""
        scene = self._scenes.of(session)
        if scene is not None and scene.task is not None:
            await asyncio.wait([scene.task])
        else:
            await asyncio.sleep(0)
        return await self._book.get(run.run_id)

    def _again(self, session: Session) -> dict[str, Any]:
        effects.touch(session, time.monotonic())
        assert session.turn is not None, "a session that is not busy has its turn"
        return session.turn

    def _answer(
        self, scene: Scene, turn: dict[str, Any], started: float
    ) -> dict[str, Any]:
        effects.answer(scene.session, turn, time.monotonic())
        turn_view.finish(turn, scene.session, time.perf_counter() - started)
        return turn

    def _still(self, scene: Scene) -> None:
        """After an await: is the session still the one to answer?"""
        ended_by = scene.session.ended_by
        if ended_by is not None:
            raise Refused(
                "session_ended",
                f"The session ended while its turn was executed ({ended_by}).",
                members={"ended_by": ended_by},
            )
