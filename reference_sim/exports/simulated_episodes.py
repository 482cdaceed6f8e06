"""Episodes of a record, simulated again, with what was seen after each step.

Every start of an episode is simulated; what is seen is given of the last one, which has
the result.
"""

from __future__ import annotations

import dataclasses
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from reference_record.broken import UnusableRecord
from reference_record.contents.statement import EpisodeLine
from reference_record.formats.names import MANIFEST
from reference_record.formats.opened_seeds import load_opened_seeds
from reference_record.texts.counted_text import counted
from reference_sim import benchmark_registry
from reference_sim.benchmark_registry import SimulatorConfig
from reference_sim.episode import Episode
from reference_sim.exports.job import Job
from reference_sim.exports.source import Source
from reference_sim.gymnasium import BadBenchmark
from reference_sim.interface import Action, Observation, Simulator
from reference_sim.replay import host_benchmarks
from reference_sim.replay.episode_replay import EpisodeReplay, replay_episode
from reference_sim.replay.record_replay import (
    WHO_HAS_SEEDS,
    replayable_lines,
    resolve,
)

FAILED = ("failure", "abandoned")


@dataclasses.dataclass(frozen=True, slots=True)
class SimulatedStep:
    """One executed action, with its reward and the state of success after it."""

    action: Action
    reward: float
    success: bool
    ended: bool


# The observation, and the step that led to it: None at step 0.
See = Callable[[Observation, SimulatedStep | None], None]


class Simulation:
    """The benchmark of a record on this machine, with one simulator.

    draws: where the benchmark has no cameras, take those that it is drawn with.
    Raises UnusableRecord where this machine has another one, or none.
    """

    def __init__(
        self, source: Source, job: Job, say: Callable[[str], None], *, draws: bool
    ) -> None:
        try:
            name = source.evaluation.benchmark.benchmark_id
            host_benchmarks.add(name, job.benchmarks, say)
        except BadBenchmark as error:
            raise UnusableRecord(str(error)) from error
        opened = load_opened_seeds(Path(job.seeds)) if job.seeds else None
        secret = Path(job.secret) if job.secret else None
        benchmark = resolve(
            source.evaluation, source.bundle.read(MANIFEST), opened, secret
        )
        self.manifest: Mapping[str, Any] = benchmark.manifest
        self._images: Mapping[str, Any] = benchmark.manifest["observation_space"][
            "images"
        ]
        self._source, self._benchmark, self._say = source, benchmark, say
        config = benchmark.config
        if draws and not self._images:
            config = self._with_cameras() or config
        self._config = _with_pictures(config, job)
        self._simulator: Simulator | None = None
        self.instruction = ""  # of the episode that was played last

    def _with_cameras(self) -> SimulatorConfig | None:
        name = self._source.evaluation.benchmark.benchmark_id
        drawing = benchmark_registry.drawn_as(name)
        if drawing is None:
            return None
        if reason := benchmark_registry.unavailable_reason(drawing.world.benchmark_id):
            raise UnusableRecord(f"{name} cannot be drawn here: {reason}")
        self._images = drawing.manifest["observation_space"]["images"]
        return drawing.world

    def lines(self, job: Job) -> list[EpisodeLine]:
        """The episodes of the job; with `failures`, those of them that failed."""
        lines = replayable_lines(self._source.path, self._benchmark, job.episodes)
        if job.failures:
            lines = [line for line in lines if line.outcome in FAILED]
        return lines

    def left_out(self, job: Job) -> list[dict[str, Any]]:
        """The wanted episodes that cannot be simulated, each with the reason."""
        facts = []
        for line in self._source.lines():
            if job.episodes is not None and line.index not in job.episodes:
                continue
            if job.failures and line.outcome not in FAILED:
                continue
            reason = self._benchmark.why_left_out(line)
            if reason is not None:
                facts.append(left_out_facts(line, reason))
        return facts

    def say_left_out(self, left_out: Sequence[Mapping[str, Any]], job: Job) -> None:
        """Say how many, and how to see those that are sealed."""
        if self._benchmark.secret_file is not None:
            self._say(f"sealed seeds: drawn with {self._benchmark.secret_file}")
        counts = Counter(facts["reason"] for facts in left_out)
        if sealed := counts["seed_sealed"]:
            self._say(f"{counted(sealed, 'episode')} left out: sealed seeds")
            self._say(WHO_HAS_SEEDS)
            self._say("then: the same command with --seeds FILE")
        if unrecorded := counts["not_recorded"]:
            self._say(f"{counted(unrecorded, 'episode')} left out: nothing is recorded")

    def cameras(self, task: str) -> list[str]:
        """Names of the pictures that there are in a task."""
        return [
            name
            for name, space in self._images.items()
            if task in space.get("tasks", [task])
        ]

    def play(self, line: EpisodeLine, see: See) -> EpisodeReplay:
        """Simulate an episode again. Raises what `see` raises."""
        if self._simulator is None:
            self._simulator = benchmark_registry.make(self._config)
        last = self._source.starts(line)
        watcher = _LastStart(self._simulator, last, see)
        path, plan = self._source.path, self._benchmark.plan_of(line.index)
        replay = replay_episode(
            path, self._simulator, plan, line.result, watcher=watcher
        )
        self.instruction = watcher.instruction
        return replay

    def close(self) -> None:
        if self._simulator is not None:
            self._simulator.close()


