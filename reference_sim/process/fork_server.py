"""The process that forks simulator processes, in 4 ms instead of 75 ms each.

Large packages are imported once, here. It simulates and renders nothing and has one
thread, so forking is safe. It ends with its parent, and its children end with it. Linux
only. `python -m reference_sim.process.fork_server FD`; FD is a SEQPACKET socket:

- a message with a descriptor: fork, and serve on that descriptor;
- a message without a descriptor: the process id of a child to kill. The id cannot
  belong to another process meanwhile, because only this process reaps its children;
- end-of-file: the parent has ended; all children are killed.
"""

from __future__ import annotations

import contextlib
import ctypes
import gc
import logging
import os
import select
import signal
import socket
import sys
from typing import Never

from reference_record.command_line.closed_output import leave_signals_to_parent
from reference_sim.picture_store import PICTURES
from reference_sim.process import simulator_main

_PR_SET_PDEATHSIG = 1
_log = logging.getLogger(__name__)


class ForkServer:
    """Forks, reaps and kills simulator processes for the peer of `control`."""

    def __init__(self, control: socket.socket) -> None:
        self._control = control
        self._pid = os.getpid()
        self._children: set[int] = set()
        self._libc = ctypes.CDLL(None)
        self._ended, self._on_end = socket.socketpair()
        self._on_end.setblocking(False)

    def run(self) -> None:
        """Returns when the parent and all children have ended."""
        leave_signals_to_parent()
        signal.signal(signal.SIGCHLD, self._reap)
        # A signal that comes just before a wait begins does not end it; a byte that it
        # writes does. Otherwise a child would stay a zombie until the next message.
        signal.set_wakeup_fd(self._on_end.fileno(), warn_on_full_buffer=False)
        PICTURES.open()  # inherited by every child
        gc.collect()
        gc.freeze()  # so that a child's garbage collection copies no shared pages
        while True:
            ready, _, _ = select.select([self._control, self._ended], [], [])
            if self._ended in ready:
                self._ended.recv(4096)  # `_reap` has been called
            if self._control not in ready:
                continue
            message, descriptors, _, _ = socket.recv_fds(self._control, 64, 1)
            if not message:
                return self._end()
            # No child may be reaped between the lookup and the signal.
            signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGCHLD})
            if descriptors:
                self._fork(descriptors[0])
            elif (target_pid := int(message)) in self._children:
                os.kill(target_pid, signal.SIGKILL)
            signal.pthread_sigmask(signal.SIG_UNBLOCK, {signal.SIGCHLD})

    def _fork(self, descriptor: int) -> None:
        child = os.fork()
        if child == 0:
            self._become_simulator(descriptor)
        self._children.add(child)
        os.close(descriptor)

    def _become_simulator(self, descriptor: int) -> Never:
        """Run as a simulator process; called in the child."""
        try:
            self._libc.prctl(_PR_SET_PDEATHSIG, int(signal.SIGKILL), 0, 0, 0)
            if os.getppid() == self._pid:  # otherwise it died before prctl
                signal.signal(signal.SIGCHLD, signal.SIG_DFL)
                signal.set_wakeup_fd(-1)
                signal.pthread_sigmask(signal.SIG_UNBLOCK, {signal.SIGCHLD})
                for own in (self._control, self._ended, self._on_end):
                    own.close()
                simulator_main.serve(socket.socket(fileno=descriptor))
        except BaseException:  # noqa: BLE001 - nothing may return into `run`
            _log.exception("simulator process failed")
        os._exit(1)

    def _reap(self, *_: object) -> None:
        for child in list(self._children):
            # The handler may interrupt itself; the inner call has then reaped it.
            with contextlib.suppress(ChildProcessError):
                if os.waitpid(child, os.WNOHANG)[0] == child:
                    self._children.discard(child)

    def _end(self) -> None:
        signal.signal(signal.SIGCHLD, signal.SIG_DFL)
        for child in self._children:
            os.kill(child, signal.SIGKILL)
        for child in self._children:
            os.waitpid(child, 0)


if __name__ == "__main__":
    simulator_main.log_to_stderr()
    ForkServer(socket.socket(fileno=int(sys.argv[1]))).run()
