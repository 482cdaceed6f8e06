"""EBench's way: FastAPI on uvicorn, pickles in both directions.

`POST /step` takes `{worker_id: action}` and answers `{worker_id: {obs, metric}}`, in
the shapes of its documentation, without the other work of EBench's server. Pickle is
measured here, between two processes of our own.
"""

from __future__ import annotations

import pickle
import socket
import sys
from typing import Any

import uvicorn
from fastapi import FastAPI, Request, Response

from benchmarks.round_trips.observations import ScenarioPlayer


def application(scenario: str) -> FastAPI:
    app = FastAPI()
    world = ScenarioPlayer(scenario)

    async def step(request: Request) -> Response:
        actions = pickle.loads(await request.body())  # noqa: S301 - its way
        answers = {}
        for worker_id, action in actions.items():
            state, images = world.turn(action["action"])
            observation: dict[str, Any] = {
                "instruction": "Sit for a portrait.",
                **{f"state.{name}": values for name, values in state.items()},
                **{f"video.{name}_view": image for name, image in images.items()},
                "reset": False,
            }
            answers[worker_id] = {"obs": observation, "metric": None}
        return Response(pickle.dumps(answers), media_type="application/octet-stream")

    app.add_api_route("/step", step, methods=["POST"])
    return app


def main() -> None:
    # The protocol is named, or asyncio leaves out TCP_NODELAY and 40 ms are lost.
    listener = socket.socket(socket.AF_INET, socket.SOCK_STREAM, socket.IPPROTO_TCP)
    listener.bind(("127.0.0.1", 0))
    print(f"ready 127.0.0.1:{listener.getsockname()[1]}", flush=True)
    config = uvicorn.Config(application(sys.argv[1]), log_level="warning")
    uvicorn.Server(config).run(sockets=[listener])


if __name__ == "__main__":
    main()
