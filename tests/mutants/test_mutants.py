"""The kit is judged: it fails exactly what each broken server breaks."""

from __future__ import annotations

import operator
import os
import sys
from collections.abc import Iterator, Mapping
from typing import Any, NoReturn

import pytest

from tests.mutants import load
from tests.mutants.fork_servers import Commands, fork_servers
from tests.mutants.kill import run_mutant
from tests.mutants.seeded_rows import seeded_rows
from tests.mutants.selection import Rows, select

MUTANTS = load()


def pytest_generate_tests(metafunc: pytest.Metafunc) -> None:
    """Choose mutants where slow tests may run: the choice takes a second."""
    if {"name", "rows"} <= set(metafunc.fixturenames):
        is_fast_run = metafunc.config.option.markexpr.startswith("not slow and ")
        chosen = [] if is_fast_run else list(judged_mutants())
        metafunc.parametrize(("name", "rows"), chosen)


def judged_mutants() -> Iterator[object]:
    """Every mutant by all rows; those that this commit selects, by the rows chosen.

    What the selection leaves out is judged by `make test-all` alone.
    """
    selection = select(MUTANTS)
    left_out = pytest.mark.release(selection.explain(len(MUTANTS)))
    for name in sorted(MUTANTS):
        chosen = selection.rows.get(name)
        if chosen == "own":
            yield pytest.param(name, "own", id=f"{name}-own")
        marks = () if chosen == "all" else left_out
        yield pytest.param(name, "all", id=f"{name}-all", marks=marks)


@pytest.fixture(scope="module")
def commands() -> Iterator[Commands]:
    """How kits and mutants are started; their imports are paid for once."""
    with fork_servers() as started:
        yield started


def test_each_mutant_replaces_what_the_server_has_today() -> None:
    """Expect each patch to apply to the right server, in a process of its own."""
    reader, writer = os.pipe()
    child = os.fork()
    if not child:
        _apply_all(writer)
    os.close(writer)
    with open(reader, encoding="utf-8") as failures:  # noqa: PTH123 - a descriptor
        assert failures.read() == ""
    assert os.waitpid(child, 0)[1] == 0


def _apply_all(writer: int) -> NoReturn:
    """Patch this process and undo it, mutant by mutant; write which cannot, and end."""
    status = 1
    try:
        right = [(owner, dict(_members(owner))) for owner in _owners()]
        for name, mutant in MUTANTS.items():
            try:
                mutant.patch()
            except Exception as error:  # noqa: BLE001 - any is a failure of the mutant
                os.write(writer, f"{name}: {error!r}\n".encode())
            for owner, members in right:
                _undo(owner, members)
        status = 0
    finally:
        os._exit(status)


_Owner = dict[Any, Any] | type


def _owners() -> Iterator[_Owner]:
    """Give what mutants patch: modules of the server, their classes and tables."""
    for path, module in list(sys.modules.items()):
        if path.startswith("reference_"):
            yield vars(module)
            for value in vars(module).values():
                is_class = isinstance(value, type) and value.__module__ == path
                if is_class or isinstance(value, dict):
                    yield value


def _members(owner: _Owner) -> Mapping[Any, Any]:
    return owner if isinstance(owner, dict) else vars(owner)


def _undo(owner: _Owner, right: dict[Any, Any]) -> None:
    now = _members(owner)
    if all(map(operator.is_, now.values(), right.values())):
        return
    for name, value in right.items():
        if isinstance(owner, dict):
            owner[name] = value
        elif now.get(name) is not value:
            setattr(owner, name, value)


@pytest.mark.slow("a server and a kit each")
def test_mutant_is_killed_by_exactly_what_it_breaks(
    name: str, rows: Rows, commands: Commands
) -> None:
    """The kit against one mutant. Expect its ids and no others judged to fail."""
    kill = run_mutant(MUTANTS[name], rows, commands)
    assert kill.is_exact, str(kill)


def test_rows_that_draw_from_the_seed_are_found() -> None:
    """Those of generated examples, of random bytes, and of a helper's generator."""
    found = seeded_rows()
    assert {"PRED-006", "ENC-003", "ERR-012", "MODEL-002"} <= found
    assert not {"PRED-001", "ENC-004", "ERR-001", "LEASE-003"} & found
