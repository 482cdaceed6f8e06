"""Plays a Gymnasium environment as a `Simulator`.

Errors of an environment, such as a wrong shape or a number that is not finite, are
raised, never corrected. The parent process reports them as a fault of the simulator.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from reference_sim.gymnasium import entries, environments
from reference_sim.gymnasium.entries import Entry
from reference_sim.gymnasium.environments import Environment
from reference_sim.gymnasium.own_sources import (
    OWN_SOURCES,
    DeclaredFiles,
)
from reference_sim.interface import (
    Action,
    ChangedSource,
    Observation,
    StepOutcome,
    TaskUnplayable,
    number_of,
    truth_of,
)

ACTION, OBSERVATION = "action", "observation"  # of spaces that have no names inside


@dataclass(frozen=True, slots=True)
class StepData:
    """The result of a step. total: the sum of rewards, including this one."""

    environment: Environment
    info: Mapping[str, Any]
    reward: float
    total: float
    terminated: bool


SuccessPredicate = Callable[[StepData], bool]


class GymnasiumSimulator:
    """`Simulator` of a checked benchmark (`plan`, JSON-able).

    size: width and height of the images, in pixels; None leaves them as they come.
    """

    def __init__(
        self, plan: Mapping[str, Any], size: tuple[int, int] | None = None
    ) -> None:
        self._plan = plan
        self._size = size
        self._tasks = {task["name"]: task for task in plan["tasks"]}
        self.read_success()
        self._files = DeclaredFiles(Path(plan["made_of"]["folder"]), plan["files"])
        self._environment: Environment | None = None
        self._made_for: Mapping[str, Any] | None = None

    def read_success(self) -> None:
        """Judge as the plan says; `check` settles that after the first steps."""
        folder = self._plan["made_of"]["folder"]
        self._is_success = _success_predicate(self._plan["success"], folder)

    def reset(self, task: str, seed: int, split: str = "") -> str:
        """Raises TaskUnplayable if the benchmark has no such task.

        Raises ChangedSource if a file is not that of the manifest.
        """
        self._files.require_unchanged()
        OWN_SOURCES.require_unchanged(self._plan.get("sources", ()))
        if task not in self._tasks:
            raise TaskUnplayable(f"the benchmark has no task {task!r}")
        chosen = self._tasks[task]
        kwargs = {**self._plan["kwargs"], **chosen["kwargs"]}
        if kwargs != self._made_for or self._plan["rebuild_every_episode"]:
            self._make(kwargs)
        environment = self._require_environment()
        returned = environment.reset(seed=seed, options=chosen["reset_options"])
        observation, info = environments.parts_of(environment, "reset", returned)
        self.info: Mapping[str, Any] = info
        self._observation = observation
        self._steps, self._return = 0, 0.0
        _require_sources()
        return str(chosen["instruction"])

    def _make(self, kwargs: Mapping[str, Any]) -> None:
        self.close()
        draws = self._plan["camera"] is not None
        made = environments.make(self._plan["made_of"], kwargs, draws=draws)
        self._environment, self._made_for = made, kwargs
        self.actions, self._nesting_of_action = environments.read_space(
            made.action_space, ACTION
        )
        observed, self._nesting = environments.read_space(
            made.observation_space, OBSERVATION
        )
        tensors = self._plan["images_as_tensors"]
        self.observed = [
            replace(entry, as_tensor=entry.name in tensors) for entry in observed
        ]

    def step(self, action: Action) -> StepOutcome:
        """Success, and whether it ends the episode, are decided by the plan."""
        environment = self._require_environment()
        values = {
            entry.name: entries.to_environment(entry, action[entry.name])
            for entry in self.actions
        }
        returned = environment.step(entries.assemble(self._nesting_of_action, values))
        self._observation, rewarded, is_terminated, is_truncated, self.info = (
            environments.parts_of(environment, "step", returned)
        )
        _require_sources()
        reward = number_of(rewarded, "reward")
        terminated = truth_of(is_terminated, "terminated")
        truncated = truth_of(is_truncated, "truncated")
        self._steps += 1
        self.over = terminated or truncated  # as the environment sees it
        self._return += reward
        success = self._is_success(
            StepData(environment, self.info, reward, self._return, terminated)
        )
        ended = terminated or (success and self._plan["ends_on_success"])
        # Cut off at the benchmark's own limit: then the episode says so itself.
        cut_short = truncated and self._steps < self._plan["max_steps"]
        return StepOutcome(
            success=success,
            score=self._score(success),
            terminated=ended or cut_short,
            reward=reward,
        )

    def _score(self, success: bool) -> float:
        way = self._plan["score"]
        if way == "success":
            return float(success)
        start, end = way["return_from"], way["return_to"]
        return float(min(1.0, max(0.0, (self._return - start) / (end - start))))

    def observe(self) -> Observation:
        """State, images and tensors of the space, and the image of `render`."""
        parts = self.observation_parts()
        if (camera := self._plan["camera"]) is not None:
            parts["images"][camera["name"]] = self.draw(camera["upside_down"])
        if self._size is not None:
            for name, pixels in parts["images"].items():
                parts["images"][name] = _resize(pixels, self._size)
        return Observation(**parts)

    def observation_parts(self) -> dict[str, dict[str, NDArray[Any]]]:
        """The observation by group: `state`, `images` and `tensors`."""
        parts: dict[str, dict[str, NDArray[Any]]]
        parts = {"state": {}, "images": {}, "tensors": {}}
        for entry, value in self.leaves():
            if entry.size:
                parts[entry.kind][entry.name] = entries.as_array(entry, value)
        return parts

    def leaves(self) -> Iterator[tuple[Entry, Any]]:
        """The parts of the observation as the environment gave them."""
        values = entries.take(self._nesting, self._observation)
        return ((entry, values[entry.name]) for entry in self.observed)

    def draw(self, upside_down: bool = False) -> NDArray[np.uint8]:
        """The image of `render`, (height, width, 3). Raises ValueError if invalid."""
        pixels: Any = self._require_environment().render()
        if not (
            isinstance(pixels, np.ndarray)
            and pixels.dtype == np.uint8
            and pixels.ndim == 3
            and pixels.shape[2] == 3
        ):
            raise ValueError(
                f"render gave {_describe(pixels)}, not uint8 (height, width, 3)"
            )
        return np.ascontiguousarray(pixels[::-1, ::-1] if upside_down else pixels)

    def state_bytes(self) -> bytes:
        """The observation without rendered images, and the sum of rewards.

        They stand for the state, which Gymnasium has no way to read.
        """
        observed = b"".join(
            f"{name} {array.dtype} {array.shape} ".encode() + array.tobytes()
            for group in self.observation_parts().values()
            for name, array in group.items()
        )
        return observed + repr((self._steps, self._return)).encode()

    def close(self) -> None:
        if self._environment is not None and hasattr(self._environment, "close"):
            self._environment.close()  # a class may do without
        self._environment = self._made_for = None

    @property
    def environment(self) -> Environment:
        """The environment of the current task, for `check`."""
        return self._require_environment()

    def _require_environment(self) -> Environment:
        if self._environment is None:
            raise RuntimeError("reset comes before step and observe")
        return self._environment


def make(settings: Mapping[str, Any]) -> GymnasiumSimulator:
    """The simulator of these settings; see registration. Raises ChangedSource."""
    OWN_SOURCES.require(settings["plan"])
    size = (settings["width"], settings["height"])
    return GymnasiumSimulator(settings["plan"], size)


def _require_sources() -> None:
    """The environment may have caught the exception of an import."""
    if OWN_SOURCES.fault is not None:
        raise ChangedSource(OWN_SOURCES.fault)


def _resize(pixels: NDArray[np.uint8], size: tuple[int, int]) -> NDArray[np.uint8]:
    height, width, channels = pixels.shape
    if (width, height) == size:
        return pixels
    picture = Image.fromarray(pixels[:, :, 0] if channels == 1 else pixels)
    scaled = np.asarray(picture.resize(size, Image.Resampling.BOX), dtype=np.uint8)
    return scaled.reshape(size[1], size[0], channels)


def _success_predicate(success: Mapping[str, Any], folder: str) -> SuccessPredicate:
    """Whether the goal condition holds after a step, as the plan says."""
    if key := success.get("info"):
        name = f"info[{key!r}]"
        return lambda step_data: truth_of(step_data.info.get(key, False), name)
    if (reward := success.get("reward_at_least")) is not None:
        return lambda step_data: step_data.reward >= reward
    if (total := success.get("return_at_least")) is not None:
        return lambda step_data: step_data.total >= total
    if success.get("terminated"):
        return lambda step_data: step_data.terminated
    if reference := success.get("function"):
        predicate = environments.find(reference, folder)
        return lambda step_data: truth_of(
            predicate(step_data.environment, step_data.info), reference
        )
    return lambda step_data: False  # noqa: ARG005 - no success condition is declared


def _describe(thing: object) -> str:
    if isinstance(thing, np.ndarray):
        return f"{thing.dtype} {thing.shape}"
    return type(thing).__name__
