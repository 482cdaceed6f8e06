"""Refuses what a command of the host would do where no server has its database."""

from __future__ import annotations

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
