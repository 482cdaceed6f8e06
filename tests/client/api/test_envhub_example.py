"""The environment for LeRobot's EnvHub, played as LeRobot's evaluation plays it.

LeRobot itself is not installed here; lerobot_envhub_checks.py of
tests/client/policies/lerobot plays the same file with LeRobot's own functions.
"""

import json
from typing import Any

import numpy as np
import pytest

from examples.envhub.env import ProctorEnv, make_env
from reference_client import RemoteEnv
from reference_client.gymnasium_env.remote_env import RunDone
from tests.support.client.direct_client import DirectClient
from tests.support.servers import TOKENS, ReferenceServer
from tests.support.sim.calibration_action import calibration_action

pytestmark = pytest.mark.slow("starts a server")


@pytest.fixture(autouse=True)
def _environment(server: ReferenceServer, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PROCTOR_URL", server.url)
    monkeypatch.setenv("PROCTOR_TOKEN", TOKENS["alice"])
    monkeypatch.setenv("PROCTOR_BENCHMARK", "calibration")
    monkeypatch.setenv("PROCTOR_OPTIONS", json.dumps({"tasks": ["count", "echo"]}))


def vector(env: ProctorEnv, **values: float) -> Any:
    action = calibration_action(**values)
    return np.concatenate([action[name] for name in env.action_names])


def test_a_run_is_played_as_lerobot_plays(direct: DirectClient) -> None:
    """Two rollouts of a batch of one. Expect two episodes, one attempt each."""
    ((suite, tasks),) = make_env().items()
    assert suite == "proctor_calibration"
    batch: Any = tasks[0]
    (env,) = batch.envs
    for score in (1.0, 0.0):
        observation, _ = batch.reset(seed=[5])
        assert batch.call("_max_episode_steps") == (10,)
        assert batch.call("task_description") != ("",)
        numbers = env.observation_space["agent_pos"].shape
        assert observation["agent_pos"].shape == (1, *numbers)
        batch.step(vector(env)[None])
        *_, terminated, _, info = batch.step(vector(env, success=score, end=1.0)[None])
        assert terminated.tolist() == [True]
        assert info["final_info"]["is_success"].tolist() == [score == 1.0]
    with pytest.raises(RunDone):
        batch.reset()
    assert direct.attempts(env.remote.run_id) == [1, 1]
    assert env.remote.score()["counts"]["success"] == 1
    batch.close()


def test_spaces_hold_what_is_observed_and_done() -> None:
    env = ProctorEnv(RemoteEnv(benchmark="calibration", options={"tasks": ["echo"]}))
    observation, _ = env.reset()
    assert env.observation_space.contains(observation)
    assert env.action_space.contains(vector(env))
    assert {"pixels", "agent_pos"} == set(observation)
    observation, *_ = env.step(vector(env, score=0.5))
    assert env.observation_space.contains(observation)
    env.close()


def test_a_batch_of_more_is_refused() -> None:
    with pytest.raises(ValueError, match="batch_size=1"):
        make_env(n_envs=2)
