"""A policy that tries to escape is ended or refused, and its log says which of both.

`test_escape_attempts.py` has every attempt; here each kind is the whole policy.
"""

from __future__ import annotations

import os
import socket
from collections.abc import Iterator
from dataclasses import replace

import pytest

from reference_platform.sandbox.bubblewrap import BubblewrapMaker
from reference_platform.sandbox.sandbox_interface import SandboxSpec
from tests.support.platform.sandboxes import (
    SMALL,
    WrittenLog,
    python_command,
    system_binds,
)

CONNECT = "import socket; socket.socket(socket.{0}).connect({1})"
CALL = "import ctypes; ctypes.CDLL(None).{0}(0, 0, 0, 0)"
NOT_ALLOWED = "The policy was killed: it made a system call that is not allowed."
# Kind → the policy, and what its log has of the refusal.
ESCAPES = {
    "network, IPv4": (CONNECT.format("AF_INET", "('192.0.2.1', 80)"), "unreachable"),
    "network, IPv6": (CONNECT.format("AF_INET6", "('2001:db8::1', 80)"), "OSError"),
    "network, netlink": ("import socket; socket.socket(socket.AF_NETLINK)", "OSError"),
    "network, packets": (
        "import socket; socket.socket(socket.AF_PACKET, socket.SOCK_RAW)",
        "OSError",
    ),
    "server": (CONNECT.format("AF_INET", "('127.0.0.1', PORT)"), "refused"),
    "files of the host": ("open('/etc/shadow')", "No such file"),
    "other submissions": ("import os; os.listdir('/srv')", "No such file"),
    "memory of the server": ("open('/proc/PID/mem')", "No such file"),
    "signals": ("import os; os.kill(PID, 9)", "No such process"),
    "setuid": ("import os; os.setuid(0)", "OSError: [Errno 22]"),
    "devices": ("import os; os.mknod('/tmp/a', 0o60666, 2048)", "not permitted"),
    "ptrace": (CALL.format("ptrace"), NOT_ALLOWED),
    "mounts": (CALL.format("mount"), NOT_ALLOWED),
    "namespaces": (CALL.format("unshare"), NOT_ALLOWED),
    "fork bomb": (
        "import os, time\nwhile True:\n  if os.fork() == 0: time.sleep(9)",
        "limit was reached",
    ),
    "memory": (
        "a = []\nwhile True: a.append(bytearray(b'x' * 2**24))",
        "limit was reached",
    ),
    "disk": (
        (
            "import time\nfile = open('/tmp/large', 'wb', 0)\n"
            "try:\n  while True: file.write(bytes(2**20))\n"
            "except OSError: time.sleep(60)"
        ),
        "The disk limit of /tmp was reached.",
    ),
    "descriptors": ("a = []\nwhile True: a.append(open('/'+'dev/null'))", "Too many"),
    "time": ("while True: pass", "the longest time that it may"),
}


@pytest.fixture(scope="module")
def port() -> Iterator[int]:
    """A server of the host."""
    with socket.create_server(("127.0.0.1", 0)) as listener:
        yield int(listener.getsockname()[1])


@pytest.mark.parametrize("kind", ESCAPES)
async def test_the_log_says_how_an_escape_was_refused(kind: str, port: int) -> None:
    code, refusal = ESCAPES[kind]
    code = code.replace("PORT", str(port)).replace("PID", str(os.getpid()))
    limits = replace(SMALL, wall_clock_s=2.0 if kind in ("disk", "time") else 30.0)
    command = [python_command(), "-c", code]
    log = WrittenLog()
    spec = SandboxSpec(command, binds=system_binds(), limits=limits)
    sandbox = await BubblewrapMaker().start(spec, log)
    end = await sandbox.wait()
    written = [text for _, text in log.lines]
    assert any(refusal in text for text in written), written
    assert log.lines[-1] == ("platform", f"The sandbox has ended. {end.reason}")
    assert "exit code 0" not in end.reason
