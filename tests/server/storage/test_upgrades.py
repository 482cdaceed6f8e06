"""Databases that older versions of the server made, and one of a newer version."""

from __future__ import annotations

import asyncio
import subprocess
import sys
import time
from pathlib import Path

import pytest
import sqlalchemy as sa
from alembic.autogenerate import compare_metadata
from alembic.config import Config
from alembic.migration import MigrationContext
from alembic.script import ScriptDirectory

from reference_server.rules.runs.run import Leaving, RunHead
from reference_server.storage.connection.database import Database
from reference_server.storage.record_store import RecordStore
from reference_server.storage.runs.run_store import Store, StoreFailed
from reference_server.storage.tables.database_tables import TABLES
from reference_server.storage.tables.schema_version import (
    LEASE_OF_OLDER_S,
    MIGRATIONS,
    VERSIONS,
    Upgrade,
)
from tests.support.server.databases import RUN_COLUMNS, UsedDatabase
from tests.support.server.server_parts import (
    RESULT,
    ServerParts,
    calibration_run,
    record_score,
    run_scenario,
)
from tests.support.servers import TIMEOUT_S

# What the first version of the server made of an empty database.
FIRST_TABLES = (
    """CREATE TABLE runs (number {serial}, run_id VARCHAR(64) NOT NULL,
    account VARCHAR(200) NOT NULL, state VARCHAR(16) NOT NULL, reason TEXT,
    retryable BOOLEAN, manifest_sha256 VARCHAR(64) NOT NULL,
    submission {bytes} NOT NULL, max_workers INTEGER NOT NULL,
    idle_timeout_s FLOAT NOT NULL, images {bytes} NOT NULL,
    created_at_wall FLOAT NOT NULL, updated_at_wall FLOAT NOT NULL,
    queue_until_wall FLOAT NOT NULL, UNIQUE (run_id))""",
    """CREATE TABLE manifests (manifest_sha256 VARCHAR(64) NOT NULL PRIMARY KEY,
    manifest {bytes} NOT NULL)""",
    """CREATE TABLE episodes (number INTEGER NOT NULL REFERENCES runs (number),
    "index" INTEGER NOT NULL, attempt INTEGER NOT NULL, faults INTEGER NOT NULL,
    faults_forgiven INTEGER NOT NULL, result {bytes}, PRIMARY KEY (number, "index"))""",
    """CREATE TABLE idempotency_keys (account VARCHAR(200) NOT NULL,
    "key" VARCHAR(128) NOT NULL, body_sha256 VARCHAR(64) NOT NULL,
    run_id VARCHAR(64) NOT NULL, PRIMARY KEY (account, "key"))""",
    "CREATE INDEX runs_of_account ON runs (account, number)",
    "CREATE INDEX ix_runs_state ON runs (state)",
)
FIRST_COLUMNS = {
    "runs": "number, run_id, account, state, reason, retryable, manifest_sha256, "
    "submission, max_workers, idle_timeout_s, images, created_at_wall, "
    "updated_at_wall, queue_until_wall",
    "manifests": "manifest_sha256, manifest",
    "episodes": 'number, "index", attempt, faults, faults_forgiven, result',
    "idempotency_keys": 'account, "key", body_sha256, run_id',
}

# As it is, in each database: text was not escaped.
OLDER_REASON = r"\\server\share\0"


def make_first_version(database: UsedDatabase) -> None:
    """Give the database the tables of the first server, with the rows that it has."""
    types = {"serial": "INTEGER NOT NULL PRIMARY KEY", "bytes": "BLOB"}
    if database.server is not None:
        types = {"serial": "SERIAL PRIMARY KEY", "bytes": "BYTEA"}
    names = list(FIRST_COLUMNS)
    copies = [
        f"CREATE TABLE copy_of_{name} AS SELECT * FROM {name}"  # noqa: S608
        for name in names
    ]
    dropped = [f"DROP TABLE {table}" for table in all_tables()]
    filled = [
        f"INSERT INTO {name} ({columns}) SELECT {columns} FROM copy_of_{name}"  # noqa: S608
        for name, columns in FIRST_COLUMNS.items()
    ]
    end = [f"DROP TABLE copy_of_{name}" for name in names]
    made = [statement.format(**types) for statement in FIRST_TABLES]
    if database.server is not None:
        end.append("SELECT setval('runs_number_seq', (SELECT max(number) FROM runs))")
    database.execute(*copies, *dropped, *made, *filled, *end)


def all_tables() -> list[str]:
    tables = [table.name for table in reversed(TABLES.sorted_tables)]
    return [*tables, "alembic_version"]


