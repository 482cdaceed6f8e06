"""The process between a simulator process and the program of a host.

It starts the program, writes a bounded part of its standard error into the server's
log, and ends it with every process that it started, also those that left its process
group: on Linux orphans become children of this process. It does so when the program
ends, or when this process's standard input does: a simulator process that is killed
closes it. Then it removes the program's temporary directory.

Started as `python -I -S supervisor.py PLAN`, in 20 ms: it imports little, and nothing
of this project. Standard output: one line of JSON, when the program has ended or could
not be started.
"""

from __future__ import annotations

import contextlib
import ctypes
import errno
import json
import os
import select
import signal
import sys
import time

_PR_SET_CHILD_SUBREAPER = 36
_END_OF_INPUT_S = 2.0  # the time that the program has after the end of its input
_KILL_S_MAX = 10.0
_LINE_MAX = 500
_LINES_AT_ONCE, _LINES_PER_S = 200, 20
_BYTES_PER_S = 4 << 20  # what writes more waits
_READ_BYTES = 1 << 16
# Another start later may succeed, and no program can help it.
_OF_MACHINE = {errno.EAGAIN, errno.ENOMEM, errno.EMFILE, errno.ENFILE}


class ErrorOutput:
    """Writes the program's standard error into the log: whole lines, not too many."""

    def __init__(self, name: str) -> None:
        self.last_line = ""
        self._prefix = f"simulator {name}: "
        self._rest = b""
        self._lines_left = float(_LINES_AT_ONCE)
        self._lines_at = time.monotonic()
        self._left_out = 0

    def write(self, data: bytes) -> None:
        *lines, self._rest = (self._rest + data).split(b"\n")
        if len(self._rest) > _LINE_MAX:
            lines.append(self._rest)
            self._rest = b""
        now = time.monotonic()
        regained = (now - self._lines_at) * _LINES_PER_S
        self._lines_left = min(self._lines_left + regained, _LINES_AT_ONCE)
        self._lines_at = now
        for line in lines:
            self._write_line(line)

    def close(self) -> None:
        if self._rest:
            self._write_line(self._rest)
        self._say_what_is_left_out()

    def _write_line(self, line: bytes) -> None:
        # A terminal must not execute what a program prints.
        text = line[:_LINE_MAX].decode(errors="replace").rstrip()
        text = "".join(c if c.isprintable() or c == "\t" else "?" for c in text)
        if text:
            self.last_line = text
        if self._lines_left < 1:
            self._left_out += 1
            return
        self._say_what_is_left_out()
        self._lines_left -= 1
        self._print(text)

    def _say_what_is_left_out(self) -> None:
        if self._left_out:
            self._print(f"({self._left_out} more lines are left out)")
            self._left_out = 0

    def _print(self, text: str) -> None:
        with contextlib.suppress(OSError):  # the log may have ended
            os.write(2, f"{self._prefix}{text}\n".encode())


