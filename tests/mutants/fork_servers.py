"""Kits and broken servers by fork: most checks of a rule take less than an import."""

from __future__ import annotations

import contextlib
import sys
from collections.abc import Iterator
from dataclasses import dataclass

from tests.mutants import load
from tests.support.forking.fork_server import CAN_FORK, Main, shared_forks, stand_in
from tests.support.forking.forked_kits import KIT, kit_command
from tests.support.forking.forked_servers import import_server, run_server

PREPARE = f"{__name__}:prepare_mutants"


@dataclass(frozen=True, slots=True)
class Commands:
    """How a kit and a mutant are started; the mutant's name follows."""

    kit: tuple[str, ...]
    server: tuple[str, ...]


PLAIN = Commands(
    (sys.executable, "-m", KIT),
    (sys.executable, "-m", "tests.mutants.serve"),
)


@contextlib.contextmanager
def fork_servers() -> Iterator[Commands]:
    """The commands that start both by fork; the plain ones where that cannot work."""
    yield Commands(kit_command(), mutant_command())


def mutant_command() -> tuple[str, ...]:
    """A command that starts a mutant; its name and the server's options follow."""
    return stand_in(shared_forks(PREPARE)) if CAN_FORK else PLAIN.server


def prepare_mutants() -> Main:
    """In the fork server: import the server, and every way to break it."""
    import_server()
    mutants = load()
    return lambda arguments: run_server(arguments[1:], mutants[arguments[0]].patch)
