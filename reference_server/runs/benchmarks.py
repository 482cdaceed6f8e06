"""The benchmarks that this server offers, in the spec's schemas.

Their content is the simulator's; the hash and the refusals are decided here.
"""

from __future__ import annotations

import asyncio
import hmac
import json
import logging
import time
from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any, cast

import msgspec

from reference_record.contents.benchmark_manifest import (
    is_manifest,
    manifest_sha256,
)
from reference_record.generated import answers
from reference_record.texts.counted_text import counted
from reference_server.files.seed_secret import SeedSecret
from reference_server.rules import submission as submission_rules
from reference_server.rules.manifest import (
    Manifest,
    Submission,
)
from reference_server.rules.refusal import Refused, not_found
from reference_server.rules.runs.lifecycle import OPEN_STATES, Refuse
from reference_server.rules.runs.run import RunHead
from reference_server.rules.submission import Selection
from reference_server.storage.runs.run_store import Store, StoreFailed
from reference_sim import benchmark_registry
from reference_sim.host_seeds import seal_for_run

log = logging.getLogger("proctor.runs")

CACHED_CONFIGS_MAX = 256
# Manifests that are compared at the start, each for up to 0.1 s.
COMPARED_MANIFESTS_MAX = 64


@dataclass(frozen=True, slots=True)
class ResolvedRun:
    """A benchmark with one submission's choices applied.

    manifest: schema Benchmark without its hash, and `episodes` with the seeds that are
    played; those of sealed splits are secret.
    """

    manifest: Manifest
    manifest_sha256: str
    images: answers.ImageChoice


# Manifests that further runs share with those that were submitted.
SHARED_MANIFESTS_MAX = 64


