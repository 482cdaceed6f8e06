"""Which mutants `make test` judges; `make test-all` judges all of them, by all rows.

`make test` judges a mutant when the commits of the last day changed the mutant itself,
a function that it replaces, the text of a rule that it breaks or the check of such a
rule; and a tenth of all mutants, which rotates with the commit. This module reads git
and the text of the repository; it imports neither a mutant nor a server.
"""

from __future__ import annotations

import ast
import functools
import hashlib
import inspect
import re
import subprocess
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from tests.mutants import Mutant
from tests.support.paths import ROOT

Rows = Literal["own", "all"]
# One mutant in so many is judged whatever changed, and of these one in so many by all
# rows: a whole run of the kit takes as long as the own rows of ten mutants.
ROTATION = 10
ROTATION_BY_ALL_ROWS = 20
# After a change of everything a day's mutants would take an hour.
CHANGED_MAX = 60
_JUDGED = ("reference_server", "reference_sim", "reference_record")
# Changes of the server that mutants of several files share.
SHARED_CHANGES = Path(__file__).with_name("server_changes.py")
_CHECKS = "conformance/checks/"
_MUTANTS = "tests/mutants/"
_HUNK = re.compile(r"^@@ -\S+ \+(\d+)(?:,(\d+))? @@")
_RULE_ID = re.compile(r"\b[A-Z]+-\d{3}\b")
_WORD = re.compile(r"\w+")


@dataclass(frozen=True, slots=True)
class Selection:
    """What a run judges: the rows of each mutant that is chosen, by its name."""

    rows: dict[str, Rows]
    changed: int  # how many mutants the last day's commits concern

    def explain(self, total: int) -> str:
        """The sentence that the end of a run prints."""
        return (
            f"{len(self.rows)} of {total} mutants were judged: "
            f"{min(self.changed, CHANGED_MAX)} of {self.changed} that the last day's "
            "commits concern, and a tenth of all"
        )


@dataclass(frozen=True, slots=True)
class Change:
    """What commits changed. functions: (name of its class or module, its name)."""

    functions: frozenset[tuple[str, str]]
    rule_ids: frozenset[str]
    mutants: frozenset[str]


