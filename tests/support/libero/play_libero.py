"""Plays LIBERO without the server, as openpi and LeRobot do: `play_libero.py FOLDER`.

For libero_checks.py, by the Python that has LIBERO. FOLDER gets SUITE.npz, with each
observation as robosuite gives it, after the steps that wait and after each action.
"""

import importlib
import math
import sys
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

ROOT = Path(__file__).resolve().parents[3]
sys.path.append(str(ROOT / "reference_sim" / "external" / "libero"))
sys.path.append(str(ROOT / "reference_sim" / "external" / "libraries"))

Numbers = NDArray[np.float64]
STATE = 3  # which published state, of the first task of each suite
KEYS = (
    *("agentview_image", "robot0_eye_in_hand_image"),
    *("robot0_eef_pos", "robot0_eef_quat", "robot0_gripper_qpos"),
)


def actions() -> Any:
    """Numbers beyond -1 … 1 as well, which robosuite limits."""
    return np.random.default_rng(5).uniform(-1.2, 1.2, (8, 7)).round(6)


def play(suite: str, world: Any) -> Any:
    root = world.package_folder()
    task = world.task_names(root, suite)[0]
    make = world.import_environment(root, world.assets_folder())
    environment = make(
        bddl_file_name=str(root / "bddl_files" / suite / f"{task}.bddl"),
        camera_heights=256,
        camera_widths=256,
    )
    environment.seed(STATE)
    environment.reset()
    states = world.read_states(root / "init_files" / suite / f"{task}.pruned_init")
    environment.set_init_state(states[STATE])
    for _ in range(10):
        seen = environment.step([0, 0, 0, 0, 0, 0, -1])[0]
    rows = [seen, *(environment.step(action)[0] for action in actions())]
    return {key: np.array([row[key] for row in rows]) for key in KEYS}


def by_openpi(quaternion: Numbers) -> Numbers:
    """The formula of openpi's examples/libero/main.py, x y z w to axis times angle."""
    w = float(np.clip(quaternion[3], -1, 1))
    sine = math.sqrt(1 - w * w)
    return np.zeros(3) if sine == 0 else quaternion[:3] * 2 * math.acos(w) / sine


def by_lerobot(quaternion: Numbers) -> Numbers:
    """The formula of LeRobot's LiberoProcessorStep, which computes in float32."""
    x, y, z, w = quaternion.astype(np.float32)
    w = np.clip(w, np.float32(-1), np.float32(1))
    sine = np.sqrt(max(np.float32(1) - w * w, np.float32(0)))
    angle = np.float32(2) * np.arccos(w)
    return np.array([x, y, z]) / sine * angle if sine > 1e-10 else np.zeros(3)


if __name__ == "__main__":
    libero_world = importlib.import_module("libero_world")
    for name in libero_world.MAX_STEPS:
        np.savez(Path(sys.argv[1], name), **play(name, libero_world))
