"""Interleaved measurement: in every round, each contender plays a few turns.

So disturbances of the machine affect all contenders alike. A contender is two
processes, a server and a client (contenders/turn_client.py), which are idle while
others play. CPU time is that of their own turns, of all processes of the server; a
client measures its own. The bytes of a turn are counted before, with another client.
Knows no contender.
"""

from __future__ import annotations

import contextlib
import json
import os
import subprocess
import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Self

from benchmarks.round_trips.byte_counting_relay import ByteCounts, Relay

ROOT = Path(__file__).resolve().parents[2]
_CLOCK_OF_PROCESS = 2  # CPUCLOCK_SCHED, see clock_getcpuclockid(3)
_EXIT_TIMEOUT_S = 10.0
_WEIGHED_TURNS = 10


@dataclass(frozen=True, slots=True)
class Contender:
    """server: a command that prints a line with its address behind `ready` or `at`.

    client: a command that is given this address, then the arguments.
    """

    name: str
    server: Sequence[str]
    client: Sequence[str]
    arguments: Sequence[str]
    environment: Mapping[str, str] = field(default_factory=dict)


@dataclass(slots=True)
class TurnTimes:
    """What one contender's turns took: each in ns, CPU in seconds of all of them."""

    ns: list[int] = field(default_factory=list)
    server_cpu_s: float = 0.0
    client_cpu_s: float = 0.0


class ContenderFailed(RuntimeError):
    """A process of a contender ended or printed something unexpected."""


class ContenderPair:
    """A contender's two processes, from their start to their end."""

    def __init__(self, contender: Contender) -> None:
        self.name = contender.name
        self._processes: list[subprocess.Popen[str]] = []
        self._contender = contender

    def __enter__(self) -> Self:
        try:
            self._server = self._start(self._contender.server)
            address = self._address()
            self.byte_counts = self._measure_bytes(address)
            self._client = self._join(address)
        except BaseException:
            self.close()
            raise
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        while self._processes:
            self._end(self._processes.pop(), is_client=len(self._processes) > 0)

    def play(
        self, turns: int, played: TurnTimes | None = None, *, whole: bool = False
    ) -> None:
        """Adds to what was played. whole: every pixel is compared. Raises Failed."""
        before_s = self._server_cpu_s()
        reply = self._send_command(
            self._client, f"{'check' if whole else 'play'} {turns}"
        )
        if played is not None:
            played.ns += reply["ns"]
            played.server_cpu_s += self._server_cpu_s() - before_s
            played.client_cpu_s += reply["cpu_ns"] / 1e9

    def _measure_bytes(self, address: str) -> ByteCounts:
        """By a client that reaches the server through a relay, and is then gone."""
        with Relay(address) as relay:
            client = self._join(relay.address)
            self._send_command(client, "play 2")
            before = relay.byte_counts()
            self._send_command(client, f"play {_WEIGHED_TURNS}")
            after = relay.byte_counts()
            self._end(self._processes.pop(), is_client=True)
        return ByteCounts(
            *(
                round((b - a) / _WEIGHED_TURNS)
                for a, b in zip(before, after, strict=True)
            )
        )

    def _join(self, address: str) -> subprocess.Popen[str]:
        command = [*self._contender.client, address, *self._contender.arguments]
        client = self._start(command)
        self._line(client, "ready")
        return client

    def _start(self, command: Sequence[str]) -> subprocess.Popen[str]:
        process = subprocess.Popen(
            list(command),
            cwd=ROOT,
            env={
                **os.environ,
                "OPENBLAS_NUM_THREADS": "1",
                **self._contender.environment,
            },
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        )
        self._processes.append(process)
        return process

    def _address(self) -> str:
        while True:
            words = self._line(self._server).split()
            if words[:1] == ["ready"] or words[-2:-1] == ["at"]:
                return words[-1]

    def _send_command(self, client: subprocess.Popen[str], line: str) -> Any:
        assert client.stdin is not None
        with contextlib.suppress(
            BrokenPipeError
        ):  # its output then explains the failure
            client.stdin.write(line + "\n")
            client.stdin.flush()
        return json.loads(self._line(client))

    def _server_cpu_s(self) -> float:
        return sum(map(cpu_s, process_tree(self._server.pid)))

    def _line(self, process: subprocess.Popen[str], wanted: str = "") -> str:
        assert process.stdout is not None
        line = process.stdout.readline()
        if not line or wanted not in line:
            raise ContenderFailed(f"{self.name}: {process.args!r} said {line!r}")
        return line.strip()

    @staticmethod
    def _end(process: subprocess.Popen[str], *, is_client: bool) -> None:
        """is_client: a client exits at the end of stdin, and disconnects first."""
        assert process.stdin is not None
        assert process.stdout is not None
        with contextlib.suppress(BrokenPipeError):
            process.stdin.close()
        if not is_client:
            process.terminate()
        try:
            process.wait(_EXIT_TIMEOUT_S)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()
        process.stdout.close()


def process_tree(pid: int) -> list[int]:
    """A process and its descendants."""
    found = [pid]
    for parent in found:
        for children in Path(f"/proc/{parent}/task").glob("*/children"):
            with contextlib.suppress(OSError):
                found += map(int, children.read_text().split())
    return found


def cpu_s(pid: int) -> float:
    """Seconds that a process has computed; 0 if it has gone."""
    try:
        return time.clock_gettime((~pid << 3) | _CLOCK_OF_PROCESS)
    except OSError:
        return 0.0


def play(
    pairs: Sequence[ContenderPair], rounds: int, turns: Mapping[str, int]
) -> dict[str, TurnTimes]:
    """Plays `turns` of each contender in each round; each round begins with another."""
    played = {pair.name: TurnTimes() for pair in pairs}
    for number in range(rounds):
        first = number % len(pairs)
        for pair in (*pairs[first:], *pairs[:first]):
            pair.play(turns[pair.name], played[pair.name])
    return played
