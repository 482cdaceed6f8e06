"""Knows a PostgreSQL database and the folder with its keys and recordings as one pair.

A database that is a file has them beside it. For the others the folder is `var` of the
working directory, wherever a program happens to be started. So the database stores an
id, which a file in the folder has, too, and where the server was that used both. The
files of a cluster are where the settings of its nodes say: its database has no such
id, and one server alone is refused there.
"""

from __future__ import annotations

import asyncio
import secrets
import socket
from collections.abc import Mapping
from pathlib import Path

import sqlalchemy as sa

from reference_record.formats.private_file import read_or_create
from reference_server.storage.connection.database import StoreFailed
from reference_server.storage.connection.existing_database import require_database
from reference_server.storage.connection.transactions import Transactions
from reference_server.storage.tables.database_tables import cluster_facts as _facts

_ID, _PLACE = "files_id", "files_place"
# A database that nodes use has one of these values, at least.
_OF_CLUSTERS = ("records_folder", "seed_secret")


class OtherFiles(StoreFailed):
    """The folder belongs to another database; the text says what to do."""


async def claim_folder(transactions: Transactions, path: Path) -> None:
    """Pair the database of a server that starts with the folder of the file `path`.

    Raises OtherFiles if it has another folder; then nothing is made in this one.
    """
    await transactions.write_in_turn(lambda connection: _claim(connection, path))


def _claim(connection: sa.Connection, path: Path) -> None:
    stored, here = _read(connection), _id_in(path)
    of_cluster = next((stored[name] for name in _OF_CLUSTERS if name in stored), here)
    if _ID not in stored and of_cluster != here:
        raise OtherFiles(
            "this database is of a cluster, whose keys and recordings are where the "
            "settings of its nodes say: start the server with them, and with cluster "
            "on; or, to use them with one server from now on, set the same files "
            f"without cluster, and write {of_cluster} into {path.absolute()}"
        )
    if stored.get(_ID, here) != here:
        raise OtherFiles(
            f"{_difference(path, stored)}: start the server in the folder above that "
            "one, or copy its content here; if it is lost for good, write "
            f"{stored[_ID]} into {path.absolute()}, and others are made"
        )
    if here is None:
        path.unlink(missing_ok=True)  # it is empty, after a loss of power
        here = read_or_create(path, secrets.token_hex(16).encode).decode()
    facts = {_ID: here, _PLACE: f"{path.parent.absolute()} on {socket.gethostname()}"}
    connection.execute(_facts.delete().where(_facts.c.name.in_(facts)))
    rows = [{"name": name, "value": value} for name, value in facts.items()]
    connection.execute(_facts.insert(), rows)


def require_files(url: str, path: Path | None, *, more: str = "") -> None:
    """Refuse a command of the host where a server has not its database and its files.

    path: as of `claim_folder`; None where a name says which files belong to the
    database. more: as of `require_database`. Raises StoreFailed.
    """
    require_database(url, more=more)
    if path is not None:
        asyncio.run(_check_folder(url, path))


async def _check_folder(url: str, path: Path) -> None:
    transactions = Transactions(url)
    try:
        stored = await transactions.read(_read)
    finally:
        await transactions.close()
    # The database of a server that knew no ids has no id, and its files are there.
    here, files = _id_in(path), path.parent.glob(f"{path.stem}.*")
    is_older = _ID not in stored and here is None and any(files)
    if not is_older and stored.get(_ID, "") != here:
        raise OtherFiles(
            f"{_difference(path, stored)}: give this command in the folder of the "
            "server and with its settings"
        )


def _difference(path: Path, stored: Mapping[str, str]) -> str:
    folder = path.parent.absolute()
    here = "others" if path.exists() else "none"
    if _PLACE not in stored:
        return f"{folder} is of no server that has used this database"
    return (
        "the keys, tokens and recordings of this database are in "
        f"{stored[_PLACE]}, and {folder} has {here}"
    )


def _id_in(path: Path) -> str | None:
    try:
        return path.read_text().strip() or None
    except FileNotFoundError:
        return None


def _read(connection: sa.Connection) -> dict[str, str]:
    """An empty database has none, and stays empty."""
    if not sa.inspect(connection).has_table(_facts.name):
        return {}
    rows = connection.execute(sa.select(_facts.c.name, _facts.c.value))
    return {row.name: row.value for row in rows}
