"""What outlives the process: runs, their episodes, and what was signed.

It stores and returns them and holds no rule: what a restart does to runs is a table
that it is given. Sessions are not stored: they end with the process.
"""

from __future__ import annotations

import asyncio
from collections.abc import (
    AsyncIterator,
    Awaitable,
    Callable,
    Iterable,
    Iterator,
    Mapping,
    Sequence,
)
from contextlib import asynccontextmanager, contextmanager
from functools import partial
from typing import Any

import msgspec
import sqlalchemy as sa
from sqlalchemy.dialects import postgresql, sqlite
from sqlalchemy.ext.asyncio import AsyncConnection

from reference_server.rules.capacity import Quota, WaitingRun
from reference_server.rules.lifecycle import OPEN_STATES
from reference_server.rules.manifest import Manifest
from reference_server.rules.run import Episode, PublicKey, Run, RunHead, State
from reference_server.storage import rows
from reference_server.storage.column_types import any_number
from reference_server.storage.database import Database, Found, StoreFailed
from reference_server.storage.database_tables import accounts as _accounts
from reference_server.storage.database_tables import episodes as _episodes
from reference_server.storage.database_tables import idempotency_keys as _keys
from reference_server.storage.database_tables import manifests as _manifests
from reference_server.storage.database_tables import runs as _runs
from reference_server.storage.database_tables import signing_keys as _signing_keys
from reference_server.storage.database_tables import statements as _statements
from reference_server.storage.schema_version import Upgrade

__all__ = ["NotTheNext", "OwnershipLost", "RunIsKept", "Store", "StoreFailed"]

# Decoded manifests kept, for all the runs that share them.
CACHED_MANIFESTS_MAX = 64

_COUNT_SCORED = (
    sa.select(sa.func.count(_episodes.c.result))
    .where(_episodes.c.number == _runs.c.number)
    .scalar_subquery()
)
_IS_THERE = _runs.c.deleted_at_wall.is_(None)
# Rows may be older than the column.
_STORED_BYTES = sa.func.coalesce(
    _runs.c.stored_bytes, sa.func.length(_runs.c.submission)
)
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

# Made once, so that what they are compiled to is found at once.
_NEW_RUN = _runs.insert().returning(_runs.c.number)
_NEW_KEY = _keys.insert()
_FIND_KEY = sa.select(_keys.c.body_sha256, _keys.c.run_id).where(
    _keys.c.account == sa.bindparam("account"), _keys.c.key == sa.bindparam("key")
)
_HAS_MANIFEST = sa.select(_manifests.c.manifest_sha256).where(
    _manifests.c.manifest_sha256 == sa.bindparam("manifest_sha256")
)
_OWNED_RUN = _runs.update().where(
    _runs.c.number == sa.bindparam("of_number"),
    sa.func.coalesce(_runs.c.fence, 0) == sa.bindparam("of_fence"),
)
_NEW_EPISODE = _episodes.insert()
_OLD_EPISODE = _episodes.delete().where(
    _episodes.c.number == sa.bindparam("of_number"),
    _episodes.c.index == sa.bindparam("of_index"),
)

_LAST_STATEMENT = (
    sa.select(_statements.c.sha256).order_by(_statements.c.number.desc()).limit(1)
)

_OF_NO_ACCOUNT = {"account": "", "counted": 0}
# Of no account: of what is of the host, and not of one of them.
_OF_ALL_ACCOUNTS = "*"


class OwnershipLost(StoreFailed):
    """Another node has claimed the run: nothing of it was stored, nor will be."""


class NotTheNext(Exception):
    """Another node has signed meanwhile, this run or another one."""


class RunIsKept(Exception):
    """The run cannot be deleted: something else that is stored needs it."""


# Is called in the transaction that deletes a run, with its id and whether the host
# deletes it; deletes what goes with it, or raises RunIsKept.
BeforeDelete = Callable[[sa.Connection, str, bool], None]


def _delete_nothing_else(_: sa.Connection, _run_id: str, _host: bool) -> None:
    """What precedes a deletion, unless something else is named."""


async def _complete_nothing(_run: Run) -> None:
    """What precedes a write, unless something else is named."""


