"""`make cluster`: what it says, and when."""

import contextlib
import os
import re
import select
import socket
import subprocess
import sys
from pathlib import Path
from typing import IO

import httpx
import pytest

from tests.support.paths import ROOT
from tests.support.servers import TIMEOUT_S

SAID = re.compile(
    r"A cluster of 2 nodes is listening at (?P<url>\S+)\n"
    r"token: (?P<token>\S+)  \(kept in \S+\)\nnodes: \S+, \S+\n"
)


def read_lines(stream: IO[bytes], count: int) -> str:
    """So many lines of a pipe, or what has come when it ends or nothing comes."""
    text = b""
    while text.count(b"\n") < count and select.select([stream], [], [], TIMEOUT_S)[0]:
        if not (read := os.read(stream.fileno(), 4096)):
            break
        text += read
    return text.decode()


def free_ports(size: int) -> int:
    """The first of so many free ports in a row, below those that systems give out."""
    for first in range(21000, 30000, size):
        with contextlib.ExitStack() as opened, contextlib.suppress(OSError):
            for port in range(first, first + size):
                opened.enter_context(socket.create_server(("127.0.0.1", port)))
            return first
    raise AssertionError("no free ports")


@pytest.mark.slow("starts a cluster of two servers")
def test_the_address_and_the_token_are_printed_at_once(tmp_path: Path) -> None:
    """Into a pipe, which is not flushed line by line. Expect a token that is valid."""
    settings = {
        "PROCTOR_PORT": str(free_ports(3)),
        "PROCTOR_DATABASE": str(tmp_path / "cluster.sqlite"),
    }
    with subprocess.Popen(
        [sys.executable, "-m", "tools.local_cluster"],
        cwd=ROOT,
        env={k: v for k, v in os.environ.items() if k != "PROCTOR_TOKENS"} | settings,
        stdout=subprocess.PIPE,
    ) as cluster:
        assert cluster.stdout is not None
        try:
            text = read_lines(cluster.stdout, 3)
            said = SAID.fullmatch(text)
            assert said is not None, text
            answer = httpx.get(
                f"{said['url']}/v1/benchmarks",
                headers={"Authorization": f"Bearer {said['token']}"},
                timeout=TIMEOUT_S,
            )
            assert answer.status_code == 200
            served = httpx.get(f"{said['url']}/v1", timeout=TIMEOUT_S).json()
            assert {"record", "board"} <= set(served["profiles"])
        finally:
            cluster.terminate()
    assert cluster.returncode == 0
