"""Mutants of scores: what is counted, averaged and bounded, and when it is shown."""

from __future__ import annotations

import math
import statistics
from typing import Any

from reference_server.http.handlers import Handlers
from reference_server.rules import (
    scoring,
)
from reference_server.rules.refusal import Refused
from reference_server.views import run_views
from tests.mutants import Json, instead_of, mutant, put


def change_score(change: Any) -> None:
    """Let `change(score, episodes)` spoil every score."""
    right: Any = scoring.score_of

    def wrong(episodes: Any) -> Any:
        score = right(episodes)
        change(score, episodes)
        return score

    put(run_views, "score_of", wrong)


@mutant(
    *(
        "SCORE-004",
        "SCORE-006",
        "SCORE-007",
        "SCORE-009",
        "SCORE-011",
        "SCORE-012",
        "SCORE-013",
    ),
    through=instead_of(run_views, "score_of"),
)
def leaves_abandoned_episodes_out(right: Any, episodes: Any) -> Any:
    """Giving up on hard episodes raises the score."""
    counted_episodes = [e for e in episodes if e.outcome != "abandoned"]
    return (
        right(counted_episodes) | {"counts": right(episodes)["counts"]}
        if counted_episodes
        else right(episodes)
    )


@mutant("SCORE-006", through=change_score)
def averages_over_tasks(score: Json, _episodes: Any) -> None:
    """A task with one episode weighs as much as one with a hundred."""
    if score["score"] is not None:
        means = [group["mean"] for group in score["by_task"].values()]
        score["score"] = statistics.fmean(means)


@mutant("SCORE-005", "SCORE-006", through=change_score)
def calls_a_partial_score_complete(score: Json, _episodes: Any) -> None:
    """A partial score is published as the result."""
    score["complete"] = True
    if score["score"] is None:
        score["score"] = score["mean"] or 0.0


@mutant("SCORE-007", through=change_score)
def forgets_the_upper_bound(score: Json, _episodes: Any) -> None:
    """A partial score looks final."""
    score["score_high"] = score["score_low"]


@mutant("SCORE-012", "SCORE-013", through=instead_of(scoring, "wilson"))
def approximates_intervals_of_many_episodes(
    right: Any, rate: float | None, n: int
) -> Any:
    """The interval of a long run is narrower than it may be."""
    if rate is None or n <= 30:
        return right(rate, n)
    half = 1.96 * math.sqrt(rate * (1 - rate) / n)
    return {"low": max(0.0, rate - half), "high": min(1.0, rate + half)}


@mutant("SCORE-008", through=instead_of(run_views, "score_of"))
def counts_abandoned_episodes_as_failures(right: Any, episodes: Any) -> Any:
    """Abandoned episodes cannot be distinguished from failed ones."""
    score = right(episodes)
    counts = score["counts"]
    counts["failure"] += counts["abandoned"]
    counts["abandoned"] = 0
    return score


@mutant("SCORE-010", through=instead_of(Handlers, "get_score"))
async def hides_scores_until_the_end(right: Any, self: Handlers, call: Any) -> Any:
    """Partial results cannot be read."""
    run = await self.service.get_run(call.account, call.path["run_id"])
    if run.state == "stopped":
        raise Refused("illegal_transition", "Not while stopped.")
    return await right(self, call)


@mutant("SCORE-014", through=instead_of(run_views, "score_of"))
def shows_another_state_beside_the_score(right: Any, episodes: Any) -> Any:
    """A dashboard calls a run that was stopped running."""
    return right(episodes) | {"state": "running"}
