"""Limits of memory, processes and CPU for all processes of a sandbox together.

Control groups of version 1 or 2, where this process may make them; the sandbox's groups
are below the groups of this process, so that limits on the platform hold for both. A
host where they cannot be made has only the limits of single processes: `ControlGroups`
says so, and `bubblewrap.py` sets these in any case.
"""

from __future__ import annotations

import contextlib
import errno
import os
import secrets
import signal
import time
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from reference_platform.sandbox.sandbox_interface import Limits

_ROOT = Path("/sys/fs/cgroup")
_CONTROLLERS = ("cpu", "memory", "pids")
_ACCOUNTING = "cpuacct"  # version 1; it limits nothing, and may be missing
_CPU_PERIOD_US = 100_000
_REMOVE_S = 10.0
_PLATFORM = "proctor-platform"  # version 2; the group of the platform's own process
_PREFIX = "proctor-sandbox-"  # then the platform's process, and a random name


@dataclass(frozen=True, slots=True)
class ControlGroup:
    """The group of one sandbox: one folder, or with version 1 one per controller."""

    folders: tuple[Path, ...]

    @property
    def entrances(self) -> tuple[Path, ...]:
        """A process enters the group by writing its number to each of these files."""
        return tuple(folder / "cgroup.procs" for folder in self.folders)

    def refusals(self) -> list[str]:
        """A sentence for each kind of thing that the group has refused."""
        texts = []
        killed = self._count(("memory.events", "memory.oom_control"), "oom_kill")
        if killed:
            texts.append(f"The memory limit was reached; processes killed: {killed}.")
        if refused := self._count(("pids.events",), "max"):
            texts.append(f"The process limit was reached; refused: {refused}.")
        return texts

    def cpu_s(self) -> float | None:
        """The time of processors that its processes used, if the kernel counts it."""
        for folder in self.folders:
            with contextlib.suppress(OSError, ValueError):
                return int((folder / "cpuacct.usage").read_text()) / 1e9
        microseconds = self._count(("cpu.stat",), "usage_usec")
        return microseconds / 1e6 if microseconds else None

    def remove(self) -> None:
        """Kill what is in the group, and remove it. Returns when it is empty."""
        deadline = time.monotonic() + _REMOVE_S
        for folder in self.folders:
            while folder.exists():
                try:
                    folder.rmdir()
                except OSError:  # a process that was killed is not gone yet
                    if time.monotonic() > deadline:
                        raise
                    _kill_all(folder)
                    time.sleep(0.005)

    def _count(self, names: tuple[str, ...], key: str) -> int:
        for folder in self.folders:
            for name in names:
                with contextlib.suppress(OSError, ValueError):
                    for line in (folder / name).read_text().splitlines():
                        word, _, count = line.partition(" ")
                        if word == key:
                            return int(count)
        return 0


class ControlGroups:
    """Makes the groups of sandboxes.

    problem: why they cannot be made here; None if they can.
    """

    def __init__(self, root: Path = _ROOT, own: str | None = None) -> None:
        """own: the text of /proc/self/cgroup."""
        own = Path("/proc/self/cgroup").read_text() if own is None else own
        self._folders, self._is_v2 = _own_folders(root, own)
        self.version = 2 if self._is_v2 else 1
        self.problem = self._find_problem()

    def make(self, limits: Limits) -> ControlGroup | None:
        """The group of a new sandbox; None where groups cannot be made."""
        if self.problem is not None:
            return None
        name = f"{_PREFIX}{_process_name(os.getpid())}-{secrets.token_hex(8)}"
        folders = tuple(dict.fromkeys(p / name for p in self._folders.values()))
        group = ControlGroup(folders)
        try:
            for folder in folders:
                folder.mkdir()
            for controller, settings in _settings(limits, is_v2=self._is_v2).items():
                folder = self._folders[controller] / name
                for file, value in settings.items():
                    (folder / file).write_text(value)
        except OSError:
            group.remove()
            raise
        return group

    def remove_left(self) -> None:
        """Remove the groups that killed platforms have left, with their processes."""
        left = {
            path.name
            for folder in self._folders.values()
            for path in folder.glob(f"{_PREFIX}*")
            if not _is_alive(path.name.removeprefix(_PREFIX).rpartition("-")[0])
        }
        for name in left:
            ControlGroup(tuple(p / name for p in self._folders.values())).remove()

    def _find_problem(self) -> str | None:
        missing = [name for name in _CONTROLLERS if name not in self._folders]
        if missing:
            return f"this process has no control group of {', '.join(missing)}"
        try:
            if self._is_v2:
                _delegate(self._folders["memory"])
            for folder in dict.fromkeys(self._folders.values()):
                trial = folder / f"proctor-trial-{os.getpid()}"
                trial.mkdir()
                trial.rmdir()
        except OSError as error:
            return f"control groups cannot be made ({error})"
        return None


