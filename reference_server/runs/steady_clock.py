"""Wall time that runs evenly while the process lives, however the clock is set.

It is for deadlines that are stored and so outlive the process. People are shown the
time of the system's clock instead.
"""

from __future__ import annotations

import time

_STARTED_AT = time.time() - time.monotonic()


def now_wall() -> float:
    """Seconds since the epoch, by the clock as it was when the process began."""
    return _STARTED_AT + time.monotonic()
