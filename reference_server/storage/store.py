"""What outlives the process: the one module that knows the database.

SQLAlchemy over SQLite by default; a URL makes it PostgreSQL. It stores and returns
runs and holds no rule: what a restart does to runs is a table that it is given.
Sessions are not stored: they end with the process.
"""

from __future__ import annotations

import asyncio
import contextlib
from collections import Counter
from collections.abc import (
    AsyncIterator,
    Awaitable,
    Callable,
    Iterable,
    Iterator,
    Mapping,
    Sequence,
)
from concurrent.futures import ThreadPoolExecutor
from contextlib import asynccontextmanager
from pathlib import Path
from typing import Any, TypeVar

import msgspec
import sqlalchemy as sa
from sqlalchemy.ext.asyncio import AsyncConnection, AsyncEngine, create_async_engine

from reference_server.rules.capacity import WaitingRun
from reference_server.rules.manifest import Manifest
from reference_server.rules.run import Episode, PublicKey, Run, RunHead, State
from reference_server.storage import rows
from reference_server.system import private_files

Found = TypeVar("Found")

# Reads of the database file that run at once.
READER_THREADS = 4
# Decoded manifests kept, for all the runs that share them.
CACHED_MANIFESTS_MAX = 64

# Tables of other modules of this folder are added to these.
TABLES = sa.MetaData()

_runs = sa.Table(
    "runs",
    TABLES,
    sa.Column("number", sa.Integer, primary_key=True, autoincrement=True),
    sa.Column("run_id", sa.String(64), unique=True, nullable=False),
    sa.Column("account", sa.String(200), nullable=False),
    sa.Column("state", sa.String(16), nullable=False, index=True),
    sa.Column("reason", sa.Text),
    sa.Column("retryable", sa.Boolean),
    sa.Column("manifest_sha256", sa.String(64), nullable=False),
    sa.Column("submission", sa.LargeBinary, nullable=False),
    sa.Column("max_workers", sa.Integer, nullable=False),
    sa.Column("idle_timeout_s", sa.Float, nullable=False),
    sa.Column("images", sa.LargeBinary, nullable=False),
    sa.Column("created_at_wall", sa.Float, nullable=False),
    sa.Column("updated_at_wall", sa.Float, nullable=False),
    sa.Column("queue_until_wall", sa.Float, nullable=False),
    # How many of its episodes have a result; NULL in rows older than this column.
    sa.Column("scored", sa.Integer),
    # NULL in rows older than these columns.
    sa.Column("benchmark_id", sa.String(64)),
    sa.Column("attempts_by_submitter", sa.Integer),
    # What it counts for its account; NULL in rows older than this column.
    sa.Column("stored_bytes", sa.BigInteger),
    # NULL if no action was executed in it.
    sa.Column("played_number", sa.Integer),
    # NULL unless it was deleted: its row stays, so that it stays counted.
    sa.Column("deleted_at_wall", sa.Float),
    sa.Index("runs_of_account", "account", "number"),
    sa.Index("runs_of_benchmark", "account", "benchmark_id", "attempts_by_submitter"),
    sa.Index("runs_played", "account", "benchmark_id", "played_number"),
)
# A manifest is stored once, however many runs use it.
_manifests = sa.Table(
    "manifests",
    TABLES,
    sa.Column("manifest_sha256", sa.String(64), primary_key=True),
    sa.Column("manifest", sa.LargeBinary, nullable=False),
)
# Only episodes that something happened to; the others follow from the manifest.
_episodes = sa.Table(
    "episodes",
    TABLES,
    sa.Column("number", sa.ForeignKey("runs.number"), primary_key=True),
    sa.Column("index", sa.Integer, primary_key=True),
    sa.Column("attempt", sa.Integer, nullable=False),
    sa.Column("faults", sa.Integer, nullable=False),
    sa.Column("faults_forgiven", sa.Integer, nullable=False),
    sa.Column("result", sa.LargeBinary),
    sa.Column("policy_fault", sa.Text),
    # Of its result among those of the run; NULL in rows older than this column.
    sa.Column("place", sa.Integer),
    # NULL if the episode was not recorded.
    sa.Column("recording", sa.LargeBinary),
)
_keys = sa.Table(
    "idempotency_keys",
    TABLES,
    sa.Column("account", sa.String(200), primary_key=True),
    sa.Column("key", sa.String(128), primary_key=True),
    sa.Column("body_sha256", sa.String(64), nullable=False),
    sa.Column("run_id", sa.String(64), nullable=False),
)

