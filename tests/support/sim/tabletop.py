"""Helpers for tests of the tabletop world: a simulator, and ways to act in it."""

import json
import xml.etree.ElementTree as ET

import numpy as np

from reference_sim.benchmarks.tabletop.experts import TabletopExpert
from reference_sim.benchmarks.tabletop.layout import CAMERAS, HOME_RAD, SUBSTEPS
from reference_sim.benchmarks.tabletop.scene import TabletopScene, scene_mjcf
from reference_sim.benchmarks.tabletop.tasks import TASKS
from reference_sim.benchmarks.tabletop.variation import SPLITS
from reference_sim.interface import Action, Observation, Simulator
from reference_sim.mujoco.task_simulator import PhysicalSimulator
from tests.support.sim.physical_play import Policy

WIDTH, HEIGHT = 64, 48
HOME: Action = {"joint_position": list(HOME_RAD), "gripper": [1.0]}
TASKS_AND_SPLITS = [(task, split) for task in TASKS for split in SPLITS]

Tabletop = PhysicalSimulator[TabletopScene]


def tabletop(*, cameras: bool, quality: str = "fast") -> Tabletop:
    return PhysicalSimulator(
        TabletopScene(quality),
        TASKS,
        substeps=SUBSTEPS,
        cameras=CAMERAS if cameras else (),
        camera_size=(WIDTH, HEIGHT),
    )


def scene_elements(tag: str) -> dict[str, dict[str, str]]:
    """Elements of the scene's XML: name → attributes."""
    root = ET.fromstring(scene_mjcf())  # noqa: S314 - our own file
    return {one.get("name", ""): dict(one.attrib) for one in root.iter(tag)}


def expert(sim: Simulator, task: str, seed: int, split: str = "") -> Policy:
    """Begins an episode; the expert's actions pass through JSON, as over the wire."""
    solver = TabletopExpert()
    solver.reset(sim.reset(task, seed, split))

    def act(seen: Observation) -> Action:
        state = {name: values.tolist() for name, values in seen.state.items()}
        acted = solver.act(json.loads(json.dumps(state)))
        action: Action = json.loads(json.dumps(acted))
        return action

    return act


def scripted_motion() -> Policy:
    """The same lively actions each time, whatever is seen."""
    rng = np.random.Generator(np.random.PCG64(99))
    reach = np.array([0.5, 0.9, 0.3, 1.0, 0.5, 1.0, 0.5])

    def act(_: Observation) -> Action:
        joints = reach * rng.uniform(-0.2, 1.0, 7)
        return {"joint_position": joints.tolist(), "gripper": [rng.uniform()]}

    return act
