"""A server process that the kit starts, kills and restarts.

Environment variables give the command its address, tokens and database (PROCTOR_HOST,
PROCTOR_PORT, PROCTOR_TOKENS, PROCTOR_DATABASE), and allow it to call policies on this
machine (PROCTOR_ALLOW_PRIVATE_POLICIES). It runs in its own process group, so that its
children end with it.
"""

import contextlib
import os
import secrets
import shlex
import shutil
import signal
import socket
import subprocess
import tempfile
import threading
import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import IO

import httpx

from conformance.client.connections.connection_pool import Connections
from conformance.client.connections.loopback import in_url, loopback, probing_socket

_START_S = 60.0
_ANSWER_S = 10.0
_ENDS_S = 0.5  # how long what closes its connections may take to end
_STOP_S = 5.0
_POLL_S = 0.02
# A file system in memory, which containers often make small.
_MEMORY = "/dev/shm"  # noqa: S108 - the directory in it has a random name
_MEMORY_FREE_BYTES = 2**30
_CLAIMS_MAX = 100


class StartFailed(Exception):
    """The command did not become a server."""


@dataclass(frozen=True)
class AccountTokens:
    """Two accounts, and a token of the first that may only read."""

    alice: str
    bob: str
    reader: str

    @classmethod
    def generate(cls) -> "AccountTokens":
        """Generate random tokens."""
        return cls(*(secrets.token_hex(16) for _ in range(3)))

    def as_setting(self) -> str:
        """Write them in the format of PROCTOR_TOKENS."""
        return (
            f"alice:read+run:{self.alice},bob:read+run:{self.bob}"
            f",alice:read:{self.reader}"
        )


@contextlib.contextmanager
def open_directory() -> Iterator[Path]:
    """Make a directory for the database of one server; it ends with the block.

    In memory where there is room: what a server has stored outlives its SIGKILL there,
    too, and each of its thousands of commits would wait for the disk.
    """
    has_room = os.access(_MEMORY, os.W_OK) and (
        shutil.disk_usage(_MEMORY).free >= _MEMORY_FREE_BYTES
    )
    place = _MEMORY if has_room else None
    with tempfile.TemporaryDirectory(prefix="proctor-conformance-", dir=place) as made:
        yield Path(made)


@contextlib.contextmanager
def claim_port() -> Iterator[int]:
    """Give a free port that no other kit on this machine is given in the block.

    A command listens only some time after its port was chosen, and not while it is
    restarted: in these times the port is as free for all others. A file claims it.
    """
    for _ in range(_CLAIMS_MAX):
        port = _free_port()
        claim = Path(tempfile.gettempdir()) / f"proctor-conformance-port-{port}"
        with contextlib.suppress(FileExistsError):
            claim.touch(mode=0o600, exist_ok=False)
            break
    else:
        raise StartFailed(
            f"{_CLAIMS_MAX} free ports in succession are claimed by files as {claim}: "
            "delete them if no other kit is running"
        )
    try:
        yield port
    finally:
        claim.unlink(missing_ok=True)


