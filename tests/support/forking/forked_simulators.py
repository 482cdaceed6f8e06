"""The simulators of a forked server: their fork server is forked as well.

As a new interpreter it would cost more than the checks of one rule. It is forked before
its server is broken and while that has one thread, so it is what a new interpreter
would be: the fork server of simulators that are right.
"""

import os
import select
import signal
import socket
import subprocess
from typing import Never, cast

from reference_sim.process import fork_server, simulator_main, simulator_process

_start_new = simulator_process.spawn


def fork_simulators() -> None:
    """Fork what this process will start first; later ones are started as ever."""
    ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
    pid = os.fork()
    if pid == 0:
        ours.close()
        _serve(theirs)
    theirs.close()
    waiting = [_Forked(pid, ours)]

    def spawn(module: str, connection: socket.socket) -> subprocess.Popen[bytes]:
        if not waiting or module != fork_server.__name__:
            return _start_new(module, connection)
        forked = waiting.pop()
        forked.begin(connection)
        return cast("subprocess.Popen[bytes]", forked)

    simulator_process.spawn = spawn


class _Forked:
    """The used part of a process that was started: its id, its end, its death."""

    def __init__(self, pid: int, control: socket.socket) -> None:
        self.pid, self._control = pid, control

    def begin(self, connection: socket.socket) -> None:
        with self._control:
            socket.send_fds(self._control, [b"begin"], [connection.fileno()])

    def wait(self, timeout_s: float = 60.0) -> None:
        end = os.pidfd_open(self.pid)
        try:
            ends = select.poll()
            ends.register(end, select.POLLIN)
            if not ends.poll(1000 * timeout_s):
                raise subprocess.TimeoutExpired("a fork server", timeout_s)
        finally:
            os.close(end)
        os.waitpid(self.pid, 0)

    def kill(self) -> None:
        os.kill(self.pid, signal.SIGKILL)


def _serve(control: socket.socket) -> Never:
    """Be what `spawn` starts, as soon as the server wants it."""
    status = 1
    try:
        os.setpgid(0, 0)
        with control:
            _, descriptors, _, _ = socket.recv_fds(control, 64, 1)
        if descriptors:  # otherwise the server has ended
            environment = simulator_process._inherited_environment()
            os.environ.clear()
            os.environ.update(environment)
            simulator_main.log_to_stderr()
            fork_server.ForkServer(socket.socket(fileno=descriptors[0])).run()
        status = 0
    finally:
        os._exit(status)
