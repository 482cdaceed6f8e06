"""When two scores are the same: numbers to 1e-12, everything else exactly."""

from typing import Any

EXACTNESS = 1e-12


def assert_same(found: Any, expected: Any, at: str = "score") -> None:
    if isinstance(expected, dict):
        assert found.keys() == expected.keys(), at
        for key in expected:
            assert_same(found[key], expected[key], f"{at}.{key}")
    elif isinstance(expected, float) and found is not None:
        assert abs(found - expected) <= EXACTNESS, at
    else:
        assert found == expected, at
