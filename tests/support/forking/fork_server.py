"""Starts processes of one program by fork, so that its imports are paid for once.

An interpreter that imports the kit, or the server, costs more than most tests of it.
`python -m tests.support.forking.fork_server MODULE:FUNCTION SOCKET` calls the function,
which imports what the program needs and gives its `main`, and then forks: each process
is one of its own, in a session of its own, in the state that follows the imports. Who
asks is a `ForkedProcess`, or `stand_in.py` where a command is needed. Linux only.
"""

import atexit
import contextlib
import functools
import gc
import importlib
import json
import os
import selectors
import signal
import socket
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path

from tests.support.paths import ROOT

CLIENT = Path(__file__).with_name("stand_in.py")
REQUEST_BYTES_MAX = 1 << 20
CAN_FORK = hasattr(os, "pidfd_open")

Main = Callable[[list[str]], int]


@contextlib.contextmanager
def fork_server(prepare: str) -> Iterator[Path]:
    """Start one for a while; gives its socket. prepare: `MODULE:FUNCTION`."""
    with tempfile.TemporaryDirectory(prefix="proctor-forks-") as directory:
        path = Path(directory, "socket")
        command = [sys.executable, "-m", __spec__.name, prepare, str(path)]
        with subprocess.Popen(
            command,
            cwd=ROOT,
            env={**os.environ, "OPENBLAS_NUM_THREADS": "1"},  # fewer threads to fork
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
        ) as process:
            assert process.stdin is not None
            assert process.stdout is not None
            assert process.stdout.readline() == b"ready\n", f"no fork server: {prepare}"
            try:
                yield path
            finally:
                process.stdin.close()  # ends it, as the end of this process would


@functools.cache
def shared_forks(prepare: str) -> Path:
    """The socket of this process's one fork server of a program, until its end."""
    stack = ExitStack()
    atexit.register(stack.close)
    return stack.enter_context(fork_server(prepare))


def stand_in(path: Path) -> tuple[str, ...]:
    """The command of a process that stands for a forked one; arguments follow."""
    return (sys.executable, "-S", "-I", str(CLIENT), str(path))


# --- in the fork server ---


@dataclass(slots=True)
class _Child:
    pid: int
    pidfd: int
    client: socket.socket


class _ForkServer:
    def __init__(self, listener: socket.socket) -> None:
        self._listener = listener
        self._selector = selectors.DefaultSelector()
        self._selector.register(listener, selectors.EVENT_READ)
        self._selector.register(sys.stdin, selectors.EVENT_READ)

    def run(self) -> list[str] | None:
        """Fork for each client. Returns its arguments in a child, None at the end."""
        while True:
            ready = [key for key, _ in self._selector.select()]
            # Ends come first: what a client starts next may need the same port.
            ready.sort(key=lambda key: key.fileobj is self._listener)
            for key in ready:
                if key.fileobj is sys.stdin:
                    self._end_all()
                    return None
                if isinstance(key.data, _Child):
                    self._on_child(key.data, is_end=key.fileobj == key.data.pidfd)
                elif (arguments := self._accept()) is not None:
                    return arguments

    def _accept(self) -> list[str] | None:
        client, _ = self._listener.accept()
        request, fds, _, _ = socket.recv_fds(client, REQUEST_BYTES_MAX, 2)
        while not request.endswith(b"\n"):
            more = client.recv(REQUEST_BYTES_MAX)
            if not more:
                break
            request += more
        job = json.loads(request)
        pid = os.fork()
        if pid == 0:
            self._become(job, fds)
            return [str(argument) for argument in job["arguments"]]
        for fd in fds:
            os.close(fd)
        client.sendall(b"%d\n" % pid)
        child = _Child(pid, os.pidfd_open(pid), client)
        self._selector.register(child.pidfd, selectors.EVENT_READ, child)
        self._selector.register(client, selectors.EVENT_READ, child)
        return None

    def _become(self, job: dict[str, object], fds: list[int]) -> None:
        os.setsid()
        for key in list(self._selector.get_map().values()):
            if isinstance(key.data, _Child) and key.fileobj is key.data.client:
                key.data.client.close()
                os.close(key.data.pidfd)
        self._selector.close()
        self._listener.close()
        nothing = os.open(os.devnull, os.O_RDONLY)
        for number, fd in enumerate([nothing, *fds]):
            os.dup2(fd, number)
            os.close(fd)
        os.environ.clear()
        environment = job["environment"]
        assert isinstance(environment, dict)
        os.environ.update(environment)
        os.chdir(str(job["directory"]))

    def _on_child(self, child: _Child, *, is_end: bool) -> None:
        if child.client.fileno() < 0:
            return  # both ended at once
        if not is_end and (request := child.client.recv(1)):
            with contextlib.suppress(ProcessLookupError):
                os.kill(child.pid, request[0])
            return
        self._end(child)

    def _end(self, child: _Child) -> None:
        """The child has ended, or its client has: the rest of its session ends too."""
        self._selector.unregister(child.pidfd)
        self._selector.unregister(child.client)
        with contextlib.suppress(ProcessLookupError, PermissionError):
            os.killpg(child.pid, signal.SIGKILL)
        _, status = os.waitpid(child.pid, 0)
        os.close(child.pidfd)
        code = os.waitstatus_to_exitcode(status)
        with contextlib.suppress(OSError):
            child.client.sendall(b"%d\n" % (code if code >= 0 else 128 - code))
        child.client.close()

    def _end_all(self) -> None:
        for key in list(self._selector.get_map().values()):
            if isinstance(key.data, _Child) and key.fileobj is key.data.client:
                self._end(key.data)


def main() -> int:
    prepare, path = sys.argv[1:]
    module, _, function = prepare.partition(":")
    program: Main = getattr(importlib.import_module(module), function)()
    with socket.socket(socket.AF_UNIX) as listener:
        listener.bind(path)
        listener.listen()
        gc.collect()
        gc.freeze()  # no child looks through what was imported
        sys.stdout.write("ready\n")
        sys.stdout.flush()
        arguments = _ForkServer(listener).run()
    return 0 if arguments is None else program(arguments)


if __name__ == "__main__":
    sys.exit(main())
