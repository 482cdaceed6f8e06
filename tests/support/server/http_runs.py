"""Runs of `calibration` that a test plays over plain HTTP."""

from typing import Any

import httpx

from tests.support.sim.calibration_action import calibration_action


def submit(client: httpx.Client, *tasks: str) -> str:
    body = {
        "benchmark_id": "calibration",
        "policy": {"name": "p"},
        "options": {"tasks": tasks},
    }
    answer = client.post("/v1/runs", json=body)
    assert answer.status_code == 201, answer.text
    return str(answer.json()["run_id"])


def predict_body(turn: dict[str, Any], **values: float) -> dict[str, Any]:
    """Body of the predict after this turn, with one action."""
    return {
        "session_id": turn["session_id"],
        "seq": turn["seq"] + 1,
        "actions": [{"values": calibration_action(**values)}],
    }
