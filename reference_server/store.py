"""What outlives the process: the one module that knows the database.

SQLAlchemy over SQLite by default; a URL makes it PostgreSQL. It stores and returns
runs and holds no rule. Sessions are not here: they end with the process, and a run
that was in play is found ready again (CRASH-002).
"""

from __future__ import annotations

import asyncio
import contextlib
from collections.abc import AsyncIterator, Sequence
from contextlib import asynccontextmanager
from dataclasses import asdict
from pathlib import Path
from typing import Any

import msgspec
import sqlalchemy as sa
from sqlalchemy.ext.asyncio import AsyncConnection, AsyncEngine, create_async_engine

from reference_server.run_state import Episode, Result, Run

_tables = sa.MetaData()

_runs = sa.Table(
    "runs",
    _tables,
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
    sa.Index("runs_of_account", "account", "number"),
)
# A manifest is stored once, however many runs use it.
_manifests = sa.Table(
    "manifests",
    _tables,
    sa.Column("manifest_sha256", sa.String(64), primary_key=True),
    sa.Column("manifest", sa.LargeBinary, nullable=False),
)
# Only episodes that something happened to; the others follow from the manifest.
_episodes = sa.Table(
    "episodes",
    _tables,
    sa.Column("number", sa.ForeignKey("runs.number"), primary_key=True),
    sa.Column("index", sa.Integer, primary_key=True),
    sa.Column("attempt", sa.Integer, nullable=False),
    sa.Column("faults", sa.Integer, nullable=False),
    sa.Column("faults_forgiven", sa.Integer, nullable=False),
    sa.Column("result", sa.LargeBinary),
)
_keys = sa.Table(
    "idempotency_keys",
    _tables,
    sa.Column("account", sa.String(200), primary_key=True),
    sa.Column("key", sa.String(128), primary_key=True),
    sa.Column("body_sha256", sa.String(64), nullable=False),
    sa.Column("run_id", sa.String(64), nullable=False),
)


class StoreFailed(Exception):
    """The database did not do what it was asked; nothing of it was stored."""


class Store:
    """Runs on disk. Writes happen one after another; each is one transaction."""

    def __init__(self, url: str) -> None:
        try:
            self._url = sa.make_url(url)
            self._engine: AsyncEngine = create_async_engine(self._url)
        except (sa.exc.SQLAlchemyError, ImportError) as error:
            raise StoreFailed(_one_line(error)) from error
        self._writing = asyncio.Lock()
        # A database in memory is one connection, and so one transaction at a time.
        shared = isinstance(self._engine.pool, sa.StaticPool)
        self._alone = asyncio.Lock() if shared else contextlib.nullcontext()
        if self._url.get_backend_name() == "sqlite":
            sa.event.listen(self._engine.sync_engine, "connect", _tune_sqlite)

    async def open(self) -> None:
        """Make the tables and end what the last process left in play."""
        if self._url.get_backend_name() == "sqlite" and self._url.database:
            try:
                Path(self._url.database).parent.mkdir(parents=True, exist_ok=True)
            except OSError as error:
                raise StoreFailed(_one_line(error)) from error
        async with self._transaction() as connection:
            await connection.run_sync(_tables.create_all)
            for before, after in (("running", "ready"), ("stopping", "stopped")):
                await connection.execute(
                    _runs.update()
                    .where(_runs.c.state == before)
                    .values(state=after, reason="The server was started anew.")
                )

    async def close(self) -> None:
        await self._engine.dispose()

    @asynccontextmanager
    async def _transaction(self) -> AsyncIterator[AsyncConnection]:
        try:
            async with self._alone, self._engine.begin() as connection:
                yield connection
        except (sa.exc.SQLAlchemyError, OSError) as error:
            # A server that cannot be reached is told by its driver, not by SQLAlchemy.
            raise StoreFailed(_one_line(error)) from error

    async def insert(self, run: Run, key: str | None, body_sha256: str) -> bool:
        """Store a new run and give it its number, unless its key is taken.

        Returns whether it was stored.
        """
        async with self._writing, self._transaction() as connection:
            if key is not None and await _find_key(connection, run.account, key):
                return False
            row = _run_row(run) | {
                "run_id": run.run_id,
                "account": run.account,
                "manifest_sha256": run.manifest_sha256,
                "submission": msgspec.json.encode(run.submission),
                "max_workers": run.max_workers,
                "idle_timeout_s": run.idle_timeout_s,
                "images": msgspec.json.encode(run.images),
                "created_at_wall": run.created_at_wall,
            }
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
        """Commit the run's state and the episodes that changed since the last save."""
        async with self._writing:
            # Read inside the lock and before any other await: a later save never
            # overtakes an earlier one, and state and episodes are of one moment.
            if run.lost:
                raise StoreFailed("an earlier write of the run failed")
            changed, run.changed = run.changed, set()
            row, episodes = _run_row(run), _episode_rows(run, changed)
            try:
                async with self._transaction() as connection:
                    await connection.execute(
                        _runs.update().where(_runs.c.number == run.number).values(row)
                    )
                    await _replace_episodes(connection, run.number, episodes)
            except StoreFailed:
                run.changed |= changed
                raise

    async def find_key(self, account: str, key: str) -> tuple[str, str] | None:
        """(body_sha256, run_id) of an account's Idempotency-Key, if it was used."""
        async with self._transaction() as connection:
            return await _find_key(connection, account, key)

    async def load(self, run_id: str) -> Run | None:
        """The run with all its episodes."""
        async with self._transaction() as connection:
            query = (
                sa.select(_runs, _manifests.c.manifest)
                .join_from(
                    _runs,
                    _manifests,
                    _runs.c.manifest_sha256 == _manifests.c.manifest_sha256,
                )
                .where(_runs.c.run_id == run_id)
            )
            row = (await connection.execute(query)).mappings().first()
            if row is None:
                return None
            touched = await connection.execute(
                sa.select(_episodes).where(_episodes.c.number == row["number"])
            )
            return _run_of(row, touched.mappings().all())

    async def page(
        self, account: str, before: int | None, limit: int
    ) -> list[tuple[int, str]]:
        """(number, run_id) of an account's runs, newest first, below a number."""
        query = sa.select(_runs.c.number, _runs.c.run_id).where(
            _runs.c.account == account
        )
        if before is not None:
            query = query.where(_runs.c.number < before)
        query = query.order_by(_runs.c.number.desc()).limit(limit)
        async with self._transaction() as connection:
            return [(n, r) for n, r in await connection.execute(query)]

    async def in_states(self, *states: str) -> list[str]:
        """Ids of all runs in these states, oldest first."""
        query = sa.select(_runs.c.run_id).where(_runs.c.state.in_(states))
        async with self._transaction() as connection:
            return list(await connection.scalars(query.order_by(_runs.c.number)))


