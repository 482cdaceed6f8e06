"""A record, simulated again by several processes; each has its own simulator."""

from __future__ import annotations

import multiprocessing
from collections.abc import Callable, Iterable, Mapping, Sequence
from concurrent.futures import ProcessPoolExecutor, as_completed
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Any, Final, Literal

import msgspec

from reference_record.broken import UnusableRecord
from reference_record.contents.benchmark_manifest import (
    is_deterministic,
    manifest_of,
    manifest_sha256,
)
from reference_record.contents.replay_verdict import ReplaySummary, replay_of
from reference_record.contents.statement import EpisodeLine, Evaluation, read_lines
from reference_record.formats.bundle import open_bundle
from reference_record.formats.names import EPISODES
from reference_record.formats.opened_seeds import OpenedBenchmark, seeds_for
from reference_record.history.drawn_seeds import drawn_secret
from reference_sim import benchmark_registry
from reference_sim.definition import Json
from reference_sim.engine import engine_fingerprint
from reference_sim.host_seeds import as_drawn, seal, seal_for_run
from reference_sim.interface import Simulator
from reference_sim.replay.episode_replay import (
    EpisodeReplay,
    ReplayPlan,
    replay_episode,
)
from reference_sim.replay.foreign_manifest import (
    BenchmarkChoice,
    differences,
    open_part,
    read_choice,
    selected,
)
from reference_sim.replay.host_secrets import local_secrets

NONE_SIMULATED: Final = (
    "no episode can be simulated: their seeds are the secret of the host"
)
# REC-015: who can simulate episodes whose seeds are sealed.
DIFFERENCES_SHOWN: Final = 3
_NAMED_MAX: Final = 3
WHO_HAS_SEEDS: Final = (
    "the machine of their host has the seeds, for the user who runs the server there; "
    "any other needs --seeds with the file in which the host has opened them"
)
NO_SEEDS: Final = (
    f"no episode can be simulated, as their seeds are sealed: {WHO_HAS_SEEDS}"
)
_LEFT_OUT: Final = {
    "seed_sealed": f"the seed is sealed; {WHO_HAS_SEEDS}",
    "not_recorded": "nothing is recorded",
}


@dataclass(frozen=True, slots=True)
class ReplayedBenchmark:
    """The benchmark of a record, as this machine has it.

    secret_file: that of the host, if the seeds of sealed splits come from it.
    """

    manifest: dict[str, Any]
    config: benchmark_registry.SimulatorConfig
    secret_file: Path | None = None

    def plan_of(self, index: int) -> ReplayPlan:
        """The plan of an episode, by its index; its seed must not be secret."""
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

    def why_left_out(
        self, line: EpisodeLine
    ) -> Literal["seed_sealed", "not_recorded"] | None:
        """The reason for which an episode cannot be simulated; None if it can be."""
        if line.recording is None:
            return "not_recorded"
        return None if self.knows_seed(line.index) else "seed_sealed"

    def knows_seed(self, index: int) -> bool:
        """Whether the seed of an episode is known; a host may keep it secret."""
        return "seed" in self.manifest["episodes"][index]

    @property
    def secret(self) -> int:
        """How many episodes cannot be simulated because their seeds are secret."""
        return sum("seed" not in episode for episode in self.manifest["episodes"])

    def with_seeds(self, seeds: Mapping[int, int]) -> ReplayedBenchmark:
        """The benchmark with seeds that a host has opened. seeds: index → seed."""
        episodes = [
            {**episode, "seed": seeds[index]} if index in seeds else episode
            for index, episode in enumerate(self.manifest["episodes"])
        ]
        return replace(self, manifest={**self.manifest, "episodes": episodes})


class AnotherManifest(UnusableRecord):
    """This machine offers another benchmark of that id. here: its open manifest."""

    def __init__(self, benchmark_id: str, here: Json, differing: str = "") -> None:
        super().__init__(
            f"{benchmark_id} is another benchmark on this machine than in the record, "
            f"so it cannot be replayed: {differing or 'the manifests differ'}"
        )
        self._benchmark_id, self._here = benchmark_id, here

    def compared_with(self, recorded: Json) -> AnotherManifest:
        """The same error with the members that differ."""
        lines = [
            *differences(manifest_of(open_part(recorded)), manifest_of(self._here))
        ]
        more = len(lines) - DIFFERENCES_SHOWN
        shown = lines[:DIFFERENCES_SHOWN] + ([f"and {more} more"] if more > 0 else [])
        return AnotherManifest(self._benchmark_id, self._here, "; ".join(shown))


