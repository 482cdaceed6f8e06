"""A score beside itself and beside the results that were shown before it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from conformance.oracle.expected_score import OUTCOMES, expected_score, is_close
from conformance.oracle.history.facts.run_knowledge import RunKnowledge
from conformance.oracle.history.facts.seen_exchange import Difference, SeenExchange

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


def judge_score(run: RunKnowledge, seen: SeenExchange) -> Iterator[Difference]:
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
        yield from _numbers(run, total, seen)


def _numbers(run: RunKnowledge, total: int, seen: SeenExchange) -> Iterator[Difference]:
    """Compare all numbers with those of the results, which are all that there are."""
    known = {
        index: result
        for index, (result, witness) in run.episodes.results.items()
        if witness.is_surely_before(seen)
    }
    tasks = run.tasks or [""] * total
    unscored = [
        {"task": tasks[index], "split": ("even", "odd")[index % 2], "outcome": None}
        for index in range(total)
    ]
    episodes = [known.get(index, unscored[index]) for index in range(total)]
    due, score = expected_score(episodes), seen.value
    for name, rules in _RULES.items():
        run.exercised.update(rules)
        if name in ("by_task", "by_split"):
            differs = _groups_differ(due[name], score[name], is_whole=bool(run.tasks))
        elif name == "counts":
            differs = any(score[name].get(k) != v for k, v in due[name].items())
        elif name.endswith("_interval"):
            differs = not all(is_close(score[name][k], v) for k, v in due[name].items())
        elif name == "complete":
            differs = score[name] is not due[name]
        else:
            differs = not is_close(score[name], due[name])
        if differs:
            expected = f"`{name}` {_readable(due[name])} of {len(known)} results"
            yield Difference(rules, expected, f"`{name}` {score[name]}", seen)


def _groups_differ(
    due: Mapping[str, Any], groups: Mapping[str, Any], *, is_whole: bool
) -> bool:
    """Whether groups have other numbers; `is_whole`: all episodes are known."""
    if is_whole and due.keys() != groups.keys():
        return True
    for key in due.keys() & groups.keys() if not is_whole else due:
        counts, shown = due[key]["counts"], groups[key]
        names = counts if is_whole else OUTCOMES
        means = [is_close(shown[n], due[key][n]) for n in ("mean", "success_rate")]
        if any(shown["counts"][n] != counts[n] for n in names) or not all(means):
            return True
    return False


def _readable(value: Any) -> Any:
    """Write fractions as numbers."""
    if isinstance(value, dict):
        return {key: _readable(item) for key, item in value.items()}
    return value if isinstance(value, int | str | None) else float(value)
