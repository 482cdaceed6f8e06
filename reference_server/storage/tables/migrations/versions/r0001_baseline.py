"""The tables of the first version that has a number, in any database of before.

A database of before has some of these tables, and some of their columns: each server
added what it knew. Missing tables and columns are added here, and filled where their
content follows from older rows. The tables are those of this version for good.
"""

from __future__ import annotations

from collections import Counter

import msgspec
import sqlalchemy as sa
from alembic import op
from sqlalchemy import Column, Integer, String

revision = "0001"
down_revision = None

_BASELINE = sa.MetaData()

_runs = sa.Table(
    "runs",
    _BASELINE,
    Column("number", Integer, primary_key=True, autoincrement=True),
    Column("run_id", String(64), unique=True, nullable=False),
    Column("account", String(200), nullable=False),
    Column("state", String(16), nullable=False, index=True),
    Column("reason", sa.Text),
    Column("retryable", sa.Boolean),
    Column("manifest_sha256", String(64), nullable=False),
    Column("submission", sa.LargeBinary, nullable=False),
    Column("max_workers", Integer, nullable=False),
    Column("idle_timeout_s", sa.Float, nullable=False),
    Column("images", sa.LargeBinary, nullable=False),
    Column("created_at_wall", sa.Float, nullable=False),
    Column("updated_at_wall", sa.Float, nullable=False),
    Column("queue_until_wall", sa.Float, nullable=False),
    Column("scored", Integer),
    Column("benchmark_id", String(64)),
    Column("attempts_by_submitter", Integer),
    Column("stored_bytes", sa.BigInteger),
    Column("played_number", Integer),
    Column("deleted_at_wall", sa.Float),
    sa.Index("runs_of_account", "account", "number"),
    sa.Index("runs_of_benchmark", "account", "benchmark_id", "attempts_by_submitter"),
    sa.Index("runs_played", "account", "benchmark_id", "played_number"),
)
_manifests = sa.Table(
    "manifests",
    _BASELINE,
    Column("manifest_sha256", String(64), primary_key=True),
    Column("manifest", sa.LargeBinary, nullable=False),
)
_episodes = sa.Table(
    "episodes",
    _BASELINE,
    Column("number", sa.ForeignKey("runs.number"), primary_key=True),
    Column("index", Integer, primary_key=True),
    Column("attempt", Integer, nullable=False),
    Column("faults", Integer, nullable=False),
    Column("faults_forgiven", Integer, nullable=False),
    Column("result", sa.LargeBinary),
    Column("policy_fault", sa.Text),
    Column("place", Integer),
    Column("recording", sa.LargeBinary),
)
sa.Table(
    "idempotency_keys",
    _BASELINE,
    Column("account", String(200), primary_key=True),
    Column("key", String(128), primary_key=True),
    Column("body_sha256", String(64), nullable=False),
    Column("run_id", String(64), nullable=False),
)

sa.Table(
    "statements",
    _BASELINE,
    Column("number", Integer, primary_key=True, autoincrement=True),
    Column("run_id", String(64), unique=True, nullable=False),
    Column("statement", sa.LargeBinary, nullable=False),
    Column("sha256", String(64), nullable=False),
)
sa.Table(
    "signing_keys",
    _BASELINE,
    Column("keyid", String(80), primary_key=True),
    Column("public_key", sa.LargeBinary, nullable=False),
    Column("created_at_wall", sa.Float, nullable=False),
    Column("retired_at_wall", sa.Float),
)

sa.Table(
    "entries",
    _BASELINE,
    Column("number", Integer, primary_key=True, autoincrement=True),
    Column("entry_id", String(64), unique=True, nullable=False),
    Column("run_id", String(64), unique=True, nullable=False),
    Column("account", String(200), nullable=False, index=True),
    Column("benchmark_id", String(64), nullable=False),
    Column("manifest_sha256", String(64), nullable=False, index=True),
    Column("is_listed", sa.Boolean, nullable=False),
    Column("is_public", sa.Boolean, nullable=False),
    Column("entry", sa.LargeBinary, nullable=False),
)
sa.Table(
    "history",
    _BASELINE,
    Column("index", Integer, primary_key=True, autoincrement=False),
    Column("leaf", sa.Text, nullable=False),
    Column("leaf_sha256", sa.LargeBinary, nullable=False),
)

sa.Table(
    "record_imports",
    _BASELINE,
    Column("number", Integer, primary_key=True, autoincrement=True),
    Column("import_id", String(64), unique=True, nullable=False),
    Column("account", String(200), nullable=False),
    Column("archive_sha256", String(64), nullable=False),
    Column("size_bytes", sa.BigInteger, nullable=False),
    Column("statement_sha256", String(64), nullable=False),
    Column("keyid", sa.Text, nullable=False),
    Column("run_id", sa.Text, nullable=False),
    Column("benchmark_id", sa.Text, nullable=False),
    Column("benchmark_version", sa.Text, nullable=False),
    Column("manifest_sha256", String(64), nullable=False),
    Column("policy_name", sa.Text, nullable=False),
    Column("policy_version", sa.Text),
    Column("score", sa.Float),
    Column("episodes", Integer, nullable=False),
    Column("imported_at_wall", sa.Float, nullable=False),
    Column("state", String(16), nullable=False),
    Column("replay", sa.LargeBinary),
    Column("verdict", sa.LargeBinary),
    Column("reason", sa.Text),
    Column("finished_at_wall", sa.Float),
    sa.Index("archives_of_account", "account", "archive_sha256", unique=True),
)

# Columns whose texts PostgreSQL stores since then with each backslash as two
# (`column_types.py`).
_ESCAPED = {
    "runs": ("reason",),
    "episodes": ("policy_fault",),
    "record_imports": (
        *("keyid", "run_id", "benchmark_id", "benchmark_version"),
        *("policy_name", "policy_version", "reason"),
    ),
}


def upgrade() -> None:
    connection = op.get_bind()
    _BASELINE.create_all(connection)
    added = _add_missing_columns(connection)
    if connection.dialect.name == "postgresql":
        _escape_older_text(connection)
    _number_older_attempts(connection)
    if _runs.c.played_number in added:
        _number_older_played(connection)


def _add_missing_columns(connection: sa.Connection) -> set[Column[object]]:
    """Add the columns that an older database does not have, empty; and the indexes."""
    added = set()
    for table in _BASELINE.sorted_tables:
        columns = sa.inspect(connection).get_columns(table.name)
        present = {column["name"] for column in columns}
        for column in table.columns:
            if column.name not in present:
                op.add_column(table.name, Column(column.name, column.type))
                added.add(column)
        for index in table.indexes:
            index.create(connection, checkfirst=True)
    return added


def _escape_older_text(connection: sa.Connection) -> None:
    """Columns that were added now are empty, and stay so."""
    for table, names in _ESCAPED.items():
        for name in names:
            column = _BASELINE.tables[table].c[name]
            escaped = column.table.update().where(sa.func.strpos(column, "\\") > 0)
            doubled = sa.func.replace(column, "\\", "\\\\")
            connection.execute(escaped.values({name: doubled}))


def _number_older_attempts(connection: sa.Connection) -> None:
    """Fill what counts attempts (REC-110) in rows that are older than its columns."""
    older = _runs.c.benchmark_id.is_(None)
    used = sa.select(_runs.c.manifest_sha256).where(older).distinct()
    for sha256 in connection.scalars(used).all():
        of_manifest = _manifests.c.manifest_sha256 == sha256
        stored = connection.scalars(sa.select(_manifests.c.manifest).where(of_manifest))
        manifest = msgspec.json.decode(stored.one())
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
