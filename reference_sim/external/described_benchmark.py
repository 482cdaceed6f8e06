"""The benchmark that a program describes, completed by its entry in a TOML file."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Mapping, Sequence
from pathlib import Path

from pydantic import ValidationError

from reference_sim.definition import BenchmarkDefinition, Json, definition_of_plan
from reference_sim.external import socket_address
from reference_sim.external.description import (
    COMPLETED,
    ProgramDescription,
    read_description,
)
from reference_sim.external.external_simulator import make
from reference_sim.external.program import (
    AWAY_TIMEOUT_S,
    CALL_TIMEOUT_S,
    START_TIMEOUT_S,
    Program,
    is_file,
    program_name,
)
from reference_sim.external.simulator_messages import PROTOCOL
from reference_sim.external.tried_tasks import START_TRY_S, try_tasks
from reference_sim.gymnasium import BadBenchmark
from reference_sim.gymnasium.benchmark_file import (
    SEED_MAX,
    UNNAMED,
    Benchmark,
    faults_of,
    legal_id,
)
from reference_sim.gymnasium.own_sources import (
    hash_files,
    sha256_of,
)
from reference_sim.interface import ProgramFault, SimulatorAway, TaskUnplayable

ADAPTER = "external"
_MAX_ATTEMPTS = _MAX_FAULTS = 3
_NO_IMAGE_SIZE = [{"width": 64, "height": 64}]  # every run records a choice


def definition(
    benchmark: Benchmark,
    folder: Path,
    say: Callable[[str], None],
    try_s: float = START_TRY_S,
) -> tuple[str, BenchmarkDefinition]:
    """The id and the definition of an entry; starts the program to ask and try it.

    say: called with progress messages. try_s: how long its tasks are tried. Raises
    BadBenchmark.
    """
    command = benchmark.simulator
    assert command is not None
    name = program_name(command, str(folder))
    start_timeout_s = benchmark.start_timeout_s or START_TIMEOUT_S
    away_timeout_s = benchmark.away_timeout_s
    plan: Json = {
        "folder": str(folder),
        "start_timeout_s": start_timeout_s,
        "away_timeout_s": AWAY_TIMEOUT_S if away_timeout_s is None else away_timeout_s,
    }
    try:
        plan["command"] = _with_path(command, folder)
        if benchmark.cells:
            plan["cells"] = {
                cell: _with_path([address], folder)
                for cell, address in benchmark.cells.items()
            }
        program = Program(
            plan["command"],
            plan["folder"],
            start_timeout_s=start_timeout_s,
            call_timeout_s=max(CALL_TIMEOUT_S, benchmark.start_timeout_s or 0.0),
            away_timeout_s=start_timeout_s,
            on_wait=_Progress(say, command),
        )
        try:
            described = program.description.benchmark
            plan["benchmark"] = described
            plan["sources"] = _sources(command, benchmark.files, folder)
            declared = read_description(described)
            for member in declared.unknown_members():
                say(f"simulator {name}: its description has {member}")
            plan["announced"] = declared.sources
            described.pop("sources", None)
            complete = _completed(benchmark, described, folder)
            manifest = _manifest(complete, declared, plan, command)
            if declared.physical is None:  # a robot moves only when a person is ready
                for note in try_tasks(program, plan, manifest, try_s):
                    say(f"simulator {name}: {note}")
        finally:
            program.close()
        _require_equal_cells(plan, start_timeout_s)
    # A ValueError is of a declared file, or of what the program reports.
    except (ProgramFault, SimulatorAway, TaskUnplayable, ValueError) as error:
        raise BadBenchmark(f"simulator {name}: {error}") from error
    return complete.benchmark_id, definition_of_plan(
        ADAPTER,
        plan,
        manifest,
        make,
        seed_max=SEED_MAX,
        success_scored=not declared.graded and declared.physical is None,
        ray_resources=complete.ray_resources or {},
    )


def _require_equal_cells(plan: Json, timeout_s: float) -> None:
    """Raises ProgramFault unless every cell describes the benchmark of the first."""
    cells: Mapping[str, Sequence[str]] = plan.get("cells", {})
    others = {name: cell for name, cell in cells.items() if cell != plan["command"]}
    if cells and "physical" not in plan["benchmark"]:
        raise ProgramFault("it has cells, and declares no `physical`")
    for name, command in others.items():
        program = Program(
            command, plan["folder"], start_timeout_s=timeout_s, away_timeout_s=timeout_s
        )
        announced = program.description.benchmark
        program.close()
        if announced.pop("sources", {}) != plan["announced"]:
            raise ProgramFault(f"cell {name} has other sources than the first one")
        if announced != plan["benchmark"]:
            raise ProgramFault(
                f"cell {name} describes another benchmark than the first"
            )


def _with_path(command: Sequence[str], folder: Path) -> list[str]:
    """The command, with a program beside its file named by its whole path."""
    if socket_address.is_socket(command):
        return socket_address.resolve(command, folder)
    program = folder / command[0]
    is_path = "/" in command[0] or is_file(program)
    return [str(program) if is_path else command[0], *command[1:]]


class _Progress:
    """Says after three seconds, and then every ten, that a program is waited for."""

    def __init__(self, say: Callable[[str], None], command: Sequence[str]) -> None:
        self._say, self._command = say, command
        self._began_at, self._next_s = time.monotonic(), 3.0

    def __call__(self) -> None:
        spent_s = time.monotonic() - self._began_at
        if spent_s >= self._next_s:
            self._next_s += 10.0
            is_socket = socket_address.is_socket(self._command)
            doing = "waiting until it listens" if is_socket else "starting"
            self._say(f"simulator {self._command[0]}: {doing}, {spent_s:.0f} s so far")


def _completed(benchmark: Benchmark, described: Json, folder: Path) -> Benchmark:
    """The entry, with what the program says where the entry says nothing."""
    said = {name: described[name] for name in COMPLETED if name in described}
    stated = benchmark.model_fields_set
    if benchmark.benchmark_id == UNNAMED:
        stated = stated - {"benchmark_id"}
    said |= benchmark.model_dump(include=set(stated))
    name = program_name(benchmark.simulator or [""], str(folder))
    said.setdefault("benchmark_id", legal_id(Path(name).stem))
    try:
        return Benchmark.model_validate(said)
    except ValidationError as error:
        raise ProgramFault(f"its description: {faults_of(error)}") from error


def _manifest(
    complete: Benchmark,
    declared: ProgramDescription,
    plan: Json,
    command: Sequence[str],
) -> Json:
    """The manifest of Definition.describe, without max_chunk."""
    for split in complete.splits:
        if unknown := set(split.tasks or ()) - set(declared.tasks):
            raise ProgramFault(f"split {split.name}: no task {', '.join(unknown)}")
    described = plan["benchmark"]
    episodes = complete.episodes(declared.tasks)
    physical = declared.physical
    if physical is not None:
        episodes = physical.ordered(episodes)
    sealed = [split.name for split in complete.splits if split.is_sealed]
    space = described["observation_space"]
    sizes = [size.model_dump() for size in complete.image_sizes]
    if declared.observation_space.images and not sizes:
        raise ProgramFault("its description has images and no image_sizes")
    return {
        "benchmark_id": complete.benchmark_id,
        "version": complete.version,
        "title": complete.title or complete.benchmark_id,
        "description": complete.description or f"The simulator {complete.source}.",
        "episodes_total": len(episodes),
        "episodes": episodes,
        "tasks": declared.tasks,
        "splits": [split.name for split in complete.splits],
        **({"sealed_splits": sealed} if sealed else {}),
        "control_rate_hz": complete.control_rate_hz or 1.0,
        "max_steps": complete.max_steps or declared.max_steps,
        "max_attempts": _MAX_ATTEMPTS,
        "max_faults": complete.max_faults or _MAX_FAULTS,
        "success_rule": complete.success_rule or "any_step",
        "action_space": described["action_space"],
        "observation_space": {
            group: space.get(group, {}) for group in ("state", "images", "tensors")
        },
        "image_sizes": sizes or _NO_IMAGE_SIZE,
        "image_codecs": list(complete.image_codecs) if sizes else ["raw"],
        "simulator": {
            **described["simulator"],
            "protocol": PROTOCOL,
            # Where a program listens does not change what it plays.
            **({} if socket_address.is_socket(command) else {"command": list(command)}),
            "graded": declared.graded,
            "deterministic": declared.deterministic and physical is None,
            "sources": plan["announced"] | plan["sources"],
        },
        **({} if physical is None else {"physical": physical.manifest()}),
    }


def _sources(command: Iterable[str], files: Sequence[str], folder: Path) -> Json:
    """Name → SHA-256 of each file that the command names or the entry declares."""
    sources = hash_files(folder, files)
    for word in command:
        if is_file(folder / word):
            sources[word] = sha256_of(folder / word)
    return sources
