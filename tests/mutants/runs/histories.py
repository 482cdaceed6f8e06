"""Mutants that only a history shows: each rule alone seems to be kept.

The windows of races are opened a little by a sleep, so that they are found sooner.
"""

from __future__ import annotations

import asyncio
import time
from typing import Any

from reference_record.generated.answers import Turn
from reference_server.rules.runs import effects
from reference_server.rules.runs.lifecycle import Heartbeat, Predict
from reference_server.rules.runs.run import Run, Session, SessionEnd
from reference_server.runs.sessions.episode_beginnings import EpisodeBeginnings
from reference_server.runs.sessions.session_executor import SessionExecutor
from reference_server.runs.sessions.session_resources import SessionResources
from tests.mutants import mutant, put


@mutant("DET-005", "MODEL-001")
def revives_sessions_on_resume() -> None:
    """A policy from before the stop gets old answers as if it still played."""
    stopped: dict[str, Session] = {}
    remember, heartbeat, predict = (
        Run.record_end,
        SessionExecutor.heartbeat,
        SessionExecutor.predict,
    )

    def wrong_remember(self: Run, session: Session, ended_by: SessionEnd) -> None:
        if ended_by == "run_stopped":
            stopped[session.session_id] = session
        remember(self, session, ended_by)

    def wrong_heartbeat(self: SessionExecutor, run: Run, command: Heartbeat) -> Session:
        session = stopped.get(command.session_id)
        if session is None or run.state == "stopped":
            return heartbeat(self, run, command)
        effects.extend_lease(session, time.monotonic())
        return session

    async def wrong_predict(self: SessionExecutor, run: Run, command: Predict) -> Turn:
        session = stopped.get(command.session_id)
        if session is None or session.turn is None or run.state == "stopped":
            return await predict(self, run, command)
        return session.turn

    put(Run, "record_end", wrong_remember)
    put(SessionExecutor, "heartbeat", wrong_heartbeat)
    put(SessionExecutor, "predict", wrong_predict)


@mutant("MODEL-002", "STOP-002")
def stop_misses_a_session_that_is_opening() -> None:
    """A worker that attaches during a stop plays on in a stopped run."""
    right, begin = effects.stop, EpisodeBeginnings.begin

    def wrong(run: Run, mode: str, *others: Any) -> list[Session]:
        opening = {k: s for k, s in run.workers.items() if s.busy == "opening"}
        for worker_id in opening:
            del run.workers[worker_id]
        sessions = right(run, mode, *others)
        run.workers.update(opening)
        return sessions

    async def slow_begin(self: EpisodeBeginnings, resources: SessionResources) -> Any:
        if resources.session.busy == "opening":
            await asyncio.sleep(0.03)
        return await begin(self, resources)

    put(effects, "stop", wrong)
    put(EpisodeBeginnings, "begin", slow_begin)
