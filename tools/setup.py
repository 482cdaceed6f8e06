"""Create a virtual environment from a hashed lock, and say what it is doing.

Run by make with any Python >= 3.11; uses nothing but the standard library.
`dev` is .venv with the project installed in place, `metaworld` is the house alone
beside another MuJoCo, `generate` is for the tools that write committed files, `bench`
has the peers that we are measured against. An environment whose lock has not changed is
kept. It knows nothing of what the packages are for; whether cameras can be rendered is
asked of reference_sim.mujoco.rendering.
"""

import fcntl
import hashlib
import os
import re
import shutil
import subprocess
import sys
import time
from pathlib import Path
from typing import Self

ROOT = Path(__file__).resolve().parent.parent
ENVIRONMENTS = {
    "bench": ".venv-bench",
    "dev": ".venv",
    "generate": ".venv-generate",
    "metaworld": ".venv-metaworld",
}
WITH_PROJECT = ("dev", "metaworld")
RENDERING = ROOT / "reference_sim" / "mujoco" / "rendering.py"
APT = ("apt-get", "-qq", "-y", "-o", "Dpkg::Use-Pty=0")
GL_PACKAGES = ("libegl1", "libopengl0", "libgl1-mesa-dri")
PIP_FLAGS = ("--disable-pip-version-check", "--no-input", "--progress-bar", "off")
# What pip prints -> what it means. The first match is reported.
CAUSES = {
    r"No space left on device": "the disk is full",
    r"do not match the hashes": "a downloaded package is not the locked one",
    r"No matching distribution .*|Could not find a version .*|Max retries exceeded"
    r"|Connection (?:broken|refused|reset)|[Tt]imed? ?out|NameResolution"
    r"|Network is unreachable": "the package index cannot be reached (no network?)",
    r"Permission denied": "this directory cannot be written to",
}


class SetupError(Exception):
    """What failed, in one line."""


class Phase:
    """One line of progress: what is being done, then how long it took."""

    def __init__(self, text: str) -> None:
        self.text = text
        self.started = time.monotonic()
        print(f"set-up: {text} …", end="", flush=True)

    def show(self, detail: str) -> None:
        """Replace the detail behind the text, where there is a terminal for it."""
        if sys.stdout.isatty():
            print(f"\r\033[Kset-up: {self.text} … {detail}", end="", flush=True)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, kind: object, *_: object) -> None:
        self.show("")
        outcome = "failed after" if kind else "done in"
        print(f" {outcome} {time.monotonic() - self.started:.1f} s", flush=True)


def digest(*parts: str | Path) -> str:
    sha = hashlib.sha256()
    for part in parts:
        sha.update(part.read_bytes() if isinstance(part, Path) else part.encode())
    return sha.hexdigest()


def cause_of(output: str) -> str:
    for pattern, meaning in CAUSES.items():
        if re.search(pattern, output):
            return meaning
    lines = [line for line in output.splitlines() if line.strip()]
    errors = [line for line in lines if line.lower().startswith("error")]
    return (errors or lines or ["no reason was given"])[-1].strip()


def run(command: list[str], log: Path, phase: Phase) -> None:
    """Run a command, keep its output in a log, raise its cause when it fails."""
    # PIP_USER would send packages elsewhere; PYTHONPATH would shadow them.
    clean = {k: v for k, v in os.environ.items() if k != "PYTHONPATH"}
    clean["PIP_USER"] = "0"
    output, collected = [], 0
    with subprocess.Popen(
        command,
        cwd=ROOT,
        env=clean,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        errors="replace",
    ) as process:
        assert process.stdout is not None
        for line in process.stdout:
            output.append(line)
            if line.startswith("Collecting"):
                collected += 1
                phase.show(f"{collected} {line.split()[1].split('==')[0]}")
    if log.parent.is_dir():
        log.write_text("".join(output))
    if process.returncode != 0:
        raise SetupError(cause_of("".join(output)))


