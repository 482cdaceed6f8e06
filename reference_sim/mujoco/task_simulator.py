"""The simulator of tasks in one MuJoCo scene, shared by the physical benchmarks.

A scene is a robot and its objects, in physical quantities. A task defines how an
episode begins, which stages lead to the goal, and when the goal holds. This module
knows no particular robot or task, and uses MuJoCo only through `World`.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Generic, Protocol, TypeVar

import numpy as np
from numpy.typing import NDArray

from reference_sim.interface import Action, Observation, StepOutcome, TaskUnplayable
from reference_sim.mujoco.world import Vector, World

GOAL_HOLD_STEPS = 3  # consecutive control steps: a cube thrown up is not lifted


class Scene(Protocol):
    """Robot and objects. `world` is for snapshots and images; tasks do not use it."""

    world: World

    def reset(self) -> None:
        """Reset to the initial state of the model, with the robot at home."""

    def command(self, action: Action) -> None:
        """Set the targets of one control step."""

    def state(self) -> Mapping[str, Vector]:
        """The observation's state."""


SceneT = TypeVar("SceneT", bound=Scene)
SceneT_contra = TypeVar("SceneT_contra", bound=Scene, contravariant=True)


class Task(Protocol[SceneT_contra]):
    """The initial state and the goal of a task. One object plays one episode.

    stages: names of what leads to the goal, in order; the goal itself comes last and is
    not among them. The score is the share of stages that were ever reached, each after
    the one before it: stage k of n gives k / (n + 1), the goal 1.
    """

    name: str
    instruction: str

    @property
    def stages(self) -> Sequence[str]: ...

    def reset(self, scene: SceneT_contra, rng: np.random.Generator, split: str) -> None:
        """Place the objects in a scene that was just reset."""

    def reached(self, scene: SceneT_contra) -> Sequence[bool]:
        """Whether each stage holds now."""

    def goal_holds(self, scene: SceneT_contra) -> bool:
        """The goal condition, as one predicate of the scene."""


@dataclass(frozen=True, slots=True)
class Snapshot:
    """An episode in progress; continues in any simulator of the same versions.

    task, seed, split: reproduce the random choices of the task.
    """

    task: str
    seed: int
    split: str
    world: Vector
    held_steps: int
    stages_reached: int
    success: bool


class PhysicalSimulator(Generic[SceneT]):
    """`Simulator` of tasks in a scene; one per process; with cameras, per thread."""

    def __init__(
        self,
        scene: SceneT,
        tasks: Mapping[str, type[Task[SceneT]]],
        *,
        substeps: int,
        cameras: Sequence[str] = (),
        camera_size: tuple[int, int] = (0, 0),
    ) -> None:
        """substeps: of the model's timestep in one control step. camera_size: pixels,
        width and height; without cameras, no rendering backend is needed."""
        self._scene = scene
        self._world = scene.world
        self._tasks = tasks
        self._substeps = substeps
        self._cameras = cameras
        self._camera_size = camera_size
        self._task: Task[SceneT] | None = None

    def reset(self, task: str, seed: int, split: str = "") -> str:
        """Raises TaskUnplayable if the benchmark has no such task."""
        if task not in self._tasks:
            raise TaskUnplayable(f"the benchmark has no task {task!r}")
        self._task = self._tasks[task]()
        self._seed, self._split = seed, split
        self._held_steps = self._stages_reached = 0
        self._success = False
        self._scene.reset()
        self._task.reset(self._scene, np.random.Generator(np.random.PCG64(seed)), split)
        self._world.forward()
        return self._task.instruction

    @property
    def stages(self) -> Sequence[str]:
        """The stages of the task that was reset last."""
        return self._require_task().stages

    def step(self, action: Action) -> StepOutcome:
        """Success is the goal in GOAL_HOLD_STEPS steps in a row, and ends the task."""
        task = self._require_task()
        self._scene.command(action)
        self._world.advance(self._substeps)
        self._held_steps = self._held_steps + 1 if task.goal_holds(self._scene) else 0
        self._success = self._success or self._held_steps >= GOAL_HOLD_STEPS
        reached = task.reached(self._scene)
        while self._stages_reached < len(reached) and reached[self._stages_reached]:
            self._stages_reached += 1
        share = self._stages_reached / (len(task.stages) + 1)
        return StepOutcome(
            success=self._success,
            score=1.0 if self._success else share,
            terminated=self._success,
        )

    def observe(self) -> Observation:
        """State, and an image of each camera."""
        self._require_task()
        images: dict[str, NDArray[np.uint8]] = {
            camera: self._world.render(camera, *self._camera_size)
            for camera in self._cameras
        }
        return Observation(state=self._scene.state(), images=images)

    def snapshot(self) -> Snapshot:
        """The state for `restore`."""
        return Snapshot(
            task=self._require_task().name,
            seed=self._seed,
            split=self._split,
            world=self._world.snapshot(),
            held_steps=self._held_steps,
            stages_reached=self._stages_reached,
            success=self._success,
        )

    def restore(self, snapshot: Snapshot) -> None:
        """Continue from the snapshot, bit for bit."""
        self.reset(snapshot.task, snapshot.seed, snapshot.split)
        self._world.restore(snapshot.world)
        self._held_steps = snapshot.held_steps
        self._stages_reached = snapshot.stages_reached
        self._success = snapshot.success

    def state_bytes(self) -> bytes:
        """The full state of MuJoCo's physics, and the progress in the task."""
        progress = self._held_steps, self._stages_reached, self._success
        return self._world.snapshot().tobytes() + repr(progress).encode()

    def close(self) -> None:
        """Free the renderers."""
        self._world.close()

    def _require_task(self) -> Task[SceneT]:
        if self._task is None:
            raise RuntimeError("reset comes before step, observe and snapshot")
        return self._task
