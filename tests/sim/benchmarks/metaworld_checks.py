"""Tests that need Meta-World's own MuJoCo: `make metaworld-check`, in .venv-metaworld.

Not part of `make test`, whose environment has another MuJoCo. All fifty tasks with ten
seeds are compared by `make metaworld-table`; here are a few, and the reasons.
"""

import signal
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from reference_client import evaluate
from reference_sim.benchmarks.metaworld.world import SeededTask, expert
from reference_sim.gymnasium import registration
from reference_sim.gymnasium.benchmark_file import Benchmark, read
from tests.support.servers import TOKENS, ReferenceServer
from tools.measurements.both_ways.metaworld import COMPARED
from tools.measurements.both_ways.play import (
    differing,
    max_steps_of,
    play_by_protocol,
    play_directly,
)

TASKS = ("reach-v3", "button-press-topdown-v3", "drawer-close-v3", "peg-insert-side-v3")
FEW = """
made_by = "reference_sim.benchmarks.metaworld.world:SeededTask"
max_steps = 500
camera = false
"""
TASK = """
[[tasks]]
name = "{0}"
instruction = "{1}"
kwargs = {{ task = "{0}" }}
"""


def examine_benchmark(reference: str, **members: object) -> tuple[list[str], list[str]]:
    """Faults and warnings."""
    ((benchmark, folder),) = read(reference)
    content = benchmark.model_dump(exclude_unset=True) | members
    found = registration.examine(Benchmark.model_validate(content), folder, print)
    return found["faults"], found["warnings"]


# --- the seed ---


def test_the_check_reports_that_meta_world_ignores_the_seed() -> None:
    faults, _ = examine_benchmark(
        "gymnasium:metaworld:Meta-World/MT1",
        kwargs={"env_name": "reach-v3"},
        camera=False,
    )
    (fault,) = faults
    assert "reset(seed=20) is not deterministic (the observation" in fault


def test_the_check_warns_when_every_seed_gives_the_same_episode(tmp_path: Path) -> None:
    (tmp_path / "raw.py").write_text(
        "from metaworld.env_dict import ALL_V3_ENVIRONMENTS_GOAL_OBSERVABLE as ALL\n"
        "Reach = ALL['reach-v3-goal-observable']\n"
    )
    faults, warnings = examine_benchmark(f"{tmp_path}/raw.py:Reach", camera=False)
    assert faults == []
    assert "task reach: every seed gives the same episode" in warnings


@pytest.mark.parametrize("task", TASKS)
def test_a_seed_gives_the_same_episode_after_other_episodes(task: str) -> None:
    def play(world: SeededTask, seed: int) -> list[bytes]:
        observation, _ = world.reset(seed=seed)
        seen, policy = [observation.tobytes()], expert(task)
        for _ in range(60):
            action = np.clip(policy.get_action(observation), -1, 1).astype(np.float32)
            observation, reward, *_ = world.step(action)
            seen.append(observation.tobytes() + np.float64(reward).tobytes())
        return seen

    fresh, used = SeededTask(task), SeededTask(task)
    play(used, 4)
    assert play(used, 3) == play(fresh, 3)
    assert play(used, 5)[0] != play(used, 3)[0]


# --- through the protocol ---


@pytest.mark.slow("starts a server")
def test_experts_score_the_same_directly_and_by_the_protocol(tmp_path: Path) -> None:
    """Four tasks, two seeds each. Expect every episode to agree, step by step."""
    ((benchmark, _),) = read("metaworld_mt50")
    text = FEW + '[[splits]]\nname = "few"\nepisodes = 2\n'
    for task in benchmark.tasks:
        if task.name in TASKS:
            text += TASK.format(task.name, task.instruction)
    (tmp_path / "few.toml").write_text(text)
    few = COMPARED._replace(file=tmp_path / "few.toml", benchmark_id="few", split="few")
    served = play_by_protocol(few)
    assert set(served.outcomes) == {(task, seed) for task in TASKS for seed in (0, 1)}
    direct = play_directly(few, sorted(served.outcomes), max_steps_of(few))
    assert differing(direct, served) == []
    ((described, folder),) = read(str(few.file))
    manifest = registration.examine(described, folder, print)["manifest"]
    assert manifest["simulator"]["packages"]["mujoco"] == "3.3.0"
    assert manifest["success_rule"] == "any_step"


class Reacher:
    """Moves the gripper towards the goal."""

    def reset(self, instruction: str) -> None:
        pass

    def act(self, observation):  # type: ignore[no-untyped-def]
        state = {name: np.array(v) for name, v in observation.state.items()}
        assert observation.images["render"].shape == (480, 480, 3)
        move = 10 * (state["desired_goal"] - state["achieved_goal"])
        return [{"action": [*np.clip(move, -1, 1), 0.0]}]


def test_gymnasium_robotics_is_served_with_its_camera(tmp_path: Path) -> None:
    reference = "gymnasium:gymnasium_robotics:FetchReach-v4"
    server = ReferenceServer(tmp_path, PROCTOR_BENCHMARKS=reference)
    try:
        place: dict[str, Any] = {"url": server.url, "token": TOKENS["alice"]}
        score = evaluate(Reacher, benchmark="fetchreach_v4", **place)
    finally:
        server.end(signal.SIGKILL)
    assert score.score == 1.0


@pytest.mark.parametrize(
    "environment", ["FetchPickAndPlace-v4", "AdroitHandDoor-v1", "HandReach-v3"]
)
def test_gymnasium_robotics_passes_the_check(environment: str) -> None:
    reference = f"gymnasium:gymnasium_robotics:{environment}"
    assert examine_benchmark(reference, camera=False)[0] == []
