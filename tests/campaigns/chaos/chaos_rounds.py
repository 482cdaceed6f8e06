"""What rounds found: added up, and kept in a file so that a long campaign can go on.

A long campaign takes hours. What it has played on a commit, with the same players and
lease, is not played again when it is started again. Several clusters may be broken at
once, by a process each: what one has played the others need not play.
"""

from __future__ import annotations

import fcntl
import json
import operator
from collections import Counter
from collections.abc import Sequence
from dataclasses import asdict, astuple, dataclass, field
from pathlib import Path
from typing import Any

from tests.campaigns.chaos.chaos_faults import FAULTS, PROMISED, Fault

FILE = Path(__file__).resolve().parents[3] / "var" / "chaos.jsonl"
# Of each fault in a long campaign, also where nothing is promised.
ROUNDS_MIN = 10


@dataclass
class Counts:
    """Of a campaign, or of rounds of it.

    operations: turns, starts and changes of push runs. compared: turns with two
    answers. writes: of runs and episodes, that were judged. records: of completed runs.
    """

    runs: int = 0
    operations: int = 0
    claims: int = 0
    compared: int = 0
    writes: int = 0
    records: int = 0

    def __add__(self, other: Counts) -> Counts:
        return Counts(*map(operator.add, astuple(self), astuple(other)))

    def __sub__(self, other: Counts) -> Counts:
        return Counts(*map(operator.sub, astuple(self), astuple(other)))


@dataclass
class Round:
    """waits_s: of each player, the longest time without success since the fault.

    number, seed: that chose the fault and when it ends. count: how often it broke what
    its fault is promised for. counts: of this round.
    """

    number: int
    fault: Fault
    waits_s: list[float] = field(default_factory=list)
    findings: list[str] = field(default_factory=list)
    count: int = 0
    counts: Counts = field(default_factory=Counts)
    seed: int = 0


def broken_so_far(rounds: Sequence[Round]) -> Counter[str]:
    """How often each promise was tried."""
    broken: Counter[str] = Counter()
    for one in rounds:
        broken[one.fault.promise] += one.count
    return broken


def faults_to_play(rounds: Sequence[Round]) -> list[str]:
    """Names of the faults that a long campaign has played too rarely; none: it ends."""
    broken = broken_so_far(rounds)
    played = Counter(one.fault.name for one in rounds)
    return [
        name
        for name, fault in FAULTS.items()
        if played[name] < ROUNDS_MIN
        or broken[fault.promise] < PROMISED.get(fault.promise, 0)
    ]


class KeptRounds:
    """Rounds of one campaign, in a file that several processes may add to.

    under: commit and whatever else has to be equal. file: None keeps them for this
    process alone. loads: of the machine before each round.
    """

    def __init__(self, under: dict[str, Any], file: Path | None = FILE) -> None:
        self._under, self._file = under, file
        self._read_to = 0
        self.rounds: list[Round] = []
        self.loads: list[float] = []
        self.refresh()

    def refresh(self) -> None:
        """Read what was added to the file since the last time."""
        if self._file is None or not self._file.exists():
            return
        with self._file.open("rb") as file:
            file.seek(self._read_to)
            # What another process is just writing has no end yet.
            whole, end, _ = file.read().rpartition(b"\n")
        self._read_to += len(whole + end)
        for line in whole.splitlines():
            self._take(json.loads(line))

    def _take(self, line: dict[str, Any]) -> None:
        if line.pop("under") == self._under:
            self.loads.append(line.pop("load"))
            fault, counts = FAULTS[line.pop("fault")], Counts(**line.pop("counts"))
            self.rounds.append(Round(fault=fault, counts=counts, **line))

    def add(self, played: Round, load: float) -> None:
        """Keep a round that was just played."""
        line = {"under": self._under, "load": load}
        line |= asdict(played) | {"fault": played.fault.name}
        if self._file is None:
            self._take(line)
            return
        self._file.parent.mkdir(exist_ok=True)
        with self._file.open("a") as file:
            fcntl.flock(file, fcntl.LOCK_EX)
            file.write(json.dumps(line) + "\n")
        self.refresh()

    def played_with(self, seed: int) -> int:
        """How many rounds were chosen by this seed."""
        return sum(one.seed == seed for one in self.rounds)
