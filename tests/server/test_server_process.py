"""The server as people run it: a process that starts, says so, and ends.

That a kill loses nothing is judged by the kit (tests/kit/test_reference_server.py) and
by the campaigns.
"""

import asyncio
import contextlib
import json
import os
import shutil
import signal
import socket
import sqlite3
import subprocess
import sys
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import httpx
import pytest
from starlette.requests import Request
from starlette.responses import Response

from reference_record.command_line.listening import CannotListen, bind, listen
from reference_server.__main__ import main
from reference_server.http.auth import Tokens
from reference_server.http.dispatch import Operation, perform
from reference_server.http.tokens import admin_command as admin
from tests.support.paths import ROOT
from tests.support.ports import free_port
from tests.support.processes import (
    PROGRAM_S,
    descendants,
    run_program,
    wait_until_ended,
)
from tests.support.server.http_runs import attach, predict_body, submit, worker_path
from tests.support.servers import TIMEOUT_S, TOKENS, ReferenceServer

pytestmark = pytest.mark.slow("starts servers")


def environment(**settings: str) -> dict[str, str]:
    """This process's, without settings of the server and without proxies."""
    inherited = {
        name: value
        for name, value in os.environ.items()
        if not name.upper().startswith("PROCTOR_")
        and not name.lower().endswith("_proxy")
    }
    return inherited | settings


def run_to_end(*command: str, **settings: str) -> subprocess.CompletedProcess[str]:
    """A server, or a program that takes its place, which ends by itself."""
    return run_program(
        [sys.executable, *command],
        cwd=ROOT,
        env=environment(**settings),
        timeout=PROGRAM_S,
    )


def is_one_line(code: int | None, stderr_text: str, *, about: str) -> bool:
    assert (code, stderr_text.count("\n")) == (2, 1), stderr_text
    assert stderr_text.startswith("proctor: ")
    return about in stderr_text


# --- starting ---


@pytest.mark.parametrize(
    ("cause", "about"),
    [
        ("port", "port"),
        ("tokens", "tokens"),
        ("file", "database"),
        # In a process of its own: an event loop is left to the end of it.
        ("driver", "database"),
    ],
)
def test_a_failed_start_prints_one_line(tmp_path: Path, cause: str, about: str) -> None:
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        port = str(taken.getsockname()[1])
        flags = {
            "port": ["--port", port],
            "tokens": ["--tokens", "alice:read"],
            "file": ["--port", "0", "--database", str(ROOT / "LICENSE")],
            "driver": ["--port", "0", "--database", "nonsense://x"],
        }
        ended = run_to_end(
            "-m",
            "reference_server",
            *flags[cause],
            PROCTOR_DATABASE=str(tmp_path / "proctor.sqlite"),
        )
    assert is_one_line(ended.returncode, ended.stderr, about=about)
    assert ended.stdout == ""
    # A server beside ours may be using the database: it was left alone.
    assert list(tmp_path.iterdir()) == []


# How each file or folder may be wrong: the setting, and the name of what it should be.
KEPT = {
    "sealing_key": "the key",
    "seed_secret": "the secret of sealed seeds",
    "signing_key": "the key that signs records",
    "records_dir": "the folder of recordings",
    "tokens_file": "the tokens",
    "opened_seeds": "the opened seeds",
}
WRONG = {
    "a folder": set(KEPT) - {"records_dir"},
    "an empty file": set(KEPT) - {"tokens_file"},
    "binary": set(KEPT),
    "/proc/none": set(KEPT) - {"tokens_file"},
}


def test_one_program_binds_a_port_also_before_it_listens() -> None:
    """A restart does, beside connections of before that are not over."""
    with bind("127.0.0.1", 0) as first:
        host, port = first.getsockname()
        for is_listening in (False, True):
            if is_listening:
                listen(first)
            with pytest.raises(CannotListen, match="end the server that is there"):
                bind(host, port)
        left = socket.create_connection((host, port))
        accepted, _ = first.accept()
    with left, accepted, bind(host, port) as restarted:
        listen(restarted)


