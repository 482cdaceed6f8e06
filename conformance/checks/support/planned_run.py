"""Runs that are played to a plan: an outcome and a score for every episode.

The task `score` gives an episode the score that its action carries, so a check can
play any pattern of outcomes.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

from hypothesis import strategies as st

from conformance.checks.support.given_states import index_of
from conformance.client.check_context import CheckContext
from conformance.client.run_client import RunClient, WorkerClient
from conformance.verdicts import expect
from conformance.verdicts.expect import SetUpFailed


@dataclass(frozen=True)
class PlannedEpisode:
    """The planned end of an episode; an outcome of None leaves it unscored."""

    outcome: str | None
    score: float = 0.0
    task: str = "score"


# No decimal fraction of few digits, so that a rounded number is seen.
SUCCESS, FAILURE, UNPLAYED = (
    PlannedEpisode("success", 0.9123456789012345),
    PlannedEpisode("failure", 1 / 3),
    PlannedEpisode(None),
)
ABANDONED = PlannedEpisode("abandoned", 0.7)


class PlannedRun:
    """A run that is played episode by episode."""

    def __init__(self, context: CheckContext, plan: Sequence[PlannedEpisode]) -> None:
        max_attempts = 1 if context.offers("sessions") else None
        if max_attempts is None:  # nothing can be abandoned
            plan = [_without_abandonment(planned) for planned in plan]
        self.run: RunClient = context.submit(
            *[t.task for t in plan], max_attempts=max_attempts
        )
        self.played = 0
        self._context = context
        self._plan = plan
        self._worker: WorkerClient | None = None

    def play_next(self) -> bool:
        """Play one episode to the outcome that is planned; say if there was one."""
        if self.played == len(self._plan) or not self._plan[self.played].outcome:
            return False
        if self._worker is None:
            self._worker = self.run.worker()
            self._worker.attach()
        if index_of(self._worker) != self.played:
            raise SetUpFailed("episodes come in another order", breaks="EPI-001")
        planned_episode = self._plan[self.played]
        is_abandoned = planned_episode.outcome == "abandoned"
        self._worker.predict(
            self._context.action(
                score=planned_episode.score,
                success=int(planned_episode.outcome == "success"),
                end=int(not is_abandoned),
            )
        )
        if is_abandoned:
            self._worker.detach()
            self._worker = None
            result = self.run.results()[self.played]
            if result is None or result["outcome"] != "abandoned":
                raise SetUpFailed("the last attempt is not abandoned", breaks="EPI-004")
        self.played += 1
        return True

    def play_all(self) -> dict[str, Any]:
        """Play up to the first unscored episode of the plan; give the score."""
        while self.play_next():
            pass
        return self.score()

    def score(self) -> dict[str, Any]:
        """Read the score, whose members are what is under test."""
        return expect.ExpectedBody(self.run.score())


def _without_abandonment(planned: PlannedEpisode) -> PlannedEpisode:
    is_abandoned = planned.outcome == "abandoned"
    return replace(planned, outcome="failure") if is_abandoned else planned


EPISODE_PLANS = st.builds(
    PlannedEpisode,
    st.sampled_from(["success", "failure", "abandoned"]),
    st.one_of(st.floats(0, 1), st.sampled_from([0.1, 0.2, 0.3, 1 / 3])),
    st.sampled_from(["score", "score", "count"]),
)
