"""Certificates: which are accepted, and that one that is not is said at once."""

import json
import re
import ssl
from collections.abc import Iterator
from pathlib import Path

import pytest
from proctor_client.transport.tls_trust import VARIABLES, client_context

from reference_client import ProctorError, evaluate
from reference_client.command.main import main
from reference_client.protocol.http_connection import HttpConnection
from tests.support.client.command import options
from tests.support.client.policies import GradedPolicy
from tests.support.kit.null_servers import canned_answers, run_server
from tests.support.network.tls_gateway import gateway_to, serve_tls
from tests.support.servers import ReferenceServer


@pytest.fixture(autouse=True)
def no_variables(monkeypatch: pytest.MonkeyPatch) -> None:
    for name in (*VARIABLES, "SSL_CERT_DIR"):
        # Set first: what a test or the command sets is then taken back.
        monkeypatch.setenv(name, "")
        monkeypatch.delenv(name)


@pytest.fixture(scope="module")
def tls_server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[tuple[str, Path]]:
    with serve_tls(tmp_path_factory.mktemp("tls"), canned_answers) as served:
        yield served


def benchmarks(capsys: pytest.CaptureFixture[str], *flags: str) -> tuple[int, str]:
    """The exit code and what was written, of a command that would retry for long."""
    code = main(["benchmarks", "--retry-timeout-s", "60", "--token", "t", *flags])
    captured = capsys.readouterr()
    return code, captured.out + captured.err


def test_an_unknown_certificate_is_said_at_once(
    tls_server: tuple[str, Path], capsys: pytest.CaptureFixture[str]
) -> None:
    url, _ = tls_server
    code, written = benchmarks(capsys, "--url", url)
    assert (code, written.count("\n")) == (2, 1)
    assert f"The certificate of {url} is not accepted: self-signed" in written
    assert "--ca, PROCTOR_CA" in written
    assert written.endswith("[not_trusted]\n")
    with pytest.raises(ProctorError) as caught:
        evaluate(GradedPolicy, url=url, token="t", benchmark="calibration")
    assert caught.value.code == "not_trusted"


def test_a_certificate_for_another_name_is_said_at_once(
    tls_server: tuple[str, Path], capsys: pytest.CaptureFixture[str]
) -> None:
    url, pem = tls_server
    url = url.replace("localhost", "127.0.0.1")
    code, written = benchmarks(capsys, "--url", url, "--ca", str(pem))
    assert code == 2
    assert "is not accepted: IP address mismatch" in written


def test_no_tls_is_said_at_once(capsys: pytest.CaptureFixture[str]) -> None:
    with run_server(canned_answers) as url:
        code, written = benchmarks(capsys, "--url", url.replace("http:", "https:"))
    assert (code, written.count("\n")) == (2, 1)
    assert "does not speak TLS" in written


def test_the_flag_names_certificates(
    tls_server: tuple[str, Path], capsys: pytest.CaptureFixture[str]
) -> None:
    url, pem = tls_server
    code, written = benchmarks(capsys, "--url", url, "--ca", str(pem), "--json")
    assert code == 0
    assert json.loads(written)[0]["benchmark_id"] == "calibration"


@pytest.mark.usefixtures("policy_folder")
def test_an_endpoint_without_tls_leaves_no_run_behind(
    server: ReferenceServer,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """A proxy speaks TLS, the server behind it has no public URL. Expect the cause and
    what to do, and that the run of which no turn was played is stopped: the proxy
    forwards no DELETE."""
    with serve_tls(tmp_path, gateway_to(server.url)) as (url, pem):
        flags = ["--url", url, "--ca", str(pem), "--policy", "policies:Graded"]
        code = main(["run", *flags, *options("count")])
        captured = capsys.readouterr()
    assert code == 2
    refusal, withdrawn = captured.err.splitlines()[-2:]
    assert "is not HTTPS; refusing to send the token" in refusal
    assert refusal.endswith("set the server's public URL. [not_trusted]")
    (run_id,) = re.findall(r"run_\w+", withdrawn)
    assert withdrawn == f"No turn was played, so run {run_id} was withdrawn."
    main(["status", run_id, "--url", server.url])
    assert "stopped" in capsys.readouterr().out


@pytest.mark.parametrize("name", VARIABLES)
def test_the_usual_variables_name_certificates(
    tls_server: tuple[str, Path],
    name: str,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """In both planes: the second one has a connection of its own."""
    url, pem = tls_server
    monkeypatch.setenv(name, str(pem))
    assert benchmarks(capsys, "--url", url)[0] == 0
    connection = HttpConnection(url, (5.0, 5.0), lambda n: memoryview(bytearray(n)))
    request = b"GET /v1 HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n"
    assert connection.send_request(request).status == 200
    connection.close()


@pytest.mark.parametrize("content", [None, b"no certificate"])
def test_a_file_without_certificates_is_wrong_usage(
    tmp_path: Path, content: bytes | None, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "ca.pem"
    if content is not None:
        path.write_bytes(content)
    code, written = benchmarks(capsys, "--url", "https://[::1]:9", "--ca", str(path))
    assert (code, written.count("\n")) == (2, 1)
    assert f"PROCTOR_CA names {path}, which has no certificates" in written


def test_folders_may_hold_them(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PROCTOR_CA", str(tmp_path))
    assert client_context().verify_mode == ssl.CERT_REQUIRED
