"""A hostile policy is refused whatever it tries, and its log says so.

One sandbox makes all attempts, one after another; each test reads what came of one.
"""

from __future__ import annotations

import asyncio
import ctypes
import json
import os
import socket
from pathlib import Path
from typing import Any

import pytest

from reference_platform.sandbox.bubblewrap import BubblewrapMaker
from reference_platform.sandbox.sandbox_interface import SandboxEnd, SandboxSpec
from tests.support.paths import ROOT
from tests.support.platform.sandboxes import (
    SMALL,
    WrittenLog,
    open_folder,
    python_command,
    system_binds,
)

PROGRAM = ROOT / "tests" / "support" / "platform" / "escape_attempts.py"
CALLS = [
    *("add_key", "bpf", "chroot", "clock_settime", "clone3", "finit_module", "fsopen"),
    *("init_module", "io_uring_setup", "kexec_load", "keyctl", "mount", "open_tree"),
    *("open_by_handle_at", "perf_event_open", "pidfd_getfd", "pivot_root", "ptrace"),
    *("process_vm_readv", "process_vm_writev", "quotactl", "reboot", "request_key"),
    *("setns", "sethostname", "settimeofday", "swapon", "syslog", "umount2"),
    *("unshare", "userfaultfd"),
]
# How an attempt ends that no system call refuses; another end is a hole in the test.
REFUSED_BY = {
    "memory": "SIGKILL",  # the control group's; without one it is a MemoryError
    "fork bomb": "BlockingIOError",
    "disk": "OSError: [Errno 28]",
    "shared memory": "OSError: [Errno 28]",
    "disk, socket folder": "OSError: [Errno 28]",
    "descriptors": "OSError: [Errno 24]",
    "loopback of the host": "ConnectionRefusedError",
    "network, IPv4": "OSError: [Errno 101]",
    "system call of another convention": "SIGSYS",
    "new user namespace by clone": "OSError: [Errno 38]",
}


async def run_to_end(spec: SandboxSpec, log: WrittenLog) -> SandboxEnd:
    sandbox = await BubblewrapMaker().start(spec, log)
    return await sandbox.wait()


@pytest.fixture(scope="module")
def attempts() -> Any:
    """Attempt → how it was refused; with the log and the end of the sandbox."""
    library = ctypes.CDLL("libseccomp.so.2")

    def number(name: str) -> int:
        return int(library.seccomp_syscall_resolve_name(name.encode()))

    abstract = f"proctor-test-{os.getpid()}"
    with (
        open_folder() as folder,
        socket.create_server(("127.0.0.1", 0)) as tcp,
        socket.socket(socket.AF_UNIX) as unix,
        socket.socket(socket.AF_UNIX) as nameless,
    ):
        unix.bind(str(folder / "server.sock"))
        (folder / "server.sock").chmod(0o777)
        unix.listen()
        nameless.bind("\0" + abstract)
        nameless.listen()
        (folder / "secret").write_text("secret")
        facts = {
            "host_pid": os.getpid(),
            "port": tcp.getsockname()[1],
            "abstract": abstract,
            "socket": str(folder / "server.sock"),
            "secret": str(folder / "secret"),
            "folder": str(folder),
            "calls": {name: number(name) for name in CALLS},
            "clone": number("clone"),
            "getpid": number("getpid"),
        }
        program = folder / "program"
        program.mkdir()
        (program / PROGRAM.name).write_bytes(PROGRAM.read_bytes())
        spec = SandboxSpec(
            command=[python_command(), f"/policy/{PROGRAM.name}", json.dumps(facts)],
            binds=system_binds() | {"/policy": program},
            limits=SMALL,
        )
        log = WrittenLog()
        end = asyncio.run(run_to_end(spec, log))
        refusals: dict[str, str | None] = {}
        for line in log.of("policy"):
            if line.startswith("{"):
                outcome = json.loads(line)
                refusals[outcome["attempt"]] = outcome["refused"]
        return refusals, log, end


def attempt_names() -> list[str]:
    """As the program has them."""
    text = PROGRAM.read_text()
    table = text[text.index("ATTEMPTS = {") : text.index("def attempt_in_child")]
    names = [line.split('"')[1] for line in table.splitlines() if line[:5] == '    "']
    return [*names, *(f"system call {name}" for name in CALLS)]


@pytest.mark.parametrize("name", attempt_names())
def test_an_attempt_is_refused(
    attempts: tuple[dict[str, str | None], WrittenLog, SandboxEnd], name: str
) -> None:
    refusals, log, end = attempts
    assert name in refusals, (log.lines[-5:], end)
    refused = refusals[name]
    assert refused is not None, "the attempt succeeded"
    expected = REFUSED_BY.get(name, "")
    assert refused.startswith((expected, "MemoryError") if expected else "")


def test_what_the_limits_refused_is_in_the_log(
    attempts: tuple[dict[str, str | None], WrittenLog, SandboxEnd],
) -> None:
    written = "\n".join(attempts[1].of("platform"))
    assert "The memory limit was reached" in written
    assert "The process limit was reached" in written


def test_nothing_is_left(
    attempts: tuple[dict[str, str | None], WrittenLog, SandboxEnd],
) -> None:
    assert attempts[2].reason == "The policy ended by itself, with exit code 0."
    commands = [
        path.read_bytes()
        for path in Path("/proc").glob("[0-9]*/cmdline")
        if os.access(path, os.R_OK)
    ]
    assert not [command for command in commands if b"/policy/escape" in command]
    assert not list(Path("/sys/fs/cgroup").glob(f"**/proctor-sandbox-{os.getpid()}-*"))
