"""Starts kits and broken servers by fork, so that their imports are paid for once.

An interpreter that imports the kit, or the server and all mutants, costs more than the
checks of one rule. One process for each kind imports what it needs and then forks:
every kit and every server is still a process and a session of its own, in the state
that follows the imports. A small client (`forked.py`) stands for the process: it passes
on its output, its signals and its end. Knows nothing of rules and verdicts. Linux only.
"""

from __future__ import annotations

import contextlib
import importlib
import json
import os
import pkgutil
import selectors
import signal
import socket
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).parents[2]
CLIENT = Path(__file__).with_name("forked.py")
START_S = 120.0
REQUEST_BYTES_MAX = 1 << 20


@dataclass(frozen=True, slots=True)
class Commands:
    """How a kit and a mutant are started; the mutant's name follows."""

    kit: tuple[str, ...]
    server: tuple[str, ...]


PLAIN = Commands(
    (sys.executable, "-m", "conformance"),
    (sys.executable, "-m", "tests.mutants.serve"),
)


@contextlib.contextmanager
def fork_servers() -> Iterator[Commands]:
    """Start both for a while; where they cannot work, give the plain commands."""
    if not hasattr(os, "pidfd_open"):
        yield PLAIN
        return
    with (
        tempfile.TemporaryDirectory(prefix="proctor-mutants-") as directory,
        _started("kit", Path(directory, "kit")) as kit,
        _started("server", Path(directory, "server")) as server,
    ):
        client = (sys.executable, "-S", "-I", str(CLIENT))
        yield Commands((*client, str(kit)), (*client, str(server)))


@contextlib.contextmanager
def forked_kit() -> Iterator[tuple[str, ...]]:
    """Start the fork server of the kit alone; give the command of a kit."""
    if not hasattr(os, "pidfd_open"):
        yield PLAIN.kit
        return
    with (
        tempfile.TemporaryDirectory(prefix="proctor-mutants-") as directory,
        _started("kit", Path(directory, "kit")) as kit,
    ):
        yield (sys.executable, "-S", "-I", str(CLIENT), str(kit))


@contextlib.contextmanager
def _started(kind: str, path: Path) -> Iterator[Path]:
    command = [sys.executable, "-m", "tests.mutants.fork_server", kind, str(path)]
    with subprocess.Popen(
        command, cwd=ROOT, stdin=subprocess.PIPE, stdout=subprocess.PIPE
    ) as process:
        assert process.stdin is not None
        assert process.stdout is not None
        assert process.stdout.readline() == b"ready\n", f"no fork server of a {kind}"
        try:
            yield path
        finally:
            process.stdin.close()  # ends it, as the end of this process would


# --- in the fork server ---


def _prepare_kit() -> Callable[[list[str]], int]:
    """Import everything that a kit imports, its checks as well."""
    import conformance.checks
    from conformance.cli.main import main
    from conformance.specification.ledger import load_ledger

    load_ledger()
    for late in (
        "conformance.runner.execution",
        "httpcore",
        "stringprep",
    ):
        importlib.import_module(late)  # otherwise imported when first needed
    folder = conformance.checks
    for found in pkgutil.walk_packages(folder.__path__, f"{folder.__name__}."):
        importlib.import_module(found.name)
    return main


def _prepare_server() -> Callable[[list[str]], int]:
    from reference_server.__main__ import main
    from tests.mutants import load

    mutants = load()
    importlib.import_module("sqlalchemy.dialects.sqlite.aiosqlite")

    def serve(arguments: list[str]) -> int:
        name, *sys.argv[1:] = arguments
        mutants[name].patch()
        return int(main() or 0)

    return serve


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
    kind, path = sys.argv[1:]
    work = {"kit": _prepare_kit, "server": _prepare_server}[kind]()
    with socket.socket(socket.AF_UNIX) as listener:
        listener.bind(path)
        listener.listen()
        sys.stdout.write("ready\n")
        sys.stdout.flush()
        arguments = _ForkServer(listener).run()
    return 0 if arguments is None else work(arguments)


if __name__ == "__main__":
    sys.exit(main())
