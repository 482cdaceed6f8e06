"""What clients were answered, and what it has to agree with.

Each rule is checked when an answer is read, or at the end against what the simulators
executed. `wrong` collects sentences for people.
"""

from __future__ import annotations

import hashlib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import pytest

from conformance.oracle.expected_score import expected_score
from tests.simulation.world import World

# Of a repeated turn these may differ: the lease goes on, and so does the clock.
_OF_THE_ANSWER = ("lease", "timing")


@dataclass(slots=True)
class History:
    """known: results by run and episode. turns: by session and seq."""

    world: World
    known: dict[tuple[str, str], Mapping[str, Any]] = field(default_factory=dict)
    turns: dict[tuple[str, int], Mapping[str, Any]] = field(default_factory=dict)
    run_of_key: dict[str, str] = field(default_factory=dict)
    wrong: list[str] = field(default_factory=list)

    def note_submitted(self, key: str, run_id: str) -> None:
        """RUN-003: one key, one run."""
        if self.run_of_key.setdefault(key, run_id) != run_id:
            self.wrong.append(f"key {key} made {self.run_of_key[key]} and {run_id}")

    def note_turn(
        self, run_id: str, turn: Mapping[str, Any], sent: Sequence[float] = ()
    ) -> None:
        """PRED-002: one answer per session and seq; PRED-001: of what was executed.

        sent: the numbers of its actions, which the simulator gives back as rewards.
        """
        executed = turn["executed_steps"]
        if turn["rewards"] != list(sent[:executed]) or len(sent) < executed:
            self.wrong.append(f"actions {sent} were answered by {turn}")
        kept = {name: turn[name] for name in turn if name not in _OF_THE_ANSWER}
        place = turn["session_id"], turn["seq"]
        first = self.turns.setdefault(place, kept)
        if first != kept:
            self.wrong.append(f"turn {place} was {first}, then {kept}")
        if "episode_result" in turn:
            self.note_result(run_id, turn["episode_result"])

    def note_result(self, run_id: str, result: Mapping[str, Any]) -> None:
        """CRASH-001, EPI-005: a result that was shown never changes."""
        place = run_id, result["episode_id"]
        first = self.known.setdefault(place, dict(result))
        if first != result:
            self.wrong.append(f"result {place} was {first}, then {result}")

    def known_results(self, run_id: str) -> set[str]:
        """Episodes whose results were shown so far; a later answer has them all."""
        return {episode_id for of, episode_id in self.known if of == run_id}

    def note_episodes(
        self, run_id: str, known: set[str], episodes: list[dict[str, Any]]
    ) -> None:
        """known: what was shown before the request was sent."""
        scored = {e["episode_id"] for e in episodes if "result" in e}
        if missing := sorted(known - scored):
            self.wrong.append(f"{run_id} has no result of {missing} any more")
        for episode in episodes:
            if "result" in episode:
                self.note_result(run_id, episode["result"])

    def note_counts(
        self, run_id: str, known: set[str], view: Mapping[str, Any], max_workers: int
    ) -> None:
        """What a view of the run counts."""
        progress = view["progress"]
        if progress["episodes_scored"] < len(known):
            self.wrong.append(f"{run_id} counts fewer results than {sorted(known)}")
        parts = ("scored", "in_progress", "pending")
        if sum(progress[f"episodes_{p}"] for p in parts) != progress["episodes_total"]:
            self.wrong.append(f"{run_id} has progress {progress}")
        if view["live_workers"] > max_workers:
            self.wrong.append(f"{run_id} has {view['live_workers']} workers")

    # --- at the end ---

    def digest(self) -> str:
        """Of all answers, in the order in which they came."""
        answered = repr((self.run_of_key, list(self.turns.items()), self.known))
        return hashlib.sha256(answered.encode()).hexdigest()

    def check_executed(self) -> None:
        """No action was executed twice, however often its request came."""
        for number, times in self.world.executed.items():
            if len(times) > 1:
                self.wrong.append(f"action {number} was executed {len(times)} times")

    def check_results(self, run_id: str, episodes: list[dict[str, Any]]) -> None:
        """A result follows from the actions of one playing of its episode."""
        ends = {
            (one.score, self.world.steps_of_playing[one.playing])
            for times in self.world.executed.values()
            for one in times
            if one.ended
        }
        for episode in episodes:
            result = episode["result"]
            place = result["score"], result["steps"]
            if result["outcome"] != "abandoned" and place not in ends:
                self.wrong.append(f"{run_id}: no playing ended as {result} says")

    def check_score(
        self, run_id: str, score: Mapping[str, Any], episodes: list[dict[str, Any]]
    ) -> None:
        """SCORE-006: computed from the results that are shown."""
        expected = expected_score([e["result"] for e in episodes])
        for name in ("complete", "score", "counts"):
            if score[name] != pytest.approx(expected[name]):
                self.wrong.append(f"{run_id}: {name} {score[name]}: {expected[name]}")
