"""A run beside the body of its `submit_run`: what was chosen, or its default."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from conformance.oracle.history.facts.run_knowledge import RunKnowledge
from conformance.oracle.history.facts.seen_exchange import (
    Difference,
    SeenExchange,
    is_same,
)

_MAX_STEPS = 10  # without the option
_CHOSEN = {
    "benchmark_id": "RUN-018",
    "max_workers": "RUN-018",
    "idle_timeout_s": "RUN-018",
    "any_policy": "ATR-005",
    "select": "SUB-003",
}


def judge_submitted(
    facts: RunKnowledge, body: Mapping[str, Any], seen: SeenExchange
) -> Iterator[Difference]:
    """Judge whether a run shows what was submitted."""
    submission = facts.submission
    if submission is None:
        return
    for name, rule in _CHOSEN.items():
        if name in submission and not is_same(body.get(name), submission[name]):
            text = f"`{name}` {submission[name]!r} as it was submitted"
            yield Difference((rule,), text, f"`{name}` {body.get(name)!r}", seen)
    for name in ("policy", "images"):
        shown = body.get(name) or {}
        for member, value in (submission.get(name) or {}).items():
            if not is_same(shown.get(member), value):
                text = f"`{name}.{member}` {value!r} as it was submitted"
                observed = f"`{name}.{member}` {shown.get(member)!r}"
                yield Difference(("RUN-018",), text, observed, seen)
    if facts.tasks:
        total = len(facts.tasks)
        shown = body["progress"]["episodes_total"]
        if shown != total:
            text = f"episodes_total {total}: one for each of `options.tasks`"
            yield Difference(("CAL-001",), text, f"episodes_total {shown}", seen)


def judge_episode(
    facts: RunKnowledge, episode: Mapping[str, Any], seen: SeenExchange
) -> Iterator[Difference]:
    """Judge task, split, seed and length of an episode of calibration."""
    tasks, index = facts.tasks, episode["index"]
    if not tasks:
        return
    result = episode.get("result") or episode
    split = ("even", "odd")[index % 2]
    due: dict[str, tuple[Any, str]] = {
        "task": (tasks[index] if index < len(tasks) else None, "CAL-001"),
        "split": (split, "CAL-001"),
        "seed": (index + 1000, "SEAL-001"),
        "max_steps": (facts.options.get("max_steps", _MAX_STEPS), "EPI-013"),
    }
    for name, (value, rule) in due.items():
        is_secret = name == "seed" and facts.options.get("sealed") is True
        if name not in result or is_secret:
            continue
        facts.exercised[rule] += 1
        if not is_same(result[name], value):
            text = f"`{name}` {value!r} of episode {index}"
            yield Difference((rule,), text, f"`{name}` {result[name]!r}", seen)
