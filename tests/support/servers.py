"""The reference server as a process of its own, for one test or for several.

It knows the program's settings and its startup line, and nothing of its modules.
"""

import os
import signal
import subprocess
from collections.abc import Sequence
from pathlib import Path
from typing import Any, Self

import httpx

from tests.support.forking.fork_server import CAN_FORK
from tests.support.forking.forked_process import ForkedProcess
from tests.support.forking.forked_servers import PROGRAM, server_forks
from tests.support.paths import ROOT

TOKENS = {
    "alice": "alice-token",
    "bob": "bob-token",
    "reader": "reader-token",  # of alice, without the scope `run`
}
TIMEOUT_S = 30.0


def end_process(
    process: subprocess.Popen[str] | ForkedProcess, number: signal.Signals
) -> int:
    """Send one signal unless the process has ended; return its exit code."""
    if process.poll() is None:
        process.send_signal(number)
    code = process.wait(TIMEOUT_S)
    assert process.stdout is not None
    process.stdout.close()
    return code


class NotStarted(AssertionError):
    """A server ended before it was listening; with the end of its log."""


class ReferenceServer:
    """The reference server on a free port, with a database in `directory`.

    It runs once constructed. After `end`, `start` starts it again with the same
    database on the same port. As a context manager it is killed at the end.
    settings: environment variables of the server. command: a subclass may have another;
    this one is forked where that can be done, which takes a quarter of the time.
    """

    command: Sequence[str] = PROGRAM

    def __init__(self, directory: Path, **settings: str) -> None:
        self._directory = directory
        self.database_file = directory / "proctor.sqlite"
        self.settings = settings
        self._port = "0"
        self.start()

    def start(self) -> None:
        inherited = {k: v for k, v in os.environ.items() if k[:8] != "PROCTOR_"}
        tokens = "alice:read+run:{alice},bob:read+run:{bob},alice:read:{reader}"
        settings = {
            "PROCTOR_PORT": self._port,
            "PROCTOR_DATABASE": str(self.database_file),
            "PROCTOR_TOKENS": tokens.format(**TOKENS),
        } | self.settings
        with (self._directory / "log").open("ab") as log:
            self.process = self._started(inherited | settings, log.fileno())
        assert self.process.stdout is not None
        startup_line = self.process.stdout.readline()
        if not startup_line:
            raise NotStarted(self.log()[-2000:])
        self.url = startup_line.split()[-1]
        self._port = self.url.rpartition(":")[2]

    def _started(
        self, environment: dict[str, str], log: int
    ) -> subprocess.Popen[str] | ForkedProcess:
        if self.command == PROGRAM and CAN_FORK:
            return ForkedProcess(server_forks(), environment, log)
        return subprocess.Popen(
            self.command,
            cwd=ROOT,
            env=environment,
            stdout=subprocess.PIPE,
            stderr=log,
            text=True,
        )

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.end(signal.SIGKILL)

    def client(self, account: str = "alice", **settings: Any) -> httpx.Client:
        headers = {"Authorization": f"Bearer {TOKENS[account]}"}
        # The environment may name a proxy; loopback is never behind it.
        return httpx.Client(
            base_url=self.url,
            headers=headers,
            timeout=TIMEOUT_S,
            trust_env=False,
            **settings,
        )

    def log(self) -> str:
        return (self._directory / "log").read_text()

    def end(self, number: signal.Signals = signal.SIGTERM) -> int:
        """Sends one signal, waits, and returns the exit code."""
        return end_process(self.process, number)
