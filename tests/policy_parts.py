"""A policy server in this process, and a policy for the benchmark `calibration`."""

import contextlib
import socket
import threading
from collections.abc import Iterator
from typing import Any

import uvicorn
from starlette.types import ASGIApp

from reference_client import Observation
from reference_client.policies.serving import PolicyApp

KEY = "sesame"
ACTION: dict[str, Any] = {
    "score": [0.5],
    "success": [1.0],
    "end": [0.0],
    "delay_s": [0.0],
    "fault": [0.0],
    "vector": [0.0] * 8,
    "clipped": [0.0, 0.0],
}


class Counting:
    """Ends an episode at its third act; has its score from how often it was asked."""

    def reset(self, instruction: str) -> None:
        self.acts = 0

    def act(self, observation: Observation) -> list[dict[str, Any]]:
        self.acts += 1
        end = [1.0 if self.acts == 3 else 0.0]
        return [ACTION | {"score": [self.acts / 10], "end": end}]


def an_app(**members: Any) -> PolicyApp:
    return PolicyApp(Counting, "counting", **{"key": KEY, **members})


@contextlib.contextmanager
def serving(app: ASGIApp) -> Iterator[str]:
    """Serves an application on a free port; yields its URL."""
    listener = socket.create_server(("127.0.0.1", 0))
    config = uvicorn.Config(app, log_level="critical", lifespan="off")
    server = uvicorn.Server(config)
    thread = threading.Thread(target=server.run, args=([listener],), daemon=True)
    thread.start()
    try:
        yield f"http://127.0.0.1:{listener.getsockname()[1]}"
    finally:
        server.should_exit = True
        thread.join()
        listener.close()