# The statements of records, in the order in which they were signed.
_statements = sa.Table(
    "statements",
    TABLES,
    sa.Column("number", sa.Integer, primary_key=True, autoincrement=True),
    sa.Column("run_id", sa.String(64), unique=True, nullable=False),
    sa.Column("statement", sa.LargeBinary, nullable=False),
    sa.Column("sha256", sa.String(64), nullable=False),
)
_signing_keys = sa.Table(
    "signing_keys",
    TABLES,
    sa.Column("keyid", sa.String(80), primary_key=True),
    sa.Column("public_key", sa.LargeBinary, nullable=False),
    sa.Column("created_at_wall", sa.Float, nullable=False),
    sa.Column("retired_at_wall", sa.Float),
)

_COUNT_SCORED = (
    sa.select(sa.func.count(_episodes.c.result))
    .where(_episodes.c.number == _runs.c.number)
    .scalar_subquery()
)
_IS_THERE = _runs.c.deleted_at_wall.is_(None)
_NOT_IN_HEADS = ("scored", "stored_bytes", "deleted_at_wall")
_HEADS = sa.select(
    *(one for one in _runs.c if one.name not in _NOT_IN_HEADS),
    sa.func.coalesce(_runs.c.scored, _COUNT_SCORED).label("scored"),
).where(_IS_THERE, _runs.c.run_id.in_(sa.bindparam("run_ids", expanding=True)))
_MANIFEST = sa.select(_manifests.c.manifest).where(
    _manifests.c.manifest_sha256 == sa.bindparam("manifest_sha256")
)
_OF_RUN = sa.select(*(_episodes.c[name] for name in rows.EPISODE_COLUMNS)).where(
    _episodes.c.number == sa.bindparam("number")
)
_start, _end = (sa.bindparam(name, type_=sa.Integer) for name in ("start", "end"))
_EPISODES_IN_RANGE = _OF_RUN.where(
    _episodes.c.index >= _start, _episodes.c.index < _end
)
# One after another as they were scored, like Run.scored_order.
_EPISODES_SCORED = (
    _OF_RUN.where(_episodes.c.result.is_not(None))
    .order_by(sa.func.coalesce(_episodes.c.place, 0), _episodes.c.index)
    .offset(_start)
    .limit(_end - _start)
)


class StoreFailed(Exception):
    """The database failed; nothing of the transaction was stored."""


class RunIsKept(Exception):
    """The run cannot be deleted: something else that is stored needs it."""


# Is called in the transaction that deletes a run, with its id and whether the host
# deletes it; deletes what goes with it, or raises RunIsKept.
BeforeDelete = Callable[[AsyncConnection, str, bool], Awaitable[None]]


async def _delete_nothing_else(_: AsyncConnection, _run_id: str, _host: bool) -> None:
    """What precedes a deletion, unless something else is named."""


async def _complete_nothing(_run: Run) -> None:
    """What precedes a write, unless something else is named."""


