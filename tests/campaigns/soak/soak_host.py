"""A host under random faults of its programs, its databases and its disk.

Its folder of submissions is a file system of its own, if this process may mount one:
so it can be full. After a kill `ensure_running` starts it, as a service manager does.
"""

from __future__ import annotations

import asyncio
import contextlib
import os
import signal
import sqlite3
import subprocess
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from random import Random

import psutil

from reference_platform.accounts.organisations import Owner
from reference_platform.images.image_reviews import ImageReviews
from reference_platform.parts import Parts
from tests.support.platform.approved_accounts import approved, key_of, quick_parts
from tests.support.platform.hosted_server import HostedServer, mail_receiver, track_file
from tests.support.platform.sandboxes import open_folder
from tests.support.platform.uploaded_policies import write_preset
from tests.support.ports import free_port

DISK = "1300M"  # more than what the platform leaves free
# A policy that does not listen or answer is to fail soon.
_OPTIONS = ("--sandboxes", "3", "--policy-start-s", "15", "--policy-call-s", "4")
_GONE_S = 40.0


class SoakHost(HostedServer):
    """mark: in the environment of every program that it starts, but sandboxes."""

    def __init__(self, directory: Path, smtp: str, submissions: Path) -> None:
        self.mark = f"soak-{os.getpid()}-{time.monotonic_ns()}"
        os.environ["SOAK_MARK"] = self.mark
        self.pids: list[int] = []
        self.starts = 0
        super().__init__(
            directory, smtp, submissions, options=_OPTIONS, port=free_port()
        )

    def start(self, *server_options: str) -> None:
        super().start(*server_options)
        self.pids.append(self.process.pid)
        self.starts += 1

    def ensure_running(self) -> None:
        if self.process.poll() is not None:
            assert self.process.stdout is not None
            self.process.stdout.close()
            self.start()

    def keys_of(self, names: list[str]) -> list[str]:
        """Keys of new approved accounts that have entered the track."""
        self.put_track(track_file("soak", "total = 100000"))
        parts = quick_parts(self.database)
        with contextlib.closing(parts.database):
            for name in names:
                asyncio.run(approved(parts, name))
                parts.tracks.enter("soak", Owner(name))
            day_s = 86_400
            return [
                key_of(parts, name, "read", "run", lifetime_s=day_s) for name in names
            ]

    def approve_images(self) -> None:
        """Those that wait; a database that is locked now is asked the next time."""
        with contextlib.suppress(Exception):
            parts = Parts.of(self.database)
            with contextlib.closing(parts.database):
                reviews = ImageReviews(parts.database)
                for image in reviews.in_state("waiting"):
                    reviews.decide(image.digest, "approve", "", "the campaign")

    def programs(self) -> list[psutil.Process]:
        """All that the host has started, the sandboxes included."""
        with contextlib.suppress(psutil.NoSuchProcess):
            return psutil.Process(self.process.pid).children(recursive=True)
        return []

    def find(self, kind: str) -> list[psutil.Process]:
        """Programs of one kind, by what `KINDS` says about a process."""
        found = []
        for process in self.programs():
            with contextlib.suppress(psutil.Error):
                if KINDS[kind](process):
                    found.append(process)
        return found

    # --- what is left ---

    def files_left(self) -> list[str]:
        """Uploads, unpacked roots and sockets."""
        assert self.submissions is not None
        found: list[Path] = []
        for pattern in ("uploads/*/*", "roots/*", "roots/.new-*", "sockets/*"):
            found += self.submissions.glob(pattern)
        return [str(path.relative_to(self.submissions)) for path in found]

    def groups_left(self) -> list[str]:
        names = [f"proctor-sandbox-{pid}-" for pid in self.pids]
        groups = Path("/sys/fs/cgroup").glob("**/proctor-sandbox-*")
        return [path.name for path in groups if path.name.startswith(tuple(names))]

    def processes_left(self) -> list[str]:
        """The host has ended; list programs that it started."""
        found = []
        for process in psutil.process_iter():
            with contextlib.suppress(psutil.Error):
                words = " ".join(process.cmdline())
                is_ours = str(self.submissions) in words
                is_ours |= process.environ().get("SOAK_MARK") == self.mark
                if is_ours and process.pid != os.getpid():
                    found.append(words)
        return found


def _is_bubblewrap(process: psutil.Process) -> bool:
    return process.name() == "bwrap"


def _parent_name(process: psutil.Process) -> str:
    parent = process.parent()
    return "" if parent is None else str(parent.name())


