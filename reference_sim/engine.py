"""Versions of the software and hardware here that may change a trajectory."""

from __future__ import annotations

import importlib.metadata
import platform
from functools import cache
from pathlib import Path
from typing import Any

_PACKAGES = ("proctor-eval", "mujoco", "gymnasium", "numpy")


@cache
def engine_fingerprint() -> dict[str, Any]:
    """Packages by name, Python, operating system and processor: read once, in 10 ms."""
    packages = {}
    for name in _PACKAGES:
        try:
            packages[name] = importlib.metadata.version(name)
        except importlib.metadata.PackageNotFoundError:
            continue
    return {
        "packages": packages,
        "python": platform.python_version(),
        "os": f"{platform.system()} {platform.release()}",
        "cpu": _cpu_model(),
    }


def _cpu_model() -> str:
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
    except OSError:
        return platform.machine()
    models = (line.partition(": ")[2] for line in lines if "model name" in line)
    return next(models, platform.machine())
