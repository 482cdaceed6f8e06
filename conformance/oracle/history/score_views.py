"""A score beside itself and beside the results that were shown before it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from conformance.oracle.expected_score import OUTCOMES, expected_score, is_close
from conformance.oracle.history.observation import Difference, Observation
from conformance.oracle.history.run_facts import RunFacts

_RULES = {
    "complete": ("SCORE-005",),
    "score": ("SCORE-006",),
    "score_low": ("SCORE-007",),
    "score_high": ("SCORE-007",),
    "counts": ("SCORE-008",),
    "mean": ("SCORE-009",),
    "success_rate": ("SCORE-009",),
    "success_interval": ("SCORE-012",),
    "mean_interval": ("SCORE-013",),
    "by_task": ("SCORE-011",),
    "by_split": ("SCORE-011",),
}
_SHARED_WITH_RUN = {
    "run_id": ("SCORE-014",),
    "benchmark_id": ("SCORE-014", "SCORE-010"),
    "manifest_sha256": ("SCORE-014", "SCORE-010"),
    "select": ("SUB-003",),
}


def judge_score(run: RunFacts, seen: Observation) -> Iterator[Difference]:
    """Judge a score: its run, its counts, and its numbers where all is known."""
    score, shown = seen.value, run.views.latest()
    for name, rules in _SHARED_WITH_RUN.items():
        if shown and score.get(name) != shown.get(name):
            text = f"`{name}` {shown.get(name)!r} as the run has it"
            yield Difference(rules, text, f"`{name}` {score.get(name)!r}", seen)
    counts = score["counts"]
    total = shown["progress"]["episodes_total"] if shown else counts["total"]
    outcomes = sum(counts[name] for name in (*OUTCOMES, "unscored"))
    if counts["total"] != total or outcomes != total:
        text = f"counts that add up to {total}"
        yield Difference(("SCORE-008",), text, f"{counts}", seen)
        return
    scored = total - counts["unscored"]
    facts = run.episodes.results
    before = [fact for fact in facts.values() if fact[1].is_surely_before(seen)]
    if len(before) > scored:
        text = f"{len(before)} scored episodes or more, which were shown before"
        witness = before[-1][1]
        rules = ("SCORE-008", *run.views.rules_of_loss(witness))
        yield Difference(rules, text, f"{counts}", seen, witness)
        return
    if len(before) == scored and (shown or not scored):
        yield from _numbers(total, [fact[0] for fact in before], seen)


def _numbers(
    total: int, results: list[Mapping[str, Any]], seen: Observation
) -> Iterator[Difference]:
    """Compare all numbers with those of the results, which are all that there are."""
    unscored = {"task": "", "split": "", "outcome": None, "score": 0.0}
    episodes = [*results, *[unscored] * (total - len(results))]
    due, score = expected_score(episodes), seen.value
    for name, rules in _RULES.items():
        if name in ("by_task", "by_split"):
            differs = _group_differs(due[name], score[name])
        elif name == "counts":
            differs = any(score[name].get(k) != v for k, v in due[name].items())
        elif name.endswith("_interval"):
            differs = not all(is_close(score[name][k], v) for k, v in due[name].items())
        elif name == "complete":
            differs = score[name] is not due[name]
        else:
            differs = not is_close(score[name], due[name])
        if differs:
            expected = f"`{name}` {_readable(due[name])} of {len(results)} results"
            yield Difference(rules, expected, f"`{name}` {score[name]}", seen)


def _group_differs(due: Mapping[str, Any], groups: Mapping[str, Any]) -> bool:
    """Whether a group has other means than its results; those unscored are unknown."""
    for key, group in due.items():
        if key == "":
            continue
        shown = groups.get(key)
        if shown is None:
            return True
        counts = [shown["counts"][n] != group["counts"][n] for n in OUTCOMES]
        means = [is_close(shown[n], group[n]) for n in ("mean", "success_rate")]
        if any(counts) or not all(means):
            return True
    return False


def _readable(value: Any) -> Any:
    """Write fractions as numbers."""
    if isinstance(value, dict):
        return {key: _readable(item) for key, item in value.items()}
    return value if isinstance(value, int | str | None) else float(value)
