"""Servers that do not serve again after a kill: whether their data is the reason."""

import shlex
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from unittest.mock import Mock

import pytest

from conformance.run_settings import Settings
from conformance.runner import private_server, server_process
from conformance.runner.private_server import (
    LentServers,
    _OwnServer,
    name_end_of_server,
)
from conformance.runner.server_process import (
    AccountTokens,
    ServerProcess,
    StartFailed,
    claim_port,
    name_end,
)
from conformance.verdicts.expect import SetUpFailed, Violation
from tests.support.ports import free_port

pytestmark = pytest.mark.slow("starts servers")

SERVER = """
import http.server, os, pathlib, sys, time
taken = pathlib.Path("port-is-taken")
if taken.exists():
    taken.unlink()
    sys.exit("the port is taken")
kept = pathlib.Path({path})
if kept.exists():
    sys.exit("cannot read " + str(kept))
if kept.parent.exists():
    kept.write_text("a run")
address = os.environ["PROCTOR_HOST"], int(os.environ["PROCTOR_PORT"])
Handler = http.server.SimpleHTTPRequestHandler
server = http.server.ThreadingHTTPServer(address, Handler, bind_and_activate=False)
server.server_bind()
outlives = pathlib.Path("child-outlives-s")
if outlives.exists():
    parent, (ready, write_end) = os.getpid(), os.pipe()
    if os.fork() == 0:
        os.setsid()
        os.write(write_end, b".")
        server.timeout = 0.01
        while os.getppid() == parent:
            time.sleep(0.01)
        until = time.monotonic() + float(outlives.read_text())
        while time.monotonic() < until:
            server.handle_request()
        os._exit(0)
    os.read(ready, 1)  # from here on, no kill of the group ends the child
server.server_activate()
server.serve_forever()
"""
SILENT = """
import os, socket, time
address = os.environ["PROCTOR_HOST"], int(os.environ["PROCTOR_PORT"])
listening = socket.create_server(address)
time.sleep(60)
"""
DATABASE = "os.environ['PROCTOR_DATABASE']"
ANYWHERE = "'started-once'"
NOWHERE = "'no-folder/nothing'"


