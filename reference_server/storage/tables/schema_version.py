"""Which version of the tables a database has, and the way to the one of this code.

The version is a row that plain SQL reads: a start at which nothing is to be done does
not import Alembic. An empty database gets all tables at once; one of an older version
is upgraded by `migrations/`, in the transaction that is given; one of a newer version
is refused.
"""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

import sqlalchemy as sa

from reference_server.storage.tables.database_clock import silent_s
from reference_server.storage.tables.database_tables import LEASE, TABLES
from reference_server.storage.tables.database_tables import cluster_facts as _facts
from reference_server.storage.tables.database_tables import nodes as _nodes

# Oldest first; the last one is that of this code. Each is a file of `migrations/`.
VERSIONS = ("0001", "0002", "0003", "0004", "0005", "0006")
MIGRATIONS = Path(__file__).parent / "migrations"
# Key of the advisory lock by which only one process at a time upgrades a PostgreSQL
# database.
_UPGRADE_LOCK = 0x50726F63_75706772
# A node has renewed its lease within this time, or that of a longer lease; older
# versions do not say which one they have.
LEASE_OF_OLDER_S = 10.0

_version = sa.Table(
    "alembic_version",
    sa.MetaData(),
    sa.Column("version_num", sa.String(32), nullable=False),
    sa.PrimaryKeyConstraint("version_num", name="alembic_version_pkc"),  # as Alembic
)


class OtherVersion(Exception):
    """The database has a version that cannot be used; the text says what to do."""


class NodesLive(OtherVersion):
    """Nodes of an older version live, or were killed: known after `within_s`."""

    def __init__(self, urls: list[str], lease_s: float, within_s: float) -> None:
        super().__init__(
            f"nodes of an older version live ({', '.join(urls)}): end all of them "
            f"first; of one that was killed this is known after {lease_s:g} s"
        )
        self.within_s = within_s


class UpgradeFailed(Exception):
    """A migration raised `reason`, which may be of any type."""

    def __init__(self, reason: Exception) -> None:
        super().__init__(str(reason))
        self.reason = reason


class Upgrade(NamedTuple):
    """before: None for a database that is older than its first version."""

    before: str | None
    after: str


def prepare(connection: sa.Connection, *, upgrade: bool = True) -> Upgrade | None:
    """Give the database the tables of this code; what was upgraded, if it was.

    upgrade: False: only what is empty is changed. Raises OtherVersion, UpgradeFailed.
    """
    if read_version(connection) == VERSIONS[-1]:
        return None
    _lock(connection)
    version = read_version(connection)  # another process may have done it meanwhile
    if version == VERSIONS[-1]:
        return None
    if version is None and not _has(connection, "runs"):
        TABLES.create_all(connection, checkfirst=False)
        _version.create(connection)
        connection.execute(_version.insert().values(version_num=VERSIONS[-1]))
        return None
    if version is not None and version not in VERSIONS:
        raise OtherVersion(
            f"it is of version {version}, newer than this server, which knows "
            f"{VERSIONS[-1]}: install the newer server again, or restore a backup "
            "of before the upgrade"
        )
    if not upgrade:
        raise OtherVersion(
            f"it is of version {version or 'none'}, older than {VERSIONS[-1]}: start "
            "the server, or run `proctor admin db upgrade`"
        )
    _refuse_beside_nodes(connection)
    _upgrade(connection)
    return Upgrade(version, VERSIONS[-1])


def read_version(connection: sa.Connection) -> str | None:
    """The version of the database; None if it is empty, or older than versions."""
    if not _has(connection, _version.name):
        return None
    return connection.scalar(sa.select(_version.c.version_num))


def _refuse_beside_nodes(connection: sa.Connection) -> None:
    """Raise NodesLive while there may be nodes, which do not know the newer tables."""
    if not _has(connection, _nodes.name):
        return
    lease_s = LEASE_OF_OLDER_S
    if _has(connection, _facts.name):
        named = sa.select(_facts.c.value).where(_facts.c.name == LEASE)
        lease_s = max(lease_s, float(connection.scalar(named) or 0.0))
    query = sa.select(_nodes.c.url, silent_s).where(silent_s <= lease_s)
    if found := connection.execute(query).all():
        within_s = lease_s - min(silent for _, silent in found)
        raise NodesLive(sorted(url for url, _ in found), lease_s, within_s)


def _has(connection: sa.Connection, table: str) -> bool:
    return sa.inspect(connection).has_table(table)


def _lock(connection: sa.Connection) -> None:
    """Let only this process upgrade until the transaction ends."""
    if connection.dialect.name == "postgresql":
        connection.execute(sa.select(sa.func.pg_advisory_xact_lock(_UPGRADE_LOCK)))
    else:
        connection.exec_driver_sql("BEGIN IMMEDIATE")


def _upgrade(connection: sa.Connection) -> None:
    from alembic import command
    from alembic.config import Config

    config = Config(attributes={"connection": connection})
    # Alembic reads % as the begin of a name.
    config.set_main_option("script_location", str(MIGRATIONS).replace("%", "%%"))
    config.set_main_option("path_separator", "os")
    try:
        command.upgrade(config, VERSIONS[-1])
    except Exception as error:
        raise UpgradeFailed(error) from error
