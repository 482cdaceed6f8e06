"""Writes demonstrations of scripted experts as a data set that LeRobot trains from.

    .venv-lerobot/bin/python examples/trained_policy/demonstrations.py FOLDER

Plays the expert of a benchmark in this process, with seeds that no run has, and writes
its successful episodes. A frame has the observation and the action that the expert
chose. The action that is executed has noise, so that the data set shows how to return
from states in which an expert by itself would never be.
"""

from __future__ import annotations

import argparse
import importlib
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import datasets
import numpy as np
import numpy.typing as npt
from lerobot.datasets.lerobot_dataset import LeRobotDataset

from reference_sim import benchmark_registry
from reference_sim.interface import Observation

FIRST_SEED = 1_000_000  # those of runs are smaller
SPLIT = "val_train"
ROBOT, ALL = "observation.state", "observation.environment_state"

Vector = npt.NDArray[np.float32]
Frames = list[dict[str, Any]]


class Demonstrator:
    """Plays the expert of `benchmark`, such as tabletop.

    noise: standard deviation of what is added to each number of the action but the
    gripper's, in its unit.
    """

    def __init__(self, benchmark: str, noise: float) -> None:
        resolved = benchmark_registry.resolve(f"{benchmark}_state")
        experts = importlib.import_module(
            f"reference_sim.benchmarks.{benchmark}.experts"
        )
        self.manifest: Mapping[str, Any] = resolved.manifest
        self._simulator = benchmark_registry.make(resolved.world)
        self._expert = experts.make_expert()
        self._noise = noise
        self._actions = self.manifest["action_space"]
        self._states = self.manifest["observation_space"]["state"]
        self._robot = [name for name in self._actions if name in self._states]

    def features(self) -> dict[str, dict[str, Any]]:
        """As LeRobot describes a frame: the robot's state, all states, the action.

        The states are those that `--policy lerobot:FOLDER` finds by their sizes.
        """
        return {
            ROBOT: _feature({name: self._states[name] for name in self._robot}),
            ALL: _feature(self._states),
            "action": _feature(self._actions),
        }

    def play(self, task: str, seed: int) -> Frames | None:
        """The frames of an episode; None if the noise made the expert fail."""
        rng = np.random.default_rng(seed)
        instruction = self._simulator.reset(task, seed, SPLIT)
        self._expert.reset(instruction)
        frames: Frames = []
        for _ in range(self.manifest["max_steps"]):
            observation = self._simulator.observe()
            state = {name: one.tolist() for name, one in observation.state.items()}
            action = self._expert.act(state)
            frames.append(self._frame(instruction, observation, action))
            outcome = self._simulator.step(self._disturbed(action, rng))
            if outcome.terminated:
                return frames if outcome.success else None
        return None

    def _frame(
        self, instruction: str, observation: Observation, action: Mapping[str, Any]
    ) -> dict[str, Any]:
        state = observation.state
        return {
            "task": instruction,
            ROBOT: _joined(state[name] for name in self._robot),
            ALL: _joined(state[name] for name in self._states),
            "action": _joined(action[name] for name in self._actions),
        }

    def _disturbed(
        self, action: Mapping[str, Sequence[float]], rng: np.random.Generator
    ) -> dict[str, list[float]]:
        disturbed = {}
        for name, values in action.items():
            space = self._actions[name]
            spread = 0.0 if name == "gripper" else self._noise
            noisy = np.asarray(values) + rng.normal(0.0, spread, len(values))
            clipped = np.clip(noisy, space["minimum"], space["maximum"])
            disturbed[name] = clipped.tolist()
        return disturbed


def _feature(spaces: Mapping[str, Any]) -> dict[str, Any]:
    names = [f"{name}.{n}" for name, one in spaces.items() for n in range(one["size"])]
    return {"dtype": "float32", "shape": (len(names),), "names": names}


def _joined(vectors: Any) -> Vector:
    return np.concatenate([np.asarray(one, np.float32) for one in vectors])


def write(folder: Path, player: Demonstrator, tasks: Sequence[str], count: int) -> None:
    """`count` episodes of each task."""
    dataset = LeRobotDataset.create(
        repo_id=f"proctor/{folder.name}",
        fps=round(player.manifest["control_rate_hz"]),
        features=player.features(),
        root=folder,
        use_videos=False,
    )
    for task in tasks:
        written, seed = 0, FIRST_SEED
        while written < count:
            for frame in player.play(task, seed) or ():
                dataset.add_frame(frame)
            if dataset.episode_buffer["size"]:
                dataset.save_episode()
                written += 1
            seed += 1
        print(f"{task}: {written} of {seed - FIRST_SEED} episodes", flush=True)
    dataset.finalize()


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("folder", type=Path, help="must not exist")
    parser.add_argument("--benchmark", default="tabletop", help="one with experts")
    parser.add_argument("--tasks", help="comma-separated; all without it")
    parser.add_argument("--episodes", type=int, default=100, help="of each task")
    parser.add_argument("--noise", type=float, default=0.01, help="rad")
    options = parser.parse_args()
    datasets.disable_progress_bars()  # there is one for each episode
    player = Demonstrator(options.benchmark, options.noise)
    tasks = options.tasks.split(",") if options.tasks else player.manifest["tasks"]
    write(options.folder, player, tasks, options.episodes)


if __name__ == "__main__":
    main()