@pytest.fixture
def start(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> Iterator[Callable[..., _OwnServer]]:
    """Start a server that keeps `path`, and does not start where that exists."""
    monkeypatch.chdir(tmp_path)
    started: list[ServerProcess] = []

    def start_it(path: str) -> _OwnServer:
        script = tmp_path / "server.py"
        script.write_text(SERVER.format(path=path))
        command = f"{sys.executable} {script}"
        log = tmp_path / "server.log"
        tokens = AccountTokens.generate()
        started.append(
            ServerProcess(command, tokens, directory=tmp_path, port=port, log=log)
        )
        started[0].start()
        return _OwnServer(Mock(), started[0])  # its history notes each restart

    with claim_port() as port:
        yield start_it
        for server in started:
            server.stop()


def test_data_that_ends_the_server_is_a_violation(
    start: Callable[..., _OwnServer],
) -> None:
    server = start(DATABASE)
    server.kill9()
    with pytest.raises(Violation, match=r"cannot read .*conformance\.sqlite3"):
        server.restart()


def test_the_end_of_the_command_is_named_as_the_reason(
    start: Callable[..., _OwnServer],
) -> None:
    process = start(NOWHERE)._process
    assert name_end([process], "no response") == "no response"
    assert process._process is not None
    process._process.kill()
    said = name_end([process], "no response")
    assert said.startswith("the command exited with code -9 while it served requests")
    assert said.endswith("; no response")


@pytest.mark.parametrize(
    ("script", "says"),
    [
        ("import time; time.sleep(60)", "nothing listens on port"),
        (SILENT, "it listens, and answered no request within 0.2 s"),
    ],
)
def test_a_command_that_never_answers_is_described(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, script: str, says: str
) -> None:
    monkeypatch.setattr(server_process, "_START_S", 2.0)
    monkeypatch.setattr(server_process, "_ANSWER_S", 0.2)
    with claim_port() as port:
        process = ServerProcess(
            shlex.join([sys.executable, "-c", script]),
            AccountTokens.generate(),
            directory=tmp_path,
            port=port,
            log=tmp_path / "server.log",
        )
        with pytest.raises(StartFailed, match=says):
            process.start()
        process.stop()


def test_server_that_ended_by_itself_is_named(start: Callable[..., _OwnServer]) -> None:
    process = start(NOWHERE)._process
    error = SetUpFailed("no response", breaks="EPI-001")
    assert name_end_of_server(error, process) is error
    assert process._process is not None
    process._process.kill()
    named = name_end_of_server(error, process)
    assert "no response" in named.reason
    assert "ended by itself, with exit code -9" in named.reason
    assert named.breaks is None


def test_other_reasons_are_none(start: Callable[..., _OwnServer]) -> None:
    server = start(ANYWHERE)
    server.kill9()
    with pytest.raises(SetUpFailed, match="cannot read started-once"):
        server.restart()


def test_port_that_was_taken_for_a_moment_is_none(
    start: Callable[..., _OwnServer], tmp_path: Path
) -> None:
    server = start(NOWHERE)
    server.kill9()
    (tmp_path / "port-is-taken").touch()
    server.restart()
    assert not (tmp_path / "port-is-taken").exists()


def test_restart_waits_for_processes_that_outlive_the_group(
    start: Callable[..., _OwnServer], tmp_path: Path
) -> None:
    """They would answer the first requests after the kill, and keep the port."""
    (tmp_path / "child-outlives-s").write_text("0.5")
    server = start(NOWHERE)
    server.kill9()
    server.restart()
    assert server._process.wait_for_exit_code(0.5) is None


def test_server_that_no_kill_ends_is_named(
    start: Callable[..., _OwnServer], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(server_process, "_STOP_S", 0.3)
    (tmp_path / "child-outlives-s").write_text("10")
    server = start(NOWHERE)
    server.kill9()
    with pytest.raises(SetUpFailed, match="must run in their process group"):
        server.restart()


@pytest.fixture
def commands(monkeypatch: pytest.MonkeyPatch) -> list[Mock]:
    """Collect the servers that are started, which are none."""
    started: list[Mock] = []

    def start(*_: object, **__: object) -> Mock:
        started.append(Mock(**{"wait_for_exit_code.return_value": None}))
        return started[-1]

    monkeypatch.setattr(private_server, "ServerProcess", start)
    return started


def test_a_server_is_lent_to_one_check_after_the_other(commands: list[Mock]) -> None:
    servers, settings = LentServers(), Settings(start_cmd="serve")
    with servers.lend(settings, "CRASH-001") as first:
        with servers.lend(settings, "CRASH-002") as second:
            assert second is not first
        with servers.lend(settings, "CRASH-003") as third:
            assert third is second
    assert [server.stop.called for server in commands] == [False, False]
    servers.close()
    assert [server.stop.called for server in commands] == [True, True]


@pytest.mark.parametrize("ends_in_check", [True, False])
def test_a_server_that_has_ended_by_itself_is_lent_no_more(
    commands: list[Mock], ends_in_check: bool
) -> None:
    """In the check that had it, or before the next one."""
    servers, settings = LentServers(), Settings(start_cmd="serve")
    with servers.lend(settings, "CRASH-001"):
        commands[0].wait_for_exit_code.return_value = 3 if ends_in_check else None
    commands[0].wait_for_exit_code.return_value = 3
    with servers.lend(settings, "CRASH-002") as second:
        assert second is commands[1]
    assert commands[0].stop.called
    servers.close()


def test_a_server_of_a_check_that_raised_is_lent_no_more(commands: list[Mock]) -> None:
    servers, settings = LentServers(), Settings(start_cmd="serve")
    with (
        pytest.raises(Violation),
        servers.lend(settings, "CRASH-001"),
    ):
        raise Violation("a result", "none")
    assert commands[0].stop.called
    with servers.lend(settings, "CRASH-002") as second:
        assert second is commands[1]


def test_no_server_is_started_when_the_kit_ends(commands: list[Mock]) -> None:
    """A check that waited for its turn gets none any more."""
    servers, settings = LentServers(), Settings(start_cmd="serve")
    servers.close()
    with pytest.raises(StartFailed), servers.lend(settings, "CRASH-001"):
        pass
    assert not commands[0].start.called


def test_two_servers_are_never_given_the_same_port(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Each is free until its command listens, so the system may give it twice."""
    given = [free_port() for _ in range(2)]
    system = iter([given[0], given[0], given[1], given[0]])
    monkeypatch.setattr(server_process, "_free_port", lambda: next(system))
    with claim_port() as first, claim_port() as second:
        assert (first, second) == tuple(given)
    with claim_port() as third:
        assert third == first


def test_no_port_is_left(monkeypatch: pytest.MonkeyPatch) -> None:
    port = free_port()
    monkeypatch.setattr(server_process, "_free_port", lambda: port)
    with (
        claim_port(),
        pytest.raises(StartFailed, match="claimed by files"),
        claim_port(),
    ):
        pass