class Benchmarks:
    """All benchmarks of the simulator's catalogue."""

    def __init__(self, max_chunk: int, seed_secret: SeedSecret) -> None:
        self._max_chunk = max_chunk
        self._manifests: dict[str, Manifest] = {}
        self._resolved_runs: dict[bytes, ResolvedRun] = {}
        self._seed_secret = seed_secret

    def summaries(self) -> list[answers.BenchmarkSummary]:
        """Each benchmark, sorted by id (BEN-001, BEN-004)."""
        benchmarks: list[answers.BenchmarkSummary] = []
        for benchmark_id in benchmark_registry.benchmark_ids():
            resolved = self._resolved(benchmark_id, None, None)
            manifest = resolved.manifest
            benchmarks.append(
                {
                    "benchmark_id": manifest["benchmark_id"],
                    "version": manifest["version"],
                    "title": manifest["title"],
                    "episodes_total": manifest["episodes_total"],
                    "manifest_sha256": resolved.manifest_sha256,
                }
            )
        return benchmarks

    def manifests(self) -> Iterator[Manifest]:
        """The manifest of each, without a choice."""
        for benchmark_id in benchmark_registry.benchmark_ids():
            yield self._resolved(benchmark_id, None, None).manifest

    def have_robots(self) -> bool:
        return any("physical" in manifest for manifest in self.manifests())

    def offers(self, benchmark_id: str) -> bool:
        return benchmark_id in benchmark_registry.benchmark_ids()

    async def view(self, benchmark_id: str) -> answers.Benchmark:
        """Schema Benchmark (BEN-002, BEN-003)."""
        if not self.offers(benchmark_id):
            raise no_benchmark(benchmark_id)
        resolved = self._resolved(benchmark_id, None, None)
        members: dict[str, object] = {
            k: v for k, v in resolved.manifest.items() if k != "episodes"
        }
        members["manifest_sha256"] = resolved.manifest_sha256
        members["unavailable_reason"] = await _unavailable(benchmark_id)
        # A simulator may add members of its own.
        return cast("answers.Benchmark", members)

    def manifest_sha256(self, benchmark_id: str) -> str:
        """The `manifest_sha256` of the benchmark without a choice (BEN-003)."""
        if not self.offers(benchmark_id):
            raise no_benchmark(benchmark_id)
        return self._resolved(benchmark_id, None, None).manifest_sha256

    async def resolve(
        self, submission: Submission, drawn: Mapping[str, Any] | None = None
    ) -> ResolvedRun:
        """The manifest of a new run; refused when its choices do not fit (RUN-006).

        drawn: how the seeds of this run are drawn; None as for every other one.
        """
        benchmark_id = submission["benchmark_id"]
        if benchmark_id not in benchmark_registry.benchmark_ids():
            raise Refused(
                "invalid_request",
                f"There is no benchmark {benchmark_id}.",
                errors=[("/benchmark_id", "see list_benchmarks")],
                requirement="RUN-006",
            )
        reason = await _unavailable(benchmark_id)
        if reason is not None:
            raise Refused("benchmark_unavailable", f"{benchmark_id}: {reason}.")
        options, images = submission.get("options"), submission.get("images")
        try:
            return self._resolved(
                benchmark_id, options, images, submission.get("select"), drawn
            )
        except benchmark_registry.InvalidChoice as error:  # RUN-007, RUN-017
            raise Refused(
                "invalid_request",
                "The benchmark does not offer this choice.",
                errors=[(error.pointer, error.detail)],
            ) from error

    def _resolved(
        self,
        benchmark_id: str,
        options: Mapping[str, Any] | None,
        images: Mapping[str, Any] | None,
        select: Selection | None = None,
        drawn: Mapping[str, Any] | None = None,
    ) -> ResolvedRun:
        """Described, sealed and hashed once per choice: it takes 0.1 s if it is long.

        The secret is part of the choice, for it may be read after this was made.
        """
        choices = json.dumps((benchmark_id, options, images, select, drawn)).encode()
        key = hmac.digest(self._seed_secret.value, choices, "sha256")
        resolved = self._resolved_runs.get(key)
        if resolved is None:
            resolved = self._resolve(benchmark_id, options, images, select, drawn)
            if len(self._resolved_runs) >= SHARED_MANIFESTS_MAX:
                self._resolved_runs.clear()
            self._resolved_runs[key] = resolved
        return resolved

    def _resolve(
        self,
        benchmark_id: str,
        options: Mapping[str, Any] | None,
        images: Mapping[str, Any] | None,
        select: Selection | None,
        drawn: Mapping[str, Any] | None,
    ) -> ResolvedRun:
        resolved = benchmark_registry.resolve(
            benchmark_id, options, images, max_chunk=self._max_chunk
        )
        whole = _sealed_manifest(resolved, self._seed_secret, drawn)
        manifest = submission_rules.select_episodes(whole, select)
        if isinstance(manifest, Refuse):
            raise Refused.from_verdict(manifest)
        sha256 = manifest_sha256(manifest)
        if len(self._manifests) >= SHARED_MANIFESTS_MAX:
            self._manifests.clear()
        # One for all runs that have it: it is most of what a run takes in memory.
        manifest = self._manifests.setdefault(sha256, manifest)
        return ResolvedRun(manifest, sha256, resolved.images)


def no_benchmark(benchmark_id: str) -> Refused:
    return not_found("benchmark", benchmark_id, benchmark_registry.benchmark_ids())


