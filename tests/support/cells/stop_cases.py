"""Robots that are stopped: by every cause, in every phase of a trial, at any moment.

A bench has a server, a robot without a body that writes down when it moves, an operator
and a client. A case brings the trial into a phase, lets something happen, and reads
when the robot stopped.
"""

import contextlib
import json
import random
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import httpx

from reference_server.rules.runs.lifecycle import OPEN_STATES
from reference_sim.external import LIBRARIES
from tests.support.network.links import Link, LinkThread
from tests.support.paths import ROOT
from tests.support.servers import TIMEOUT_S, TOKENS, ReferenceServer
from tests.support.waiting import wait_until

CELL = ROOT / "examples" / "cells" / "simulated_cell.py"
CELL_ID = "simulated_cell"
WATCHDOG_S, STOP_WITHIN_S = 1.0, 0.25  # as the cell declares them
UNANSWERED = "a judgement needs an answer, yes or no; nothing was changed"
LEASE_S = 1.0
OPERATOR = "operator-token"
SECOND_OPERATOR = "second-operator-token"
PHASES = ("preparing", "resetting", "between turns", "in a turn")
ACTION = {"values": {"velocity": [0.3, 0.1]}}


class Drive:
    """Drives to where the instruction says."""

    def reset(self, instruction: str) -> None:
        self.x = 0.3 if "right" in instruction else -0.3

    def act(self, observation: Any) -> list[dict[str, list[float]]]:
        assert observation.images["front"].shape == (48, 64, 3)
        return [{"velocity": [self.x, 0.0]}] * 20


@dataclass(frozen=True)
class Stopped:
    """after_s: from what happened to the stop. limit_s: the longest that may be.
    moved_after: whether the robot was driven again before it was reset."""

    cause: str
    phase: str
    after_s: float
    limit_s: float
    moved_after: bool

    @property
    def is_right(self) -> bool:
        return self.after_s <= self.limit_s and not self.moved_after


