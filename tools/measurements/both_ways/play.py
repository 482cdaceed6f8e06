"""One policy by the protocol and in a loop of its own: every episode is compared."""

from __future__ import annotations

import hashlib
import subprocess
import sys
import tempfile
import time
import tomllib
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from itertools import pairwise
from pathlib import Path
from statistics import median
from typing import Any, NamedTuple

import numpy as np
from proctor_client import ControlApi, EpisodeResult

from reference_client import Observation, evaluate
from reference_client.protocol.connection import Connection
from tools.measurements.both_ways.compared_benchmark import (
    ComparedBenchmark,
    Expert,
    Parts,
)

TOKEN = "both"  # noqa: S105 - of a server that lives as long as this does
ROOT = Path(__file__).resolve().parents[3]


class BothWaysOutcome(NamedTuple):
    """The figures of an episode that must agree to the last bit.

    observations: SHA-256 of all that the policy saw, in order, pictures included.
    """

    steps: int
    success: bool
    total_reward: float
    observations: str


class Sight:
    """The observations of a policy in one episode, as a digest, and their times."""

    def __init__(self) -> None:
        self._digest = hashlib.sha256()
        self._times_s: list[float] = []

    def note(self, seen: Parts) -> None:
        for name in sorted(seen):
            part = seen[name]
            self._digest.update(f"{name} {part.dtype} {part.shape} ".encode())
            self._digest.update(part.tobytes())
        self._times_s.append(time.perf_counter())

    @property
    def digest(self) -> str:
        return self._digest.hexdigest()

    @property
    def turns_s(self) -> list[float]:
        """How long each turn took, from one observation to the next; no reset."""
        return [b - a for a, b in pairwise(self._times_s)]


class Played(NamedTuple):
    """Outcomes by task and seed, and how fast they came."""

    outcomes: dict[tuple[str, int], BothWaysOutcome]
    turns_per_s: float


class ExpertPolicy:
    """An expert as a policy of the client. sights: of its episodes, by their ids."""

    def __init__(self, compared: ComparedBenchmark, sights: dict[str, Sight]) -> None:
        self._subject, self._sights = compared, sights

    def reset(self, instruction: str) -> None:
        self._expert = self._subject.expert(instruction)
        self._sight = Sight()

    def act(self, observation: Observation) -> dict[str, Any]:
        seen: Parts = {
            **{n: np.array(v, np.float64) for n, v in observation.state.items()},
            **observation.images,
        }
        self._sight.note(seen)
        self._sights[observation.episode_id] = self._sight
        return {"action": self._expert.act(seen)}


def play_directly(
    compared: ComparedBenchmark, episodes: Sequence[tuple[str, int]], max_steps: int
) -> Played:
    """Each episode until success or the last step."""
    outcomes, sights = {}, []
    for task, seed in episodes:
        episode, sight = compared.begin(task, seed), Sight()
        expert = compared.expert(task)
        outcome = _play(episode, expert, sight, max_steps)
        outcomes[task, seed] = outcome
        sights.append(sight)
    return Played(outcomes, _speed(sights))


def _play(
    episode: Any, expert: Expert, sight: Sight, max_steps: int
) -> BothWaysOutcome:
    total, success, step = 0.0, False, 0
    try:
        while step < max_steps and not success:
            sight.note(episode.observed)
            reward, success = episode.step(expert.act(episode.observed))
            total += reward
            step += 1
    finally:
        episode.close()
    return BothWaysOutcome(step, success, total, sight.digest)


def play_by_protocol(
    compared: ComparedBenchmark, episodes: int | None = None
) -> Played:
    """The split on a server of its own. episodes: only the first ones."""
    sights: dict[str, Sight] = {}
    with _serving(compared.file) as url:
        score = evaluate(
            lambda: ExpertPolicy(compared, sights),
            url=url,
            token=TOKEN,
            benchmark=compared.benchmark_id or compared.file.stem,
            splits=[compared.split],
            name="expert",
            episodes=episodes,
            workers=compared.workers,
            dry_turn=False,
        )
        with Connection(url, TOKEN, requests=1) as connection:
            outcomes = dict(_outcomes(connection.control, score.run_id, sights))
    return Played(outcomes, _speed(list(sights.values())))


def _outcomes(
    control: ControlApi, run_id: str, sights: dict[str, Sight]
) -> Iterator[tuple[tuple[str, int], BothWaysOutcome]]:
    """The outcome of every episode with a result, by task and seed."""
    cursor = None
    while True:
        page = control.list_episodes(run_id, cursor=cursor)
        for listed in page.episodes:
            if (result := listed.result) is not None and result.seed is not None:
                sight = sights[listed.episode_id]
                yield (result.task, result.seed), _outcome_of(result, sight)
        cursor = page.next_cursor
        if cursor is None:
            return


def _outcome_of(result: EpisodeResult, sight: Sight) -> BothWaysOutcome:
    assert result.total_reward is not None
    success = result.outcome.value == "success"
    reward = float(result.total_reward)
    return BothWaysOutcome(result.steps, success, reward, sight.digest)


def _speed(sights: Sequence[Sight]) -> float:
    """By the median: in the first turns, some packages are still being compiled."""
    return 1 / median(turn_s for sight in sights for turn_s in sight.turns_s)


@contextmanager
def _serving(file: Path) -> Iterator[str]:
    """The URL of a server with this benchmark."""
    with tempfile.TemporaryDirectory() as scratch:
        server = subprocess.Popen(
            [
                *(sys.executable, "-m", "reference_server", "--port", "0"),
                *("--database", f"{scratch}/proctor.sqlite"),
                *("--tokens", f"both:read+run:{TOKEN}", "--benchmarks", str(file)),
            ],
            cwd=ROOT,
            stdout=subprocess.PIPE,
            text=True,
        )
        try:
            assert server.stdout is not None
            yield server.stdout.readline().split()[-1]
        finally:
            server.terminate()
            server.communicate()  # closes the pipe as well


def max_steps_of(compared: ComparedBenchmark) -> int:
    """The step limit in the benchmark file."""
    limit: int = tomllib.loads(compared.file.read_text())["max_steps"]
    return limit


def differing(direct: Played, served: Played) -> list[tuple[str, int]]:
    """The episodes that were not played both ways alike."""
    keys = direct.outcomes.keys() | served.outcomes.keys()
    one, other = direct.outcomes, served.outcomes
    return sorted(key for key in keys if one.get(key) != other.get(key))
