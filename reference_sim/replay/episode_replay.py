"""One recorded episode, simulated again: exact, the same outcome, or diverged.

Every attempt is played from its seed. After each turn the state digest is compared with
the recorded one; the result decides between `outcome` and `diverged`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from pathlib import Path

import msgspec

from reference_record.formats.bundle import open_bundle
from reference_record.formats.mcap_reader import McapReader
from reference_record.recording import AttemptEvent, Turn
from reference_record.replay_verdict import Divergence, Result
from reference_record.score import TOLERANCE
from reference_record.statement import EpisodeLine
from reference_sim.episode import Episode
from reference_sim.interface import Simulator
from reference_sim.process.recorder import state_digest

_ATTEMPT = msgspec.json.Decoder(AttemptEvent)
_TURN = msgspec.json.Decoder(Turn)


@dataclass(frozen=True, slots=True)
class EpisodeReplay:
    """where: of the first state digest that differs. error: why it ended early."""

    result: Result
    where: Divergence | None = None
    error: str | None = None


class ReplayPlan(msgspec.Struct, frozen=True):
    """An episode of a manifest, as the simulator plays it."""

    task: str
    seed: int
    split: str
    max_steps: int
    success_rule: str
    score_is_success: bool

    def begin(self, simulator: Simulator) -> Episode:
        """At step 0."""
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
    line: EpisodeLine,
    before_turn: Callable[[], object] = lambda: None,
) -> EpisodeReplay:
    """Simulate one recording of a verified record again. before_turn: is called."""
    bundle = open_bundle(path)
    assert line.recording is not None
    name = line.recording.path
    with bundle.open(name) as file:
        messages = McapReader(name, file, bundle.sizes[name]).messages()
        replayer = Replayer(simulator, lambda: plan.begin(simulator), line)
        return replayer.play(messages, before_turn)


class Replayer:
    """Plays the messages of one recording. begin: makes the episode at step 0."""

    def __init__(
        self, simulator: Simulator, begin: Callable[[], Episode], line: EpisodeLine
    ) -> None:
        self._simulator = simulator
        self._begin = begin
        self._line = line
        self._episode: Episode | None = None
        self._attempt = 0
        self._where: Divergence | None = None

    def play(
        self,
        messages: Iterable[tuple[str, memoryview]],
        before_turn: Callable[[], object] = lambda: None,
    ) -> EpisodeReplay:
        """Whatever the simulator raises is a divergence: it did not when recorded."""
        try:
            for topic, data in messages:
                if topic == "/attempt":
                    event = _ATTEMPT.decode(data)
                    if event.event == "started":
                        self._start(event)
                elif topic == "/turn":
                    before_turn()
                    self._execute(_TURN.decode(data))
        except Exception as error:  # noqa: BLE001 - a simulator may raise anything
            self._mark()
            text = f"{type(error).__name__}: {error}"
            return EpisodeReplay("diverged", self._where, text)
        if not self._has_same_result():
            self._mark()
            return EpisodeReplay("diverged", self._where)
        return EpisodeReplay("outcome" if self._where else "exact", self._where)

    def _start(self, event: AttemptEvent) -> None:
        self._attempt = event.attempt
        self._episode = self._begin()
        self._compare(event.state_digest)

    def _execute(self, turn: Turn) -> None:
        assert self._episode is not None  # a verified recording starts first
        executed = len(list(self._episode.play(turn.actions)))
        if executed != turn.steps:
            self._mark()
        self._compare(turn.state_digest)

    def _compare(self, recorded: str | None) -> None:
        if state_digest(self._simulator) != recorded:
            self._mark()

    def _mark(self) -> None:
        """Keep where the first difference was seen."""
        if self._where is None:
            steps = self._episode.steps if self._episode else 0
            self._where = Divergence(self._line.index, self._attempt, steps)

    def _has_same_result(self) -> bool:
        """An abandoned episode has its result from its attempts, not from a state."""
        line, episode = self._line, self._episode
        if line.outcome in ("abandoned", None):
            return True
        assert line.score is not None
        return (
            episode is not None
            and episode.success == line.success
            and abs(episode.score - line.score) <= TOLERANCE
            and episode.steps == line.steps
        )
