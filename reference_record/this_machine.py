"""The part of this machine that a process may use, which changes while it runs."""

from __future__ import annotations

import os
import tempfile
import threading
from pathlib import Path

_CGROUPS = Path("/sys/fs/cgroup")
_MEMBERSHIP = Path("/proc/self/cgroup")


def temporary_folder() -> str:
    """The folder for temporary files, chosen anew where the last choice is gone.

    `tempfile` chooses once, for as long as the process lives; a job's folder and what
    cleaners of /tmp remove end before that. Raises FileNotFoundError for none.
    """
    chosen = tempfile.tempdir
    if chosen is not None and not os.access(chosen, os.W_OK | os.X_OK):
        tempfile.tempdir = None
    return tempfile.gettempdir()


def unusable_temporary_folder() -> str:
    """Say which folder of the environment is not used, and which is; else empty."""
    named = os.environ.get("TMPDIR")
    if not named:
        return ""
    try:
        folder = temporary_folder()
    except OSError as error:
        return f"temporary files cannot be written: {error.strerror}"
    if Path(folder) == Path(named).absolute():
        return ""
    why = "cannot be written" if Path(named).is_dir() else "is not there"
    return f"TMPDIR is {named}, which {why}: temporary files are written to {folder}"


def usable_processors() -> int:
    """How many processors this process may use; the machine may have more.

    The affinity of the process counts, and the quota of its control group: containers
    and batch systems have the one or the other.
    """
    allowed = os.cpu_count() or 1
    if hasattr(os, "sched_getaffinity"):
        allowed = len(os.sched_getaffinity(0))
    return max(1, min(allowed, *(_quotas() or [allowed])))


def start_if_possible(thread: threading.Thread) -> bool:
    """Start a thread that only says something, unless the system refuses one more."""
    try:
        thread.start()
    except RuntimeError:
        return False
    return True


def _quotas() -> list[int]:
    """The processors of each control group above this process that has a quota."""
    try:
        lines = _MEMBERSHIP.read_text().splitlines()
    except OSError:
        return []
    found = []
    for line in lines:
        _, controllers, path = line.split(":", 2)
        if controllers in ("", "cpu,cpuacct", "cpu"):
            folder = _CGROUPS / controllers
            group = folder / path.strip("/")
            groups = [group, *group.parents]
            for part in groups[: groups.index(folder) + 1]:
                found += _quota(part)
    return found


def _quota(group: Path) -> list[int]:
    """Of version 2, `max 100000` or `200000 100000`, or of version 1, in two files."""
    try:
        if (group / "cpu.max").exists():
            quota, period = (group / "cpu.max").read_text().split()
        else:
            quota = (group / "cpu.cfs_quota_us").read_text()
            period = (group / "cpu.cfs_period_us").read_text()
        return [-(-int(quota) // int(period))] if int(quota) > 0 else []
    except (OSError, ValueError):  # there is no quota
        return []