@contextmanager
def simulation(
    source: Source, job: Job, say: Callable[[str], None], *, draws: bool = False
) -> Iterator[Simulation]:
    made = Simulation(source, job, say, draws=draws)
    try:
        yield made
    finally:
        made.close()


class _LastStart:
    def __init__(self, simulator: Simulator, starts: int, see: See) -> None:
        self._simulator = simulator
        self._starts_left = starts
        self._see = see
        self._episode: Episode | None = None
        self.instruction = ""

    def started(self, attempt: int, episode: Episode) -> None:
        self._starts_left -= 1
        self._episode = episode
        self.instruction = episode.instruction
        if not self._starts_left:
            self._see(self._observe(), None)

    def stepped(self, action: Action, reward: float) -> None:
        if not self._starts_left and self._episode is not None:
            step = SimulatedStep(
                action, reward, self._episode.success, self._episode.ended
            )
            self._see(self._observe(), step)

    def _observe(self) -> Observation:
        try:
            return self._simulator.observe()
        except (Exception, SystemExit) as error:
            text = f"{type(error).__name__}: {error}"
            raise UnusableRecord(f"what was seen cannot be drawn: {text}") from error


def _with_pictures(config: SimulatorConfig, job: Job) -> SimulatorConfig:
    """The same simulator with the pictures of the job: nothing else changes."""
    settings = dict(config.settings)
    if job.size is not None:
        settings["width"], settings["height"] = job.size
    if job.cameras is not None:
        settings["cameras"] = job.cameras
    return dataclasses.replace(config, settings=settings)


def difference_text(line: EpisodeLine, replay: EpisodeReplay) -> str | None:
    """Where the replay left the record; None if it did not."""
    if replay.where is None:
        return None
    text = (
        f"episode {line.index} leaves the record at turn {replay.seq} of attempt "
        f"{replay.where.attempt}, step {replay.where.step}"
    )
    if replay.result == "outcome":
        return f"{text}; its result is the same"
    return (
        f"{text}, and its result is another{f': {replay.error}' * bool(replay.error)}"
    )


def left_out_facts(line: EpisodeLine, reason: str) -> dict[str, Any]:
    return {"episode": line.index, "outcome": line.outcome, "reason": reason}


def replay_facts(line: EpisodeLine, replay: EpisodeReplay) -> dict[str, Any]:
    """The result of the replay of an episode, as JSON for scripts."""
    where = replay.where and {"turn": replay.seq, "step": replay.where.step}
    return {
        "episode": line.index,
        "outcome": line.outcome,
        "replay": replay.result,
        "leaves_the_record_at": where,
    }