class SimulatorConfigs:
    """Configurations of simulator processes, made once per manifest and choice.

    A benchmark does not change while the server runs, and its manifest is long: it is
    described and hashed again only for what is not in the cache.
    """

    def __init__(self, seed_secret: SeedSecret) -> None:
        self._seed_secret = seed_secret
        self._started_at_wall = time.time()
        # A text says why there is none.
        self._cache: dict[bytes, benchmark_registry.SimulatorConfig | str] = {}

    def find(self, run: RunHead) -> benchmark_registry.SimulatorConfig:
        """Refused when the benchmark is not the one that the run was submitted to.

        A score is of one manifest.
        """
        config = self._find(run)
        if isinstance(config, str):
            raise Refused("benchmark_unavailable", config)
        return config

    def why_unplayable(self, run: RunHead) -> str | None:
        """Why no worker can play a run that an earlier server process accepted."""
        if run.created_at_wall >= self._started_at_wall:
            return None
        config = self._find(run)
        return config if isinstance(config, str) else None

    def _find(self, run: RunHead) -> benchmark_registry.SimulatorConfig | str:
        submission = run.submission
        choices = (submission["benchmark_id"], submission.get("options"), run.images)
        key = msgspec.msgpack.encode((run.manifest_sha256, choices))
        config = self._cache.get(key)
        if config is None:
            config = _simulator_config(run, self._seed_secret)
            if len(self._cache) >= CACHED_CONFIGS_MAX:
                self._cache.clear()
            self._cache[key] = config
        return config


async def log_unplayable(
    store: Store, why_unplayable: Callable[[RunHead], str | None]
) -> None:
    """Log how many open runs of an earlier server process cannot go on."""
    unplayable: Counter[str] = Counter()
    try:
        counts = await store.counts_of_manifests(OPEN_STATES, COMPARED_MANIFESTS_MAX)
        for run_id, count in counts:
            window = await store.read_window(run_id, 0, 0)
            if window is None:
                continue
            head = window[0]
            # The benchmark is described and hashed: never on the event loop.
            if await asyncio.to_thread(why_unplayable, head) is not None:
                unplayable[head.submission["benchmark_id"]] += count
    except StoreFailed:
        return  # requests report it
    for benchmark_id, count in unplayable.items():
        log.warning(
            "%s of %s cannot go on: the benchmark has changed since, or is not offered "
            "any more. Their accounts end them with proctor stop RUN; the software and "
            "the files of before would play them",
            counted(count, "open run"),
            benchmark_id,
        )


def _sealed_manifest(
    resolved: benchmark_registry.ResolvedBenchmark,
    seed_secret: SeedSecret,
    drawn: Mapping[str, Any] | None,
) -> Manifest:
    sealed = seal_for_run(
        resolved.manifest,
        seed_secret.value,
        resolved.seed_block,
        resolved.seed_max,
        drawn,
    )
    return cast("Manifest", sealed)  # schema Benchmark


def _simulator_config(
    run: RunHead, seed_secret: SeedSecret
) -> benchmark_registry.SimulatorConfig | str:
    """The configuration, or why the run cannot be played."""
    submission = run.submission
    benchmark_id = submission["benchmark_id"]
    if benchmark_id not in benchmark_registry.benchmark_ids():
        return (
            f"{benchmark_id} is no longer offered, so this run cannot go on until a "
            "server that offers it is started. Scored episodes are kept."
        )
    changed = (
        f"{benchmark_id} has changed since this run was submitted, so this run cannot "
        "go on: what is offered now has another manifest. Submit another run; only the "
        "host could undo what changed it, an upgrade or a file. Scored episodes are "
        "kept."
    )
    try:
        resolved = benchmark_registry.resolve(
            benchmark_id,
            submission.get("options"),
            run.images,
            max_chunk=run.manifest["max_chunk"],
        )
    except benchmark_registry.InvalidChoice:  # an option that it had
        return changed
    whole = _sealed_manifest(resolved, seed_secret, run.manifest.get("seeds_drawn"))
    manifest = submission_rules.select_episodes(whole, submission.get("select"))
    if isinstance(manifest, Refuse) or not is_manifest(manifest, run.manifest_sha256):
        return changed
    return resolved.world


async def _unavailable(benchmark_id: str) -> str | None:
    if benchmark_registry.is_always_available(benchmark_id):
        return None
    # Reads files, and may start a process to find a renderer: never on the event loop.
    return await asyncio.to_thread(benchmark_registry.unavailable_reason, benchmark_id)
