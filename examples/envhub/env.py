"""A Proctor run as a LeRobot environment, in the form that its EnvHub loads.

LeRobot calls `make_env` of this file and plays its policy in the environment; the
server owns seeds, success and score. Settings are read from the environment:
PROCTOR_URL, PROCTOR_TOKEN, PROCTOR_BENCHMARK, and PROCTOR_OPTIONS, the run's options as
JSON. Needs the package proctor-eval and nothing of LeRobot; README.md has
more.
"""

from __future__ import annotations

import json
import os
from typing import Any

import gymnasium
import numpy as np
import numpy.typing as npt
from gymnasium import spaces

from reference_client import RemoteEnv

Vector = npt.NDArray[np.float64]


class ProctorEnv(gymnasium.Env[dict[str, Any], Vector]):
    """An episode of a run for each `reset`, with LeRobot's names.

    Observation: `pixels`, a dict of uint8 images (height, width, channels) by camera,
    and `agent_pos`, float64: the vectors of the state one after another. Action: the
    vectors of the action space one after another, in units of the benchmark. Their
    order is `state_names` and `action_names`.
    """

    def __init__(self, remote: RemoteEnv, max_steps: int | None = None) -> None:
        """max_steps: where the options of the run change the benchmark's."""
        self.remote = remote
        self.metadata = {"render_modes": []}
        self.task = self.task_description = ""
        # Read by LeRobot. The server ends an episode by itself.
        self._max_episode_steps = max_steps or remote.max_steps
        # Dicts of spaces, which Gymnasium's types do not say.
        observations: Any = remote.observation_space
        actions: Any = remote.action_space
        groups = observations.spaces
        state = dict(groups["state"].spaces) if "state" in groups else {}
        self.state_names = list(state)
        self.action_names = list(actions.spaces)
        observed: dict[str, spaces.Space[Any]] = {}
        if "images" in groups:
            observed["pixels"] = groups["images"]
        if state:
            observed["agent_pos"] = _joined(state)
        self.observation_space = spaces.Dict(observed)
        self.action_space = _joined(actions.spaces)
        sizes = [actions[name].shape[0] for name in self.action_names]
        self._ends = np.cumsum(sizes)[:-1]

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[dict[str, Any], dict[str, Any]]:
        """Begin the run's next episode; the seed is the server's own."""
        observation, info = self.remote.reset(seed=seed, options=options)
        self.task, self.task_description = info["task"], info["instruction"]
        return self._observed(observation), {"is_success": False}

    def step(
        self, action: Vector
    ) -> tuple[dict[str, Any], float, bool, bool, dict[str, Any]]:
        """Execute one action; the last step of an episode says if it succeeded."""
        parts = np.split(np.asarray(action, np.float64), self._ends)
        named = dict(zip(self.action_names, parts, strict=True))
        observation, reward, terminated, truncated, more = self.remote.step(named)
        result = more.get("episode_result", {})
        is_success = result.get("outcome") == "success"
        info: dict[str, Any] = {"is_success": is_success}
        if terminated or truncated:
            info["final_info"] = {"is_success": is_success}
        return self._observed(observation), float(reward), terminated, truncated, info

    def close(self) -> None:
        """Leave the run, which stays on the server."""
        self.remote.close()

    def _observed(self, observation: Any) -> dict[str, Any]:
        observed: dict[str, Any] = {}
        if "images" in observation:
            observed["pixels"] = observation["images"]
        if self.state_names:
            vectors = [observation["state"][name] for name in self.state_names]
            observed["agent_pos"] = np.concatenate(vectors, dtype=np.float64)
        return observed


def make_env(
    n_envs: int = 1,
    use_async_envs: bool = False,  # noqa: ARG001 - a batch of one is synchronous
    cfg: Any = None,  # noqa: ARG001 - LeRobot passes it to some files
) -> dict[str, dict[int, gymnasium.vector.VectorEnv[Any, Any, Any]]]:
    """Make the environment, for LeRobot; ValueError for more than one at a time.

    LeRobot plays a batch until its last episode ends, and resets those that ended
    before: on a server these would be attempts that count.
    """
    if n_envs != 1:
        raise ValueError(f"{n_envs} environments: use --eval.batch_size=1")
    benchmark = os.environ["PROCTOR_BENCHMARK"]
    options = json.loads(os.environ.get("PROCTOR_OPTIONS", "{}"))

    def make() -> ProctorEnv:
        remote = RemoteEnv(benchmark=benchmark, options=options, name="lerobot")
        return ProctorEnv(remote, options.get("max_steps"))

    return {f"proctor_{benchmark}": {0: gymnasium.vector.SyncVectorEnv([make])}}


def _joined(entries: dict[str, spaces.Space[Any]]) -> Any:
    """A Box of all of them, in float64."""
    boxes = [box for box in entries.values() if isinstance(box, spaces.Box)]
    assert len(boxes) == len(entries)
    low = np.concatenate([box.low for box in boxes], dtype=np.float64)
    high = np.concatenate([box.high for box in boxes], dtype=np.float64)
    return spaces.Box(low, high, dtype=np.float64)
