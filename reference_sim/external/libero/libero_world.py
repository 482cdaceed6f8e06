"""The suites of LIBERO as benchmarks, over the simulator protocol.

    proctor-server --benchmarks libero.toml

Needs a Python with the package hf-libero (`make libero`), which LIBERO_PYTHON names,
and a clone of LIBERO's repository with its meshes and textures, which LIBERO_PATH
names. Episodes are those that openpi and LeRobot play: the seeds 0 to 49 of a task are
its published initial states. A larger seed is placed by LIBERO's own sampler.
docs/host/simulators.md has the conventions.
"""

from __future__ import annotations

import contextlib
import copy
import hashlib
import importlib
import importlib.util
import math
import os
import pickle
import re
import runpy
import struct
import sys
import tempfile
import types
import zipfile
from importlib import metadata
from pathlib import Path
from typing import Any, Dict, List

# The library stands beside this file, or in the folder that the server has it in.
sys.path.append(str(Path(__file__).resolve().parents[1] / "libraries"))

import proctor_simulator
from proctor_simulator import part, vector

MAX_STEPS = {
    "libero_spatial": 220,
    "libero_object": 280,
    "libero_goal": 300,
    "libero_10": 520,
}
PUBLISHED_STATES = 50  # of each task
# Objects fall to their places while the arm holds still and the gripper opens.
WAIT_STEPS, WAIT_ACTION = 10, (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0)
CAMERAS = {"image": "agentview", "image2": "robot0_eye_in_hand"}  # LeRobot's names
VERSIONS = ("hf-libero", "robosuite", "mujoco", "numpy")
CLONE = "git clone --depth 1 https://github.com/Lifelong-Robot-Learning/LIBERO"

ACTION = vector(
    {
        "position": part(
            3, "position", "m", "world", relative_to="measured", scale=0.05
        ),
        "orientation": part(
            *(3, "orientation", "rad", "world"),
            rotation="axis_angle",
            relative_to="measured",
            scale=0.5,
        ),
        "gripper": part(1, "gripper", gripper_open=-1.0, gripper_closed=1.0),
    },
    *([-1.0] * 7, [1.0] * 7),
    description="the command of robosuite's controller OSC_POSE",
)
STATE = vector(
    {
        "position": part(3, "position", "m", "world"),
        "orientation": part(3, "orientation", "rad", "world", rotation="axis_angle"),
        "fingers": part(2, "joint_position", "m", "joint"),
    },
    description="the hand, as openpi and LeRobot send it to their policies",
)
JOINTS = vector({"all": part(7, "joint_position", "rad", "joint")})
TURNED = "as drawn by robosuite, turned by 180°: a mirror image, left and right swapped"