class Store:
    """Runs on disk. Writes happen one after another; each is one transaction.

    before_save: completes a run that is about to be stored. after_save: is called with
    the run and the indices of the episodes that were stored. is_shared: other nodes
    write to the database, too.
    """

    def __init__(
        self,
        url: str,
        before_save: Callable[[Run], Awaitable[None]] = _complete_nothing,
        after_save: Callable[[Run, set[int]], None] = lambda _run, _indices: None,
        *,
        is_shared: bool = False,
    ) -> None:
        self._before_save, self._after_save = before_save, after_save
        self._is_shared = is_shared
        self._before_delete: BeforeDelete = _delete_nothing_else
        self._database = Database(url, is_shared=is_shared)
        self._write_lock = asyncio.Lock()
        self._last_write_failed = False
        self._manifest_cache: dict[str, Manifest] = {}

    async def open(self, *, upgrade: bool = True) -> Upgrade | None:
        """Create or upgrade the tables, as Database.open does it."""
        return await self._database.open(upgrade=upgrade)

    async def close(self) -> None:
        await self._database.close()

    @asynccontextmanager
    async def _transaction(self) -> AsyncIterator[AsyncConnection]:
        with self._note_failure():
            async with self._database.transaction() as connection:
                yield connection

    async def _write_at_once(self, store: Callable[[sa.Connection], Found]) -> Found:
        """A transaction of a caller that has the lock of writes."""
        with self._note_failure():
            return await self._database.write(store)

    @contextmanager
    def _note_failure(self) -> Iterator[None]:
        try:
            yield
        except StoreFailed as error:
            self._last_write_failed |= not isinstance(error, OwnershipLost)
            raise

    @asynccontextmanager
    async def write(self) -> AsyncIterator[AsyncConnection]:
        """A transaction after all writes before it. Raises StoreFailed."""
        async with self._write_lock, self._transaction() as connection:
            yield connection

    @asynccontextmanager
    async def write_of_node(self) -> AsyncIterator[AsyncConnection]:
        """A transaction about nodes and owners, which no other write delays.

        But in an SQLite file, which has one writer at a time. Raises StoreFailed.
        """
        if not self._database.has_node_connections:
            async with self.write() as connection:
                yield connection
            return
        async with self._database.node_transaction() as connection:
            yield connection

    async def read_of_node(self, fetch: Callable[[sa.Connection], Found]) -> Found:
        """What `fetch` finds, which no other read delays. Raises StoreFailed."""
        if not self._database.has_node_connections:
            return await self.read(fetch)
        async with self._database.node_transaction() as connection:
            return await connection.run_sync(fetch)

    async def write_in_turn(self, store: Callable[[sa.Connection], Found]) -> Found:
        """What `store` returns, once all that it wrote is stored; as `write` does it.

        store: runs in another thread. What it raises ends the transaction.
        """
        async with self._write_lock:
            return await self._write_at_once(store)

    async def read(self, fetch: Callable[[sa.Connection], Found]) -> Found:
        """What `fetch` finds, all of it as it was at one moment."""
        return await self._database.read(fetch)

    async def check_writable(self) -> None:
        """Raises StoreFailed if no write can begin, or none is stored after a failure.

        On a full disk writes begin. So after one that failed a row is written, and
        deleted again, until that works.
        """
        nothing = _runs.update().where(sa.false()).values(state=_runs.c.state)
        is_tried = self._last_write_failed
        async with self.write() as connection:
            await connection.execute(nothing)
            if is_tried:
                of_none = _accounts.c.account == ""
                await connection.execute(_accounts.insert().values(_OF_NO_ACCOUNT))
                await connection.execute(_accounts.delete().where(of_none))
        if is_tried:
            self._last_write_failed = False

    async def insert(
        self,
        run: Run,
        key: str | None,
        body_sha256: str,
        check: Callable[[Quota], None] | None = None,
    ) -> bool:
        """Store a new run and give it its number, unless its key is taken (CRASH-003).

        check: raises if the account, which has so much, may not have another one.
        Returns whether it was stored.
        """
        async with self._write_lock:
            row = rows.new_run_row(run)  # of the moment at which it is stored

            def store(connection: sa.Connection) -> tuple[int, int] | None:
                self._lock_account(connection, run.account)
                if key is not None and _find_key(connection, run.account, key):
                    return None
                if check is not None:
                    check(_usage_of(connection, run.account))
                before = connection.scalar(_last_attempt(run))
                row["attempts_by_submitter"] = 1 + (before or 0)  # REC-110
                _add_manifest(connection, run)
                number = connection.execute(_NEW_RUN, row).scalar_one()
                if key is not None:
                    of_key = {"account": run.account, "key": key}
                    made = {"body_sha256": body_sha256, "run_id": run.run_id}
                    connection.execute(_NEW_KEY, of_key | made)
                return number, row["attempts_by_submitter"]

            numbers = await self._write_at_once(store)
            if numbers is not None:
                run.number, run.attempts_by_submitter = numbers
        return numbers is not None

    async def save(
        self, run: Run, check: Callable[[Quota], None] | None = None
    ) -> list[Episode]:
        """Commit the run's state and the episodes that changed since.

        Returns those of them that have a result.

        CRASH-001, CRASH-004: every answer that shows them is sent after that. check:
        raises if the account, which has so much without it, may not have it open.
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
            stored = (run.episodes[index] for index in sorted(changed))
            scored = [episode for episode in stored if episode.result is not None]
            count = run.is_played and run.played_number is None

            def store(connection: sa.Connection) -> None:
                if count or check is not None:
                    self._lock_account(connection, run.account)
                if check is not None:
                    check(_usage_of(connection, run.account))
                if count:
                    before = connection.scalar(_last_played(run))
                    row["played_number"] = 1 + (before or 0)
                _update_owned(connection, run, row)
                _replace_episodes(connection, episodes)

            try:
                await self._write_at_once(store)
            except Exception:
                run.changed |= changed
                raise
            run.played_number = row["played_number"]
        self._after_save(run, changed)
        return scored

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
        emptied = _statements.update().where(_statements.c.run_id == run.run_id)
        size = rows.stored_bytes(run)
        row = rows.deleted_run_row(now_wall)
        # What it has in the history of the leaderboard is kept, and counted.
        counted = sa.func.coalesce(_runs.c.stored_bytes, size)
        kept = counted - size + row.pop("stored_bytes")
        of_run = _runs.update().where(_runs.c.number == run.number)

        def store(connection: sa.Connection) -> None:
            self.lock_order(connection)  # for the entry
            self._before_delete(connection, run.run_id, by_host)
            connection.execute(
                _episodes.delete().where(_episodes.c.number == run.number)
            )
            connection.execute(emptied.values(statement=b""))
            _update_owned(connection, run, row)
            connection.execute(of_run.values(stored_bytes=kept))

        await self.write_in_turn(store)

    async def deleted_ids(self, run_ids: Sequence[str]) -> set[str]:
        """Which of these runs were deleted."""
        query = sa.select(_runs.c.run_id).where(~_IS_THERE, _runs.c.run_id.in_(run_ids))
        async with self._database.transaction_that_reads() as connection:
            return set(await connection.scalars(query))

    @staticmethod
    def is_deleted(connection: sa.Connection, run_id: str) -> bool:
        """Whether the run was deleted, as a transaction of a write sees it."""
        query = sa.select(_runs.c.run_id).where(~_IS_THERE, _runs.c.run_id == run_id)
        return connection.scalar(query) is not None

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
        async with self._database.transaction_that_reads() as connection:
            return [(n, r) for n, r in await connection.execute(query)]

    async def find_key(self, account: str, key: str) -> tuple[str, str] | None:
        """(body_sha256, run_id) of an account's Idempotency-Key, if it was used."""
        return await self.read(partial(_find_key, account=account, key=key))

    async def load(self, run_id: str) -> Run | None:
        """The run with all its episodes."""

        def fetch(connection: sa.Connection) -> Run | None:
            for row, manifest in self._heads(connection, [run_id]):
                return rows.run_of(
                    row, manifest, _stored_episodes(connection, row["number"])
                )
            return None

        return await self.read(fetch)

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

        return await self.read(fetch)

    async def heads(self, run_ids: Sequence[str]) -> dict[str, RunHead]:
        """Those runs by id, without their episodes and without their options."""

        def fetch(connection: sa.Connection) -> dict[str, RunHead]:
            found = self._heads(connection, run_ids)
            heads = [rows.listed_head_of(*one) for one in found]
            return {head.run_id: head for head in heads}

        return await self.read(fetch)

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
            query = query.where(_runs.c.number < any_number(before))
        query = query.order_by(_runs.c.number.desc()).limit(limit)

        def fetch(connection: sa.Connection) -> list[tuple[int, str]]:
            return [(n, r) for n, r in connection.execute(query)]

        return await self.read(fetch)

    async def replace_states(self, states: Mapping[State, State], reason: str) -> None:
        """Move every run in one of these states to the state beside it."""
        async with self._write_lock, self._transaction() as connection:
            for before, after in states.items():
                await connection.execute(
                    _runs.update()
                    .where(_runs.c.state == before)
                    .values(state=after, reason=reason)
                )

    def _lock_account(self, connection: sa.Connection, account: str) -> None:
        """Until its end, no other transaction that does this counts the account."""
        if not self._is_shared:  # the lock of writes is enough
            return
        is_sqlite = connection.dialect.name == "sqlite"
        insert = (sqlite if is_sqlite else postgresql).insert(_accounts)
        known = insert.values(account=account, counted=0).on_conflict_do_nothing()
        connection.execute(known)
        counted = _accounts.update().where(_accounts.c.account == account)
        connection.execute(counted.values(counted=_accounts.c.counted + 1))

    def lock_order(self, connection: sa.Connection) -> None:
        """To be called first by a transaction that adds to what has one order.

        What it then reads no other node changes before it ends: the last statement, the
        leaves of the leaderboard, an entry.
        """
        self._lock_account(connection, _OF_ALL_ACCOUNTS)

    async def usage_of(self, account: str) -> Quota:
        """What an account has of what its quota bounds."""
        return await self.read(partial(_usage_of, account=account))

    @staticmethod
    def usage_in(connection: sa.Connection, account: str) -> Quota:
        """`usage_of`, as a transaction of a write sees it."""
        return _usage_of(connection, account)

    @staticmethod
    def count_kept(connection: sa.Connection, run_id: str, size: int) -> None:
        """Count bytes that are kept for good because of a run."""
        row = _runs.update().where(_runs.c.run_id == run_id)
        connection.execute(row.values(stored_bytes=_STORED_BYTES + size))

    # --- records ---

    async def count_attempts(self, run: RunHead) -> int:
        """How many runs of its benchmark the run's account has submitted so far."""
        async with self._database.transaction_that_reads() as connection:
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

        return await self.read(fetch)

    async def find_statement(self, run_id: str) -> bytes | None:
        """That of the run's record, if it was signed."""
        query = sa.select(_statements.c.statement).where(_statements.c.run_id == run_id)
        async with self._database.transaction_that_reads() as connection:
            return await connection.scalar(query)

    async def last_statement_sha256(self) -> str | None:
        """Of the statement that was signed last; None before the first."""
        async with self._database.transaction_that_reads() as connection:
            return await connection.scalar(_LAST_STATEMENT)

    async def add_statement(
        self, run_id: str, statement: bytes, sha256: str, previous: str | None
    ) -> None:
        """Store the statement of a run that has none, behind the one that it names.

        previous: its digest; None for the first. Raises NotTheNext.
        """
        row = {"run_id": run_id, "statement": statement, "sha256": sha256}
        is_there = sa.select(_statements.c.number).where(_statements.c.run_id == run_id)

        def store(connection: sa.Connection) -> None:
            self.lock_order(connection)
            if connection.scalar(_LAST_STATEMENT) != previous:
                raise NotTheNext(run_id)
            if connection.scalar(is_there) is not None:
                raise NotTheNext(run_id)
            connection.execute(_statements.insert().values(row))

        await self.write_in_turn(store)

    async def use_key(self, keyid: str, public_key: bytes, now_wall: float) -> None:
        """This key signs from now on; all others are retired."""
        keys = _signing_keys
        retire = keys.update().where(
            keys.c.keyid != keyid, keys.c.retired_at_wall.is_(None)
        )
        again = keys.update().where(keys.c.keyid == keyid).values(retired_at_wall=None)
        row = {"keyid": keyid, "public_key": public_key, "created_at_wall": now_wall}

        def store(connection: sa.Connection) -> None:
            self.lock_order(connection)
            connection.execute(retire.values(retired_at_wall=now_wall))
            if connection.execute(again).rowcount == 0:
                connection.execute(keys.insert().values(row))

        await self.write_in_turn(store)

    async def keys(self) -> list[PublicKey]:
        """All keys that signed, the newest first."""
        columns = (_signing_keys.c[n] for n in PublicKey.__dataclass_fields__)
        query = sa.select(*columns).order_by(_signing_keys.c.created_at_wall.desc())
        async with self._database.transaction_that_reads() as connection:
            return [PublicKey(*row) for row in await connection.execute(query)]

    async def in_states(self, *states: str) -> list[str]:
        """Ids of all runs in these states, oldest first."""
        in_states = _runs.c.state.in_(states)
        query = sa.select(_runs.c.run_id).where(_IS_THERE, in_states)
        async with self._database.transaction_that_reads() as connection:
            return list(await connection.scalars(query.order_by(_runs.c.number)))

    async def runs_of_manifests(self, benchmark_id: str) -> list[str]:
        """The id of one run of each manifest of a benchmark."""
        query = sa.select(sa.func.max(_runs.c.run_id))
        query = query.where(_IS_THERE, _runs.c.benchmark_id == benchmark_id)
        query = query.group_by(_runs.c.manifest_sha256)
        async with self._database.transaction_that_reads() as connection:
            return sorted(await connection.scalars(query))

    async def waiting_runs(self, *states: str) -> list[WaitingRun]:
        """All runs in these states as the queue reads them, oldest first."""
        columns = (_runs.c[name] for name in WaitingRun.__dataclass_fields__)
        query = sa.select(*columns).where(_IS_THERE, _runs.c.state.in_(states))
        async with self._database.transaction_that_reads() as connection:
            found = await connection.execute(query.order_by(_runs.c.number))
            return [WaitingRun(*row) for row in found]

    async def sizes_of_accounts(self) -> tuple[dict[str, int], dict[str, int]]:
        """Of each account the number of its Idempotency-Keys, and its stored bytes."""
        counted = ((_keys, sa.func.count()), (_runs, sa.func.sum(_STORED_BYTES)))
        async with self._database.transaction_that_reads() as connection:
            keys, sizes = [
                await connection.execute(
                    sa.select(table.c.account, count).group_by(table.c.account)
                )
                for table, count in counted
            ]
            return {a: int(n) for a, n in keys}, {a: int(n) for a, n in sizes}