@pytest.mark.parametrize("name", KEPT)
def test_a_file_that_cannot_be_used_is_one_line_with_its_setting(
    name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "a folder").mkdir()
    (tmp_path / "an empty file").touch()
    (tmp_path / "binary").write_bytes(b"\xff\x00")
    for wrong, settings in WRONG.items():
        if name not in settings:
            continue
        path, flag = tmp_path / wrong, f"--{name.replace('_', '-')}"
        flags = ["--port", "0", "--database", str(tmp_path / "db"), flag, str(path)]
        with pytest.MonkeyPatch.context() as patch:
            patch.delenv("MAKELEVEL", raising=False)  # else advice for make is behind
            patch.setattr(sys, "argv", ["reference_server", *flags])
            code = main()
        said = capsys.readouterr().err
        assert is_one_line(code, said, about=f"cannot use {KEPT[name]} in {path} (")
        assert said.endswith(f"); choose another with {flag}\n")
        assert "Errno" not in said


def test_files_that_are_made_anew_for_a_database_with_runs_are_named(
    tmp_path: Path,
) -> None:
    with ReferenceServer(tmp_path) as server, server.client() as client:
        submit(client, "score")
        server.end()
        assert "is new" not in server.log()
        assert "has no run yet" not in server.log()
        for ending in ("seeds", "records"):
            path = tmp_path / f"proctor.sqlite.{ending}"
            shutil.move(path, tmp_path / ending)
        server.start()
        paths = ", ".join(
            str(tmp_path / f"proctor.sqlite.{ending}")
            for ending in ("seeds", "records")
        )
        assert f"made for them: {paths} is new; if a backup has it" in server.log()


def test_an_empty_database_beside_another_one_is_named(tmp_path: Path) -> None:
    """Expect the way back to its runs, and no word of files of other programs."""
    (tmp_path / "empty.sqlite").touch()
    (tmp_path / "text.sqlite").write_text("no database")
    with contextlib.closing(sqlite3.connect(tmp_path / "other.sqlite")) as other:
        other.executescript(
            "PRAGMA journal_mode = WAL; CREATE TABLE alembic_version (version_num);"
            "CREATE TABLE runs (run_uuid); INSERT INTO runs VALUES ('a')"
        )
    with ReferenceServer(tmp_path) as server, server.client() as client:
        assert "has no run yet" not in server.log()
        submit(client, "score")
        server.end()
        shutil.move(tmp_path / "proctor.sqlite", tmp_path / "older.sqlite")
        files = set(tmp_path.iterdir())
        server.start()
        said = f"start the server with --database {tmp_path / 'older.sqlite'}"
        assert said in server.log()
        assert server.log().count("has no run yet") == 1
        new = {path.name for path in set(tmp_path.iterdir()) - files}
        assert {name[: len("proctor.sqlite")] for name in new} == {"proctor.sqlite"}


