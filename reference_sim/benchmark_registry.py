"""The registry of benchmarks: resolves submissions and makes simulators.

A simulator is imported only when one is made, so listing benchmarks imports no physics
and renders no image. The user's own benchmarks are added when the server starts, by an
adapter whose name is part of the simulator's settings: a simulator process has its own
registry, without them.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache
from typing import Any

from reference_record.contents.drawable import DRAWN_AS
from reference_record.generated.answers import ImageChoice
from reference_sim.benchmarks import calibration
from reference_sim.benchmarks.mobile_bimanual import benchmark as mobile_bimanual
from reference_sim.benchmarks.question_answering import benchmark as question_answering
from reference_sim.benchmarks.question_file import benchmark as question_file
from reference_sim.benchmarks.tabletop import benchmark as tabletop
from reference_sim.definition import BenchmarkDefinition, Json
from reference_sim.external.socket_address import is_socket
from reference_sim.gymnasium import BadBenchmark
from reference_sim.interface import Simulator


class UnknownBenchmark(LookupError):
    """The registry has no benchmark of that id."""


class InvalidChoice(ValueError):
    """The benchmark does not offer the choice of the member `pointer` (RUN-017)."""

    def __init__(self, pointer: str, detail: str) -> None:
        super().__init__(pointer, detail)
        self.pointer = pointer
        self.detail = detail

    def __str__(self) -> str:
        return self.detail


@dataclass(frozen=True, slots=True)
class EpisodePlan:
    task: str
    split: str
    seed: int


@dataclass(frozen=True, slots=True)
class SimulatorConfig:
    """The configuration of a simulator process; `settings` can be written as JSON.

    Processes are reused for equal configurations, so settings contain nothing that
    differs by episode. ray_resources: see BenchmarkDefinition; they decide where
    the process is started, and are not sent to it.
    """

    benchmark_id: str
    settings: Mapping[str, Any]
    ray_resources: Mapping[str, float] = field(default_factory=dict)

    @property
    def image_codec(self) -> str:
        return str(self.settings["codec"])

    @property
    def imports_own_files(self) -> bool:
        """Whether the simulator consists of files of the host's own."""
        return self.settings.get("adapter") == "gymnasium"

    @property
    def holds_connection(self) -> bool:
        """Whether it has a connection to a program that may have one world."""
        is_external = self.settings.get("adapter") == "external"
        return is_external and is_socket(self.settings["plan"]["command"])

    @property
    def is_robot(self) -> bool:
        """Whether it is stopped before its process is ended."""
        described = self.settings.get("plan", {}).get("benchmark", {})
        return "physical" in described

    @property
    def success_scored_tasks(self) -> Sequence[str]:
        """Tasks whose score is 1 on success by the success rule, and 0 otherwise."""
        tasks: Sequence[str] = self.settings.get("success_scored_tasks", ())
        return tasks


@dataclass(frozen=True, slots=True)
class ResolvedBenchmark:
    """A benchmark with a submitter's choices applied.

    manifest: see BenchmarkDefinition.describe.
    images: the chosen codec, width and height.
    seed_block, seed_max: see BenchmarkDefinition.
    """

    manifest: Json
    episodes: tuple[EpisodePlan, ...]
    world: SimulatorConfig
    images: ImageChoice
    seed_block: int
    seed_max: int


def add(references: str, say: Callable[[str], None]) -> None:
    """Add the user's own benchmarks, after checking them.

    references: see docs/host/benchmarks.md, comma-separated. say: called with progress
    messages. Blocks for seconds. Raises BadBenchmark; earlier references are then
    already added.
    """
    for reference in filter(None, map(str.strip, references.split(","))):
        for benchmark_id, definition in _benchmarks_of(reference, say):
            if benchmark_id in _BENCHMARKS:
                raise BadBenchmark(
                    f"{reference}: benchmark_id {benchmark_id} is already in use; "
                    "change it in the file"
                )
            _BENCHMARKS[benchmark_id] = definition
            _REFERENCES[benchmark_id] = reference


def _benchmarks_of(
    reference: str, say: Callable[[str], None]
) -> Iterable[tuple[str, BenchmarkDefinition]]:
    if reference.endswith(question_file.ENDING):
        return [question_file.benchmark(reference)]
    from reference_sim.gymnasium import registration

    return registration.benchmarks(reference, say)


