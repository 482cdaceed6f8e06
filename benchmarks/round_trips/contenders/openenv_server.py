"""OpenEnv, as its package serves an environment: FastAPI, a WebSocket for a session."""

from __future__ import annotations

import base64
import socket
import sys
from typing import Any

import uvicorn
from openenv.core.env_server import Environment
from openenv.core.env_server.http_server import create_fastapi_app
from openenv.core.env_server.types import State

from benchmarks.round_trips.contenders.openenv_models import (
    StillLifeAction,
    StillLifeObservation,
)
from benchmarks.round_trips.observations import ScenarioPlayer

SCENARIO = sys.argv[1]


class StillLife(Environment):  # type: ignore[misc,unused-ignore]
    def __init__(self) -> None:
        super().__init__()
        self._world = ScenarioPlayer(SCENARIO)

    def reset(self, *_: Any, **__: Any) -> StillLifeObservation:
        return self._seen([0.0])

    def step(self, action: Any, *_: Any, **__: Any) -> StillLifeObservation:
        return self._seen(action.joint_position)

    @property
    def state(self) -> State:
        return State()

    def _seen(self, action: list[float]) -> StillLifeObservation:
        state, images = self._world.turn(action)
        return StillLifeObservation(
            state={name: values.tolist() for name, values in state.items()},
            images={
                name: base64.b64encode(image.data).decode()
                for name, image in images.items()
            },
        )


def main() -> None:
    app = create_fastapi_app(StillLife, StillLifeAction, StillLifeObservation)
    # The protocol is named, or asyncio leaves out TCP_NODELAY and 40 ms are lost.
    listener = socket.socket(socket.AF_INET, socket.SOCK_STREAM, socket.IPPROTO_TCP)
    listener.bind(("127.0.0.1", 0))
    print(f"ready 127.0.0.1:{listener.getsockname()[1]}", flush=True)
    # Its endpoint closes what a departing client has closed, and logs that as an error.
    # A client that waits for its turn answers no pings.
    config = uvicorn.Config(app, log_level="critical", ws_ping_interval=None)
    uvicorn.Server(config).run(sockets=[listener])


if __name__ == "__main__":
    main()
