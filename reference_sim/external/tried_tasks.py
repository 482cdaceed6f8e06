"""Plays the beginning of each task of a described benchmark before it is offered.

So a host sees a fault before a user does. An episode is played twice with another one
between, as SIM-011 and the check of Gymnasium environments have it.
"""

from __future__ import annotations

import hashlib
import math
import random
import time
from collections.abc import Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass, field
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np

from reference_sim.definition import Json
from reference_sim.external.external_simulator import ExternalSimulator
from reference_sim.external.program import Program
from reference_sim.external.simulator_messages import (
    EpisodeBegun,
    Reply,
    StepDone,
    unknown_members,
)
from reference_sim.gymnasium.own_sources import DeclaredFiles
from reference_sim.interface import Action, ProgramFault, TaskUnplayable, stages_of

STEPS = 12  # of each episode
START_TRY_S = 5.0  # the start of a server takes so much longer, and a step, at most

# One map for each step of an episode: name → what is shown
Trajectory = list[dict[str, object]]


def try_tasks(
    program: Program, plan: Json, manifest: Json, within_s: float
) -> Iterator[str]:
    """Yields what a host should know. Raises ProgramFault, TaskUnplayable, WrongReport.

    within_s: when it has passed, no other step is played but the first one of all.
    """
    size = manifest["image_sizes"][0]
    files = DeclaredFiles(Path(plan["folder"]), plan["sources"])
    simulator = ExternalSimulator(program, files, (size["width"], size["height"]))
    trial = _Trial(program, simulator, manifest, time.monotonic() + within_s)
    is_deterministic = plan["benchmark"].get("deterministic", True)
    tasks = manifest["tasks"]
    for number, task in enumerate(tasks):
        if number and trial.is_over():
            yield (
                f"{number} of {len(tasks)} tasks were tried in {within_s:g} s; `python "
                "-m reference_sim.gymnasium check` with its file tries all of them"
            )
            break
        if number and not trial.has_episodes(task):
            continue
        try:
            trial.try_task(task, is_deterministic=is_deterministic)
        except TaskUnplayable as error:
            if not number:
                raise
            yield f"{error}; the other tasks are played all the same"
    yield from trial.notes()


@dataclass(slots=True)
class _Trial:
    program: Program
    simulator: ExternalSimulator
    manifest: Json
    until: float
    # Members of replies that are ignored; task → seeds that begin alike.
    ignored: dict[str, None] = field(default_factory=dict, init=False)
    alike: dict[str, list[int]] = field(default_factory=dict, init=False)

    def is_over(self) -> bool:
        return time.monotonic() > self.until

    def has_episodes(self, task: str) -> bool:
        return any(one["task"] == task for one in self.manifest["episodes"])

    def notes(self) -> Iterator[str]:
        yield from self.ignored
        if self.alike:
            first, seeds = next(iter(self.alike.items()))
            yield (
                f"seeds begin alike, as {seeds[0]} and {seeds[1]} of {first}, in all "
                f"that is observed up to the first step of {', '.join(self.alike)}: "
                "does its `reset` use the seed? If it is meant so, give each split one "
                "seed: more are copies of one episode"
            )

    def try_task(self, task: str, *, is_deterministic: bool) -> None:
        """Raises ProgramFault where an episode is another one when it is repeated."""
        episode, other = self._episodes_of(task)
        first = self._play(episode)
        self._note_ignored_members()
        if self.is_over():
            return
        seeds = [episode["seed"]]
        if other is not None:
            with suppress(TaskUnplayable):  # as a task with other seeds than these may
                second = self._play(other)
                seeds.append(other["seed"])
                if second[:2] == first[:2]:
                    self.alike[task] = seeds
        if not is_deterministic or self.is_over():
            return
        if (difference := _difference(first, self._play(episode))) is not None:
            between = " with another episode between" * (len(seeds) > 1)
            raise ProgramFault(
                f"{task} with the seed {seeds[0]} was played twice{between}, and "
                f"{difference}: does it draw without the seed, or keep state of the "
                "episode before? A simulator that cannot repeat an episode declares "
                "`deterministic` false (SIM-011)"
            )

    def _episodes_of(self, task: str) -> tuple[Json, Json | None]:
        """One of the task, and another one of its split, if there is any."""
        episodes = [one for one in self.manifest["episodes"] if one["task"] == task]
        for one, another in pairwise(episodes):
            if one["split"] == another["split"]:
                return one, another
        split = self.manifest["splits"][0]
        return next(iter(episodes), {"task": task, "split": split, "seed": 0}), None

    def _play(self, episode: Json) -> Trajectory:
        """The first steps, with the same actions for every seed; one at least."""
        task = episode["task"]
        begun = self.simulator.reset(task, episode["seed"], episode["split"])
        stages = stages_of(self.simulator)
        shown = [{"instruction": begun, "stages": stages, **self._observed()}]
        for step in range(min(STEPS, self.manifest["max_steps"])):
            if step and self.is_over():
                break
            action = _some_action(self.manifest["action_space"], task, step)
            outcome = self.simulator.step(action)
            shown.append({"verdict": outcome, **self._observed()})
            if outcome.terminated or outcome.success:
                break
        return shown

    def _observed(self) -> dict[str, object]:
        seen = self.simulator.observe()
        parts = {"state": seen.state, "image": seen.images, "tensor": seen.tensors}
        shown: dict[str, object] = {}
        for kind, arrays in parts.items():
            for name, array in arrays.items():
                data = np.asarray(array).tobytes()
                shown[f"{kind} {name!r}"] = hashlib.sha256(data).digest()
        return shown | {"digest": self.simulator.state_bytes()}

    def _note_ignored_members(self) -> None:
        """Those of the first replies of an episode."""
        kinds: Mapping[str, type[Reply]] = {"reset": EpisodeBegun, "step": StepDone}
        for call, kind in kinds.items():
            for unknown in unknown_members(self.program.latest.get(kind, b""), kind):
                self.ignored[f"`{call}` returns {unknown}"] = None


def _difference(first: Trajectory, again: Trajectory) -> str | None:
    """The first difference of two trajectories; None if one begins the other."""
    for step, (one, another) in enumerate(zip(first, again, strict=False)):
        for name in one:
            if one[name] != another.get(name):
                return f"the {name} differs at step {step}"
    return None


def _some_action(spaces: Mapping[str, Any], task: str, step: int) -> Action:
    """One within its bounds, or within 1 of 0; the same for each number of a step."""
    rng = random.Random(step)
    return {
        name: [rng.uniform(low, high) for low, high in _ranges(space)]
        for name, space in spaces.items()
        if task in space.get("tasks", (task,))
    }


def _ranges(space: Mapping[str, Any]) -> Iterator[tuple[float, float]]:
    unbounded = [math.inf] * int(space["size"])
    lows, highs = space.get("minimum", unbounded), space.get("maximum", unbounded)
    for low, high in zip(lows, highs, strict=True):
        yield (low, high) if math.isfinite(high - low) else (-1.0, 1.0)