def benchmark_ids() -> tuple[str, ...]:
    return tuple(sorted(_BENCHMARKS))


def own_references() -> Mapping[str, str]:
    """The reference of each benchmark that was added, by its id."""
    return _REFERENCES


def resolve(
    benchmark_id: str,
    options: Mapping[str, Any] | None = None,
    images: Mapping[str, Any] | None = None,
    *,
    max_chunk: int = 64,
) -> ResolvedBenchmark:
    """Raises UnknownBenchmark and InvalidChoice. The schema has checked bounds."""
    definition = _definition(benchmark_id)
    if options is not None and not definition.has_options:
        raise InvalidChoice("/options", f"{benchmark_id} takes no options")
    manifest = definition.describe(options or {}, max_chunk)
    chosen = _choose_images(manifest, images)
    settings = definition.settings(chosen)
    return ResolvedBenchmark(
        manifest=manifest,
        episodes=tuple(EpisodePlan(**episode) for episode in manifest["episodes"]),
        world=SimulatorConfig(benchmark_id, settings, definition.ray_resources),
        images=chosen,
        seed_block=definition.seed_block,
        seed_max=definition.seed_max,
    )


def ray_resources(benchmark_id: str) -> Mapping[str, float]:
    """The resources that the benchmark declares; see BenchmarkDefinition."""
    return _definition(benchmark_id).ray_resources


def drawn_as(benchmark_id: str) -> ResolvedBenchmark | None:
    """The benchmark with cameras that draws these episodes; None if there is none."""
    drawing_id = DRAWN_AS.get(benchmark_id)
    return None if drawing_id is None else resolve(drawing_id)


def is_always_available(benchmark_id: str) -> bool:
    """Whether there is never an `unavailable_reason`, which may block."""
    return _definition(benchmark_id).is_always_available


def unavailable_reason(benchmark_id: str) -> str | None:
    """Why the benchmark cannot be played, and the remedy; None when it can.

    Looks at the host's own files, which the manifest has as they were. Blocks up to a
    second the first time, for a rendering test.
    """
    if changed := _definition(benchmark_id).changed_files():
        return (
            f"{', '.join(changed)} has changed since the server started: restart the "
            "server to offer the changed benchmark, or undo the change"
        )
    return _missing(benchmark_id)


@cache
def _missing(benchmark_id: str) -> str | None:
    return _definition(benchmark_id).unavailable()


def make(
    world: SimulatorConfig, on_wait: Callable[[], None] = lambda: None
) -> Simulator:
    """Make the simulator, in the process that runs it.

    on_wait: called about every second while a simulator takes long to start.
    """
    if world.settings.get("adapter") == "external":
        from reference_sim.external import external_simulator

        return external_simulator.make(world.settings, on_wait)
    if world.settings.get("adapter") == "gymnasium":
        from reference_sim.gymnasium import simulator

        return simulator.make(world.settings)
    if world.settings.get("adapter") == question_file.ADAPTER:
        return question_file.make(world.settings)
    return _definition(world.benchmark_id).make(world.settings)


def _definition(benchmark_id: str) -> BenchmarkDefinition:
    try:
        return _BENCHMARKS[benchmark_id]
    except KeyError:
        raise UnknownBenchmark(f"no benchmark {benchmark_id!r}") from None


def _choose_images(manifest: Json, images: Mapping[str, Any] | None) -> ImageChoice:
    codecs, sizes = manifest["image_codecs"], manifest["image_sizes"]
    if images is None:
        images = {"codec": codecs[0], **sizes[0]}
    if images["codec"] not in codecs:
        raise InvalidChoice("/images/codec", f"offered are {', '.join(codecs)}")
    width, height = images["width"], images["height"]
    if {"width": width, "height": height} not in sizes:
        offered = ", ".join(f"{s['width']} × {s['height']}" for s in sizes)
        raise InvalidChoice("/images/width", f"offered are {offered}")
    return {"codec": images["codec"], "width": width, "height": height}


_REFERENCES: dict[str, str] = {}
_BENCHMARKS: dict[str, BenchmarkDefinition] = {
    **calibration.BENCHMARKS,
    **mobile_bimanual.BENCHMARKS,
    **question_answering.BENCHMARKS,
    **tabletop.BENCHMARKS,
}
