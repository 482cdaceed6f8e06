"""A reason is shown where it explains how an attempt ended."""

from typing import Any

import pytest

from reference_record.texts.left_reason import left_reason


@pytest.mark.parametrize(
    ("attempt", "outcome", "is_shown"),
    [
        (2, None, True),
        (2, "abandoned", True),
        (2, "success", False),
        (3, "failure", True),
    ],
    ids=["waits", "abandoned", "played on", "played again"],
)
def test_a_reason_explains_no_result(
    attempt: int, outcome: str | None, is_shown: bool
) -> None:
    """The episode was left in attempt 2."""
    episode: dict[str, Any] = {"last_left": {"attempt": 2, "reason": "Ctrl-C"}}
    if outcome is not None:
        episode["result"] = {"outcome": outcome, "attempt": attempt}
    assert left_reason(episode) == ("Ctrl-C" if is_shown else None)
    assert left_reason({**episode, "last_left": None}) is None