async def save_scored_run(parts: ServerParts, run_id: str) -> None:
    run = calibration_run("score", "echo", "count", run_id=run_id)
    assert await parts.store.insert(run, f"key of {run_id}", "sha")
    record_score(run, 1)
    await parts.store.save(run)


def schema_of(database: UsedDatabase) -> set[str]:
    """Each column, key and index, with its type."""

    def look(connection: sa.Connection) -> set[str]:
        found = MigrationContext.configure(connection, opts={"compare_type": True})
        differences = compare_metadata(found, TABLES)
        assert differences == []
        seen = sa.inspect(connection)
        return {
            f"{table} {kind} {one}"
            for table in seen.get_table_names()
            for kind, all_ in (
                ("index", seen.get_indexes(table)),
                ("unique", seen.get_unique_constraints(table)),
                ("key", [seen.get_pk_constraint(table)]),
                ("foreign", seen.get_foreign_keys(table)),
            )
            for one in all_
        } | {
            f"{table} {column['name']} {column['type']!r} {column['nullable']}"
            for table in seen.get_table_names()
            for column in seen.get_columns(table)
        }

    async def read() -> set[str]:
        opened = Database(database.url)
        try:
            return await opened.read(look)
        finally:
            await opened.close()

    return asyncio.run(read())


async def open_store(database: UsedDatabase, *, upgrade: bool = True) -> Upgrade | None:
    store = Store(database.url)
    try:
        return await store.open(upgrade=upgrade)
    finally:
        await store.close()


def test_the_versions_are_those_of_the_migrations() -> None:
    config = Config()
    config.set_main_option("script_location", str(MIGRATIONS))
    config.set_main_option("path_separator", "os")
    revisions = ScriptDirectory.from_config(config).walk_revisions()
    assert tuple(one.revision for one in revisions) == VERSIONS[::-1]


def test_an_upgraded_database_has_the_tables_of_a_new_one(
    database: UsedDatabase,
) -> None:
    """A migration and the tables of the code say the same."""
    asyncio.run(open_store(database))
    new = schema_of(database)
    make_first_version(database)
    upgraded = asyncio.run(open_store(database))
    assert upgraded == (None, VERSIONS[-1])
    assert schema_of(database) == new
    assert asyncio.run(open_store(database)) is None


def test_the_runs_of_the_first_version_are_there(database: UsedDatabase) -> None:
    async def save_runs(parts: ServerParts) -> None:
        for number in range(3):
            await save_scored_run(parts, f"run_{number}")

    async def read_runs(parts: ServerParts) -> None:
        heads = await parts.store.heads(["run_0", "run_1", "run_2"])
        assert heads["run_0"].reason == OLDER_REASON
        assert [heads[f"run_{n}"].attempts_by_submitter for n in range(3)] == [1, 2, 3]
        assert [heads[f"run_{n}"].played_number for n in range(3)] == [1, 2, 3]
        found = await parts.store.read_window("run_1", 1, 2)
        assert found is not None
        assert (found[0].scored, found[1][0].result) == (1, RESULT)
        assert await parts.store.find_key("alice", "key of run_1") == ("sha", "run_1")
        await use_new_columns(parts, heads["run_1"])
        await save_scored_run(parts, "run_3")
        records = RecordStore(parts.store.transactions)
        assert await records.count_attempts(heads["run_0"]) == 4

    run_scenario(database, save_runs)
    make_first_version(database)
    # Stopped: a queued one may become ready, without the reason, before it is read.
    change = f"UPDATE runs SET reason = '{OLDER_REASON}', state = 'stopped'"  # noqa: S608
    database.execute(change)
    run_scenario(database, read_runs)


async def use_new_columns(parts: ServerParts, head: RunHead) -> None:
    # What the registry has begun to write of it would be written after this otherwise.
    run = await parts.registry.get(head.run_id)
    run.episodes[2].policy_fault = "it hung up"
    run.episodes[2].last_left = Leaving(1, "Ctrl-C \x00")
    record_score(run, 2)
    await parts.registry.writer.commit(run)
    again = await parts.store.read_window(head.run_id, 2, 3)
    assert again is not None
    head, [episode] = again
    assert (head.scored, episode.policy_fault) == (2, "it hung up")
    assert episode.last_left == Leaving(1, "Ctrl-C \x00")


def test_a_database_without_a_version_gets_one(database: UsedDatabase) -> None:
    """Made by the last server that had no versions: nothing else changes."""
    run_scenario(database, lambda parts: save_scored_run(parts, "run_1"))
    before = schema_of(database)
    database.make_unversioned()
    added = [None] * len(RUN_COLUMNS)
    rows = [(*row, *added) for row in database.execute("SELECT * FROM runs")]
    assert asyncio.run(open_store(database)) == (None, VERSIONS[-1])
    assert database.execute("SELECT * FROM runs") == rows
    assert schema_of(database) == before