class Store:
    """Runs on disk. Writes happen one after another; each is one transaction.

    before_save: completes a run that is about to be stored. after_save: is called with
    the run and the indices of the episodes that were stored.
    """

    def __init__(
        self,
        url: str,
        before_save: Callable[[Run], Awaitable[None]] = _complete_nothing,
        after_save: Callable[[Run, set[int]], None] = lambda _run, _indices: None,
    ) -> None:
        self._before_save, self._after_save = before_save, after_save
        self._before_delete: BeforeDelete = _delete_nothing_else
        try:
            self._url = sa.make_url(url)
            self._engine: AsyncEngine = create_async_engine(self._url)
        except (sa.exc.SQLAlchemyError, ImportError) as error:
            raise StoreFailed(_one_line(error)) from error
        self._write_lock = asyncio.Lock()
        # A database in memory is one connection, and so one transaction at a time.
        shared = isinstance(self._engine.pool, sa.StaticPool)
        self._exclusive = asyncio.Lock() if shared else contextlib.nullcontext()
        if self._url.get_backend_name() == "sqlite":
            sa.event.listen(self._engine.sync_engine, "connect", _tune_sqlite)
        # The async driver switches to its thread and back for each step of a query. For
        # reads of a file one switch is enough for all queries of one read.
        self._read_engine: sa.Engine | None = None
        # Not the loop's own threads: a slow DNS look-up may occupy those.
        self._reader_threads = ThreadPoolExecutor(READER_THREADS, "store")
        if self._url.get_backend_name() == "sqlite" and not shared:
            self._read_engine = sa.create_engine(self._url.set(drivername="sqlite"))
            sa.event.listen(self._read_engine, "connect", _set_query_only)
            sa.event.listen(self._read_engine, "begin", _begin)
        self._manifest_cache: dict[str, Manifest] = {}

    async def open(self) -> None:
        """Create the tables and the columns that are missing."""
        path = _database_file(self._url)
        if path is not None:
            try:
                private_files.create_empty(path)
            except OSError as error:
                raise StoreFailed(_one_line(error)) from error
        async with self._transaction() as connection:
            await connection.run_sync(TABLES.create_all)
            added = await connection.run_sync(_add_missing_columns)
            await connection.run_sync(_number_older_attempts)
            if _runs.c.played_number in added:
                await connection.run_sync(_number_older_played)
        if path is not None:  # only now it is known to be a database
            for suffix in ("", "-wal", "-shm"):
                private_files.restrict(path.with_name(path.name + suffix))

    async def close(self) -> None:
        await self._engine.dispose()
        if self._read_engine is not None:
            self._reader_threads.shutdown(wait=False)
            self._read_engine.dispose()

    @asynccontextmanager
    async def _transaction(self) -> AsyncIterator[AsyncConnection]:
        try:
            async with self._exclusive, self._engine.begin() as connection:
                yield connection
        except (sa.exc.SQLAlchemyError, OSError) as error:
            # An unreachable server is reported by its driver, not by SQLAlchemy.
            raise StoreFailed(_one_line(error)) from error

    @asynccontextmanager
    async def write(self) -> AsyncIterator[AsyncConnection]:
        """A transaction after all writes before it. Raises StoreFailed."""
        async with self._write_lock, self._transaction() as connection:
            yield connection

    async def _read(self, fetch: Callable[[sa.Connection], Found]) -> Found:
        """What `fetch` finds, all of it as it was at one moment."""
        if self._read_engine is None:
            async with self._transaction() as connection:
                return await connection.run_sync(fetch)
        try:
            loop = asyncio.get_running_loop()
            return await loop.run_in_executor(
                self._reader_threads, _run_in_connection, self._read_engine, fetch
            )
        except (sa.exc.SQLAlchemyError, OSError) as error:
            raise StoreFailed(_one_line(error)) from error

    async def read(self, fetch: Callable[[sa.Connection], Found]) -> Found:
        """What `fetch` finds in tables of another module of storage/."""
        return await self._read(fetch)

    async def insert(self, run: Run, key: str | None, body_sha256: str) -> bool:
        """Store a new run and give it its number, unless its key is taken (CRASH-003).

        Returns whether it was stored.
        """
        async with self._write_lock, self._transaction() as connection:
            if key is not None and await _find_key(connection, run.account, key):
                return False
            before = await connection.scalar(_last_attempt(run))
            run.attempts_by_submitter = 1 + (before or 0)  # REC-110
            row = rows.new_run_row(run)
            known = sa.select(_manifests.c.manifest_sha256).where(
                _manifests.c.manifest_sha256 == run.manifest_sha256
            )
            if (await connection.execute(known)).first() is None:
                await connection.execute(
                    _manifests.insert().values(
                        manifest_sha256=run.manifest_sha256,
                        manifest=msgspec.json.encode(run.manifest),
                    )
                )
            inserted = await connection.execute(
                _runs.insert().values(row).returning(_runs.c.number)
            )
            run.number = inserted.scalar_one()
            if key is not None:
                await connection.execute(
                    _keys.insert().values(
                        account=run.account,
                        key=key,
                        body_sha256=body_sha256,
                        run_id=run.run_id,
                    )
                )
        return True

    async def save(self, run: Run) -> None:
        """Commit the run's state and the episodes that changed since.

        CRASH-001, CRASH-004: every answer that shows them is sent after that.
        """
        await self._before_save(run)  # while others write
        async with self._write_lock:
            await self._before_save(run)  # what came since then
            # Read inside the lock and before any other await: a later save never
            # overtakes an earlier one, and state and episodes are of one moment.
            if run.lost:
                raise StoreFailed("an earlier write of the run failed")
            changed, run.changed = run.changed, set()
            row, episodes = rows.run_row(run), rows.episode_rows(run, changed)
            count = run.is_played and run.played_number is None
            try:
                async with self._transaction() as connection:
                    if count:
                        before = await connection.scalar(_last_played(run))
                        row["played_number"] = 1 + (before or 0)
                    await connection.execute(
                        _runs.update().where(_runs.c.number == run.number).values(row)
                    )
                    await _replace_episodes(connection, run.number, episodes)
            except StoreFailed:
                run.changed |= changed
                raise
            run.played_number = row["played_number"]
        self._after_save(run, changed)

    def before_delete(self, call: BeforeDelete) -> None:
        """Of another module of storage/, whose tables name runs."""
        self._before_delete = call

    async def delete(
        self, run: RunHead, now_wall: float, *, by_host: bool = False
    ) -> None:
        """Delete what is stored of a run, but for what counts it (DEL-006).

        Its Idempotency-Key stays used (DEL-005), and of its statement the digest, which
        the next one names. Raises RunIsKept.
        """
        of_run = _runs.c.number == run.number
        emptied = _statements.update().where(_statements.c.run_id == run.run_id)
        async with self._write_lock, self._transaction() as connection:
            await self._before_delete(connection, run.run_id, by_host)
            await connection.execute(
                _episodes.delete().where(_episodes.c.number == run.number)
            )
            await connection.execute(emptied.values(statement=b""))
            await connection.execute(
                _runs.update().where(of_run).values(rows.deleted_run_row(now_wall))
            )

    async def deleted_ids(self, run_ids: Sequence[str]) -> set[str]:
        """Which of these runs were deleted."""
        query = sa.select(_runs.c.run_id).where(~_IS_THERE, _runs.c.run_id.in_(run_ids))
        async with self._transaction() as connection:
            return set(await connection.scalars(query))

    async def is_deleted(self, connection: AsyncConnection, run_id: str) -> bool:
        """Whether the run was deleted, as a transaction of `write` sees it."""
        query = sa.select(_runs.c.run_id).where(~_IS_THERE, _runs.c.run_id == run_id)
        return await connection.scalar(query) is not None

    async def in_states_since(
        self, states: Sequence[str], before: float, after: int, limit: int
    ) -> list[tuple[int, str]]:
        """(number, id) of runs in these states since then, behind a number."""
        query = sa.select(_runs.c.number, _runs.c.run_id).where(
            _IS_THERE,
            _runs.c.number > after,
            _runs.c.state.in_(states),
            _runs.c.updated_at_wall < before,
        )
        query = query.order_by(_runs.c.number).limit(limit)
        async with self._transaction() as connection:
            return [(n, r) for n, r in await connection.execute(query)]

    async def find_key(self, account: str, key: str) -> tuple[str, str] | None:
        """(body_sha256, run_id) of an account's Idempotency-Key, if it was used."""
        async with self._transaction() as connection:
            return await _find_key(connection, account, key)

    async def load(self, run_id: str) -> Run | None:
        """The run with all its episodes."""

        def fetch(connection: sa.Connection) -> Run | None:
            for row, manifest in self._heads(connection, [run_id]):
                return rows.run_of(
                    row, manifest, _stored_episodes(connection, row["number"])
                )
            return None

        return await self._read(fetch)

    async def read_window(
        self, run_id: str, start: int, end: int | None, scored: bool = False
    ) -> tuple[RunHead, list[Episode]] | None:
        """The run as it is stored, and its episodes that `Run.window` would give."""

        def fetch(connection: sa.Connection) -> tuple[RunHead, list[Episode]] | None:
            for row, manifest in self._heads(connection, [run_id]):
                head = rows.head_of(row, manifest)
                places = range(head.total)[start:end]
                window = (connection, head.number, start, start + len(places))
                if scored:
                    found = _stored_episodes(*window, _EPISODES_SCORED)
                    return head, [rows.episode_of(manifest, one) for one in found]
                found = _stored_episodes(*window)
                return head, rows.episodes_of(manifest, places, found)
            return None

        return await self._read(fetch)

    async def heads(self, run_ids: Sequence[str]) -> dict[str, RunHead]:
        """Those runs by id, without their episodes."""

        def fetch(connection: sa.Connection) -> dict[str, RunHead]:
            found = (rows.head_of(*one) for one in self._heads(connection, run_ids))
            return {head.run_id: head for head in found}

        return await self._read(fetch)

    def _heads(
        self, connection: sa.Connection, run_ids: Sequence[str]
    ) -> Iterator[tuple[rows.Row, Manifest]]:
        """Each run's row and manifest."""
        rows = connection.execute(_HEADS, {"run_ids": run_ids}).mappings().all()
        for row in rows:
            yield dict(row), self._manifest(connection, row["manifest_sha256"])

    def _manifest(self, connection: sa.Connection, sha256: str) -> Manifest:
        """The one decoded copy of a manifest; several threads may call at a time."""
        manifest = self._manifest_cache.get(sha256)
        if manifest is None:
            known = {"manifest_sha256": sha256}
            manifest = msgspec.json.decode(connection.scalars(_MANIFEST, known).one())
            if len(self._manifest_cache) >= CACHED_MANIFESTS_MAX:
                self._manifest_cache.clear()
            self._manifest_cache[sha256] = manifest
        return manifest

    async def page(
        self, account: str | None, before: int | None, limit: int
    ) -> list[tuple[int, str]]:
        """(number, run_id) of an account's runs, newest first, below a number.

        AUTH-004: of this account only; None for all (AUTH-008). RUN-009: numbers
        never change.
        """
        query = sa.select(_runs.c.number, _runs.c.run_id).where(_IS_THERE)
        if account is not None:
            query = query.where(_runs.c.account == account)
        if before is not None:
            query = query.where(_runs.c.number < before)
        query = query.order_by(_runs.c.number.desc()).limit(limit)

        def fetch(connection: sa.Connection) -> list[tuple[int, str]]:
            return [(n, r) for n, r in connection.execute(query)]

        return await self._read(fetch)

    async def replace_states(self, states: Mapping[State, State], reason: str) -> None:
        """Move every run in one of these states to the state beside it."""
        async with self._write_lock, self._transaction() as connection:
            for before, after in states.items():
                await connection.execute(
                    _runs.update()
                    .where(_runs.c.state == before)
                    .values(state=after, reason=reason)
                )

    # --- records ---

    async def count_attempts(self, run: RunHead) -> int:
        """How many runs of its benchmark the run's account has submitted so far."""
        async with self._transaction() as connection:
            # Its rows may be older than the column that counts.
            return max(1, await connection.scalar(_last_attempt(run)) or 0)

    async def attempts_of(
        self, accounts: Iterable[str], benchmark_ids: Iterable[str]
    ) -> dict[tuple[str, str], int]:
        """(account, benchmark) → how many runs of it were submitted (BRD-019)."""
        of = (_runs.c.account, _runs.c.benchmark_id)
        query = sa.select(*of, sa.func.max(_runs.c.attempts_by_submitter))
        query = query.where(
            _runs.c.account.in_(accounts), _runs.c.benchmark_id.in_(benchmark_ids)
        ).group_by(*of)

        def fetch(connection: sa.Connection) -> dict[tuple[str, str], int]:
            return {(a, b): n for a, b, n in connection.execute(query)}

        return await self._read(fetch)

    async def find_statement(self, run_id: str) -> bytes | None:
        """That of the run's record, if it was signed."""
        query = sa.select(_statements.c.statement).where(_statements.c.run_id == run_id)
        async with self._transaction() as connection:
            return await connection.scalar(query)

    async def last_statement_sha256(self) -> str | None:
        """Of the statement that was signed last; None before the first."""
        query = sa.select(_statements.c.sha256).order_by(_statements.c.number.desc())
        async with self._transaction() as connection:
            return await connection.scalar(query.limit(1))

    async def add_statement(self, run_id: str, statement: bytes, sha256: str) -> None:
        """Store the statement of a run that has none."""
        row = {"run_id": run_id, "statement": statement, "sha256": sha256}
        async with self._write_lock, self._transaction() as connection:
            await connection.execute(_statements.insert().values(row))

    async def use_key(self, keyid: str, public_key: bytes, now_wall: float) -> None:
        """This key signs from now on; all others are retired."""
        keys = _signing_keys
        retire = keys.update().where(
            keys.c.keyid != keyid, keys.c.retired_at_wall.is_(None)
        )
        async with self._write_lock, self._transaction() as connection:
            await connection.execute(retire.values(retired_at_wall=now_wall))
            again = keys.update().where(keys.c.keyid == keyid)
            known = await connection.execute(again.values(retired_at_wall=None))
            if known.rowcount == 0:
                row = {"keyid": keyid, "public_key": public_key}
                await connection.execute(
                    keys.insert().values(row | {"created_at_wall": now_wall})
                )

    async def keys(self) -> list[PublicKey]:
        """All keys that signed, the newest first."""
        columns = (_signing_keys.c[n] for n in PublicKey.__dataclass_fields__)
        query = sa.select(*columns).order_by(_signing_keys.c.created_at_wall.desc())
        async with self._transaction() as connection:
            return [PublicKey(*row) for row in await connection.execute(query)]

    async def in_states(self, *states: str) -> list[str]:
        """Ids of all runs in these states, oldest first."""
        in_states = _runs.c.state.in_(states)
        query = sa.select(_runs.c.run_id).where(_IS_THERE, in_states)
        async with self._transaction() as connection:
            return list(await connection.scalars(query.order_by(_runs.c.number)))

    async def waiting_runs(self, *states: str) -> list[WaitingRun]:
        """All runs in these states as admission reads them, oldest first."""
        columns = (_runs.c[name] for name in WaitingRun.__dataclass_fields__)
        query = sa.select(*columns).where(_IS_THERE, _runs.c.state.in_(states))
        async with self._transaction() as connection:
            found = await connection.execute(query.order_by(_runs.c.number))
            return [WaitingRun(*row) for row in found]

    async def sizes_of_accounts(self) -> tuple[dict[str, int], dict[str, int]]:
        """Of each account the number of its Idempotency-Keys, and its stored bytes."""
        size = sa.func.coalesce(
            _runs.c.stored_bytes, sa.func.length(_runs.c.submission)
        )
        counted = ((_keys, sa.func.count()), (_runs, sa.func.sum(size)))
        async with self._transaction() as connection:
            keys, sizes = [
                await connection.execute(
                    sa.select(table.c.account, count).group_by(table.c.account)
                )
                for table, count in counted
            ]
            return {a: int(n) for a, n in keys}, {a: int(n) for a, n in sizes}