class LiberoWorld(proctor_simulator.Simulator):
    """One suite; the environment of one task at a time."""

    def __init__(self, suite: str, root: Path, assets: Path) -> None:
        """root: of the package, with its task files. assets: of the clone."""
        self._suite, self._root, self._assets = suite, root, assets
        self._task = ""
        self._environment: Any = None  # of LIBERO
        self._states: Any = None
        self._seen: Any = None
        engine = {name: metadata.version(name) for name in VERSIONS}
        self.benchmark = {
            "benchmark_id": suite,
            "title": suite.replace("libero_", "LIBERO ").replace("10", "Long"),
            "description": "The published initial states of the suite.",
            "simulator": {
                "name": "libero",
                "version": engine.pop("hf-libero"),
                **engine,
                "assets_sha256": digest_of(assets),
            },
            "tasks": task_names(root, suite),
            "max_steps": MAX_STEPS[suite],
            "control_rate_hz": 20,
            "action_space": {"action": ACTION},
            "observation_space": {
                "state": {"state": STATE, "joint_position": JOINTS},
                "images": {
                    name: {"channels": 3, "description": f"{camera}, {TURNED}"}
                    for name, camera in CAMERAS.items()
                },
            },
            "image_sizes": [{"width": s, "height": s} for s in (256, 128, 224, 512)],
            "splits": [
                {"name": "published", "first_seed": 0, "episodes": PUBLISHED_STATES}
            ],
            "digest": True,
            "shared_memory": True,
        }

    def reset(self, task: str, seed: int, split: str) -> Dict[str, Any]:
        if task != self._task:
            self._open(task)
        environment = self._environment
        # LIBERO adds its samplers of drawers and stoves at each reset, and each of them
        # draws: without this an episode would depend on those before it.
        environment.env.object_property_initializers.clear()
        environment.seed(seed)
        environment.reset()
        if seed < len(self._states):
            environment.set_init_state(self._states[seed])
        for _ in range(WAIT_STEPS):
            seen = environment.step(list(WAIT_ACTION))[0]
        return {"instruction": instruction_of(task), "state": state_of(seen)}

    def step(self, action: Dict[str, List[float]]) -> Dict[str, Any]:
        seen, reward, success, _ = self._environment.step(action["action"])
        return {
            "state": state_of(seen),
            "success": success,
            "terminated": success,
            "reward": float(reward),
        }

    def draw(self, camera: str, width: int, height: int) -> Any:
        simulation = self._environment.sim
        context = simulation._render_context_offscreen  # noqa: SLF001 - no other way
        context.data = types.SimpleNamespace(_data=self._seen)
        try:
            drawn = simulation.render(width, height, camera_name=CAMERAS[camera])
        finally:
            context.data = simulation.data
        return drawn[::-1, ::-1]

    def _keep(self, sampled: Any) -> Any:
        """Keep the physics of an observation, of which its images are drawn.

        robosuite samples observations in the first of the 25 simulation steps of an
        action, so they are older than the physics after the action.
        """
        self._seen = copy.copy(self._environment.sim.data._data)  # noqa: SLF001
        return sampled

    def digest(self) -> bytes:
        """A hash of physics, of what controllers remember and of where fixtures are."""
        data, (robot,) = self._environment.sim.data, self._environment.robots
        controller, digest = robot.controller, hashlib.sha256()
        model = self._environment.sim.model  # a reset places cabinets and stoves in it
        digest.update(struct.pack("<d", data.time))
        for numbers in (
            *(data.qpos, data.qvel, data.ctrl, data.qacc_warmstart),
            *(controller.goal_pos, controller.goal_ori, robot.gripper.current_action),
            *(model.body_pos, model.body_quat),
        ):
            digest.update(numbers.tobytes())
        return digest.digest()

    def close(self) -> None:
        """End at once: contexts of OpenGL that Python frees at its end print errors."""
        os._exit(0)

    def _open(self, task: str) -> None:
        """Make the environment of a task; LIBERO is imported at the first one."""
        if self._environment is not None:
            self._environment.close()
        self._task, self._environment = "", None
        kind = import_environment(self._root, self._assets)
        files = self._root / "init_files" / self._suite
        self._states = read_states(files / f"{task}.pruned_init")
        self._environment = kind(
            bddl_file_name=str(
                self._root / "bddl_files" / self._suite / f"{task}.bddl"
            ),
            use_camera_obs=False,  # drawn when the server asks
            ignore_done=True,  # the server counts the steps
        )
        self._environment.env.modify_observable("robot0_eef_pos", "filter", self._keep)
        self._task = task


def state_of(seen: Dict[str, Any]) -> Dict[str, Any]:
    """The state of an observation of robosuite."""
    hand = [*seen["robot0_eef_pos"], *axis_angle(*map(float, seen["robot0_eef_quat"]))]
    return {
        "state": [*hand, *seen["robot0_gripper_qpos"]],
        "joint_position": seen["robot0_joint_pos"],
    }


def axis_angle(x: float, y: float, z: float, w: float) -> List[float]:
    """The turn of a quaternion, as robosuite, openpi and LeRobot write it.

    Its length is up to 2π: policies were trained on turns that are not shortened.
    """
    w = min(max(w, -1.0), 1.0)
    sine = math.sqrt(1.0 - w * w)
    if sine <= 1e-10:
        return [0.0, 0.0, 0.0]
    angle = 2.0 * math.acos(w)
    return [component * angle / sine for component in (x, y, z)]


def instruction_of(task: str) -> str:
    """The text that policies were trained with; that of the task file is another."""
    return re.sub(r"^[A-Z_]+SCENE\d+_", "", task).replace("_", " ")


def package_folder() -> Path:
    """Where the package has its task files. To import it now would ask questions."""
    package = importlib.util.find_spec("libero")
    for place in (package and package.submodule_search_locations) or ():
        if (Path(place) / "libero" / "bddl_files").is_dir():
            return Path(place) / "libero"
    raise SystemExit(
        f"hf-libero is not installed for {sys.executable}: `make libero` installs it, "
        "or LIBERO_PYTHON names a Python that has it"
    )


