"""Interleaved rounds: in every round, each contender plays a few turns.

So disturbances of the machine affect all contenders alike. A contender is two
processes, a server and a client (contender_process.py), which are idle while others
play. CPU time is that of their own turns, of all processes of the server; a client
measures its own. Knows no contender.
"""

import contextlib
import json
import os
import subprocess
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Self

from benchmarks.measuring import ROOT, in_turn, percentile, tree_cpu_s

_EXIT_TIMEOUT_S = 10.0


@dataclass(frozen=True, slots=True)
class Contender:
    """server: a command that prints a line with its address behind `ready` or `at`.

    client: a command; the address takes the place of `{}`.
    """

    name: str
    server: Sequence[str]
    client: Sequence[str]
    environment: Mapping[str, str] = field(default_factory=dict)


@dataclass(slots=True)
class TurnTimes:
    """The time of one contender's turns: each in ns, and seconds of CPU for all."""

    ns: list[int] = field(default_factory=list)
    server_cpu_s: float = 0.0
    client_cpu_s: float = 0.0

    def percentile_ms(self, percent: int) -> float:
        """Milliseconds."""
        return percentile(self.ns, percent) / 1e6

    def cpu_ms(self) -> tuple[float, float]:
        """Milliseconds of CPU of one turn, in the server and in the client."""
        turns = len(self.ns)
        return 1e3 * self.server_cpu_s / turns, 1e3 * self.client_cpu_s / turns


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
            command = [part.replace("{}", address) for part in self._contender.client]
            self._client = self._start(command)
            self._line(self._client, "ready")
        except BaseException:
            self.close()
            raise
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """End both processes; a client disconnects at the end of its stdin."""
        while self._processes:
            process = self._processes.pop()
            assert process.stdin is not None
            assert process.stdout is not None
            with contextlib.suppress(BrokenPipeError):
                process.stdin.close()
            if not self._processes:  # the server, which was started first
                process.terminate()
            try:
                process.wait(_EXIT_TIMEOUT_S)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()
            process.stdout.close()

    def play(self, turns: int, *, whole: bool = False) -> TurnTimes:
        """Play turns. whole: every pixel is compared. Raises ContenderFailed."""
        assert self._client.stdin is not None
        before_s = tree_cpu_s(self._server.pid)
        # Where the client has ended, its output explains the failure.
        with contextlib.suppress(BrokenPipeError):
            word = "check" if whole else "play"
            self._client.stdin.write(f"{word} {turns}\n")
            self._client.stdin.flush()
        reply: Any = json.loads(self._line(self._client))
        server_s = tree_cpu_s(self._server.pid) - before_s
        return TurnTimes(reply["ns"], server_s, reply["cpu_ns"] / 1e9)

    def _start(self, command: Sequence[str]) -> subprocess.Popen[str]:
        chosen = {"OPENBLAS_NUM_THREADS": "1", **self._contender.environment}
        process = subprocess.Popen(
            list(command),
            cwd=ROOT,
            env=os.environ | chosen,
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

    def _line(self, process: subprocess.Popen[str], wanted: str = "") -> str:
        assert process.stdout is not None
        line = process.stdout.readline()
        if not line or wanted not in line:
            raise ContenderFailed(f"{self.name}: {process.args!r} said {line!r}")
        return line.strip()


@contextlib.contextmanager
def started(contenders: Sequence[Contender]) -> Iterator[list[ContenderPair]]:
    """All pairs at once."""
    with contextlib.ExitStack() as stack:
        yield [stack.enter_context(ContenderPair(each)) for each in contenders]


def play(
    pairs: Sequence[ContenderPair], rounds: int, turns: Mapping[str, int]
) -> dict[str, TurnTimes]:
    """Play `turns` of each contender in each round; each round begins with another."""
    played = {pair.name: TurnTimes() for pair in pairs}
    for pair in in_turn(pairs, rounds):
        times, added = played[pair.name], pair.play(turns[pair.name])
        times.ns += added.ns
        times.server_cpu_s += added.server_cpu_s
        times.client_cpu_s += added.client_cpu_s
    return played
