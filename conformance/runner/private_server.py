"""A server that a check may kill, or that no other check asks.

With `--start-cmd` every such check has a server to itself. The next check gets the same
one when it has passed, because to start a server costs more than most checks do. With
`--restart-cmd` it is the server under test, which the command kills and restarts; these
checks then run alone, after all others.
"""

import contextlib
import os
import shlex
import subprocess
import threading
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Protocol

import httpx

from conformance.client.check_context import CheckContext
from conformance.client.connections.connection_pool import Connections
from conformance.client.request_context import SharedContext
from conformance.run_settings import Settings
from conformance.runner.server_process import (
    AccountTokens,
    ServerProcess,
    StartFailed,
    claim_port,
    open_directory,
)
from conformance.verdicts.expect import SetUpFailed, Violation

_RESTART_S = 60.0
_LENT_SERVERS = "lent servers"
# To start one keeps a processor busy: more at a time would be ready no sooner, and
# would delay the checks that wait for a moment.
_SERVERS_MAX = max(2, os.cpu_count() or 1)
_ENDS_S = 0.5  # a connection breaks a little before its process has ended


class PrivateServer(Protocol):
    """A server that a crash check may kill and restart; `context` talks to it."""

    context: CheckContext

    def kill9(self) -> None:
        """Kill the server with SIGKILL."""

    def restart(self) -> None:
        """Restart it on the same data, and wait until it responds.

        Raises Violation where it does not and the data is the reason, SetUpFailed
        where anything else may be.
        """


class _OwnServer:
    def __init__(self, context: CheckContext, process: ServerProcess) -> None:
        self.context = context
        self._process = process
        self._killed_at = time.monotonic()

    def kill9(self) -> None:
        self._killed_at = self.context.begin_restart()
        self._process.kill9()

    def restart(self) -> None:
        try:
            self._process.start_again()
            self.context.end_restart(self._killed_at)
        except StartFailed as error:
            # The port or the machine may be the reason: the data is when the same
            # command serves without it.
            if self._process.starts_without_data():
                raise Violation(
                    "a server that serves again on the data that it left", str(error)
                ) from error
            raise SetUpFailed(f"server restart failed: {error}") from error


class _HookedServer:
    def __init__(self, context: CheckContext, command: str) -> None:
        self.context = context
        self._command = shlex.split(command)

    def kill9(self) -> None:
        """Do nothing: the command of the operator kills and restarts in one step."""

    def restart(self) -> None:
        began_at = self.context.begin_restart()
        self._restart()
        self.context.end_restart(began_at)

    def _restart(self) -> None:
        done = subprocess.run(
            self._command, capture_output=True, timeout=_RESTART_S, check=False
        )
        if done.returncode != 0:
            raise SetUpFailed(
                f"server restart failed: --restart-cmd exited with {done.returncode}"
            )
        deadline = time.monotonic() + _RESTART_S
        url = self.context.shared.settings.url
        while time.monotonic() < deadline:
            with (
                contextlib.suppress(httpx.RequestError),
                contextlib.closing(Connections()) as connections,
            ):
                connections.get(f"{url}/v1", timeout_s=2.0)
                return
            time.sleep(0.05)
        raise SetUpFailed("server restart failed: no response after --restart-cmd")


