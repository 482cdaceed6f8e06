"""The state of an evaluation as workers report it, and the progress line of it."""

from __future__ import annotations

import re
import sys
import threading
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from typing import TextIO

from reference_client.api.action_layout import ClipCount
from reference_client.api.observation import Observation
from reference_client.api.policy import WireAction
from reference_client.errors import advises_takeover, as_sentence, text_of
from reference_client.generated.messages import Turn
from reference_client.printable_text import LenientStream, printable
from reference_client.protocol.silence import LostSession
from reference_client.protocol.worker_session import LeftEpisode
from reference_record.pages.run_page import estimate_pace
from reference_record.texts.figures import figure
from reference_record.texts.terminal_width import COLUMNS_UNKNOWN, columns_of


@dataclass(frozen=True, slots=True)
class Progress:
    """The progress of an evaluation.

    episodes_scored: by all clients of the run, including abandoned episodes.
    mean: of their scores, in [0, 1]; None before the first score.
    episodes_abandoned: those of the scored whose attempts were used up; they count 0.
    waiting: what a worker waits for, and what to do about it; None if none waits.
    at_once: episodes that are played at a time.
    """

    run_id: str
    episodes_total: int
    episodes_scored: int
    mean: float | None
    waiting: str | None
    episodes_abandoned: int = 0
    at_once: int = 1


@dataclass(frozen=True, slots=True, eq=False)
class TurnSnapshot:
    """One turn of a worker, for the live view.

    observation: input of the policy. turn: the response to its actions. think_s: time
    of the policy, seconds. turn_s: time of the request; `turn.timing` is the server's
    share of it. actions: the answer of the policy.
    """

    worker_id: str
    observation: Observation
    turn: Turn
    think_s: float
    turn_s: float
    actions: Sequence[WireAction] = ()


SLOW_S = 5  # a turn may take so long before it is shown


