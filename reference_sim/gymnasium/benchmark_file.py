"""The user's description of a benchmark: a TOML file or a short reference.

Documented in docs/host/benchmarks.md. This module knows no environment; what a file
omits is completed by `check`, from the environment.
"""

from __future__ import annotations

import os
import re
import shlex
from collections.abc import Iterable, Iterator, Sequence
from itertools import chain
from pathlib import Path
from typing import Annotated, Any, Literal, Self

from pydantic import (
    BaseModel,
    BeforeValidator,
    ConfigDict,
    Field,
    ValidationError,
    ValidationInfo,
    field_validator,
    model_validator,
)

from reference_record.command_line.spelling import reason_of, unknown
from reference_record.command_line.text_file import read_text_file
from reference_record.command_line.toml_file import NotToml, read_toml_file
from reference_sim.gymnasium import BadBenchmark
from reference_sim.ray_resources import check_resources
from reference_sim.vector_spaces import RELATIVE_MODES, VectorPart, registered

BUNDLED_BENCHMARKS = {
    "metaworld_mt50": Path(__file__).parents[1] / "benchmarks/metaworld/benchmark.toml",
    "libero": Path(__file__).parents[1] / "external/libero/libero.toml",
}
_ID_LENGTH_MAX = 64
_DEFAULT_EPISODES = 10
# Keys that a program answers for itself, and keys that only a program has.
_OF_ENVIRONMENTS = {"modules", "kwargs", "tasks", "success", "ends_on_success"} | {
    *("score", "rebuild_every_episode", "camera", "action", "state")
}
_OF_SIMULATORS = {"cells", "start_timeout_s", "away_timeout_s"}
# Settings about simulators, which are not of one benchmark.
OF_THE_SERVER = ("turn_timeout_s", "max_simulators", "spare_simulators", "simulators")
SIMULATOR = "simulator:"  # before the command line of a program
SOCKET = "unix:"  # before the socket at which a program listens
UNNAMED = "simulator"  # the id of a program's benchmark until the program names it

BenchmarkId = Annotated[str, Field(pattern=r"^[a-z][a-z0-9_]{0,63}$")]
Name = Annotated[str, Field(min_length=1, max_length=200)]
Reference = Annotated[str, Field(pattern=r"^.+:[A-Za-z_][A-Za-z0-9_]*$")]
FAULTS_MAX = 1000
SEED_MAX = 2**32 - 1  # some environments take no larger one
Seed = Annotated[int, Field(ge=0, le=SEED_MAX)]
RayResources = Annotated[dict[str, float], BeforeValidator(check_resources)]
CellName = Annotated[str, Field(pattern=r"^[a-z0-9_]{1,20}$")]
MaxFaults = Annotated[int, Field(ge=1, le=FAULTS_MAX)]
PixelCount = Annotated[int, Field(ge=1, le=4096)]


class _Strict(BaseModel):
    model_config = ConfigDict(extra="forbid", strict=True, frozen=True)

    @model_validator(mode="before")
    @classmethod
    def _has_known_keys(cls, given: Any) -> Any:
        names = [] if not isinstance(given, dict) else given.keys() - cls.model_fields
        faults = [_unknown_key(name, cls.model_fields) for name in sorted(names)]
        if faults:
            raise ValueError("; ".join(faults))
        return given


def _unknown_key(name: str, names: Iterable[str]) -> str:
    if name in OF_THE_SERVER:
        option = f"--{name.replace('_', '-')}"
        return f"{name} is a setting of the server ({option}), and no key of this file"
    return unknown("key", name, names)


class Task(_Strict):
    """kwargs: of the environment, added to the benchmark's. reset_options: `options`
    of its reset."""

    name: Name
    instruction: str = Field(min_length=1)
    kwargs: dict[str, Any] = {}
    reset_options: dict[str, Any] | None = None


class Split(_Strict):
    """Every task with every seed. seeds: a list, or first_seed and episodes.

    sealed: the host draws the seeds in secret; by default, in a split `test` that names
    none.
    """

    name: Name
    seeds: list[Seed] = []
    first_seed: Seed | None = None
    episodes: Annotated[int, Field(ge=1, le=100_000)] | None = None
    tasks: list[str] | None = None
    sealed: bool | None = None

    @model_validator(mode="after")
    def _has_seeds(self) -> Self:
        if bool(self.seeds) == (self.episodes is not None):
            raise ValueError(
                "give either seeds = [...] or episodes = N (and first_seed)"
            )
        if len(set(self.seeds)) < len(self.seeds):
            raise ValueError("seeds has a number twice")
        if self.sealed and self.names_seeds:
            raise ValueError("sealed = true takes episodes = N alone, and no seeds")
        return self

    @property
    def names_seeds(self) -> bool:
        return bool(self.seeds) or self.first_seed is not None

    @property
    def is_sealed(self) -> bool:
        if self.sealed is None:
            return self.name == "test" and not self.names_seeds
        return self.sealed

    def all_seeds(self) -> list[int]:
        if self.episodes is None:
            return self.seeds
        first = self.first_seed or 0
        return list(range(first, first + self.episodes))


