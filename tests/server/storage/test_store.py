"""What outlives the process, row by row, and writes that fail."""

from __future__ import annotations

import asyncio
import os
import resource
import sqlite3
import threading
from collections.abc import AsyncIterator, Iterator
from contextlib import contextmanager
from dataclasses import fields
from pathlib import Path
from typing import Any

import pytest
import sqlalchemy as sa

from reference_server.rules.imported_record import RecordImport
from reference_server.rules.manifest import Submission
from reference_server.rules.runs.run import Player, Result, Run, RunHead
from reference_server.storage.board_store import BoardStore
from reference_server.storage.connection import postgresql as postgresql_module
from reference_server.storage.import_store import ImportStore
from reference_server.storage.record_store import RecordStore
from reference_server.storage.runs import run_store as store_module
from reference_server.storage.runs.run_store import Store, StoreFailed
from tests.support.server.databases import UsedDatabase
from tests.support.server.postgresql_server import PostgresqlServer
from tests.support.server.server_parts import (
    ServerParts,
    calibration_run,
    open_server_parts,
    record_score,
    run_scenario,
)
from tests.support.servers import TIMEOUT_S
from tests.support.waiting import wait_until

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
        run_scenario(tmp_path, scenario)
        (tmp_path / "proctor.sqlite").unlink()
        sqlite3.connect(tmp_path / "proctor.sqlite").close()
        (tmp_path / "proctor.sqlite").touch(0o644)
        run_scenario(tmp_path, scenario)
    finally:
        os.umask(before)


# --- rows ---


@pytest.fixture
async def parts(database: UsedDatabase) -> AsyncIterator[ServerParts]:
    """A server over a database of each kind."""
    async with open_server_parts(database) as parts:
        yield parts


async def test_a_run_is_loaded_as_it_was_saved(database: UsedDatabase) -> None:
    player: Player = {"name": "p", "client": "é"}
    result = Result(
        "failure", 0.1 + 0.2, 2, 7, False, True, 5e-324, 1e9 + 1 / 3, player, 3, -0.5
    )
    async with open_server_parts(database) as parts:
        run = calibration_run("score", "echo", "count", queue_until_wall=0.1)
        assert await parts.store.insert(run, None, "")
        run.episodes[1].result = result
        run.episodes[2].attempt = run.episodes[2].faults = 2
        run.episodes[2].faults_forgiven = 1
        run.changed = {1, 2}
        run.state, run.reason, run.retryable = "failed", "é\x00💥", True
        await parts.store.save(run)
        assert run.changed == set()
    async with open_server_parts(database) as parts:
        loaded = await parts.store.load("run_1")
        assert loaded is not None
        assert loaded.episodes[1].result == result
        plain = loaded.episodes[0]
        assert (plain.attempt, plain.faults, plain.result) == (1, 0, None)
        touched = loaded.episodes[2]
        attempt_and_faults = (touched.attempt, touched.faults, touched.faults_forgiven)
        assert attempt_and_faults == (2, 2, 1)
        assert (loaded.state, loaded.reason, loaded.retryable) == (
            "failed",
            "é\x00💥",
            True,
        )
        assert (loaded.pending, loaded.scored, loaded.workers) == ([0, 2], 1, {})
        same = calibration_run("score", "echo", "count")
        for name in ("manifest", "submission", "images", "max_workers", "account"):
            assert getattr(loaded, name) == getattr(same, name)
        assert (loaded.queue_until_wall, loaded.created_at_wall) == (0.1, 1000.0)
        assert await parts.store.load("run_2") is None


async def test_an_import_is_found_as_it_was_added(parts: ServerParts) -> None:
    """The texts of its statement are of others: they have any character."""
    text = "é\x00\\0💥"
    one = RecordImport(
        *(1, "import_1", "alice", "sha", 9, "sha"),
        *(text, text, text, text, "sha", text, text),
        *(None, 1, 1000.0),
        reason=text,
    )
    imports = ImportStore(parts.store)
    await imports.add(one)
    assert await imports.find("alice", "import_1") == one


async def test_a_manifest_is_stored_once(
    database: UsedDatabase, parts: ServerParts
) -> None:
    for number in range(3):
        await parts.store.insert(calibration_run(run_id=f"run_{number}"), None, "")
    assert (database.count("manifests"), database.count("runs")) == (1, 3)


async def test_numbers_grow_and_pages_go_back(parts: ServerParts) -> None:
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


