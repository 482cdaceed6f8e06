"""examples/envhub/env.py by LeRobot's own functions: `make lerobot-check`.

The file is loaded as LeRobot loads one of the Hub, and a policy is rolled out in it as
`lerobot-eval` does. Not part of `make test`, whose environment has no LeRobot.
"""

import json
from typing import Any

import pytest
import torch
from lerobot.envs.utils import (
    _call_make_env,
    _load_module_from_path,
    _normalize_hub_result,
)
from lerobot.scripts.lerobot_eval import rollout

from tests.support.paths import ROOT
from tests.support.servers import TOKENS, ReferenceServer
from tests.support.sim.calibration_action import calibration_action


class Ending(torch.nn.Module):  # type: ignore[misc]
    """Ends every episode in its third step, with success."""

    def __init__(self, names: list[str]) -> None:
        super().__init__()
        self.names = names
        self.tasks: list[str] = []

    def reset(self) -> None:
        self.steps = 0

    def select_action(self, observation: dict[str, Any]) -> torch.Tensor:
        assert observation["observation.state"].shape[0] == 1
        assert observation["observation.images.pattern"].dtype == torch.float32
        self.tasks += observation["task"]
        self.steps += 1
        ends = float(self.steps == 3)
        action = calibration_action(success=ends, end=ends)
        values = [value for name in self.names for value in action[name]]
        return torch.tensor([values], dtype=torch.float64)


def unchanged(value: Any) -> Any:
    return value


def test_lerobot_plays_the_environment(
    server: ReferenceServer, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Two rollouts. Expect three steps each, success, and the run complete."""
    monkeypatch.setenv("PROCTOR_URL", server.url)
    monkeypatch.setenv("PROCTOR_TOKEN", TOKENS["alice"])
    monkeypatch.setenv("PROCTOR_BENCHMARK", "calibration")
    monkeypatch.setenv("PROCTOR_OPTIONS", json.dumps({"tasks": ["echo", "echo"]}))
    module = _load_module_from_path(str(ROOT / "examples" / "envhub" / "env.py"))
    made = _call_make_env(module, n_envs=1, use_async_envs=False, cfg=None)
    batch = _normalize_hub_result(made)["proctor_calibration"][0]
    env = batch.envs[0]
    policy = Ending(env.action_names)
    for _ in range(2):
        played = rollout(batch, policy, *[unchanged] * 4, seeds=[1])
        assert played["success"].tolist() == [[False, False, True]]
    assert all(policy.tasks)
    score = env.remote.score()
    assert (score["counts"]["success"], score["counts"]["total"]) == (2, 2)
    batch.close()