def resolve(
    evaluation: Evaluation,
    manifest: bytes,
    opened: OpenedBenchmark | None = None,
    secret_file: Path | None = None,
) -> ReplayedBenchmark:
    """opened: seeds of sealed splits that the host of the record has opened.

    secret_file: the host's own; None tries those of this user's servers.

    Raises UnusableRecord where this machine has another benchmark, or none, and where
    these are not the seeds to which the record commits its host.
    """
    choice = read_choice(evaluation, manifest)
    try:
        benchmark = resolve_choice(choice)
    except AnotherManifest as error:
        raise error.compared_with(msgspec.json.decode(manifest)) from error
    if opened is not None:
        return benchmark.with_seeds(seeds_for(opened, msgspec.json.decode(manifest)))
    return _add_seeds_of_this_machine(benchmark, choice, secret_file)


def _add_seeds_of_this_machine(
    benchmark: ReplayedBenchmark, choice: BenchmarkChoice, secret_file: Path | None
) -> ReplayedBenchmark:
    """Add sealed seeds where a server of this user is the host of the record."""
    if not benchmark.secret or choice.seeds_sha256 is None:
        return benchmark
    resolved = _resolved(choice)
    for path, secret in local_secrets(secret_file):
        sealed = seal_for_run(
            resolved.manifest,
            secret,
            resolved.seed_block,
            resolved.seed_max,
            choice.drawn,
        )
        if sealed["seeds_sha256"] == choice.seeds_sha256:
            with_seeds = _with_seeds_of(benchmark, dict(sealed), choice)
            return replace(with_seeds, secret_file=path)
    return benchmark


def _with_seeds_of(
    benchmark: ReplayedBenchmark, sealed: dict[str, Any], choice: BenchmarkChoice
) -> ReplayedBenchmark:
    episodes = selected(sealed, choice.select)["episodes"]
    seeds = {index: episode["seed"] for index, episode in enumerate(episodes)}
    return benchmark.with_seeds(seeds)


def add_drawn_seeds(
    benchmark: ReplayedBenchmark, choice: BenchmarkChoice, key: bytes
) -> ReplayedBenchmark:
    """The seeds of a draw whose key the host has opened (HST-032).

    Raises UnusableRecord where the record commits its host to other seeds.
    """
    drawn, resolved = choice.drawn, _resolved(choice)
    if drawn is None:
        raise UnusableRecord("the seeds of the record were not drawn with a key")
    sealed = seal(
        as_drawn(resolved.manifest, drawn),
        drawn_secret(key, drawn["root_sha256"]),
        resolved.seed_block,
        resolved.seed_max,
    )
    if sealed["seeds_sha256"] != choice.seeds_sha256:
        raise UnusableRecord(
            "the seeds that follow from the key are not those to which the record "
            f"commits its host: their SHA-256 is {sealed['seeds_sha256']} [HST-032]"
        )
    return _with_seeds_of(benchmark, dict(sealed), choice)


def _resolved(choice: BenchmarkChoice) -> benchmark_registry.ResolvedBenchmark:
    return benchmark_registry.resolve(
        choice.benchmark_id, choice.options, choice.images
    )


def _how_to_add(benchmark_id: str) -> str:
    added = [
        f"{reference} adds {name}"
        for name, reference in benchmark_registry.own_references().items()
    ]
    if added:
        return (
            f"{', '.join(added[:_NAMED_MAX])}: if one is the same, write "
            f'benchmark_id = "{benchmark_id}" into its TOML file'
        )
    return (
        "--benchmarks adds it, with what its server was started with: "
        '--benchmarks FILE.toml, or "simulator:COMMAND" for a server with '
        '--simulator "COMMAND", in the folder of its program'
    )


def resolve_choice(choice: BenchmarkChoice) -> ReplayedBenchmark:
    """Takes as long as the options say. Raises UnusableRecord as `resolve`."""
    benchmark_id = choice.benchmark_id
    try:
        reason = benchmark_registry.unavailable_reason(benchmark_id)
        resolved = _resolved(choice)
    except benchmark_registry.UnknownBenchmark as error:
        raise UnusableRecord(
            f"this machine has no benchmark {benchmark_id}; {_how_to_add(benchmark_id)}"
        ) from error
    except (LookupError, TypeError, ValueError, AttributeError) as error:
        # Nothing has checked the options of a record before.
        raise UnusableRecord(
            f"{benchmark_id} has not the options of the record: {error}"
        ) from error
    if reason is not None:
        raise UnusableRecord(f"{benchmark_id} cannot be simulated here: {reason}")
    drawn = dict(as_drawn(resolved.manifest, choice.drawn))
    known = open_part(selected(drawn, choice.select))
    if manifest_sha256(known) != choice.open_sha256:
        raise AnotherManifest(benchmark_id, known)
    if not is_deterministic(known):
        raise UnusableRecord(
            f"{benchmark_id} cannot be replayed: its simulator says that equal seeds "
            "and actions may give other episodes, so its records promise no replay"
        )
    return ReplayedBenchmark(known, resolved.world)


