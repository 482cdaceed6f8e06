"""The definition of a benchmark: its manifest, and how its simulator is made.

A manifest contains everything that can change a score; its members are those of the
specification's schema Benchmark. A module that defines benchmarks has a mapping
`BENCHMARKS`, id → BenchmarkDefinition, and imports no simulator;
benchmark_registry.py collects them.
"""

from __future__ import annotations

import importlib.metadata
import importlib.util
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache
from typing import Any

from reference_sim.interface import Simulator
from reference_sim.mujoco import rendering
from reference_sim.ray_resources import check_resources

Json = dict[str, Any]


SEED_MAX = 2**53 - 1  # every language has it exactly


def _always_available() -> None:
    return None


def _no_files() -> Sequence[str]:
    return ()


@dataclass(frozen=True, slots=True)
class BenchmarkDefinition:
    """A benchmark, as the registry uses it.

    describe: (options, max_chunk) → manifest: the schema Benchmark without
        `manifest_sha256` and `unavailable_reason`, with one more member, `episodes`: a
        list of {task, split, seed}.
    settings: chosen images → SimulatorConfig.settings, JSON-able.
    make: SimulatorConfig.settings → the simulator, in the process that runs it.
    unavailable: why the benchmark cannot be played on this machine, and the remedy, in
        one line; None if it can.
    changed_files: the benchmark's own files that are not any more as they were when it
        was checked. No run is accepted then. No episode begins either, unless the file
        is the one that describes the benchmark, which no simulator process reads.
    seed_block, seed_max: how a host may draw other seeds for the splits that
        `sealed_splits` of the manifest names: seeds belong together in blocks of so
        many, and none is larger.
    ray_resources: what one simulator takes of a machine of a Ray cluster; empty if the
        benchmark declares nothing. No part of the manifest: no score depends on it.
    """

    describe: Callable[[Mapping[str, Any], int], Json]
    settings: Callable[[Mapping[str, Any]], Json]
    make: Callable[[Mapping[str, Any]], Simulator]
    has_options: bool = False
    unavailable: Callable[[], str | None] = _always_available
    changed_files: Callable[[], Sequence[str]] = _no_files
    seed_block: int = 1
    seed_max: int = SEED_MAX
    ray_resources: Mapping[str, float] = field(default_factory=dict)

    def __post_init__(self) -> None:
        if self.ray_resources:
            check_resources(self.ray_resources)  # raises ValueError

    @property
    def is_always_available(self) -> bool:
        """Whether no file and nothing else on a machine keeps it from being played."""
        is_available = self.unavailable is _always_available
        return is_available and self.changed_files is _no_files


def definition_of_plan(
    adapter: str,
    plan: Json,
    manifest: Json,
    make: Callable[[Mapping[str, Any]], Simulator],
    *,
    seed_max: int,
    success_scored: bool,
    ray_resources: Mapping[str, float],
) -> BenchmarkDefinition:
    """The definition of a benchmark that a host brings, which has no options.

    adapter: makes the simulator from `plan`; a simulator process has its own registry.
    success_scored: the score of an episode is its success.
    """

    def describe(_options: Mapping[str, Any], max_chunk: int) -> Json:
        return {**manifest, "max_chunk": max_chunk}

    def settings(images: Mapping[str, Any]) -> Json:
        scored = manifest["tasks"] if success_scored else []
        chosen = {"adapter": adapter, "plan": plan, "success_scored_tasks": scored}
        return {**images, **chosen}

    return BenchmarkDefinition(
        describe, settings, make, seed_max=seed_max, ray_resources=ray_resources
    )


def goals_in_words(tasks: Mapping[str, type[Any]]) -> Json:
    """Task → when its goal holds: the docstring of `goal_holds`, or of its class."""
    goals = {
        name: kind.goal_holds.__doc__ or kind.__doc__ or ""
        for name, kind in tasks.items()
    }
    return {name: " ".join(goal.split()) for name, goal in goals.items()}


def image_sizes(*sizes: tuple[int, int]) -> list[Json]:
    return [{"width": width, "height": height} for width, height in sizes]


@cache
def installed_version(distribution: str) -> str:
    """The version of an installed package, without importing it."""
    try:
        return importlib.metadata.version(distribution)
    except importlib.metadata.PackageNotFoundError:
        return "not installed"


def without_mujoco() -> str | None:
    """The reason why benchmarks with physics cannot be played; None if they can."""
    installed = importlib.util.find_spec("mujoco") is not None
    return None if installed else "MuJoCo is not installed: make setup"


def without_pictures() -> str | None:
    """Why benchmarks with cameras cannot be played; starts a process the first time."""
    if reason := without_mujoco():
        return reason  # a rendering test would report the graphics instead
    try:
        rendering.find_backend()
    except rendering.RenderingUnavailable as unavailable:
        return str(unavailable)
    return None
