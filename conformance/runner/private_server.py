"""A server that a check may kill, or that no other check asks.

With `--start-cmd` every such check gets its own server. With `--restart-cmd` it is the
server under test, which the command kills and restarts; these checks then run alone,
after all others.
"""

import contextlib
import shlex
import subprocess
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Protocol

import httpx

from conformance.client.check_context import CheckContext
from conformance.client.connections.connection_pool import Connections
from conformance.runner.server_process import (
    AccountTokens,
    ServerProcess,
    StartFailed,
    claim_port,
    open_directory,
)
from conformance.verdicts.expect import SetUpFailed, Violation

_RESTART_S = 60.0
_OPEN: set[ServerProcess] = set()
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
    tokens = AccountTokens(
        settings.token or "", settings.token_2 or "", settings.token_read or ""
    )
    with contextlib.ExitStack() as ends:
        try:
            process = ServerProcess(
                settings.start_cmd,
                tokens,
                directory=ends.enter_context(open_directory()),
                port=ends.enter_context(claim_port()),
                log=Path(settings.report) / f"server-{context.name}.log",
            )
            _OPEN.add(process)
            ends.callback(_OPEN.discard, process)
            ends.callback(process.stop)
            process.start()
            yield _OwnServer(context.for_base_url(process.url), process)
        except StartFailed as error:
            raise SetUpFailed(str(error)) from error
        except SetUpFailed as error:
            raise name_end_of_server(error, process) from None


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


def close_private_servers() -> None:
    """Kill those of checks whose end the kit does not wait for."""
    for process in list(_OPEN):
        process.close()
