"""The text of a number, the same in every place that shows it.

A half is rounded away from zero: 0.91875 is 0.9188, and -0.91875 is -0.9188. The format
of Python looks at the binary fraction, in which 0.91875 is a little less than the half.
"""

from __future__ import annotations

from decimal import ROUND_HALF_UP, Decimal

# Further digits are the noise of sums of binary fractions.
_EXACT_DIGITS = 12
_LARGEST = 1e12


def figure(value: float, places: int, *, sign: bool = False) -> str:
    """The value with so many decimal places; `sign`: with a plus, too."""
    mark = "+" if sign else ""
    if not abs(value) < _LARGEST:
        return f"{value:{mark}.{places}f}"
    rounded = _exact(value).quantize(Decimal(1).scaleb(-places), ROUND_HALF_UP)
    return f"{rounded + 0:{mark}f}"  # nothing is below zero


def difference_figure(value: float, baseline: float, places: int) -> str:
    """The value minus the baseline, of what they are and not of their figures.

    A half goes where the difference adds up with the figures of both: 0.8125 minus 0.5
    is +0.313 beside 0.813, and 0.9375 minus 1 is -0.062 beside 0.938.
    """
    exact = _exact(value - baseline)
    shown = Decimal(figure(value, places)) - Decimal(figure(baseline, places))
    if abs(exact - shown) > Decimal("0.5").scaleb(-places):
        return figure(float(exact), places, sign=True)
    return f"{shown + 0:+f}"


def _exact(value: float) -> Decimal:
    return Decimal(f"{value:.{_EXACT_DIGITS}f}")
