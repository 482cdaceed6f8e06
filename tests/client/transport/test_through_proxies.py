"""Requests of both planes take the way that the environment names, and say so."""

from collections.abc import Iterator
from pathlib import Path

import pytest

from reference_client.command.main import main
from reference_client.protocol import http_connection
from reference_client.protocol.connection import Connection
from reference_client.protocol.http_connection import HttpConnection
from tests.support.client.command import options
from tests.support.kit.null_servers import canned_answers
from tests.support.network.forward_proxy import run_forward_proxy
from tests.support.network.tls_gateway import serve_tls
from tests.support.server.certificates import create_certificate
from tests.support.servers import ReferenceServer

pytestmark = [
    pytest.mark.slow("starts servers"),
    pytest.mark.usefixtures("policy_folder", "no_proxies"),
]
NAME = "robots.behind.example"
URL = f"http://{NAME}"


@pytest.fixture(scope="module")
def hosts(
    tmp_path_factory: pytest.TempPathFactory,
) -> Iterator[dict[str, tuple[str, int]]]:
    """A server whose name the proxy alone knows."""
    folder = tmp_path_factory.mktemp("behind")
    with ReferenceServer(folder, PROCTOR_PUBLIC_URL=URL) as server:
        yield {NAME: ("127.0.0.1", int(server.url.rpartition(":")[2]))}


