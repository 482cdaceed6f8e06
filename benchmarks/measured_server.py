"""A reference server as a process of its own, and one lasting connection to it."""

import http.client
import json
import os
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

from benchmarks.measuring import ROOT, cpu_s

TOKEN = "bench"  # noqa: S105 - opens nothing but the server of the benchmark
HEADERS = {"Authorization": f"Bearer {TOKEN}", "Content-Type": "application/json"}


class ServerProcess:
    """A server on one database, a file or a URL. Linux only: it reads /proc."""

    def __init__(
        self, database: Path | str, module: str = "reference_server", **settings: str
    ) -> None:
        chosen = {
            "PROCTOR_PORT": "0",
            "PROCTOR_TOKENS": f"bench:read+run:{TOKEN}",
            "PROCTOR_DATABASE": str(database),
            "PROCTOR_MAX_ACTIVE_RUNS": "100000",
            "PROCTOR_WAIT_S_MAX": "120",
            "PROCTOR_MAX_EVENT_STREAMS": "1000",
        }
        self.process = subprocess.Popen(
            [sys.executable, "-m", module],
            cwd=ROOT,
            env=os.environ | chosen | settings,
            stdout=subprocess.PIPE,
            text=True,
        )
        assert self.process.stdout is not None
        self.url = self.process.stdout.readline().split()[-1]
        self.netloc = urlsplit(self.url).netloc
        self._connection = http.client.HTTPConnection(self.netloc)

    def ask(self, method: str, path: str, body: Any = None) -> Any:
        """The decoded answer; anything but a success ends the program."""
        data = None if body is None else json.dumps(body)
        self._connection.request(method, path, data, HEADERS)
        answer = self._connection.getresponse()
        read = answer.read()
        if answer.status >= 300:
            raise RuntimeError(f"{method} {path}: {answer.status} {read[:300]!r}")
        is_json = answer.headers.get_content_type() == "application/json"
        return json.loads(read) if read and is_json else None

    def memory_mb(self) -> float:
        return self._count("status", "VmRSS") / 1024

    def written_bytes(self) -> int:
        return self._count("io", "write_bytes")

    def _count(self, file: str, name: str) -> int:
        lines = Path(f"/proc/{self.process.pid}/{file}").read_text().splitlines()
        (line,) = (line for line in lines if line.startswith(f"{name}:"))
        return int(line.split()[1])

    def cpu_s(self) -> float:
        return cpu_s(self.process.pid)

    def end(self) -> None:
        self._connection.close()
        self.process.terminate()
        self.process.wait()
        assert self.process.stdout is not None
        self.process.stdout.close()


@contextmanager
def running_server(
    database: Path | str, module: str = "reference_server", **settings: str
) -> Iterator[ServerProcess]:
    server = ServerProcess(database, module, **settings)
    try:
        yield server
    finally:
        server.end()


class TimedRun:
    """A run with one worker `w` that plays over the connection of a server.

    values: of every action. The run of `calibration` is one long task.
    """

    def __init__(
        self, server: ServerProcess, run_id: str, values: dict[str, list[float]]
    ) -> None:
        self._server = server
        self.worker = f"/v1/runs/{run_id}/workers/w"
        self.turn = server.ask("PUT", self.worker, {"attach_key": "k"})
        self._values = values

    def play(self, **values: float) -> None:
        """Play a turn of one action; values: instead of those of every action."""
        chosen = self._values | {name: [value] for name, value in values.items()}
        self._body = {
            "session_id": self.turn["session_id"],
            "seq": self.turn["seq"] + 1,
            "actions": [{"values": chosen}],
        }
        self.repeat()

    def repeat(self) -> None:
        """Send the last turn again."""
        path = f"{self.worker}/predict"
        self.turn = self._server.ask("POST", path, self._body)

    def detach(self) -> None:
        session_id = self.turn["session_id"]
        self._server.ask("DELETE", f"{self.worker}?session_id={session_id}")


def submit(server: ServerProcess, benchmark_id: str, **members: Any) -> str:
    """The id of a new run."""
    body = {"benchmark_id": benchmark_id, "policy": {"name": "bench"}, **members}
    return str(server.ask("POST", "/v1/runs", body)["run_id"])
