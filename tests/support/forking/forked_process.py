"""A forked process, used like a `subprocess.Popen`."""

import contextlib
import os
import select
import socket
import subprocess
from pathlib import Path
from typing import IO

from tests.support.forking.stand_in import ask
from tests.support.paths import ROOT


class ForkedProcess:
    """Runs from its construction until its end, or while it is referred to. stdout:
    what it prints, as text. pid: its own; it has no parent here."""

    def __init__(self, path: Path, environment: dict[str, str], stderr: int) -> None:
        """path: of the socket of a fork server. Raises OSError."""
        reader, writer = os.pipe()
        self.stdout: IO[str] = os.fdopen(reader)
        self.returncode: int | None = None
        self._server = socket.socket(socket.AF_UNIX)
        try:
            self._server.connect(str(path))
            ask(self._server, [], environment, str(ROOT), [writer, stderr])
        finally:
            os.close(writer)
        self.pid = int(self._answer())

    def _answer(self) -> bytes:
        """One line; nothing of the next one is read, for `select` to see it."""
        line = b""
        while not line.endswith(b"\n") and (byte := self._server.recv(1)):
            line += byte
        return line

    def poll(self) -> int | None:
        """The exit code, negative for a signal; None while it runs."""
        with contextlib.suppress(subprocess.TimeoutExpired):
            self.wait(0)
        return self.returncode

    def wait(self, timeout: float | None = None) -> int:
        """Raises TimeoutExpired."""
        if self.returncode is None:
            if not select.select([self._server], [], [], timeout)[0]:
                raise subprocess.TimeoutExpired("a forked process", timeout or 0)
            code = int(self._answer() or b"1")
            self.returncode = code if code < 128 else 128 - code
            self._server.close()
        return self.returncode

    def send_signal(self, number: int) -> None:
        """Harmless if it has ended."""
        if self.poll() is None:
            with contextlib.suppress(ProcessLookupError):
                os.kill(self.pid, number)
