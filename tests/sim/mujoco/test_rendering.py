"""Finding what can draw: once per process tree, and without harm where nothing can.

Graphics that do not work are played by a package named OpenGL that cannot be imported:
MuJoCo's EGL and OSMesa contexts both need it, so neither can draw.
"""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from reference_sim.mujoco import rendering
from tests.support.paths import ROOT
from tests.support.processes import run_program

pytestmark = pytest.mark.slow("starts an interpreter with MuJoCo for each backend")

COMMAND = ("-m", "reference_sim.mujoco.rendering")

STATE_ONLY = """
import os, sys
from reference_sim import benchmark_registry
from reference_sim.mujoco.rendering import RenderingUnavailable
from reference_sim.benchmarks.tabletop.layout import HOME_RAD

assert "mujoco" not in sys.modules, "reading the constants must not cost an import"
sim = benchmark_registry.make(benchmark_registry.SimulatorConfig("tabletop_state", {}))
sim.reset("lift_cube", 0)
sim.step({"joint_position": HOME_RAD, "gripper": [1.0]})
assert not sim.observe().images
assert not {"OpenGL", "glfw"} & set(sys.modules), "graphics were touched"

size = {"width": 64, "height": 48}
seeing = benchmark_registry.make(benchmark_registry.SimulatorConfig("tabletop", size))
seeing.reset("lift_cube", 0)
"""
THEN_CAMERAS = """
assert seeing.observe().images["front"].any()
seeing.close()
"""
THEN_NO_CAMERAS = """
try:
    seeing.observe()
except RenderingUnavailable as unavailable:
    print(unavailable)
"""


def run(*arguments: str, **variables: str) -> subprocess.CompletedProcess[str]:
    """Python in a process that has inherited no answer."""
    inherited = {
        name: value
        for name, value in os.environ.items()
        if name not in ("PROCTOR_GL", "MUJOCO_GL", "PYOPENGL_PLATFORM", "PYTHONPATH")
    }
    return run_program(
        [sys.executable, *arguments], cwd=ROOT, env=inherited | variables, timeout=60
    )


@pytest.fixture
def no_graphics(tmp_path: Path) -> dict[str, str]:
    """Variables under which nothing can draw."""
    package = tmp_path / "OpenGL"
    package.mkdir()
    (package / "__init__.py").write_text("raise AttributeError('no OpenGL, says test')")
    return {"PYTHONPATH": str(tmp_path)}


@pytest.fixture
def no_backend_chosen(monkeypatch: pytest.MonkeyPatch) -> pytest.MonkeyPatch:
    # Set first, so that whatever the test leaves behind is undone.
    monkeypatch.setenv("PROCTOR_GL", "")
    monkeypatch.setenv("MUJOCO_GL", "")
    return monkeypatch


def test_this_machine_can_draw() -> None:
    answer = run(*COMMAND)
    assert answer.returncode == 0, answer.stderr  # which names the package to install
    assert answer.stdout.strip() in rendering.BACKENDS


def test_without_graphics_one_line_names_the_package_to_install(
    no_graphics: dict[str, str],
) -> None:
    answer = run(*COMMAND, **no_graphics)
    assert answer.returncode == 1
    assert answer.stdout == ""
    assert answer.stderr.count("\n") == 1
    assert rendering.APT_COMMAND in answer.stderr
    assert "no OpenGL, says test" in answer.stderr


@pytest.mark.parametrize("exported", ["nonsense", "egl", "osmesa"])
def test_state_needs_no_graphics(no_graphics: dict[str, str], exported: str) -> None:
    """MUJOCO_GL=egl alone would end `import mujoco` here."""
    played = run("-c", STATE_ONLY + THEN_NO_CAMERAS, MUJOCO_GL=exported, **no_graphics)
    assert played.returncode == 0, played.stderr
    assert rendering.APT_COMMAND in played.stdout


def test_cameras_work_after_a_state_only_simulator() -> None:
    played = run("-c", STATE_ONLY + THEN_CAMERAS, MUJOCO_GL="nonsense")
    assert played.returncode == 0, played.stderr
    assert played.stderr == ""


def test_child_processes_inherit_the_backend(no_graphics: dict[str, str]) -> None:
    """Where nothing draws, only an inherited answer can be positive."""
    answer = run(*COMMAND, PROCTOR_GL="osmesa", **no_graphics)
    assert answer.stdout == "osmesa\n"


def test_the_backend_is_exported(no_backend_chosen: pytest.MonkeyPatch) -> None:
    no_backend_chosen.setattr(rendering, "_PROBE", "")
    assert rendering.find_backend() == "egl"
    assert os.environ["MUJOCO_GL"] == os.environ["PROCTOR_GL"] == "egl"


def test_the_backend_from_the_environment_is_tried_first(
    no_backend_chosen: pytest.MonkeyPatch,
) -> None:
    no_backend_chosen.setattr(rendering, "_PROBE", "")
    no_backend_chosen.setenv("MUJOCO_GL", "OSMesa")
    assert rendering.find_backend() == "osmesa"


@pytest.mark.parametrize(
    ("probe", "reason"),
    [
        ("import os; os.abort()", "exit -6"),
        ("import time; time.sleep(60)", "no image rendered within 0.1 s"),
        ("raise SystemExit('line\\nlast line ' + 'x' * 999)", "last line xxx"),
    ],
)
def test_a_crashing_driver_is_reported_as_a_reason(
    no_backend_chosen: pytest.MonkeyPatch, probe: str, reason: str
) -> None:
    """Expect one short line, MUJOCO_GL removed, and no second look."""
    no_backend_chosen.setattr(rendering, "_PROBE", probe)
    if "sleep" in probe:
        no_backend_chosen.setattr(rendering, "_PROBE_TIMEOUT_S", 0.1)
    with pytest.raises(rendering.RenderingUnavailable) as first:
        rendering.find_backend()
    assert reason in str(first.value)
    assert "\n" not in str(first.value)
    assert len(str(first.value)) < 500
    assert "MUJOCO_GL" not in os.environ

    no_backend_chosen.setattr(rendering, "_probe_backends", None)
    with pytest.raises(rendering.RenderingUnavailable, match=reason):
        rendering.find_backend()
