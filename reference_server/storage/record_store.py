"""Tables of signatures: the statements of records, and the keys that signed them.

Statements are in one order, each naming the one before it, whichever node signs.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import partial

import sqlalchemy as sa

from reference_server.rules.runs.run import PublicKey, RunHead
from reference_server.storage.connection.transactions import Transactions
from reference_server.storage.runs.run_statements import last_attempt
from reference_server.storage.tables.database_tables import runs as _runs
from reference_server.storage.tables.database_tables import (
    signing_keys as _signing_keys,
)
from reference_server.storage.tables.database_tables import statements as _statements

_LAST_STATEMENT = (
    sa.select(_statements.c.sha256).order_by(_statements.c.number.desc()).limit(1)
)


class NotTheNext(Exception):
    """Another node has signed meanwhile, this run or another one."""


class RecordStore:
    """Statements, keys, and how often each account has tried a benchmark."""

    def __init__(self, transactions: Transactions) -> None:
        self._transactions = transactions

    async def count_attempts(self, run: RunHead) -> int:
        """How many runs of its benchmark the run's account has submitted so far."""
        # At least 1: the rows may be older than the column that is counted.
        return max(1, await self._transactions.read(partial(last_attempt, run=run)))

    async def attempts_of(
        self, accounts: Iterable[str], benchmark_ids: Iterable[str]
    ) -> dict[tuple[str, str], int]:
        """(account, benchmark) → how many runs of it were submitted (BRD-019)."""
        of = (_runs.c.account, _runs.c.benchmark_id)
        query = sa.select(*of, sa.func.max(_runs.c.attempts_by_submitter))
        query = query.where(
            _runs.c.account.in_(accounts), _runs.c.benchmark_id.in_(benchmark_ids)
        ).group_by(*of)

        return await self._transactions.read(
            lambda c: {(a, b): n for a, b, n in c.execute(query)}
        )

    async def find_statement(self, run_id: str) -> bytes | None:
        """The statement of the run's record, if it was signed."""
        query = sa.select(_statements.c.statement).where(_statements.c.run_id == run_id)
        return await self._transactions.read(lambda c: c.scalar(query))

    async def last_statement_sha256(self) -> str | None:
        """The digest of the statement that was signed last; None before the first."""
        return await self._transactions.read(lambda c: c.scalar(_LAST_STATEMENT))

    async def add_statement(
        self, run_id: str, statement: bytes, sha256: str, previous: str | None
    ) -> None:
        """Store the statement of a run that has none, behind the one that it names.

        previous: its digest; None for the first. Raises NotTheNext.
        """
        row = {"run_id": run_id, "statement": statement, "sha256": sha256}
        is_there = sa.select(_statements.c.number).where(_statements.c.run_id == run_id)

        def store(connection: sa.Connection) -> None:
            self._transactions.lock_order(connection)
            if connection.scalar(_LAST_STATEMENT) != previous:
                raise NotTheNext(run_id)
            if connection.scalar(is_there) is not None:
                raise NotTheNext(run_id)
            connection.execute(_statements.insert().values(row))

        await self._transactions.write_in_turn(store)

    async def use_key(self, keyid: str, public_key: bytes, now_wall: float) -> None:
        """Store that this key signs from now on, and that all others are retired."""
        keys = _signing_keys
        retire = keys.update().where(
            keys.c.keyid != keyid, keys.c.retired_at_wall.is_(None)
        )
        again = keys.update().where(keys.c.keyid == keyid).values(retired_at_wall=None)
        row = {"keyid": keyid, "public_key": public_key, "created_at_wall": now_wall}

        def store(connection: sa.Connection) -> None:
            self._transactions.lock_order(connection)
            connection.execute(retire.values(retired_at_wall=now_wall))
            if connection.execute(again).rowcount == 0:
                connection.execute(keys.insert().values(row))

        await self._transactions.write_in_turn(store)

    async def keys(self) -> list[PublicKey]:
        """All keys that signed, the newest first."""
        columns = (_signing_keys.c[n] for n in PublicKey.__dataclass_fields__)
        query = sa.select(*columns).order_by(_signing_keys.c.created_at_wall.desc())
        return await self._transactions.read(
            lambda c: [PublicKey(*row) for row in c.execute(query)]
        )
