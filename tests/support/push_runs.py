"""Push runs for tests: how they are submitted, played to their end and read."""

import signal
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import httpx

from tests.support.servers import TIMEOUT_S, ReferenceServer

END_STATES = ("completed", "failed", "stopped")
ALLOW_LOOPBACK = {"PROCTOR_ALLOW_PRIVATE_POLICIES": "127.0.0.0/8"}


def start_push_server(path: Path, **settings: str) -> Iterator[ReferenceServer]:
    """A server that may call policies on this machine; nothing in it may go wrong."""
    server = ReferenceServer(path, **ALLOW_LOOPBACK, **settings)
    yield server
    server.end(signal.SIGKILL)
    assert "Traceback" not in server.log()


def push_submission(url: str, *tasks: str, **members: Any) -> Any:
    """Body of submit_run; what is no member of it is one of its policy server."""
    known = {"options", "idle_timeout_s", "max_workers"}
    body: dict[str, Any] = {
        "benchmark_id": "calibration",
        "policy": {"name": "pushed"},
        "mode": "push",
        "options": {"tasks": list(tasks or ("score",)), **members.pop("options", {})},
        **{name: members.pop(name) for name in known & members.keys()},
    }
    order = {"call_timeout_s": 5.0, "max_retries": 0, **members}
    return body | {"policy_server": {"url": url, "protocol": "proctor", **order}}


def submit_push_run(client: httpx.Client, url: str, *tasks: str, **members: Any) -> str:
    answer = client.post("/v1/runs", json=push_submission(url, *tasks, **members))
    assert answer.status_code == 201, answer.text
    return str(answer.json()["run_id"])


def wait_for_state(client: httpx.Client, run_id: str, *states: str) -> dict[str, Any]:
    """The run, when it is in one of the states; ended ones without any."""
    deadline = time.monotonic() + TIMEOUT_S
    while True:
        run: dict[str, Any] = client.get(f"/v1/runs/{run_id}").json()
        if run["state"] in (states or END_STATES):
            return run
        assert time.monotonic() < deadline, run
        time.sleep(0.01)


def episodes(client: httpx.Client, run_id: str) -> list[dict[str, Any]]:
    found: list[dict[str, Any]] = client.get(f"/v1/runs/{run_id}/episodes").json()[
        "episodes"
    ]
    return found


def play_push_run(
    server: ReferenceServer, url: str, *tasks: str, **members: Any
) -> dict[str, Any]:
    """The run at its end, with its `episodes`."""
    with server.client() as client:
        run_id = submit_push_run(client, url, *tasks, **members)
        run = wait_for_state(client, run_id)
        return run | {"episodes": episodes(client, run_id)}
