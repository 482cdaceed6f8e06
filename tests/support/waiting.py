"""Waiting for something that another process or thread does."""

import asyncio
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


async def wait_in_loop(
    condition: Callable[[], object], timeout_s: float = TIMEOUT_S
) -> None:
    """As `wait_until`, while the event loop of the test goes on."""
    deadline = time.monotonic() + timeout_s
    while not condition():
        assert time.monotonic() < deadline, "did not come true in time"
        await asyncio.sleep(0.01)
