"""Mutants of seeds: which are shown, and what stands for those that are not."""

from __future__ import annotations

from typing import Any

from reference_server.rules.manifest import Manifest
from reference_server.rules.run import Episode
from reference_server.runs import benchmarks
from reference_server.runs.benchmarks import Benchmarks
from reference_server.storage import rows
from reference_server.system.seed_secret import SeedSecret
from reference_server.views import run_views, turn_view
from tests.mutants import mutant, put


@mutant("SEAL-002")
def shows_sealed_seeds_in_lists() -> None:
    """Other participants can train on the test episodes of the first one."""
    right = run_views.result_view

    def wrong(episode: Episode) -> dict[str, Any]:
        return right(episode) | {"seed": episode.seed}

    put(run_views, "result_view", wrong)


@mutant("SEAL-002")
def shows_a_sealed_seed_in_the_last_turn() -> None:
    """A participant that plays once knows the seeds of the test."""
    right = run_views.result_view

    def wrong(episode: Episode) -> dict[str, Any]:
        return right(episode) | {"seed": episode.seed}

    put(turn_view, "result_view", wrong)


@mutant("SEAL-002")
def shows_sealed_seeds_of_abandoned_episodes() -> None:
    """A participant that gives up an episode knows the seed of the test."""
    right = run_views.result_view

    def wrong(episode: Episode) -> dict[str, Any]:
        view = right(episode)
        if view["outcome"] == "abandoned":
            view["seed"] = episode.seed
        return view

    put(run_views, "result_view", wrong)


@mutant("CRASH-003")
def shows_sealed_seeds_of_stored_episodes() -> None:
    """A participant has only to wait until the host starts its server again."""
    right = rows.episode_of

    def wrong(manifest: Manifest, row: rows.EpisodeRow) -> Episode:
        episode = right(manifest, row)
        episode.is_sealed = False
        return episode

    put(rows, "episode_of", wrong)


@mutant("SEAL-001", "SEAL-002")
def shows_no_seed_at_all() -> None:
    """No user can replay an episode of a split that is open."""
    right = run_views.result_view

    def wrong(episode: Episode) -> dict[str, Any]:
        shown = right(episode)
        shown.pop("seed", None)
        return shown

    for module in (run_views, turn_view):
        put(module, "result_view", wrong)


@mutant("SEAL-003")
def commits_to_no_seeds() -> None:
    """A host can choose the seeds after it has seen the policies."""
    right = Benchmarks.view

    async def wrong(self: Benchmarks, benchmark_id: str) -> dict[str, Any]:
        shown = await right(self, benchmark_id)
        shown.pop("seeds_sha256", None)
        return shown

    put(Benchmarks, "view", wrong)


@mutant("BEN-005", "AUTH-005", "ERR-008", "ERR-017", "SEAL-002")
def hashes_open_and_sealed_seeds_alike() -> None:
    """Runs of other episodes are compared as if they were of the same ones."""
    right = benchmarks.digest
    members = ("sealed_splits", "seeds_sha256", "episodes")
    put(
        benchmarks,
        "digest",
        lambda manifest: right(
            {name: value for name, value in manifest.items() if name not in members}
            | {"episodes": [{**e, "seed": 0} for e in manifest["episodes"]]}
        ),
    )


@mutant("BEN-005")
def draws_other_sealed_seeds_for_every_run() -> None:
    """No two policies play the same test, and no comparison is of pairs."""
    right = Benchmarks._resolved

    def wrong(self: Benchmarks, name: str, options: Any, *choices: Any) -> Any:
        if (options or {}).get("sealed"):
            self._seed_secret = SeedSecret()
        return right(self, name, options, *choices)

    put(Benchmarks, "_resolved", wrong)
