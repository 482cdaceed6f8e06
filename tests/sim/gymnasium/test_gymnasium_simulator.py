"""Environments are played: as simulators, in processes of the pool, and by a client."""

import asyncio
import re
import signal
import tomllib
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from reference_client import Observation, evaluate
from reference_record.generated.answers import Benchmark as Manifest
from reference_sim import benchmark_registry
from reference_sim.benchmark_registry import SimulatorConfig
from reference_sim.gymnasium import registration
from reference_sim.gymnasium.benchmark_file import Benchmark
from reference_sim.gymnasium.check import BenchmarkCheck
from reference_sim.gymnasium.simulator import GymnasiumSimulator
from reference_sim.interface import TaskUnplayable
from reference_sim.process.observation_encoding import EncodedObservation
from reference_sim.process.pool import (
    Begin,
    SimulatorFault,
    SimulatorHandle,
    SimulatorPool,
)
from tests.support.paths import ROOT
from tests.support.repository.answer_schemas import check_answer
from tests.support.servers import TOKENS, ReferenceServer
from tests.support.sim.shared_processes import opened_pool

EXAMPLES = ROOT / "examples" / "benchmarks"
CLASSICS = ("Acrobot-v1", "CartPole-v1", "MountainCarContinuous-v0", "Pendulum-v1")


def settings_of(world: str, **members: Any) -> dict[str, Any]:
    """Of a world of tests/support/sim/gymnasium_envs.py, as sent to its process."""
    made_by = f"gymnasium_envs.py:{world}"
    content = {"benchmark_id": "mine", "made_by": made_by} | members
    benchmark = Benchmark.model_validate(content)
    found = BenchmarkCheck(benchmark, ROOT / "tests" / "support" / "sim", print).run()
    assert found["faults"] == []
    definition = registration._definition(found)
    manifest = definition.describe({}, 8)
    return definition.settings({"codec": "raw", **manifest["image_sizes"][-1]})


def simulator_of(world: str, **members: Any) -> GymnasiumSimulator:
    simulator = registration.make(settings_of(world, **members))
    assert isinstance(simulator, GymnasiumSimulator)
    return simulator


# --- one simulator ---


def test_a_step_reports_what_the_environment_did() -> None:
    simulator = simulator_of("ValidEnv", ends_on_success=False)
    simulator.reset("mine", 3)
    start = simulator.observe().state["observation"][0]
    outcome = simulator.step({"action": [0.5]})
    assert outcome.reward == pytest.approx(start + 0.5)
    assert (outcome.success, outcome.terminated) == (start + 0.5 > 1, False)
    while not outcome.success:
        outcome = simulator.step({"action": [1.0]})
    assert (outcome.score, outcome.terminated) == (1.0, False)


def test_success_ends_the_episode_when_the_result_is_final() -> None:
    simulator = simulator_of("ValidEnv")
    simulator.reset("mine", 3)
    outcomes = [simulator.step({"action": [1.0]}) for _ in range(3)]
    assert (outcomes[-1].success, outcomes[-1].terminated) == (True, True)


@pytest.mark.parametrize(
    ("success", "steps"),
    [
        ({"reward_at_least": 3.0}, 4),
        ({"return_at_least": 3.0}, 3),
        ({"function": "gymnasium_envs.py:number_is_large"}, 3),
        ({"terminated": True}, None),
    ],
)
def test_success_follows_the_criterion_of_the_file(
    success: dict[str, Any], steps: int | None
) -> None:
    """The number begins at -0.83 and grows by one with each step."""
    simulator = simulator_of("ValidEnv", success=success)
    simulator.reset("mine", 3)
    assert simulator.observe().state["observation"][0] == pytest.approx(-0.83, abs=0.01)
    held = [simulator.step({"action": [1.0]}).success for _ in range(6)]
    assert (held.index(True) + 1 if any(held) else None) == steps


def test_a_score_may_be_the_return() -> None:
    score = {"return_from": -1.0, "return_to": 9.0}
    simulator = simulator_of("ValidEnv", score=score)
    simulator.reset("mine", 3)
    total, scores = 0.0, []
    for _ in range(6):
        outcome = simulator.step({"action": [1.0]})
        total += outcome.reward
        scores.append(outcome.score)
        assert outcome.score == pytest.approx(min(1.0, (total + 1) / 10))
    assert scores[-1] == 1.0


@pytest.mark.parametrize(("max_steps", "terminated"), [(5, False), (20, True)])
def test_truncation_by_the_environment_differs_from_the_step_limit(
    max_steps: int, terminated: bool
) -> None:
    members = {"max_steps": max_steps, "ends_on_success": False}
    simulator = simulator_of("TruncatesItself", **members)
    simulator.reset("mine", 3)
    ends = [simulator.step({"action": [0.0]}).terminated for _ in range(5)]
    assert ends == [False] * 4 + [terminated]


