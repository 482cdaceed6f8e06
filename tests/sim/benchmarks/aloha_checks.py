"""Tests that need gym-aloha and its MuJoCo: `make aloha-check`, in .venv-aloha.

Not part of `make test`, whose environment has another MuJoCo. All episodes of the split
`practice` are compared by `python -m tools both-ways aloha`.
"""

import hashlib
import multiprocessing

import numpy as np
import pytest
from gym_aloha.constants import START_ARM_POSE

from reference_sim.gymnasium import registration
from reference_sim.gymnasium.benchmark_file import read
from reference_sim.gymnasium.simulator import GymnasiumSimulator
from tools.measurements.both_ways.aloha import COMPARED
from tools.measurements.both_ways.play import (
    differing,
    max_steps_of,
    play_by_protocol,
    play_directly,
)

START_ELBOW = START_ARM_POSE[2]
TASKS = ("transfer_cube", "insertion")


@pytest.fixture(scope="module")
def found() -> dict[str, object]:
    """The report of the check: faults, warnings, plan and manifest."""
    ((benchmark, folder),) = read(str(COMPARED.file))
    return registration.examine(benchmark, folder, print)


def digest_of(plan: dict[str, object], task: str, seed: int) -> str:
    """A digest of every observation and reward of a short episode."""
    simulator, digest = GymnasiumSimulator(plan), hashlib.sha256()
    rng = np.random.default_rng(3)
    simulator.reset(task, seed)
    start = simulator.observe().state["agent_pos"]
    for _ in range(5):
        digest.update(simulator.observe().images["pixels.top"].tobytes())
        digest.update(simulator.state_bytes())
        simulator.step({"action": (start + rng.uniform(-0.1, 0.1, 14)).tolist()})
    return digest.hexdigest()


def test_the_check_finds_no_fault(found: dict[str, object]) -> None:
    """Expect versions of what decides the physics, in the manifest."""
    assert (found["faults"], found["warnings"]) == ([], [])
    packages = found["manifest"]["simulator"]["packages"]  # type: ignore[index]
    assert packages["gym-aloha"] == "0.1.5"
    assert packages["dm-control"] == "1.0.28"
    assert packages["mujoco"] == "3.3.0"


@pytest.mark.parametrize("task", TASKS)
def test_two_processes_play_one_episode(found: dict[str, object], task: str) -> None:
    """The same seed, and another one. Expect equal pictures and states; not so."""
    arguments = [(found["plan"], task, seed) for seed in (4, 4, 5)]
    with multiprocessing.get_context("spawn").Pool(2, maxtasksperchild=1) as pool:
        one, again, other = pool.starmap(digest_of, arguments, chunksize=1)
    assert one == again != other


def test_angles_beyond_declared_bounds_are_executed(found: dict[str, object]) -> None:
    """Where the arms begin, an elbow is beyond 1, which gym-aloha declares as the most.
    Expect arms that are held there to stay there."""
    assert START_ELBOW > 1
    simulator = GymnasiumSimulator(found["plan"])  # type: ignore[arg-type]
    simulator.reset("transfer_cube", 0)
    start = simulator.observe().state["agent_pos"]
    for _ in range(20):
        simulator.step({"action": start.tolist()})
    elbow = simulator.observe().state["agent_pos"][2]
    assert elbow == pytest.approx(START_ELBOW, abs=0.02)


def test_arms_driven_too_hard_end_the_episode(found: dict[str, object]) -> None:
    """Targets from all over the bounds, by which the simulation diverges. Expect an end
    without success, and another episode after it."""
    simulator, rng = GymnasiumSimulator(found["plan"]), np.random.default_rng(3)  # type: ignore[arg-type]
    simulator.reset("transfer_cube", 4)
    (space,) = simulator.actions
    for _ in range(20):
        action = rng.uniform(space.low, space.high).tolist()
        outcome = simulator.step({"action": action})
        if outcome.terminated:
            break
    assert outcome.terminated
    assert not outcome.success
    simulator.reset("transfer_cube", 5)
    assert not simulator.step({"action": action}).terminated


@pytest.mark.slow("starts a server")
def test_an_expert_plays_the_same_directly_and_by_the_protocol() -> None:
    """One episode from its pictures. Expect success, every observation to agree."""
    served = play_by_protocol(COMPARED, episodes=1)
    direct = play_directly(COMPARED, sorted(served.outcomes), max_steps_of(COMPARED))
    assert differing(direct, served) == []
    (outcome,) = served.outcomes.values()
    assert outcome.success