class Success(_Strict):
    """When the goal condition holds, after a step. Exactly one member.

    info: a key of the step's `info`. function: FILE.py:NAME or MODULE:NAME, called with
    (environment, info). return_at_least: of the sum of rewards so far.
    """

    info: Name | None = None
    reward_at_least: float | None = None
    return_at_least: float | None = None
    terminated: Literal[True] | None = None
    function: Reference | None = None

    @model_validator(mode="after")
    def _has_one_member(self) -> Self:
        members = list(type(self).model_fields)
        if len(self.given()) != 1:
            raise ValueError(f"give exactly one of {', '.join(members)}")
        return self

    def given(self) -> dict[str, Any]:
        return self.model_dump(exclude_none=True)


class ReturnScore(_Strict):
    """The sum of rewards, as a share of the way between two returns."""

    return_from: float
    return_to: float

    @model_validator(mode="after")
    def _is_ascending(self) -> Self:
        if not self.return_from < self.return_to:
            raise ValueError("return_from must be less than return_to")
        return self


class Camera(_Strict):
    """The image of `render`. upside_down: rotated by 180° before it is sent."""

    name: Name = "render"
    upside_down: bool = False


class ImageSize(_Strict):
    width: PixelCount
    height: PixelCount


class PartConvention(_Strict):
    """Conventions that Gymnasium cannot express; see schema VectorPart."""

    unit: str | None = None
    scale: float | None = None
    quantity: str | None = None
    meaning: str | None = None
    frame: str | None = None
    rotation: str | None = None
    relative_to: str | None = None
    gripper_open: float | None = None
    gripper_closed: float | None = None

    @model_validator(mode="before")
    @classmethod
    def _is_of_today(cls, given: Any) -> Any:
        if isinstance(given, dict) and "relative" in given:
            raise ValueError(
                f"relative: now {' or '.join(map(repr, RELATIVE_MODES))} as relative_to"
            )
        if isinstance(given, dict) and "," in str(given.get("unit")):
            raise ValueError("unit: several units need parts, each with its unit")
        return given

    @field_validator("unit", "quantity", "frame", "rotation", "relative_to")
    @classmethod
    def _is_registered(cls, value: str | None, info: ValidationInfo) -> str | None:
        assert info.field_name is not None
        return None if value is None else registered(info.field_name, value)

    def part(self, name: str, size: int) -> VectorPart:
        """The part of `size` numbers. Raises ValueError for a part that cannot be.

        A member that the file does not state is unspecified.
        """
        is_other = self.quantity not in (None, "unspecified", "orientation")
        return VectorPart(
            name=name,
            size=size,
            quantity=self.quantity or "unspecified",
            unit=self.unit or "unspecified",
            frame=self.frame or "unspecified",
            rotation=self.rotation or ("none" if is_other else "unspecified"),
            relative_to=self.relative_to or "unspecified",
            scale=self.scale,
            gripper_open=self.gripper_open,
            gripper_closed=self.gripper_closed,
            description=self.meaning,
        )


class NamedPart(PartConvention):
    """size: how many numbers; parts follow one another in the order of the file."""

    size: Annotated[int, Field(ge=1)]


class Convention(PartConvention):
    """The conventions of a vector: of all its numbers, or of each of its parts."""

    parts: Annotated[dict[Name, NamedPart], Field(min_length=1)] | None = None

    @model_validator(mode="after")
    def _has_conventions_once(self) -> Self:
        if self.parts is not None and (given := self._of_all()):
            raise ValueError(f"{', '.join(sorted(given))}: say it of each of the parts")
        return self

    def _of_all(self) -> set[str]:
        """The members that are about all numbers of the vector."""
        return {*self.model_dump(exclude_none=True)} - {"parts", "meaning"}

    def declared_parts(self, size: int) -> tuple[VectorPart, ...] | None:
        """The parts of a vector of `size` numbers; None if the file states none.

        Raises ValueError if they are not parts of such a vector.
        """
        if self.parts is None:
            if not self._of_all():
                return None
            return (self.model_copy(update={"meaning": None}).part("all", size),)
        total = sum(part.size for part in self.parts.values())
        if total != size:
            raise ValueError(f"its parts have {total} numbers, the vector has {size}")
        return tuple(part.part(name, part.size) for name, part in self.parts.items())