def add_opened_seeds(
    benchmark: ReplayedBenchmark,
    choice: BenchmarkChoice,
    files: Iterable[OpenedBenchmark],
) -> ReplayedBenchmark:
    """Add the seeds of sealed splits, where one of the files has them.

    Raises UnusableRecord where these are not what the file says.
    """
    commitment = choice.seeds_sha256
    for opened in files:
        if opened.benchmark_id == choice.benchmark_id and any(
            part.seeds_sha256 == commitment for part in opened.opened
        ):
            # Its own manifest, not that of the record: it is the same but for seeds.
            manifest = {**benchmark.manifest, "seeds_sha256": commitment}
            return benchmark.with_seeds(seeds_for(opened, manifest))
    return benchmark


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
    report: called with each episode when it is done. Raises UnusableRecord when the
    record does not have an episode that is wanted, or none can be simulated.
    """
    lines = replayable_lines(path, benchmark, only)
    replays: dict[int, EpisodeReplay] = {}
    work = partial(_replay_one, path, benchmark)
    if benchmark.config.holds_connection:  # its program may have one world
        processes = 1
    with _process_pool(min(processes, len(lines) or 1)) as pool:
        pending = {pool.submit(work, line): line.index for line in lines}
        for done in as_completed(pending):
            index = pending[done]
            replays[index] = done.result()
            report(index, replays[index])
    results = {
        index: (replay.result, replay.where) for index, replay in replays.items()
    }
    return replay_of(results, engine_fingerprint())


def _process_pool(processes: int) -> ProcessPoolExecutor:
    """Its semaphores are files of /dev/shm, which an OSError of them does not name."""
    try:
        context = multiprocessing.get_context("spawn")
        return ProcessPoolExecutor(processes, context)
    except OSError as error:
        place = "/dev/shm"  # noqa: S108 - where the C library keeps semaphores
        what = f"{place}, which the processes of a replay need"
        raise OSError(error.errno, error.strerror, what) from error


def replayable_lines(
    path: Path, benchmark: ReplayedBenchmark, only: Sequence[int] | None = None
) -> list[EpisodeLine]:
    """The episodes of a verified record that can be simulated, or `only` those.

    Raises UnusableRecord when the record does not have one of `only`, or none can.
    """
    wanted = _wanted_lines(path, only)
    lines = [line for line in wanted if benchmark.why_left_out(line) is None]
    if not lines:
        reasons = [] if only is None else left_out_texts(path, benchmark, only)
        raise UnusableRecord("; ".join(reasons) or NO_SEEDS)
    return lines


def left_out_texts(
    path: Path, benchmark: ReplayedBenchmark, only: Sequence[int]
) -> list[str]:
    """Why some of the episodes `only` cannot be simulated, and who can; else empty."""
    texts = []
    lines = _wanted_lines(path, only)
    for reason, text in _LEFT_OUT.items():
        found = [line for line in lines if benchmark.why_left_out(line) == reason]
        if found:
            some = "episode" if len(found) == 1 else "episodes"
            indices = ", ".join(str(line.index) for line in found)
            texts.append(f"{some} {indices} cannot be simulated: {text}")
    return texts


def _wanted_lines(path: Path, only: Sequence[int] | None) -> list[EpisodeLine]:
    lines = list(read_lines(open_bundle(path).blocks(EPISODES)))
    if only is None:
        return lines
    if absent := sorted(set(only) - {line.index for line in lines}):
        last = max((line.index for line in lines), default=-1)
        has = "none" if last < 0 else f"0 to {last}"
        raise UnusableRecord(f"the record has no episode {absent[0]}; it has {has}")
    return [line for line in lines if line.index in set(only)]


_SIMULATORS: dict[str, Simulator] = {}  # of this process, one


def _replay_one(
    path: Path, benchmark: ReplayedBenchmark, line: EpisodeLine
) -> EpisodeReplay:
    plan = benchmark.plan_of(line.index)
    return replay_episode(path, _simulator(benchmark), plan, line.result)


def _simulator(benchmark: ReplayedBenchmark) -> Simulator:
    name = benchmark.config.benchmark_id
    if name not in _SIMULATORS:
        _SIMULATORS[name] = benchmark_registry.make(benchmark.config)
    return _SIMULATORS[name]
