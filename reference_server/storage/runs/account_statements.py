"""Statements that count for each account all that its quota bounds."""

from __future__ import annotations

import sqlalchemy as sa

from reference_server.rules.capacity import Quota
from reference_server.rules.runs.lifecycle import OPEN_STATES
from reference_server.storage.runs.run_statements import IS_THERE
from reference_server.storage.tables.database_tables import idempotency_keys as _keys
from reference_server.storage.tables.database_tables import runs as _runs

# Rows may be older than the column.
STORED_BYTES = sa.func.coalesce(
    _runs.c.stored_bytes, sa.func.length(_runs.c.submission)
)
_IS_OPEN = sa.and_(IS_THERE, _runs.c.state.in_(OPEN_STATES))
_USED_BY_RUNS = sa.select(
    sa.func.count().filter(_IS_OPEN), sa.func.sum(STORED_BYTES)
).where(_runs.c.account == sa.bindparam("account"))
_COUNT_KEYS = (
    sa.select(sa.func.count())
    .select_from(_keys)
    .where(_keys.c.account == sa.bindparam("account"))
)
_FIND_KEY = sa.select(_keys.c.body_sha256, _keys.c.run_id).where(
    _keys.c.account == sa.bindparam("account"), _keys.c.key == sa.bindparam("key")
)
_NEW_KEY = _keys.insert()


def usage_of(connection: sa.Connection, account: str) -> Quota:
    """How many open runs, keys and bytes the account has."""
    of_account = {"account": account}
    open_runs, stored = connection.execute(_USED_BY_RUNS, of_account).one()
    keys = connection.scalar(_COUNT_KEYS, of_account) or 0
    return Quota(open_runs, keys, int(stored or 0))


def sizes_of_accounts(
    connection: sa.Connection,
) -> tuple[dict[str, int], dict[str, int]]:
    """Two mappings by account: the number of its Idempotency-Keys, its stored bytes."""
    counted = ((_keys, sa.func.count()), (_runs, sa.func.sum(STORED_BYTES)))
    keys, sizes = (
        connection.execute(
            sa.select(table.c.account, count).group_by(table.c.account)
        ).all()
        for table, count in counted
    )
    return {a: int(n) for a, n in keys}, {a: int(n) for a, n in sizes}


def count_kept(connection: sa.Connection, run_id: str, size: int) -> None:
    """Count bytes that are kept for good because of a run."""
    row = _runs.update().where(_runs.c.run_id == run_id)
    connection.execute(row.values(stored_bytes=STORED_BYTES + size))


def find_key(
    connection: sa.Connection, account: str, key: str
) -> tuple[str, str] | None:
    """(body_sha256, run_id) of an account's Idempotency-Key, if it was used."""
    row = connection.execute(_FIND_KEY, {"account": account, "key": key}).first()
    return None if row is None else (row[0], row[1])


def add_key(
    connection: sa.Connection, account: str, key: str, body_sha256: str, run_id: str
) -> None:
    """The key has made this run of that body."""
    of_key = {"account": account, "key": key}
    made = {"body_sha256": body_sha256, "run_id": run_id}
    connection.execute(_NEW_KEY, of_key | made)