def _add_manifest(connection: sa.Connection, run: Run) -> None:
    """Store the manifest of a run, unless another run has it."""
    of_run = {"manifest_sha256": run.manifest_sha256}
    if connection.execute(_HAS_MANIFEST, of_run).first() is None:
        row = of_run | {"manifest": msgspec.json.encode(run.manifest)}
        connection.execute(_manifests.insert(), row)


def _update_owned(
    connection: sa.Connection, run: RunHead, row: Mapping[str, Any]
) -> None:
    """Change the row of a run, unless another node has claimed it since it was read."""
    owned = {"of_number": run.number, "of_fence": run.fence}
    if connection.execute(_OWNED_RUN, {**row, **owned}).rowcount == 0:
        raise OwnershipLost(f"another node has claimed {run.run_id}")


def _usage_of(connection: sa.Connection, account: str) -> Quota:
    is_open = sa.and_(_IS_THERE, _runs.c.state.in_(OPEN_STATES))
    count = sa.func.count()
    query = sa.select(count.filter(is_open), sa.func.sum(_STORED_BYTES))
    of_account = query.where(_runs.c.account == account)
    open_runs, stored = connection.execute(of_account).one()
    keys = sa.select(count).select_from(_keys).where(_keys.c.account == account)
    return Quota(open_runs, connection.scalar(keys) or 0, int(stored or 0))


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


def _find_key(
    connection: sa.Connection, account: str, key: str
) -> tuple[str, str] | None:
    row = connection.execute(_FIND_KEY, {"account": account, "key": key}).first()
    return None if row is None else (row[0], row[1])


def _replace_episodes(
    connection: sa.Connection, episodes: Sequence[Mapping[str, Any]]
) -> None:
    """Delete and insert: an upsert that every database speaks."""
    if not episodes:
        return
    old = [{"of_number": one["number"], "of_index": one["index"]} for one in episodes]
    connection.execute(_OLD_EPISODE, old)
    connection.execute(_NEW_EPISODE, episodes)


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
