"""Build every client, play every scenario through it, judge: `make interop`.

Runs from the repository's root as `python -m tools interop`. Without --url it judges
the clients at a reference server of its own. The matrix goes to the console and to
build/interop.md. A scenario that was not run is never green; the last line names the
languages that were not played. Ends with 1 if something failed, 2 if something or all
was not run, else with 0.
"""

import os
import shlex
import signal
import subprocess
import tempfile
import time
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path

from tests.interop.builds.build_steps import BuildFailed
from tests.interop.clients import LANGUAGES, Language
from tests.interop.scenarios import (
    DESCRIPTIONS,
    EVALUATION_ONLY,
    LIMITS,
    MESSAGES_ONLY,
    SAY_WHY,
    SCENARIOS,
    Program,
    ScenarioNotRunnable,
    Server,
    UnexpectedResult,
)
from tests.support.servers import TOKENS, ReferenceServer
from tools.built_pages import write_page

PASSED, FAILED, NOT_RUN = "passed", "failed", "not run"
NO_PART = "no part of it"
MARKS = {PASSED: "✔", FAILED: "**failed**", NOT_RUN: "not run", NO_PART: "–"}


@dataclass(frozen=True)
class Cell:
    """The outcome of one scenario in one language."""

    outcome: str
    why: str = ""
    seconds: float = 0.0


@dataclass
class Matrix:
    """Outcomes by language and scenario, and the toolchains that made them."""

    cells: dict[str, dict[str, Cell]] = field(default_factory=dict)
    toolchains: dict[str, str] = field(default_factory=dict)

    def outcomes(self) -> list[str]:
        """The outcomes of the scenarios that the programs have a part in."""
        cells = [cell for row in self.cells.values() for cell in row.values()]
        return [cell.outcome for cell in cells if cell.outcome != NO_PART]

    def exit_code(self) -> int:
        seen = self.outcomes()
        if FAILED in seen:
            return 1
        return 2 if NOT_RUN in seen or not seen else 0


def play(language: Language, server: Server, names: list[str], matrix: Matrix) -> None:
    """Build one client and put its row into the matrix."""
    parts = scenarios_of(language)
    row = matrix.cells.setdefault(language.name, {})
    row |= {name: Cell(NO_PART) for name in SCENARIOS if name not in parts}
    names = [name for name in names if name in parts]
    language.provide()
    if missing := language.missing():
        row |= {name: Cell(NOT_RUN, missing) for name in names}
        print(f"{language.name}: not run: {missing}", flush=True)
        return
    matrix.toolchains[language.name] = language.toolchain()
    started = time.monotonic()
    try:
        language.build()
    except (BuildFailed, subprocess.TimeoutExpired) as error:
        row |= {name: Cell(FAILED, f"the build: {error}") for name in names}
        print(f"{language.name}: failed: the build: {error}", flush=True)
        return
    print(f"{language.name}: built in {time.monotonic() - started:.0f} s", flush=True)
    program = program_of(language)
    for name in names:
        row[name] = judge(name, server, program)
        print(f"  {name:<14} {row[name].outcome} {row[name].why}".rstrip(), flush=True)


def scenarios_of(language: Language) -> list[str]:
    """The scenarios that its programs have a part in."""
    absent = MESSAGES_ONLY if language.evaluates else EVALUATION_ONLY
    if language.name not in SAY_WHY:
        absent = absent | {"left"}
    return [name for name in SCENARIOS if name not in absent]


def program_of(language: Language) -> Program:
    return Program(
        language.name,
        language.interop_command(),
        language.env(),
        language.example_command(),
    )


def judge(name: str, server: Server, program: Program) -> Cell:
    started = time.monotonic()
    try:
        SCENARIOS[name](server, program)
    except ScenarioNotRunnable as error:
        return Cell(NOT_RUN, str(error))
    except (UnexpectedResult, KeyError, TypeError, ValueError) as error:
        # A member that is missing or misshapen in what the program said is its fault.
        why = f"{type(error).__name__}: {error}"
        return Cell(FAILED, why, time.monotonic() - started)
    return Cell(PASSED, seconds=time.monotonic() - started)


