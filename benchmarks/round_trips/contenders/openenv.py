"""OpenEnv, as its package serves an environment: FastAPI, a WebSocket for a session.

The client is the real one, EnvClient. OpenEnv sends JSON and does not define images.
Base64 is the cheapest encoding that fits; lists of numbers cost many times as much.
"""

import asyncio
import atexit
import base64
from functools import partial
from typing import Any

import numpy as np
import uvicorn
from openenv.core import EnvClient
from openenv.core.client_types import StepResult
from openenv.core.env_server import Environment
from openenv.core.env_server.http_server import create_fastapi_app
from openenv.core.env_server.types import Action, Observation, State

from benchmarks.round_trips.contender_process import ObservationParts, Turn, listen
from benchmarks.round_trips.observations import SCENARIOS, ScenarioPlayer, by_name


class StillLifeAction(Action):  # type: ignore[misc,unused-ignore]
    joint_position: list[float]
    gripper: list[float]


class StillLifeObservation(Observation):  # type: ignore[misc,unused-ignore]
    state: dict[str, list[float]]
    images: dict[str, str]


class StillLifeEnvironment(Environment):  # type: ignore[misc,unused-ignore]
    def __init__(self, scenario: str) -> None:
        super().__init__()
        self._world = ScenarioPlayer(scenario)

    def reset(self, *_: Any, **__: Any) -> StillLifeObservation:
        return self._observe([0.0])

    def step(self, action: Any, *_: Any, **__: Any) -> StillLifeObservation:
        return self._observe(action.joint_position)

    @property
    def state(self) -> State:
        return State()

    def _observe(self, action: list[float]) -> StillLifeObservation:
        state, images = self._world.turn(action)
        return StillLifeObservation(
            state={name: values.tolist() for name, values in state.items()},
            images={
                name: base64.b64encode(image.data).decode()
                for name, image in images.items()
            },
        )


def serve(scenario: str) -> None:
    make = partial(StillLifeEnvironment, scenario)
    app = create_fastapi_app(make, StillLifeAction, StillLifeObservation)
    listener = listen()
    # Its endpoint closes what a departing client has closed, and logs that as an error.
    # A client that waits for its turn answers no pings.
    config = uvicorn.Config(app, log_level="critical", ws_ping_interval=None)
    uvicorn.Server(config).run(sockets=[listener])


class StillLifeClient(EnvClient):  # type: ignore[misc,unused-ignore]
    def _step_payload(self, action: Any) -> dict[str, Any]:
        return {"joint_position": action.joint_position, "gripper": action.gripper}

    def _parse_result(self, payload: dict[str, Any]) -> Any:
        observation = StillLifeObservation(**payload["observation"])
        return StepResult(observation=observation, reward=None, done=payload["done"])

    def _parse_state(self, payload: dict[str, Any]) -> Any:
        return State(**payload)


def connect(address: str, scenario: str) -> Turn:
    runner = asyncio.Runner()
    client = StillLifeClient(f"http://{address}")
    runner.run(client.connect())
    runner.run(client.reset())
    atexit.register(lambda: runner.run(client.close()))
    shown = SCENARIOS[scenario]
    shape = (shown.height, shown.width, 3)

    def turn(action: list[float]) -> ObservationParts:
        message = StillLifeAction(**by_name(action))
        observation = runner.run(client.step(message)).observation
        return observation.state, {
            name: np.frombuffer(base64.b64decode(data), np.uint8).reshape(shape)
            for name, data in observation.images.items()
        }

    return turn