@pytest.mark.parametrize("password", [None, "user:s3cret"])
@pytest.mark.parametrize("more", [[], ["--processes"]])
def test_a_run_is_played_through_the_proxy(
    hosts: dict[str, tuple[str, int]],
    password: str | None,
    more: list[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Expect turns and heartbeats, the score and the record on the same way."""
    flags = ["--policy", "policies:Graded", *options("count"), *more]
    with run_forward_proxy(hosts, password=password) as proxy:
        user = f"{password}@" if password else ""
        monkeypatch.setenv("HTTP_PROXY", proxy.url.replace("://", f"://{user}"))
        assert main(["run", "--url", URL, *flags]) == 0
        scores = (line for line in proxy.requests if line.endswith("/score"))
        run_id = next(scores).split("/")[5]
        assert main(["export", run_id, "--url", URL]) == 0
    assert sum(line.endswith("/predict") for line in proxy.requests) == 2
    assert any(line.endswith("/record") for line in proxy.requests)
    assert all(line.split()[1].startswith(f"{URL}/") for line in proxy.requests)


@pytest.mark.parametrize(
    ("variables", "texts"),
    [
        ({}, ["without a proxy: no proxy is set", "http_proxy=URL names one"]),
        (
            {"http_proxy": "http://user:s3cret@127.0.0.1:1"},
            [
                "The proxy http://127.0.0.1:1 of http_proxy, on the way to",
                "is unreachable (Connection refused)",
                f"NO_PROXY={NAME} goes past it",
            ],
        ),
        (
            {"ALL_PROXY": "PROXY", "NO_PROXY": ".example"},
            ["without a proxy: NO_PROXY excludes this host"],
        ),
        (
            {"ALL_PROXY": "socks5://u:s3cret@127.0.0.1:1"},
            ["ALL_PROXY names a SOCKS", "instead; NO_PROXY=robots.behind.example goes"],
        ),
        (
            {"PROCTOR_PROXY": "socks5://127.0.0.1:1", "NO_PROXY": "*"},
            ["PROCTOR_PROXY names a SOCKS", "instead; PROCTOR_PROXY=none goes past it"],
        ),
        (
            {"http_proxy": "PROXY"},
            ["the proxy PROXY of http_proxy in its place, answered 502 Bad Gateway"],
        ),
        (
            {"PROCTOR_PROXY": "PASSWORD"},
            [
                "of PROCTOR_PROXY refused the way to http://robots.behind.example (407",
                "It did not accept the user and the password that PROCTOR_PROXY has",
                "PROCTOR_PROXY=http://USER:PASSWORD@HOST:PORT",
            ],
        ),
    ],
)
@pytest.mark.parametrize("command", ["status", "run"])
def test_an_error_names_the_way(
    variables: dict[str, str],
    texts: list[str],
    command: str,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    flags = ["--policy", "policies:Graded", *options("count")]
    with (
        run_forward_proxy({NAME: ("127.0.0.1", 1)}) as proxy,
        run_forward_proxy(password="user:s3cret") as refusing,
    ):
        wrong = refusing.url.replace("//", "//user:no@")
        places = {"PROXY": proxy.url, "PASSWORD": wrong}
        for name, value in variables.items():
            monkeypatch.setenv(name, places.get(value, value))
        line = [command, "--url", URL, "--retry-timeout-s", "0"]
        assert main(line + (flags if command == "run" else [])) == 2
    written = capsys.readouterr().err
    assert written.count("\n") == 1
    for text in texts:
        assert text.replace("PROXY of", f"{proxy.url} of") in written
    for word in ("s3cret", "policy", "Traceback"):
        assert word not in written


def test_this_machine_is_reached_past_the_proxy(
    server: ReferenceServer,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    with run_forward_proxy() as proxy:
        monkeypatch.setenv("http_proxy", proxy.url)
        assert main(["status", "--url", server.url]) == 0
        assert proxy.requests == []
        closed = ["status", "--url", "http://127.0.0.1:1", "--retry-timeout-s", "0"]
        assert main(closed) == 2
        said = "http_proxy is not for addresses of this machine"
        assert said in capsys.readouterr().err
        monkeypatch.setenv("PROCTOR_PROXY", proxy.url)
        assert main(["status", "--url", server.url]) == 0
        assert proxy.requests[0] == f"GET {server.url}/v1/runs"


@pytest.mark.parametrize("is_secure_proxy", [False, True])
def test_https_goes_through_a_tunnel(
    tmp_path: Path, is_secure_proxy: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Also to a proxy that speaks TLS itself: TLS inside of TLS, in both planes."""
    (tmp_path / "proxy").mkdir()
    proxy_pem, context = create_certificate(tmp_path / "proxy", "localhost")
    with serve_tls(tmp_path, canned_answers, NAME) as (url, pem):
        pem.write_bytes(pem.read_bytes() + proxy_pem.read_bytes())
        monkeypatch.setenv("PROCTOR_CA", str(pem))
        address = ("127.0.0.1", int(url.rpartition(":")[2]))
        tls = context if is_secure_proxy else None
        with run_forward_proxy({NAME: address}, tls=tls) as proxy:
            monkeypatch.setenv("https_proxy", proxy.url)
            with Connection(url, "t", requests=1) as connection:
                assert connection.control.describe_service().protocol.min
            data = HttpConnection(url, (5.0, 5.0), lambda n: memoryview(bytearray(n)))
            request = f"GET /v1 HTTP/1.1\r\nHost: {NAME}\r\n\r\n".encode()
            assert data.send_request(request).status == 200
            data.close()
    assert proxy.requests == [f"CONNECT {NAME}:{address[1]}"] * 2


def test_a_tunnel_that_is_refused_is_not_the_server_s_fault(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    line = ["status", "--url", f"https://{NAME}", "--retry-timeout-s", "60"]
    with run_forward_proxy(refuses=403) as proxy:
        monkeypatch.setenv("ALL_PROXY", proxy.url)
        assert main(line) == 2
    written = capsys.readouterr().err
    assert f"{proxy.url} of ALL_PROXY refused the way to https://{NAME} (403" in written
    assert written.count("\n") == 1


@pytest.mark.parametrize("more", [[], ["--processes"]])
def test_a_defect_of_the_connection_is_not_said_to_be_the_policy_s(
    server: ReferenceServer,
    more: list[str],
    policy_folder: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    (policy_folder / "broken.py").write_text(
        "from policies import Graded\n"
        "from reference_client.protocol import http_connection\n"
        "def receive(*_): raise ModuleNotFoundError('No module named socks')\n"
        "class Broken(Graded):\n"
        "    def act(self, observation):\n"
        "        http_connection._receive_into = receive\n"
        "        return super().act(observation)\n"
    )
    right = http_connection._receive_into
    monkeypatch.setattr(http_connection, "_receive_into", right)
    flags = ["--policy", "broken:Broken", "--no-dry-turn", *options("count"), *more]
    assert main(["run", "--url", server.url, *flags]) == 1
    written = capsys.readouterr().err
    assert "This client failed in its connection to the server: ModuleNot" in written
    assert "The policy raised" not in written
