"""The benchmark `tabletop`: one arm, one table, one cube; and its tasks.

Three things, kept apart: what a policy sends and sees (the constants, from which the
manifest is made), the scene (robot and cube in physical terms) and the tasks (how an
episode begins, what counts as done). A new task is one class at the foot of this file.

Nothing here knows of MuJoCo, and importing this file does not import it: whoever only
needs the constants does not wait.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from importlib.resources import files
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from reference_sim import rendering
from reference_sim.interface import Action, Observation, StepOutcome, TaskUnplayable
from reference_sim.mujoco_world import Vector, World

# What a policy sends and sees

BENCHMARK = "tabletop"
CONTROL_RATE_HZ = 20
SUBSTEPS = 20  # of the scene's timestep, 2.5 ms, in one control step

JOINTS = (
    "shoulder_yaw",
    "shoulder_pitch",
    "shoulder_roll",
    "elbow_pitch",
    "forearm_roll",
    "wrist_pitch",
    "hand_roll",
)
JOINT_LOW_RAD = (-2.8, -1.8, -2.8, -2.4, -2.8, -2.2, -2.8)
JOINT_HIGH_RAD = (2.8, 1.8, 2.8, 2.4, 2.8, 2.2, 2.8)
HOME_RAD = (0.0, 0.3, 0.0, 1.6, 0.0, math.pi - 1.9, 0.0)  # the gripper looks down


@dataclass(frozen=True, slots=True)
class Channel:
    """One named vector of an action or of an observation's state.

    low, high: bounds per element, inclusive; none means unbounded. An action beyond its
    bounds is executed as the nearest allowed one.
    """

    name: str
    size: int
    unit: str
    meaning: str
    low: tuple[float, ...] | None = None
    high: tuple[float, ...] | None = None


ACTION_CHANNELS = (
    Channel(
        "joint_position", 7, "rad", "absolute targets", JOINT_LOW_RAD, JOINT_HIGH_RAD
    ),
    Channel("gripper", 1, "fraction", "0 closed, 1 open", (0.0,), (1.0,)),
)
STATE_CHANNELS = (
    Channel("joint_position", 7, "rad", "measured, in the order of the action"),
    Channel("gripper", 1, "fraction", "measured opening, 0 closed, 1 open"),
    Channel("ee_pose", 7, "m", "between the fingertips: position, quaternion wxyz"),
    Channel("cube_pose", 7, "m", "the cube's centre: position, quaternion wxyz"),
)
POSE_FRAME = "world"  # origin under the arm, x forward, z up, z = 0 on the table
ROTATION = "quaternion_wxyz"
CAMERAS = ("front", "wrist")

# The scene's measures, which its XML states as well (a test compares them)

CUBE_HALF_M = 0.022
FINGER_STROKE_M = 0.04  # of each finger
FINGERS = ("left_finger", "right_finger")


def scene_mjcf() -> str:
    """The XML text of robot, table and cube."""
    return (files("reference_sim") / "scenes" / "tabletop.xml").read_text()


class Scene:
    """Robot and cube, in the words of a task: no indices, no engine."""

    def __init__(self, world: World) -> None:
        self._world = world

    def reset(self) -> None:
        """The arm at home, the gripper open, the cube where the XML has it."""
        self._world.reset()
        self._world.set_joint_positions(JOINTS, HOME_RAD)
        self._world.set_joint_positions(FINGERS, (FINGER_STROKE_M, FINGER_STROKE_M))
        self.command(HOME_RAD, 1.0)

    def command(self, joint_position: Sequence[float] | Vector, gripper: float) -> None:
        finger = FINGER_STROKE_M * min(max(gripper, 0.0), 1.0)
        joints = np.clip(joint_position, JOINT_LOW_RAD, JOINT_HIGH_RAD)
        self._world.set_controls([*joints, finger, finger])

    def place_cube(self, x: float, y: float, yaw: float) -> None:
        """On the table, flat. Metres and radians."""
        turned = (math.cos(yaw / 2), 0.0, 0.0, math.sin(yaw / 2))
        self._world.set_free_pose("cube", (x, y, CUBE_HALF_M, *turned))

    def cube_clearance_m(self) -> float:
        """Between the table and the underside of the cube, were it level."""
        return float(self._world.body_pose("cube")[2]) - CUBE_HALF_M

    def cube_distance_m(self) -> float:
        """Between the fingertips' middle and the cube's centre."""
        apart = self._world.body_pose("tcp")[:3] - self._world.body_pose("cube")[:3]
        return float(np.linalg.norm(apart))

    def cube_is_gripped(self) -> bool:
        return all(self._world.bodies_touch(finger, "cube") for finger in FINGERS)

    def state(self) -> dict[str, Vector]:
        opening = self._world.joint_positions(FINGERS).mean() / FINGER_STROKE_M
        return {
            "joint_position": self._world.joint_positions(JOINTS),
            "gripper": np.array([opening]),
            "ee_pose": self._world.body_pose("tcp"),
            "cube_pose": self._world.body_pose("cube"),
        }


# The tasks


class Task(Protocol):
    """How an episode begins and what counts as done.

    max_steps: control steps after which an episode is over (counted elsewhere).
    """

    name: str
    instruction: str
    max_steps: int

    def reset(self, scene: Scene, rng: np.random.Generator) -> None:
        """Arranges a scene that was just reset."""

    def goal_holds(self, scene: Scene) -> bool: ...

    def progress(self, scene: Scene) -> float:
        """In [0, 0.9]: the last tenth is for success alone."""


class LiftCube:
    name = "lift_cube"
    instruction = "Lift the red cube at least 10 cm above the table."
    max_steps = 150

    LIFT_M = 0.10
    REACHED_M = 0.03
    CUBE_X_M = (0.36, 0.56)
    CUBE_Y_M = (-0.20, 0.20)

    def reset(self, scene: Scene, rng: np.random.Generator) -> None:
        scene.place_cube(
            x=rng.uniform(*self.CUBE_X_M),
            y=rng.uniform(*self.CUBE_Y_M),
            yaw=rng.uniform(-math.pi, math.pi),
        )

    def goal_holds(self, scene: Scene) -> bool:
        return scene.cube_is_gripped() and scene.cube_clearance_m() >= self.LIFT_M

    def progress(self, scene: Scene) -> float:
        reached = scene.cube_distance_m() <= self.REACHED_M
        gripped = scene.cube_is_gripped()
        lifted = min(max(scene.cube_clearance_m() / self.LIFT_M, 0.0), 1.0)
        return 0.2 * reached + gripped * (0.2 + 0.5 * lifted)


TASKS: dict[str, type[Task]] = {LiftCube.name: LiftCube}

# The simulator

GOAL_HOLD_STEPS = 3  # control steps in a row: a cube thrown up is not lifted


@dataclass(frozen=True, slots=True)
class Snapshot:
    """An episode under way; continues in any Tabletop of the same versions."""

    task: str
    world: Vector
    held_steps: int
    score: float


class Tabletop:
    """`Simulator` of the benchmark; one per process and, with cameras, per thread."""

    def __init__(
        self,
        camera_width: int,
        camera_height: int,
        cameras: bool = True,
        quality: str = "fast",
    ) -> None:
        """Sizes in pixels. cameras=False: no images, and no graphics are looked for.

        quality: a key of mujoco_world.QUALITIES.
        Raises RenderingUnavailable if cameras are wanted where nothing can be drawn.
        """
        if cameras:
            rendering.find_backend()
        self._camera_size = (camera_width, camera_height)
        self._cameras = CAMERAS if cameras else ()
        self._world = World(scene_mjcf(), quality)
        self._scene = Scene(self._world)
        self._task: Task | None = None
        self._held_steps = 0
        self._score = 0.0

    def reset(self, task: str, seed: int) -> str:
        """Raises TaskUnplayable if the benchmark has no such task."""
        if task not in TASKS:
            raise TaskUnplayable(f"{BENCHMARK} has no task {task!r}")
        self._task = TASKS[task]()
        self._held_steps = 0
        self._score = 0.0
        self._scene.reset()
        self._task.reset(self._scene, np.random.Generator(np.random.PCG64(seed)))
        self._world.forward()
        return self._task.instruction

    def step(self, action: Action) -> StepOutcome:
        task = self._playing()
        self._scene.command(action["joint_position"], action["gripper"][0])
        self._world.advance(SUBSTEPS)
        self._held_steps = self._held_steps + 1 if task.goal_holds(self._scene) else 0
        success = self._held_steps >= GOAL_HOLD_STEPS
        progress = 1.0 if success else task.progress(self._scene)
        self._score = max(self._score, progress)
        return StepOutcome(success=success, score=self._score, terminated=success)

    def observe(self) -> Observation:
        self._playing()
        images: dict[str, NDArray[np.uint8]] = {
            camera: self._world.render(camera, *self._camera_size)
            for camera in self._cameras
        }
        return Observation(state=self._scene.state(), images=images)

    def snapshot(self) -> Snapshot:
        return Snapshot(
            task=self._playing().name,
            world=self._world.snapshot(),
            held_steps=self._held_steps,
            score=self._score,
        )

    def restore(self, snapshot: Snapshot) -> None:
        """Continues where the snapshot was taken, bit for bit."""
        self._task = TASKS[snapshot.task]()
        self._world.restore(snapshot.world)
        self._held_steps = snapshot.held_steps
        self._score = snapshot.score

    def close(self) -> None:
        self._world.close()

    def _playing(self) -> Task:
        if self._task is None:
            raise RuntimeError("reset comes before step, observe and snapshot")
        return self._task
