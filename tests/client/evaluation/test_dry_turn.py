"""The turn before the submission: which observation, and which errors count."""

import copy
from typing import Any

import numpy as np
import pytest

from reference_client import Observation, ProctorError
from reference_client.command.exit_codes import message_of
from reference_client.evaluation.dry_turn import (
    NOTE,
    play_dry_turn,
    settle_doubt,
)
from reference_sim.vector_spaces import VectorPart, pose_parts, vector

BENCHMARK: Any = {
    "benchmark_id": "arm",
    "title": "An arm",
    "max_chunk": 2,
    "action_space": {"joints": {"size": 2, "out_of_range": "refuse", "unit": "rad"}},
    "image_sizes": [{"width": 8, "height": 6}, {"width": 80, "height": 60}],
    "observation_space": {
        "state": {
            "joints": {
                "size": 2,
                "parts": {
                    "all": VectorPart("all", 2, "joint_position", "rad").declare(0)
                },
                "minimum": [-1.0, 0.0],
                "maximum": [1.0, 4.0],
            },
            "pose": vector(*pose_parts("world"), minimum=[1] * 7, maximum=[3] * 7),
            "force": {"size": 3, "rotation": "none"},  # as earlier drafts had it
        },
        "images": {"front": {"channels": 3, "description": ""}},
        "tensors": {
            "depth": {"dtype": "float32", "shape": [6, 8], "description": ""},
            "later": {"dtype": "float8", "shape": [1], "description": ""},
        },
    },
}


class Recorder:
    """Keeps what it receives; `answer` is what `act` returns or raises."""

    def __init__(self, answer: Any = (0.0, 0.0)) -> None:
        self.answer = answer
        self.seen: list[Observation] = []

    def reset(self, instruction: str) -> None:
        self.instruction = instruction

    def act(self, observation: Observation) -> Any:
        self.seen.append(observation)
        if isinstance(self.answer, Exception):
            raise self.answer
        return self.answer


def test_the_observation_has_the_declared_names_and_shapes() -> None:
    policy = Recorder()
    play_dry_turn(policy, BENCHMARK)
    (seen,) = policy.seen
    assert {name: vector.tolist() for name, vector in seen.state.items()} == {
        "joints": [0.0, 2.0],
        "pose": [2.0, 2.0, 2.0, 1.0, 0.0, 0.0, 0.0],
        "force": [0.0, 0.0, 0.0],
    }
    assert seen.images["front"].shape == (6, 8, 3)
    assert seen.tensors["depth"].dtype == np.float32
    assert list(seen.tensors) == ["depth"]


@pytest.mark.parametrize(
    "error", [KeyError("x"), ValueError("shapes"), RuntimeError("sizes")]
)
def test_an_error_of_the_policy_is_raised_with_a_note(error: Exception) -> None:
    with pytest.raises(type(error)) as caught:
        play_dry_turn(Recorder(error), BENCHMARK)
    assert caught.value.__notes__ == [NOTE]


def test_actions_that_do_not_fit_are_refused() -> None:
    with pytest.raises(ProctorError, match=NOTE) as caught:
        play_dry_turn(Recorder([0.0, 0.0, 0.0]), BENCHMARK)
    assert "joints 2, or an array of 2" in caught.value.detail


@pytest.mark.parametrize(
    "answer",
    [ZeroDivisionError(), AssertionError(), [np.nan, 0.0]],
    ids=["arithmetic", "assertion", "not finite"],
)
def test_what_an_impossible_state_may_cause_proves_nothing(answer: Any) -> None:
    play_dry_turn(Recorder(answer), BENCHMARK)


CALM = " That is fine if it knows those of arm, which now follow."


def test_a_policy_of_certain_instructions_is_doubted() -> None:
    """Where runs count, it is refused before there is one."""

    class Choosy(Recorder):
        def reset(self, instruction: str) -> None:
            raise KeyError(instruction)

    policy, said = Choosy(), list[str]()
    doubt = play_dry_turn(policy, BENCHMARK)
    assert policy.seen == []
    assert doubt is not None
    assert "not take 'An arm', a made-up instruction: KeyError: 'An arm' (" in doubt
    settle_doubt(doubt, "arm", said.append, counts=False)
    assert [line.partition(doubt)[2] for line in said] == [CALM]
    with pytest.raises(ProctorError, match="no run was submitted") as refused:
        settle_doubt(doubt, "arm", said.append, counts=True)
    assert "repeat it with --no-dry-turn" in message_of(refused.value)
    settle_doubt(play_dry_turn(Recorder(), BENCHMARK), "arm", said.append, counts=True)
    assert len(said) == 1


def test_a_missing_name_is_answered_with_those_that_exist() -> None:
    policy = Recorder()
    play_dry_turn(policy, BENCHMARK)
    state = policy.seen[0].state
    with pytest.raises(KeyError, match=r"joint: .*state has joints, .* mean joints\?"):
        state["joint"]
    assert "joint" not in state
    assert copy.deepcopy(state)["joints"].tolist() == state["joints"].tolist()
