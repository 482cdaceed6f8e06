"""Databases filled with finished runs.

Independent of the store's schema: one run is stored by the store itself, the others are
copies of its rows.
"""

import asyncio
import contextlib
import sqlite3
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import cast

from reference_record.contents.benchmark_manifest import manifest_sha256
from reference_record.generated.answers import Outcome, RunPolicy
from reference_server.rules.manifest import Manifest
from reference_server.rules.runs.run import Episode, Result, Run, State
from reference_server.storage.runs.run_store import Store
from reference_sim import benchmark_registry

FIRST_FINISHED, FIRST_READY = 10, 10**6
READY_RUNS = 1000
# The number of the first copy of each template, and how many; None: as the case says.
TEMPLATES: dict[State, tuple[int, int | None]] = {
    "completed": (FIRST_FINISHED, None),
    "ready": (FIRST_READY, READY_RUNS),
}
TASKS = ("score", "count", "delay", "echo")


@dataclass(frozen=True)
class DatabaseCase:
    """One database: its column in the table, and its content.

    runs: finished runs. episodes: of each run, all scored. same: request the same run
    repeatedly, like a client that watches it; otherwise a different one each time.
    """

    name: str
    runs: int
    episodes: int
    same: bool = False

    @property
    def file(self) -> str:
        """Its own, as only one server may use a database."""
        kind = "-same" if self.same else ""
        return f"{self.runs}x{self.episodes}{kind}.sqlite"


def build_run(length: int, state: State) -> Run:
    """A calibration run; completed means that every episode is scored."""
    tasks = [TASKS[index % len(TASKS)] for index in range(length)]
    options = {"tasks": tasks, "max_steps": 10_000}
    found = benchmark_registry.resolve("calibration", options)
    policy: RunPolicy = {"name": "growth"}
    manifest = cast("Manifest", found.manifest)
    episodes = [Episode.of(manifest, i) for i in range(len(manifest["episodes"]))]
    for episode in episodes if state == "completed" else ():
        score = episode.index / length
        outcome: Outcome = "success" if episode.index % 3 else "failure"
        ended_at = 1.7e9 + episode.index
        episode.result = Result(outcome, score, 1, 7, True, False, score / 4, ended_at)
    return Run(
        run_id=f"template_{state}",
        number=0,
        account="bench",
        state=state,
        reason=None,
        retryable=None,
        manifest=manifest,
        manifest_sha256=manifest_sha256(manifest),
        submission={
            "benchmark_id": "calibration",
            "policy": policy,
            "options": options,
        },
        max_workers=4,
        idle_timeout_s=600.0,
        images=found.images,
        created_at_wall=1.7e9,
        updated_at_wall=1.7e9,
        queue_until_wall=0.0,
        episodes=episodes,
    )


async def store_templates(url: str, length: int) -> None:
    store = Store(url)
    await store.open()
    for state in TEMPLATES:
        run = build_run(length, state)
        await store.insert(run, None, "")
        run.changed = {e.index for e in run.episodes if e.result is not None}
        await store.save(run)
    await store.close()


def filling_statements(
    database_case: DatabaseCase, columns: Mapping[str, Sequence[str]]
) -> Iterator[str]:
    """SQL that copies the rows of the templates, and removes those in the end.

    For SQLite and PostgreSQL. columns: of the tables `runs` and `episodes`.
    """
    for state, (first, copies) in TEMPLATES.items():
        count = database_case.runs if copies is None else copies
        source = f"(SELECT number FROM runs WHERE run_id = 'template_{state}')"  # noqa: S608
        yield "CREATE TEMP TABLE copies (n INTEGER, run_id TEXT)"
        yield (
            "WITH RECURSIVE counted(n) AS "  # noqa: S608
            f"(SELECT 0 UNION ALL SELECT n + 1 FROM counted WHERE n + 1 < {count}) "
            f"INSERT INTO copies SELECT {first} + n, '{state}_' || n FROM counted"
        )
        for table in ("runs", "episodes"):
            yield _copying_statement(table, columns[table], source)
        for table in ("episodes", "runs"):
            yield f"DELETE FROM {table} WHERE number = {source}"  # noqa: S608
        yield "DROP TABLE copies"


def _copying_statement(table: str, names: Sequence[str], source: str) -> str:
    """Copy what a table has of the run `source`, once for each row of `copies`."""
    replaced = {"number": "copies.n"}
    if table == "runs":
        replaced["run_id"] = "copies.run_id"
    into = ", ".join(f'"{name}"' for name in names)
    shown = ", ".join(replaced.get(name, f't."{name}"') for name in names)
    return (
        f"INSERT INTO {table} ({into}) SELECT {shown} FROM copies, {table} AS t "  # noqa: S608
        f"WHERE t.number = {source} ORDER BY copies.n"
    )


def fill(path: Path, database_case: DatabaseCase) -> None:
    """Finished runs from FIRST_FINISHED on, and behind them runs for a worker."""
    url = f"sqlite:///{path}"
    asyncio.run(store_templates(url, database_case.episodes))
    with contextlib.closing(sqlite3.connect(path)) as database:
        columns = {
            table: [row[1] for row in database.execute(f"PRAGMA table_info({table})")]
            for table in ("runs", "episodes")
        }
        for statement in filling_statements(database_case, columns):
            database.execute(statement)
        database.commit()
        database.execute("PRAGMA wal_checkpoint(TRUNCATE)")
