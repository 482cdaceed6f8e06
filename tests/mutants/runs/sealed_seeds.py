"""Mutants of seeds: which are shown, and what stands for those that are not."""

from __future__ import annotations

from typing import Any

from reference_server.rules.manifest import Manifest
from reference_server.rules.runs.run import Episode
from reference_server.runs.benchmarks import Benchmarks
from reference_server.storage.runs import rows
from tests.mutants import Json, instead_of, mutant
from tests.mutants.server_changes import (
    change_results,
)


@mutant("SEAL-002", through=change_results)
def shows_sealed_seeds(result: Json, episode: Episode) -> None:
    """Other participants can train on the test episodes of the first one."""
    result["seed"] = episode.seed


@mutant("SEAL-001", "SEAL-002", through=change_results)
def shows_no_seed_at_all(result: Json, _episode: Episode) -> None:
    """No user can replay an episode of a split that is open."""
    result.pop("seed", None)


@mutant("CRASH-003", through=instead_of(rows, "episode_of"))
def shows_sealed_seeds_of_stored_episodes(
    right: Any, manifest: Manifest, row: rows.EpisodeRow
) -> Any:
    """A participant has only to wait until the host starts its server again."""
    episode = right(manifest, row)
    episode.is_sealed = False
    return episode


@mutant("SEAL-003", through=instead_of(Benchmarks, "view"))
async def commits_to_no_seeds(right: Any, self: Benchmarks, benchmark_id: str) -> Any:
    """A host can choose the seeds after it has seen the policies."""
    shown = await right(self, benchmark_id)
    shown.pop("seeds_sha256", None)
    return shown
