"""The kit is judged: it fails exactly what each broken server breaks."""

from __future__ import annotations

import pytest

from tests.mutants import load
from tests.mutants.kill import run_mutant
from tests.support.paths import ROOT

MUTANTS = load()
MATRIX = ROOT / "docs" / "contribute" / "kill-matrix.md"


@pytest.mark.parametrize("name", sorted(MUTANTS))
def test_mutant_is_killed_by_exactly_what_it_breaks(name: str) -> None:
    """The whole kit against one mutant. Expect its ids and no others to fail."""
    kill = run_mutant(MUTANTS[name])
    assert kill.is_exact, str(kill)


def test_matrix_shows_every_mutant() -> None:
    """The kill matrix is rewritten by `make kill-matrix` when a mutant changes."""
    rows = {
        line.split("|")[1].strip(" `"): set(line.split("|")[3].split())
        for line in MATRIX.read_text().splitlines()
        if line.startswith("| `")
    }
    assert rows == {name: set(mutant.kills) for name, mutant in MUTANTS.items()}
