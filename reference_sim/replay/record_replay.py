"""A record, simulated again by several processes; each has its own simulator."""

from __future__ import annotations

import hashlib
import multiprocessing
from collections.abc import Callable, Sequence
from concurrent.futures import ProcessPoolExecutor, as_completed
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

import msgspec

from reference_record.broken import UnusableRecord
from reference_record.formats.bundle import open_bundle
from reference_record.formats.names import EPISODES, MANIFEST
from reference_record.formats.strict_json import read_json
from reference_record.replay_verdict import ReplaySummary, replay_of
from reference_record.statement import EpisodeLine, Evaluation, read_lines
from reference_sim import benchmark_registry
from reference_sim.engine import engine_fingerprint
from reference_sim.interface import Simulator
from reference_sim.replay.episode_replay import (
    EpisodeReplay,
    ReplayPlan,
    replay_episode,
)


@dataclass(frozen=True, slots=True)
class ReplayedBenchmark:
    """The benchmark of a record, as this machine has it."""

    manifest: dict[str, Any]
    config: benchmark_registry.SimulatorConfig

    def plan_of(self, index: int) -> ReplayPlan:
        """The episode at a place of the manifest; its seed is no secret."""
        manifest = self.manifest
        planned = manifest["episodes"][index]
        return ReplayPlan(
            planned["task"],
            planned["seed"],
            planned["split"],
            manifest["max_steps"],
            manifest["success_rule"],
            planned["task"] in self.config.success_scored_tasks,
        )


class _Limits(msgspec.Struct):
    max_chunk: int


def resolve(evaluation: Evaluation, manifest: bytes) -> ReplayedBenchmark:
    """Raises UnusableRecord where this machine has another benchmark, or none."""
    max_chunk = read_json(MANIFEST, manifest, _Limits).max_chunk
    benchmark_id = evaluation.benchmark.benchmark_id
    run = evaluation.run
    try:
        reason = benchmark_registry.unavailable_reason(benchmark_id)
        found = benchmark_registry.resolve(
            benchmark_id, run.options, run.images, max_chunk=max_chunk
        )
    except benchmark_registry.UnknownBenchmark as error:
        raise UnusableRecord(
            f"this machine has no benchmark {benchmark_id}; --benchmarks adds yours"
        ) from error
    except (LookupError, TypeError, ValueError, AttributeError) as error:
        # Nothing has checked the options of a record before.
        raise UnusableRecord(
            f"{benchmark_id} has not the options of the record: {error}"
        ) from error
    if reason is not None:
        raise UnusableRecord(f"{benchmark_id} cannot be simulated here: {reason}")
    canonical = msgspec.json.encode(found.manifest, order="deterministic")
    if hashlib.sha256(canonical).hexdigest() == evaluation.manifest_sha256:
        return ReplayedBenchmark(found.manifest, found.world)
    open_part = _without_sealed_seeds(found.manifest)
    if _without_sealed_seeds(msgspec.json.decode(manifest)) != open_part:
        raise UnusableRecord(
            f"{benchmark_id} is another one here: its manifest has another SHA-256. "
            "Install the version of the record: proctor verify shows it"
        )
    return ReplayedBenchmark(open_part, found.world)


def _without_sealed_seeds(manifest: dict[str, Any]) -> dict[str, Any]:
    """The manifest but for what the host of a sealed split keeps secret."""
    sealed = manifest.get("sealed_splits", ())
    episodes = [
        {k: v for k, v in one.items() if k != "seed" or one["split"] not in sealed}
        for one in manifest["episodes"]
    ]
    rest = {k: v for k, v in manifest.items() if k != "seeds_sha256"}
    return {**rest, "episodes": episodes}


def replay_record(
    path: Path,
    benchmark: ReplayedBenchmark,
    *,
    only: Sequence[int] | None = None,
    processes: int = 1,
    report: Callable[[int, EpisodeReplay], None] = lambda *_: None,
) -> ReplaySummary:
    """Simulate a verified record again. only: indices of episodes; None for all.

    Episodes whose seed is the secret of the host are left out.
    report: called with each episode when it is done. Raises UnusableRecord when an
    episode that is wanted cannot be simulated, or none can.
    """
    lines = replayable_lines(path, benchmark, only)
    found: dict[int, EpisodeReplay] = {}
    work = partial(_replay_one, path, benchmark)
    context = multiprocessing.get_context("spawn")
    with ProcessPoolExecutor(min(processes, len(lines) or 1), context) as pool:
        pending = {pool.submit(work, line): line.index for line in lines}
        for done in as_completed(pending):
            index = pending[done]
            found[index] = done.result()
            report(index, found[index])
    results = {index: (one.result, one.where) for index, one in found.items()}
    return replay_of(results, engine_fingerprint())


def replayable_lines(
    path: Path, benchmark: ReplayedBenchmark, only: Sequence[int] | None = None
) -> list[EpisodeLine]:
    """The episodes of a verified record that can be simulated, or `only` those.

    Raises UnusableRecord when one that is wanted cannot be, or none can.
    """
    bundle = open_bundle(path)
    planned = benchmark.manifest["episodes"]
    lines = [
        line
        for line in read_lines(bundle.blocks(EPISODES))
        if line.recording is not None and "seed" in planned[line.index]
    ]
    if only is not None:
        absent = sorted(set(only) - {line.index for line in lines})
        if absent:
            raise UnusableRecord(
                f"the record has no episode {absent[0]} that can be simulated"
            )
        lines = [line for line in lines if line.index in set(only)]
    if not lines:
        raise UnusableRecord(
            "no episode can be simulated: their seeds are the secret of the host"
        )
    return lines


_SIMULATORS: dict[str, Simulator] = {}  # of this process, one


def _replay_one(
    path: Path, benchmark: ReplayedBenchmark, line: EpisodeLine
) -> EpisodeReplay:
    plan = benchmark.plan_of(line.index)
    return replay_episode(path, _simulator(benchmark), plan, line)


def _simulator(benchmark: ReplayedBenchmark) -> Simulator:
    name = benchmark.config.benchmark_id
    if name not in _SIMULATORS:
        _SIMULATORS[name] = benchmark_registry.make(benchmark.config)
    return _SIMULATORS[name]