def task_names(root: Path, suite: str) -> List[str]:
    """In LIBERO's order, so that the task ids of other programs are places here."""
    names = runpy.run_path(str(root / "benchmark" / "libero_suite_task_map.py"))
    return list(names["libero_task_map"][suite])


def assets_folder() -> Path:
    named = os.environ.get("LIBERO_PATH", "")
    for assets in (Path(named, "libero", "libero", "assets"), Path(named)):
        if named and (assets / "scenes").is_dir():
            return assets
    problem = f"has no {named}/libero/libero/assets" if named else "is not set"
    raise SystemExit(f"LIBERO_PATH {problem}; `{CLONE}` makes a folder for it")


def digest_of(folder: Path) -> str:
    """The SHA-256 of all files with their names, in the order of the names."""
    digest = hashlib.sha256()
    files = [path for path in folder.rglob("*") if path.is_file()]
    for name, path in sorted((f.relative_to(folder).as_posix(), f) for f in files):
        if not path.name.startswith("."):
            data = path.read_bytes()
            digest.update(f"{len(name)} {name} {len(data)} ".encode())
            digest.update(data)
    return digest.hexdigest()


class ArrayUnpickler(pickle.Unpickler):
    """Reads arrays of NumPy, and refuses all else that a file names."""

    def find_class(self, module: str, name: str) -> Any:
        if (module.replace("._core", ".core"), name) in {
            ("_codecs", "encode"),
            ("numpy", "dtype"),
            ("numpy", "ndarray"),
            ("numpy.core.multiarray", "_reconstruct"),
        }:
            return super().find_class(module, name)
        raise pickle.UnpicklingError(f"no array of numbers: {module}.{name}")


def read_states(path: Path) -> Any:
    """The initial states of a task, an array; they need no torch, which wrote them."""
    with zipfile.ZipFile(path) as archive:
        (name,) = (n for n in archive.namelist() if n.endswith("/data.pkl"))
        with archive.open(name) as file:
            return ArrayUnpickler(file).load()


def import_environment(root: Path, assets: Path) -> Any:
    """LIBERO's class of environments, with the clone's assets."""
    if "bddl" not in sys.modules and importlib.util.find_spec("bddl") is None:
        sys.modules["bddl"] = types.ModuleType("bddl")
        sys.modules["bddl.parsing"] = bddl_parsing()
    if "libero.libero" not in sys.modules:
        with tempfile.TemporaryDirectory() as folder:
            paths = {"bddl_files": root / "bddl_files", "assets": assets}
            text = "".join(f'{name}: "{path}"\n' for name, path in paths.items())
            Path(folder, "config.yaml").write_text(text)
            os.environ["LIBERO_CONFIG_PATH"] = folder
            package: Any = importlib.import_module("libero.libero")
        package._assets_path_cache = str(assets)  # noqa: SLF001 - else it downloads
    return importlib.import_module("libero.libero.envs").OffScreenRenderEnv


def bddl_parsing() -> types.ModuleType:
    """The two functions of the package bddl that LIBERO calls.

    The package itself has no wheel, and needs a notebook's and a test's packages.
    """

    def scan_tokens(filename: str) -> List[Any]:
        text = re.sub(r";.*", "", Path(filename).read_text()).lower()
        nested: List[Any] = [[]]
        for word in re.findall(r"[()]|[^\s()]+", text):
            if word == "(":
                nested.append([])
            elif word == ")":
                nested[-2].append(nested.pop())
            else:
                nested[-1].append(word)
        ((expression,),) = nested
        return list(expression)

    def package_predicates(
        group: List[Any], goals: List[Any], _name: str, _part: str
    ) -> None:
        goals += group[1:] if group[0] == "and" else [group]

    module = types.ModuleType("bddl.parsing")
    module.__dict__.update(
        scan_tokens=scan_tokens, package_predicates=package_predicates
    )
    return module


def main() -> None:
    python = os.environ.pop("LIBERO_PYTHON", "")
    if python and not os.access(python, os.X_OK):
        raise SystemExit(f"LIBERO_PYTHON: no {python} that can be executed")
    if python:
        os.execv(python, [python, *sys.argv])  # noqa: S606
    if len(sys.argv) != 2 or sys.argv[1] not in MAX_STEPS:
        raise SystemExit(f"name a suite: {', '.join(MAX_STEPS)}")
    world = LiberoWorld(sys.argv[1], package_folder(), assets_folder())
    with contextlib.suppress(KeyboardInterrupt):
        proctor_simulator.serve(world)


if __name__ == "__main__":
    main()
