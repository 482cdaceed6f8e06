"""A comparison beside what was asked for, and beside the results shown before it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from conformance.oracle.expected_comparison import expected_comparison
from conformance.oracle.expected_score import is_close
from conformance.oracle.history.facts.run_knowledge import RunKnowledge
from conformance.oracle.history.facts.seen_exchange import Difference, SeenExchange
from conformance.oracle.history.facts.seen_session import SeenSession

_TOLERANCE = 0.05  # where the request has none
_MEANS = ("baseline_mean", "mean", "difference")
_RULES = {
    "paired": "CMP-002",
    "complete": "CMP-003",
    **dict.fromkeys(_MEANS, "CMP-004"),
    **dict.fromkeys(("wins", "losses", "ties"), "CMP-006"),
    "p_value": "CMP-007",
    "release": "CMP-008",
}


def judge_comparison(
    runs: Mapping[str, RunKnowledge], seen: SeenExchange
) -> Iterator[Difference]:
    """Judge the answer of `compare_runs`; `runs` are those that are known."""
    base, named = runs.get(seen.query["baseline"]), seen.query["runs"].split(",")
    shown = [entry["run_id"] for entry in seen.value["runs"]]
    if shown != named:
        text = f"entries of {', '.join(named)}"
        yield Difference(("CMP-001",), text, ", ".join(shown), seen)
    if base is None:
        return
    base.exercised.update(("CMP-001", "CMP-012"))
    tolerance = float(seen.query.get("tolerance", _TOLERANCE))
    latest = base.views.latest()
    due = {name: latest[name] for name in ("benchmark_id", "manifest_sha256")}
    for name, value in (
        due | {"baseline": base.run_id, "tolerance": tolerance}
    ).items():
        if seen.value[name] != value:
            observed = f"`{name}` {seen.value[name]!r}"
            yield Difference(("CMP-012",), f"`{name}` {value!r}", observed, seen)
    episodes = _known_episodes(base, seen)
    for entry in seen.value["runs"]:
        run = runs.get(entry["run_id"])
        others = None if run is None else _known_episodes(run, seen)
        if episodes is not None and others is not None:
            base.exercised.update((*_RULES.values(), "CMP-005"))
            expected = expected_comparison(episodes, others, tolerance)
            yield from _differences(entry, expected, seen)


def _known_episodes(
    run: RunKnowledge, seen: SeenExchange
) -> list[Mapping[str, Any]] | None:
    """Give the episodes of a run; None unless all its results are surely known."""
    results, sessions = run.episodes.results, run.sessions.values()
    is_sure = (
        bool(run.tasks)
        and not (run.is_partial or run.views.restarts or run.open)
        and all(witness.is_surely_before(seen) for _, witness in results.values())
        and all(run.is_settled(session, seen) for session in sessions)
        and not any(_may_be_abandoned(run, session) for session in sessions)
    )
    if not is_sure:
        return None
    return [
        results[index][0] if index in results else {"task": task, "outcome": None}
        for index, task in enumerate(run.tasks)
    ]


def _may_be_abandoned(run: RunKnowledge, session: SeenSession) -> bool:
    """Whether the end of a session may have given a result that was not shown."""
    episode = session.last.value.get("episode")
    if episode is None or episode["index"] in run.episodes.results:
        return False
    return bool(episode["step"]) and episode["attempt"] == run.episodes.max_attempts


def _differences(
    entry: Mapping[str, Any], expected: Mapping[str, Any], seen: SeenExchange
) -> Iterator[Difference]:
    groups, due = entry["by_task"], expected["by_task"]
    if sorted(groups) != sorted(due):
        text, observed = f"tasks {sorted(due)}", f"tasks {sorted(groups)}"
        yield Difference(("CMP-005",), text, observed, seen)
    for task in due.keys() & groups.keys():
        for name in ("paired", *_MEANS):
            yield from _difference("CMP-005", name, groups[task], due[task], seen)
    for name, rule in _RULES.items():
        yield from _difference(rule, name, entry, expected, seen)


def _difference(
    rule: str,
    name: str,
    shown: Mapping[str, Any],
    expected: Mapping[str, Any],
    seen: SeenExchange,
) -> Iterator[Difference]:
    """Compare one member; means and p-values within the tolerance of the rules."""
    value, due = shown[name], expected[name]
    is_number = name in (*_MEANS, "p_value")
    if not (is_close(value, due) if is_number else value == due):
        due = due if due is None or not is_number else float(due)
        yield Difference((rule,), f"`{name}` {due!r}", f"`{name}` {value!r}", seen)