class Supervisor:
    """Starts one program; `run` returns when nothing of it is left."""

    def __init__(
        self,
        name: str,
        command: list[str],
        folder: str,
        descriptors: list[int],
        temporary: str,
    ) -> None:
        self._command, self._folder, self._descriptors = command, folder, descriptors
        self._status: int | None = None
        self._stderr = ErrorOutput(name)
        self._woken, wake = os.pipe()
        for end in (self._woken, wake):
            os.set_blocking(end, False)
        signal.set_wakeup_fd(wake, warn_on_full_buffer=False)
        signal.signal(signal.SIGCHLD, lambda *_: None)
        for number in (signal.SIGINT, signal.SIGHUP):  # of a terminal: the server's
            signal.signal(number, signal.SIG_IGN)
        if sys.platform == "linux":
            ctypes.CDLL(None).prctl(_PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0)
        self._directory = _make_directory(temporary)

    def run(self) -> None:
        try:
            self._start()
        except OSError as error:
            is_of_machine = error.errno in _OF_MACHINE
            _report(
                could_not_start=error.strerror or str(error), of_machine=is_of_machine
            )
        else:
            self._relay()
            self._kill_everything()
            self._drain()
            self._stderr.close()
            _report(status=self._status, last_line=self._stderr.last_line)
        _remove(self._directory)

    def _start(self) -> None:
        command, ends = self._command, self._descriptors
        self._errors, theirs = os.pipe()
        os.set_blocking(self._errors, False)
        environment = _environment() | {"TMPDIR": self._directory}
        try:
            os.chdir(self._folder)
            for end in ends:
                os.set_inheritable(end, False)
            self._pid = os.posix_spawnp(
                command[0],
                command,
                environment,
                file_actions=[
                    (os.POSIX_SPAWN_DUP2, end, place)
                    for place, end in enumerate([*ends, theirs])
                ],
                setsid=True,
                setsigdef=[signal.SIGINT, signal.SIGPIPE],
            )
        finally:
            for end in (*ends, theirs):
                os.close(end)

    def _relay(self) -> None:
        """Returns when the program has ended, or has had its time to end."""
        poll = select.poll()
        poll.register(0, select.POLLIN)
        poll.register(self._errors, select.POLLIN)
        poll.register(self._woken, select.POLLIN)
        end_at = float("inf")
        second, read_bytes = time.monotonic(), 0
        while self._status is None and (now := time.monotonic()) < end_at:
            if now - second > 1.0:
                if read_bytes >= _BYTES_PER_S:
                    poll.register(self._errors, select.POLLIN)
                second, read_bytes = now, 0
            for end, _ in poll.poll(200 if end_at < now + 9 or read_bytes else None):
                if end == 0 and not os.read(0, 1):
                    poll.unregister(0)
                    end_at = now + _END_OF_INPUT_S
                elif end == self._woken:
                    os.read(self._woken, 4096)
                elif end == self._errors:
                    data = self._read_errors()
                    read_bytes += len(data)
                    if not data or read_bytes >= _BYTES_PER_S:
                        poll.unregister(self._errors)
            self._reap()

    def _read_errors(self) -> bytes:
        try:
            data = os.read(self._errors, _READ_BYTES)
        except BlockingIOError:
            return b""
        self._stderr.write(data)
        return data

    def _drain(self) -> None:
        """Read its last lines, which often say why the program ended."""
        for _ in range(_BYTES_PER_S // _READ_BYTES):
            if not self._read_errors():
                return

    def _reap(self) -> bool:
        """Whether a child is left."""
        try:
            while True:
                pid, status = os.waitpid(-1, os.WNOHANG)
                if pid == 0:
                    return True
                if pid == self._pid:
                    self._status = os.waitstatus_to_exitcode(status)
        except ChildProcessError:
            return False

    def _kill_everything(self) -> None:
        """Kill children until none is left: orphans of killed ones become children."""
        until = time.monotonic() + _KILL_S_MAX
        while time.monotonic() < until:
            for pid in (-self._pid, *_children()):
                with contextlib.suppress(ProcessLookupError, PermissionError):
                    os.kill(pid, signal.SIGKILL)
            if not self._reap():
                return
            time.sleep(0.002)


def _environment() -> dict[str, str]:
    """The environment without tokens and keys, and without this project's packages.

    The program may be of another Python, which must not import the server's packages.
    """
    kept = {n: v for n, v in os.environ.items() if not n.startswith("PROCTOR_")}
    root = __file__.rsplit("/", 3)[0]
    paths = [p for p in kept.pop("PYTHONPATH", "").split(":") if p not in ("", root)]
    return kept | ({"PYTHONPATH": ":".join(paths)} if paths else {})


def _children() -> list[int]:
    """The process ids of this process's children; empty where the system hides them."""
    try:
        with open(f"/proc/self/task/{os.getpid()}/children", "rb") as file:  # noqa: PTH123
            return [int(pid) for pid in file.read().split()]
    except OSError:
        return []


def _make_directory(base: str) -> str:
    path = f"{base}/proctor-simulator-{os.getpid()}-{time.time_ns()}"
    os.mkdir(path, 0o700)  # noqa: PTH102
    return path


def _remove(directory: str) -> None:
    from shutil import rmtree  # costs 5 ms, which a start need not wait for

    rmtree(directory, ignore_errors=True)


def _report(**members: object) -> None:
    with contextlib.suppress(OSError):  # the simulator process may have ended
        os.write(1, json.dumps(members).encode() + b"\n")


def _main() -> None:
    try:
        supervisor = Supervisor(**json.loads(sys.argv[1]))
    except OSError as error:
        why = f"{error.filename or 'the system'}: {error.strerror}"
        _report(could_not_start=why, of_machine=True)
    else:
        supervisor.run()


if __name__ == "__main__":
    _main()
