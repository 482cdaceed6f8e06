"""Mutants of answers: scores, versions, problems, encodings."""

from __future__ import annotations

import asyncio
import statistics
from typing import Any

from starlette.responses import Response

from reference_server import app
from reference_server.generated.problem_codes import PROBLEMS
from reference_server.http import codec, dispatch, problems
from reference_server.http.handlers import Handlers
from reference_server.rules import scoring
from reference_server.rules.refusal import Refused
from reference_server.rules.run import Run
from reference_server.runs.registry import RunRegistry
from reference_server.views import run_views
from tests.mutants import mutant, put


def change_score(change: Any) -> None:
    """Let `change(score, episodes)` spoil every score."""
    right = scoring.score_of

    def wrong(episodes: Any) -> dict[str, Any]:
        score = right(episodes)
        change(score, episodes)
        return score

    put(run_views, "score_of", wrong)


@mutant(
    "SCORE-004",
    "SCORE-006",
    "SCORE-007",
    "SCORE-009",
    "SCORE-011",
    "SCORE-012",
    "SCORE-013",
)
def leaves_abandoned_episodes_out() -> None:
    """Giving up on hard episodes raises the score."""
    right = scoring.score_of

    def wrong(episodes: Any) -> dict[str, Any]:
        counted_episodes = [e for e in episodes if e.outcome != "abandoned"]
        return (
            right(counted_episodes) | {"counts": right(episodes)["counts"]}
            if counted_episodes
            else right(episodes)
        )

    put(run_views, "score_of", wrong)


@mutant("SCORE-006")
def averages_over_tasks() -> None:
    """A task with one episode weighs as much as one with a hundred."""

    def wrong(score: dict[str, Any], _episodes: Any) -> None:
        if score["score"] is not None:
            means = [group["mean"] for group in score["by_task"].values()]
            score["score"] = statistics.fmean(means)

    change_score(wrong)


@mutant("SCORE-006")
def rounds_the_score() -> None:
    """Two runs that differ look the same."""

    def wrong(score: dict[str, Any], _episodes: Any) -> None:
        if score["score"] is not None:
            score["score"] = round(score["score"], 6)

    change_score(wrong)


@mutant("SCORE-005", "SCORE-006")
def calls_a_partial_score_complete() -> None:
    """A partial score is published as the result."""

    def wrong(score: dict[str, Any], _episodes: Any) -> None:
        score["complete"] = True
        if score["score"] is None:
            score["score"] = score["mean"] or 0.0

    change_score(wrong)


@mutant("SCORE-007")
def forgets_the_upper_bound() -> None:
    """A partial score looks final."""
    change_score(lambda score, _: score.update(score_high=score["score_low"]))


@mutant("SCORE-012")
def uses_the_normal_interval() -> None:
    """Ten successes of ten look like certainty."""
    right = scoring.wilson

    def wrong(rate: float | None, n: int) -> dict[str, float]:
        if rate is None or n == 0:
            return right(rate, n)
        half = 1.96 * (rate * (1 - rate) / n) ** 0.5
        return {"low": max(0.0, rate - half), "high": min(1.0, rate + half)}

    def spoil(score: dict[str, Any], episodes: Any) -> None:
        n = sum(1 for e in episodes if e.outcome is not None)
        score["success_interval"] = wrong(score["success_rate"], n)

    change_score(spoil)


@mutant("ERR-014", "VER-002")
def accepts_any_version() -> None:
    """A client of another protocol is misunderstood instead of refused."""
    put(dispatch, "check_version", lambda _request: None)


@mutant("SVC-002", "VER-001")
def does_not_name_its_version() -> None:
    """A client cannot know which protocol version an answer follows."""

    right = app.Application.__call__

    async def wrong(self: app.Application, scope: Any, receive: Any, send: Any) -> None:
        if scope["type"] == "http":
            await self._app(scope, receive, send)
        else:
            await right(self, scope, receive, send)

    put(app.Application, "__call__", wrong)


@mutant("ERR-001")
def calls_problems_plain_json() -> None:
    """Clients that expect problem details do not recognise them."""
    put(problems, "PROBLEM_JSON", "application/json")


@mutant("ERR-001")
def says_that_a_conflict_is_retryable() -> None:
    """Clients repeat a request that can never succeed."""
    PROBLEMS["illegal_transition"]["retryable"] = True


@mutant("ERR-011")
def does_not_say_when_to_retry() -> None:
    """Clients that must wait retry immediately."""
    right = problems.problem_response

    def wrong(refused: Refused, *headers: Any) -> Response:
        response = right(refused, *headers)
        if "retry-after" in response.headers:
            del response.headers["retry-after"]
        return response

    put(dispatch, "problem_response", wrong)


@mutant("DET-001", "DET-003", "LEASE-011", "SVC-003")
def sends_numbers_as_text() -> None:
    """Generated clients cannot read the run."""
    right = run_views.run_view

    def wrong(*arguments: Any) -> dict[str, Any]:
        body = right(*arguments)
        return body | {"live_workers": str(body["live_workers"])}

    put(run_views, "run_view", wrong)


@mutant("ENC-001")
def prefers_messagepack() -> None:
    """Generated clients receive a format that they cannot read."""
    right = codec.negotiate_media_type

    def wrong(request: Any, writable: Any) -> str:
        return right(request, tuple(reversed(writable)))

    put(codec, "negotiate_media_type", wrong)


@mutant("ENC-001")
def repeats_a_turn_in_its_first_encoding() -> None:
    """A client that accepts both is sent a format that it does not expect."""
    right = Handlers.predict
    first: dict[tuple[str, int], str] = {}

    async def wrong(self: Handlers, call: Any) -> Response:
        place = call.body.session_id, call.body.seq
        call.media_type = first.setdefault(place, call.media_type)
        return await right(self, call)

    put(Handlers, "predict", wrong)


@mutant("CRASH-001", "CRASH-003", "CRASH-004")
def stores_results_after_sending_them() -> None:
    """A crash loses results that the client has received."""
    right = RunRegistry.commit

    async def later(self: RunRegistry, run: Run) -> None:
        await asyncio.sleep(3)
        await right(self, run)

    async def wrong(self: RunRegistry, run: Run) -> None:
        if not run.changed:
            await right(self, run)
            return
        self.run_in_background(later(self, run))
        self.notify(run)

    put(RunRegistry, "commit", wrong)


@mutant("SCORE-009", "SCORE-011")
def shows_no_rate_without_a_success() -> None:
    """A policy that never succeeds seems not to be measured yet."""

    def wrong(score: dict[str, Any], _episodes: Any) -> None:
        for group in (score, *score["by_task"].values(), *score["by_split"].values()):
            group["success_rate"] = group["success_rate"] or None

    change_score(wrong)
