"""Runs with markup in every text, that a test looks at on pages."""

from collections.abc import Sequence
from typing import Any

from tests.support.server.http_runs import predict_body
from tests.support.servers import ReferenceServer

EVIL = "\"'><script>alert(1)</script><b onmouseover=x>"
TASKS = ("score", "score", "score")


def submit_and_play(
    server: ReferenceServer,
    successes: set[int],
    account: str = "alice",
    tasks: Sequence[str] = TASKS,
) -> str:
    """The id of a completed run; successes: indices of its episodes."""
    with server.client(account) as client:
        body = {
            "benchmark_id": "calibration",
            "policy": {
                "name": EVIL,
                "version": EVIL,
                "submitter": EVIL,
                "homepage": "https://a.example/\"onmouseover='x'<b>",
            },
            "options": {"tasks": tasks},
        }
        run: dict[str, Any] = client.post("/v1/runs", json=body).json()
        path = f"/v1/runs/{run['run_id']}/workers/w"
        player = {"name": EVIL, "version": EVIL, "client": EVIL}
        turn = client.put(path, json={"attach_key": "k", "player": player}).json()
        for index in range(len(tasks)):
            won = float(index in successes)
            values = {"score": won, "success": won, "end": 1.0}
            answer = client.post(f"{path}/predict", json=predict_body(turn, **values))
            assert answer.status_code == 200, answer.text
            turn = answer.json() | {"session_id": turn["session_id"]}
    return str(run["run_id"])
