"""The reference server by fork: one fork server for each process of the tests."""

import importlib
import sys
from collections.abc import Callable
from pathlib import Path

from tests.support.forking.fork_server import CAN_FORK, Main, shared_forks, stand_in

PROGRAM = (sys.executable, "-m", "reference_server")
PREPARE = f"{__name__}:prepare_server"


def server_forks() -> Path:
    """The socket of this process's fork server of servers."""
    return shared_forks(PREPARE)


def server_command() -> tuple[str, ...]:
    """A command that starts a server, for a kit that starts many."""
    return stand_in(server_forks()) if CAN_FORK else PROGRAM


def prepare_server() -> Main:
    """In the fork server: import all that the server uses."""
    import_server()
    return run_server


def import_server() -> None:
    """Also what is otherwise imported when a database is first opened."""
    for name in ("reference_server.__main__", "sqlalchemy.dialects.sqlite.pysqlite"):
        importlib.import_module(name)


def run_server(arguments: list[str], change: Callable[[], None] | None = None) -> int:
    """In a forked process. change: breaks the server, and never its simulators."""
    from reference_server.__main__ import main
    from tests.support.forking.forked_simulators import fork_simulators

    sys.argv[1:] = arguments
    fork_simulators()
    if change is not None:
        change()
    return int(main() or 0)
