"""The kit's own idea of a comparison: the vectors, and a p-value worked out by hand."""

import json
from fractions import Fraction
from pathlib import Path

import pytest

from conformance.oracle.expected_comparison import expected_comparison, mcnemar
from tests.support.kit.score_differences import differences
from tests.support.paths import ROOT

VECTORS = sorted((ROOT / "spec" / "vectors" / "comparison").iterdir())


@pytest.mark.parametrize("path", VECTORS, ids=lambda path: path.stem)
def test_the_kit_agrees_with_the_vectors(path: Path) -> None:
    vector = json.loads(path.read_text())
    stated = vector["comparison"]
    arguments = vector["baseline"], vector["run"], vector["tolerance"]
    expected = expected_comparison(*arguments)
    assert differences(stated, expected) == []
    # Nothing is compared so loosely that a wrong number would do.
    stated["p_value"] += 2e-9
    stated["wins"] += 1
    assert sorted(differences(stated, expected)) == ["score.p_value", "score.wins"]


def test_known_p_values_of_the_kit() -> None:
    assert mcnemar(0, 0) == mcnemar(2, 2) == 1
    assert mcnemar(7, 1) == mcnemar(1, 7) == Fraction(2 * (1 + 8), 2**8)