def test_an_upgrade_that_fails_changes_nothing(database: UsedDatabase) -> None:
    run_scenario(database, lambda parts: save_scored_run(parts, "run_1"))
    make_first_version(database)
    before = tables_of(database)
    database.execute("UPDATE manifests SET manifest = ''")
    failed = "the upgrade failed; nothing was changed: .*truncated"
    with pytest.raises(StoreFailed, match=failed):
        asyncio.run(open_store(database))
    assert tables_of(database) == before


def tables_of(database: UsedDatabase) -> set[str]:
    query = "SELECT name FROM sqlite_master WHERE type = 'table'"
    if database.server is not None:
        query = "SELECT tablename FROM pg_tables WHERE schemaname = 'public'"
    return {name for (name,) in database.execute(query)}


def test_a_newer_database_is_refused(database: UsedDatabase) -> None:
    asyncio.run(open_store(database))
    database.execute("UPDATE alembic_version SET version_num = '9999'")
    with pytest.raises(StoreFailed, match="version 9999, newer than this server"):
        asyncio.run(open_store(database))
    assert database.execute("SELECT * FROM alembic_version") == [("9999",)]


def test_the_database_of_nodes_that_live_is_not_upgraded(
    database: UsedDatabase,
) -> None:
    """They know the older tables alone; a node with a long lease is silent for long.

    Expect an upgrade when the lease of one that was killed ends.
    """

    def set_silent(silent_s: float) -> None:
        database.execute(f"UPDATE nodes SET renewed_at = {time.time() - silent_s}")  # noqa: S608

    async def open_while_it_renews(silent_s: float) -> None:
        opened = asyncio.create_task(open_store(database))
        until = time.monotonic() + TIMEOUT_S
        while not opened.done() and time.monotonic() < until:
            await asyncio.to_thread(set_silent, silent_s)
            await asyncio.wait([opened], timeout=0.1)
        await opened

    asyncio.run(open_store(database))
    database.execute(
        "ALTER TABLE nodes DROP COLUMN settings",
        "UPDATE alembic_version SET version_num = '0005'",
        "INSERT INTO nodes VALUES ('a', 'http://first', 'secret', 0.0)",
    )
    set_silent(0.0)
    with pytest.raises(StoreFailed, match=r"live \(http://first\): end all of them"):
        asyncio.run(open_while_it_renews(0.0))
    database.execute("INSERT INTO cluster_facts VALUES ('node_lease_s', '600.0')")
    set_silent(LEASE_OF_OLDER_S + 9.0)
    with pytest.raises(StoreFailed, match="was killed this is known after 600 s"):
        asyncio.run(open_while_it_renews(LEASE_OF_OLDER_S + 9.0))
    database.execute("DELETE FROM cluster_facts")
    killed_s = time.time()
    set_silent(LEASE_OF_OLDER_S - 3.0)
    assert asyncio.run(open_store(database)) == ("0005", VERSIONS[-1])
    assert time.time() - killed_s >= 3.0


def test_an_older_database_is_only_upgraded_where_that_is_allowed(
    database: UsedDatabase,
) -> None:
    asyncio.run(open_store(database))
    make_first_version(database)
    with pytest.raises(StoreFailed, match="proctor admin db upgrade"):
        asyncio.run(open_store(database, upgrade=False))
    assert "alembic_version" not in tables_of(database)
    asyncio.run(open_store(database))
    assert asyncio.run(open_store(database, upgrade=False)) is None


def test_two_servers_that_start_at_once_upgrade_once(database: UsedDatabase) -> None:
    run_scenario(database, lambda parts: save_scored_run(parts, "run_1"))
    make_first_version(database)

    async def open_both() -> list[Upgrade | None]:
        return list(await asyncio.gather(open_store(database), open_store(database)))

    done = asyncio.run(open_both())
    assert sorted(map(bool, done)) == [False, True]


@pytest.mark.slow("imports the server in a new interpreter")
def test_a_start_with_nothing_to_do_does_not_import_alembic(tmp_path: Path) -> None:
    program = (
        "import asyncio, sys\n"
        "from reference_server.storage.runs.run_store import Store\n"
        f"store = Store('sqlite:///{tmp_path}/proctor.sqlite')\n"
        "asyncio.run(store.open()); asyncio.run(store.close())\n"
        "sys.exit('alembic' in sys.modules)"
    )
    for _ in range(2):
        subprocess.run([sys.executable, "-c", program], check=True)
