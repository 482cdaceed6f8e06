"""The turn that a chunk of `calibration` leads to, member by member.

The turn before and the actions decide it, whatever other workers do: calibration.md and
the rules of play.md on one turn. Only the episode that comes next is open.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from conformance.oracle.calibration_benchmark import ACTIONS, Vector

_ZEROS = {"vector": [0.0] * 8, "clipped": [0.0] * 2}
_REWARD_TOLERANCE = 1e-9  # stated by ATR-006
ABSENT = "(absent)"

Expectation = tuple[str, Any, tuple[str, ...]]


def is_valid_chunk(request: Mapping[str, Any], max_chunk: int) -> bool:
    """Whether a `predict` of calibration has nothing that may be refused as invalid."""
    actions = request.get("actions")
    # `observe` is unknown to a server without the profile observations.
    is_plain = request.keys() == {"session_id", "seq", "actions"}
    if not is_plain or not isinstance(actions, list):
        return False
    return 0 < len(actions) <= max_chunk and all(map(_is_valid, actions))


def _is_valid(action: Any) -> bool:
    values = action.get("values") if isinstance(action, dict) else None
    if not isinstance(values, dict) or len(action) > 1:
        return False
    return values.keys() == ACTIONS.keys() and all(
        isinstance(vector, list)
        and len(vector) == ACTIONS[name].size
        and all(_is_within(value, ACTIONS[name]) for value in vector)
        for name, vector in values.items()
    )


def _is_within(value: Any, space: Vector) -> bool:
    if not isinstance(value, int | float) or isinstance(value, bool):
        return False
    low, high = space.minimum, space.maximum
    if low is None or high is None or space.out_of_range == "clip":
        return abs(value) < 1e300
    return low <= value <= high


@dataclass(frozen=True, slots=True)
class PlayedActions:
    """The actions of an attempt since it last began at step 0."""

    steps: int = 0
    successes: tuple[bool, bool] = (False, False)  # of any step, of the last one
    score: float = 0.0  # the one that was commanded last
    rewards: tuple[float, float] = (0.0, 0.0)  # their sum, that of their magnitudes
    clipped_actions: int = 0
    vector: Sequence[float] = tuple(_ZEROS["vector"])
    clipped: Sequence[float] = tuple(_ZEROS["clipped"])

    def execute(self, values: Mapping[str, Sequence[float]]) -> PlayedActions:
        """Give the attempt after one more action."""
        is_success = values["success"][0] == 1
        score = values["score"][0]
        total, magnitude = self.rewards
        clipped = [min(1.0, max(-1.0, value)) for value in values["clipped"]]
        return PlayedActions(
            self.steps + 1,
            (self.successes[0] or is_success, is_success),
            score,
            (total + score, magnitude + abs(score)),
            self.clipped_actions + (clipped != list(values["clipped"])),
            tuple(values["vector"]),
            tuple(clipped),
        )

    def states(self) -> dict[str, list[float]]:
        """Give the states that an observation after these actions has."""
        return {
            "count": [self.steps],
            "vector": list(self.vector),
            "clipped": list(self.clipped),
        }


@dataclass(frozen=True, slots=True)
class PlayedChunk:
    """A chunk that was executed: its actions, and what they led to.

    before, after: None where earlier actions of the attempt are not known.
    """

    executed: Sequence[Mapping[str, Sequence[float]]]
    sent: int
    step: int  # after it
    is_fault: bool
    is_terminated: bool
    is_truncated: bool
    after: PlayedActions | None
    passed: Sequence[PlayedActions]  # after each action

    @property
    def is_end(self) -> bool:
        """Whether it ended the episode."""
        return self.is_terminated or self.is_truncated


def execute(
    before: PlayedActions | None, episode: Mapping[str, Any], actions: Sequence[Any]
) -> PlayedChunk:
    """Execute a chunk; `episode` is that of the turn before."""
    executed: list[Mapping[str, Sequence[float]]] = []
    step, task = episode["step"], episode["task"]
    played, passed = before, []
    is_terminated = is_truncated = False
    for action in actions:
        values = action["values"]
        if task == "fault" and values["fault"][0] >= 1:
            return PlayedChunk(
                [], len(actions), 0, True, False, False, PlayedActions(), []
            )
        executed.append(values)
        step += 1
        if played is not None:
            played = played.execute(values)
            passed.append(played)
        is_terminated = values["end"][0] == 1
        is_truncated = step == episode["max_steps"] and not is_terminated
        if is_terminated or is_truncated:
            break
    return PlayedChunk(
        executed,
        len(actions),
        step,
        False,
        is_terminated,
        is_truncated,
        played,
        passed,
    )


def expectations(
    chunk: PlayedChunk, episode: Mapping[str, Any], success_rule: str | None, turn: Any
) -> Iterator[Expectation]:
    """Give what a turn has to have: path, value, the rules that say so.

    A turn that does not end its episode at the shown `max_steps` breaks a rule on that
    number, whatever else differs by it.
    """
    goes_on = chunk.is_truncated and not turn["truncated"]
    for path, value, rules in _expectations(chunk, episode, success_rule, turn):
        yield path, value, ("PRED-020", "EPI-013") if goes_on else rules


def _expectations(
    chunk: PlayedChunk, episode: Mapping[str, Any], success_rule: str | None, turn: Any
) -> Iterator[Expectation]:
    count = len(chunk.executed)
    rules: tuple[str, ...] = ("PRED-001", "PRED-006", "PRED-007", "PRED-021")
    if len(turn["rewards"]) == count:  # the other sign of how much was executed
        rules = ("PRED-021", "PRED-001", "PRED-007")
    elif turn["executed_steps"] > count:
        rules = ("PRED-020" if chunk.is_truncated else "PRED-007", "PRED-001")
    rules = ("FAULT-012", *rules) if chunk.is_fault else rules
    yield "executed_steps", count, rules
    is_early = count < chunk.sent and not chunk.is_fault
    yield "stopped_early", is_early, ("PRED-028", "PRED-007")
    rules = ("PRED-020",) if chunk.is_truncated else ("CAL-005",)
    yield "terminated", chunk.is_terminated, rules
    yield "truncated", chunk.is_truncated, ("PRED-020",)
    rewards = [values["score"][0] for values in chunk.executed]
    yield "rewards.length", len(rewards), ("PRED-021", "FAULT-012")
    yield "rewards", rewards, ("CAL-008", "PRED-001", "PRED-006")
    if chunk.is_fault:
        yield "episode_result", ABSENT, ("FAULT-012", "FAULT-001")
        yield "fault.length", 1, ("FAULT-001", "CAL-009")
        yield "done", False, ("FAULT-001",)
    if not chunk.is_end:
        yield "episode_result", ABSENT, ("PRED-008", "CAL-005")
        yield "done", False, ("PRED-009",)
        rules = ("FAULT-001",) if chunk.is_fault else ("PRED-001", "FAULT-008")
        yield "episode.index", episode["index"], rules
        yield "episode.attempt", episode["attempt"], rules
        yield "episode.step", chunk.step, rules
        yield from expected_states("observation", chunk.after, chunk.step)
    else:
        yield from _result(chunk, episode, success_rule)
        if not turn["done"] and "episode" not in turn:
            yield "done", True, ("PRED-009", "PRED-008")
        elif not turn["done"]:
            yield "episode.step", 0, ("PRED-008",)
            yield from expected_states("observation", PlayedActions(), 0)


def expected_states(
    path: str, played: PlayedActions | None, step: int
) -> Iterator[Expectation]:
    """Give the states of an observation at a step."""
    yield f"{path}.state.count", [step], ("CAL-003", "PRED-001", "PRED-006")
    rules = ("CAL-007", "PRED-018", "PRED-001", "PRED-006")
    if played is not None:
        for name, value in played.states().items():
            yield f"{path}.state.{name}", value, rules


def expected_observations(chunk: PlayedChunk) -> Iterator[Expectation]:
    """Give the observations of a chunk that was sent with `observe` all."""
    count = 0 if chunk.is_fault else len(chunk.executed)
    yield "observations.length", count, ("PRED-012", "FAULT-012")
    first = chunk.step - count + 1
    for place in range(count):
        played = chunk.passed[place] if chunk.passed else None
        states = expected_states(f"observations.{place}", played, first + place)
        for path, value, rules in states:
            yield path, value, ("PRED-012", *rules)


def _result(
    chunk: PlayedChunk, episode: Mapping[str, Any], success_rule: str | None
) -> Iterator[Expectation]:
    yield "episode_result.index", episode["index"], ("PRED-008",)
    yield "episode_result.episode_id", episode["episode_id"], ("RUN-024",)
    yield "episode_result.attempt", episode["attempt"], ("PRED-008", "EPI-003")
    yield "episode_result.steps", chunk.step, ("EPI-012", "FAULT-008", "PRED-008")
    yield "episode_result.terminated", chunk.is_terminated, ("CAL-005",)
    yield "episode_result.truncated", chunk.is_truncated, ("PRED-020",)
    played = chunk.after
    last_score = chunk.executed[-1]["score"][0]
    if episode["task"] == "score":
        yield "episode_result.score", last_score, ("CAL-002",)
    if played is None or success_rule is None:
        return
    is_any = success_rule == "any_step"
    is_success = played.successes[0 if is_any else 1]
    rules = ("SCORE-002" if is_any else "SCORE-003", "EPI-012", "FAULT-008")
    outcome = "success" if is_success else "failure"
    yield "episode_result.outcome", outcome, rules
    if episode["task"] != "score":
        yield "episode_result.score", float(is_success), ("CAL-011", *rules)


def result_differences(
    result: Mapping[str, Any], played: PlayedActions
) -> Iterator[Expectation]:
    """Give what a result has wrong of the profile `attribution`."""
    total, magnitude = played.rewards
    shown = result.get("total_reward")
    if shown is not None and abs(shown - total) > _REWARD_TOLERANCE * magnitude:
        yield "episode_result.total_reward", total, ("ATR-006", "PRED-006")
    shown = result.get("clipped_actions")
    if shown is not None and shown != played.clipped_actions:
        yield "episode_result.clipped_actions", played.clipped_actions, ("ATR-004",)


def value_at(body: Any, path: str) -> Any:
    """Give the value at a path; ABSENT where there is none."""
    for name in path.split("."):
        if name == "length":
            return len(body) if isinstance(body, list) else int(body != ABSENT)
        if isinstance(body, list) and name.isdigit() and int(name) < len(body):
            body = body[int(name)]
        elif isinstance(body, dict) and name in body:
            body = body[name]
        else:
            body = ABSENT
    return body
