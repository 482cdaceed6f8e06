"""The two sides compared: a benchmark file, and its environment without a server."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, NamedTuple, Protocol, TypeAlias

import numpy.typing as npt

# Parts of an observation, by name: vectors are float64 (n,), pictures uint8 (h, w, 3).
Parts: TypeAlias = Mapping[str, npt.NDArray[Any]]

EXAMPLES = Path(__file__).resolve().parents[3] / "examples" / "benchmarks"


class Expert(Protocol):
    """A policy for one episode. It follows what it sees, so that a difference in any
    step leads elsewhere."""

    def act(self, seen: Parts) -> npt.NDArray[Any]:
        """The action, (n,)."""


class DirectEpisode(Protocol):
    """An episode in an environment made for it alone, without what the benchmark file
    names: that is what it is compared with."""

    @property
    def observed(self) -> Parts:
        """The current observation."""

    def step(self, action: npt.NDArray[Any]) -> tuple[float, bool]:
        """Reward and success; `observed` is then the next observation."""

    def close(self) -> None: ...


class ComparedBenchmark(NamedTuple):
    """file: of the benchmark. begin: an episode of a task and a seed.

    expert: for a task, which is named or given by its instruction. benchmark_id: where
    it is not the name of the file. split: which is played, with so many workers.
    """

    file: Path
    begin: Callable[[str, int], DirectEpisode]
    expert: Callable[[str], Expert]
    benchmark_id: str = ""
    split: str = "practice"
    workers: int = 1