def _last_attempt(run: RunHead) -> sa.Select[Any]:
    """The largest number that a run of this account and benchmark has."""
    return sa.select(sa.func.max(_runs.c.attempts_by_submitter)).where(
        _runs.c.account == run.account,
        _runs.c.benchmark_id == run.manifest["benchmark_id"],
    )


def _last_played(run: RunHead) -> sa.Select[Any]:
    """The largest place among the runs of this account and benchmark."""
    return sa.select(sa.func.max(_runs.c.played_number)).where(
        _runs.c.account == run.account,
        _runs.c.benchmark_id == run.manifest["benchmark_id"],
    )


def _run_in_connection(
    engine: sa.Engine, fetch: Callable[[sa.Connection], Found]
) -> Found:
    with engine.connect() as connection:
        return fetch(connection)


def _add_missing_columns(connection: sa.Connection) -> set[sa.Column[Any]]:
    """Add the columns that an older database does not have, empty; and the indexes."""
    added = set()
    for table in TABLES.sorted_tables:
        columns = sa.inspect(connection).get_columns(table.name)
        present = {column["name"] for column in columns}
        for column in table.columns:
            if column.name not in present:
                kind = column.type.compile(connection.dialect)
                add = f"ALTER TABLE {table.name} ADD {column.name} {kind}"
                connection.execute(sa.text(add))
                added.add(column)
        for index in table.indexes:
            index.create(connection, checkfirst=True)
    return added


