"""Where a score differs from the one that the kit expects."""

from fractions import Fraction
from typing import Any

from conformance.oracle.expected_score import is_close


def differences(stated: Any, expected: Any, at: str = "score") -> list[str]:
    """Where an answer is not what the kit expects, number by number."""
    if isinstance(expected, dict):
        if stated.keys() != expected.keys():
            return [at]
        pairs = [(stated[k], expected[k], f"{at}.{k}") for k in expected]
        return [found for pair in pairs for found in differences(*pair)]
    same = (
        is_close(stated, expected)
        if isinstance(expected, Fraction | float)
        else stated == expected
    )
    return [] if same else [at]
