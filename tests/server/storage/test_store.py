"""What outlives the process, row by row, and writes that fail."""

from __future__ import annotations

import asyncio
import contextlib
import os
import sqlite3
import threading
from dataclasses import fields
from pathlib import Path
from typing import Any, cast

import pytest
import sqlalchemy as sa

from reference_server.rules.run import Result, Run, RunHead
from reference_server.storage import store as store_module
from reference_server.storage.store import Store, StoreFailed
from tests.support.server.server_parts import (
    RESULT,
    ServerParts,
    calibration_run,
    count_rows,
    record_score,
    run_scenarios,
)
from tests.support.servers import TIMEOUT_S

# --- files ---


def modes(folder: Path) -> dict[str, int]:
    return {path.name: path.stat().st_mode & 0o777 for path in folder.iterdir()}


def test_the_files_are_their_owners_alone(tmp_path: Path) -> None:
    """Also those that an older server left readable for all."""

    async def scenario(parts: ServerParts) -> None:
        await parts.store.insert(calibration_run(), None, "")
        files = modes(tmp_path)
        names = ("proctor.sqlite", "proctor.sqlite-shm", "proctor.sqlite-wal")
        assert files == dict.fromkeys(names, 0o600)

    before = os.umask(0o022)
    try:
        run_scenarios(tmp_path, scenario)
        (tmp_path / "proctor.sqlite").unlink()
        sqlite3.connect(tmp_path / "proctor.sqlite").close()
        (tmp_path / "proctor.sqlite").touch(0o644)
        run_scenarios(tmp_path, scenario)
    finally:
        os.umask(before)


# --- rows ---


def test_a_run_is_loaded_as_it_was_saved(tmp_path: Path) -> None:
    player = {"name": "p", "client": "é"}
    result = Result(
        "failure", 0.1 + 0.2, 2, 7, False, True, 5e-324, 1e9 + 1 / 3, player, 3, -0.5
    )

    async def save(parts: ServerParts) -> None:
        run = calibration_run("score", "echo", "count", queue_until_wall=0.1)
        assert await parts.store.insert(run, None, "")
        run.episodes[1].result = result
        run.episodes[2].attempt = run.episodes[2].faults = 2
        run.episodes[2].faults_forgiven = 1
        run.changed = {1, 2}
        run.state, run.reason, run.retryable = "failed", "é\x00💥", True
        await parts.store.save(run)
        assert run.changed == set()

    async def load(parts: ServerParts) -> None:
        run = await parts.store.load("run_1")
        assert run is not None
        assert run.episodes[1].result == result
        plain = run.episodes[0]
        assert (plain.attempt, plain.faults, plain.result) == (1, 0, None)
        touched = run.episodes[2]
        attempt_and_faults = (touched.attempt, touched.faults, touched.faults_forgiven)
        assert attempt_and_faults == (2, 2, 1)
        assert (run.state, run.reason, run.retryable) == ("failed", "é\x00💥", True)
        assert (run.pending, run.scored, run.workers) == ([0, 2], 1, {})
        same = calibration_run("score", "echo", "count")
        for name in ("manifest", "submission", "images", "max_workers", "account"):
            assert getattr(run, name) == getattr(same, name)
        assert (run.queue_until_wall, run.created_at_wall) == (0.1, 1000.0)
        assert await parts.store.load("run_2") is None

    run_scenarios(tmp_path, save, load)


def test_a_manifest_is_stored_once(tmp_path: Path) -> None:
    async def scenario(parts: ServerParts) -> None:
        for number in range(3):
            await parts.store.insert(calibration_run(run_id=f"run_{number}"), None, "")
        assert (
            count_rows(parts.path, "manifests"),
            count_rows(parts.path, "runs"),
        ) == (1, 3)

    run_scenarios(tmp_path, scenario)


def test_numbers_grow_and_pages_go_back(tmp_path: Path) -> None:
    async def scenario(parts: ServerParts) -> None:
        for number in range(5):
            account = "bob" if number == 2 else "alice"
            run = calibration_run(run_id=f"run_{number}", account=account)
            await parts.store.insert(run, None, "")
        page = await parts.store.page("alice", None, 3)
        assert [run_id for _, run_id in page] == ["run_4", "run_3", "run_1"]
        rest = await parts.store.page("alice", page[-1][0], 3)
        assert [run_id for _, run_id in rest] == ["run_0"]
        queued = await parts.store.in_states("queued", "ready")
        assert queued == [f"run_{number}" for number in range(5)]

    run_scenarios(tmp_path, scenario)


# --- parts of runs ---