def _number_older_attempts(connection: sa.Connection) -> None:
    """Fill what counts attempts (REC-110) in rows that are older than its columns."""
    older = _runs.c.benchmark_id.is_(None)
    used = sa.select(_runs.c.manifest_sha256).where(older).distinct()
    for sha256 in connection.scalars(used).all():
        known = {"manifest_sha256": sha256}
        manifest = msgspec.json.decode(connection.scalars(_MANIFEST, known).one())
        filled = _runs.update().where(older, _runs.c.manifest_sha256 == sha256)
        connection.execute(filled.values(benchmark_id=manifest["benchmark_id"]))
    unnumbered = sa.func.coalesce(_runs.c.attempts_by_submitter, 0) == 0
    columns = (_runs.c.number, _runs.c.account, _runs.c.benchmark_id)
    query = sa.select(*columns).where(unnumbered).order_by(_runs.c.number)
    counts: Counter[tuple[str, str]] = Counter()
    for number, *of in connection.execute(query).all():
        counts[tuple(of)] += 1
        row = _runs.update().where(_runs.c.number == number)
        connection.execute(row.values(attempts_by_submitter=counts[tuple(of)]))


def _number_older_played(connection: sa.Connection) -> None:
    """Number the runs of which something was stored before that was counted (DEL-006).

    An older row does not say whether a turn inside an episode was its only one.
    """
    of_episode = sa.select(_episodes.c.number).distinct()
    columns = (_runs.c.number, _runs.c.account, _runs.c.benchmark_id)
    query = sa.select(*columns).where(_runs.c.number.in_(of_episode))
    counts: Counter[tuple[str, str]] = Counter()
    for number, *of in connection.execute(query.order_by(_runs.c.number)).all():
        counts[tuple(of)] += 1
        row = _runs.update().where(_runs.c.number == number)
        connection.execute(row.values(played_number=counts[tuple(of)]))


