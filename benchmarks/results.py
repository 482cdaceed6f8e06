"""build/benchmarks.json: what was measured last, a section for each tool that measures.

    update("round_trips", {...})

A tool replaces its own section and leaves the others' alone; two may write at once. The
facts of the machine and of the moment are added here, the same for all. It knows
nothing of what is in a section.
"""

from __future__ import annotations

import fcntl
import importlib.metadata
import json
import os
import platform
import time
from pathlib import Path
from typing import Any

from tools.built_pages import BUILD

FILE = BUILD / "benchmarks.json"
DISTRIBUTIONS = (
    *("httptools", "msgspec", "mujoco", "numpy", "simplejpeg", "starlette"),
    *("uvicorn", "uvloop"),
)

Json = dict[str, Any]


def update(section: str, body: Json, file: Path = FILE) -> None:
    """Replaces one section. body: JSON-able; `measured_on` is added if it has none.

    Blocks while another tool writes. A reader never sees half a file.
    """
    file.parent.mkdir(exist_ok=True)
    folder = os.open(file.parent, os.O_RDONLY)
    try:
        fcntl.flock(folder, fcntl.LOCK_EX)
        sections = read(file)
        sections[section] = {"measured_on": machine(), **body}
        fresh = file.with_suffix(".new")
        fresh.write_text(json.dumps(sections, indent=1, sort_keys=True) + "\n")
        fresh.replace(file)
    finally:
        os.close(folder)


def read(file: Path = FILE) -> dict[str, Json]:
    """Every section by name; none if nothing was measured yet."""
    if not file.exists():
        return {}
    sections: dict[str, Json] = json.loads(file.read_text())
    return sections


def machine() -> Json:
    """Where and when: take it before the measuring begins, for the load's sake."""
    return {
        "date": time.strftime("%Y-%m-%d", time.gmtime()),
        "cores": os.cpu_count(),
        "processor": _processor(),
        "system": f"{platform.system()} {platform.release()}",
        "python": platform.python_version(),
        "load_before": [round(load, 2) for load in os.getloadavg()],
        "versions": {name: _version(name) for name in DISTRIBUTIONS},
    }


def _processor() -> str:
    cpuinfo = Path("/proc/cpuinfo")
    if cpuinfo.exists():
        for line in cpuinfo.read_text().splitlines():
            if line.startswith("model name"):
                return line.partition(":")[2].strip()
    return platform.processor() or platform.machine()


def _version(name: str) -> str:
    try:
        return importlib.metadata.version(name)
    except importlib.metadata.PackageNotFoundError:
        return "not installed"
