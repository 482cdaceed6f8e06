"""Checks an environment before its benchmark is registered.

Runs in its own process (started by registration), because an environment may hang or
end its process. Plays a few steps of every task: the same seed twice with another one
between, which detects an ignored seed and state that leaks into the next episode. Each
fault and each warning is one line.
"""

from __future__ import annotations

import json
import os
import random
import re
import sys
import time
import traceback
import warnings
from collections.abc import Callable, Mapping
from collections.abc import Set as AbstractSet
from dataclasses import replace
from pathlib import Path
from typing import TypeAlias

import numpy as np

from reference_record.command_line.installation import how_to_install
from reference_sim.definition import Json
from reference_sim.gymnasium import entries, environments
from reference_sim.gymnasium.benchmark_file import Benchmark
from reference_sim.gymnasium.entries import Entry
from reference_sim.gymnasium.manifest_plan import PlanDraft, Unsettled
from reference_sim.gymnasium.own_sources import OWN_SOURCES, observe_reads, with_place
from reference_sim.gymnasium.simulator import GymnasiumSimulator
from reference_sim.interface import WrongReport

SEED, OTHER_SEED = 20, 21
STEPS = 12  # of each short trajectory
_PLAY_ON_S = 5.0  # longest time that the end of an episode is waited for

# The observation at each step of an episode: name → bytes.
Trajectory: TypeAlias = list[dict[str, bytes]]


class TaskFault(Exception):
    """The task is not usable; the text says why, in one line."""


# Errors whose text says all; every other one is the environment's.
_EXPECTED = (
    TaskFault,
    environments.EnvironmentUnavailable,
    entries.UnsupportedSpace,
    Unsettled,
    WrongReport,
)


