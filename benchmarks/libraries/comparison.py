"""Which library does a piece of HTTP or encoding best: section `libraries`.

All contenders live in the peers' environment, those that the project uses too, so that
all are measured alike. What they are given are real requests and answers of the
reference server (capture.py). What needs no second process is measured in one
(one_process.py), servers and clients on loopback (loopback.py).
"""

from __future__ import annotations

import json
import subprocess
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple

from benchmarks import contender_registry, results, rounds
from benchmarks.libraries import capture, loopback
from benchmarks.results import Json


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
        say("libraries: a server is asked for real answers")
        capture.write(folder)
        say("libraries: parsing and encoding")
        told = _in_one_process(folder, counts.in_process)
        figures = {
            **told.pop("figures"),
            "servers": loopback.servers(folder, counts.loopback, say),
            "clients": loopback.clients(folder, counts.loopback, say),
        }
    return {
        "measured_on": {**before, **told},
        "rounds": counts._asdict(),
        "figures": figures,
    }


def _in_one_process(folder: Path, count: int) -> dict[str, Any]:
    """Also says which Python and which versions these are, not those of the house."""
    module = "benchmarks.libraries.one_process"
    told = subprocess.run(
        [str(contender_registry.PEERS_PYTHON), "-m", module, str(folder), str(count)],
        cwd=rounds.ROOT,
        check=True,
        stdout=subprocess.PIPE,
        text=True,
    )
    read: dict[str, Any] = json.loads(told.stdout)
    return read
