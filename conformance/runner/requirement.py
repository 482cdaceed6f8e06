"""The decorators of checks: the rule that a check judges, and how it runs."""

from collections.abc import Callable, Mapping
from typing import Any, TypeVar

import pytest

Check = TypeVar("Check", bound=Callable[..., None])


def requirement(*requirement_ids: str) -> Callable[[Check], Check]:
    """Mark a check with the rule that it judges.

    A scenario of several rules asserts none of them: the oracle judges its exchanges.
    """
    return pytest.mark.requirement(*requirement_ids)


def each_requirement(name: str, values: Mapping[str, Any]) -> Callable[[Check], Check]:
    """Mark a check with rules that differ in a value: it judges each with its own.

    name: the argument of the check that gets the value.
    """
    cases = [
        pytest.param(value, id=rule, marks=pytest.mark.requirement(rule))
        for rule, value in values.items()
    ]
    return pytest.mark.parametrize(name, cases)


def plays_histories(check: Check) -> Check:
    """Mark a check of generated histories, which a run with time left plays again."""
    marked: Check = pytest.mark.histories(check)
    return marked


def more_with_minutes(check: Check) -> Check:
    """Mark a check that tries more with `--minutes`."""
    marked: Check = pytest.mark.minutes(check)
    return marked


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