class ServerProcess:
    """One server on a port of this machine, with a database in a directory."""

    def __init__(
        self,
        command: str,
        tokens: AccountTokens,
        *,
        directory: Path,
        port: int,
        log: Path,
    ) -> None:
        self.url = f"http://{in_url(loopback())}:{port}"
        self._command = shlex.split(command)
        self._tokens = tokens
        self._database = directory / "conformance.sqlite3"
        self._log = log
        self._output: IO[bytes] | None = None
        self._process: subprocess.Popen[bytes] | None = None
        self._port = port
        self._is_closed = False
        self._lock = threading.Lock()

    def start(self, public_url: str | None = None) -> None:
        """Start it and wait until it responds.

        public_url: that of the service it is a node of, "" for its own; None if it is
        a service of itself.

        Raises StartFailed, also while what was started before still listens.
        """
        self._wait_until_free()
        self._log.parent.mkdir(parents=True, exist_ok=True)
        self._output = self._log.open("ab")
        environment = os.environ | {
            "PROCTOR_HOST": loopback(),
            "PROCTOR_PORT": str(self._port),
            "PROCTOR_TOKENS": self._tokens.as_setting(),
            "PROCTOR_DATABASE": str(self._database),
            # The address of the policy server of the kit, for the profile push.
            "PROCTOR_ALLOW_PRIVATE_POLICIES": loopback(),
        }
        if public_url is not None:
            environment["PROCTOR_PUBLIC_URL"] = public_url or self.url
        with self._lock:
            if self._is_closed:
                raise StartFailed("the kit ends")
            try:
                self._process = subprocess.Popen(
                    self._command,
                    env=environment,
                    stdin=subprocess.DEVNULL,
                    stdout=self._output,
                    stderr=subprocess.STDOUT,
                    start_new_session=True,
                )
            except OSError as error:
                raise StartFailed(f"`{self._command[0]}`: {error}") from error
        self._wait_until_ready(self._process)

    def start_again(self) -> None:
        """Start it on the port that it had; twice, if that was taken for a moment."""
        try:
            self.start()
        except StartFailed:
            self.stop()
            self.start()

    def _wait_until_free(self) -> None:
        """Wait for the end of what listened, so that it answers nothing after a kill.

        A process that its command has put into another group may end a little later.
        """
        deadline = time.monotonic() + _STOP_S
        while not _is_free(self._port):
            if time.monotonic() > deadline:
                raise StartFailed(
                    f"port {self._port} is still in use {_STOP_S:g} s after the "
                    f"processes of `{self._command[0]}` were killed: the server must "
                    "run in their process group, not in a container or a session of "
                    "its own; or use --restart-cmd"
                )
            time.sleep(_POLL_S)

    def _wait_until_ready(self, process: subprocess.Popen[bytes]) -> None:
        deadline = time.monotonic() + _START_S
        while time.monotonic() < deadline:
            if process.poll() is not None:
                raise StartFailed(
                    f"the command exited with code {process.returncode} before it "
                    f"served requests; end of its output: {self.log_tail()}"
                )
            if _is_listening(self._port):
                with (
                    contextlib.suppress(httpx.RequestError),
                    contextlib.closing(Connections()) as connections,
                ):
                    connections.get(f"{self.url}/v1", timeout_s=_ANSWER_S)
                    return
            time.sleep(_POLL_S)
        reason = f"nothing listens on port {self._port}, which PROCTOR_PORT names"
        if _is_listening(self._port):
            reason = f"it listens, and answered no request within {_ANSWER_S:g} s"
        raise StartFailed(
            f"no response from {self.url}/v1 within {_START_S:g} s: {reason}; end of "
            f"its output: {self.log_tail()}"
        )

    def starts_without_data(self) -> bool:
        """Whether the command serves on the same port with an empty database."""
        self.stop()
        kept = self._database
        self._database = kept.with_name("empty.sqlite3")
        try:
            self.start_again()
        except StartFailed:
            return False
        finally:
            self.stop()
            self._database = kept
        return True

    def wait_for_exit_code(self, within_s: float) -> int | None:
        """Give that of a process which ended although the kit did not end it."""
        if self._process is not None:
            with contextlib.suppress(subprocess.TimeoutExpired):
                return self._process.wait(within_s)
        return None

    def log_tail(self) -> str:
        """Give the end of its output."""
        lines = self._log.read_text(errors="replace").split("\n")
        return " | ".join(line.strip() for line in lines if line.strip())[-400:]

    def kill9(self) -> None:
        """Kill it at once, with its children."""
        self._signal(signal.SIGKILL)
        self._reap()

    def close(self) -> None:
        """Kill it from another thread than the one that uses it, and start no other."""
        with self._lock:
            self._is_closed = True
            self._signal(signal.SIGKILL)

    def stop(self) -> None:
        """Terminate it; kill it after a timeout."""
        if self._process is None:
            return
        self._signal(signal.SIGTERM)
        with contextlib.suppress(subprocess.TimeoutExpired):
            self._process.wait(_STOP_S)
        # Children that outlived the leader of the group end here.
        self._signal(signal.SIGKILL)
        self._reap()

    def _signal(self, number: signal.Signals) -> None:
        process = self._process  # another thread may reap it meanwhile
        if process is not None:
            with contextlib.suppress(ProcessLookupError, PermissionError):
                os.killpg(process.pid, number)

    def _reap(self) -> None:
        if self._process is not None:
            self._process.wait()
            self._process = None
        if self._output is not None:
            self._output.close()
            self._output = None


def name_end(processes: Sequence[ServerProcess], problem: str) -> str:
    """Add to a problem that the server has ended by itself, if that is the reason."""
    for process in processes:
        code = process.wait_for_exit_code(_ENDS_S)
        if code is not None:
            return (
                f"the command exited with code {code} while it served requests; end of "
                f"its output: {process.log_tail() or 'nothing'}; {problem}"
            )
    return problem


def _is_listening(port: int) -> bool:
    with probing_socket() as probe:
        return probe.connect_ex((loopback(), port)) == 0


def _is_free(port: int) -> bool:
    """Whether a server could listen: what has ended leaves connections in TIME_WAIT.

    Binds, for a connection would wait in the queue of a server that accepts no more.
    """
    with probing_socket() as probe:
        probe.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            probe.bind((loopback(), port))
        except OSError:
            return False
    return True


def _free_port() -> int:
    with probing_socket() as probe:
        probe.bind((loopback(), 0))
        port: int = probe.getsockname()[1]
        return port
