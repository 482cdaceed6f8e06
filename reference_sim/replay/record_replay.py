"""A record, simulated again by several processes; each has its own simulator."""

from __future__ import annotations

import hashlib
import multiprocessing
from collections.abc import Callable, Sequence
from concurrent.futures import ProcessPoolExecutor, as_completed
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Annotated, Any, Final

import msgspec
from msgspec import Meta

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

# No server announces more actions in one predict.
MAX_CHUNK: Final = 4096


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


class _PlannedEpisode(msgspec.Struct):
    split: str


class _ForeignManifest(msgspec.Struct):
    """What is read of a manifest of unknown origin; the rest is only compared."""

    max_chunk: Annotated[int, Meta(ge=1, le=MAX_CHUNK)]
    episodes: list[_PlannedEpisode]
    sealed_splits: list[str] = []


class BenchmarkChoice(msgspec.Struct, frozen=True):
    """What a record says of its benchmark, of which the manifest is only a digest.

    open_sha256: of the manifest without what a host of sealed splits keeps secret.
    """

    benchmark_id: str
    options: dict[str, Any] | None
    images: dict[str, Any] | None
    max_chunk: int
    manifest_sha256: str
    open_sha256: str


def read_choice(evaluation: Evaluation, manifest: bytes) -> BenchmarkChoice:
    """Reads the whole manifest, which may be large. Raises BrokenRecord."""
    read = read_json(MANIFEST, manifest, _ForeignManifest)
    open_part = _without_sealed_seeds(msgspec.json.decode(manifest))
    return BenchmarkChoice(
        evaluation.benchmark.benchmark_id,
        evaluation.run.options,
        evaluation.run.images,
        read.max_chunk,
        evaluation.manifest_sha256,
        _sha256_of(open_part),
    )


def resolve(evaluation: Evaluation, manifest: bytes) -> ReplayedBenchmark:
    """Raises UnusableRecord where this machine has another benchmark, or none."""
    return resolve_choice(read_choice(evaluation, manifest))


def resolve_choice(choice: BenchmarkChoice) -> ReplayedBenchmark:
    """Takes as long as the options say. Raises UnusableRecord as `resolve`."""
    benchmark_id = choice.benchmark_id
    try:
        reason = benchmark_registry.unavailable_reason(benchmark_id)
        found = benchmark_registry.resolve(
            benchmark_id, choice.options, choice.images, max_chunk=choice.max_chunk
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
    if _sha256_of(found.manifest) == choice.manifest_sha256:
        return ReplayedBenchmark(found.manifest, found.world)
    open_part = _without_sealed_seeds(found.manifest)
    if _sha256_of(open_part) != choice.open_sha256:
        raise UnusableRecord(
            f"{benchmark_id} is another one here: its manifest has another SHA-256. "
            "Install the version of the record: proctor verify shows it"
        )
    return ReplayedBenchmark(open_part, found.world)


def _sha256_of(manifest: dict[str, Any]) -> str:
    canonical = msgspec.json.encode(manifest, order="deterministic")
    return hashlib.sha256(canonical).hexdigest()


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