def _is_fork_server(process: psutil.Process) -> bool:
    """Or one of its simulators, which have its command line."""
    return "reference_sim.process.fork_server" in process.cmdline()


def _is_simulator(process: psutil.Process) -> bool:
    parent = process.parent()
    is_forked = parent is not None and _is_fork_server(parent)
    return is_forked and _is_fork_server(process)


# The first process of a sandbox is the child of bubblewrap's, and the policy is its.
KINDS: dict[str, Callable[[psutil.Process], bool]] = {
    "server": lambda p: "reference_server" in p.cmdline(),
    "bubblewrap": lambda p: _is_bubblewrap(p) and _parent_name(p) != "bwrap",
    "first process": lambda p: _is_bubblewrap(p) and _parent_name(p) == "bwrap",
    "policy": lambda p: not _is_bubblewrap(p) and _parent_name(p) == "bwrap",
    "unpacking": lambda p: any("unpack_program" in word for word in p.cmdline()),
    "fork server": lambda p: _is_fork_server(p) and not _is_simulator(p),
    "simulator": _is_simulator,
}


@contextmanager
def soak_host(directory: Path) -> Iterator[SoakHost]:
    with open_folder() as folder, mail_receiver() as mail:
        submissions = folder / "submissions"
        submissions.mkdir(mode=0o711)
        with _mounted(submissions):
            write_preset(submissions / "presets")
            host = SoakHost(directory, mail.url, submissions)
            try:
                yield host
            finally:
                if host.process.poll() is None:
                    host.end(signal.SIGKILL)


@contextmanager
def _mounted(place: Path) -> Iterator[None]:
    """Where this user may mount nothing, it is a folder, and is never full."""
    options = f"size={DISK},mode=0711"
    command = ["mount", "-t", "tmpfs", "-o", options, "soak", str(place)]
    is_mounted = subprocess.run(command, capture_output=True, check=False).returncode
    try:
        yield
    finally:
        if is_mounted == 0:
            subprocess.run(["umount", "--lazy", place], check=True)


# --- faults: each returns whether it could happen now ---


def kill(kind: str) -> Callable[[SoakHost, Random], bool]:
    """kind: of programs; "platform" is the host itself."""

    def happen(host: SoakHost, chance: Random) -> bool:
        if kind == "platform":
            host.process.kill()
            host.process.wait()
            return True
        deadline = time.monotonic() + 2.0
        while not (found := host.find(kind)) and time.monotonic() < deadline:
            time.sleep(0.02)
        if not found:
            return False
        with contextlib.suppress(psutil.NoSuchProcess):
            chance.choice(found).kill()
        if kind == "server":  # the host ends with it
            host.process.wait(_GONE_S)
        return True

    return happen


def lock(name: str) -> Callable[[SoakHost, Random], bool]:
    """A database is busy, for longer than its programs wait."""

    def happen(host: SoakHost, chance: Random) -> bool:
        connection = sqlite3.connect(host.directory / name, timeout=5.0)
        with contextlib.closing(connection):
            try:
                connection.execute("BEGIN IMMEDIATE")
            except sqlite3.OperationalError:
                return False
            time.sleep(chance.uniform(1.0, 8.0))
            connection.rollback()
        return True

    return happen


def fill_disk(host: SoakHost, chance: Random) -> bool:
    """No byte is free in the folder of submissions; then all are again."""
    place = host.submissions
    assert place is not None
    usage = os.statvfs(place)
    used = (usage.f_blocks - usage.f_bfree) * usage.f_frsize
    if not place.is_mount() or not _resize(place, str(used + 4096)):
        return False
    time.sleep(chance.uniform(1.0, 6.0))
    return _resize(place, DISK)


def _resize(place: Path, size: str) -> bool:
    command = ["mount", "-o", f"remount,size={size}", str(place)]
    return subprocess.run(command, capture_output=True, check=False).returncode == 0


FAULTS: dict[str, Callable[[SoakHost, Random], bool]] = {
    "platform killed": kill("platform"),
    "server killed": kill("server"),
    "bubblewrap killed": kill("bubblewrap"),
    "first process killed": kill("first process"),
    "policy killed": kill("policy"),
    "unpacking killed": kill("unpacking"),
    "fork server killed": kill("fork server"),
    "simulator killed": kill("simulator"),
    "platform's database locked": lock("platform.sqlite"),
    "server's database locked": lock("proctor.sqlite"),
    "disk full": fill_disk,
}
