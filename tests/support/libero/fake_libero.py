"""A package that stands in for LIBERO: its files, and a class with its interface.

`install` writes the package; this file is its module `libero.libero.envs`. As LIBERO
does, an environment adds a sampler of drawers at every reset, and each sampler draws.
"""

from __future__ import annotations

import importlib
import io
import pickle
import shutil
import zipfile
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np

SUITES = ("libero_spatial", "libero_object", "libero_goal", "libero_10")
TASKS = ["push_the_plate", "KITCHEN_SCENE10_close_the_drawer"]
STATES = np.arange(150, dtype=np.float64).reshape(50, 3) / 1000
BDDL = """(define (problem fake) ; a comment
  (:language Push the PLATE) (:goal (And (On plate_1 stove_1) (Open drawer_1))))"""
GOAL = [["on", "plate_1", "stove_1"], ["open", "drawer_1"]]
SUCCESS_X = 0.3


def install(folder: Path) -> Path:
    """Write the package into a folder for PYTHONPATH, give that of its clone."""
    root = folder / "libero" / "libero"
    for name in ("benchmark", "envs"):
        (root / name).mkdir(parents=True)
    (root / "__init__.py").write_text(
        "import os\n"  # without this file, LIBERO asks questions
        "open(os.environ['LIBERO_CONFIG_PATH'] + '/config.yaml').close()\n"
    )
    shutil.copy(__file__, root / "envs" / "__init__.py")
    task_map = f"libero_task_map = {dict.fromkeys(SUITES, TASKS)}\n"
    (root / "benchmark" / "libero_suite_task_map.py").write_text(task_map)
    for suite in SUITES:
        for kind in ("bddl_files", "init_files"):
            (root / kind / suite).mkdir(parents=True)
        for task in TASKS:
            (root / "bddl_files" / suite / f"{task}.bddl").write_text(BDDL)
            states = root / "init_files" / suite / f"{task}.pruned_init"
            states.write_bytes(torch_file(STATES))
    for name, version in (("hf_libero", "0.1.4"), ("robosuite", "1.4.0")):
        info = folder / f"{name}-{version}.dist-info"
        info.mkdir()
        text = f"Metadata-Version: 2.1\nName: {name}\nVersion: {version}\n"
        (info / "METADATA").write_text(text)
    scenes = folder / "clone" / "libero" / "libero" / "assets" / "scenes"
    scenes.mkdir(parents=True)
    (scenes / "table.xml").write_text("<mujoco/>")
    return folder / "clone"


def torch_file(value: Any) -> bytes:
    """A value as torch.save writes it, where it holds no tensor."""
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w") as archive:
        archive.writestr("archive/data.pkl", pickle.dumps(value, protocol=2))
        archive.writestr("archive/version", "3\n")
    return file.getvalue()


class OffScreenRenderEnv:
    def __init__(
        self, bddl_file_name: str, *, use_camera_obs: bool, ignore_done: bool
    ) -> None:
        parsing = importlib.import_module("bddl.parsing")
        goals: list[Any] = []
        problem = parsing.scan_tokens(filename=bddl_file_name)
        parsing.package_predicates(problem[-1][1], goals, "", "")
        assert goals == GOAL
        assert not use_camera_obs
        assert ignore_done
        self.env = SimpleNamespace(
            object_property_initializers=[], modify_observable=self._set_filter
        )
        self.robots = [
            SimpleNamespace(
                controller=SimpleNamespace(goal_pos=np.zeros(3), goal_ori=np.eye(3)),
                gripper=SimpleNamespace(current_action=np.zeros(2)),
            )
        ]

    def _set_filter(self, name: str, attribute: str, keep: Any) -> None:
        assert (name, attribute) == ("robot0_eef_pos", "filter")
        self._keep = keep

    def seed(self, seed: int) -> None:
        np.random.seed(seed)  # noqa: NPY002 - as LIBERO

    def reset(self) -> None:
        self.robots[0].gripper.current_action = np.zeros(2)
        self.env.object_property_initializers.append("drawer")
        for _ in self.env.object_property_initializers:
            cabinet = np.random.uniform(-0.01, 0.01, (1, 3))  # noqa: NPY002
        self.sim = Simulation(cabinet)

    def set_init_state(self, state: Any) -> None:
        self.sim.data.qpos = np.array(state)

    def step(self, action: list[float]) -> tuple[dict[str, Any], float, bool, Any]:
        """Observes before it moves, nearly as robosuite."""
        assert len(action) == 7
        gripper = self.robots[0].gripper
        seen = {
            "robot0_eef_pos": self._keep(self.sim.data.qpos),
            "robot0_eef_quat": np.array([1.0, 0.0, 0.0, 0.0]),
            "robot0_gripper_qpos": gripper.current_action * [-1, 1],
            "robot0_joint_pos": np.arange(7.0),
        }
        gripper.current_action = gripper.current_action + np.sign(action[6]) * 0.01
        self.sim.data.time += 0.05
        self.sim.data.qpos = self.sim.data.qpos + 0.05 * np.asarray(action[:3])
        success = bool(self.sim.data.qpos[0] > SUCCESS_X)
        return seen, float(success), success, {}

    def close(self) -> None:
        pass


class Simulation:
    def __init__(self, cabinet: Any) -> None:
        self.model = SimpleNamespace(body_pos=cabinet, body_quat=np.eye(4))
        self.data = Physics()
        self._render_context_offscreen = SimpleNamespace(data=self.data)

    def render(self, width: int, height: int, *, camera_name: str) -> Any:
        """Rows from the bottom, as robosuite: a grey corner, below on the left. Its
        grey says where the hand is."""
        shown = self._render_context_offscreen.data._data
        pixels = np.full((height, width, 3), 9, np.uint8)
        pixels[: height // 4, : width // 4] = 100 + round(100 * shown.qpos[0])
        pixels[-1, -1] = [camera_name == "agentview", 0, 0]
        return pixels


class Physics:
    def __init__(self) -> None:
        self.time, self.qpos = 0.0, np.array([0.5, 0.5, 0.5])
        self.qvel = self.ctrl = self.qacc_warmstart = np.zeros(3)

    @property
    def _data(self) -> Physics:
        return self
