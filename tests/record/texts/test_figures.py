"""Figures are rounded alike in every place, and a difference adds up with its sides."""

import re
from decimal import Decimal
from pathlib import Path

import pytest

from reference_record.texts.figures import difference_figure, figure

ROOT = Path(__file__).parents[3]
SCORE = r"(score|mean|rate|kappa|difference|low|high|p_value)"
OTHER_FORMAT = re.compile(rf"\b{SCORE}\w*:[+]?\.\df|\b{SCORE}\w*\.toFixed")


@pytest.mark.parametrize(
    ("value", "places", "text"),
    [
        (0.91875, 4, "0.9188"),
        (0.03125, 4, "0.0313"),
        (0.5, 0, "1"),
        (2 / 3, 4, "0.6667"),
        (0.1 + 0.2, 1, "0.3"),
        (-0.08125, 4, "-0.0813"),
        (-0.00001, 4, "0.0000"),
        (1e20, 1, "100000000000000000000.0"),
        (float("inf"), 2, "inf"),
        (float("nan"), 2, "nan"),
    ],
)
def test_a_half_is_rounded_away_from_zero(value: float, places: int, text: str) -> None:
    assert figure(value, places) == text


@pytest.mark.parametrize(
    ("value", "text"),
    [(0.25, "+0.250"), (-0.25, "-0.250"), (0.0, "+0.000"), (-0.0, "+0.000")],
)
def test_a_difference_has_its_sign(value: float, text: str) -> None:
    assert figure(value, 3, sign=True) == text


@pytest.mark.parametrize(
    ("run", "baseline", "text"),
    [
        (0.5, 0.8125, "-0.313"),
        (0.9375, 1, "-0.062"),
        (0.5, 0.5, "+0.000"),
        (2 / 3, 1 / 3, "+0.333"),  # 0.667 - 0.333 is not it
    ],
)
def test_a_difference_is_that_of_the_unrounded_values(
    run: float, baseline: float, text: str
) -> None:
    assert difference_figure(run, baseline, 3) == text


@pytest.mark.parametrize("run", range(17))
@pytest.mark.parametrize("baseline", range(17))
def test_halves_add_up_with_their_difference_whichever_is_the_baseline(
    run: int, baseline: int
) -> None:
    shown = difference_figure(run / 16, baseline / 16, 3)
    assert Decimal(figure(baseline / 16, 3)) + Decimal(shown) == Decimal(
        figure(run / 16, 3)
    )
    assert float(difference_figure(baseline / 16, run / 16, 3)) == -float(shown)


def test_scores_are_formatted_by_these_functions_alone() -> None:
    """Another format beside them would round a half in another way."""
    beside = [
        f"{path}: {found[0]}"
        for pattern in ("reference_*/**/*.py", "reference_*/**/*.html*")
        for path in ROOT.glob(pattern)
        for found in OTHER_FORMAT.finditer(path.read_text(encoding="utf-8"))
    ]
    assert beside == []
    assert OTHER_FORMAT.search('f"{score.mean:.3f}"')
    assert OTHER_FORMAT.search("one.score.toFixed(3)")
