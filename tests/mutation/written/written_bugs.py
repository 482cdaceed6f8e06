"""Bugs that people wrote without a look at the kit, and what the kit says of each.

There is a file of bugs for each server: each is one replacement in one file, and
breaks rules that it names. What the kit says of them is in var/mutation/, one line of
JSON for each time: judge new bugs before a check is changed for them, so that the first
line of a bug is of a kit that had not seen it, and keep those that it did not notice.
"""

import tomllib
from dataclasses import dataclass
from pathlib import Path

from tests.mutation.campaign import RESULTS, read_results
from tests.mutation.page import NOTICED
from tests.mutation.syntax import Edit, MutantSource
from tests.mutation.targets import ROOT, Target

FOLDER = Path(__file__).parent


@dataclass(frozen=True, slots=True)
class WrittenBug:
    """rules: that it breaks; seen: by a client, and what the client should see."""

    mutant: MutantSource
    rules: tuple[str, ...]
    seen: str


def results_of_written(target: Target) -> Path:
    """The file of what the kit said of a server's bugs."""
    return RESULTS / f"written-{target.name}.jsonl"


def read_bugs(target: Target) -> list[WrittenBug]:
    """Give the bugs of a server; ValueError if one does not fit the server of today."""
    written = tomllib.loads((FOLDER / f"{target.name}.toml").read_text())
    bugs = []
    for entry in written["bug"]:
        source = (ROOT / target.folder / entry["file"]).read_text()
        original = entry["original"]
        if source.count(original) != 1:
            raise ValueError(f"{entry['name']}: its original does not stand there once")
        before = source[: source.index(original)]
        start = len(before.encode())
        mutant = MutantSource(
            id=entry["name"],
            file=entry["file"],
            line=before.count("\n") + 1,
            function="",
            operator="written",
            edit=Edit(start, start + len(original.encode()), entry["replacement"]),
            original=original,
        )
        bugs.append(WrittenBug(mutant, tuple(entry["rules"]), entry["seen"].strip()))
    return bugs


def are_noticed(target: Target) -> bool:
    """Whether the kit noticed each bug that it has judged, the last time."""
    results = read_results(results_of_written(target))
    judged = [bug for bug in read_bugs(target) if bug.mutant.id in results]
    return all(results[bug.mutant.id].outcome in NOTICED for bug in judged)
