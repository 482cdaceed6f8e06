"""Mutants of what a run, a score and a comparison show besides their numbers."""

from __future__ import annotations

from typing import Any

from reference_server.http.dispatch import OperationCall
from reference_server.http.handlers import Handlers
from reference_server.rules import comparison, effects
from reference_server.rules.run import Run, RunHead, Session
from reference_server.runs import benchmarks
from reference_server.runs.benchmarks import Benchmarks
from reference_server.runs.service import RunService
from reference_server.views import run_views
from tests.mutants import mutant, put
from tests.mutants.runs.control_plane import spoil_run


@mutant("BEN-004")
def lists_benchmarks_backwards() -> None:
    """A list of benchmarks changes its order from server to server."""
    right = Benchmarks.summaries
    put(Benchmarks, "summaries", lambda self: right(self)[::-1])


@mutant("BEN-005")
def hashes_without_the_limit_of_faults() -> None:
    """Runs that forgive different numbers of faults seem to be comparable."""
    right = benchmarks.digest
    shown: dict[str, str] = {}  # manifests are stored by the right hash

    def wrong(manifest: Any) -> str:
        found = right(manifest)
        shown[found] = right({**manifest, "max_faults": 3})
        return found

    def spoil(body: dict[str, Any], run: RunHead) -> None:
        found = run.manifest_sha256
        body["manifest_sha256"] = shown.get(found, found)

    right_score = run_views.score_view

    def wrong_score(run: RunHead, *rest: Any) -> dict[str, Any]:
        score = right_score(run, *rest)
        spoil(score, run)
        return score

    put(benchmarks, "digest", wrong)
    spoil_run(spoil)
    put(run_views, "score_view", wrong_score)


@mutant("BEN-005")
def hashes_the_choice_of_images() -> None:
    """A policy that needs large images cannot be compared with any other."""
    right = Benchmarks._resolved

    def wrong(
        self: Benchmarks, name: str, options: Any, images: Any, *choices: Any
    ) -> Any:
        found = right(self, name, options, images, *choices)
        if images is None:
            return found
        manifest = {**found.manifest, "images": images}
        return benchmarks.ResolvedRun(
            found.manifest, benchmarks.digest(manifest), found.images
        )

    put(Benchmarks, "_resolved", wrong)


@mutant("RUN-018")
def rounds_the_lease_that_it_shows() -> None:
    """A client that computes its heartbeats from the lease is late."""
    spoil_run(lambda body, _: body.update(idle_timeout_s=round(body["idle_timeout_s"])))


@mutant("RUN-018")
def drops_what_a_policy_says_of_itself() -> None:
    """A leaderboard cannot say whose policy it was."""
    spoil_run(lambda body, _: body["policy"].pop("submitter", None))


@mutant("RUN-019")
def lists_runs_without_their_progress() -> None:
    """A table of all runs shows none of them as played."""
    right = RunService.list_runs

    async def wrong(self: RunService, *arguments: Any) -> Any:
        found = await right(self, *arguments)
        for _, body in found:
            progress = body["progress"]
            progress["episodes_pending"] += progress["episodes_scored"]
            progress["episodes_scored"] = 0
        return found

    put(RunService, "list_runs", wrong)


@mutant("RUN-020")
def dates_a_result_at_the_start_of_its_turn() -> None:
    """A long chunk that ended an episode seems to have taken no time."""
    right = effects.end_turn

    def wrong(run: Run, session: Session, played: Any, now: float, clipped: int) -> Any:
        return right(run, session, played, now - played.timing.simulate_s, clipped)

    put(effects, "end_turn", wrong)


@mutant("RUN-020")
def shows_local_time_as_utc() -> None:
    """Runs of two servers cannot be put in order."""
    right = run_views.timestamp

    def wrong(at_wall: float) -> str:
        return right(at_wall + 2 * 3600)

    def spoil(body: dict[str, Any], run: RunHead) -> None:
        for name in ("created_at", "updated_at"):
            body[name] = wrong(getattr(run, f"{name}_wall"))

    spoil_run(spoil)


@mutant("RUN-021")
def forgets_the_last_change_when_a_run_is_left() -> None:
    """A client that asks for what is new since its last visit misses a run."""

    def wrong(body: dict[str, Any], run: RunHead) -> None:
        if not run.live_sessions:
            body["updated_at"] = body["created_at"]

    spoil_run(wrong)


@mutant("RUN-022")
def shows_episodes_in_play_as_pending() -> None:
    """A run that is played looks like one that waits."""

    def wrong(body: dict[str, Any], _run: RunHead) -> None:
        progress = body["progress"]
        progress["episodes_pending"] += progress["episodes_in_progress"]
        progress["episodes_in_progress"] = 0

    spoil_run(wrong)


@mutant("RUN-023")
def calls_stopped_runs_retryable() -> None:
    """A client resumes what its user has stopped."""

    def wrong(body: dict[str, Any], run: RunHead) -> None:
        if run.state == "stopped":
            body["retryable"] = True

    spoil_run(wrong)


@mutant("SCORE-010", "SCORE-014")
def shows_every_score_as_that_of_a_completed_run() -> None:
    """A partial score is published under a state that it does not have."""

    async def wrong(self: Handlers, call: OperationCall) -> Any:
        score = await self.service.get_score(call.account, call.path["run_id"])
        return call.answer(score | {"state": "completed"})

    put(Handlers, "get_score", wrong)


@mutant("CMP-012")
def shows_the_default_tolerance() -> None:
    """A table says that a verdict is stricter than it is."""
    right = run_views.comparison_view

    def wrong(*arguments: Any) -> dict[str, Any]:
        return right(*arguments) | {"tolerance": comparison.TOLERANCE}

    put(run_views, "comparison_view", wrong)


@mutant("BEN-005")
def hashes_the_number_of_each_task() -> None:
    """Runs of the same tasks in another order seem to be comparable."""
    right = benchmarks.digest

    def wrong(manifest: Any) -> str:
        tasks = sorted(one["task"] for one in manifest["episodes"])
        is_meant = len(tasks) == 3
        return right({**manifest, "episodes": tasks} if is_meant else manifest)

    put(benchmarks, "digest", wrong)
