"""Meta-World's fifty tasks with its own experts; `make metaworld` installs it apart.

It must not import the adapter or the module with which it is compared.
"""

from __future__ import annotations

import tomllib
import warnings
from pathlib import Path
from typing import Any

import metaworld.env_dict
import metaworld.policies
import numpy as np
import numpy.typing as npt

from tools.measurements.both_ways.compared_benchmark import ComparedBenchmark, Parts

ROOT = Path(__file__).resolve().parents[3]
FILE = ROOT / "reference_sim" / "benchmarks" / "metaworld" / "benchmark.toml"
TASK_OF = {
    task["instruction"]: task["name"]
    for task in tomllib.loads(FILE.read_text())["tasks"]
}


class TaskExpert:
    """Meta-World's expert for a task, which is named or recognised by its text."""

    def __init__(self, task: str) -> None:
        name = TASK_OF.get(task, task)
        self._expert = metaworld.policies.ENV_POLICY_MAP[name]()

    def act(self, seen: Parts) -> npt.NDArray[np.float32]:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # it commands more than it may
            action: npt.NDArray[np.float32] = self._expert.get_action(
                seen["observation"]
            )
        return action


class MetaWorldEpisode:
    """As Meta-World's own pages make it, with a seed."""

    def __init__(self, task: str, seed: int) -> None:
        made = metaworld.env_dict.ALL_V3_ENVIRONMENTS_GOAL_OBSERVABLE
        self._environment: Any = made[f"{task}-goal-observable"]()
        # Its reset(seed) disregards the seed; this is how it can be given one.
        self._environment.seeded_rand_vec = True
        self._environment._freeze_rand_vec = False  # noqa: SLF001 - no other way
        self._environment.seed(seed)
        self._note(self._environment.reset()[0])

    def _note(self, observation: npt.NDArray[np.float64]) -> None:
        self.observed = {"observation": np.array(observation, np.float64)}

    def step(self, action: npt.NDArray[np.float32]) -> tuple[float, bool]:
        clipped = np.clip(action, -1, 1).astype(np.float32)
        observation, reward, _, _, info = self._environment.step(clipped)
        self._note(observation)
        return float(reward), bool(info["success"])

    def close(self) -> None:
        self._environment.close()


COMPARED = ComparedBenchmark(
    file=FILE,
    begin=MetaWorldEpisode,
    expert=TaskExpert,
    benchmark_id="metaworld_mt50",
    split="test",
    workers=4,
)