@pytest.mark.parametrize(
    ("flags", "way_out"),
    [
        (
            ["--host", "nowhere.invalid"],
            "name an address of this machine, such as 127.",
        ),
        (
            ["--host", "[::1]"],
            "name an address of this machine, such as 127.0.0.1, with",
        ),
        (["--host", "203.0.113.1"], "such as 127.0.0.1, with --host\n"),
        (["--metrics-host", "203.0.113.1"], "such as 127.0.0.1, with --metrics-host\n"),
        (["--metrics-port", "PORT"], "choose another port with --metrics-port\n"),
    ],
)
def test_the_way_out_is_that_of_the_cause_why_it_cannot_listen(
    flags: list[str],
    way_out: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """The port of this very server is in use for its metrics."""
    monkeypatch.delenv("MAKELEVEL", raising=False)
    port = str(free_port())
    flags = [port if flag == "PORT" else flag for flag in flags]
    given = ["--port", port, "--database", str(tmp_path / "db"), "--metrics", "on"]
    monkeypatch.setattr(sys, "argv", ["reference_server", *given, *flags])
    assert is_one_line(main(), capsys.readouterr().err, about=way_out)


def test_a_server_does_not_listen_before_its_database_is_checked() -> None:
    """A database that accepts, and answers once the port was found to be closed."""
    port = free_port()
    with socket.create_server(("127.0.0.1", 0)) as database:
        place = f"127.0.0.1:{database.getsockname()[1]}"
        starting = subprocess.Popen(
            [sys.executable, "-m", "reference_server", "--port", str(port)],
            cwd=ROOT,
            env=environment(PROCTOR_DATABASE=f"postgresql://me:pw@{place}/proctor"),
            stderr=subprocess.PIPE,
            text=True,
        )
        database.settimeout(TIMEOUT_S)
        with database.accept()[0], pytest.raises(ConnectionRefusedError):
            socket.create_connection(("127.0.0.1", port))
    _, said = starting.communicate(timeout=PROGRAM_S)
    assert is_one_line(starting.returncode, said, about="cannot use the database")


def test_a_database_that_fails_after_it_was_checked_has_no_traceback() -> None:
    """It is restarted, say, between two looks at it."""
    program = (
        "import sys, reference_server.__main__ as server\n"
        "server._check_database_and_keys = lambda settings: None\n"
        "sys.argv[1:] = ['--port', '0']\n"
        "sys.exit(server.main())"
    )
    settings = {
        "PROCTOR_DATABASE": str(ROOT / "LICENSE"),
        "PROCTOR_TOKENS": "alice:read:a-token",
        "PROCTOR_RECORDINGS": "off",
    }
    ended = run_to_end("-c", program, **settings)
    assert ended.returncode == 2, ended.stderr
    assert "cannot use the database (" in ended.stderr
    assert "Traceback" not in ended.stderr


@pytest.mark.parametrize(
    ("flags", "about"),
    [
        (["--tokens", ","], "tokens"),
        (["--port", "x"], "port"),
        (["--port", "65536"], "port"),
        (["--max-chunk", "3"], "max_chunk"),
        (["--log-level", "nonsense"], "log_level"),
    ],
)
def test_an_invalid_setting_prints_one_line(
    flags: list[str],
    about: str,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    flags = flags if "--port" in flags else [*flags, "--port", "0"]
    monkeypatch.setattr(sys, "argv", ["reference_server", *flags])
    code = main()
    assert is_one_line(code, capsys.readouterr().err, about=about)


def test_the_printed_commands_work(tmp_path: Path) -> None:
    """Copied from a terminal of 40 columns, in which no line is broken but that of a
    long path. They work in any folder."""
    command = [sys.executable, "-m", "reference_server", "--port", "0"]
    given = environment(
        PROCTOR_DATABASE="p.sqlite", XDG_STATE_HOME=str(tmp_path), PYTHONPATH=str(ROOT)
    )
    how: dict[str, Any] = {"cwd": tmp_path, "env": given, "text": True}
    with subprocess.Popen(command, stdout=subprocess.PIPE, **how) as server:
        assert server.stdout is not None
        lines = list(iter(server.stdout.readline, "database: p.sqlite\n"))
        try:
            text = "".join(lines).partition("try:\n")[2].partition("certify:\n")
            certify = text[2].partition("pages: ")[0].replace("make", "echo")
            pasted = [
                subprocess.run(
                    ["sh", "-c", pasted],
                    capture_output=True,
                    check=True,
                    **how | {"cwd": "/"},
                ).stdout
                for pasted in (text[0], certify)
            ]
        finally:
            server.terminate()
    url, token = lines[0].split()[-1], lines[2].strip()
    assert lines[:2] == [
        f"Proctor listens at {url}\n",
        f"token, kept in {tmp_path / 'p.sqlite.token'}:\n",
    ]
    # A port that is chosen has one digit more than the default.
    of_checkout = f"make -C {ROOT} \\\n"
    of_paths = [line for line in lines if str(tmp_path) in line or line == of_checkout]
    assert all(len(line.rstrip()) <= 41 for line in lines if line not in of_paths)
    assert (tmp_path / "p.sqlite.token").read_text().strip() == token
    named = [one["benchmark_id"] for one in json.loads(pasted[0])["benchmarks"]]
    assert lines[-len(named) - 1 :] == ["benchmarks:\n", *(f"  {n}\n" for n in named)]
    assert pasted[1] == f"-C {ROOT} conformance URL={url} TOKEN={token}\n"


@contextmanager
def server_with_its_own_token(
    folder: Path, port: str = "0"
) -> Iterator[tuple[str, str, dict[str, str]]]:
    """A started server's URL, its two lines with the token, and its environment."""
    given = environment(
        PROCTOR_DATABASE=str(folder / "proctor.sqlite"),
        XDG_STATE_HOME=str(folder / "state"),
    )
    with subprocess.Popen(
        [sys.executable, "-m", "reference_server", "--port", port],
        cwd=ROOT,
        env=given,
        stdout=subprocess.PIPE,
        text=True,
    ) as server:
        assert server.stdout is not None
        url = server.stdout.readline().split()[-1]
        line = server.stdout.readline() + server.stdout.readline()
        try:
            yield url, line, given
        finally:
            server.kill()


def test_the_made_token_survives_a_restart_and_is_listed(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """Kept beside the database, for its owner alone; printed once, with its place."""
    path = tmp_path / "proctor.sqlite.token"
    with server_with_its_own_token(tmp_path) as (url, first, _):
        assert first == f"token, kept in {path}:\n{path.read_text().strip()}\n"
        assert path.stat().st_mode & 0o777 == 0o600
    with server_with_its_own_token(tmp_path, url.rpartition(":")[2]) as (_, line, _):
        assert line == f"token, kept in {path}\ntry:\n"
    monkeypatch.setenv("PROCTOR_DATABASE", str(tmp_path / "proctor.sqlite"))
    assert admin.main(["token", "list"]) == 0
    (line,) = capsys.readouterr().out.splitlines()
    token_id, _, account, place = line.split(maxsplit=3)
    assert (account, place) == ("local", f"the server's own, in {path}")
    for which in (token_id, account):
        assert admin.main(["token", "revoke", which]) == 2
        assert f"stop the server and remove {path}; its " in capsys.readouterr().err


def test_the_command_finds_the_made_token(tmp_path: Path) -> None:
    """From any folder, and nothing is exported; another server's is not sent."""
    with server_with_its_own_token(tmp_path) as (url, _, given):
        called = [sys.executable, "-m", "reference_client.command", "benchmarks"]
        command = [*called, "--url", url]
        options: dict[str, Any] = {"cwd": tmp_path, "capture_output": True}
        found = subprocess.run(command, env=given, check=False, **options)
        assert (found.returncode, found.stderr) == (0, b"")
        assert b"calibration" in found.stdout
        nowhere = given | {"XDG_STATE_HOME": str(tmp_path / "other")}
        refused = subprocess.run(command, env=nowhere, check=False, **options)
        assert refused.returncode == 2
        assert b"[unauthenticated]" in refused.stderr
    (entry,) = (tmp_path / "state" / "proctor" / "servers").glob("*/*")
    port = url.rpartition(":")[2]
    assert entry.name == f"127.0.0.1-{port}"
    settings = {"PROCTOR_PORT": port, "XDG_STATE_HOME": str(tmp_path / "state")}
    with ReferenceServer(tmp_path, **settings):
        assert not entry.exists()


def test_a_file_without_a_token_ends_the_start_with_one_line(tmp_path: Path) -> None:
    path = tmp_path / "proctor.sqlite.token"
    path.write_text("two words\n")
    ended = run_to_end(
        "-m",
        "reference_server",
        "--port",
        "0",
        PROCTOR_DATABASE=str(tmp_path / "proctor.sqlite"),
    )
    assert is_one_line(ended.returncode, ended.stderr, about=f"no token in {path}")


def test_configured_tokens_are_not_printed(server: ReferenceServer) -> None:
    assert server.process.stdout is not None
    server.end()
    assert server.process.stdout.closed
    assert not any(token in server.log() for token in TOKENS.values())


# Says, in place of serving, what a full collection goes through from then on.
COUNTING_SERVER = """
import gc, sys
from reference_server import __main__ as program

class CountingServer(program.DrainingServer):
    def run(self, sockets=None):
        print(gc.get_freeze_count(), len(gc.get_objects()), gc.isenabled())
        self.started = True

program.DrainingServer = CountingServer
sys.exit(program.main())
"""


def test_a_full_collection_goes_through_little(tmp_path: Path) -> None:
    """Modules stay for good: going through them stops every turn for a while.

    Expect collections to go on, for what comes later.
    """
    ended = run_to_end(
        "-c",
        COUNTING_SERVER,
        "--port",
        "0",
        PROCTOR_DATABASE=str(tmp_path / "proctor.sqlite"),
    )
    assert ended.returncode == 0, ended.stderr
    kept, looked_at, is_enabled = ended.stdout.splitlines()[-1].split()
    assert int(kept) > 100_000, "everything that was there at the start"
    assert int(looked_at) < int(kept) / 100
    assert is_enabled == "True"


# --- ending ---


@pytest.mark.parametrize(
    "number",
    [
        *(signal.SIGTERM, signal.SIGINT, signal.SIGHUP, signal.SIGUSR2, signal.SIGXCPU),
        signal.SIGKILL,
    ],
)
def test_no_process_outlives_the_server(
    server: ReferenceServer, number: signal.Signals
) -> None:
    with server.client() as client:
        idle, busy = submit(client, "count"), submit(client, "delay")
        attach(client, idle)
        turn = attach(client, busy)
        # In order, the server lets the turn end; by force, there is no time for that.
        delay_s = 5 if number == signal.SIGKILL else 0.5
        with in_play(server, client, busy, turn, delay_s=delay_s):
            children = descendants(server.process.pid)
            assert len(children) >= 3, "two simulators and who started them"
            server.end(number)
            wait_until_ended(children)
    assert server.log() == ""


def test_long_polls_are_answered_at_shutdown(server: ReferenceServer) -> None:
    with server.client() as client, server.client() as waiter:
        path = f"/v1/runs/{submit(client, 'count')}"
        etag = client.get(path).headers["etag"]
        poll_headers = {"If-None-Match": etag, "Prefer": "wait=30"}
        with ThreadPoolExecutor(1) as pool:
            waiting = pool.submit(waiter.get, path, headers=poll_headers)
            for _ in range(50):  # it arrives meanwhile
                client.get(path)
            server.end()
            answer = waiting.result(TIMEOUT_S)
    assert (answer.status_code, answer.json()["code"]) == (503, "unavailable")
    assert answer.headers["retry-after"]
    assert server.log() == ""


def test_cancelled_requests_are_answered_with_503() -> None:
    async def endless(_call: Any) -> Response:
        await asyncio.Event().wait()
        raise AssertionError("the event is never set")

    async def scenario() -> Response:
        request = Request({"type": "http", "headers": [], "query_string": b""})
        operation = Operation(endless, scope=None)
        task = asyncio.ensure_future(perform(request, operation, Tokens({}), 1024))
        await asyncio.sleep(0)
        task.cancel()
        return await task

    assert asyncio.run(scenario()).status_code == 503


@contextmanager
def in_play(
    server: ReferenceServer,
    client: httpx.Client,
    run_id: str,
    turn: dict[str, Any],
    **values: float,
) -> Iterator[None]:
    """A turn is executed meanwhile, which the server's end may break off."""
    path, body = f"{worker_path(run_id)}/predict", predict_body(turn, **values)

    def play() -> None:
        with server.client() as player, contextlib.suppress(httpx.TransportError):
            assert player.post(path, json=body).status_code in (200, 409, 503)

    with ThreadPoolExecutor(1) as pool:
        playing = pool.submit(play)
        ahead = body | {"seq": body["seq"] + 5}
        expected = 0
        while expected <= body["seq"]:  # until the turn has used up its seq
            expected = client.post(path, json=ahead).json()["expected_seq"]
        yield
        playing.result(TIMEOUT_S)
