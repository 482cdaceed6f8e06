"""Judges a sample of the mutants of a server; one line of JSON for each.

A campaign can be ended at any time and goes on where it was: what has a line is not
judged again, unless its outcome is named by `again`. The last line of an id counts.
"""

import datetime as dt
import hashlib
import json
import queue
import tempfile
import threading
from collections import Counter
from collections.abc import Callable, Collection, Iterable
from concurrent.futures import ThreadPoolExecutor, as_completed
from dataclasses import asdict, dataclass
from pathlib import Path

from tests.mutation.judge import Judgement, judge
from tests.mutation.syntax import MutantSource
from tests.mutation.targets import ROOT, Target
from tests.support.forking.forked_kits import kit_command
from tools.measurements.git_commit import read_commit

RESULTS = ROOT / "var" / "mutation"


@dataclass(frozen=True, slots=True)
class Record:
    """One line of the results."""

    id: str
    file: str
    line: int
    function: str
    operator: str
    original: str
    replacement: str
    outcome: str  # of Judgement, or `invalid`: no program
    failed: list[str]
    conclusion: str
    elapsed_s: float
    seed: int
    kit: str  # the commit
    date: str


def choose(mutants: Iterable[MutantSource], size: int, seed: int) -> list[MutantSource]:
    """A random sample; that of a smaller size is a part of it. 0: all."""
    by_chance = sorted(
        mutants, key=lambda one: hashlib.sha256(f"{seed} {one.id}".encode()).digest()
    )
    return by_chance[:size] if size else by_chance


def read_results(path: Path) -> dict[str, Record]:
    """The last record of each id."""
    if not path.exists():
        return {}
    records = [Record(**json.loads(line)) for line in path.read_text().splitlines()]
    return {record.id: record for record in records}


def results_of(target: Target) -> Path:
    """The file of a server's results."""
    return RESULTS / f"{target.name}.jsonl"


class Killers:
    """Which rules failed by changes of the same function, file, or at all."""

    def __init__(self) -> None:
        self._counts: dict[tuple[str, ...], Counter[str]] = {}

    def add(self, record: Record) -> None:
        """Count the rules that a mutant broke."""
        for place in _places(record.file, record.function):
            self._counts.setdefault(place, Counter()).update(record.failed)

    def of(self, file: str, function: str) -> list[str]:
        """The rules that failed before: the nearest and most frequent first."""
        found: dict[str, None] = {}
        for place in _places(file, function):
            for rule, _ in self._counts.get(place, Counter()).most_common():
                found[rule] = None
        return list(found)


def _places(file: str, function: str) -> list[tuple[str, ...]]:
    return [(file, function), (file,), ()]


class Campaign:
    """Copies of a server that threads change and give to the kit."""

    def __init__(self, target: Target, seed: int, jobs: int, path: Path) -> None:
        self._target = target
        self._seed = seed
        self._jobs = jobs
        self._path = path
        self._commit, _ = read_commit()
        self._lock = threading.Lock()
        self._copies: queue.Queue[Path] = queue.Queue()
        self._kit: tuple[str, ...] = ()
        self._killers = Killers()

    def run(
        self,
        mutants: Iterable[MutantSource],
        again: Collection[str],
        report: Callable[[Record], None],
    ) -> None:
        """Judge what has no result yet."""
        known = read_results(self._path)
        for record in known.values():
            self._killers.add(record)
        done = {id_ for id_, one in known.items() if one.outcome not in again}
        left = [one for one in mutants if one.id not in done]
        self._path.parent.mkdir(parents=True, exist_ok=True)
        self._kit = kit_command()
        with (
            tempfile.TemporaryDirectory(prefix="proctor-mutation-") as directory,
            ThreadPoolExecutor(self._jobs) as executor,
        ):
            for number in range(self._jobs):
                copy = Path(directory, str(number))
                self._target.copy_to(copy)
                self._target.build(copy)
                self._copies.put(copy)
            self._require_conformant()
            futures = [executor.submit(self._judge, one) for one in left]
            try:
                for future in as_completed(futures):
                    report(future.result())
            finally:  # what is being judged comes to its end, so that servers end
                executor.shutdown(cancel_futures=True)

    def _require_conformant(self) -> None:
        """The unchanged server: every mutant of another one would be killed."""
        copy = self._copies.get()
        found = judge(self._kit, self._target.start_command(copy), self._seed)
        self._copies.put(copy)
        assert found.outcome == "survived", f"{found.failed} {found.conclusion}"

    def _judge(self, mutant: MutantSource) -> Record:
        copy = self._copies.get()
        try:
            problem = self._target.change(mutant, copy)
            if problem is None:
                start = self._target.start_command(copy)
                likely = self._killers.of(mutant.file, mutant.function)
                found = judge(self._kit, start, self._seed, likely)
            else:
                found = Judgement("invalid", [], problem, 0.0)
        finally:
            self._target.restore(mutant, copy)
            self._copies.put(copy)
        today = dt.datetime.now(dt.UTC).date().isoformat()
        record = Record(
            id=mutant.id,
            file=mutant.file,
            line=mutant.line,
            function=mutant.function,
            operator=mutant.operator,
            original=mutant.original,
            replacement=mutant.edit.replacement,
            outcome=found.outcome,
            failed=found.failed,
            conclusion=found.conclusion,
            elapsed_s=found.elapsed_s,
            seed=self._seed,
            kit=self._commit,
            date=today,
        )
        with self._lock, self._path.open("a") as file:
            self._killers.add(record)
            file.write(json.dumps(asdict(record), ensure_ascii=False) + "\n")
        return record
