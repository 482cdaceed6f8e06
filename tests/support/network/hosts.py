"""Hosts: network namespaces with addresses of their own, on one bridge.

They stand for machines: packets between two of them can be dropped in silence, in one
direction or in both, and a link can be slow. All of them lie inside the namespaces of
one process (`run_inside`), which the kernel removes with it, however it ends: programs,
addresses and file systems too. The bridge has no way out, so no packet leaves it.

Programs: iproute2 and util-linux. A wall clock of its own is not to be had this way:
a time namespace shifts the clocks since boot alone, which differ between machines, too.
"""

import contextlib
import ctypes
import itertools
import os
import shutil
import subprocess
import sys
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from typing import TypeVar

import pytest

from tests.support.paths import ROOT
from tests.support.processes import run_program

Made = TypeVar("Made")
NETWORK = "10.77.0.0/24"
_INSIDE = "PROCTOR_TESTS_INSIDE_HOSTS"  # in the environment of what `run_inside` runs
_NAMESPACES = Path("/run/netns")
_BRIDGE = "hosts"
# It ends with the process that started it, and what it started ends with it.
_UNSHARE = (
    "setpriv --pdeathsig KILL "
    "unshare --net --mount --pid --fork --kill-child --mount-proc"
)
# The first process of a namespace adopts orphans and has to wait for them; sh does.
# Temporary files vanish with the namespaces, too.
_MOUNT = 'mkdir -p "$0" && mount -t tmpfs hosts "$0" && mkdir -m 1777 "$0/files"'
_FIRST = (
    *("sh", "-c", f'{_MOUNT} && TMPDIR="$0/files" "$@"; exit $?'),
    str(_NAMESPACES),
)
# A packet to this address reaches no host, and nothing answers that it does not.
_LOST = "02:00:00:00:00:fe"
_PROGRAMS = ("setpriv", "unshare", "nsenter", "ip", "tc", "mount")


def is_inside() -> bool:
    """Whether this process may make hosts."""
    return _INSIDE in os.environ


def run_inside(command: Sequence[str]) -> int:
    """Run a program that may make hosts; its exit code."""
    whole = [*_UNSHARE.split(), *_FIRST, *command]
    environment = os.environ | {_INSIDE: "1"}
    return subprocess.run(whole, check=False, cwd=ROOT, env=environment).returncode


def why_none() -> str:
    """The reason why no hosts can be made here; empty where they can."""
    if missing := [name for name in _PROGRAMS if shutil.which(name) is None]:
        return f"hosts need {', '.join(missing)}, which is not installed"
    tried = run_program(
        [*_UNSHARE.split(), *_FIRST, sys.executable, "-m", __name__],
        cwd=ROOT,
        env=os.environ | {_INSIDE: "1"},
    )
    if tried.returncode == 0:
        return ""
    last = (tried.stderr.strip().splitlines() or ["no reason given"])[-1]
    return f"this machine lets no hosts be made: {last}"


def plays_inside(request: pytest.FixtureRequest) -> bool:
    """Whether the test goes on here; else it was run inside, or cannot be run."""
    if is_inside():
        return True
    if reason := why_none():
        pytest.skip(reason)
    test = [sys.executable, "-m", "pytest", "-n", "0", "-q", request.node.nodeid]
    assert run_inside([*test, "-m", ""]) == 0, "the test failed inside; see above"
    return False


@dataclass(frozen=True)
class Host:
    """address: its own. namespace: empty for this process's host, `Hosts.here`."""

    name: str
    address: str
    namespace: str = ""

    @property
    def device(self) -> str:
        return "eth0" if self.namespace else _BRIDGE

    @property
    def port(self) -> str:
        """Name of the other end of its link, at the bridge."""
        return f"to-{self.name}"[:15]

    def command(
        self, command: Sequence[str | Path], account: int | None = None
    ) -> list[str | Path]:
        """A command line that runs a program there, under the same process id."""
        if not self.namespace:
            return list(command)
        enter = ["nsenter", f"--net={_NAMESPACES / self.namespace}"]
        if account is not None:
            enter += ["--setuid", str(account), "--setgid", str(account)]
        return [*enter, "--", *command]


