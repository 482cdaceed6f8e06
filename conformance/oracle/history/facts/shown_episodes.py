"""The episodes of a run as lists, turns, results and events show them.

A result never changes and never disappears; an attempt and a count of faults only grow.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any

from conformance.oracle.history.facts.seen_exchange import (
    Difference,
    SeenExchange,
    is_same,
    name_of_difference,
)

# Members of an episode that are the same wherever it is shown, with their rules.
_CONSTANTS = {
    "episode_id": ("RUN-024",),
    "task": ("CAL-001", "RUN-024"),
    "split": ("CAL-001", "RUN-024"),
    "max_steps": ("EPI-013",),
    "seed": ("SEAL-001", "BEN-005"),
}
_SHARED_WITH_RESULT = ("episode_id", "index", "task", "split", "attempt", "faults")


@dataclass
class ShownEpisodes:
    """The episodes of one run; `rules_of_loss` names the rules that keep a result.

    counts_attempts: whether the server announces `sessions`, which counts attempts.
    """

    rules_of_loss: Callable[[SeenExchange], tuple[str, ...]]
    is_calibration: bool = False
    max_attempts: int | None = None
    counts_attempts: bool = True
    results: dict[int, tuple[Mapping[str, Any], SeenExchange]] = field(
        default_factory=dict
    )
    _constants: dict[tuple[int, str], tuple[Any, SeenExchange]] = field(
        default_factory=dict
    )
    _index_of: dict[str, tuple[int, SeenExchange]] = field(default_factory=dict)
    _grown: dict[tuple[int, str], list[tuple[int, SeenExchange]]] = field(
        default_factory=dict
    )

    def judge_shown(
        self, episode: Mapping[str, Any], seen: SeenExchange
    ) -> Iterator[Difference]:
        """Judge what a turn or a list says of an episode, but for its result."""
        index = episode["index"]
        for name, rules in _CONSTANTS.items():
            if name in episode:
                yield from self._constant(index, name, episode[name], rules, seen)
        owner, witness = self._index_of.setdefault(episode["episode_id"], (index, seen))
        if owner != index:
            text = f"another episode_id than that of episode {owner}"
            observed = f"episode {index} has it, too: {episode['episode_id']}"
            yield Difference(("RUN-024",), text, observed, seen, witness)
        for name in ("attempt", "faults"):
            if name in episode:
                yield from self._growth(index, name, episode[name], seen)
        attempt = episode["attempt"]
        if self.max_attempts is not None and attempt > self.max_attempts:
            text = f"attempt of at most {self.max_attempts} (max_attempts)"
            observed = f"attempt {attempt} of episode {index}"
            yield Difference(("EPI-004",), text, observed, seen)

    def judge_listed(
        self, item: Mapping[str, Any], seen: SeenExchange
    ) -> Iterator[Difference]:
        """Judge an item of `list_episodes` or the episode of an event."""
        yield from self.judge_shown(item, seen)
        index, result = item["index"], item.get("result")
        if (result is not None) != (item["status"] == "scored"):
            text = "a result exactly of an episode that is `scored`"
            observed = f"episode {index}: status {item['status']}, result {result}"
            yield Difference(("EPI-006", "EPI-005"), text, observed, seen)
        if result is None:
            fact = self.results.get(index)
            if fact is not None and fact[1].is_surely_before(seen):
                text = f"episode {index} with its result {dict(fact[0])}"
                observed = f"status {item['status']} and no result"
                rules = self.rules_of_loss(fact[1])
                yield Difference(rules, text, observed, seen, fact[1])
            return
        for name in _SHARED_WITH_RESULT:
            if result[name] != item[name]:
                rules = ("FAULT-009",) if name == "faults" else ("EPI-010", "RUN-024")
                text = f"`{name}` {result[name]!r} as in the result"
                observed = f"`{name}` {item[name]!r} of episode {index}"
                yield Difference(rules, text, observed, seen)
        yield from self.judge_result(result, seen)

    def judge_result(
        self, result: Mapping[str, Any], seen: SeenExchange
    ) -> Iterator[Difference]:
        """Judge the result of an episode, which never changes."""
        index = result["index"]
        first, witness = self.results.setdefault(index, (result, seen))
        if not is_same(first, result):
            name = name_of_difference(first, result)
            is_id = name == "episode_id"
            rules = ("RUN-024",) if is_id else self.rules_of_loss(witness)
            text = f"the result of episode {index} with `{name}` {first.get(name)!r}"
            observed = f"`{name}` {result.get(name)!r}"
            yield Difference(rules, text, observed, seen, witness)
        yield from self.judge_shown(result, seen)
        yield from _faults_inside(result, seen, self.is_calibration)

    def _constant(
        self,
        index: int,
        name: str,
        value: Any,
        rules: tuple[str, ...],
        seen: SeenExchange,
    ) -> Iterator[Difference]:
        first, witness = self._constants.setdefault((index, name), (value, seen))
        if first != value:
            text = f"`{name}` {first!r} of episode {index} as before"
            yield Difference(rules, text, f"`{name}` {value!r}", seen, witness)

    def _growth(
        self, index: int, name: str, value: int, seen: SeenExchange
    ) -> Iterator[Difference]:
        """Judge a number that never becomes smaller."""
        if seen.operation == "stream_events":
            return  # an event may come late
        grown = self._grown.setdefault((index, name), [])
        for earlier, witness in reversed(grown):
            if earlier > value and witness.is_surely_before(seen):
                rules = ("EPI-003", "CRASH-004")
                rules = ("FAULT-009", "CRASH-004") if name == "faults" else rules
                text = f"`{name}` of at least {earlier} of episode {index}"
                yield Difference(rules, text, f"`{name}` {value}", seen, witness)
                return
        if not grown or value > grown[-1][0]:
            grown.append((value, seen))


def _faults_inside(
    result: Mapping[str, Any], seen: SeenExchange, is_calibration: bool
) -> Iterator[Difference]:
    """Give the contradictions inside of one result."""
    outcome, score = result["outcome"], result["score"]
    ends = (result["terminated"], result["truncated"])
    shown = (
        f"episode {result['index']}: outcome {outcome}, score {score}, terminated "
        f"{ends[0]}, truncated {ends[1]}, steps {result['steps']}"
    )
    if outcome == "abandoned":
        if any(ends):
            text = "an abandoned episode neither terminated nor truncated"
            yield Difference(("EPI-010",), text, shown, seen)
        if score != 0:
            text = "score 0 of an abandoned episode"
            yield Difference(("SCORE-004", "EPI-004"), text, shown, seen)
        return
    if sum(ends) != 1:
        text = "a result either terminated or truncated"
        yield Difference(("PRED-020",), text, shown, seen)
    is_own_score = result["task"] == "score"
    if is_calibration and not is_own_score and score != (outcome == "success"):
        text = "score 1 of a success and 0 of a failure"
        yield Difference(("CAL-011",), text, shown, seen)