def select(mutants: dict[str, Mutant]) -> Selection:
    """Choose for the commit that is checked out."""
    change = read_change()
    ranked = sorted(mutants, key=_rank)
    concerned = [
        name
        for name in ranked
        if is_concerned(mutants[name], _names_of(mutants[name]), change)
    ]
    tenth = ranked[: len(ranked) // ROTATION]
    by_all_rows = set(tenth[: len(ranked) // ROTATION // ROTATION_BY_ALL_ROWS + 1])
    chosen = dict.fromkeys([*tenth, *concerned[:CHANGED_MAX]])
    rows: dict[str, Rows] = {
        name: "all" if name in by_all_rows else "own" for name in chosen
    }
    return Selection(rows, len(concerned))


def is_concerned(mutant: Mutant, names: frozenset[str], change: Change) -> bool:
    """Whether a change may alter what a mutant breaks, or who notices it.

    names: the identifiers and strings in the text of the mutant.
    """
    return (
        mutant.name in change.mutants
        or bool(mutant.kills & change.rule_ids)
        or any(
            owner in names and function in names for owner, function in change.functions
        )
    )


def _rank(name: str) -> bytes:
    """An order of the mutants that is another one for each commit."""
    return hashlib.sha256(f"{_git('rev-parse', 'HEAD')} {name}".encode()).digest()


@functools.cache
def _git(*arguments: str) -> str:
    """The output of git; empty where there is no repository."""
    done = subprocess.run(
        ["git", *arguments], cwd=ROOT, capture_output=True, text=True, check=False
    )
    return done.stdout.strip()


def read_change() -> Change:
    """What the commits of the day before the newest one changed, and what is open."""
    newest = int(_git("show", "--no-patch", "--format=%ct") or 0)
    base = _git("rev-list", "--max-count=1", f"--before={newest - 86_400}", "HEAD")
    if not base:
        return Change(frozenset(), frozenset(), frozenset())
    functions, rule_ids, mutants = set(), set(), set()
    for path, lines, text in _changed_files(base):
        rule_ids |= set(_RULE_ID.findall(text)) if path.startswith("spec/") else set()
        # A row of a table changes a mutant, too, though the table's function stays.
        mutants |= set(_WORD.findall(text)) if path.startswith(_MUTANTS) else set()
        if not path.endswith(".py"):
            continue
        for owner, function in _functions(ROOT / path):
            if not any(line in lines for line in _span(function)):
                continue
            if path.startswith(_JUDGED):
                functions.add((owner, function.name))
            elif path.startswith(_CHECKS):
                rule_ids |= set(_rules_of(function))
            elif path.startswith(_MUTANTS):
                mutants.add(function.name)
    return Change(frozenset(functions), frozenset(rule_ids), frozenset(mutants))


def _changed_files(base: str) -> Iterator[tuple[str, set[int], str]]:
    """Give each file's path, the numbers of its new lines, and these lines as text."""
    folders = (*_JUDGED, _CHECKS, _MUTANTS, "spec")
    difference = _git("diff", "--unified=0", "--no-color", base, "--", *folders)
    for part in re.split(r"^diff --git ", difference, flags=re.MULTILINE)[1:]:
        path = re.search(r"^\+\+\+ b/(.+)$", part, re.MULTILINE)
        if path is None:
            continue  # a file that was deleted
        lines = set[int]()
        for hunk in part.splitlines():
            if match := _HUNK.match(hunk):
                first, count = int(match[1]), int(match[2] or 1)
                lines |= set(range(first, first + max(count, 1)))
        yield (
            path[1],
            lines,
            "\n".join(re.findall(r"^[+](?!\+\+)(.*)$", part, re.MULTILINE)),
        )


_Function = ast.FunctionDef | ast.AsyncFunctionDef


@functools.cache
def _functions(path: Path) -> tuple[tuple[str, _Function], ...]:
    """Each function of a module and of its classes, after its owner's name."""
    functions: list[tuple[str, _Function]] = []
    for node in ast.parse(path.read_text()).body:
        if isinstance(node, _Function):
            functions.append((path.stem, node))
        elif isinstance(node, ast.ClassDef):
            functions += [(node.name, n) for n in node.body if isinstance(n, _Function)]
    return tuple(functions)


def _span(function: _Function) -> range:
    first = min([function.lineno, *(d.lineno for d in function.decorator_list)])
    return range(first, (function.end_lineno or first) + 1)


def _rules_of(check: _Function) -> Iterator[str]:
    """The ids in the decorators of a check."""
    for decorator in check.decorator_list:
        yield from _RULE_ID.findall(ast.unparse(decorator))


def _names_of(mutant: Mutant) -> frozenset[str]:
    """The identifiers and strings in a mutant's text and in what it calls there.

    A mutant that no function of the file surrounds, such as a row of a table, has those
    of the whole file.
    """
    patch = inspect.unwrap(getattr(mutant.patch, "func", mutant.patch))
    code = patch.__code__
    by_function = _names_by_function(Path(code.co_filename))
    for (first, last), names in by_function.items():
        if first <= code.co_firstlineno <= last:
            return names
    return frozenset[str]().union(*by_function.values())


@functools.cache
def _names_by_function(path: Path) -> dict[tuple[int, int], frozenset[str]]:
    """By the first and the last line of each function of a file.

    A function has the names of what it calls in its file and in SHARED_CHANGES, too.
    """
    functions = [function for _, function in _functions(path)]
    shared = [function for _, function in _functions(SHARED_CHANGES)]
    used = {function.name: _names_in(function) for function in [*shared, *functions]}
    return {
        (_span(function)[0], _span(function)[-1]): used[function.name].union(
            *(used[helper] for helper in used[function.name] & used.keys())
        )
        for function in functions
    }


def _names_in(tree: ast.AST) -> frozenset[str]:
    names = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Name):
            names.add(node.id)
        elif isinstance(node, ast.Attribute):
            names.add(node.attr)
        elif isinstance(node, ast.Constant) and isinstance(node.value, str):
            names.add(node.value)
    return frozenset(names)