async def test_a_page_may_begin_at_any_number(parts: ServerParts) -> None:
    """A cursor is the client's: it may be larger than a number in any row can be."""
    await parts.store.insert(calibration_run(), None, "")
    board = BoardStore(parts.store, bytes)
    imports = ImportStore(parts.store)
    for cursor in (2**31 - 1, 2**31, 10**15 - 1):
        page = await parts.store.page("alice", cursor, 3)
        assert [run_id for _, run_id in page] == ["run_1"]
        assert await board.page("alice", None, cursor, 3) == []
        assert await board.leaves(cursor, 3) == []
        assert await imports.page("alice", cursor, 3) == []
        window = await parts.store.read_window("run_1", cursor, cursor + 3)
        assert window is not None
        assert window[1] == []


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


async def test_a_window_is_a_part_of_the_run(parts: ServerParts) -> None:
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


async def test_a_list_of_runs_has_all_of_their_submissions_but_the_options(
    parts: ServerParts,
) -> None:
    """Every member of a submission. Expect that those of one run have the options."""
    all_of_it: Any = dict.fromkeys(Submission.__annotations__, "x")
    options = {"options": {"tasks": ["score"] * 3}}
    run = calibration_run(submission=all_of_it | options)
    await parts.store.insert(run, None, "")
    listed = (await parts.store.heads(["run_1"]))["run_1"]
    assert listed.submission | options == all_of_it | options
    assert "options" not in listed.submission
    found = await parts.store.read_window("run_1", 0, 0)
    assert found is not None
    assert found[0].submission == all_of_it | options


async def test_the_manifest_cache_is_bounded(
    monkeypatch: pytest.MonkeyPatch, parts: ServerParts
) -> None:
    monkeypatch.setattr(store_module, "CACHED_MANIFESTS_MAX", 2)
    for length in range(1, 6):
        run = calibration_run(*["score"] * length, run_id=f"run_{length}")
        await parts.store.insert(run, None, "")
    for length in (1, 2, 3, 4, 5, 1):
        heads = await parts.store.heads([f"run_{length}"])
        assert heads[f"run_{length}"].total == length
        assert len(parts.store._manifest_cache) <= 2


async def test_a_read_is_of_one_moment(
    database: UsedDatabase, parts: ServerParts
) -> None:
    """And a write of another process does not wait for it."""
    await save_runs(parts, three_episode_run())
    count = sa.text("SELECT count(result) FROM episodes")

    def look(connection: sa.Connection) -> list[int]:
        first = connection.execute(count).scalar_one()
        database.execute("DELETE FROM episodes")
        return [first, connection.execute(count).scalar_one()]

    assert await parts.store.transactions.read(look) == [1, 1]
    assert database.count("episodes") == 0


async def test_reads_are_read_only(database: UsedDatabase, parts: ServerParts) -> None:
    await save_runs(parts, three_episode_run())
    with pytest.raises(StoreFailed, match=r"read-?only"):
        await parts.store.transactions.read(
            lambda connection: connection.execute(sa.text("DELETE FROM episodes"))
        )
    assert database.count("episodes") == 1


# --- writes that fail ---


@pytest.mark.parametrize(
    "url",
    [
        "nonsense",
        "nonsense://x",
        "sqlite:////proc/nowhere/x",
        f"sqlite:///{Path(__file__).parent}",
        f"sqlite:///{Path(__file__)}",
    ],
)
def test_an_invalid_database_is_reported(url: str) -> None:
    others = set(threading.enumerate())

    async def open_in_vain() -> None:
        store = Store(url)
        try:
            await store.open()
        finally:
            # The driver's thread ends by itself, and has to find its loop until then.
            for thread in set(threading.enumerate()) - others:
                await asyncio.to_thread(thread.join, TIMEOUT_S)
            await store.close()

    with pytest.raises(StoreFailed) as caught:
        asyncio.run(open_in_vain())
    assert "\n" not in str(caught.value)


async def test_a_failed_write_can_be_repeated(parts: ServerParts) -> None:
    run = calibration_run()
    await parts.store.insert(run, None, "")
    run.episodes[0].faults, run.changed, run.reason = 1, {0}, "new"
    with (
        parts.database.reject_writes(),
        pytest.raises(StoreFailed, match="disk is full"),
    ):
        await parts.store.save(run)
    stored = await parts.store.load("run_1")
    assert stored is not None
    assert (stored.reason, stored.episodes[0].faults) == (None, 0)
    assert run.changed == {0}
    await parts.store.save(run)
    stored = await parts.store.load("run_1")
    assert stored is not None
    assert (stored.reason, stored.episodes[0].faults) == ("new", 1)