def table(matrix: Matrix) -> list[str]:
    """The matrix in Markdown, languages as columns, with a note for every limit."""
    languages = list(matrix.cells)
    notes: dict[str, int] = {}
    lines = [f"| scenario | {' | '.join(languages)} |"]
    lines.append("|---" * (len(languages) + 1) + "|")
    for name in SCENARIOS:
        marks = []
        for language in languages:
            cell = matrix.cells[language].get(name, Cell(NOT_RUN))
            mark = MARKS[cell.outcome]
            limit = LIMITS.get((language, name)) if cell.outcome == PASSED else None
            if limit:
                mark += f" [{notes.setdefault(f'{language}: {limit}', len(notes) + 1)}]"
            marks.append(mark)
        lines.append(f"| {name}: {DESCRIPTIONS[name]} | {' | '.join(marks)} |")
    lines += ["", *(f"[{number}] {note}." for note, number in notes.items())]
    return lines


def reasons(matrix: Matrix, *outcomes: str) -> set[tuple[str, str]]:
    """Languages with the first line of why something of theirs has this outcome."""
    return {
        (language, cell.why.splitlines()[0])
        for language, row in matrix.cells.items()
        for cell in row.values()
        if cell.outcome in outcomes and cell.why
    }


def page(matrix: Matrix) -> str:
    whys = sorted(reasons(matrix, FAILED, NOT_RUN))
    built = [f"{name} ({version})" for name, version in matrix.toolchains.items()]
    parts = [
        "# Every client, every scenario",
        "",
        "Written by `make interop`. [Clients](../docs/implement/clients.md#played)",
        "says how to read it.",
        "",
        *table(matrix),
        "",
        *(f"- {language}: {why}" for language, why in whys),
        *([""] if whys else []),
        f"Toolchains: {'; '.join(built)}.",
    ]
    return "\n".join(parts) + "\n"


def last_line(matrix: Matrix, languages: Iterable[str]) -> str:
    """Which languages were played and which were not, for whatever reason."""
    judged = [
        name
        for name, row in matrix.cells.items()
        if {PASSED, FAILED} & {cell.outcome for cell in row.values()}
    ]
    left = [name for name in languages if name not in judged]
    played, missed = (", ".join(names) or "none" for names in (judged, left))
    return f"interop: languages played: {played}; not played: {missed}"


@contextmanager
def the_server(url: str) -> Iterator[Server]:
    """The server of --url, or one of our own."""
    if url:
        command = shlex.split(os.environ.get("RAW_RESTART_CMD", ""))

        def restart() -> str:
            subprocess.run(command, check=True)
            return url

        token = os.environ.get("PROCTOR_TOKEN", "")
        yield Server(url.rstrip("/"), token, restart if command else None)
        return
    with tempfile.TemporaryDirectory() as directory:
        reference = ReferenceServer(Path(directory))

        def again() -> str:
            reference.end(signal.SIGKILL)
            reference.start()
            return reference.url

        try:
            yield Server(reference.url, TOKENS["alice"], again)
        finally:
            reference.end(signal.SIGTERM)


def chosen(text: str, known: list[str]) -> list[str]:
    wanted = [name for name in text.split(",") if name] or known
    if unknown := set(wanted) - set(known):
        named = ", ".join(sorted(unknown))
        raise SystemExit(f"interop: no {named}; have {', '.join(known)}")
    return wanted


def main(*, url: str, languages: str, only: str) -> int:
    by_name = {language.name: language for language in LANGUAGES}
    rows = chosen(languages, list(by_name))
    names = chosen(only, list(SCENARIOS))
    matrix = Matrix()
    with the_server(url) as server:
        for name in rows:
            play(by_name[name], server, names, matrix)
    print("\n".join(["", *table(matrix)]))
    for language, why in sorted(reasons(matrix, NOT_RUN)):
        print(f"{language}: not run: {why}")
    if not matrix.outcomes():
        print("interop: nothing was played; no language has a part in what was chosen")
    write_page("interop.md", page(matrix))
    print(last_line(matrix, by_name))
    return matrix.exit_code()
