"""Mutants of the profile `subsets`: runs of a part of a benchmark."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from reference_server.rules import submission
from reference_server.rules.lifecycle import Refuse
from reference_server.rules.manifest import Manifest
from reference_server.rules.run import RunHead
from reference_server.rules.submission import Selection
from reference_server.runs import benchmarks
from reference_server.views import run_views
from tests.mutants import mutant, put


@mutant("SUB-001")
def renumbers_the_seeds_of_a_selection() -> None:
    """The episodes of a part are others than those of the whole benchmark."""
    right = submission.select_episodes

    def wrong(manifest: Manifest, select: Selection | None) -> Manifest | Refuse:
        found = right(manifest, select)
        if isinstance(found, Refuse) or found is manifest:
            return found
        seeds = [plan["seed"] for plan in manifest["episodes"]]
        plans = [
            plan | {"seed": seed}
            for plan, seed in zip(found["episodes"], seeds, strict=False)
        ]
        return found | {"episodes": plans}

    put(submission, "select_episodes", wrong)


@mutant("SUB-001", "SUB-002", "SUB-004")
def reads_the_tasks_of_a_selection_alone() -> None:
    """A run of the test split plays all splits."""
    right = submission.select_episodes

    def wrong(manifest: Manifest, select: Selection | None) -> Manifest | Refuse:
        return right(
            manifest, {k: v for k, v in (select or {}).items() if k == "tasks"}
        )

    put(submission, "select_episodes", wrong)


@mutant("SUB-002")
def passes_over_unknown_names_of_a_selection() -> None:
    """A misspelt task is left out, without a word."""
    right = submission.select_episodes

    def wrong(manifest: Manifest, select: Selection | None) -> Manifest | Refuse:
        known = {*manifest["tasks"], *manifest["splits"]}
        named = {
            member: [name for name in names if name in known] or names
            for member, names in (select or {}).items()
        }
        return right(manifest, named)

    put(submission, "select_episodes", wrong)


@mutant("SUB-003")
def conceals_in_the_score_that_it_is_of_a_part() -> None:
    """The score of an easy task looks like that of the benchmark."""
    right = run_views.score_view

    def wrong(run: RunHead, *rest: Any) -> dict[str, Any]:
        return {k: v for k, v in right(run, *rest).items() if k != "select"}

    put(run_views, "score_view", wrong)


@mutant("SUB-004")
def digests_the_whole_benchmark_for_a_part() -> None:
    """Runs of different parts are compared episode by episode."""
    right = benchmarks.Benchmarks._resolved

    def wrong(self: benchmarks.Benchmarks, *choices: Any) -> benchmarks.ResolvedRun:
        whole = right(self, *choices[:3])
        return replace(right(self, *choices), manifest_sha256=whole.manifest_sha256)

    put(benchmarks.Benchmarks, "_resolved", wrong)
