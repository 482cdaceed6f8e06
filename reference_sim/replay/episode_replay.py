"""One recorded episode, simulated again: exact, the same outcome, or diverged.

Every attempt is played from its seed. After each turn the state digest is compared with
the recorded one; the result decides between `outcome` and `diverged`. A Watcher
sees every step, to draw or to copy it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Protocol

import msgspec

from reference_record.contents.replay_verdict import Divergence, Result
from reference_record.contents.score import TOLERANCE
from reference_record.contents.statement import RecordedResult
from reference_record.formats.bundle import open_bundle
from reference_record.recordings.mcap_reader import read_messages
from reference_record.recordings.recording import AttemptEvent, Turn
from reference_sim.episode import Episode
from reference_sim.interface import Action, Simulator
from reference_sim.process.recorder import state_digest

_ATTEMPT = msgspec.json.Decoder(AttemptEvent)
_TURN = msgspec.json.Decoder(Turn)


@dataclass(frozen=True, slots=True)
class EpisodeReplay:
    """The result of a replay.

    where, seq: the step and the turn of the first state digest that differs (seq 0: the
    start of the attempt). error: why the replay ended early.
    """

    result: Result
    where: Divergence | None = None
    error: str | None = None
    seq: int | None = None


class Watcher(Protocol):
    """Watches the replay; each method is called after its event."""

    def started(self, attempt: int, episode: Episode) -> None:
        """The attempt is at step 0, also again after a fault."""

    def stepped(self, action: Action, reward: float) -> None:
        """The action was executed; the `episode` of the last start has its effects."""


class _Unwatched:
    def started(self, attempt: int, episode: Episode) -> None:
        pass

    def stepped(self, action: Action, reward: float) -> None:
        pass


class _WatcherFailed(Exception):
    """The watcher raised `error`, which must not count as a divergence."""

    def __init__(self, error: Exception) -> None:
        self.error = error


class ReplayPlan(msgspec.Struct, frozen=True):
    """An episode of a manifest, as the simulator plays it."""

    task: str
    seed: int
    split: str
    max_steps: int
    success_rule: str
    score_is_success: bool

    def begin(self, simulator: Simulator) -> Episode:
        """The episode at step 0, in a simulator that is built."""
        return Episode(
            simulator,
            self.task,
            self.seed,
            split=self.split,
            max_steps=self.max_steps,
            success_rule=self.success_rule,
            score_is_success=self.score_is_success,
        )


def replay_episode(
    path: Path,
    simulator: Simulator,
    plan: ReplayPlan,
    recorded: RecordedResult,
    before_turn: Callable[[], object] = lambda: None,
    *,
    watcher: Watcher | None = None,
) -> EpisodeReplay:
    """Simulate one recording of a verified record again. before_turn: is called.

    Raises the errors of the watcher.
    """
    messages = read_messages(open_bundle(path), recorded.recording)
    replayer = Replayer(simulator, lambda: plan.begin(simulator), recorded, watcher)
    return replayer.play(messages, before_turn)


class Replayer:
    """Plays the messages of one recording. begin: makes the episode at step 0."""

    def __init__(
        self,
        simulator: Simulator,
        begin: Callable[[], Episode],
        recorded: RecordedResult,
        watcher: Watcher | None = None,
    ) -> None:
        self._simulator = simulator
        self._begin = begin
        self._recorded = recorded
        self._watcher: Watcher = watcher or _Unwatched()
        self._seq = 0
        self._marked_seq: int | None = None
        self._episode: Episode | None = None
        self._attempt = 0
        self._where: Divergence | None = None

    def play(
        self,
        messages: Iterable[tuple[str, memoryview]],
        before_turn: Callable[[], object] = lambda: None,
    ) -> EpisodeReplay:
        """Play the messages of a recording, and say where the simulator leaves it.

        An error of the simulator is a divergence, because none was raised when the
        episode was recorded. An error of the watcher is raised.
        """
        try:
            for topic, data in messages:
                if topic == "/attempt":
                    event = _ATTEMPT.decode(data)
                    if event.event == "started":
                        self._start(event)
                elif topic == "/turn":
                    before_turn()
                    self._execute(_TURN.decode(data))
        except _WatcherFailed as failed:
            raise failed.error from None
        except KeyboardInterrupt:  # of the person at a terminal
            raise
        except BaseException as error:  # noqa: BLE001 - also what ends a program
            self._mark()
            text = f"{type(error).__name__}: {error}"
            return EpisodeReplay("diverged", self._where, text, self._marked_seq)
        result: Result = "outcome" if self._where else "exact"
        if not self._has_same_result():
            self._mark()
            result = "diverged"
        return EpisodeReplay(result, self._where, seq=self._marked_seq)

    def _start(self, event: AttemptEvent) -> None:
        self._attempt, self._seq = event.attempt, 0
        self._episode = self._begin()
        self._compare(event.state_digest)
        self._show(self._watcher.started, event.attempt, self._episode)

    def _execute(self, turn: Turn) -> None:
        assert self._episode is not None  # a verified recording starts first
        self._seq, executed = turn.seq, 0
        for reward in self._episode.play(turn.actions):
            self._show(self._watcher.stepped, turn.actions[executed], reward)
            executed += 1
        if executed != turn.steps:
            self._mark()
        self._compare(turn.state_digest)

    @staticmethod
    def _show(method: Callable[..., None], *what: object) -> None:
        try:
            method(*what)
        except Exception as error:
            raise _WatcherFailed(error) from error

    def _compare(self, recorded: str | None) -> None:
        if state_digest(self._simulator) != recorded:
            self._mark()

    def _mark(self) -> None:
        """Keep where the first difference was seen."""
        if self._where is None:
            steps = self._episode.steps if self._episode else 0
            self._where = Divergence(self._recorded.index, self._attempt, steps)
            self._marked_seq = self._seq

    def _has_same_result(self) -> bool:
        """An abandoned episode has its result from its attempts, not from a state."""
        recorded, episode = self._recorded, self._episode
        if recorded.outcome in ("abandoned", None):
            return True
        assert recorded.score is not None
        return (
            episode is not None
            and episode.success == recorded.success
            and abs(episode.score - recorded.score) <= TOLERANCE
            and episode.steps == recorded.steps
        )