class BenchmarkCheck:
    """Checks one benchmark, task by task.

    files_read: the files in the folder that this process has opened; it may grow.
    """

    def __init__(
        self,
        benchmark: Benchmark,
        folder: Path,
        report_progress: Callable[[str], None],
        files_read: AbstractSet[str] = frozenset(),
    ) -> None:
        self._draft = PlanDraft(benchmark, folder)
        self._folder, self._files_read = folder, files_read
        self._report_progress = report_progress
        self._findings: dict[str, dict[str, list[str]]] = {"faults": {}, "warnings": {}}
        self._tracebacks: list[str] = []
        self._observed: list[Entry] = []
        self._actions: list[Entry] = []
        self._outside: dict[str, str] = {}
        self._frame: tuple[int, int] | None = None
        self._steps_played, self._play_s = 0, 0.0

    def run(self) -> Json:
        """faults, warnings, notes: lines; without faults, also what `settle` gives.

        tracebacks: of what the environment raised.
        """
        draft = self._draft
        OWN_SOURCES.record(self._folder)
        self._report_progress(f"importing {draft.benchmark.source}")
        try:
            draft.begin()
        except BaseException as error:  # noqa: BLE001 - it runs what the user wrote
            return self._report({self._line_of(error): [""]})
        names = [task["name"] for task in draft.tasks]
        for number, name in enumerate(names):
            self._report_progress(f"task {name} ({number + 1} of {len(names)})")
            try:
                self._check_task(name)
            except BaseException as error:  # noqa: BLE001 - so does this
                self._add_finding("faults", name, self._line_of(error))
            if self._findings["faults"] and number == 0:
                break  # the other tasks would fail alike
        if self._findings["faults"]:
            return self._report(self._findings["faults"])
        for name, example in self._outside.items():
            self._add_finding(
                "warnings", "", f"{example}; its bounds are omitted from the manifest"
            )
            self._observed = [
                _unbounded(e) if e.name == name else e for e in self._observed
            ]
        try:
            settled = draft.settle(self._actions, self._observed, self._frame)
        except (Unsettled, entries.UnsupportedSpace) as unsettled:
            return self._report({str(unsettled): [""]})
        self._warn_of_undeclared_files(settled["manifest"]["simulator"]["sources"])
        pace = self._steps_played / max(self._play_s, 1e-9)
        return (
            self._report({})
            | settled
            | {"notes": [*draft.notes, f"{pace:.0f} steps/s"]}
        )

    def _warn_of_undeclared_files(self, declared: Mapping[str, str]) -> None:
        for name in sorted(self._files_read - declared.keys()):
            self._draft.warnings.append(
                f"reads {name}, which is not in the manifest, so a change of it is not "
                f"noticed: name it in a benchmark file, files = [{json.dumps(name)}]"
            )

    def _add_finding(self, kind: str, task: str, text: str) -> None:
        self._findings[kind].setdefault(text, []).append(task)

    def _report(self, faults: Mapping[str, list[str]]) -> Json:
        warned = dict(self._findings["warnings"])
        warned |= {text: [""] for text in self._draft.warnings}
        return {
            "faults": _lines(faults),
            "warnings": _lines(warned),
            "tracebacks": self._tracebacks,
        }

    def _line_of(self, error: BaseException) -> str:
        """The fault in one line; a traceback of the environment is kept."""
        if not isinstance(error, (environments.NotAnEnvironment, *_EXPECTED)):
            self._tracebacks.append("".join(traceback.format_exception(error)))
        return _line(error)

    # One task

    def _check_task(self, task: str) -> None:
        simulator = GymnasiumSimulator(self._draft.plan)
        try:
            first = self._record_trajectory(simulator, task, SEED)
            self._read_spaces(simulator, task)
            simulator.read_success()
            second = self._record_trajectory(simulator, task, OTHER_SEED)
            again = self._record_trajectory(simulator, task, SEED)
            if (difference := _difference(first, again)) is not None:
                self._explain(simulator, task, first, difference)
            if _difference(first, second) is None:
                self._add_finding("warnings", task, "every seed gives the same episode")
            self._find_success(simulator, task)
        finally:
            simulator.close()

    def _record_trajectory(
        self, simulator: GymnasiumSimulator, task: str, seed: int
    ) -> Trajectory:
        """A short episode with actions that are the same for every seed."""
        # An environment that draws from the global generators must not be saved by us.
        random.seed()
        np.random.seed()  # noqa: NPY002 - it is theirs
        simulator.reset(task, seed)
        trajectory = [self._record_step(simulator)]
        rng = np.random.default_rng(0)
        began = time.perf_counter()
        for _ in range(STEPS):
            outcome = simulator.step(_some_action(simulator.actions, rng))
            reward = {"reward": np.float64(outcome.reward).tobytes()}
            trajectory.append(self._record_step(simulator) | reward)
            self._steps_played += 1
            if simulator.over:
                break
        self._play_s += time.perf_counter() - began
        return trajectory

    def _record_step(self, simulator: GymnasiumSimulator) -> dict[str, bytes]:
        shown: dict[str, bytes] = {}
        for part in simulator.observation_parts().values():
            shown |= {f"observation {name!r}": a.tobytes() for name, a in part.items()}
        for entry, value in simulator.leaves():
            array = np.asarray(value)
            if entry.kind != "state" and array.dtype != entry.dtype:
                raise TaskFault(
                    f"the observation {entry.name!r} is of {array.dtype}, its space of "
                    f"{entry.dtype}"
                )
            outside = (array < entry.low) | (array > entry.high)
            if outside.any() and entry.name not in self._outside:
                at = np.argwhere(outside)[0]
                where = f"[{', '.join(map(str, at))}]" if at.size else ""
                number, low, high = (
                    float(a[tuple(at)]) for a in (array, entry.low, entry.high)
                )
                self._outside[entry.name] = (
                    f"the observation {entry.name!r}{where} is {number:g}, outside its "
                    f"bounds {low:g} … {high:g}"
                )
        return shown

    def _read_spaces(self, simulator: GymnasiumSimulator, task: str) -> None:
        """Spaces, which must be equal in all tasks; the camera, from the first task."""
        if not self._actions:
            self._actions, self._observed = simulator.actions, simulator.observed
            self._draft.read_environment(simulator)
            if self._draft.plan["camera"] is not None:
                self._frame = self._draft.try_camera(simulator)
            return
        if not entries.same(self._actions, simulator.actions):
            raise TaskFault("its action space differs from that of the first task")
        self._observed = entries.joined(self._observed, simulator.observed)

    def _explain(
        self,
        simulator: GymnasiumSimulator,
        task: str,
        first: Trajectory,
        difference: str,
    ) -> None:
        """The same seed gave two episodes. Raises TaskFault with the likely cause."""
        simulator.close()  # the next reset makes it anew
        fresh = self._record_trajectory(simulator, task, SEED)
        if _difference(first, fresh) is None:
            raise TaskFault(
                f"state leaks between episodes ({difference}): set "
                "rebuild_every_episode = true"
            )
        raise TaskFault(
            f"reset(seed={SEED}) is not deterministic ({difference}), so scores are "
            "not reproducible"
        )

    def _find_success(self, simulator: GymnasiumSimulator, task: str) -> None:
        """Continues until the declared key is in `info`, at most to the end."""
        key = self._draft.plan["success"].get("info")
        if key is None or key in simulator.info:
            return
        rng = np.random.default_rng(1)
        simulator.reset(task, SEED)
        until = time.perf_counter() + _PLAY_ON_S
        for _ in range(self._draft.plan["max_steps"]):
            simulator.step(_some_action(simulator.actions, rng))
            if key in simulator.info:
                return
            if simulator.over or time.perf_counter() > until:
                break
        offered = ", ".join(map(str, simulator.info)) or "nothing"
        raise TaskFault(f"info has no key {key!r} after a step; it has {offered}")