async def test_a_full_disk_is_seen_until_there_is_room(tmp_path: Path) -> None:
    """Without a change of what is stored."""

    @contextmanager
    def full_disk() -> Iterator[None]:
        before = resource.getrlimit(resource.RLIMIT_FSIZE)
        resource.setrlimit(resource.RLIMIT_FSIZE, (1, before[1]))
        try:
            yield
        finally:
            resource.setrlimit(resource.RLIMIT_FSIZE, before)

    async with open_server_parts(tmp_path / "proctor.sqlite") as parts:
        run = three_episode_run()
        await save_runs(parts, run)
        await parts.store.transactions.check_writable()
        run.changed = {0}
        with full_disk():
            with pytest.raises(StoreFailed):
                await parts.store.save(run)
            for _ in range(2):
                with pytest.raises(StoreFailed):
                    await parts.store.transactions.check_writable()
        for _ in range(2):
            await parts.store.transactions.check_writable()
        assert parts.database.count("accounts") == 0
        await parts.store.save(run)


@pytest.mark.slow("starts PostgreSQL")
def test_an_unreachable_database_is_reported() -> None:
    """And it is used again when it answers, without a start of the server."""
    with PostgresqlServer() as server:
        database = UsedDatabase(server.create(), server=server)

        async def scenario(parts: ServerParts) -> None:
            run = calibration_run()
            await parts.store.insert(run, None, "")
            server.kill()
            run.changed = {0}
            for work in (
                parts.store.heads(["run_1"]),
                parts.store.save(run),
                parts.store.insert(calibration_run(run_id="run_2"), None, ""),
                parts.store.load(run.run_id),
            ):
                with pytest.raises(StoreFailed, match="there is no PostgreSQL at"):
                    await work
            assert run.changed == {0}
            server.start()
            await parts.store.save(run)
            assert run.changed == set()
            assert list(await parts.store.heads(["run_1", "run_2"])) == ["run_1"]

        run_scenario(database, scenario)


@pytest.mark.slow("starts PostgreSQL")
async def test_slow_reads_leave_connections_for_writes(
    postgresql: PostgresqlServer, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(postgresql_module, "POOL_TIMEOUT_S", 0.5)
    database = UsedDatabase(postgresql.create(), server=postgresql)
    sleep = sa.text("SELECT pg_sleep(30)")
    sleeping = (
        "SELECT count(*) FROM pg_stat_activity WHERE query = 'SELECT pg_sleep(30)' "
        "AND datname = current_database()"
    )
    async with open_server_parts(database) as parts:
        reads = [
            asyncio.create_task(
                parts.store.transactions.read(lambda c: c.execute(sleep))
            )
            for _ in range(2 * postgresql_module.CONNECTIONS_MAX)
        ]
        full = postgresql_module.READS_MAX
        await asyncio.to_thread(
            wait_until, lambda: database.execute(sleeping) == [(full,)], "reads run"
        )
        await save_runs(parts, three_episode_run())
        with pytest.raises(StoreFailed, match="does not answer in time"):
            await RecordStore(parts.store.transactions).find_statement("run_1")
        for read in reads:
            read.cancel()
        await asyncio.gather(*reads, return_exceptions=True)
        records = RecordStore(parts.store.transactions)
        assert await records.find_statement("run_1") is None


async def test_closing_waits_for_a_write_whose_caller_was_cancelled(
    tmp_path: Path,
) -> None:
    """Else the process may end, or the file be copied, in the middle of it."""
    begun, go_on = threading.Event(), threading.Event()

    def write(connection: sa.Connection) -> None:
        begun.set()
        assert go_on.wait(TIMEOUT_S)
        connection.exec_driver_sql("UPDATE runs SET reason = 'stored'")

    async with open_server_parts(tmp_path / "proctor.sqlite") as _parts:
        database = UsedDatabase.of_file(tmp_path / "other.sqlite")
        store = Store(database.url)
        await store.open()
        await store.insert(calibration_run(), None, "")
        leaving = asyncio.create_task(store.transactions.write_at_once(write))
        await asyncio.to_thread(begun.wait, TIMEOUT_S)
        leaving.cancel()
        await asyncio.wait([leaving])
        closing = asyncio.create_task(store.close())
        await asyncio.wait([closing], timeout=0.2)
        assert not closing.done()
        go_on.set()
        await closing
        assert database.execute("SELECT reason FROM runs") == [("stored",)]