class Benchmark(_Strict):
    """A complete file. None and empty members are completed from the environment."""

    benchmark_id: BenchmarkId
    version: Name = "1"
    title: str = ""
    description: str = ""
    environment: Name | None = None
    made_by: Reference | None = None
    simulator: Annotated[list[str], Field(min_length=1)] | None = None
    cells: dict[CellName, str] = {}
    start_timeout_s: Annotated[float, Field(gt=0, le=3600)] | None = None
    away_timeout_s: Annotated[float, Field(ge=0, le=3600)] | None = None
    modules: list[str] = []
    files: list[str] = []
    kwargs: dict[str, Any] = {}
    tasks: list[Task] = []
    splits: list[Split] = [Split(name="test", episodes=_DEFAULT_EPISODES)]
    max_steps: Annotated[int, Field(ge=1)] | None = None
    max_faults: MaxFaults | None = None
    control_rate_hz: Annotated[float, Field(gt=0, allow_inf_nan=False)] | None = None
    success: Success | None = None
    success_rule: Literal["any_step", "last_step"] | None = None
    ends_on_success: bool | None = None
    score: Literal["success"] | ReturnScore = "success"
    rebuild_every_episode: bool = False
    camera: Camera | Literal[False] | None = None
    image_sizes: list[ImageSize] = []
    image_codecs: Annotated[
        list[Literal["raw", "png", "jpeg"]], Field(min_length=1)
    ] = ["raw", "png", "jpeg"]
    action: dict[str, Convention] = {}
    state: dict[str, Convention] = {}
    ray_resources: RayResources | None = None

    @model_validator(mode="before")
    @classmethod
    def _has_its_first_cell(cls, given: Any) -> Any:
        """`simulator` is the first of several cells, unless it is there."""
        cells = given.get("cells") if isinstance(given, dict) else None
        if isinstance(cells, dict) and cells and "simulator" not in given:
            return {**given, "simulator": [next(iter(cells.values()))]}
        return given

    @model_validator(mode="after")
    def _has_cells_of_robots(self) -> Self:
        if not all(address.startswith(SOCKET) for address in self.cells.values()):
            raise ValueError(f'cells: each is "{SOCKET}PATH"')
        return self

    @model_validator(mode="after")
    def _is_consistent(self) -> Self:
        makers = (self.environment, self.made_by, self.simulator)
        if makers.count(None) != len(makers) - 1:
            raise ValueError(
                'give one of environment = "ID", made_by = "FILE.py:NAME" and '
                'simulator = ["PROGRAM", …]'
            )
        others = _OF_SIMULATORS if self.simulator is None else _OF_ENVIRONMENTS
        if misplaced := sorted(others & self.model_fields_set):
            source = "an environment" if self.simulator is None else "a simulator"
            raise ValueError(f"{', '.join(misplaced)}: not a key of {source}")
        names = [task.name for task in self.tasks]
        if len(set(names)) < len(names):
            raise ValueError("two tasks have the same name")
        if len({split.name for split in self.splits}) < len(self.splits):
            raise ValueError("two splits have the same name")
        for split in self.splits:
            for name in split.tasks or ():
                if name not in names and self.simulator is None:
                    raise ValueError(
                        f"split {split.name}: {unknown('task', name, names)}"
                    )
        if (
            self.success
            and self.success.return_at_least is not None
            and self.success_rule == "any_step"
        ):
            raise ValueError(
                "return_at_least is known at the end only: success_rule is last_step"
            )
        return self

    @property
    def source(self) -> str:
        return self.environment or self.made_by or shlex.join(self.simulator or ())

    def episodes(self, tasks: Sequence[str]) -> list[dict[str, Any]]:
        """Split by split, task by task, so that worlds are seldom rebuilt."""
        return [
            {"task": task, "split": split.name, "seed": seed}
            for split in self.splits
            for task in tasks
            if split.tasks is None or task in split.tasks
            for seed in split.all_seeds()
        ]