def test_tasks_set_the_constructor_arguments() -> None:
    tasks = [
        {"name": name, "instruction": f"Do {name}.", "kwargs": {"amount": amount}}
        for name, amount in (("near", 0.0), ("far", -10.0))
    ]
    simulator = simulator_of("ValidEnv", tasks=tasks)
    assert simulator.reset("near", 3) == "Do near."
    near = simulator.observe().state["observation"]
    assert simulator.reset("far", 3) == "Do far."
    assert simulator.observe().state["observation"] == pytest.approx(near - 10)
    with pytest.raises(TaskUnplayable, match="no task 'up'"):
        simulator.reset("up", 3)


def test_a_simulator_must_be_reset_first() -> None:
    with pytest.raises(RuntimeError, match="reset comes before"):
        simulator_of("ValidEnv").step({"action": [0.0]})


def test_all_kinds_of_spaces_are_played() -> None:
    """The environment asserts that the action is in its space, and echoes it."""
    simulator = simulator_of("HasAllSpaces", camera=False)
    simulator.reset("mine", 3)
    action: dict[str, list[float]] = {
        "arm.joints": [0.25, -9.0],
        "arm.gripper": [-1.0],
        "front": [7.0] * (12 * 16 * 3),
        "grey": [8.0] * (12 * 16),
        "small": [9.0] * (8 * 9 * 3),
        "grid": [0.5] * 6,
        "pair.0": [1.0, 4.0],
        "pair.1": [1.0, 0.0, 1.0],
    }
    simulator.step(action)
    seen = simulator.observe()
    assert {name: vector.tolist() for name, vector in seen.state.items()} == {
        "arm.joints": [0.25, -3.0],
        "arm.gripper": [-1.0],
        "pair.0": [1.0, 4.0],
        "pair.1": [1.0, 0.0, 1.0],
    }
    shapes = {name: pixels.shape for name, pixels in seen.images.items()}
    assert shapes == {"front": (12, 16, 3), "grey": (12, 16, 1)}
    assert (seen.images["grey"] == 8).all()
    assert seen.tensors["grid"].dtype == np.float32
    assert (seen.tensors["small"] == 9).all()


def test_a_picture_is_turned_and_scaled_as_the_file_says() -> None:
    ramp = np.arange(6 * 8 * 3, dtype=np.uint8).reshape(6, 8, 3)
    camera = {"name": "front", "upside_down": True}
    simulator = simulator_of("ValidEnv", camera=camera)
    simulator.reset("mine", 3)
    assert np.array_equal(simulator.observe().images["front"], ramp[::-1, ::-1])
    sizes = [{"width": 8, "height": 6}, {"width": 4, "height": 3}]
    simulator = simulator_of("ValidEnv", camera={"name": "front"}, image_sizes=sizes)
    simulator.reset("mine", 3)
    small = simulator.observe().images["front"]
    assert small.shape == (3, 4, 3)
    blocks = ramp.reshape(3, 2, 4, 2, 3).astype(float).mean(axis=(1, 3))
    assert np.abs(small - blocks).max() <= 1


def test_the_manifest_is_one_of_the_specification() -> None:
    for world in ("ValidEnv", "HasAllSpaces"):
        content = {"benchmark_id": "mine", "made_by": f"gymnasium_envs.py:{world}"}
        found = BenchmarkCheck(
            Benchmark.model_validate(content), ROOT / "tests" / "support" / "sim", print
        ).run()
        manifest = found["manifest"] | {
            "max_chunk": 8,
            "manifest_sha256": "0" * 64,
            "unavailable_reason": None,
        }
        known = {k: v for k, v in manifest.items() if k in Manifest.__annotations__}
        assert manifest.keys() - known.keys() == {"episodes"}
        members = {"name": "gymnasium", "version": known["simulator"]["version"]}
        check_answer("Benchmark", known | {"simulator": members})


# --- in processes ---


async def record_observations(
    pool: SimulatorPool, world: SimulatorConfig
) -> list[EncodedObservation]:
    """The observations of one episode in a process, for a fixed list of actions."""
    handle = await pool.acquire(world)
    task = world.settings["plan"]["tasks"][0]["name"]
    beginning = await begin(handle, task)
    actions = [{"action": [float(number % 2)]} for number in range(40)]
    played = await handle.play(actions, observe_all=True)
    assert played.observations is not None
    return [beginning, *played.observations]


async def begin(handle: SimulatorHandle, task: str) -> EncodedObservation:
    began = await handle.begin(Begin(task, 7, max_steps=100, success_rule="any_step"))
    return began.observation


