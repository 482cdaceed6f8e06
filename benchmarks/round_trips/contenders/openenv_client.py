"""OpenEnv, with the real client: EnvClient over its WebSocket, as it comes."""

from __future__ import annotations

import asyncio
import atexit
import base64
from typing import Any

import numpy as np
from openenv.core import EnvClient
from openenv.core.client_types import StepResult
from openenv.core.env_server.types import State

from benchmarks.round_trips.contenders import turn_client
from benchmarks.round_trips.contenders.openenv_models import (
    StillLifeAction,
    StillLifeObservation,
)
from benchmarks.round_trips.observations import ACTION_SIZES, SCENARIOS


class Client(EnvClient):  # type: ignore[misc,unused-ignore]
    def _step_payload(self, action: Any) -> dict[str, Any]:
        return {"joint_position": action.joint_position, "gripper": action.gripper}

    def _parse_result(self, payload: dict[str, Any]) -> Any:
        observation = StillLifeObservation(**payload["observation"])
        return StepResult(observation=observation, reward=None, done=payload["done"])

    def _parse_state(self, payload: dict[str, Any]) -> Any:
        return State(**payload)


def connect(address: str, scenario: str) -> turn_client.Turn:
    runner = asyncio.Runner()
    client = Client(f"http://{address}")
    runner.run(client.connect())
    runner.run(client.reset())
    atexit.register(lambda: runner.run(client.close()))
    shown = SCENARIOS[scenario]
    shape = (shown.height, shown.width, 3)
    joints = ACTION_SIZES["joint_position"]

    def turn(action: list[float]) -> turn_client.ObservationParts:
        action_message = StillLifeAction(
            joint_position=action[:joints], gripper=action[joints:]
        )
        observation = runner.run(client.step(action_message)).observation
        return observation.state, {
            name: np.frombuffer(base64.b64decode(data), np.uint8).reshape(shape)
            for name, data in observation.images.items()
        }

    return turn


if __name__ == "__main__":
    turn_client.main(connect)
