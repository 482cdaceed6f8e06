"""A server is judged through nginx and HAProxy as they are installed.

What a proxy refuses by itself leaves a rule unjudged and is no violation; what it only
passes on is judged as without it: event streams, long polls, large bodies.
"""

import os
import subprocess
from pathlib import Path

import pytest

from tests.support.kit.reverse_proxies import run_proxy
from tests.support.kit.run_kit import KitRun, run_kit
from tests.support.ports import free_port
from tests.support.servers import TOKENS, ReferenceServer
from tools.example_servers import GO, build_server_go

pytestmark = pytest.mark.slow("a server, a proxy and a kit")


def certify(url: str, folder: Path, *options: str) -> KitRun:
    """Judge the server at a URL."""
    return run_kit(
        folder,
        *("--url", url, *options),
        PROCTOR_TOKEN=TOKENS["alice"],
        PROCTOR_TOKEN_2=TOKENS["bob"],
        PROCTOR_TOKEN_READ=TOKENS["reader"],
    )


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
        kit = certify(url, tmp_path / "report")
    assert kit.code == 0, kit.output[-3000:]
    for passed in ("EVT-002", "EVT-004", "RUN-012", "RUN-013", "PRED-002", "ERR-012"):
        assert kit.outcomes[passed] == "passed", kit.rows[passed]["reason"]
    large = kit.rows["ERR-005"]
    if name == "nginx":  # its client_max_body_size is 1 MiB
        assert large["outcome"] == "not_verified"
        assert "nginx, in front of the server, answered 413" in large["reason"]
    else:
        assert large["outcome"] == "passed"


@pytest.mark.skipif(not GO, reason="set-up brings no Go")
def test_the_event_streams_of_the_server_in_go_pass_nginx(tmp_path: Path) -> None:
    port = free_port()
    scopes = "alice:read+run:{alice},bob:read+run:{bob},alice:read:{reader}"
    with subprocess.Popen(
        [build_server_go(tmp_path), "--port", "0"],
        env=os.environ | {"PROCTOR_TOKENS": scopes.format(**TOKENS)},
        stdout=subprocess.PIPE,
        text=True,
    ) as server:
        assert server.stdout is not None
        url = server.stdout.readline().split()[-1]
        with run_proxy("nginx", tmp_path / "nginx", port, url):
            proxy_url, report = f"http://127.0.0.1:{port}", tmp_path / "report"
            kit = certify(proxy_url, report, "--only", "EVT-004")
        server.terminate()
    assert kit.outcomes["EVT-004"] == "passed", kit.output