def three_episode_run(run_id: str = "run_1") -> Run:
    run = calibration_run("score", "echo", "count", run_id=run_id)
    record_score(run, 1)
    return run


async def save_runs(parts: ServerParts, *runs: Run) -> None:
    for run in runs:
        changed, run.changed = run.changed, set()
        await parts.store.insert(run, None, "")
        run.changed = changed
        await parts.store.save(run)


def test_a_window_is_a_part_of_the_run(tmp_path: Path) -> None:
    async def scenario(parts: ServerParts) -> None:
        await save_runs(parts, three_episode_run(), three_episode_run("run_2"))
        run = await parts.store.load("run_1")
        assert run is not None
        for start, end in ((0, 0), (0, None), (1, 2), (2, 9), (3, 9), (7, None)):
            found = await parts.store.read_window("run_1", start, end)
            assert found is not None
            head, episodes = found
            assert episodes == run.episodes[start:end]
            for member in fields(RunHead):
                assert getattr(head, member.name) == getattr(run, member.name)
        heads = await parts.store.heads(["run_2", "run_3", "run_1"])
        assert {i: head.scored for i, head in heads.items()} == {"run_1": 1, "run_2": 1}
        assert heads["run_1"].manifest is run.manifest, "it is decoded once for all"
        assert await parts.store.read_window("run_3", 0, None) is None
        assert await parts.store.heads([]) == {}

    run_scenarios(tmp_path, scenario)


