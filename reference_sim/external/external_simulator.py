"""Plays a program that speaks the simulator protocol as a `Simulator`.

Replies are checked here and never corrected: a reply that breaks a rule of
spec/simulator.md is a fault of the simulator.
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from reference_sim.external.program import Program
from reference_sim.external.simulator_messages import (
    OBSERVATION_EXTRA_BYTES,
    AliveCall,
    DigestCall,
    Digested,
    EpisodeBegun,
    ObserveCall,
    Observed,
    OfferedMemory,
    Pixels,
    ResetCall,
    StepCall,
    StepDone,
    StopCall,
    TensorValue,
)
from reference_sim.gymnasium.own_sources import DeclaredFiles
from reference_sim.interface import (
    Action,
    ChangedSource,
    Observation,
    ProgramFault,
    StepOutcome,
)
from reference_sim.shared_frame_buffer import FRAME_BUFFER

DTYPES = {
    name: np.dtype(name).newbyteorder("<")
    for name in (
        *("bool", "int8", "int16", "int32", "int64"),
        *("uint8", "uint16", "uint32", "uint64"),
        *("float16", "float32", "float64"),
    )
}


class ExternalSimulator:
    """`Simulator` of one program.

    files: those of its manifest. size: width and height of images.
    """

    def __init__(
        self, program: Program, files: DeclaredFiles, size: tuple[int, int]
    ) -> None:
        self._program, self._files = program, files
        self._benchmark = program.description.benchmark
        self._width, self._height = size
        self.stages: tuple[str, ...] = ()
        physical = self._benchmark.get("physical", {})
        self._watchdog_s = float(physical.get("watchdog_s", math.inf))
        self._heard_at = math.inf

    @property
    def is_physical(self) -> bool:
        """Whether it is a robot, which takes signals."""
        return "physical" in self._benchmark

    def signal(self, kind: str) -> None:
        """Send `stop` or `alive` to a robot; any thread may call it (SIM-029).

        The server sends `alive` while it waits: a chunk ends soon after a server that
        stands still (SIM-031).
        """
        self._heard_at = time.monotonic()
        if self.is_physical:
            self._program.signal(StopCall() if kind == "stop" else AliveCall())

    def reset(self, task: str, seed: int, split: str = "") -> str:
        """Raises TaskUnplayable if the program says so (SIM-013), and ChangedSource."""
        self._files.require_unchanged()
        space = self._benchmark["observation_space"]
        self._sizes = {
            name: vector["size"]
            for name, vector in space.get("state", {}).items()
            if task in vector.get("tasks", (task,))
        }
        self._images = _names_of(space.get("images", {}), task)
        self._tensors = _names_of(space.get("tensors", {}), task)
        self._steps, self._return = 0, 0.0
        self._task = task
        begun = self._program.request(
            ResetCall(task, seed, split), EpisodeBegun, f"`reset` of {task}"
        )
        self._state = self._checked(begun.state)
        self.stages = tuple(begun.stages)
        return begun.instruction

    def step(self, action: Action) -> StepOutcome:
        """Raises ProgramFault for numbers that no episode may have (SIM-016)."""
        if time.monotonic() - self._heard_at > self._watchdog_s:
            self._program.signal(StopCall())
        moment = f"`step` {self._steps + 1} of {self._task}"
        done = self._program.request(StepCall(action), StepDone, moment)
        self._state = self._checked(done.state)
        self._steps += 1
        self._return += done.reward
        score = done.score if self._benchmark.get("graded") else float(done.success)
        if score is None:
            raise self._program.fault("sent a step without its score")
        return StepOutcome(
            done.success, score, done.terminated, done.reward, done.stopped
        )

    def _checked(self, state: Mapping[str, list[float]]) -> Mapping[str, list[float]]:
        """The state, if it has its declared entries and sizes (SIM-015)."""
        sizes = {name: len(vector) for name, vector in state.items()}
        if sizes != self._sizes:
            changes = "; ".join(_differences(sizes, self._sizes))
            raise self._program.fault(
                f"sent another state than `observation_space.state` declares: {changes}"
            )
        for name, vector in state.items():
            if not all(map(math.isfinite, vector)):
                raise self._program.fault(f"sent a state {name!r} that is not finite")
        return state

    def observe(self) -> Observation:
        """The state of the last reply; images and tensors are asked for here."""
        state = {
            name: np.asarray(vector, np.float64) for name, vector in self._state.items()
        }
        if not self._images and not self._tensors:
            return Observation(state)
        spaces = self._benchmark["observation_space"]
        shapes = {
            name: (self._height, self._width, int(spaces["images"][name]["channels"]))
            for name in self._images
        }
        declared = {name: spaces["tensors"][name] for name in self._tensors}
        most = sum(map(math.prod, shapes.values())) + sum(
            math.prod(tensor["shape"]) * DTYPES[tensor["dtype"]].itemsize
            for tensor in declared.values()
        )
        offered = self._offer(shapes)
        memory = None
        if offered:
            places = {name: FRAME_BUFFER.place_of(offered[name]) for name in offered}
            offsets = {name: place[0] for name, place in places.items() if place}
            memory = OfferedMemory(*FRAME_BUFFER.file, offsets)
        seen = self._program.request(
            ObserveCall(self._images, self._tensors, self._width, self._height, memory),
            Observed,
            self._moment_of("observe"),
            reply_bytes_max=most + OBSERVATION_EXTRA_BYTES,
        )
        self._require_names("images", seen.images, shapes)
        self._require_names("tensors", seen.tensors, declared)
        return Observation(
            state,
            {
                name: self._image(name, seen.images[name], shape, offered.get(name))
                for name, shape in shapes.items()
            },
            {n: self._tensor(n, seen.tensors[n], declared[n]) for n in declared},
        )

    def _offer(
        self, shapes: Mapping[str, tuple[int, int, int]]
    ) -> dict[str, NDArray[np.uint8]]:
        """Arrays that the program and the server share; empty without such memory."""
        if not self._benchmark.get("shared_memory"):
            return {}
        arrays = {name: FRAME_BUFFER.allocate(*shape) for name, shape in shapes.items()}
        is_shared = all(map(FRAME_BUFFER.place_of, arrays.values()))
        return arrays if is_shared else {}

    def _require_names(
        self, kind: str, sent: Mapping[str, Any], wanted: Mapping[str, Any]
    ) -> None:
        if sent.keys() != wanted.keys():
            raise self._program.fault(
                f"sent the {kind} {sorted(sent)}, and {sorted(wanted)} were requested"
            )

    def _image(
        self,
        name: str,
        pixels: Pixels,
        shape: tuple[int, int, int],
        offered: NDArray[np.uint8] | None,
    ) -> NDArray[np.uint8]:
        """The pixels where they were received (SIM-017), or drawn (SIM-021)."""
        if offered is not None and pixels.data is None and pixels.shape == shape:
            return offered
        size = 0 if pixels.data is None else pixels.data.nbytes
        if pixels.data is None or pixels.shape != shape or size != math.prod(shape):
            raise self._program.fault(
                f"sent the image {name!r} as {pixels.shape} in {size} bytes, and "
                f"{shape} was requested"
            )
        return np.frombuffer(pixels.data, np.uint8).reshape(shape)

    def _tensor(
        self, name: str, tensor: TensorValue, declared: Mapping[str, Any]
    ) -> NDArray[np.generic]:
        """The tensor where it was received (SIM-018)."""
        shape, dtype = declared["shape"], declared["dtype"]
        size = math.prod(shape) * DTYPES[dtype].itemsize
        if (tensor.shape, tensor.dtype) != (shape, dtype) or tensor.data.nbytes != size:
            raise self._program.fault(
                f"sent the tensor {name!r} as {tensor.dtype} {tensor.shape} in "
                f"{tensor.data.nbytes} bytes, and declared {dtype} {shape}"
            )
        return np.frombuffer(tensor.data, DTYPES[dtype]).reshape(shape)

    def state_bytes(self) -> bytes:
        """The program's digest, or what stands for it: the state and the rewards."""
        if self._benchmark.get("digest"):
            moment = self._moment_of("digest")
            digested = self._program.request(DigestCall(), Digested, moment)
            return digested.digest  # SIM-020
        numbers = [number for _, v in sorted(self._state.items()) for number in v]
        return np.asarray([*numbers, self._steps, self._return]).tobytes()

    def _moment_of(self, call: str) -> str:
        """The moment of a call between two steps, for the text of a fault."""
        return f"`{call}` after {self._steps} steps of {self._task}"

    def close(self) -> None:
        self._program.close()


