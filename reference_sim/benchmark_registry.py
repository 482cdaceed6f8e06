"""The benchmarks offered: what a run of one consists of, and how its world is made.

Simulators are imported when one is made, so that a server that only lists benchmarks
stays light, and no picture is drawn to learn what is offered. Those of the user's own
are added at the start, by an adapter whose name travels in the world's settings: the
process that makes the simulator has a catalog of its own, without them.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

from reference_sim.benchmarks import calibration
from reference_sim.benchmarks.mobile_bimanual import benchmark as mobile_bimanual
from reference_sim.benchmarks.question_answering import benchmark as question_answering
from reference_sim.benchmarks.tabletop import benchmark as tabletop
from reference_sim.definition import BenchmarkDefinition, Json
from reference_sim.gymnasium import BadBenchmark
from reference_sim.interface import Simulator


class UnknownBenchmark(LookupError):
    """There is no benchmark of that id here."""


class InvalidChoice(ValueError):
    """The benchmark does not offer what was asked for; `pointer` says which member."""

    def __init__(self, pointer: str, detail: str) -> None:
        super().__init__(detail)
        self.pointer = pointer
        self.detail = detail


@dataclass(frozen=True, slots=True)
class EpisodePlan:
    task: str
    split: str
    seed: int


@dataclass(frozen=True, slots=True)
class SimulatorConfig:
    """What a simulator process needs to build its simulator; `settings` is JSON-able.

    Equal worlds share processes, so settings hold nothing that differs by episode.
    """

    benchmark_id: str
    settings: Mapping[str, Any]

    @property
    def image_codec(self) -> str:
        return str(self.settings["codec"])

    @property
    def success_scored_tasks(self) -> Sequence[str]:
        """Tasks whose score is 1 on success by the success rule, and 0 otherwise."""
        tasks: Sequence[str] = self.settings.get("success_scored_tasks", ())
        return tasks


@dataclass(frozen=True, slots=True)
class ResolvedBenchmark:
    """A benchmark with a submitter's choices applied.

    manifest: see Definition.describe.
    images: codec, width and height as chosen.
    """

    manifest: Json
    episodes: tuple[EpisodePlan, ...]
    world: SimulatorConfig
    images: Json


def add(references: str, say: Callable[[str], None]) -> None:
    """Offers benchmarks of the user's own beside ours, after trying them.

    references: see docs/host/benchmarks.md, comma-separated. say: is given lines for
    people. Blocks for seconds. Raises BadBenchmark, and has then added those before.
    """
    from reference_sim.gymnasium import registration

    for reference in filter(None, map(str.strip, references.split(","))):
        for benchmark_id, definition in registration.benchmarks(reference, say):
            if benchmark_id in _BENCHMARKS:
                raise BadBenchmark(
                    f"{reference}: there is a benchmark {benchmark_id} already: "
                    "write another benchmark_id into its file"
                )
            _BENCHMARKS[benchmark_id] = definition


def benchmark_ids() -> tuple[str, ...]:
    return tuple(sorted(_BENCHMARKS))


def resolve(
    benchmark_id: str,
    options: Mapping[str, Any] | None = None,
    images: Mapping[str, Any] | None = None,
    *,
    max_chunk: int = 64,
) -> ResolvedBenchmark:
    """Raises UnknownBenchmark and InvalidChoice. Bounds are the schema's to check."""
    definition = _definition(benchmark_id)
    if options is not None and not definition.has_options:
        raise InvalidChoice("/options", f"{benchmark_id} takes no options")
    manifest = definition.describe(options or {}, max_chunk)
    chosen = _choose_images(manifest, images)
    return ResolvedBenchmark(
        manifest=manifest,
        episodes=tuple(EpisodePlan(**episode) for episode in manifest["episodes"]),
        world=SimulatorConfig(benchmark_id, definition.settings(chosen)),
        images=chosen,
    )


@cache
def unavailable_reason(benchmark_id: str) -> str | None:
    """Why it cannot be played here, and the cure; None when it can.

    Blocks up to a second the first time, when a picture has to be tried.
    """
    return _definition(benchmark_id).unavailable()


def make(world: SimulatorConfig) -> Simulator:
    """Builds the simulator, in the process that is to run it."""
    if world.settings.get("adapter") == "gymnasium":
        from reference_sim.gymnasium import simulator

        return simulator.make(world.settings)
    return _definition(world.benchmark_id).make(world.settings)


def _definition(benchmark_id: str) -> BenchmarkDefinition:
    try:
        return _BENCHMARKS[benchmark_id]
    except KeyError:
        raise UnknownBenchmark(f"no benchmark {benchmark_id!r}") from None


def _choose_images(manifest: Json, images: Mapping[str, Any] | None) -> Json:
    codecs, sizes = manifest["image_codecs"], manifest["image_sizes"]
    if images is None:
        return {"codec": codecs[0], **sizes[0]}
    if images["codec"] not in codecs:
        raise InvalidChoice("/images/codec", f"offered are {', '.join(codecs)}")
    size = {"width": images["width"], "height": images["height"]}
    if size not in sizes:
        offered = ", ".join(f"{one['width']} × {one['height']}" for one in sizes)
        raise InvalidChoice("/images/width", f"offered are {offered}")
    return {"codec": images["codec"], **size}


_BENCHMARKS: dict[str, BenchmarkDefinition] = {
    **calibration.BENCHMARKS,
    **mobile_bimanual.BENCHMARKS,
    **question_answering.BENCHMARKS,
    **tabletop.BENCHMARKS,
}