class StopBench:
    """One server and one robot, for many cases one after the other.

    link: the connection of the server to the robot, one of the links.
    """

    def __init__(
        self,
        folder: Path,
        links: LinkThread,
        link: Link,
        server: ReferenceServer,
    ) -> None:
        self._links, self._link = links, link
        self._log = folder / "arm.log"
        self._acts = server.database_file.with_name("proctor.sqlite.cells.jsonl")
        self.server = server
        self.refusal = ""
        self._turn: dict[str, Any] = {}
        self._pending = self._later(lambda: None)
        self._open_clients()

    def _open_clients(self) -> None:
        self._client = self.server.client("alice")
        self._operator = self.server.client("alice")
        self.hand_over(OPERATOR)

    # --- the operator and the client ---

    def hand_over(self, token: str) -> None:
        """Act with the token of another operator from now on."""
        self._operator.headers["Authorization"] = f"Bearer {token}"

    def cell(self) -> dict[str, Any]:
        shown: dict[str, Any] = self._operator.get(f"/v1/cells/{CELL_ID}").json()
        return shown

    def acts(self) -> list[dict[str, Any]]:
        """The acts of operators, as the server keeps them."""
        lines = self._acts.read_text().splitlines() if self._acts.exists() else []
        return [json.loads(line) for line in lines]

    def act(self, act: str, **members: Any) -> httpx.Response:
        body = {"act": act, **members}
        return self._operator.post(f"/v1/cells/{CELL_ID}/acts", json=body)

    def begin(self) -> str:
        """A run whose worker attaches; returns its path. The trial is `preparing`."""
        since = self._log_bytes()
        submit = {
            "benchmark_id": CELL_ID,
            "policy": {"name": "p"},
            "idle_timeout_s": LEASE_S,
        }
        run = self._client.post("/v1/runs", json=submit).raise_for_status().json()
        path = f"/v1/runs/{run['run_id']}"
        wait_until(lambda: self._client.get(path).json()["state"] == "ready", "ready")
        self._turn = {}
        self._pending = self._later(self._attach, f"{path}/workers/w")
        wait_until(lambda: self.cell()["phase"] == "preparing", "a trial is prepared")
        wait_until(lambda: "stopped" in self._noted(since), "the robot is reached")
        return path

    def _attach(self, worker: str) -> None:
        while not self._turn:
            answer = self._client.put(worker, json={"attach_key": "k" * 16})
            if answer.status_code == 200:
                self._turn = answer.json()
            elif answer.status_code != 503:
                return

    def _predict(self, worker: str, actions: int) -> None:
        body = {
            "session_id": self._turn["session_id"],
            "seq": self._turn["seq"] + 1,
            "actions": [ACTION] * actions,
        }
        answer = self._client.post(f"{worker}/predict", json=body)
        self.refusal = answer.text if answer.status_code == 422 else ""
        if answer.status_code == 200:
            self._turn = answer.json()

    def _later(self, work: Callable[..., None], *given: Any) -> threading.Thread:
        def call() -> None:
            with contextlib.suppress(httpx.HTTPError):  # the server was killed
                work(*given)

        thread = threading.Thread(target=call, daemon=True)
        thread.start()
        return thread

    def bring_into(self, phase: str, run: str) -> None:
        if phase == "preparing":
            return
        self.act("ready", trial=self.cell()["trial"]).raise_for_status()
        if phase == "resetting":
            return
        wait_until(lambda: bool(self._turn), "the first turn is answered")
        if phase == "in a turn":
            self.predict_later(run)

    def predict_later(self, run: str) -> None:
        """Send a chunk of two seconds; its answer may wait for a person."""
        self._later(self._predict, f"{run}/workers/w", 40)

    # --- causes ---

    def happen(self, cause: str, run: str) -> float:
        """Let it happen; returns how long the stop may take from then."""
        if cause == "stop now":
            self._operator.post(f"/v1/cells/{CELL_ID}/stop")
        elif cause == "abort":
            self._client.post(f"{run}/stop", json={"mode": "abort"})
        elif cause == "detach":
            worker = f"{run}/workers/w"
            session = {"session_id": self._turn["session_id"]}
            self._client.delete(worker, params=session)
        elif cause == "killed server":
            self.server.end(signal.SIGKILL)
        elif cause == "frozen server":
            self.server.process.send_signal(signal.SIGSTOP)
        elif cause == "cut network":
            self._links.call(self._link.cut)
        elif cause == "silent network":
            self._links.call(self._link.hold)
        return LIMITS_S[cause]

    def restore(self) -> None:
        """Make the bench ready for another case or test, however the last one ended."""
        if self.server.process.poll() is None:
            self.server.process.send_signal(signal.SIGCONT)
        else:
            self.restart()
        self._links.call(self._link.cut, self._link.heal)
        for run in self._client.get("/v1/runs").json()["runs"]:
            if run["state"] in OPEN_STATES:
                path = f"/v1/runs/{run['run_id']}/stop"
                self._client.post(path, json={"mode": "abort"})
        self._pending.join(TIMEOUT_S)
        self.act("claim", takes_over=True)
        wait_until(self._is_free, "the cell is free")
        self._turn = {}

    def _is_free(self) -> bool:
        cell = self.cell()
        if cell["phase"] == "judging":
            self.act("void", trial=cell["trial"], reason="a case is over")
        elif cell["phase"] == "done":
            self.act("next", trial=cell["trial"])
        return bool(cell["phase"] == "free")

    def restart(self) -> None:
        """Start the server again, which was killed."""
        self.close()
        self.server.start()
        self._open_clients()
        self.act("claim", takes_over=True)

    def close(self) -> None:
        self._client.close()
        self._operator.close()

    def play_case(self, cause: str, phase: str, chance: random.Random) -> Stopped:
        run = self.begin()
        self.bring_into(phase, run)
        time.sleep(chance.uniform(0.0, DELAYS_S[phase]))
        # On a busy machine a turn may come too late, and the robot stand still already.
        stands = self._noted(0).split()[-1] == "stopped"
        since = self._log_bytes()
        before_s = time.monotonic()
        limit_s = self.happen(cause, run)
        if stands and limit_s == _BY_WATCHDOG_S:
            self.restore()
            return Stopped(cause, phase, 0.0, limit_s, moved_after=False)
        wait_until(
            lambda: "stopped" in self._noted(since), f"a stop by {cause}, {phase}"
        )
        stopped = self._read(cause, phase, since, before_s, limit_s)
        assert self.refusal == ""
        self.restore()
        return stopped

    def _log_bytes(self) -> int:
        return self._log.stat().st_size

    def _noted(self, since: int) -> str:
        with self._log.open() as log:
            log.seek(since)
            return log.read()

    def _read(
        self, cause: str, phase: str, since: int, before_s: float, limit_s: float
    ) -> Stopped:
        time.sleep(0.1)  # what moves afterwards is seen
        lines = [line.split() for line in self._noted(since).splitlines()]
        events = [event for _, event in lines]
        place = events.index("stopped")
        after = events[place:]
        if "enabled" in after:
            after = after[: after.index("enabled")]
        stopped_s = float(lines[place][0]) - before_s
        return Stopped(cause, phase, stopped_s, limit_s, "drives" in after)