def _differences(sent: Mapping[str, int], declared: Mapping[str, int]) -> Iterator[str]:
    """How a state differs from its declaration: entries, or how many numbers."""
    for name in sorted(sent.keys() | declared.keys()):
        if name not in declared:
            yield f"{name} is not declared for this task"
        elif name not in sent:
            yield f"{name} is missing"
        elif sent[name] != declared[name]:
            yield f"{name} has {sent[name]} numbers, not {declared[name]}"


def _names_of(spaces: Mapping[str, Any], task: str) -> list[str]:
    return [n for n, space in spaces.items() if task in space.get("tasks", (task,))]


def make(
    settings: Mapping[str, Any], on_wait: Callable[[], None] = lambda: None
) -> ExternalSimulator:
    """Start the program of these settings, which described_benchmark makes.

    Raises ChangedSource and ProgramFault if it is not what the server has described,
    and SimulatorAway.
    """
    plan = settings["plan"]
    files_folder = Path(plan["folder"])
    DeclaredFiles(files_folder, plan["sources"]).require_unchanged()
    program = Program(
        plan["command"],
        plan["folder"],
        start_timeout_s=plan["start_timeout_s"],
        call_timeout_s=None,  # the server has the time of a turn
        away_timeout_s=plan["away_timeout_s"],
        on_wait=on_wait,
    )
    announced = program.description.benchmark.pop("sources", {})
    if changed := dict(set(announced.items()) ^ set(plan["announced"].items())):
        program.end()
        raise ChangedSource.of(sorted(changed))
    if program.description.benchmark != plan["benchmark"]:  # SIM-009
        program.end()
        raise ProgramFault(
            f"{program.name} describes another benchmark than when the server started: "
            "start the server again"
        )
    files = DeclaredFiles.present(files_folder, plan["announced"] | plan["sources"])
    return ExternalSimulator(program, files, (settings["width"], settings["height"]))
