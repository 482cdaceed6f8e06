"""The interface of a sandbox for the runner of submissions.

`bubblewrap.py` is the implementation. Another one, for a node of a cluster or for a
container engine, gives the same promises: the policy reaches no network, no file of the
host and no other process; it has the limits of its specification; and when `close`
returns, no process, mount or file of it is left.
"""

from __future__ import annotations

import socket
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Literal, Protocol, TypeAlias

# Where the policy listens, inside the sandbox; also in its environment, by this name.
SOCKET_PATH = "/run/policy.sock"
SOCKET_VARIABLE = "PROCTOR_POLICY_SOCKET"
# Where code that was uploaded for a preset is.
CODE_PATH = "/policy"

MIB = 2**20
Source: TypeAlias = Literal["policy", "platform"]


class SandboxUnavailable(Exception):
    """This host cannot make sandboxes; the message says what to install or change."""


class NotListening(Exception):
    """The policy does not listen at its socket, or not any more."""


class WriteLine(Protocol):
    """Receives the log; lines are durable when it returns. Called by other threads."""

    def __call__(self, source: Source, text: str, /) -> None: ...


@dataclass(frozen=True, slots=True)
class Limits:
    """The limits of one sandbox.

    disk_bytes: of each of its two writable folders, /tmp and /dev/shm; they are in
    memory, and count as such. wall_clock_s: from the start to the end.
    """

    cpus: float = 2.0
    memory_bytes: int = 4096 * MIB
    processes: int = 256
    disk_bytes: int = 1024 * MIB
    open_files: int = 1024
    wall_clock_s: float = 3600.0


@dataclass(frozen=True, slots=True)
class SandboxSpec:
    """The program that is started, and all that it sees.

    root: a folder that becomes `/`, read-only; without one, `/` has only the binds.
    binds: path in the sandbox → path of the host, read-only.
    """

    command: Sequence[str]
    root: Path | None = None
    binds: Mapping[str, Path] = field(default_factory=dict)
    environment: Mapping[str, str] = field(default_factory=dict)
    directory: str = "/"
    limits: Limits = Limits()


@dataclass(frozen=True, slots=True)
class SandboxEnd:
    """reason: a sentence for people. is_by_platform: the platform ended it.

    is_killed: something killed it that was neither the platform nor a limit of the
    sandbox. Whether that was the policy itself or a program of the host cannot be seen.
    is_lost: a fault of the host ended it, for certain. cpu_s: that all its processes
    used, where this can be seen.
    """

    reason: str
    is_by_platform: bool
    is_killed: bool = False
    is_lost: bool = False
    cpu_s: float | None = None


class Sandbox(Protocol):
    """A policy that was started."""

    def connect(self) -> socket.socket:
        """A new connection to the policy's socket. Raises NotListening."""

    @property
    def end(self) -> SandboxEnd | None:
        """How it ended; None: it runs."""

    async def wait(self) -> SandboxEnd:
        """Returns once it has ended, and its whole output is in the log."""

    async def close(self, reason: str) -> SandboxEnd:
        """End it, if it has not ended; nothing of it is left when this returns."""


class SandboxMaker(Protocol):
    """Starts sandboxes."""

    def enforcement(self, limits: Limits) -> str:
        """How limits are enforced, in a few sentences for the host."""

    async def start(self, spec: SandboxSpec, write: WriteLine) -> Sandbox:
        """Raises SandboxUnavailable."""
