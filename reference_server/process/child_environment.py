"""The environment of the processes that the server starts for one task."""

from __future__ import annotations

import os
from pathlib import Path


def child_environment() -> dict[str, str]:
    """The environment without the server's settings, which may contain secrets."""
    root = str(Path(__file__).parents[2])
    paths = [root, *filter(None, [os.environ.get("PYTHONPATH")])]
    dropped = "PROCTOR_", "PG"  # PGPASSWORD is read by the driver of the database
    kept = {k: v for k, v in os.environ.items() if not k.startswith(dropped)}
    return kept | {"PYTHONPATH": os.pathsep.join(paths)}