def _some_action(
    actions: list[Entry], rng: np.random.Generator
) -> dict[str, list[float]]:
    """A random action: within the bounds, or within a range of 2 if unbounded."""
    chosen: dict[str, list[float]] = {}
    for entry in actions:
        low = np.where(np.isinf(entry.low), np.minimum(entry.high, 1) - 2, entry.low)
        high = np.where(np.isinf(entry.high), np.maximum(low, -1) + 2, entry.high)
        numbers = rng.uniform(low, high + 1 if entry.whole else high)
        if entry.whole:
            numbers = np.minimum(np.floor(numbers), high)
        chosen[entry.name] = np.asarray(numbers, np.float64).ravel().tolist()
    return chosen


def _difference(first: Trajectory, second: Trajectory) -> str | None:
    """The first difference of two trajectories, as text; None if they are equal."""
    for step, (a, b) in enumerate(zip(first, second, strict=False)):
        for name in a:
            if a[name] != b.get(name):
                return f"the {name} differs at step {step}"
    return None if len(first) == len(second) else "one of them ends earlier"


def _unbounded(entry: Entry) -> Entry:
    nothing = np.full(entry.shape, np.inf)
    return replace(entry, low=-nothing, high=nothing)


def _line(error: BaseException) -> str:
    if isinstance(error, environments.NotAnEnvironment):
        return str(error)  # its lines are to be copied
    words = " ".join(str(error).split())[:300]
    if isinstance(error, _EXPECTED):
        return words
    return with_place(f"{type(error).__name__}: {words}", error)


def _lines(said: Mapping[str, list[str]]) -> list[str]:
    """One line for each text, with the tasks that it applies to."""
    lines = []
    for text, tasks in said.items():
        more = f" (and {len(tasks) - 1} more)" if len(tasks) > 1 else ""
        line = f"task {tasks[0]}{more}: {text}" if tasks[0] else text
        lines.append(line + _cure(text))
    return lines


def _cure(text: str) -> str:
    """Gymnasium says how it is installed, but not where."""
    needed = re.search(r"is not installed.*(gymnasium\[[a-z0-9-]+\])", text)
    return "" if needed is None else f"; here: {how_to_install(repr(needed[1]))}"


def main() -> None:
    """Standard input: the benchmark; standard output: lines of JSON, `doing` or
    `found`. Prints of the environment go to the standard error."""
    ours = os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(2, 1)
    request = json.load(sys.stdin)
    benchmark = Benchmark.model_validate_json(json.dumps(request["benchmark"]))

    def send(message: Json) -> None:
        ours.write(f"{json.dumps(message)}\n")
        ours.flush()

    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        folder = Path(request["folder"])
        check = BenchmarkCheck(
            benchmark, folder, lambda t: send({"doing": t}), observe_reads(folder)
        )
        send({"found": check.run()})


if __name__ == "__main__":
    main()