def read(reference: str) -> Iterator[tuple[Benchmark, Path]]:
    """The benchmarks that a reference names, each with the folder of its own files.

    `gymnasium:ID`, FILE.toml, FOLDER, FILE.py:CLASS, or one of READY. Raises
    BadBenchmark.
    """
    place, _, name = reference.rpartition(":")
    if reference in BUNDLED_BENCHMARKS:
        yield from _read_file(BUNDLED_BENCHMARKS[reference])
    elif reference.startswith((SIMULATOR, SOCKET)):
        command = shlex.split(reference.removeprefix(SIMULATOR))
        yield Benchmark(benchmark_id=UNNAMED, simulator=command), Path.cwd()
    elif reference.startswith("gymnasium:") and name:
        yield _registered(reference.partition(":")[2]), Path.cwd()
    elif place.endswith(".py") and name.isidentifier():
        path = Path(place).absolute()
        made_by = f"{path.name}:{name}"
        yield (
            Benchmark(benchmark_id=legal_id(name), title=name, made_by=made_by),
            path.parent,
        )
    elif files := benchmark_files(reference):
        yield from chain.from_iterable(map(_read_file, files))
    elif Path(reference).is_dir():
        raise BadBenchmark(f"{reference}: no file *.toml is in this folder")
    else:
        raise BadBenchmark(
            f"{reference}: unknown benchmark reference; {_advice(reference)}"
        )


def benchmark_files(reference: str) -> Sequence[Path]:
    """The file, or those of the folder, that a reference names; none for a class."""
    path = Path(reference).absolute()
    if path.suffix == ".toml":
        return [path]
    return sorted(path.glob("*.toml"))


def _advice(reference: str) -> str:
    """The reference to write instead of a word that names no benchmark."""
    path = Path(reference)
    if path.suffix == ".py":
        text = read_text_file(path) if path.is_file() else ""
        name = re.search(r"^class (\w+)", text, re.MULTILINE)
        return f"name the class, too: {reference}:{name[1] if name else 'CLASS'}"
    if path.is_file() and os.access(path, os.X_OK):
        return f"a program is given as --simulator {reference}"
    return (
        "expected gymnasium:ID, FILE.toml, a folder of such files, FILE.py:CLASS, "
        f"FILE.jsonl, unix:SOCKET or {', '.join(BUNDLED_BENCHMARKS)}"
    )


def _registered(name: str) -> Benchmark:
    """Gymnasium's own notation: `MODULE:ID` imports the module first."""
    module, _, environment = name.rpartition(":")
    try:
        return Benchmark(
            benchmark_id=legal_id(environment),
            title=environment,
            environment=environment,
            modules=[module] if module else [],
        )
    except ValidationError as error:
        raise BadBenchmark(f"gymnasium:{name}: {faults_of(error)}") from error


def _read_file(path: Path) -> Iterator[tuple[Benchmark, Path]]:
    """The benchmark of a file, or each of its `[[benchmarks]]`.

    The keys above them are those of each benchmark that does not have its own.
    """
    try:
        content = read_toml_file(path)
    except NotToml as error:
        raise BadBenchmark(str(error)) from error
    entries = content.pop("benchmarks", None)
    if entries is None:
        content.setdefault("benchmark_id", legal_id(path.stem))
        entries = [{}]
    elif not isinstance(entries, list) or not all(isinstance(e, dict) for e in entries):
        raise BadBenchmark(f"{path}: write each benchmark as a table [[benchmarks]]")
    for number, entry in enumerate(entries):
        members = content | entry
        if "simulator" in members:
            members.setdefault("benchmark_id", UNNAMED)
        place = f"benchmarks[{number}]: " if entry else ""
        try:
            yield Benchmark.model_validate(members), path.parent
        except ValidationError as error:
            raise BadBenchmark(f"{path}: {place}{faults_of(error)}") from error


def faults_of(error: ValidationError) -> str:
    """Every fault with its path, as `tasks[1].name: Field required`."""
    faults = []
    for fault in error.errors(include_url=False):
        path = "".join(
            f"[{part}]" if isinstance(part, int) else f".{part}"
            for part in fault["loc"]
        ).removeprefix(".")
        text = reason_of(fault)
        faults.append(f"{path}: {text}" if path else text)
    return "; ".join(faults)


def legal_id(name: str) -> str:
    """A benchmark id made of an environment's: `ALE/Pong-v5` is `ale_pong_v5`."""
    words = re.sub(r"[^a-z0-9]+", "_", name.lower()).strip("_")
    if not words or not words[0].isalpha():
        words = f"env_{words}".rstrip("_")
    return words[:_ID_LENGTH_MAX]
