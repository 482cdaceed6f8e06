"""Environments with a built wheel, its locked packages, and nothing else.

The lock is installed with its hashes, the wheels without asking what they require: what
the lock leaves out is missing. It knows no module of the project.
"""

import os
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

from tests.support.paths import ROOT
from tests.support.processes import run_program

TIMEOUT_S = 300.0
Done = subprocess.CompletedProcess[str]


def build_wheels(to: Path, *, source: Path = ROOT) -> None:
    """Build all of them as `make dist` does, from a checkout."""
    command = [sys.executable, "-m", "tools", "dist", str(to)]
    done = run_program(command, cwd=source)
    assert done.returncode == 0, done.stdout + done.stderr


class Installed:
    """An environment in `directory`; `wheels` are names of distributions in `dist`."""

    def __init__(self, directory: Path, dist: Path, *wheels: str) -> None:
        self.directory = directory
        self.bin = directory / "environment" / "bin"
        stems = [name.replace("-", "_") for name in wheels]
        # The last wheel requires the others, and its lock is about all of them.
        (lock,) = dist.glob(f"{stems[-1]}-*-requirements.txt")
        built = [str(path) for stem in stems for path in dist.glob(f"{stem}-*.whl")]
        assert len(built) == len(wheels)
        to = install_lock(lock, self.bin.parent)
        _uv("pip", "install", *to, "--no-deps", "--offline", *built)

    def run(self, program: str, *arguments: str | Path, **environment: str) -> Done:
        """Run a program of the environment, in the directory."""
        return run_program(
            [self.bin / program, *arguments],
            cwd=self.directory,
            env=clean_environment() | environment,
            timeout=TIMEOUT_S,
        )

    def can_import(self, modules: Sequence[str]) -> list[str]:
        """Give those of some modules that are there."""
        program = (
            "import importlib.util as u, sys\n"
            "print(*[m for m in sys.argv[1:] if u.find_spec(m)])"
        )
        done = self.run("python", "-c", program, *modules)
        assert done.returncode == 0, done.stderr
        return done.stdout.split()


def install_lock(lock: Path, environment: Path) -> tuple[str, str]:
    """Make an environment with the packages of a lock; give the option naming it."""
    _uv("venv", "--python", sys.executable, str(environment))
    to = ("--python", str(environment))
    _uv("pip", "sync", *to, "--require-hashes", "--no-build", str(lock))
    return to


def clean_environment() -> dict[str, str]:
    """This process's, without what could bring in another Python's modules."""
    return {
        name: value
        for name, value in os.environ.items()
        if not name.startswith(("PROCTOR_", "PYTHON", "VIRTUAL_ENV", "GITHUB_"))
    }


def _uv(*arguments: str) -> None:
    """As tools/setup.sh does: this machine's certificates, and the index of pip."""
    settings = {"UV_SYSTEM_CERTS": "true", "UV_PYTHON_DOWNLOADS": "never"}
    if "PIP_INDEX_URL" in os.environ:
        settings["UV_DEFAULT_INDEX"] = os.environ["PIP_INDEX_URL"]
    done = run_program(
        [Path(sys.executable).parent / "uv", "--quiet", *arguments],
        env=settings | clean_environment(),
        timeout=TIMEOUT_S,
    )
    assert done.returncode == 0, done.stderr
