"""One attempt at an episode: step count, truncation, success rule and score.

Pure: no clock, no encoding, no process. The score is the last one that the simulator
reported, except for tasks whose score is their success (`score_is_success`): their
score follows the success rule, which only this module knows.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from reference_record.contents.score import STAGE_TOLERANCE
from reference_sim.interface import (
    Action,
    Simulator,
    StepOutcome,
    WrongReport,
    number_of,
    stages_of,
    truth_of,
)

SUCCESS_RULES = ("any_step", "last_step")


class Episode:
    """An attempt from its reset to its end; the constructor resets the simulator."""

    def __init__(
        self,
        simulator: Simulator,
        task: str,
        seed: int,
        *,
        split: str = "",
        max_steps: int,
        success_rule: str,
        score_is_success: bool = False,
    ) -> None:
        """Raises TaskUnplayable, and everything that the simulator raises."""
        if success_rule not in SUCCESS_RULES:
            raise ValueError(f"no success rule {success_rule!r}")
        self._simulator, self._task = simulator, task
        self._max_steps = max_steps
        self._any_step = success_rule == "any_step"
        self._score_is_success = score_is_success
        self._score = 0.0
        self.steps = 0
        self.success = False
        self.terminated = False
        self.truncated = False
        self.stopped = ""
        self.instruction = simulator.reset(task, seed, split)
        # A score that is the success counts no stages.
        self.stages = () if score_is_success else stages_of(simulator)

    @property
    def ended(self) -> bool:
        return self.terminated or self.truncated

    @property
    def score(self) -> float:
        """In [0, 1]; 0 before the first step."""
        return float(self.success) if self._score_is_success else self._score

    def play(self, actions: Sequence[Action]) -> Iterator[float]:
        """Executes until the chunk or the episode ends, yielding each step's reward.

        PRED-001: actions in order. PRED-006: one by one, whatever the chunk.
        PRED-007: none after the end. PRED-021: one reward each. PHY-007: a stop of the
        robot ends the episode, and what it interrupted is not executed.
        """
        for action in actions:
            if self.ended:
                return
            outcome = self._simulator.step(action)
            if outcome.stopped:
                self.stopped, self.terminated = outcome.stopped, True
                return
            try:
                reward = number_of(outcome.reward, "reward")
                self._record(outcome)
            except WrongReport as wrong:
                place = f"in `step` {self.steps + 1} of {self._task}"
                raise WrongReport(f"{place}, {wrong}") from wrong
            yield reward

    def judge(self, success: bool, score: float) -> None:
        """End the episode with the judgement of a person, whatever was measured."""
        self._score_is_success = False
        self.success, self._score = success, score
        self.terminated = not self.truncated

    def _require_stages_counted(self, score: float, success: bool) -> None:
        """SIM-037: pages say by the score which stages were reached."""
        whole = len(self.stages) + 1
        reached = whole if success else min(round(score * whole), whole - 1)
        if abs(score - reached / whole) > STAGE_TOLERANCE:
            raise WrongReport(
                f"score {score:g} with success {success} does not count the stages "
                f"{', '.join(self.stages)}: it must be k/{whole} after the first k of "
                "them, and 1 when and only when the goal holds"
            )

    def _record(self, outcome: StepOutcome) -> None:
        success = truth_of(outcome.success, "success")
        terminated = truth_of(outcome.terminated, "terminated")
        score = number_of(outcome.score, "score")
        if not 0.0 <= score <= 1.0:  # SCORE-001
            raise WrongReport(f"score {score} is outside 0 … 1")
        if self.stages:
            self._require_stages_counted(score, success)
        self.steps += 1
        # SCORE-002: any_step keeps an earlier success. SCORE-003: last_step does not.
        held_before = self._any_step and self.success
        self.success = held_before or success
        self._score, self.terminated = score, terminated
        # PRED-020: a task that ends by itself at max_steps is not truncated.
        self.truncated = self.steps >= self._max_steps and not self.terminated
