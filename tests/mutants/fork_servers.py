"""Kits and broken servers by fork: most checks of a rule take less than an import."""

from __future__ import annotations

import contextlib
import importlib
import pkgutil
import sys
from collections.abc import Iterator
from dataclasses import dataclass

from tests.mutants import load
from tests.support.forking.fork_server import CAN_FORK, Main, fork_server, stand_in
from tests.support.forking.forked_servers import import_server, run_server


@dataclass(frozen=True, slots=True)
class Commands:
    """How a kit and a mutant are started; the mutant's name follows."""

    kit: tuple[str, ...]
    server: tuple[str, ...]


PLAIN = Commands(
    (sys.executable, "-m", "conformance"),
    (sys.executable, "-m", "tests.mutants.serve"),
)


@contextlib.contextmanager
def fork_servers() -> Iterator[Commands]:
    """Start both for a while; where they cannot work, give the plain commands."""
    if not CAN_FORK:
        yield PLAIN
        return
    with forked_kit() as kit, fork_server(f"{__name__}:prepare_mutants") as server:
        yield Commands(kit, stand_in(server))


@contextlib.contextmanager
def forked_kit() -> Iterator[tuple[str, ...]]:
    """Start the fork server of the kit alone; give the command of a kit."""
    if not CAN_FORK:
        yield PLAIN.kit
        return
    with fork_server(f"{__name__}:prepare_kit") as path:
        yield stand_in(path)


def prepare_kit() -> Main:
    """In the fork server: import everything that a kit imports, its checks as well."""
    import conformance.checks
    from conformance.cli.main import main
    from conformance.specification.ledger import load_ledger

    load_ledger()
    for late in (
        "conformance.runner.execution",
        "httpcore",
        "stringprep",
    ):
        importlib.import_module(late)  # otherwise imported when first needed
    folder = conformance.checks
    for found in pkgutil.walk_packages(folder.__path__, f"{folder.__name__}."):
        importlib.import_module(found.name)
    return main


def prepare_mutants() -> Main:
    """In the fork server: the same for the server, and for every way to break it."""
    import_server()
    mutants = load()
    return lambda arguments: run_server(arguments[1:], mutants[arguments[0]].patch)
