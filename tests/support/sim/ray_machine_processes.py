"""Ray machines of a test that are killed and paused, beside a head that is not.

The test itself runs where Ray is not installed: a process of `.venv-cluster` starts
them and says which processes they are.
"""

from __future__ import annotations

import contextlib
import os
import subprocess
import tempfile
from collections.abc import Iterator
from pathlib import Path

from tests.support.paths import ROOT
from tests.support.processes import descendants
from tests.support.servers import NotStarted
from tools.local_cluster.ray_machines import (
    ADD,
    CPUS,
    ENVIRONMENT,
    LIST,
    LISTED,
    RESOURCES,
    STARTED,
)

PYTHON = ROOT / ".venv-cluster" / "bin" / "python"
BESIDE_THE_HEAD = 3
# What Ray calls the process of an actor; its own agents have names like it, and end
# their machine with them.
_SIMULATOR = b"ray::SimulatorActor"


class RayMachines:
    """Opened by `open`. settings: of a server that joins them."""

    def __init__(self, process: subprocess.Popen[str]) -> None:
        self._process = process
        address = self._read(STARTED)
        self.settings = ENVIRONMENT | {
            "PROCTOR_SIMULATORS": "ray",
            "PROCTOR_RAY_RESOURCES": RESOURCES,
            "RAY_ADDRESS": address,
        }

    @classmethod
    @contextlib.contextmanager
    def open(cls) -> Iterator[RayMachines]:
        """Raises NotStarted."""
        if not PYTHON.exists():
            raise NotStarted("Ray is not installed here: make .venv-cluster/ready")
        module = "tools.local_cluster.ray_machines"
        with (
            # Short: the path of a socket has 107 bytes at most.
            tempfile.TemporaryDirectory(prefix="ray-") as directory,
            subprocess.Popen(
                [PYTHON, "-m", module, str(BESIDE_THE_HEAD + 1), str(CPUS)],
                cwd=ROOT,
                env=os.environ | ENVIRONMENT | {"RAY_TMPDIR": directory},
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=subprocess.DEVNULL,
                text=True,
            ) as process,
        ):
            try:
                yield cls(process)
            finally:
                with contextlib.suppress(OSError):
                    process.communicate(timeout=60)  # the end of its input ends it

    def machines(self) -> list[set[int]]:
        """Process ids of each machine beside the head, with all that it started."""
        return [{pid} | descendants(pid) for pid in self._ask(LIST)]

    def simulators(self) -> list[int]:
        """Process ids of what simulates on the machines beside the head."""
        found = set[int]()
        for machine in self.machines():
            found |= {pid for pid in machine if _simulates(pid)}
        return sorted(found)

    def replace_lost(self) -> None:
        """Let others join, up to as many as there were."""
        while len(self._ask(LIST)) < BESIDE_THE_HEAD:
            self._ask(ADD)

    def _ask(self, line: str) -> list[int]:
        assert self._process.stdin is not None
        self._process.stdin.write(f"{line}\n")
        self._process.stdin.flush()
        return [int(pid) for pid in self._read(LISTED).split()]

    def _read(self, beginning: str) -> str:
        assert self._process.stdout is not None
        for line in self._process.stdout:  # Ray prints, too
            if line.startswith(beginning):
                return line.removeprefix(beginning).strip()
        raise NotStarted("Ray did not start, or has ended")


def _simulates(pid: int) -> bool:
    with contextlib.suppress(OSError):
        return Path(f"/proc/{pid}/cmdline").read_bytes().startswith(_SIMULATOR)
    return False
