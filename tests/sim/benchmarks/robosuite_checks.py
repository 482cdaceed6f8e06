"""Tests that need robosuite and its MuJoCo: `make robosuite-check`, in .venv-robosuite.

Not part of `make test`, whose environment has another MuJoCo. All episodes of the split
`practice` are compared by `python -m tools both-ways panda_lift`.
"""

import hashlib
import multiprocessing

import numpy as np
import pytest

from reference_sim.gymnasium import registration
from reference_sim.gymnasium.benchmark_file import read
from reference_sim.gymnasium.simulator import GymnasiumSimulator
from tools.measurements.both_ways.panda_lift import COMPARED
from tools.measurements.both_ways.play import (
    differing,
    max_steps_of,
    play_by_protocol,
    play_directly,
)


@pytest.fixture(scope="module")
def found() -> dict[str, object]:
    """The report of the check: faults, warnings, plan and manifest."""
    ((benchmark, folder),) = read(str(COMPARED.file))
    return registration.examine(benchmark, folder, print)


def digest_of(plan: dict[str, object], seed: int, before: int) -> str:
    """A digest of every observation and reward of a short episode, after others."""
    simulator, digest = GymnasiumSimulator(plan), hashlib.sha256()
    rng = np.random.default_rng(3)
    for other in range(before):
        simulator.reset("lift", 90 + other)
    simulator.reset("lift", seed)
    for _ in range(20):
        digest.update(simulator.state_bytes())
        simulator.step({"action": rng.uniform(-1, 1, 7).tolist()})
    return digest.hexdigest()


def test_the_check_finds_no_fault(found: dict[str, object]) -> None:
    """Expect versions of what decides the physics, in the manifest."""
    assert (found["faults"], found["warnings"]) == ([], [])
    packages = found["manifest"]["simulator"]["packages"]  # type: ignore[index]
    assert packages["robosuite"] == "1.5.2"
    assert packages["mujoco"] == "3.3.0"


@pytest.mark.slow("compiles numba in two processes")
def test_two_processes_play_one_episode(found: dict[str, object]) -> None:
    """The same seed, once after other episodes. Expect equal states; another seed
    gives others."""
    arguments = [(found["plan"], *more) for more in ((4, 0), (4, 2), (5, 0))]
    with multiprocessing.get_context("spawn").Pool(2, maxtasksperchild=1) as pool:
        one, again, other = pool.starmap(digest_of, arguments, chunksize=1)
    assert one == again != other


@pytest.mark.slow("starts a server")
def test_an_expert_plays_the_same_directly_and_by_the_protocol() -> None:
    """Two episodes. Expect success, and every observation to agree."""
    served = play_by_protocol(COMPARED, episodes=2)
    direct = play_directly(COMPARED, sorted(served.outcomes), max_steps_of(COMPARED))
    assert differing(direct, served) == []
    assert len(served.outcomes) == 2
    assert all(outcome.success for outcome in served.outcomes.values())
