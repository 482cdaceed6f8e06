"""Says what an evaluation waits for, again and again, so that no silence looks dead."""

from __future__ import annotations

import contextlib
import threading
import time
from collections.abc import Callable, Iterator

from reference_client.evaluation.status_board import StatusBoard

FIRST_S = 2.0
EVERY_S = 10.0
_LOOK_S = 0.25


@contextlib.contextmanager
def remind_of_waits(
    board: StatusBoard, say: Callable[[str], None], first_s: float = FIRST_S
) -> Iterator[None]:
    """Say it during the block: after `first_s`, then every ten seconds."""
    ended = threading.Event()
    thread = threading.Thread(
        target=_remind, args=(board, say, first_s, ended), daemon=True
    )
    thread.start()
    try:
        yield
    finally:
        ended.set()


def _remind(
    board: StatusBoard,
    say: Callable[[str], None],
    first_s: float,
    ended: threading.Event,
) -> None:
    due_at: float | None = None
    while not ended.wait(_LOOK_S):
        wait, now = board.current_wait(), time.monotonic()
        if wait is None:
            due_at = None
            continue
        due_at = due_at or now + first_s
        if now >= due_at:
            due_at = now + EVERY_S
            what, waited_s = wait
            say(f"Waiting for {waited_s:.0f} s: {what}")
