"""The commit that is checked out: what every measured page names."""

import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def read_commit(*paths: str) -> tuple[str, str]:
    """Give its short id and its day, as in `2026-11-22`.

    paths: give the last commit that changed one of them instead.
    """
    command = ["git", "log", "-1", "--date=short", "--format=%h %cd", "--", *paths]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True)
    commit, date = done.stdout.split()
    return commit, date
