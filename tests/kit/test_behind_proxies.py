"""A server is judged through nginx and HAProxy as they are installed.

What a proxy refuses by itself leaves a rule unjudged and is no violation; what it only
passes on is judged as without it: event streams, long polls, large bodies.
"""

import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from tests.support.kit.reverse_proxies import run_proxy
from tests.support.paths import ROOT
from tests.support.ports import free_port
from tests.support.servers import TOKENS, ReferenceServer

pytestmark = pytest.mark.slow("a server, a proxy and a kit")


def certify(url: str, report: Path) -> tuple[subprocess.CompletedProcess[str], Any]:
    """Judge the server at a URL; give the process and the rows by id."""
    tokens = {
        "PROCTOR_TOKEN": TOKENS["alice"],
        "PROCTOR_TOKEN_2": TOKENS["bob"],
        "PROCTOR_TOKEN_READ": TOKENS["reader"],
    }
    done = subprocess.run(
        [sys.executable, "-m", "conformance", "--url", url, "--report", str(report)],
        cwd=ROOT,
        env=os.environ | tokens,
        capture_output=True,
        text=True,
        check=False,
    )
    rows = json.loads((report / "report.json").read_text())["rows"]
    return done, {row["requirement_id"]: row for row in rows}


@pytest.mark.parametrize(
    "name",
    [
        "nginx",
        pytest.param(
            "haproxy",
            marks=pytest.mark.release("the whole kit through HAProxy; nginx is"),
        ),
    ],
)
def test_the_server_is_conformant_behind(name: str, tmp_path: Path) -> None:
    """Control and data plane through the proxy. Expect no violation."""
    port = free_port()
    url = f"http://127.0.0.1:{port}"
    with (
        ReferenceServer(tmp_path, PROCTOR_PUBLIC_URL=url) as server,
        run_proxy(name, tmp_path / name, port, server.url),
    ):
        done, rows = certify(url, tmp_path / "report")
    assert done.returncode == 0, done.stdout[-3000:]
    for passed in ("EVT-002", "EVT-004", "RUN-012", "RUN-013", "PRED-002", "ERR-012"):
        assert rows[passed]["outcome"] == "passed", rows[passed]["reason"]
    large = rows["ERR-005"]
    if name == "nginx":  # its client_max_body_size is 1 MiB
        assert large["outcome"] == "not_verified"
        assert "nginx, in front of the server, answered 413" in large["reason"]
    else:
        assert large["outcome"] == "passed"
