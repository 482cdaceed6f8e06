"""Waiting for something that another process or thread does."""

import time
from collections.abc import Callable

from tests.support.servers import TIMEOUT_S


def wait_until(
    condition: Callable[[], object], what: str, timeout_s: float = TIMEOUT_S
) -> None:
    """Polls until the condition holds; fails with `what` after the time limit."""
    deadline = time.monotonic() + timeout_s
    while not condition():
        assert time.monotonic() < deadline, f"waited in vain until {what}"
        time.sleep(0.01)
