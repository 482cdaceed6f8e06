"""Runs of `calibration` that a test plays over plain HTTP."""

from typing import Any

import httpx

from tests.support.sim.calibration_action import calibration_action


def submit(client: httpx.Client, *tasks: str, **members: Any) -> str:
    """Submit a run with these tasks and further members; give its id."""
    body = {"benchmark_id": "calibration", "policy": {"name": "p"}, **members}
    body["options"] = {"tasks": tasks, **members.get("options", {})}
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


def worker_path(run_id: str, worker_id: str = "w") -> str:
    return f"/v1/runs/{run_id}/workers/{worker_id}"


def attach(client: httpx.Client, run_id: str, key: str = "key") -> dict[str, Any]:
    """The turn that attaching the worker `w` gave."""
    answer = client.put(worker_path(run_id), json={"attach_key": key})
    assert answer.status_code == 200, answer.text
    return dict(answer.json())
