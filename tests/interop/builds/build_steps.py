"""Commands that build a client: its generator, if it is not committed, and compilers.

The module must not know which languages there are.
"""

import shutil
from collections.abc import Mapping
from pathlib import Path

from tests.support.processes import run_program
from tools.generate import INPUTS, digest_files

ROOT = Path(__file__).resolve().parents[3]
GENERATOR = ROOT / ".venv-generate" / "bin" / "python"
BUILD_S = 1800.0


class BuildFailed(Exception):
    """A program cannot be run because its build failed."""


def run_step(
    step: tuple[str, ...], folder: Path, environment: Mapping[str, str] | None = None
) -> None:
    """Run one command; BuildFailed holds the end of its output."""
    done = run_program(("nice", *step), cwd=folder, env=environment, timeout=BUILD_S)
    if done.returncode != 0:
        output = (done.stdout + done.stderr).strip()[-3000:]
        raise BuildFailed(f"{' '.join(step)} failed:\n{output}")


def write_client(language: str, folder: Path) -> None:
    """Bring a folder up to date with what `make client` writes for a language. The
    generator needs seconds to start, so it runs only after a change of its inputs."""
    programs = f"clients/{language}"
    # A change of the programs of the language counts as well.
    stamp, inputs = folder.with_name("generated"), digest_files([*INPUTS, programs])
    if stamp.exists() and stamp.read_text() == inputs:
        return
    stamp.unlink(missing_ok=True)
    shutil.rmtree(folder, ignore_errors=True)
    generate = (str(GENERATOR), "-m", "tools", "generate")
    run_step((*generate, "--client", language, "--to", str(folder)), ROOT)
    stamp.write_text(inputs)
