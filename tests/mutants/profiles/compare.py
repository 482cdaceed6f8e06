"""Mutants of comparisons: what stands beside what, and what it is called."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

from reference_server.http.dispatch import OperationCall
from reference_server.http.handlers import Handlers
from reference_server.rules import comparison
from reference_server.rules.refusal import Refused
from reference_server.views import run_views
from tests.mutants import Json, instead_of, mutant, put

Entry = Json


def change_entry(change: Callable[[Entry, Any, Any], None]) -> None:
    """Let `change(entry, baseline, run)` spoil every comparison with a baseline."""
    right: Any = comparison.compare

    def wrong(baseline: Any, run: Any, tolerance: float) -> Any:
        entry = right(baseline, run, tolerance)
        change(entry, baseline, run)
        return entry

    put(comparison, "compare", wrong)


@mutant("CMP-001", through=instead_of(run_views, "comparison_view"))
def sorts_compared_runs(right: Any, *arguments: Any) -> Any:
    """A client that compares three runs assigns the numbers to the wrong runs."""
    body = right(*arguments)
    return body | {"runs": sorted(body["runs"], key=lambda e: str(e["run_id"]))}


@mutant("CMP-002", through=change_entry)
def counts_unscored_episodes_as_pairs(entry: Entry, _baseline: Any, run: Any) -> None:
    """A difference over three episodes looks like one over a hundred."""
    entry["paired"] = len(run)


@mutant("CMP-003", through=change_entry)
def calls_a_comparison_with_half_a_baseline_complete(
    entry: Entry, _baseline: Any, run: Any
) -> None:
    """A verdict on a partial baseline is published as final."""
    entry["complete"] = all(e.outcome is not None for e in run)


@mutant("CMP-004", through=change_entry)
def subtracts_the_baseline(entry: Entry, _baseline: Any, _run: Any) -> None:
    """A policy that got worse is reported as better."""
    if entry["difference"] is not None:
        entry["difference"] = -entry["difference"]


@mutant("CMP-007", through=instead_of(comparison, "sign_test"))
def approximates_the_p_value(_right: Any, wins: int, losses: int) -> Any:
    """A p-value is too small for few episodes."""
    if wins + losses == 0:
        return 1.0
    chi_squared = (wins - losses) ** 2 / (wins + losses)
    return math.erfc(math.sqrt(chi_squared / 2))


@mutant("CMP-008", through=instead_of(comparison, "is_within"))
def compares_only_the_whole_with_the_tolerance(
    right: Any, groups: Any, tolerance: float
) -> Any:
    """A policy that lost one task and gained another is released."""
    return right(groups[:1], tolerance)


@mutant("CMP-009")
def compares_different_manifests() -> None:
    """Results of different episodes are subtracted from each other."""
    put(comparison, "manifest_mismatch", lambda _runs: None)
    put(comparison, "_pairs", lambda baseline, run: list(_scored(baseline, run)))


def _scored(baseline: Any, run: Any) -> Any:
    for base, compared in zip(baseline, run, strict=False):
        if base.outcome is not None and compared.outcome is not None:
            yield base, compared


@mutant("CMP-011", through=instead_of(Handlers, "compare_runs"))
async def refuses_to_compare_queued_runs(
    right: Any, self: Handlers, call: OperationCall
) -> Any:
    """A table of all runs breaks as soon as one of them is queued."""
    for run_id in call.query["runs"].split(","):
        run = await self.service.registry.get(run_id, call.account)
        if run.state == "queued" and run.submission["options"].get("queue_s"):
            raise Refused("illegal_transition", "The run is queued.")
    return await right(self, call)


@mutant("CMP-012", through=instead_of(run_views, "comparison_view"))
def shows_the_default_tolerance(right: Any, *arguments: Any) -> Any:
    """A table says that a verdict is stricter than it is."""
    return right(*arguments) | {"tolerance": comparison.TOLERANCE}


@mutant(
    *("CMP-005", "CMP-006", "CMP-007"),
    through=instead_of(run_views, "scored_episodes"),
)
def pairs_episodes_in_the_order_of_scoring(right: Any, episodes: Any) -> Any:
    """With two workers, episodes are compared with others than themselves."""
    return right(sorted(episodes, key=lambda e: e.place or math.inf))
