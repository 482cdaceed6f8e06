"""Sandboxes for tests: folders that their users can enter, and a Python in them."""

from __future__ import annotations

import asyncio
import contextlib
import shutil
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path

from reference_platform.sandbox.sandbox_interface import MIB, Limits

SMALL = Limits(
    cpus=2.0,
    memory_bytes=256 * MIB,
    processes=48,
    disk_bytes=8 * MIB,
    open_files=256,
    wall_clock_s=60.0,
)


# A policy that sends back what it receives.
ECHO = """
import os, socket
listener = socket.socket(socket.AF_UNIX)
listener.bind(os.environ["PROCTOR_POLICY_SOCKET"])
listener.listen()
print("listening", flush=True)
while True:
    connection, _ = listener.accept()
    connection.sendall(connection.recv(100))
"""


@contextmanager
def open_folder() -> Iterator[Path]:
    """A new folder that any user may enter, as the root of a sandbox must be."""
    folder = Path(tempfile.mkdtemp(prefix="proctor-platform-"))
    folder.chmod(0o711)
    try:
        yield folder
    finally:
        shutil.rmtree(folder)


def python_command() -> str:
    """A Python of this machine that users of sandboxes can read."""
    path = shutil.which("python3", path="/usr/bin:/usr/local/bin")
    assert path is not None, "Install a Python for all users: apt-get install python3."
    return path


def system_binds() -> dict[str, Path]:
    """The programs and libraries of this machine, without its settings and data."""
    names = ("/usr", "/bin", "/lib", "/lib64")
    return {name: Path(name) for name in names if Path(name).exists()}


@dataclass
class WrittenLog:
    """Collects the lines of a log."""

    lines: list[tuple[str, str]] = field(default_factory=list)
    first: asyncio.Event = field(default_factory=asyncio.Event)
    loop: asyncio.AbstractEventLoop | None = None

    def __post_init__(self) -> None:
        with contextlib.suppress(RuntimeError):
            self.loop = asyncio.get_running_loop()

    def __call__(self, source: str, text: str, /) -> None:
        self.lines += [(source, line) for line in text.splitlines()]
        if self.loop is not None:
            self.loop.call_soon_threadsafe(self.first.set)

    def of(self, source: str) -> list[str]:
        return [text for written, text in self.lines if written == source]
