"""The kit's own idea of a score: the vectors, and what counts as the same number."""

import json
import math
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest

from conformance.oracle.expected_score import expected_score, is_close, wilson
from tests.support.kit.score_differences import differences
from tests.support.paths import ROOT

VECTORS = sorted((ROOT / "spec" / "vectors" / "scoring").iterdir())


@pytest.mark.parametrize("path", VECTORS, ids=lambda path: path.stem)
def test_the_kit_agrees_with_the_vectors(path: Path) -> None:
    vector = json.loads(path.read_text())
    stated, expected = vector["score"], expected_score(vector["episodes"])
    assert differences(stated, expected) == []
    # Nothing is compared so loosely that a wrong number would do.
    stated["score_high"] += 2e-12
    stated["mean_interval"]["low"] += 2e-9
    low = "score.mean_interval.low"
    assert sorted(differences(stated, expected)) == [low, "score.score_high"]


def test_no_trial_allows_any_rate() -> None:
    assert wilson(None, 0) == {"low": 0.0, "high": 1.0}
    assert wilson(Fraction(0), 3)["low"] == 0.0
    assert wilson(Fraction(1), 3)["high"] == 1.0


@pytest.mark.parametrize(
    ("observed", "expected", "is_so"),
    [
        (None, None, True),
        (0.0, None, False),
        (None, Fraction(0), False),
        (1, Fraction(1), True),
        (True, Fraction(1), False),
        ("1", Fraction(1), False),
        (math.nan, Fraction(1), False),
        (math.inf, 1.0, False),
        (1 / 3, Fraction(1, 3), True),
        (1 / 3 + 1e-11, Fraction(1, 3), False),
        (0.5 + 9e-10, 0.5, True),
        (0.5 + 2e-9, 0.5, False),
    ],
)
def test_a_number_is_close_or_not(observed: Any, expected: Any, is_so: bool) -> None:
    assert is_close(observed, expected) == is_so
