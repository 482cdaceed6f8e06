"""Log lines and counters of a run's life: submitted, ready, scored, ended.

A line is logged when the change is stored, with the ids by which it can be searched
for. This module decides nothing.
"""

from __future__ import annotations

import logging
from collections.abc import Sequence
from weakref import WeakKeyDictionary

from reference_server.rules.runs.run import Episode, Run, Session, State
from reference_server.runs.memory.run_events import Departure, RunFollower
from reference_server.telemetry.counters import COUNTERS
from reference_server.telemetry.log_output import log_event

log = logging.getLogger("proctor.runs")


class RunLog(RunFollower):
    """Logs what is new of each run since its last line."""

    def __init__(self) -> None:
        self._states: WeakKeyDictionary[Run, State] = WeakKeyDictionary()

    def loaded(self, run: Run, stored: State) -> None:
        """Nothing is new of a run that was read."""
        self._states[run] = stored

    def log_taken(self, run: Run) -> None:
        """The run waited at another node; it was let in before it was read."""
        self._states.pop(run, None)
        self._log_state(run)

    def log_submitted(self, run: Run) -> None:
        log_event(
            log,
            "run submitted",
            run_id=run.run_id,
            account=run.account,
            benchmark_id=run.manifest["benchmark_id"],
            policy=run.submission.get("policy", {}).get("name"),
            episodes=run.total,
        )
        self._states[run] = "queued"
        self._log_state(run)

    def stored(self, run: Run, scored: Sequence[Episode]) -> None:
        for episode in scored:
            _log_scored(run, episode)
        self._log_state(run)

    def changed(self, run: Run) -> None:
        """A worker attached, which is in memory alone until an episode ends."""
        if run.state == "running":
            self._log_state(run)

    def left(self, run: Run, why: Departure) -> None:
        if why == "deleted":
            _log_deleted(run)

    def _log_state(self, run: Run) -> None:
        if self._states.get(run) == run.state:
            return
        self._states[run] = run.state
        COUNTERS.runs[run.state] += 1
        log_event(
            log,
            f"run {run.state}",
            run_id=run.run_id,
            account=run.account,
            scored=run.scored,
            episodes=run.total,
            reason=run.reason,
        )


def log_attached(run: Run, session: Session) -> None:
    _log_session("worker attached", run, session)


def log_restored(run: Run, session: Session) -> None:
    """A session goes on that another process had."""
    _log_session("worker goes on", run, session)


def _log_session(event: str, run: Run, session: Session) -> None:
    episode = session.episode
    log_event(
        log,
        event,
        run_id=run.run_id,
        worker_id=session.worker_id,
        episode_id=None if episode is None else episode.episode_id,
        attempt=None if episode is None else episode.attempt,
    )


def log_left(run_id: str, session: Session, cause: str | None) -> None:
    """cause: None where `ended_by` says it."""
    COUNTERS.sessions_ended[session.ended_by or "unknown"] += 1
    log_event(
        log,
        "worker left",
        run_id=run_id,
        worker_id=session.worker_id,
        ended_by=session.ended_by,
        cause=cause,
    )


def _log_deleted(run: Run) -> None:
    log_event(
        log,
        "run deleted",
        run_id=run.run_id,
        account=run.account,
        is_played=run.is_played,
    )


def _log_scored(run: Run, episode: Episode) -> None:
    result = episode.result
    assert result is not None
    COUNTERS.episodes[result.outcome] += 1
    log_event(
        log,
        "episode scored",
        run_id=run.run_id,
        episode_id=episode.episode_id,
        task=episode.task,
        outcome=result.outcome,
        score=result.score,
        steps=result.steps,
        attempt=result.attempt,
    )