DELAYS_S = {
    "preparing": 0.05,
    "resetting": 0.15,
    "between turns": 0.4,
    "in a turn": 1.0,
}
_AT_ONCE_S, _BY_WATCHDOG_S = STOP_WITHIN_S, WATCHDOG_S + STOP_WITHIN_S
# No rule says how soon the end of a server or of a connection is seen; the watchdog
# bounds it.
LIMITS_S = {
    "stop now": _AT_ONCE_S,
    "abort": _AT_ONCE_S,
    "detach": _AT_ONCE_S,
    "killed server": _BY_WATCHDOG_S,
    "cut network": _BY_WATCHDOG_S,
    "frozen server": _BY_WATCHDOG_S,
    "silent network": _BY_WATCHDOG_S,
    "killed client": _BY_WATCHDOG_S,
}
# A client has a session to detach, or is waited for, only when its attempt has begun; a
# robot that stands still while a person prepares it has no watchdog.
NOT_IN = {
    "detach": {"preparing", "resetting"},
    "killed client": {"preparing", "resetting", "in a turn"},
    "frozen server": {"preparing"},
    "silent network": {"preparing"},
}
CASES = [
    (cause, phase)
    for cause in LIMITS_S
    for phase in PHASES
    if phase not in NOT_IN.get(cause, ())
]


@contextmanager
def running_robot(folder: Path, name: str = "robot") -> Iterator[Path]:
    """A robot that listens at the socket; it writes `arm.log` if it is the only one."""
    address = folder / f"{name}.sock"
    command = [sys.executable, str(CELL), f"unix:{address}", "--errs=0"]
    log = "arm.log" if name == "robot" else f"{name}-arm.log"
    with (folder / f"{name}.log").open("wb") as errors:
        process = subprocess.Popen(
            [*command, f"--log={folder / log}"],
            env={"PYTHONPATH": str(LIBRARIES)},
            stdout=errors,
            stderr=errors,
        )
    try:
        wait_until(address.exists, "the robot listens")
        yield address
    finally:
        process.kill()
        process.wait()


@contextmanager
def serving_cells(
    folder: Path, simulator: str, repetitions: int
) -> Iterator[ReferenceServer]:
    """A server with operators. simulator: a line of the benchmark's file."""
    benchmark = folder / f"{CELL_ID}.toml"
    benchmark.write_text(
        f"{simulator}\n"
        f'[[splits]]\nname = "test"\nepisodes = {repetitions}\nfirst_seed = 0\n'
    )
    tokens = f"alice:read+run:{TOKENS['alice']},olga:operator:{OPERATOR}"
    tokens += f",otto:operator:{SECOND_OPERATOR}"
    settings = {
        "PROCTOR_BENCHMARKS": str(benchmark),
        "PROCTOR_TOKENS": tokens,
        "PROCTOR_MAX_OPEN_RUNS": "100000",
    }
    with ReferenceServer(folder, **settings) as server:
        yield server


@contextmanager
def stop_bench(folder: Path, repetitions: int = 2) -> Iterator[StopBench]:
    """A server, and a robot behind a link. repetitions: of each of two setups."""
    relayed = folder / "relay.sock"
    simulator = f"simulator = {json.dumps([f'unix:{relayed}'])}"
    with running_robot(folder) as robot, LinkThread(seed=0) as links:
        link = links.open_path(relayed, robot)
        with serving_cells(folder, simulator, repetitions) as server:
            bench = StopBench(folder, links, link, server)
            bench.act("claim").raise_for_status()
            yield bench
            bench.close()
