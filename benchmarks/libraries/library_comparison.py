"""Comparison of libraries for HTTP and encoding: section `libraries`.

All contenders, including those that the project uses, run in the peers' environment.
Their input is real requests and responses of the reference server (capture.py). Servers
and clients are measured on loopback (loopback.py), all else in one process
(one_process.py).
"""

from __future__ import annotations

import json
import subprocess
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple

from benchmarks import results
from benchmarks.libraries import capture, loopback
from benchmarks.results import Json
from benchmarks.round_trips import contender_registry, interleaved_rounds


class Counts(NamedTuple):
    """Rounds."""

    in_process: int
    loopback: int


FULL, TRIED = Counts(100, 40), Counts(3, 2)


def measure(trying: bool, say: Callable[[str], None]) -> Json:
    """The section. Raises FileNotFoundError if the environment is not there."""
    counts = TRIED if trying else FULL
    before = results.machine()
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch)
        say("libraries: capturing samples from a server")
        capture.write(folder)
        say("libraries: parsing and encoding")
        measured = _in_one_process(folder, counts.in_process)
        figures = {
            **measured.pop("figures"),
            "servers": loopback.servers(folder, counts.loopback, say),
            "clients": loopback.clients(folder, counts.loopback, say),
        }
    return {
        "measured_on": {**before, **measured},
        "rounds": counts._asdict(),
        "figures": figures,
    }


def _in_one_process(folder: Path, count: int) -> dict[str, Any]:
    """Also returns the versions of that environment, which differ from the server's."""
    module = "benchmarks.libraries.one_process"
    completed = subprocess.run(
        [str(contender_registry.PEERS_PYTHON), "-m", module, str(folder), str(count)],
        cwd=interleaved_rounds.ROOT,
        check=True,
        stdout=subprocess.PIPE,
        text=True,
    )
    read: dict[str, Any] = json.loads(completed.stdout)
    return read
