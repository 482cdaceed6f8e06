"""EBench's way: FastAPI on uvicorn, pickles in both directions, no session.

`POST /step` takes `{worker_id: action}` and answers `{worker_id: {obs, metric}}`, in
the shapes of its documentation, without the other work of EBench's server. Pickle is
measured here, between two processes of our own.
"""

import pickle
from typing import Any

import numpy as np
import requests
import uvicorn
from fastapi import FastAPI, Request, Response

from benchmarks.round_trips.contender_process import ObservationParts, Turn, listen
from benchmarks.round_trips.observations import SCENARIOS, STATE_SIZES, ScenarioPlayer

HEADERS = {
    "Authorization": "Bearer secret",
    "run_id": "run",
    "Content-Type": "application/octet-stream",
}


def serve(scenario: str) -> None:
    app, world = FastAPI(), ScenarioPlayer(scenario)

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
    listener = listen()
    config = uvicorn.Config(app, log_level="warning")
    uvicorn.Server(config).run(sockets=[listener])


def connect(address: str, scenario: str) -> Turn:
    url = f"http://{address}/step"
    cameras = SCENARIOS[scenario].cameras

    def turn(action: list[float]) -> ObservationParts:
        sent = {
            "0": {
                "action": np.array(action),
                "base_motion": np.zeros(3),
                "control_type": "joint_position",
                "is_rel": False,
                "base_is_rel": True,
            }
        }
        data = pickle.dumps(sent)
        answer = requests.post(url, data=data, headers=HEADERS, timeout=60)
        answer.raise_for_status()
        observation = pickle.loads(answer.content)["0"]["obs"]  # noqa: S301 - its way
        return {name: observation[f"state.{name}"] for name in STATE_SIZES}, {
            name: observation[f"video.{name}_view"] for name in cameras
        }

    return turn
