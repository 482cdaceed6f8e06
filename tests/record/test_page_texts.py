"""Numbers as the pages write them for people."""

from __future__ import annotations

import math

import pytest

from reference_record.pages.page_templates import duration


@pytest.mark.parametrize(
    ("seconds", "text"),
    [
        (None, "–"),
        (math.inf, "–"),
        (0.0, "0 s"),
        (0.00123, "1.23 ms"),
        (0.4, "400 ms"),
        (1.0, "1 s"),
        (3.24, "3.2 s"),
        (12.6, "13 s"),
        (95.0, "1 min 35 s"),
        (7261.0, "2 h 1 min"),
        (90061.0, "1 d 1 h"),
    ],
)
def test_a_duration_is_short_and_never_loses_what_is_small(
    seconds: float | None, text: str
) -> None:
    assert duration(seconds) == text