def _process_name(number: int) -> str:
    """The number of a process and when it began: a number is given out again."""
    status = Path(f"/proc/{number}/stat").read_text().rpartition(")")[2].split()
    return f"{number}-{status[19]}"


def _is_alive(name: str) -> bool:
    number = name.partition("-")[0]
    try:
        return _process_name(int(number)) == name
    except (OSError, ValueError):
        return False


def _own_folders(root: Path, own: str) -> tuple[dict[str, Path], bool]:
    """controller → the group of this process, and whether that is version 2."""
    folders: dict[str, Path] = {}
    is_v2 = (root / "cgroup.controllers").is_file()
    for line in own.splitlines():
        _, names, path = line.split(":", 2)
        if is_v2 and not names:
            folder = root / path.lstrip("/")
            # A platform that is started again from the shell of an earlier one begins
            # in the group that the earlier one made for itself.
            if folder.name == _PLATFORM and _has_controllers(folder.parent):
                folder = folder.parent
            return dict.fromkeys(_CONTROLLERS, folder), True
        for name in names.split(","):
            # `cpu` and `cpuacct` may be two names of one folder.
            folder = (root / name / path.lstrip("/")).resolve()
            if name in (*_CONTROLLERS, _ACCOUNTING) and folder.is_dir():
                folders[name] = folder
    return folders, False


def _has_controllers(folder: Path) -> bool:
    """Whether groups below this one may have limits."""
    control = folder / "cgroup.subtree_control"
    return control.is_file() and set(_CONTROLLERS) <= set(control.read_text().split())


def _delegate(folder: Path) -> None:
    """Version 2: let the groups below have limits."""
    if _has_controllers(folder):
        return
    control = folder / "cgroup.subtree_control"
    added = " ".join(f"+{name}" for name in _CONTROLLERS)
    try:
        control.write_text(added)
    except OSError as error:
        if error.errno != errno.EBUSY:
            raise
        # Only the uppermost group may have processes beside groups with limits.
        own = folder / _PLATFORM
        own.mkdir(exist_ok=True)
        for number in (folder / "cgroup.procs").read_text().split():
            (own / "cgroup.procs").write_text(number)
        control.write_text(added)


def _settings(limits: Limits, *, is_v2: bool) -> Mapping[str, Mapping[str, str]]:
    """controller → file → value."""
    quota, memory = int(limits.cpus * _CPU_PERIOD_US), str(limits.memory_bytes)
    pids = {"pids.max": str(limits.processes)}
    if is_v2:
        cpu = {"cpu.max": f"{quota} {_CPU_PERIOD_US}"}
        most = {"memory.max": memory, "memory.swap.max": "0"}
        return {"cpu": cpu, "memory": most, "pids": pids}
    cpu = {"cpu.cfs_period_us": str(_CPU_PERIOD_US), "cpu.cfs_quota_us": str(quota)}
    return {"cpu": cpu, "memory": {"memory.limit_in_bytes": memory}, "pids": pids}


def _kill_all(folder: Path) -> None:
    with contextlib.suppress(OSError):
        for number in (folder / "cgroup.procs").read_text().split():
            os.kill(int(number), signal.SIGKILL)
