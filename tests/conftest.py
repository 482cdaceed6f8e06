"""What several test files build: a run for the rules, a server in its own process."""

import contextlib
import os
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import httpx
import pytest

from reference_server.rules.run import Episode, Run, Session

# A shell that starts us in the background has us ignore Ctrl-C, and our children would
# inherit that: those that test Ctrl-C would wait for ever.
signal.signal(signal.SIGINT, signal.default_int_handler)

TOKENS = {"alice": "alice-token", "bob": "bob-token", "reader": "reader-token"}
TIMEOUT_S = 30.0
NOW = 1000.0
ACTION: dict[str, list[float]] = {"arm": [0.0, 0.5], "grip": [1.0], "head": [2.0]}


def make_run(length: int = 3, *, run_type: type[Run] = Run, **changes: Any) -> Run:
    """A run as the rules see it; its episodes hold nothing but their number."""
    vector = {"size": 2, "out_of_range": "unbounded", "rotation": "none"}
    bounds = {"size": 1, "minimum": [0.0], "maximum": [1.0]}
    manifest = {
        "benchmark_id": "calibration",
        "control_rate_hz": 10.0,
        "max_steps": 10,
        "max_chunk": 4,
        "max_attempts": 2,
        "max_faults": 2,
        "action_space": {
            "arm": vector,
            "grip": bounds | {"out_of_range": "refuse"},
            "head": bounds | {"out_of_range": "clip"},
        },
        "observation_space": {"state": {"joints": vector | {"unit": "rad"}}},
        "episodes": [
            {"task": "score", "split": "even", "seed": i} for i in range(length)
        ],
    }
    fields: dict[str, Any] = {
        "run_id": "run_1",
        "number": 1,
        "account": "alice",
        "state": "ready",
        "reason": None,
        "retryable": None,
        "manifest": manifest,
        "manifest_sha256": "0" * 64,
        "submission": {"benchmark_id": "calibration", "policy": {"name": "p"}},
        "max_workers": 2,
        "idle_timeout_s": 10.0,
        "images": {"codec": "raw", "width": 16, "height": 12},
        "created_at_wall": 1000.0,
        "updated_at_wall": 1000.0,
        "queue_until_wall": 0.0,
        "episodes": [Episode(i, "score", "even", i) for i in range(length)],
    }
    return run_type(**fields | changes)


def add_session(run: Run, worker_id: str = "w", **changes: Any) -> Session:
    """A live session in a running run: seq 3 was answered, the lease has begun."""
    fields: dict[str, Any] = {
        "session_id": f"session-of-{worker_id}",
        "worker_id": worker_id,
        "attach_key": "key",
        "idle_timeout_s": 10.0,
        "max_steps": 10,
        "expires_at": NOW + 10.0,
        "episode": Episode(0, "score", "even", 0),
        "seq": 3,
        "request": ([ACTION], "last"),
        "turn": {"seq": 3},
    }
    session = Session(**fields | changes)
    run.workers[worker_id] = session
    run.state = "running"
    return session


class ReferenceServer:
    """The reference server in a process of its own, on a free port."""

    def __init__(self, directory: Path, **settings: str) -> None:
        self._directory = directory
        self._settings = settings
        self.start()

    def start(self) -> None:
        tokens = "alice:read+run:{alice},bob:read+run:{bob},alice:read:{reader}"
        settings = {
            "PROCTOR_PORT": "0",
            "PROCTOR_DATABASE": str(self._directory / "proctor.sqlite"),
            "PROCTOR_TOKENS": tokens.format(**TOKENS),
        } | self._settings
        with (self._directory / "log").open("ab") as log:
            self.process = subprocess.Popen(
                [sys.executable, "-m", "reference_server"],
                cwd=Path(__file__).resolve().parent.parent,
                env=os.environ | settings,
                stdout=subprocess.PIPE,
                stderr=log,
                text=True,
            )
        assert self.process.stdout is not None
        startup_line = self.process.stdout.readline()
        assert startup_line, (self._directory / "log").read_text()[-2000:]
        self.url = startup_line.split()[-1]

    def client(self, token_name: str = "alice", **settings: Any) -> httpx.Client:
        headers = {"Authorization": f"Bearer {TOKENS[token_name]}"}
        # The environment may name a proxy; this machine is never behind it.
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
        if self.process.poll() is None:
            self.process.send_signal(number)
        code = self.process.wait(TIMEOUT_S)
        assert self.process.stdout is not None
        self.process.stdout.close()
        return code


def descendants(pid: int) -> set[int]:
    """Ids of all processes that this one and its children started."""
    listed = subprocess.run(
        ["ps", "-e", "-o", "pid=,ppid="], check=True, capture_output=True, text=True
    ).stdout
    parents = {int(p): int(q) for p, q in map(str.split, listed.splitlines())}
    found = {pid}
    while more := {p for p, q in parents.items() if q in found} - found:
        found |= more
    return found - {pid}


def wait_until_ended(pids: set[int]) -> None:
    """Waits until the processes are gone; a zombie is gone."""
    deadline = time.monotonic() + TIMEOUT_S
    while alive := {pid for pid in pids if _is_alive(pid)}:
        assert time.monotonic() < deadline, f"{alive} still live"
        time.sleep(0.01)


def _is_alive(pid: int) -> bool:
    with contextlib.suppress(FileNotFoundError, ProcessLookupError):
        stat = Path(f"/proc/{pid}/stat").read_text()
        return stat.rpartition(")")[2].split()[0] not in ("Z", "X")
    return False


@pytest.fixture
def server(tmp_path: Path) -> Iterator[ReferenceServer]:
    """A server of the test's own."""
    server = ReferenceServer(tmp_path)
    yield server
    server.end(signal.SIGKILL)
