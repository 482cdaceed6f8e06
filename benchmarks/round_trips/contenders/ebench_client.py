"""EBench's way, from its client's side: `requests.post` without a session."""

from __future__ import annotations

import pickle

import numpy as np
import requests

from benchmarks.round_trips.contenders import turn_client
from benchmarks.round_trips.observations import SCENARIOS, STATE_SIZES

HEADERS = {
    "Authorization": "Bearer secret",
    "run_id": "run",
    "Content-Type": "application/octet-stream",
}


def connect(address: str, scenario: str) -> turn_client.Turn:
    url = f"http://{address}/step"
    cameras = SCENARIOS[scenario].cameras

    def turn(action: list[float]) -> turn_client.ObservationParts:
        sent = {
            "0": {
                "action": np.array(action),
                "base_motion": np.zeros(3),
                "control_type": "joint_position",
                "is_rel": False,
                "base_is_rel": True,
            }
        }
        answer = requests.post(
            url, data=pickle.dumps(sent), headers=HEADERS, timeout=60
        )
        answer.raise_for_status()
        observation = pickle.loads(answer.content)["0"]["obs"]  # noqa: S301 - its way
        return {name: observation[f"state.{name}"] for name in STATE_SIZES}, {
            name: observation[f"video.{name}_view"] for name in cameras
        }

    return turn


if __name__ == "__main__":
    turn_client.main(connect)