def test_the_manifest_cache_is_bounded(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(store_module, "CACHED_MANIFESTS_MAX", 2)

    async def scenario(parts: ServerParts) -> None:
        for length in range(1, 6):
            run = calibration_run(*["score"] * length, run_id=f"run_{length}")
            await parts.store.insert(run, None, "")
        for length in (1, 2, 3, 4, 5, 1):
            heads = await parts.store.heads([f"run_{length}"])
            assert heads[f"run_{length}"].total == length
            assert len(parts.store._manifest_cache) <= 2

    run_scenarios(tmp_path, scenario)


def test_an_older_database_is_read_without_the_new_columns(tmp_path: Path) -> None:
    async def before(parts: ServerParts) -> None:
        await save_runs(parts, three_episode_run())
        with contextlib.closing(sqlite3.connect(parts.path)) as database:
            database.execute("ALTER TABLE runs DROP COLUMN scored")
            database.execute("ALTER TABLE episodes DROP COLUMN policy_fault")

    async def after(parts: ServerParts) -> None:
        found = await parts.store.read_window("run_1", 1, 2)
        assert found is not None
        assert (found[0].scored, found[1][0].result) == (1, RESULT)
        run = await parts.store.load("run_1")
        assert run is not None
        run.episodes[2].policy_fault = "it hung up"
        record_score(run, 2)
        await parts.store.save(run)
        again = await parts.store.read_window("run_1", 2, 3)
        assert again is not None
        assert (again[0].scored, again[1][0].policy_fault) == (2, "it hung up")

    run_scenarios(tmp_path, before, after)


def test_attempts_in_an_older_database_are_counted(tmp_path: Path) -> None:
    async def before(parts: ServerParts) -> None:
        await save_runs(parts, *(three_episode_run(f"run_{n}") for n in range(3)))
        with contextlib.closing(sqlite3.connect(parts.path)) as database:
            database.execute("UPDATE runs SET benchmark_id = NULL")
            database.execute("UPDATE runs SET attempts_by_submitter = NULL")
            database.commit()

    async def after(parts: ServerParts) -> None:
        heads = await parts.store.heads(["run_0", "run_1", "run_2"])
        numbers = [heads[one].attempts_by_submitter for one in sorted(heads)]
        assert numbers == [1, 2, 3]
        assert await parts.store.count_attempts(heads["run_0"]) == 3

    run_scenarios(tmp_path, before, after)


def test_a_read_is_a_consistent_snapshot(tmp_path: Path) -> None:
    """And neither waits for the other: who writes for who reads, nor the reverse."""

    async def scenario(parts: ServerParts) -> None:
        run = three_episode_run()
        await save_runs(parts, run)
        looking, written = threading.Event(), threading.Event()

        def look(connection: sa.Connection) -> list[int]:
            count = sa.text("SELECT count(result) FROM episodes")
            first = connection.execute(count).scalar_one()
            looking.set()
            assert written.wait(TIMEOUT_S)
            return [first, connection.execute(count).scalar_one()]

        reading = asyncio.create_task(parts.store._read(look))
        assert await asyncio.to_thread(looking.wait, TIMEOUT_S)
        record_score(run, 2)
        await parts.store.save(run)
        written.set()
        assert await reading == [1, 1]
        assert await parts.store._read(look) == [2, 2]

    run_scenarios(tmp_path, scenario)


def test_reads_are_read_only(tmp_path: Path) -> None:
    async def scenario(parts: ServerParts) -> None:
        await save_runs(parts, three_episode_run())
        with pytest.raises(StoreFailed, match="readonly"):
            await parts.store._read(
                lambda connection: connection.execute(sa.text("DELETE FROM episodes"))
            )
        assert count_rows(parts.path, "episodes") == 1

    run_scenarios(tmp_path, scenario)


# --- writes that fail ---


@pytest.mark.parametrize(
    "url",
    [
        "nonsense",
        "nonsense://x",
        "sqlite:///x",  # a driver that would block every caller
        "sqlite+aiosqlite:////proc/nowhere/x",
        f"sqlite+aiosqlite:///{Path(__file__).parent}",
        f"sqlite+aiosqlite:///{Path(__file__)}",
    ],
)
def test_an_invalid_database_is_reported(url: str) -> None:
    async def open_in_vain() -> None:
        store = Store(url)
        try:
            await store.open()
        finally:
            # The driver's thread ends by itself, and has to find its loop until then.
            for thread in set(threading.enumerate()) - {threading.main_thread()}:
                await asyncio.to_thread(thread.join, TIMEOUT_S)
            await store.close()

    with pytest.raises(StoreFailed) as caught:
        asyncio.run(open_in_vain())
    assert "\n" not in str(caught.value)


def test_a_failed_write_can_be_repeated(tmp_path: Path) -> None:
    async def scenario(parts: ServerParts) -> None:
        run = calibration_run()
        await parts.store.insert(run, None, "")
        run.episodes[0].faults, run.changed, run.reason = 1, {0}, "new"
        with parts.reject_writes(), pytest.raises(StoreFailed, match="disk is full"):
            await parts.store.save(run)
        stored = await parts.store.load("run_1")
        assert stored is not None
        assert (stored.reason, stored.episodes[0].faults) == (None, 0)
        assert run.changed == {0}
        await parts.store.save(run)
        stored = await parts.store.load("run_1")
        assert stored is not None
        assert (stored.reason, stored.episodes[0].faults) == ("new", 1)

    run_scenarios(tmp_path, scenario)


def test_an_unreachable_database_is_reported(tmp_path: Path) -> None:
    """What a driver says of a refused connection is not wrapped by SQLAlchemy."""

    class UnreachableEngine:
        def begin(self) -> UnreachableEngine:
            return self

        async def __aenter__(self) -> None:
            raise ConnectionRefusedError("refused\nby the host")

        async def __aexit__(self, *_: object) -> None: ...

    async def scenario(parts: ServerParts) -> None:
        run = calibration_run()
        await parts.store.insert(run, None, "")
        engine, parts.store._engine = (
            parts.store._engine,
            cast(Any, UnreachableEngine()),
        )
        # As over a network: not a file, which has a way of its own to be read.
        reader, parts.store._read_engine = parts.store._read_engine, None
        run.changed = {0}
        for work in (
            parts.store.heads(["run_1"]),
            parts.store.save(run),
            parts.store.insert(calibration_run(run_id="run_2"), None, ""),
            parts.store.load(run.run_id),
        ):
            with pytest.raises(StoreFailed, match=r"^refused$"):
                await work
        assert run.changed == {0}
        parts.store._engine, parts.store._read_engine = engine, reader

    run_scenarios(tmp_path, scenario)


def test_an_in_memory_database_has_transactions(tmp_path: Path) -> None:
    """It has one connection for all: a reader's end may not commit a writer's half."""

    async def scenario(_parts: ServerParts) -> None:
        store = Store("sqlite+aiosqlite:///:memory:")
        await store.open()
        await store.insert(calibration_run(), None, "")
        half_done, go_on = asyncio.Event(), asyncio.Event()

        async def fail() -> None:
            async with store._transaction() as connection:
                await connection.exec_driver_sql("UPDATE runs SET reason = 'half'")
                half_done.set()
                await go_on.wait()
                await connection.exec_driver_sql("no such command")

        failing = asyncio.create_task(fail())
        await half_done.wait()
        reading = asyncio.create_task(store.load("run_1"))
        await asyncio.wait([reading], timeout=0.05)
        go_on.set()
        with pytest.raises(StoreFailed):
            await failing
        await reading
        run = await store.load("run_1")
        assert run is not None
        assert run.reason is None
        await store.close()

    run_scenarios(tmp_path, scenario)
