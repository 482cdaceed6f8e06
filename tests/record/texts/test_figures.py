"""Figures are rounded alike in every place, and a difference adds up with its sides."""

import pytest

from reference_record.texts.figures import figure


@pytest.mark.parametrize(
    ("value", "places", "text"),
    [
        (0.91875, 4, "0.9188"),
        (0.03125, 4, "0.0313"),
        (0.5, 0, "1"),
        (2 / 3, 4, "0.6667"),
        (0.1 + 0.2, 1, "0.3"),
        (-0.08125, 4, "-0.0812"),
        (-0.00001, 4, "0.0000"),
        (1e20, 1, "100000000000000000000.0"),
        (float("inf"), 2, "inf"),
        (float("nan"), 2, "nan"),
    ],
)
def test_a_half_is_rounded_towards_plus(value: float, places: int, text: str) -> None:
    assert figure(value, places) == text


@pytest.mark.parametrize(
    ("value", "text"),
    [(0.25, "+0.250"), (-0.25, "-0.250"), (0.0, "+0.000"), (-0.0, "+0.000")],
)
def test_a_difference_has_its_sign(value: float, text: str) -> None:
    assert figure(value, 3, sign=True) == text


@pytest.mark.parametrize("won", range(33))
def test_a_difference_of_halves_adds_up_with_its_sides(won: int) -> None:
    baseline, run = 1.0, (won - 0.6) / 32
    shown = float(figure(baseline, 4)) + float(figure(run - baseline, 4, sign=True))
    assert figure(shown, 4) == figure(run, 4)