class LentServers:
    """Servers that the kit starts, each for one check at a time."""

    def __init__(self) -> None:
        self._turns = threading.Semaphore(_SERVERS_MAX)
        self._idle: list[tuple[ServerProcess, contextlib.ExitStack]] = []
        self._running: set[ServerProcess] = set()
        self._is_closed = False

    @contextlib.contextmanager
    def lend(self, settings: Settings, name: str) -> Iterator[ServerProcess]:
        """Give a server to the check of this name; end it with a check that raises."""
        with self._turns:
            process, ends = self._find_idle() or self._start(settings, name)
            with ends:
                yield process
                if _is_running(process):
                    self._idle.append((process, ends.pop_all()))

    def close(self) -> None:
        """Kill all, also those of checks whose end the kit does not wait for."""
        self._is_closed = True
        for process in list(self._running):
            process.close()
        while self._idle:
            _, ends = self._idle.pop()
            ends.close()

    def _find_idle(self) -> tuple[ServerProcess, contextlib.ExitStack] | None:
        """Give one that has not ended by itself since the check before."""
        while self._idle:
            process, ends = self._idle.pop()
            if _is_running(process):
                return process, ends
            ends.close()
        return None

    def _start(
        self, settings: Settings, name: str
    ) -> tuple[ServerProcess, contextlib.ExitStack]:
        assert settings.start_cmd is not None
        tokens = (settings.token, settings.token_2, settings.token_read)
        with contextlib.ExitStack() as ends:
            process = ServerProcess(
                settings.start_cmd,
                AccountTokens(*(token or "" for token in tokens)),
                directory=ends.enter_context(open_directory()),
                port=ends.enter_context(claim_port()),
                log=Path(settings.report) / f"server-{name}.log",
            )
            self._running.add(process)
            ends.callback(self._running.discard, process)
            ends.callback(process.stop)
            if self._is_closed:
                raise StartFailed("the kit ends")
            process.start()
            return process, ends.pop_all()


def _is_running(process: ServerProcess) -> bool:
    return process.wait_for_exit_code(0) is None


@contextlib.contextmanager
def open_private_server(context: CheckContext) -> Iterator[PrivateServer]:
    """Give a server that may be killed, and end it afterwards."""
    if not context.shared.settings.durable:
        raise SetUpFailed("not judged with --not-durable", allowed=True)
    with _open_server(context) as server:
        yield server


@contextlib.contextmanager
def open_server_of_its_own(context: CheckContext) -> Iterator[PrivateServer]:
    """Give a server that may be killed and that no other check calls."""
    if context.shared.settings.restart_cmd is not None:
        text = "requires --start-cmd: --restart-cmd disturbs other checks"
        raise SetUpFailed(text, allowed=True)
    with open_private_server(context) as server:
        yield server


@contextlib.contextmanager
def _open_server(context: CheckContext) -> Iterator[PrivateServer]:
    settings = context.shared.settings
    assert not settings.quick, f"{context.name} starts a server: mark it `background`"
    if settings.restart_cmd is not None:
        yield _HookedServer(context, settings.restart_cmd)
        return
    if settings.start_cmd is None:
        raise SetUpFailed("requires --start-cmd or --restart-cmd", allowed=True)
    lent_servers = context.shared.stored.setdefault(_LENT_SERVERS, LentServers())
    try:
        with lent_servers.lend(settings, context.name) as process:
            server = _OwnServer(context.for_base_url(process.url), process)
            try:
                yield server
            except SetUpFailed as error:
                raise name_end_of_server(error, process) from None
            server.context.tidy_up()
    except StartFailed as error:
        raise SetUpFailed(str(error)) from error


def name_end_of_server(error: SetUpFailed, process: ServerProcess) -> SetUpFailed:
    """Give an error that says so if the server ended, which no check asked it to."""
    code = process.wait_for_exit_code(_ENDS_S)
    if code is None:
        return error
    text = f"{error}; the server had ended by itself, with exit code {code}"
    return SetUpFailed(f"{text}, its last words: {process.log_tail()}")


@contextlib.contextmanager
def open_quiet_server(context: CheckContext) -> Iterator[CheckContext]:
    """Give a server that no other check asks, where the kit can start one.

    A server that looks at its clocks only when it is asked is found out there; where
    the kit was given a URL, other checks may ask it in time.
    """
    if context.shared.settings.start_cmd is None:
        yield context
        return
    with _open_server(context) as server:
        yield server.context


def close_private_servers(shared: SharedContext) -> None:
    """Kill all that the checks of this process have started."""
    if _LENT_SERVERS in shared.stored:
        shared.stored[_LENT_SERVERS].close()
