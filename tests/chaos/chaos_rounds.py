"""What rounds found: added up, and kept in a file so that a long campaign can go on.

A long campaign takes hours. What it has played on a commit, with the same seed,
players and lease, is not played again when it is started again.
"""

from __future__ import annotations

import json
import operator
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import asdict, astuple, dataclass, field
from pathlib import Path
from typing import Any

from tests.chaos.chaos_faults import FAULTS, PROMISED, Fault

FILE = Path(__file__).resolve().parents[2] / "var" / "chaos.jsonl"
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

    count: how often it broke what its fault is promised for. counts: of this round.
    """

    number: int
    fault: Fault
    waits_s: list[float] = field(default_factory=list)
    findings: list[str] = field(default_factory=list)
    count: int = 0
    counts: Counts = field(default_factory=Counts)


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
    """Rounds of one campaign in a file. under: commit, seed and whatever else is equal.

    load: of the machine before each round.
    """

    def __init__(self, under: dict[str, Any], file: Path = FILE) -> None:
        self._under, self._file = under, file
        self.rounds: list[Round] = []
        self.loads: list[float] = []
        for line in self._lines():
            if line.pop("under") == under:
                self.loads.append(line.pop("load"))
                fault = FAULTS[line.pop("fault")]
                counts = Counts(**line.pop("counts"))
                self.rounds.append(Round(fault=fault, counts=counts, **line))

    def _lines(self) -> Iterator[dict[str, Any]]:
        if self._file.exists():
            yield from map(json.loads, self._file.read_text().splitlines())

    def add(self, played: Round, load: float) -> None:
        """Keep a round that was just played."""
        self.rounds.append(played)
        self.loads.append(load)
        line = {"under": self._under, "load": load}
        line |= asdict(played) | {"fault": played.fault.name}
        self._file.parent.mkdir(exist_ok=True)
        with self._file.open("a") as file:
            file.write(json.dumps(line) + "\n")
