"""Mutants of comparisons: what stands beside what, and what it is called."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

from starlette.responses import Response

from reference_server.http import auth
from reference_server.http.dispatch import OperationCall
from reference_server.http.handlers import Handlers
from reference_server.rules import comparison
from reference_server.rules.refusal import Refused
from reference_server.views import run_views
from tests.mutants import mutant, put

Entry = dict[str, Any]


def change_entry(change: Callable[[Entry, Any, Any], None]) -> None:
    """Let `change(entry, baseline, run)` spoil every comparison with a baseline."""
    right = comparison.compare

    def wrong(baseline: Any, run: Any, tolerance: float) -> Entry:
        entry = right(baseline, run, tolerance)
        change(entry, baseline, run)
        return entry

    put(comparison, "compare", wrong)


@mutant("CMP-001")
def sorts_compared_runs() -> None:
    """A client that compares three runs assigns the numbers to the wrong runs."""
    right = run_views.comparison_view

    def wrong(*arguments: Any) -> dict[str, Any]:
        body = right(*arguments)
        return body | {"runs": sorted(body["runs"], key=lambda e: str(e["run_id"]))}

    put(run_views, "comparison_view", wrong)


@mutant("CMP-002")
def counts_unscored_episodes_as_pairs() -> None:
    """A difference over three episodes looks like one over a hundred."""
    change_entry(lambda entry, _, run: entry.update(paired=len(run)))


@mutant("CMP-003")
def calls_a_comparison_with_half_a_baseline_complete() -> None:
    """A verdict on a partial baseline is published as final."""

    def wrong(entry: Entry, _baseline: Any, run: Any) -> None:
        entry["complete"] = all(e.outcome is not None for e in run)

    change_entry(wrong)


@mutant("CMP-004")
def subtracts_the_baseline() -> None:
    """A policy that got worse is reported as better."""

    def wrong(entry: Entry, _baseline: Any, _run: Any) -> None:
        if entry["difference"] is not None:
            entry["difference"] = -entry["difference"]

    change_entry(wrong)


@mutant("CMP-005")
def leaves_out_tasks_without_a_pair() -> None:
    """A task without any compared episode goes unnoticed."""

    def wrong(entry: Entry, _baseline: Any, _run: Any) -> None:
        tasks = entry["by_task"].items()
        entry["by_task"] = {task: group for task, group in tasks if group["paired"]}

    change_entry(wrong)


@mutant("CMP-006")
def counts_a_success_of_both_as_a_win() -> None:
    """A policy that is only as good as the baseline seems better."""

    def wrong(entry: Entry, baseline: Any, run: Any) -> None:
        both = sum(
            {base.outcome, one.outcome} == {"success"}
            for base, one in zip(baseline, run, strict=True)
        )
        entry["wins"] += both
        entry["ties"] -= both

    change_entry(wrong)


@mutant("CMP-007")
def approximates_the_p_value() -> None:
    """A p-value is too small for few episodes."""

    def wrong(wins: int, losses: int) -> float:
        if wins + losses == 0:
            return 1.0
        chi_squared = (wins - losses) ** 2 / (wins + losses)
        return math.erfc(math.sqrt(chi_squared / 2))

    put(comparison, "mcnemar", wrong)


@mutant("CMP-008")
def compares_only_the_whole_with_the_tolerance() -> None:
    """A policy that lost one task and gained another is released."""
    right = comparison.is_within
    put(comparison, "is_within", lambda groups, limit: right(groups[:1], limit))


@mutant("CMP-008")
def releases_whatever_is_better() -> None:
    """A chip with other answers passes for one with the same."""

    def wrong(groups: Any, tolerance: float) -> bool:
        return all(group["difference"] <= tolerance + 1e-9 for group in groups)

    put(comparison, "is_within", wrong)


@mutant("CMP-009")
def compares_different_manifests() -> None:
    """Results of different episodes are subtracted from each other."""
    put(comparison, "manifest_mismatch", lambda _runs: None)
    put(comparison, "_pairs", lambda baseline, run: list(_scored(baseline, run)))


def _scored(baseline: Any, run: Any) -> Any:
    for base, one in zip(baseline, run, strict=False):
        if base.outcome is not None and one.outcome is not None:
            yield base, one


@mutant("CMP-010")
def compares_runs_of_any_account() -> None:
    """An account that knows run ids can read scores of other accounts."""
    right = Handlers.compare_runs

    async def wrong(self: Handlers, call: OperationCall) -> Response:
        run = await self.service.registry.get(call.query["baseline"])
        call.caller = auth.Caller(run.account, auth.SCOPES)
        return await right(self, call)

    put(Handlers, "compare_runs", wrong)


@mutant("CMP-011")
def refuses_to_compare_queued_runs() -> None:
    """A table of all runs breaks as soon as one of them is queued."""
    right = Handlers.compare_runs

    async def wrong(self: Handlers, call: OperationCall) -> Response:
        for run_id in call.query["runs"].split(","):
            run = await self.service.registry.get(run_id, call.account)
            if run.state == "queued" and run.submission["options"].get("queue_s"):
                raise Refused("illegal_transition", "The run is queued.")
        return await right(self, call)

    put(Handlers, "compare_runs", wrong)