def _database_file(url: sa.URL) -> Path | None:
    """The file of an SQLite database; None if it is in memory, or another database."""
    name = url.database or ":memory:"
    if url.get_backend_name() != "sqlite" or name.startswith((":memory:", "file:")):
        return None
    return Path(name)


def _one_line(error: Exception) -> str:
    return str(error).partition("\n")[0]


def _tune_sqlite(connection: Any, _record: object) -> None:
    cursor = connection.cursor()
    # WAL lets readers pass a writer; FULL makes a commit survive a power cut too.
    for pragma in ("journal_mode=WAL", "synchronous=FULL", "foreign_keys=ON"):
        cursor.execute(f"PRAGMA {pragma}")
    cursor.close()


def _set_query_only(connection: Any, _record: object) -> None:
    connection.isolation_level = None  # `_begin` begins the transaction
    connection.execute("PRAGMA query_only=ON").close()


def _begin(connection: sa.Connection) -> None:
    """All that is read until the end is of one moment."""
    connection.exec_driver_sql("BEGIN")


async def _find_key(
    connection: AsyncConnection, account: str, key: str
) -> tuple[str, str] | None:
    query = sa.select(_keys.c.body_sha256, _keys.c.run_id).where(
        _keys.c.account == account, _keys.c.key == key
    )
    row = (await connection.execute(query)).first()
    return None if row is None else (row[0], row[1])


async def _replace_episodes(
    connection: AsyncConnection, number: int, rows: list[dict[str, Any]]
) -> None:
    """Delete and insert: an upsert that every database speaks."""
    if not rows:
        return
    await connection.execute(
        _episodes.delete().where(
            _episodes.c.number == number,
            _episodes.c.index.in_([row["index"] for row in rows]),
        )
    )
    await connection.execute(_episodes.insert(), rows)


def _stored_episodes(
    connection: sa.Connection,
    number: int,
    start: int = 0,
    end: int = 2**31 - 1,
    query: sa.Select[Any] = _EPISODES_IN_RANGE,
) -> list[rows.EpisodeRow]:
    """What is stored of a run's episodes from start to end, as the query counts."""
    if start == end:
        return []
    window = {"number": number, "start": start, "end": end}
    return [tuple(row) for row in connection.execute(query, window)]