def create(profile: str, environment: Path, lock: Path) -> None:
    """Make the environment anew: packages left from an older lock can break it."""
    log = environment / "setup.log"
    python = str(environment / "bin" / "python")
    with Phase(f"creating {environment.name}") as phase:
        shutil.rmtree(environment, ignore_errors=True)
        run([sys.executable, "-m", "venv", str(environment)], log, phase)
    count = sum("==" in line for line in lock.read_text().splitlines())
    with Phase(f"installing the {profile} lock, {count} packages") as phase:
        # The lock is complete, so pip need not resolve anything: --no-deps.
        flags = ["--require-hashes", "--no-deps", "--only-binary", ":all:"]
        command = [python, "-m", "pip", "install", *PIP_FLAGS, *flags]
        run([*command, "-r", str(lock)], log, phase)


def install_project(environment: Path) -> None:
    python = str(environment / "bin" / "python")
    with Phase("installing Proctor in place") as phase:
        flags = ["--no-deps", "--no-build-isolation", "--editable", str(ROOT)]
        command = [python, "-m", "pip", "install", *PIP_FLAGS, *flags]
        run(command, environment / "setup.log", phase)


def rendering_problem(python: Path) -> str:
    """Ask the simulator whether cameras work; its one line of advice if not."""
    command = [str(python), "-m", "reference_sim.mujoco.rendering"]
    probe = subprocess.run(
        command, cwd=ROOT, capture_output=True, text=True, check=False
    )
    if probe.returncode == 0:
        return ""
    lines = (probe.stdout + probe.stderr).strip().splitlines()
    return lines[-1] if lines else "cameras cannot be rendered on this machine"


def provide_rendering(environment: Path) -> None:
    """Make cameras work if that is in our power; never fail because of them."""
    if not RENDERING.exists():
        return
    problem = rendering_problem(environment / "bin" / "python")
    if problem and os.geteuid() == 0 and shutil.which("apt-get"):
        install = [*APT, "install", "--no-install-recommends", *GL_PACKAGES]
        os.environ["DEBIAN_FRONTEND"] = "noninteractive"
        log = environment / "apt.log"
        try:
            with Phase(f"installing {' '.join(GL_PACKAGES)} for cameras") as phase:
                try:
                    run(install, log, phase)
                except SetupError:  # the package lists may be missing or old
                    run([*APT, "update"], log, phase)
                    run(install, log, phase)
        except SetupError as error:
            print(f"set-up: {error}")
        problem = rendering_problem(environment / "bin" / "python")
    if problem:
        print(f"set-up: only camera images are missing: {problem}", flush=True)


def packages() -> str:
    """Importable top-level packages: an install in place only knows these."""
    roots = (ROOT, ROOT / "generated_clients" / "python")
    return " ".join(sorted(str(i) for r in roots for i in r.glob("*/__init__.py")))


def ensure(profile: str) -> None:
    """Bring one environment up to date, doing only what its stamp says is due."""
    environment = ROOT / ENVIRONMENTS[profile]
    lock = ROOT / "requirements" / f"{profile}.txt"
    stamp = environment / "ready"
    with lock.open() as held:
        fcntl.flock(held, fcntl.LOCK_EX)  # two makes at once: the second waits
        want = [digest(sys.version, str(environment), lock), ""]
        if profile in WITH_PROJECT:
            want[1] = digest(ROOT / "pyproject.toml", packages())
        have = stamp.read_text().split("\n") if stamp.exists() else ["", ""]
        if have[0] != want[0]:
            create(profile, environment, lock)
        if have != want and profile in WITH_PROJECT:
            install_project(environment)
        if have[0] != want[0] and profile in WITH_PROJECT:
            provide_rendering(environment)
        stamp.write_text("\n".join(want))


def main() -> int:
    profile = sys.argv[1]
    try:
        ensure(profile)
    except SetupError as error:
        log = Path(ENVIRONMENTS[profile]) / "setup.log"
        hint = f" Details: {log}" if (ROOT / log).exists() else ""
        print(f"set-up: failed: {error}.{hint}", file=sys.stderr)
        return 1
    except OSError as error:
        print(f"set-up: failed: {error}.", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
