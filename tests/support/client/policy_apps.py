"""A policy server in this process, and a policy for the benchmark `calibration`."""

import contextlib
import os
import socket
import subprocess
import sys
import threading
from collections.abc import Iterator
from typing import Any

import uvicorn
from starlette.types import ASGIApp

from reference_client import Observation
from reference_client.policies.policy_http_app import PolicyApp
from tests.support.processes import run_program
from tests.support.servers import TOKENS, ReferenceServer
from tests.support.sim.calibration_action import calibration_action

KEY = "sesame"
ACTION: dict[str, Any] = calibration_action(score=0.5, success=1.0)


class CountingPolicy:
    """Ends an episode at its third act; its score is a tenth of its calls."""

    def reset(self, instruction: str) -> None:
        self.acts = 0

    def act(self, observation: Observation) -> list[dict[str, Any]]:
        self.acts += 1
        end = [1.0 if self.acts == 3 else 0.0]
        return [ACTION | {"score": [self.acts / 10], "end": end}]


def make_app(**members: Any) -> PolicyApp:
    return PolicyApp(CountingPolicy, "counting", **{"key": KEY, **members})


@contextlib.contextmanager
def run_app(app: ASGIApp) -> Iterator[str]:
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


def run_proctor(
    server: ReferenceServer, *arguments: str, command: str = "run"
) -> subprocess.CompletedProcess[str]:
    tokens = {"PROCTOR_TOKEN": TOKENS["alice"], "PROCTOR_URL": server.url}
    return run_program(
        [sys.executable, "-m", "reference_client.command", command, *arguments],
        env=os.environ | tokens,
    )