class Hosts:
    """Made once in a process that `run_inside` runs. here: its own host."""

    def __init__(self) -> None:
        assert is_inside(), "hosts are made by a program that run_inside runs"
        self._numbers = itertools.count(1)
        self.here = Host("here", self._next_address())
        self._hosts = [self.here]
        for line in (
            "link set lo up",
            f"link add {_BRIDGE} type bridge",
            f"address add {self.here.address}/24 dev {_BRIDGE}",
            f"link set {_BRIDGE} up",
        ):
            _ip(line)
        self._lost: set[tuple[Host, Host]] = set()
        self._slow: set[Host] = set()

    def _next_address(self) -> str:
        return NETWORK.replace("0/24", str(next(self._numbers)))

    def add(self, name: str) -> Host:
        """One more host."""
        host = Host(name, self._next_address(), name)
        for line in (
            f"netns add {name}",
            f"link add {host.port} type veth peer name {host.device} netns {name}",
            f"link set {host.port} master {_BRIDGE} up",
            f"-netns {name} address add {host.address}/24 dev {host.device}",
            f"-netns {name} link set {host.device} up",
            f"-netns {name} link set lo up",
        ):
            _ip(line)
        self._hosts.append(host)
        return host

    # --- ways ---

    def lose_way(self, sender: Host, receiver: Host) -> None:
        """Let every packet from one to the other vanish; the way back stays."""
        self._lost.add((sender, receiver))
        _ip(
            f"{_in(sender)} neighbour replace {receiver.address} lladdr {_LOST} "
            f"dev {sender.device} nud permanent"
        )

    def partition(self, one: Host, *others: Host) -> None:
        """Let every packet between one host and these, or all, vanish."""
        for other in others or self._hosts:
            if other is not one:
                self.lose_way(one, other)
                self.lose_way(other, one)

    def slow(self, host: Host, delay_ms: int, kbit_s: int) -> None:
        """Delay what a host sends and receives; without netem, by a low rate alone."""
        self._slow.add(host)
        rate = f"tbf rate {kbit_s}kbit burst 4kb latency 1s"
        delay = f"netem delay {delay_ms}ms rate {kbit_s}kbit"
        for beginning in (
            f"tc qdisc replace dev {host.port} root",
            f"tc -netns {host.namespace} qdisc replace dev {host.device} root",
        ):
            if _try(*beginning.split(), *delay.split()):
                _run(*beginning.split(), *rate.split())

    def heal(self) -> None:
        """All ways are as at first."""
        for sender, receiver in self._lost:
            what = f"neighbour del {receiver.address} dev {sender.device}"
            _ip(f"{_in(sender)} {what}")
        for host in self._slow:
            _run(*f"tc qdisc del dev {host.port} root".split())
            where = f"-netns {host.namespace} qdisc del dev {host.device} root"
            _run("tc", *where.split())
        self._lost.clear()
        self._slow.clear()


def within(host: Host, make: Callable[[], Made]) -> Made:
    """Call `make` in a thread that is on this host: its sockets stay there."""

    def run() -> Made:
        with (_NAMESPACES / host.namespace).open() as namespace:
            if ctypes.CDLL(None, use_errno=True).setns(namespace.fileno(), 0):
                raise OSError(ctypes.get_errno(), f"{host.name} cannot be entered")
        return make()

    with ThreadPoolExecutor(1) as thread:
        return thread.submit(run).result()


class Disk:
    """A small file system of its own at a folder, of so many megabytes."""

    def __init__(self, folder: Path, size_mb: int) -> None:
        folder.mkdir(parents=True, exist_ok=True)
        self._filler = folder / ".filler"
        _run(*f"mount -t tmpfs -o size={size_mb}m disk".split(), str(folder))

    def fill(self) -> None:
        """Let every later write fail for want of room."""
        with self._filler.open("wb", buffering=0) as file:
            for size in (2**20, 2**12):
                with contextlib.suppress(OSError):
                    while True:
                        file.write(bytes(size))

    def clear(self) -> None:
        """Give the room back."""
        self._filler.unlink(missing_ok=True)

    def remove(self) -> None:
        """With all that is there; the folder stays."""
        _run("umount", "--lazy", str(self._filler.parent))


def _in(host: Host) -> str:
    return f"-netns {host.namespace}" if host.namespace else ""


def _ip(line: str) -> None:
    _run("ip", *line.split())


def _run(*command: str) -> None:
    if reason := _try(*command):
        raise OSError(f"{' '.join(command)}: {reason}")


def _try(*command: str) -> str:
    """Why the command failed; empty where it did not."""
    done = run_program(command)
    return "" if done.returncode == 0 else done.stderr.strip() or "it failed"


if __name__ == "__main__":
    Hosts().add("tried")
