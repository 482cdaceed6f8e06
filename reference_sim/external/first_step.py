"""Plays a step of a described benchmark, so that a host sees a fault before a user."""

from __future__ import annotations

import hashlib
import math
import operator
import time
from collections.abc import Iterator, Mapping
from contextlib import suppress
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np

from reference_sim.definition import Json
from reference_sim.external.external_simulator import ExternalSimulator
from reference_sim.external.program import Program
from reference_sim.gymnasium.own_sources import DeclaredFiles
from reference_sim.interface import Action, TaskUnplayable, stages_of

_FAST_S = 5.0  # trying a second seed makes the start of a server so much longer at most


def try_first_step(program: Program, plan: Json, manifest: Json) -> Iterator[str]:
    """Yields what a host should know. Raises ProgramFault, TaskUnplayable, WrongReport.

    A second seed is tried, too, where the first step came fast.
    """
    size = manifest["image_sizes"][0]
    files = DeclaredFiles(Path(plan["folder"]), plan["sources"])
    simulator = ExternalSimulator(program, files, (size["width"], size["height"]))
    first = manifest["tasks"][0]
    action = {
        name: _middle(space)
        for name, space in manifest["action_space"].items()
        if first in space.get("tasks", (first,))
    }
    episode, other = _episodes_to_try(manifest)
    began_at = time.monotonic()
    seen = list(_first_step(simulator, episode, action))
    if other is None or time.monotonic() - began_at > _FAST_S:
        return
    with suppress(TaskUnplayable):  # as a task with other seeds than these may say
        if all(map(operator.eq, seen, _first_step(simulator, other, action))):
            yield (
                f"{first} begins alike with the seeds {episode['seed']} and "
                f"{other['seed']}, in all that is observed up to its first step: does "
                "its `reset` use the seed? If it is meant so, give each split one "
                "seed: more are copies of one episode"
            )


def _episodes_to_try(manifest: Json) -> tuple[Json, Json | None]:
    """One of the first task, and another one of its split, if there is any."""
    task, split = manifest["tasks"][0], manifest["splits"][0]
    episodes = [one for one in manifest["episodes"] if one["task"] == task]
    for one, another in pairwise(episodes):
        if one["split"] == another["split"]:
            return one, another
    return next(iter(episodes), {"task": task, "split": split, "seed": 0}), None


def _first_step(
    simulator: ExternalSimulator, episode: Json, action: Action
) -> Iterator[object]:
    """Everything that an episode shows up to its first step, one after the other.

    The caller may stop to read at any time: pictures may take long.
    """
    yield simulator.reset(episode["task"], episode["seed"], episode["split"])
    yield stages_of(simulator)
    yield simulator.state_bytes()
    yield _observed(simulator)
    simulator.step(action)
    yield simulator.state_bytes()
    yield _observed(simulator)


def _observed(simulator: ExternalSimulator) -> list[bytes]:
    seen = simulator.observe()
    arrays = (*seen.state.values(), *seen.images.values(), *seen.tensors.values())
    return [hashlib.sha256(np.asarray(array).tobytes()).digest() for array in arrays]


def _middle(space: Mapping[str, Any]) -> list[float]:
    if "minimum" not in space or "maximum" not in space:
        return [0.0] * int(space["size"])
    pairs = zip(space["minimum"], space["maximum"], strict=True)
    return [
        low / 2 + high / 2 if math.isfinite(high - low) else 0.0 for low, high in pairs
    ]
