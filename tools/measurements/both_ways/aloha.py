"""The tasks of gym-aloha; `make aloha` installs it into .venv-aloha."""

from __future__ import annotations

from typing import Any

import gymnasium
import numpy as np
import numpy.typing as npt

from reference_sim.mujoco import rendering
from tools.measurements.both_ways.compared_benchmark import EXAMPLES, ComparedBenchmark

rendering.find_backend()  # dm_control reads it while it is imported

import gym_aloha  # noqa: E402, F401 - registers the environments

from tools.measurements.both_ways.hand_over import HandOver  # noqa: E402

REGISTERED = {
    "transfer_cube": "gym_aloha/AlohaTransferCube-v0",
    "insertion": "gym_aloha/AlohaInsertion-v0",
}


class AlohaEpisode:
    """As LeRobot makes it: gym-aloha's own environment, which draws three cameras."""

    def __init__(self, task: str, seed: int) -> None:
        self._environment = gymnasium.make(
            REGISTERED[task],
            obs_type="pixels_agent_pos",
            max_episode_steps=400,
            disable_env_checker=True,
        )
        self._note(self._environment.reset(seed=seed)[0])

    def _note(self, observation: dict[str, Any]) -> None:
        self.observed = {
            "agent_pos": np.asarray(observation["agent_pos"], np.float64),
            "pixels.top": observation["pixels"]["top"],
        }

    def step(self, action: npt.NDArray[np.float64]) -> tuple[float, bool]:
        observation, reward, _, _, info = self._environment.step(action)
        self._note(observation)
        return float(reward), bool(info["is_success"])

    def close(self) -> None:
        self._environment.close()


COMPARED = ComparedBenchmark(
    file=EXAMPLES / "gym_aloha" / "aloha.toml",
    begin=AlohaEpisode,
    expert=lambda _: HandOver(),
)
