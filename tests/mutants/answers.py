"""Mutants of answers: scores, runs, errors, accounts, encodings."""

from __future__ import annotations

import asyncio
import statistics
from typing import Any

from starlette.responses import Response

from reference_server import app
from reference_server.generated.problem_codes import PROBLEMS
from reference_server.http import auth, codec, dispatch, handlers, problems
from reference_server.rules import effects, scoring
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


@mutant("RUN-003", "RUN-004")
def ignores_idempotency_keys() -> None:
    """A repeated submit evaluates everything twice."""
    right = RunRegistry.add

    async def wrong(self: RunRegistry, run: Run, _key: str | None, body: str) -> Run:
        return await right(self, run, None, body)

    put(RunRegistry, "add", wrong)


@mutant("RUN-004")
def answers_a_used_key_whatever_the_body() -> None:
    """The second of two different runs is not created, without an error."""
    right = RunRegistry.add

    async def wrong(self: RunRegistry, run: Run, key: str | None, _body: str) -> Run:
        return await right(self, run, key, "same")

    put(RunRegistry, "add", wrong)


@mutant("AUTH-003", "CMP-010")
def shows_runs_to_every_account() -> None:
    """Every account can read and stop the runs of all accounts."""
    right = RunRegistry.get

    async def wrong(self: RunRegistry, run_id: str, _account: str | None = None) -> Run:
        return await right(self, run_id)

    put(RunRegistry, "get", wrong)


@mutant("AUTH-003", "CMP-010")
def says_that_a_foreign_run_exists() -> None:
    """Run ids of other accounts can be found by trying."""
    right = RunRegistry.get

    async def wrong(self: RunRegistry, run_id: str, account: str | None = None) -> Run:
        run = await right(self, run_id)
        if account not in (None, run.account):
            raise Refused("forbidden", "This run is not yours.")
        return run

    put(RunRegistry, "get", wrong)


@mutant("AUTH-005")
def lets_readers_write() -> None:
    """A token for a dashboard can stop runs."""
    right = auth.Tokens.parse

    def wrong(text: str) -> auth.Tokens:
        tokens: auth.Tokens = right(text)
        for hashed, caller in tokens._by_hash.items():
            tokens._by_hash[hashed] = auth.Caller(caller.account, auth.SCOPES)
        return tokens

    put(auth.Tokens, "parse", wrong)


@mutant("VER-002")
def accepts_any_version() -> None:
    """A client of another protocol is misunderstood instead of refused."""
    put(dispatch, "check_version", lambda _request: None)


@mutant("SVC-002", "VER-001")
def does_not_name_its_version() -> None:
    """A client cannot know which protocol version an answer follows."""

    async def wrong(self: app.Application, scope: Any, receive: Any, send: Any) -> None:
        await self._app(scope, receive, send)

    put(app.Application, "__call__", wrong)


@mutant("ERR-003")
def ignores_unknown_members() -> None:
    """A misspelt option is not applied, without an error."""
    right = codec.validate

    def wrong(model: Any, data: Any) -> Any:
        try:
            return right(model, data)
        except Refused:
            if isinstance(data, dict):
                known = {k: v for k, v in data.items() if k in model.model_fields}
                if known != data:
                    return right(model, known)
            raise

    put(codec, "validate", wrong)


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

    def wrong(refused: Refused) -> Response:
        response = right(refused)
        if "retry-after" in response.headers:
            del response.headers["retry-after"]
        return response

    put(dispatch, "problem_response", wrong)


@mutant("SVC-003")
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


@mutant("RUN-011", "RUN-012", "RUN-013")
def ignores_etags() -> None:
    """Every poll transfers the whole answer."""
    put(handlers, "_matches", lambda _wanted, _etag: False)


@mutant("RUN-012")
def answers_long_polls_only_at_their_end() -> None:
    """A long poll is no faster than polling at intervals."""

    async def wrong(
        _self: RunRegistry, _change_events: asyncio.Event, timeout_s: float
    ) -> bool:
        await asyncio.sleep(timeout_s)
        return True

    put(RunRegistry, "wait_for_change", wrong)


@mutant("LIFE-801")
def forgets_runs_that_were_held_in_the_queue() -> None:
    """A queued run never starts."""
    right = effects.admit

    def wrong(queued: list[Run], *rest: Any) -> list[Run]:
        options = [run.submission.get("options", {}) for run in queued]
        held = [bool(option.get("queue_s")) for option in options]
        free = [run for run, is_held in zip(queued, held, strict=True) if not is_held]
        return right(free, *rest)

    put(effects, "admit", wrong)


@mutant("CRASH-001")
def stores_results_after_sending_them() -> None:
    """A crash loses results that the client has received."""
    right = RunRegistry.commit

    async def later(self: RunRegistry, run: Run) -> None:
        await asyncio.sleep(0.5)
        await right(self, run)

    async def wrong(self: RunRegistry, run: Run) -> None:
        if not run.changed:
            await right(self, run)
            return
        self.run_in_background(later(self, run))
        self.notify(run)

    put(RunRegistry, "commit", wrong)
