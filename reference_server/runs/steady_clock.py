"""Wall time that runs evenly while the process lives, however the clock is set.

For deadlines that are stored and so outlive the process. What is shown to people is the
time of the clock.
"""

from __future__ import annotations

import time

_STARTED_AT = time.time() - time.monotonic()


def now_wall() -> float:
    """Seconds since the epoch, by the clock as it was when the process began."""
    return _STARTED_AT + time.monotonic()
