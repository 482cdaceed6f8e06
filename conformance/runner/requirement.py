"""The decorators of checks: the rule that a check judges, and how it runs."""

from collections.abc import Callable
from typing import TypeVar

import pytest

Check = TypeVar("Check", bound=Callable[..., None])


def requirement(*requirement_ids: str) -> Callable[[Check], Check]:
    """Mark a check with the rule that it judges.

    A scenario of several rules asserts none of them: the oracle judges its exchanges.
    """
    return pytest.mark.requirement(*requirement_ids)


def background(check: Check) -> Check:
    """Mark a check that mostly waits; it runs in a thread beside the other checks."""
    marked: Check = pytest.mark.background(check)
    return marked


def on_long_run(check: Check) -> Check:
    """Mark a check that reads the long run; one process plays it for all of them.

    `--quick` leaves such checks out, as it does those that wait or kill the server.
    """
    marked: Check = pytest.mark.long_run(pytest.mark.one_process("long run")(check))
    return marked


def from_schema(check: Check) -> Check:
    """Mark a check whose requests schemathesis makes; one process loads the library."""
    marked: Check = pytest.mark.one_process("schema")(check)
    return marked