class StatusBoard:
    """Collects the reports of worker threads for the thread that watches them."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._changed = threading.Event()
        # Source → the thing that it waits for, and since when, in two ways.
        self._waiting: dict[str, tuple[str, float]] = {}
        self._begun: dict[str, tuple[str, float]] = {}
        self._scored = False
        self._notes: list[str] = []
        self._is_warned = False
        self._noted_texts: set[str] = set()
        self.clips = ClipCount()
        self.left: dict[str, LeftEpisode] = {}
        self.lost: list[LostSession] = []
        # Bounds of an episode, where they are known.
        self.max_attempts: int | None = None
        self.max_steps: int | None = None
        # The run that failed before its first turn is stopped, and deleted if possible.
        self.is_withdrawn = False
        self.counts_runs = False  # whether an open run has one of a few places

    def waiting_reporter(self, source: str) -> Callable[..., None]:
        """A function that records what `source` waits for; None when it continues.

        Its second argument is for how many seconds it has waited before.
        """

        def report_waiting(what: str | None, waited_s: float = 0.0) -> None:
            with self._lock:
                now = time.monotonic()
                _, since = self._waiting.get(source, ("", now - waited_s))
                if what is not None:  # it keeps its place: who waits first is shown
                    self._waiting[source] = what, since
                else:
                    self._waiting.pop(source, None)
                    if source in self._begun:  # from now on it waits for that alone
                        self._begun[source] = self._begun[source][0], now
            self._changed.set()

        return report_waiting

    def repeat_reporter(self, source: str) -> Callable[..., None]:
        """The same for a request to a policy server that is sent again.

        Its second argument is a warning about that, which is said once.
        """
        report_waiting = self.waiting_reporter(source)

        def report(waiting: str | None, warning: str = "") -> None:
            report_waiting(waiting)
            if warning:
                self.on_repeat(warning)

        return report

    def contact_reporter(self) -> Callable[..., None]:
        """The same for the first contact, whose repeats count nothing twice."""
        report_waiting = self.waiting_reporter("the first contact")
        return lambda waiting, _warning="": report_waiting(waiting)

    def on_repeat(self, warning: str) -> None:
        """A request is sent again, or an answer is odd; each warning is said once."""
        self._note_once(warning, warning)

    def begin(self, source: str, what: str) -> None:
        """`source` waits for `what` from now on; shown only if that takes long."""
        self._begun[source] = what, time.monotonic()

    def on_scored(self) -> None:
        """An episode has a score."""
        self._scored = True
        self._changed.set()

    def on_clips(self, count: ClipCount, warning: str | None) -> None:
        """An episode has ended; warning: what to say when most actions were clipped."""
        with self._lock:
            self.clips.add(count)
            if warning is not None and not self._is_warned:
                self._is_warned = True
                self._notes.append(warning)
        self._changed.set()

    def on_lost(self, lost: LostSession) -> None:
        """A worker has lost its session because it was silent for too long."""
        with self._lock:
            self.lost.append(lost)
            self._notes.append(f"warning: {lost.describe()}.")
        self._changed.set()

    def on_fault(self, episode_id: str, text: str) -> None:
        """The episode began again, and the text says why; each is said once.

        Texts that differ in numbers, as those of steps, are one.
        """
        note = (
            f"{episode_id} began again, at no cost to the policy: {as_sentence(text)}"
        )
        self._note_once(re.sub(r"\d+", "0", text), note)

    def _note_once(self, text: str, note: str) -> None:
        with self._lock:
            if text not in self._noted_texts:
                self._noted_texts.add(text)
                self._notes.append(f"warning: {note}")
        self._changed.set()

    def on_left(self, left: LeftEpisode) -> None:
        """A worker has left its session to the lease."""
        self.left[left.worker_id] = left

    def on_ended(self, worker_id: str) -> None:
        """The session of a worker has ended, also one that it had left."""
        self.left.pop(worker_id, None)

    def pop_notes(self) -> list[str]:
        """The warnings since the last call."""
        with self._lock:
            notes, self._notes = self._notes, []
        return notes

    def on_attached(self, session_id: str) -> None:
        """A session has begun. A hook for subclasses."""

    def on_turn(self, snapshot: TurnSnapshot) -> None:
        """A turn was answered. A hook for subclasses."""

    def end(self, source: str) -> None:
        """`source` waits for nothing any more."""
        self._begun.pop(source, None)

    def wake(self) -> None:
        """Make `wait` return."""
        self._changed.set()

    def wait(self, timeout_s: float) -> bool:
        """Wait for a change; returns False after the timeout."""
        if not self._changed.wait(timeout_s):
            return False
        self._changed.clear()
        return True

    def pop_scored(self) -> bool:
        """Whether an episode was scored since the last call."""
        was_scored, self._scored = self._scored, False
        return was_scored

    def waiting(self) -> str | None:
        """A source that waits, with the thing that it waits for; None if none waits."""
        wait = self.current_wait()
        return None if wait is None else wait[0]

    def waits(self) -> dict[str, str]:
        """The text of each wait of now, however short, by the name of its source."""
        begun = {
            name: f"waits for {what}" for name, (what, _) in [*self._begun.items()]
        }
        with self._lock:
            return begun | {name: what for name, (what, _) in self._waiting.items()}

    def takeover_helps(self, error: BaseException | None = None) -> bool:
        """Whether the evaluation goes on at once only with a takeover.

        An episode waits in a session that a worker has left, or a worker waits for the
        end of one. error: what has ended the evaluation.
        """
        with self._lock:
            texts = [what for what, _ in self._waiting.values()]
        said = "" if error is None else text_of(error)
        return bool(self.left) or any(map(advises_takeover, [*texts, said]))

    def current_wait(self) -> tuple[str, float] | None:
        """The same, and for how many seconds it has waited."""
        now = time.monotonic()
        with self._lock:
            reported = [*self._waiting.items()]
        for source, (what, since) in reported:
            return f"{source}: {what}", now - since
        for source, (what, since) in [*self._begun.items()]:
            if now - since >= SLOW_S:
                return f"{source}: waits for {what}", now - since
        return None


def describe_left(left: LeftEpisode, max_attempts: int | None = None) -> str:
    """`e0000 waits at step 41 until 14:05:00 UTC; attempt 1 of 3`."""
    until = datetime.fromisoformat(left.until).astimezone(UTC)
    allowed = "" if max_attempts is None else f" of {max_attempts}"
    is_over = until < datetime.now(UTC)
    verb, over = ("waited", ", which is over") if is_over else ("waits", "")
    return (
        f"{left.episode_id} {verb} at step {left.step} until "
        f"{until:%H:%M:%S} UTC{over}; "
        f"attempt {left.attempt}{allowed}"
    )


class Pace:
    """Estimates the time left, from the episodes scored since the first report."""

    def __init__(self) -> None:
        self._ends_s: list[float] = []
        self._scored: int | None = None

    def left(self, progress: Progress) -> str:
        """`~3:20 left`; empty while too few episodes were scored, and at the end."""
        now_s, scored = time.monotonic(), progress.episodes_scored
        if self._scored is not None:
            self._ends_s += [now_s] * (scored - self._scored)
        self._scored = scored
        rest = progress.episodes_total - scored
        left_s = estimate_pace(self._ends_s, now_s, rest, progress.at_once).left_s
        if left_s is None or rest < 1:
            return ""
        minutes, seconds = divmod(round(left_s), 60)
        hours, minutes = divmod(minutes, 60)
        clock = f"{hours}:{minutes:02}" if hours else f"{minutes}"
        return f"~{clock}:{seconds:02} left"


class ProgressLine:
    """One line on a terminal, rewritten at every report."""

    def __init__(self, stream: TextIO) -> None:
        self._stream = LenientStream(stream)
        self._began_at = time.monotonic()
        self._pace = Pace()

    def __call__(self, progress: Progress) -> None:
        mean = "–" if progress.mean is None else figure(progress.mean, 3)
        minutes, seconds = divmod(int(time.monotonic() - self._began_at), 60)
        parts = [
            progress.run_id,
            f"{progress.episodes_scored}/{progress.episodes_total} episodes",
            f"mean {mean}",
            f"{minutes}:{seconds:02}",
        ]
        left = self._pace.left(progress)
        if progress.waiting:
            parts.append(progress.waiting)
        elif left:
            parts.append(left)
        columns = columns_of(self._stream) or COLUMNS_UNKNOWN
        line = printable("  ".join(parts))[: columns - 1]
        self._stream.write(f"\r\x1b[2K{line}")
        self._stream.flush()

    def end(self) -> None:
        self._stream.write("\n")
        self._stream.flush()


def terminal_progress_line() -> ProgressLine | None:
    """A progress line on stderr, if that is a terminal."""
    is_terminal = LenientStream(sys.stderr).isatty()
    return ProgressLine(sys.stderr) if is_terminal else None
