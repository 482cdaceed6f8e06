"""The kit is judged: it fails exactly what each broken server breaks."""

from __future__ import annotations

import os
from collections.abc import Iterator
from typing import NoReturn

import pytest

from tests.mutants import Mutant, load
from tests.mutants.fork_servers import Commands, fork_servers
from tests.mutants.kill import run_mutant
from tests.mutants.seeded_rows import seeded_rows
from tests.mutants.selection import Rows, select

MUTANTS = load()
SELECTION = select(MUTANTS)


def judged_mutants() -> Iterator[object]:
    """Every mutant by all rows; those that this commit selects, by the rows chosen.

    What the selection leaves out is judged by `make test-all` alone.
    """
    left_out = pytest.mark.release(SELECTION.explain(len(MUTANTS)))
    for name in sorted(MUTANTS):
        chosen = SELECTION.rows.get(name)
        if chosen == "own":
            yield pytest.param(name, "own", id=f"{name}-own")
        marks = () if chosen == "all" else left_out
        yield pytest.param(name, "all", id=f"{name}-all", marks=marks)


@pytest.fixture(scope="module")
def commands() -> Iterator[Commands]:
    """How kits and mutants are started; their imports are paid for once."""
    with fork_servers() as started:
        yield started


@pytest.mark.parametrize("name", sorted(MUTANTS))
def test_mutant_replaces_what_the_server_has_today(name: str) -> None:
    """Expect the patch to apply, in a process of its own: it changes modules."""
    child = os.fork()
    if not child:
        _apply(MUTANTS[name])
    assert os.waitpid(child, 0)[1] == 0


def _apply(mutant: Mutant) -> NoReturn:
    """Patch this process and end it; its status says whether the patch applied."""
    status = 1
    try:
        mutant.patch()
        status = 0
    finally:
        os._exit(status)


@pytest.mark.slow("a server and a kit each")
@pytest.mark.parametrize(("name", "rows"), list(judged_mutants()))
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
