"""A running server is judged by its URL and one token, as README begins."""

import os
import subprocess
import sys
import threading
from pathlib import Path

import pytest

from conformance.client.connections.connection_pool import ConnectionPool, Connections
from tests.support.kit.run_kit import run_kit
from tests.support.paths import ROOT
from tests.support.servers import TIMEOUT_S


def start_server(directory: Path) -> tuple[subprocess.Popen[str], list[str]]:
    """Start a server with nothing set but its port, and give what it prints."""
    environment = {n: v for n, v in os.environ.items() if not n.startswith("PROCTOR_")}
    environment["PROCTOR_DATABASE"] = str(directory / "proctor.sqlite")
    environment["XDG_STATE_HOME"] = str(directory)
    server = subprocess.Popen(
        [sys.executable, "-m", "reference_server", "--port", "0"],
        cwd=ROOT,
        env=environment,
        stdout=subprocess.PIPE,
        text=True,
    )
    assert server.stdout is not None
    lines: list[str] = []
    while not lines or not lines[-1].startswith("pages:"):
        line = server.stdout.readline()
        assert line, "the server ended before it said how to certify it"
        lines.append(line.rstrip("\n"))
    return server, lines


@pytest.mark.slow("starts a server or a kit")
def test_the_printed_line_certifies_the_server(tmp_path: Path) -> None:
    """No token of another account, no hook, no private networks: still conformant."""
    server, lines = start_server(tmp_path)
    try:
        printed = "\n".join(lines[lines.index("certify:") + 1 : -1])
        assert printed.startswith("make conformance ")
        # The shell puts the token in, which stands in a file.
        echoed = ["sh", "-c", printed.replace("make", "echo", 1)]
        words = subprocess.check_output(echoed, cwd=ROOT, text=True).split()
        given = dict(word.split("=", 1) for word in words[1:])
        assert given["TOKEN"] == lines[2]
        kit = run_kit(
            tmp_path / "report",
            *("--url", given["URL"]),
            command=(sys.executable, "-m", "conformance", "--history-time", "0"),
            PROCTOR_TOKEN=given["TOKEN"],
        )
    finally:
        server.terminate()
        server.wait()
        assert server.stdout is not None
        server.stdout.close()
    assert kit.code == 0, f"{kit.rules_with('failed')}\n{kit.output[-3000:]}"
    for name in ("PUSH-001", "CHAT-001"):
        assert kit.outcomes[name] == "not_verified"
        assert "Allow it to call that address" in kit.rows[name]["reason"]
    assert kit.outcomes["PRED-002"] == "passed"


def test_two_threads_never_share_a_connection() -> None:
    pool = ConnectionPool()
    in_use: list[Connections] = []
    both = threading.Barrier(2, timeout=TIMEOUT_S)

    def send_from_thread() -> None:
        with pool.borrow() as connections:
            in_use.append(connections)
            both.wait()

    threads = [threading.Thread(target=send_from_thread) for _ in range(2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    first, second = in_use
    assert first is not second
    with pool.borrow() as again:
        assert again in (first, second)
    pool.close()
