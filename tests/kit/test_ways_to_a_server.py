"""The kit on its way to a server: proxies, certificates, addresses, redirections."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from conformance.cli.main import main
from tests.support.kit.endless_answers import ENDLESS, serve_parts
from tests.support.kit.null_servers import always, canned_answers, run_server
from tests.support.kit.run_kit import run_kit
from tests.support.network.forward_proxy import run_forward_proxy
from tests.support.network.tls_gateway import serve_tls
from tests.support.servers import TOKENS, ReferenceServer

pytestmark = pytest.mark.slow("starts servers and kits")
NAME = "robots.behind.example"
URL = f"http://{NAME}"
VARIABLES = ("http_proxy", "https_proxy", "all_proxy", "no_proxy")


@pytest.fixture(autouse=True)
def _environment(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("PROCTOR_TOKEN", TOKENS["alice"])
    for name in (*VARIABLES, *map(str.upper, VARIABLES), "PROCTOR_CA"):
        monkeypatch.setenv(name, "")  # --ca sets one: it is taken back
        monkeypatch.delenv(name)


@pytest.fixture(scope="module")
def hosts(
    tmp_path_factory: pytest.TempPathFactory,
) -> Iterator[dict[str, tuple[str, int]]]:
    folder = tmp_path_factory.mktemp("behind")
    with ReferenceServer(folder, PROCTOR_PUBLIC_URL=URL) as server:
        yield {NAME: ("127.0.0.1", int(server.url.rpartition(":")[2]))}


def test_a_server_is_judged_through_a_proxy(
    hosts: dict[str, tuple[str, int]], tmp_path: Path
) -> None:
    """Requests, event streams, and connections for bytes that no library sends."""
    rules = "SVC-003,SVC-005,PRED-001,EVT-001,LIM-001"
    with run_forward_proxy(hosts, password="user:s3cret") as proxy:
        user = proxy.url.replace("//", "//user:s3cret@")
        flags = ["--url", URL, "--only", rules, "--stress"]
        kit = run_kit(tmp_path / "report", *flags, http_proxy=user)
    assert (kit.code, set(kit.outcomes.values())) == (0, {"passed"})
    assert f"CONNECT {NAME}:80" in proxy.requests
    assert f"GET {URL}/v1" in proxy.requests
    assert not any(b"s3cret" in path.read_bytes() for path in kit.folder.iterdir())


@pytest.mark.parametrize(
    ("variables", "url", "text"),
    [
        ({}, URL, "without a proxy: no proxy is set): start the server or correct"),
        (
            {"ALL_PROXY": "http://user:s3cret@127.0.0.1:1"},
            URL,
            f"http://127.0.0.1:1 of ALL_PROXY, on the way to {URL}, is unreachable (",
        ),
        ({"https_proxy": "socks5://p"}, f"https://{NAME}", "https_proxy names a SOCKS"),
        ({"http_proxy": "FREE"}, URL, "of http_proxy, in front of the server, answer"),
        ({"http_proxy": "FREE"}, "http://127.0.0.1:1", "http_proxy is not for addr"),
        ({"PROCTOR_PROXY": "FREE"}, f"https://{NAME}", "did not reach it (502"),
        ({"PROCTOR_PROXY": "WANTS"}, f"https://{NAME}", "refused the way to https://"),
        (
            {"http_proxy": "WANTS"},
            URL,
            "Give it in http_proxy=http://USER:PASSWORD@HOST",
        ),
        ({"PROCTOR_TOKEN": "s3cret s3cret"}, URL, "the token of PROCTOR_TOKEN has a"),
        ({}, "http://user:s3cret@h", "must not have a user and a password"),
        ({}, "http://[fe80::1%25eth0]:1", "names a network interface"),
    ],
)
def test_what_went_wrong_on_the_way_is_not_the_server_s(
    variables: dict[str, str],
    url: str,
    text: str,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    with (
        run_forward_proxy({NAME: ("127.0.0.1", 1)}) as free,
        run_forward_proxy(password="user:s3cret") as wants,
    ):
        places = {"FREE": free.url, "WANTS": wants.url}
        for name, value in variables.items():
            monkeypatch.setenv(name, places.get(value, value))
        assert main(["--url", url, "--only", "SVC"]) == 2
    written = capsys.readouterr().out
    assert written.splitlines()[-1].startswith("not decided: ")
    assert text in written
    assert "s3cret" not in written


@pytest.mark.parametrize(
    ("host", "ca", "text"),
    [
        ("https://localhost", "", "self-signed certificate. Name the file with"),
        ("https://127.0.0.1", "--ca", "is not accepted: IP address mismatch"),
        ("http://localhost", "--ca", "(https:// if it speaks TLS)"),
        ("https://localhost", "--ca", "SVC-001   passed"),
    ],
)
def test_a_certificate_is_accepted_or_its_fault_is_named(
    host: str, ca: str, text: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    with serve_tls(tmp_path, canned_answers) as (url, pem):
        flags = [ca, str(pem)] if ca else []
        port = url.rpartition(":")[2]
        assert main(["--url", f"{host}:{port}", "--only", "SVC-001", *flags]) in (0, 2)
    written = capsys.readouterr().out
    assert text in written


def test_a_server_that_does_not_speak_tls_and_a_file_that_is_missing_are_named(
    capsys: pytest.CaptureFixture[str],
) -> None:
    with run_server(always(200)) as url:
        assert main(["--url", url.replace("http:", "https:"), "--only", "SVC"]) == 2
        assert (
            "does not speak TLS as this program does (WRONG_VERSION_N"
            in capsys.readouterr().out
        )
        assert main(["--url", url, "--ca", "nowhere.pem"]) == 2
        assert "nowhere.pem, which has no certificates" in capsys.readouterr().out


def test_an_answer_without_an_end_is_named(capsys: pytest.CaptureFixture[str]) -> None:
    with serve_parts(ENDLESS["body"]) as url:
        assert main(["--url", url, "--only", "SVC"]) == 2
    written = capsys.readouterr().out
    assert "sends what cannot be read: the body had no end after 128 MiB" in written


@pytest.mark.parametrize(
    ("location", "text"),
    [
        ("https://new.example/base/v1", "server is at https://new.example/base; give"),
        ("/moved/v1", "server is at http://127.0.0.1:"),
        ("https://login.example/?to=v1", "points to https://login.example/?to=v1"),
    ],
)
@pytest.mark.parametrize("status", [301, 308])
def test_a_redirection_is_named(
    status: int, location: str, text: str, capsys: pytest.CaptureFixture[str]
) -> None:
    with run_server(lambda _: (status, {"Location": location}, b"")) as url:
        assert main(["--url", url, "--only", "SVC"]) == 2
    assert text in capsys.readouterr().out
