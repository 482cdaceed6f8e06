"""Completion: what a shell is answered at Tab, and the shells that ask.

The program is started as a shell does it; bash, which every machine has, asks as well.
"""

import contextlib
import json
import os
import socket
import sys
import threading
import time
from pathlib import Path

import pytest

from tests.support.client.command import Proctor, options
from tests.support.kit.null_servers import always, run_server
from tests.support.network.accepting_server import AcceptingServer
from tests.support.paths import ROOT
from tests.support.processes import run_program
from tests.support.servers import TIMEOUT_S, ReferenceServer

pytestmark = pytest.mark.usefixtures("policy_folder")
BASH = """
eval "$(proctor completion bash)"
COMP_WORDS=($1) COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
_proctor_completion proctor
printf '%s\\n' "${COMPREPLY[@]}"
"""


# The program, with another limit of time for the answer of the server.
PROGRAM = """
import sys
from reference_client.command.command_line import completion
from reference_client.command.main import main
completion.TIMEOUT_S = float(sys.argv.pop())
sys.exit(main())
"""


def complete(line: str, url: str, timeout_s: float = TIMEOUT_S) -> list[str]:
    """The words that may stand where the line ends. url: of the environment."""
    position = str(line.count(" "))  # of the word that is completed
    done = run_program(
        [sys.executable, "-c", PROGRAM, str(timeout_s)],
        env=os.environ
        | {"PROCTOR_URL": url, "PYTHONPATH": str(ROOT)}
        | {"COMP_WORDS": line, "COMP_CWORD": position}
        | {"_PROCTOR_COMPLETE": "bash_complete"},
        check=True,
    )
    assert done.stderr == ""
    return [item.removeprefix("plain,") for item in done.stdout.split()]


def test_commands_flags_and_values_are_completed(
    server: ReferenceServer,
) -> None:
    assert complete("proctor res", server.url) == ["resume", "results"]
    assert complete("proctor results --f", server.url) == ["--format"]
    values = complete("proctor results --format ", server.url)
    assert values == ["text", "markdown", "latex"]


def test_runs_and_benchmarks_are_those_of_the_server(
    server: ReferenceServer, proctor: Proctor
) -> None:
    """Expect the newest run first, also of a server that the line names."""
    run_id = proctor.json("submit", *options("score"))["run_id"]
    named = f"proctor compare x --url {server.url} "
    nowhere, calibration = "http://127.0.0.1:9", "proctor run --benchmark calib"
    for line, url in (("proctor results ", server.url), (named, nowhere)):
        assert complete(line, url)[0] == run_id
    words = complete(calibration, server.url)
    assert words == ["calibration"]
    assert complete("proctor board ver", server.url) == ["verify"]


def test_without_a_right_answer_nothing_is_completed(
    server: ReferenceServer, monkeypatch: pytest.MonkeyPatch
) -> None:
    """No server, one that never answers, and a token that is refused."""
    assert complete("proctor results ", "http://127.0.0.1:9") == []
    with socket.create_server(("127.0.0.1", 0)) as silent:
        url = f"http://127.0.0.1:{silent.getsockname()[1]}"
        assert complete("proctor results ", url, timeout_s=1.0) == []
    monkeypatch.setenv("PROCTOR_TOKEN", "none")
    assert complete("proctor results ", server.url) == []


def test_a_hostile_server_puts_nothing_on_the_command_line() -> None:
    """Ids that a shell would act on are left out, and so is what a terminal acts on."""
    policy = {"name": "\x1b[2J\x0bfalse"}
    runs = [
        {"run_id": run_id, "state": "ready", "benchmark_id": "b", "policy": policy}
        for run_id in ("run_1", "$(reboot)", "run_2;reboot", "a\x0bb", "run_3")
    ]
    body = json.dumps({"runs": runs}).encode()

    with run_server(always(200, body)) as url:
        words = complete("proctor results ", url)
        assert words == ["run_1", "run_3"]


def test_a_server_that_sends_slowly_holds_no_tab() -> None:
    """A byte each 0.2 s, for 80 s. Expect the shell back when the limit is over."""
    is_over, asked_at = threading.Event(), []

    def drip(connection: socket.socket) -> None:
        asked_at.append(time.monotonic())
        for byte in b"HTTP/1.1 200 OK\r\nContent-Length: 999\r\n\r\n" + b" " * 362:
            connection.sendall(bytes([byte]))
            if is_over.wait(0.2):
                break

    with contextlib.closing(AcceptingServer(drip)) as server:
        assert complete("proctor results ", server.url, timeout_s=5.0) == []
        took_s = time.monotonic() - asked_at[0]
        is_over.set()
    assert took_s < TIMEOUT_S  # a busy machine ends a process slowly


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
def test_each_shell_has_its_code(proctor: Proctor, shell: str) -> None:
    assert proctor("completion", shell) == 0
    assert f"_PROCTOR_COMPLETE={shell}_complete" in proctor.out
    assert "proctor" in proctor.out


def test_an_unknown_shell_is_refused(proctor: Proctor) -> None:
    assert proctor("completion", "csh") == 2
    assert "value csh; did you mean zsh? There is bash, zsh, fish" in proctor.err


def test_bash_completes(server: ReferenceServer, tmp_path: Path) -> None:
    done = run_program(
        ["bash", "--norc", "-c", BASH, "bash", "proctor res"],
        env=os.environ
        | {"PROCTOR_URL": server.url, "PYTHONPATH": str(ROOT)}
        | {"PATH": f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"},
        cwd=tmp_path,
        check=True,
    )
    assert done.stdout.split() == ["resume", "results"]
