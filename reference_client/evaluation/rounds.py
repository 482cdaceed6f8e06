"""Plays an existing run to its score, in rounds.

The calling thread watches; each worker runs in its own thread. A round ends when no
worker finds an episode to play. Then either the run is completed, or episodes have been
requeued by a session that ended, and another round begins. This module does not know
whether a worker plays in this process or in another.
"""

from __future__ import annotations

import sys
import threading
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from typing import Protocol

from proctor_client import Run, Score

from reference_client.errors import WORKER_DIED, ProctorError
from reference_client.evaluation.status_board import Progress, StatusBoard
from reference_client.policies.error_origin import policy_failure
from reference_client.protocol.control_client import ControlClient
from reference_client.protocol.retry_policy import Interrupted

POLL_INTERVAL_S = 0.5
# Time for workers to finish a request or `act` when the evaluation ends early.
STOP_TIMEOUT_S = 5.0

# Errors that end one worker while the others continue.
_WORKER_ENDING_CODES = frozenset({"session_superseded", WORKER_DIED})


class RunWorker(Protocol):
    """One worker of the run, in this process or in another."""

    worker_id: str

    def play(self) -> None:
        """Play until no episode is left; may be called again."""

    def request_stop(self, why: str = "") -> None:
        """Make `play` return soon. Does not wait. why: for who looks at the run."""

    def leave_session(self) -> None:
        """Give up the session, even while `play` is still running."""

    def end_session(self) -> None:
        """End the session after `play`, so that others play its episode at once."""


@dataclass
class EvaluationRounds:
    """Plays `run` with `run_workers` to its score.

    stop: set when the evaluation ends early. takeover: episodes held by sessions count
    as available. progress: called at every change. say: called with a line about each
    worker that ended early, and each warning. episodes: how many are played, from the
    first of the manifest; None is all.
    """

    run: Run
    run_workers: list[RunWorker]
    control_client: ControlClient
    board: StatusBoard
    stop: threading.Event
    takeover: bool
    progress: Callable[[Progress], None] | None
    say: Callable[[str], None]
    episodes: int | None = None
    _is_first_round: bool = True
    _failures: list[BaseException] = field(default_factory=list)
    _ended_workers: dict[str, ProctorError] = field(default_factory=dict)
    _so_far: Progress = field(init=False)

    def play_to_score(self) -> Score:
        """Raises RunFailed, RunStopped, ProctorError, and the failure of a worker."""
        self._so_far = Progress(
            self.run.run_id,
            self._at_most_wanted(self.run.progress.episodes_total),
            0,
            None,
            None,
        )
        self._report(scored=True)
        held = self.takeover
        while self._has_work(held=held):
            self._play_round()
            held = False
        score = self.control_client.score(self.run.run_id)
        self._show(score)
        return score

    def _has_work(self, *, held: bool) -> bool:
        """Waits as `wait_for_work`; False also when the wanted episodes are scored."""
        if self.control_client.has_scored(self.run.run_id, self.episodes):
            return False
        if self.episodes is not None and not self._is_first_round:
            # The rest is in play elsewhere, or is requeued by a session that ends.
            self.stop.wait(POLL_INTERVAL_S)
        self._is_first_round = False
        return self.control_client.wait_for_work(self.run.run_id, held=held)

    def _play_round(self) -> None:
        """Every worker plays until no episode is left.

        Raises the first failure of a worker.
        """
        threads = {
            threading.Thread(
                target=self._run_worker,
                args=[worker],
                name=worker.worker_id,
                daemon=True,
            ): worker
            for worker in self.run_workers
        }
        try:
            for thread in threads:
                thread.start()
            while any(thread.is_alive() for thread in threads):
                has_changed = self.board.wait(POLL_INTERVAL_S)
                if has_changed or self.board.waiting() != self._so_far.waiting:
                    self._report(scored=self.board.pop_scored())
                self._say_notes()
        finally:
            self._stop_workers(threads)
            if self.board.pop_scored():  # by the last turns
                self._report(scored=True)
        self._say_notes()
        if self._failures:
            raise self._failures[0]
        self.run_workers = [
            p for p in self.run_workers if p.worker_id not in self._ended_workers
        ]
        if not self.run_workers:
            raise next(iter(self._ended_workers.values()))

    def _say_notes(self) -> None:
        for note in self.board.pop_notes():
            self.say(note)

    def _run_worker(self, worker: RunWorker) -> None:
        try:
            worker.play()
        except Interrupted:
            pass
        except SystemExit as error:  # the program would end without a word
            self._fail(policy_failure(error))
        except BaseException as error:  # noqa: BLE001 - raised again by the watcher
            if isinstance(error, ProctorError) and error.code in _WORKER_ENDING_CODES:
                # Its episode returns to the queue, and another worker plays it.
                self._ended_workers[worker.worker_id] = error
                worker.end_session()
                self.say(error.detail)
            else:
                self._fail(error)
        finally:
            self.board.wake()

    def _fail(self, error: BaseException) -> None:
        self._failures.append(error)
        for run_worker in self.run_workers:
            run_worker.request_stop(_why_stopped(None))
        self.stop.set()

    def _stop_workers(self, threads: Mapping[threading.Thread, RunWorker]) -> None:
        """Stop the workers: none uses a session afterwards, though a thread may run."""
        if not any(thread.is_alive() for thread in threads):
            return
        why = _why_stopped(sys.exception())
        for worker in threads.values():
            worker.request_stop(why)
        self.stop.set()
        deadline = time.monotonic() + STOP_TIMEOUT_S
        for thread, worker in threads.items():
            if thread.is_alive():
                thread.join(max(0.0, deadline - time.monotonic()))
            if thread.is_alive():
                worker.leave_session()

    def _report(self, *, scored: bool) -> None:
        if self.progress is None:
            return
        if scored:
            try:
                self._show(self.control_client.try_score(self.run.run_id))
            except (ProctorError, Interrupted):
                pass  # reported next time; the workers decide which errors are fatal
            else:
                return
        self._so_far = replace(self._so_far, waiting=self.board.waiting())
        self.progress(self._so_far)

    def _at_most_wanted(self, episodes: int) -> int:
        return episodes if self.episodes is None else min(episodes, self.episodes)

    def _show(self, score: Score) -> None:
        counts = score.counts
        self._so_far = Progress(
            run_id=score.run_id,
            episodes_total=self._at_most_wanted(counts.total),
            episodes_scored=self._at_most_wanted(counts.total - counts.unscored),
            mean=score.mean,
            waiting=self.board.waiting(),
            episodes_abandoned=counts.abandoned,
            at_once=len(self.run_workers),
        )
        if self.progress is not None:
            self.progress(self._so_far)


def _why_stopped(error: BaseException | None) -> str:
    """Why workers leave their episodes, by what has ended the evaluation.

    None is the failure of another worker. The command names a signal that ended it.
    """
    if error is None:
        return "Its evaluation ended by a failure of another worker."
    if not isinstance(error, KeyboardInterrupt):
        return "Its evaluation ended early."
    by = f"the signal {error}" if error.args else "its user"
    return f"Its evaluation was interrupted by {by}."
