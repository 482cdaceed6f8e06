"""How far an evaluation is, and the line that shows it to a person."""

from __future__ import annotations

import shutil
import sys
import threading
import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import TextIO

from reference_client.api.observation import Observation
from reference_client.generated.messages import Turn


@dataclass(frozen=True, slots=True)
class Progress:
    """What an evaluation has come to so far.

    episodes_scored: by every client of the run, abandoned ones included.
    mean: of their scores, in [0, 1]; None while there is none.
    waiting: what is waited for and what to do about it; None when all goes well.
    """

    run_id: str
    episodes_total: int
    episodes_scored: int
    mean: float | None
    waiting: str | None


@dataclass(frozen=True, slots=True, eq=False)
class TurnSnapshot:
    """One turn of a worker, for who looks on.

    observation: what the policy saw. turn: what came of its actions. think_s: how long
    the policy took; turn_s: how long the answer took, of it the server `turn.timing`.
    """

    worker_id: str
    observation: Observation
    turn: Turn
    think_s: float
    turn_s: float


class StatusBoard:
    """What workers tell the thread that watches them."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._changed = threading.Event()
        self._waiting: dict[str, str] = {}
        self._scored = False

    def waiting_reporter(self, source: str) -> Callable[[str | None], None]:
        """A function that notes what `source` waits for; None for nothing any more."""

        def report_waiting(what: str | None) -> None:
            with self._lock:
                if what is None:
                    self._waiting.pop(source, None)
                else:
                    self._waiting[source] = what
            self._changed.set()

        return report_waiting

    def on_scored(self) -> None:
        """An episode has a score."""
        self._scored = True
        self._changed.set()

    def on_attached(self, session_id: str) -> None:
        """A session is open; for who wants to know, which the watcher does not."""

    def on_turn(self, snapshot: TurnSnapshot) -> None:
        """A turn was answered; the same."""

    def wake(self) -> None:
        """Something else has happened: the watcher should look."""
        self._changed.set()

    def wait(self, timeout_s: float) -> bool:
        """Wait for news; returns whether there was any."""
        if not self._changed.wait(timeout_s):
            return False
        self._changed.clear()
        return True

    def take_scored(self) -> bool:
        """Whether an episode was scored since this was last asked."""
        on_scored, self._scored = self._scored, False
        return on_scored

    def waiting(self) -> str | None:
        """One line, for one of those who wait."""
        with self._lock:
            return next(
                (f"{source}: {what}" for source, what in self._waiting.items()), None
            )


class ProgressLine:
    """One line on a terminal, written anew at every report; a context that ends it."""

    def __init__(self, stream: TextIO) -> None:
        self._stream = stream
        self._began_at = time.monotonic()

    def __call__(self, progress: Progress) -> None:
        mean = "–" if progress.mean is None else f"{progress.mean:.3f}"
        minutes, seconds = divmod(int(time.monotonic() - self._began_at), 60)
        parts = [
            progress.run_id,
            f"{progress.episodes_scored}/{progress.episodes_total} episodes",
            f"mean {mean}",
            f"{minutes}:{seconds:02}",
        ]
        if progress.waiting:
            parts.append(progress.waiting)
        columns = shutil.get_terminal_size().columns
        line = "  ".join(parts)[: columns - 1]
        self._stream.write(f"\r\x1b[2K{line}")
        self._stream.flush()

    def end(self) -> None:
        self._stream.write("\n")
        self._stream.flush()


def terminal_progress_line() -> ProgressLine | None:
    """A line on the standard error if somebody looks at it."""
    return ProgressLine(sys.stderr) if sys.stderr.isatty() else None
