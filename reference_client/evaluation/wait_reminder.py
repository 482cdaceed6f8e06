"""Says what an evaluation waits for, again and again, so that no silence looks dead."""

from __future__ import annotations

import contextlib
import threading
import time
from collections.abc import Callable, Iterator

from reference_client.errors import first_sentence
from reference_client.evaluation.status_board import StatusBoard
from reference_record.this_machine import start_if_possible

FIRST_S = 3.0
EVERY_S = 10.0  # the first reminders; a long wait is said at growing intervals
RARELY_S = 600.0
_LOOK_S = 0.25


@contextlib.contextmanager
def remind_of_waits(
    board: StatusBoard,
    say: Callable[[str], None],
    first_s: Callable[[], float] = lambda: FIRST_S,
) -> Iterator[None]:
    """Say it during the block: after `first_s`, then ever more rarely.

    first_s: is asked at the beginning of each wait.
    """
    ended = threading.Event()
    thread = threading.Thread(
        target=_remind, args=(board, say, first_s, ended), daemon=True
    )
    start_if_possible(thread)
    try:
        yield
    finally:
        ended.set()


def _remind(
    board: StatusBoard,
    say: Callable[[str], None],
    first_s: Callable[[], float],
    ended: threading.Event,
) -> None:
    due_at: float | None = None
    last: str | None = None
    pause_s = EVERY_S
    while not ended.wait(_LOOK_S):
        wait, now = board.current_wait(), time.monotonic()
        if wait is None:
            due_at = None
            continue
        what, waited_s = wait
        about = first_sentence(what)
        if due_at is None or about != last:
            due_at, pause_s, last = now + first_s(), EVERY_S, about
        if now >= due_at:
            due_at, pause_s = now + pause_s, min(2 * pause_s, RARELY_S)
            say(f"Waiting for {waited_s:.0f} s: {what}")
