"""Builds the programs of examples/simulators/."""

import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from reference_sim.external import LIBRARIES
from tests.support.paths import ROOT

EXAMPLES = ROOT / "examples" / "simulators"


def mujoco_flags() -> list[str]:
    """Where the Python package has headers and the library."""
    if not Path("/usr/include/EGL/egl.h").exists():
        pytest.skip("the headers of EGL are not installed")
    mujoco = pytest.importorskip("mujoco")
    folder = Path(mujoco.__file__).parent
    (library,) = folder.glob("libmujoco.so.*")
    flags = [f"-I{folder}/include", str(library), "-lEGL", f"-Wl,-rpath,{folder}"]
    return [*flags, "-Wno-missing-field-initializers"]


def build_example(example: str, folder: Path) -> list[str]:
    """The command of an example, copied and compiled as its first lines say."""
    for library in LIBRARIES.glob("proctor_simulator.*"):
        shutil.copy(library, folder)
    program = str(folder / example.partition(".")[0])
    if example.endswith(".py"):
        shutil.copy(EXAMPLES / example, folder)
        return [sys.executable, str(folder / example)]
    if example.endswith(".cpp"):
        shutil.copy(EXAMPLES / example, folder)
        compiler = ["c++", "-O2", "-std=c++17", "-Wall", "-Wextra", "-Werror"]
        build = [*compiler, example, "-o", program]
        if example.startswith("mujoco"):
            build += mujoco_flags()
        subprocess.run(build, cwd=folder, check=True)
        return [program]
    if shutil.which("go") is None:
        pytest.skip("Go is not installed")
    build = ["go", "build", "-C", str(EXAMPLES / example), "-o", program, "."]
    subprocess.run(build, check=True)
    return [program]
