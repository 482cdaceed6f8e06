"""A whole kit in a process of its own, as its user starts it."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

from tests.support.paths import ROOT


def kit_outcomes(report: Path, *options: str) -> tuple[dict[str, str], str]:
    """Give the outcome of each row by its id, and what the kit printed."""
    done = subprocess.run(
        [sys.executable, "-m", "conformance", *options, "--report", str(report)],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=False,
    )
    rows = json.loads((report / "report.json").read_text())["rows"]
    return {row["requirement_id"]: row["outcome"] for row in rows}, done.stdout
