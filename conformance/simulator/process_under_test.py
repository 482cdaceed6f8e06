"""One simulator under test: a process that is started, or a connection to one.

Knows frames and no calls. Everything that a process starts inherits a mark in its
environment, by which it is found when the process has ended.
"""

import contextlib
import os
import select
import signal
import socket
import struct
import subprocess
import threading
import time
import uuid
from collections.abc import Sequence
from pathlib import Path

LENGTH = struct.Struct(">I")
_MARK = "SIMULATOR_UNDER_TEST"
_END_S = 5.0
_KEPT_BYTES = 2000  # of standard error


class NoFrame(Exception):
    """Nothing, or something else than a frame, has come; the text says what."""


class TooSlow(NoFrame):
    """No frame has come in its time."""


class Ended(NoFrame):
    """The output has ended."""


class _Frames:
    """Frames that are read from a descriptor, `_output`."""

    _output: int

    def __init__(self) -> None:
        self._received = bytearray()

    def read_frame(self, timeout_s: float, bytes_max: int) -> bytes:
        """The body of the next frame. Raises NoFrame."""
        until = time.monotonic() + timeout_s
        self._fill(LENGTH.size, until)
        (length,) = LENGTH.unpack_from(self._received)
        if length > bytes_max:
            begin = bytes(self._received[:40])
            raise NoFrame(
                f"{begin!r}…, a length of {length} bytes; {bytes_max} is most"
            )
        self._fill(LENGTH.size + length, until)
        body = bytes(self._received[LENGTH.size : LENGTH.size + length])
        del self._received[: LENGTH.size + length]
        return body

    def read_rest(self, wait_s: float) -> bytes:
        """Bytes that it writes, within some time, although nothing was requested."""
        until = time.monotonic() + wait_s
        with contextlib.suppress(NoFrame):
            while len(self._received) < _KEPT_BYTES:
                self._fill(len(self._received) + 1, until)
        return bytes(self._received)

    def _fill(self, size: int, until: float) -> None:
        while len(self._received) < size:
            left_s = max(0.0, until - time.monotonic())
            if not select.select([self._output], [], [], left_s)[0]:
                raise TooSlow(f"{len(self._received)} of {size} bytes in time")
            try:
                data = os.read(self._output, max(1 << 16, size - len(self._received)))
            except ConnectionError:
                data = b""
            if not data:
                raise Ended(f"the output ended after {len(self._received)} bytes")
            self._received += data


class ConnectionUnderTest(_Frames):
    """A connection to a simulator at a socket. Raises OSError."""

    last_error_line = ""

    def __init__(self, path: str) -> None:
        super().__init__()
        self._connection = socket.socket(socket.AF_UNIX)
        try:
            self._connection.connect(path)
        except OSError:
            self._connection.close()
            raise
        self._output = self._connection.fileno()

    def send(self, data: bytes) -> None:
        """Send bytes. Raises Ended."""
        try:
            self._connection.sendall(data)
        except OSError as error:
            raise Ended(f"the connection is closed ({error.strerror})") from error

    def wait(self, timeout_s: float) -> int | None:
        """0 when the connection has ended; None if it goes on."""
        until = time.monotonic() + timeout_s
        try:
            while True:
                self._fill(len(self._received) + 1, until)
        except Ended:
            return 0
        except TooSlow:
            return None

    def end(self) -> None:
        self._connection.close()


class ProcessUnderTest(_Frames):
    """A running simulator. Raises OSError if it cannot be started."""

    def __init__(self, command: Sequence[str]) -> None:
        super().__init__()
        self._mark = f"{_MARK}={uuid.uuid4()}"
        name, _, value = self._mark.partition("=")
        self._process = subprocess.Popen(
            command,
            env=os.environ | {name: value},
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            bufsize=0,
            process_group=0,  # what it starts is ended with it
        )
        assert self._process.stdout is not None
        self._output = self._process.stdout.fileno()
        self._errors = b""
        threading.Thread(target=self._read_errors, daemon=True).start()

    def _read_errors(self) -> None:
        assert self._process.stderr is not None
        with contextlib.suppress(OSError, ValueError):
            while data := self._process.stderr.read(1 << 16):
                self._errors = (self._errors + data)[-_KEPT_BYTES:]

    @property
    def last_error_line(self) -> str:
        """The last line of its standard error; empty if there is none."""
        lines = self._errors.decode(errors="replace").strip().splitlines()
        return lines[-1][:200] if lines else ""

    def send(self, data: bytes) -> None:
        """Write to its standard input. Raises Ended."""
        assert self._process.stdin is not None
        try:
            while data:
                data = data[self._process.stdin.write(data) :]
        except OSError as error:
            raise Ended(f"its standard input is closed ({error.strerror})") from error

    def close_input(self) -> None:
        """End its standard input."""
        assert self._process.stdin is not None
        with contextlib.suppress(OSError):
            self._process.stdin.close()

    def wait(self, timeout_s: float) -> int | None:
        """Its exit code, negative for a signal; None if it runs on."""
        with contextlib.suppress(subprocess.TimeoutExpired):
            return self._process.wait(timeout_s)
        return None

    def others(self) -> list[int]:
        """The processes that it started and that still run; none without /proc."""
        found = []
        for path in Path("/proc").glob("[0-9]*/environ"):
            pid = int(path.parent.name)
            with contextlib.suppress(OSError):
                if (
                    pid != self._process.pid
                    and self._mark.encode() in path.read_bytes()
                ):
                    found.append(pid)
        return found

    def end(self) -> None:
        with contextlib.suppress(ProcessLookupError, PermissionError):
            os.killpg(self._process.pid, signal.SIGKILL)
        for pid in self.others():
            with contextlib.suppress(ProcessLookupError, PermissionError):
                os.kill(pid, signal.SIGKILL)
        self._process.wait(_END_S)
        for stream in (self._process.stdin, self._process.stdout):
            if stream is not None:
                with contextlib.suppress(OSError):
                    stream.close()
