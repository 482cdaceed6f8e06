"""A run that is there, until it has its score.

The thread that calls watches; each player plays in a thread of its own. A round lasts
until every player has found nothing more to play. Then the run says whether it is
completed, or whether there is something again: what a dead session has left. This file
does not know what a player is: a worker here, or a process that plays elsewhere.
"""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from typing import Protocol

from proctor_client import Run, Score

from reference_client.api.errors import WORKER_DIED, ProctorError
from reference_client.evaluation.status_board import Board, Progress
from reference_client.protocol.control_client import Desk
from reference_client.protocol.retry_policy import Interrupted

WATCH_S = 0.5
# Players get this long to finish a request or a thought when the evaluation ends early.
FAREWELL_S = 5.0

# One player's end, which leaves the others playing.
_RETIRES = frozenset({"session_superseded", WORKER_DIED})


class Player(Protocol):
    """One worker of the run, wherever it plays."""

    worker_id: str

    def play(self) -> None:
        """Returns when no episode is left for it; may be called again."""

    def part(self) -> None:
        """The evaluation is ending: `play` should return soon. Does not wait."""

    def let_go(self) -> None:
        """Leave no session behind, whatever `play` still does."""


@dataclass
class Evaluation:
    """Plays `run` with `team` to its score.

    stop: set when it ends early. takeover: episodes that sessions hold are to be had.
    progress: hears of the score. say: takes a line about what has gone wrong.
    """

    run: Run
    team: list[Player]
    desk: Desk
    board: Board
    stop: threading.Event
    takeover: bool
    progress: Callable[[Progress], None] | None
    say: Callable[[str], None]
    _failures: list[BaseException] = field(default_factory=list)
    _retired: dict[str, ProctorError] = field(default_factory=dict)
    _so_far: Progress = field(init=False)

    def score(self) -> Score:
        """Raises RunFailed, RunStopped, ProctorError, and what a player fails with."""
        self._so_far = Progress(
            self.run.run_id, self.run.progress.episodes_total, 0, None, None
        )
        self._report(scored=True)
        held = self.takeover
        while self.desk.work_is_left(self.run.run_id, held=held):
            self._play_round()
            held = False
        score = self.desk.score(self.run.run_id)
        self._show(score)
        return score

    def _play_round(self) -> None:
        """Every player plays until it finds nothing more.

        Raises what the first of them failed with.
        """
        threads = {
            threading.Thread(
                target=self._work, args=[player], name=player.worker_id, daemon=True
            ): player
            for player in self.team
        }
        try:
            for thread in threads:
                thread.start()
            while any(thread.is_alive() for thread in threads):
                if self.board.wait(WATCH_S):
                    self._report(scored=self.board.take_scored())
        finally:
            self._part(threads)
        if self._failures:
            raise self._failures[0]
        self.team = [p for p in self.team if p.worker_id not in self._retired]
        if not self.team:
            raise next(iter(self._retired.values()))

    def _work(self, player: Player) -> None:
        try:
            player.play()
        except Interrupted:
            pass
        except BaseException as error:  # noqa: BLE001 - raised again by the watcher
            if isinstance(error, ProctorError) and error.code in _RETIRES:
                # What it leaves is for the others.
                self._retired[player.worker_id] = error
                self.say(error.detail)
            else:
                self._failures.append(error)
                self.stop.set()
                for other in self.team:
                    other.part()
        finally:
            self.board.stir()

    def _part(self, threads: Mapping[threading.Thread, Player]) -> None:
        """After this no player has a session, whatever its thread still does."""
        if not any(thread.is_alive() for thread in threads):
            return
        self.stop.set()
        for player in threads.values():
            player.part()
        deadline = time.monotonic() + FAREWELL_S
        for thread, player in threads.items():
            if thread.is_alive():
                thread.join(max(0.0, deadline - time.monotonic()))
            if thread.is_alive():
                player.let_go()

    def _report(self, *, scored: bool) -> None:
        if self.progress is None:
            return
        if scored:
            try:
                self._show(self.desk.glance(self.run.run_id))
            except (ProctorError, Interrupted):
                pass  # it is told next time; workers know better what to bear
            else:
                return
        self._so_far = replace(self._so_far, waiting=self.board.waiting())
        self.progress(self._so_far)

    def _show(self, score: Score) -> None:
        counts = score.counts
        self._so_far = Progress(
            run_id=score.run_id,
            episodes_total=counts.total,
            episodes_scored=counts.total - counts.unscored,
            mean=score.mean,
            waiting=self.board.waiting(),
        )
        if self.progress is not None:
            self.progress(self._so_far)