def _one_line(error: Exception) -> str:
    return str(error).partition("\n")[0]


def _tune_sqlite(connection: Any, _record: object) -> None:
    cursor = connection.cursor()
    # WAL lets readers pass a writer; FULL makes a commit survive a power cut too.
    for pragma in ("journal_mode=WAL", "synchronous=FULL", "foreign_keys=ON"):
        cursor.execute(f"PRAGMA {pragma}")
    cursor.close()


async def _find_key(
    connection: AsyncConnection, account: str, key: str
) -> tuple[str, str] | None:
    query = sa.select(_keys.c.body_sha256, _keys.c.run_id).where(
        _keys.c.account == account, _keys.c.key == key
    )
    row = (await connection.execute(query)).first()
    return None if row is None else (row[0], row[1])


def _run_row(run: Run) -> dict[str, Any]:
    """The columns that change in a run's life."""
    return {
        "state": run.state,
        "reason": run.reason,
        "retryable": run.retryable,
        "updated_at_wall": run.updated_at_wall,
        "queue_until_wall": run.queue_until_wall,
    }


def _episode_rows(run: Run, changed: set[int]) -> list[dict[str, Any]]:
    rows = []
    for index in sorted(changed):
        episode = run.episodes[index]
        result = episode.result
        rows.append(
            {
                "number": run.number,
                "index": index,
                "attempt": episode.attempt,
                "faults": episode.faults,
                "faults_forgiven": episode.faults_forgiven,
                "result": msgspec.json.encode(asdict(result)) if result else None,
            }
        )
    return rows


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


def _run_of(row: sa.RowMapping, touched: Sequence[sa.RowMapping]) -> Run:
    manifest = msgspec.json.decode(row["manifest"])
    episodes = [
        Episode(index, plan["task"], plan["split"], plan["seed"])
        for index, plan in enumerate(manifest["episodes"])
    ]
    for stored in touched:
        episode = episodes[stored["index"]]
        episode.attempt = stored["attempt"]
        episode.faults = stored["faults"]
        episode.faults_forgiven = stored["faults_forgiven"]
        if stored["result"]:
            episode.result = msgspec.json.decode(stored["result"], type=Result)
    columns = ("run_id", "number", "account", "state", "reason", "retryable")
    plain = {name: row[name] for name in columns}
    return Run(
        **plain,
        manifest=manifest,
        manifest_sha256=row["manifest_sha256"],
        submission=msgspec.json.decode(row["submission"]),
        max_workers=row["max_workers"],
        idle_timeout_s=row["idle_timeout_s"],
        images=msgspec.json.decode(row["images"]),
        created_at_wall=row["created_at_wall"],
        updated_at_wall=row["updated_at_wall"],
        queue_until_wall=row["queue_until_wall"],
        episodes=episodes,
    )
