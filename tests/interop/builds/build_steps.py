"""Commands that build a client: its generator, if it is not committed, and compilers.

The module must not know which languages there are.
"""

from __future__ import annotations

import hashlib
import os
import shutil
import subprocess
from collections.abc import Iterator, Mapping
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
GENERATOR = ROOT / ".venv-generate" / "bin" / "python"
# A change of these may change the client; programs of the language count as well.
GENERATOR_INPUTS = (
    *("spec/openapi.yaml", "tools/generate.py", "tools/generators"),
    *("requirements/generate.txt", "pyproject.toml"),
)
BUILD_S = 1800.0


class BuildFailed(Exception):
    """A program cannot be run because its build failed."""


def run_step(
    step: tuple[str, ...], folder: Path, environment: Mapping[str, str] | None = None
) -> None:
    """Run one command; BuildFailed holds the end of its output."""
    done = subprocess.run(
        ("nice", *step),
        cwd=folder,
        env=environment,
        capture_output=True,
        text=True,
        timeout=BUILD_S,
        check=False,
    )
    if done.returncode != 0:
        output = (done.stdout + done.stderr).strip()[-3000:]
        raise BuildFailed(f"{' '.join(step)} failed:\n{output}")


def write_client(language: str, folder: Path) -> None:
    """Bring a folder up to date with what `make client` writes for a language.

    The generator needs seconds to start, so it runs only after a change of its inputs.
    """
    stamp, inputs = folder.with_name("generated"), _digest_inputs(language)
    if stamp.exists() and stamp.read_text() == inputs:
        return
    stamp.unlink(missing_ok=True)
    shutil.rmtree(folder, ignore_errors=True)
    generate = (str(GENERATOR), "tools/generate.py")
    run_step((*generate, "--client", language, "--to", str(folder)), ROOT)
    stamp.write_text(inputs)


def _digest_inputs(language: str) -> str:
    digest = hashlib.sha256()
    for path in _files(*GENERATOR_INPUTS, f"clients/{language}"):
        content = hashlib.sha256(path.read_bytes()).hexdigest()
        digest.update(f"{os.path.relpath(path, ROOT)} {content}\n".encode())
    return digest.hexdigest()


def _files(*names: str) -> Iterator[Path]:
    for name in names:
        path = ROOT / name
        inside = sorted(path.rglob("*")) if path.is_dir() else [path]
        yield from (file for file in inside if file.is_file())
