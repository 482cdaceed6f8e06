"""How a check says which requirement it judges and how it wants to be run."""

from collections.abc import Callable
from typing import TypeVar

import pytest

Check = TypeVar("Check", bound=Callable[..., None])


def requirement(requirement_id: str) -> Callable[[Check], Check]:
    """Name the one requirement that a check judges."""
    return pytest.mark.requirement(requirement_id)


def background(check: Check) -> Check:
    """Mark a check that mostly waits; it runs in a thread beside all the others."""
    marked: Check = pytest.mark.background(check)
    return marked
