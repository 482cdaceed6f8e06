"""The text of a number, the same in every place that shows it.

A half is rounded up, towards plus: 0.91875 is 0.9188, and its difference from 1 is
-0.0812, so that the two add up. Python's own format looks at the binary fraction, in
which 0.91875 is a little less than the half.
"""

from __future__ import annotations

from decimal import ROUND_HALF_DOWN, ROUND_HALF_UP, Decimal

# Further digits are the noise of sums of binary fractions.
_EXACT_DIGITS = 12
_LARGEST = 1e12


def figure(value: float, places: int, *, sign: bool = False) -> str:
    """The value with so many decimal places; `sign`: with a plus, too."""
    mark = "+" if sign else ""
    if not abs(value) < _LARGEST:
        return f"{value:{mark}.{places}f}"
    exact = Decimal(f"{value:.{_EXACT_DIGITS}f}")
    rounding = ROUND_HALF_UP if exact > 0 else ROUND_HALF_DOWN
    rounded = exact.quantize(Decimal(1).scaleb(-places), rounding)
    return f"{rounded + 0:{mark}f}"  # nothing is below zero
