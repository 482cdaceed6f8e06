"""Turns of a benchmark, built from the spaces in its description.

The task, the instruction and the state are those with which an episode of the benchmark
begins, where a server gave them; else the state is zero. Images are black: a policy
server must answer them like any others. The benchmark is a response of `get_benchmark`;
the default is `calibration`.
"""

import base64
import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from conformance.oracle.calibration_benchmark import ACTIONS, SHAPE, STATES, spaces_of
from conformance.specification.tensor_formats import tensor_bytes

TIME = "2026-01-01T00:00:00Z"

TIMED = ("total", "queue", "simulate", "render", "encode")


@dataclass(frozen=True)
class Beginning:
    """How an episode begins. state: of the first observation; None makes it zero."""

    task: str
    instruction: str
    state: dict[str, Any] | None = None

    @classmethod
    def of(
        cls, benchmark: Mapping[str, Any], instruction: str | None = None
    ) -> "Beginning":
        """Raises ValueError where nothing says what the instruction is."""
        task = benchmark["tasks"][0]
        if instruction is None and benchmark["benchmark_id"] != "calibration":
            raise ValueError("a description has no instruction of an episode")
        return cls(task, instruction or f"Calibration task {task}.")


def calibration() -> dict[str, Any]:
    """Describe the benchmark `calibration` with the task `score` alone."""
    states = spaces_of(STATES)
    return {
        **SHAPE,
        "benchmark_id": "calibration",
        "title": "Calibration",
        "description": "No physics.",
        "manifest_sha256": "0" * 64,
        "tasks": ["score"],
        "max_chunk": 64,
        "image_sizes": [{"width": 16, "height": 12}],
        "image_codecs": ["raw"],
        "action_space": spaces_of(ACTIONS),
        "observation_space": {"state": states, "images": {}, "tensors": {}},
        "unavailable_reason": None,
    }


def episode(
    benchmark: Mapping[str, Any],
    index: int = 0,
    attempt: int = 1,
    beginning: Beginning | None = None,
) -> dict[str, Any]:
    """Give an EpisodeView of an episode that begins; by default one of calibration."""
    beginning = beginning or Beginning.of(benchmark)
    return {
        "episode_id": f"e{index:04d}",
        "index": index,
        "task": beginning.task,
        "instruction": beginning.instruction,
        "attempt": attempt,
        "step": 0,
        "max_steps": benchmark["max_steps"],
    }


def turn(
    benchmark: Mapping[str, Any],
    session_id: str,
    seq: int,
    view: Mapping[str, Any],
    state: Mapping[str, Any] | None = None,
) -> dict[str, Any]:
    """Give a Turn that shows the episode in `view`; state None is all zeros."""
    return {
        "session_id": session_id,
        "seq": seq,
        "episode": dict(view),
        "observation": _observation(benchmark, view["task"], state),
        "executed_steps": 0,
        "rewards": [],
        **dict.fromkeys(("stopped_early", "terminated", "truncated", "done"), False),
        "lease": {"expires_at": TIME, "idle_timeout_s": 60},
        "timing": {f"{part}_s": 0 for part in TIMED},
    }


def action_faults(benchmark: Mapping[str, Any], task: str, actions: Any) -> list[str]:
    """List how actions do not fit the benchmark.

    The same as a server refuses: PRED-013, PRED-014, PRED-015, PRED-016, PRED-017.
    """
    faults: list[str] = []
    if len(actions) > benchmark["max_chunk"]:
        faults.append(f"{len(actions)} actions, at most {benchmark['max_chunk']}")
    spaces = _of_task(benchmark, benchmark["action_space"], task)
    for index, action in enumerate(actions):
        values = action["values"]
        if set(values) != set(spaces):
            names = f"{sorted(values)}, not {sorted(spaces)}"
            faults.append(f"action {index} names {names}")
            continue
        for name, space in spaces.items():
            wrong = _faults(values, name, space)
            faults += [f"action {index}, {name}: {x}" for x in wrong]
    return faults


def _faults(values: Any, name: str, space: Mapping[str, Any]) -> list[str]:
    vector = values[name]
    if len(vector) != space["size"]:
        return [f"{len(vector)} numbers, not {space['size']}"]
    if space["out_of_range"] != "refuse":
        return []
    low = space.get("minimum", [-math.inf] * len(vector))
    high = space.get("maximum", [math.inf] * len(vector))
    pairs = zip(low, vector, high, strict=True)
    return [f"{x} is not in {a} … {b}" for a, x, b in pairs if not a <= x <= b]


def _of_task(
    benchmark: Mapping[str, Any], spaces: Mapping[str, Any], task: str
) -> dict[str, Any]:
    every = benchmark["tasks"]
    return {
        n: space for n, space in spaces.items() if task in space.get("tasks", every)
    }


def _observation(
    benchmark: Mapping[str, Any], task: str, state: Mapping[str, Any] | None
) -> dict[str, Any]:
    spaces = {
        kind: _of_task(benchmark, benchmark["observation_space"][kind], task)
        for kind in ("state", "images", "tensors")
    }
    size = benchmark["image_sizes"][0] if spaces["images"] else {}
    if state is None:
        state = {name: [0] * space["size"] for name, space in spaces["state"].items()}
    return {
        "state": dict(state),
        "images": {
            name: {
                "codec": "raw",
                **size,
                "channels": space["channels"],
                "data": _zeros(size["width"] * size["height"] * space["channels"]),
            }
            for name, space in spaces["images"].items()
        },
        "tensors": {
            name: {
                "dtype": space["dtype"],
                "shape": space["shape"],
                "data": _zeros(tensor_bytes(space)),
            }
            for name, space in spaces["tensors"].items()
        },
    }


def _zeros(size: int) -> str:
    return base64.b64encode(bytes(size)).decode()