@pytest.mark.parametrize("name", CLASSICS)
def test_two_processes_play_one_episode(
    name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(benchmark_registry, "_BENCHMARKS", {})
    content = {"benchmark_id": "mine", "environment": name, "camera": False}
    found = BenchmarkCheck(Benchmark.model_validate(content), ROOT, print).run()
    definition = registration._definition(found)
    images = {"codec": "raw", "width": 64, "height": 64}
    world = SimulatorConfig("mine", definition.settings(images))

    async def twice() -> list[list[EncodedObservation]]:
        async with opened_pool() as pool:
            return [await record_observations(pool, world) for _ in range(2)]

    one, other = asyncio.run(twice())
    assert one == other
    assert len(one) > 5
    assert one[0] != one[1]


async def test_an_environment_that_raises_is_a_fault_of_the_simulator() -> None:
    world = SimulatorConfig("mine", settings_of("RaisesLater", ends_on_success=False))
    still = [{"action": [0.0]}]
    async with opened_pool() as pool:
        handle = await pool.acquire(world)
        await begin(handle, "mine")
        played = await handle.play(still * 15, observe_all=False)
        assert (played.executed, played.ended) == (15, False)
        with pytest.raises(SimulatorFault, match="ValueError: the physics explode"):
            await handle.play(still, observe_all=False)
        again = await pool.acquire(world)
        await begin(again, "mine")  # a process of its own: nothing is left


# --- end to end ---


class CorridorPolicy:
    """Walks a corridor, and knows nothing else."""

    def reset(self, instruction: str) -> None:
        assert instruction == "Walk to the mark and stop there."

    def act(self, observation: Observation) -> Sequence[Mapping[str, Any]]:
        robot, mark = observation.state["observation"]
        return [{"action": [mark - robot]}, {"action": [0.0]}]


class CartPolePolicy:
    def reset(self, instruction: str) -> None:
        self.instruction = instruction

    def act(self, observation: Observation) -> Sequence[Mapping[str, Any]]:
        x, v, angle, turning = observation.state["observation"]
        lean = angle + 0.3 * turning + 0.02 * x + 0.05 * v
        return [{"action": [1.0 if lean > 0 else 0.0]}]


class ZeroPolicy:
    def reset(self, instruction: str) -> None:
        pass

    def act(self, observation: Observation) -> Sequence[Mapping[str, Any]]:
        return [{"action": [0.0]}] * 50


@pytest.mark.slow("starts a server")
def test_a_server_offers_added_benchmarks_and_clients_play_them(tmp_path: Path) -> None:
    """A class, and a folder of files. Expect the scores that they deserve."""
    offered = f"{EXAMPLES}/corridor.py:Corridor,{EXAMPLES}"
    server = ReferenceServer(tmp_path, PROCTOR_BENCHMARKS=offered)
    try:
        with server.client() as client:
            shown = client.get("/v1/benchmarks/cartpole").json()
        assert shown["action_space"]["action"]["out_of_range"] == "refuse"
        assert shown["simulator"]["packages"]["gymnasium"]
        place: Any = {"url": server.url, "token": TOKENS["alice"]}
        corridor = evaluate(CorridorPolicy, benchmark="corridor", workers=2, **place)
        assert corridor.score == 1.0
        cartpole = evaluate(CartPolePolicy, benchmark="cartpole", **place)
        assert cartpole.score == 1.0
        assert set(cartpole.by_task) == {"balance", "recover"}
        pendulum = evaluate(ZeroPolicy, benchmark="pendulum", **place)
        assert 0 < (pendulum.score or 0) < 0.6
        assert pendulum.counts.success == 0
    finally:
        server.end(signal.SIGKILL)


# --- docs/host/benchmarks.md ---

MANUAL = (ROOT / "docs" / "host" / "benchmarks.md").read_text()


def test_the_manual_shows_the_examples_as_they_are() -> None:
    (program,) = re.findall(r"```python\n(.*?)```", MANUAL, re.DOTALL)
    assert program in (EXAMPLES / "corridor.py").read_text()
    lines = [line for line in program.splitlines() if line.strip()]
    assert len(lines) <= 20
    (file,) = re.findall(r"```toml\n(.*?)```", MANUAL, re.DOTALL)
    example = (EXAMPLES / "cartpole.toml").read_text()
    assert tomllib.loads(file) == tomllib.loads(example)


def test_the_manual_explains_every_member_of_a_file() -> None:
    for name in Benchmark.model_fields:
        assert f"`{name}`" in MANUAL, name


def test_every_file_of_the_manual_is_there() -> None:
    for place in re.findall(r"`((?:examples|tests|docs)/[\w./]+)", MANUAL):
        assert (ROOT / place).exists(), place
