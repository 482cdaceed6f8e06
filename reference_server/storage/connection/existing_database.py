"""Databases that a server has made: whether there is one, and which have runs."""

from __future__ import annotations

import contextlib
import sqlite3
from pathlib import Path

from reference_server.storage.connection.database import (
    StoreFailed,
    database_file,
    url_of,
)


def require_database(url: str, *, more: str = "") -> None:
    """Raise StoreFailed if the database would be a file that is not there.

    A server makes it when it starts, so this is the folder of no server, and a file
    that was made here would serve none. more: what else may be named, with a comma.
    """
    path = database_file(url_of(url))
    if path is not None and not path.exists():
        raise StoreFailed(
            f"there is no {path.absolute()}, which a server makes when it starts: give "
            "this command in the folder of the server, or name its database with "
            f"PROCTOR_DATABASE{more}"
        )


def holds_runs(path: Path) -> bool:
    """Whether the file is an SQLite database of a server, of any version, with a run.

    Nothing is written, also not beside it: it may be that of another program, some of
    which have a table of runs, too.
    """
    wal = path.with_name(f"{path.name}-wal")
    mode = "mode=ro" if wal.exists() else "immutable=1"
    try:
        with contextlib.closing(
            sqlite3.connect(f"{path.absolute().as_uri()}?{mode}", uri=True, timeout=0)
        ) as connection:
            query = "SELECT manifest_sha256 FROM runs LIMIT 1"
            return connection.execute(query).fetchone() is not None
    except sqlite3.Error:
        return False
