"""Who is at fault for an answer that does not come, or is not one of Proctor."""

import socket
import ssl
from collections.abc import Iterator

import httpx
import pytest
from proctor_client import ApiException, ProxyFault, ProxyRoute
from proctor_client.transport import fault_texts
from urllib3 import HTTPHeaderDict

from conformance.client.connections.failure_texts import describe_failure
from reference_client.command.main import main
from reference_client.errors import from_failure
from reference_client.policies.servers.server_transport import Unreached, fault_of
from reference_client.protocol import connection, control_client, retry_policy

URL, SECURE = "http://robots.example:8460", "https://robots.example"
pytestmark = pytest.mark.usefixtures("no_proxies")
PROXY = "http://127.0.0.1:3128"
ROUTE = ProxyRoute(PROXY, "ALL_PROXY", {}, "through the proxy", "NO_PROXY=h goes past")
WITH_USER = ProxyRoute(PROXY, "ALL_PROXY", {"Proxy-Authorization": "Basic eA=="})
HTML = {"Content-Type": "text/html; charset=utf-8"}
JSON = {"Content-Type": "application/json", "Proctor-Version": "1.0"}
SAFE = "The request may have been carried out"


@pytest.fixture
def silent_address() -> Iterator[str]:
    """Connections to it are taken, and nothing is ever said."""
    with socket.create_server(("127.0.0.1", 0)) as listener:
        yield f"127.0.0.1:{listener.getsockname()[1]}"


@pytest.mark.parametrize(
    ("route", "challenges", "text"),
    [
        (ROUTE, ["Basic realm=x"], "Give it in ALL_PROXY=http://USER:PASSWORD@"),
        (ROUTE, [], "Give it in ALL_PROXY=http://USER:PASSWORD@"),
        (WITH_USER, ["basic realm=x"], "did not accept the user and the password that"),
        (WITH_USER, ["NTLM", "Basic realm=x"], "did not accept the user"),
        (WITH_USER, ["Negotiate", "NTLM"], "asks for Negotiate or NTLM, and this"),
    ],
)
def test_the_refusal_of_a_proxy_says_what_it_lacks(
    route: ProxyRoute, challenges: list[str], text: str
) -> None:
    said = fault_texts.describe_proxy_fault(SECURE, route, "407 No", 407, challenges)
    assert said.startswith(f"The proxy {PROXY} of ALL_PROXY refused the way to")
    assert text in said


@pytest.mark.parametrize(
    ("reason", "text"),
    [
        ("TLSV13_ALERT_CERTIFICATE_REQUIRED", "wants a certificate of the client"),
        ("TLSV1_ALERT_PROTOCOL_VERSION", "other versions of TLS than this program"),
        ("UNSUPPORTED_PROTOCOL", "other versions of TLS than this program"),
        ("WRONG_VERSION_NUMBER", "(WRONG_VERSION_NUMBER). Check the port"),
    ],
)
def test_an_alert_of_tls_has_its_own_cure(reason: str, text: str) -> None:
    error = ssl.SSLError(1, reason)
    error.reason = reason
    assert text in fault_texts.describe_tls_fault(error, URL)


@pytest.mark.parametrize(
    ("received", "is_http2"),
    [
        ("\0\0\x12\x04\0\0\0\0\0\0\x03", True),
        ("\0\n\x12\x04\0\0\0\0\0", True),
        ("HTTP/1.1 200 OK", False),
        ("", False),
    ],
)
def test_http2_is_known_by_its_first_frame(received: str, is_http2: bool) -> None:
    assert (fault_texts.describe_http2(URL, received) is not None) == is_http2


@pytest.mark.parametrize(
    ("headers", "method", "proxy", "texts"),
    [
        (HTML, "GET", PROXY, [f"or the proxy {PROXY} of http_proxy", "a sign-in"]),
        (HTML, "POST", "", ["(a page, text/html)", "a sign-in"]),
        (JSON, "GET", PROXY, ["report this to its operator", PROXY]),
        (JSON, "POST", "", ["report this to its operator"]),
        (JSON, "", "", ["(not JSON)", "report this to its operator"]),
    ],
)
def test_an_answer_is_not_laid_on_a_server_that_did_not_send_it(
    headers: dict[str, str],
    method: str,
    proxy: str,
    texts: list[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """And nothing was carried out by a GET."""
    monkeypatch.setenv("http_proxy", proxy)
    failure = ApiException(reason="not JSON", headers=HTTPHeaderDict(headers))
    failure.method = method
    error = from_failure(failure, URL)
    for text in texts:
        assert text in error.detail
    may_be_done = method != "GET"
    assert (SAFE in error.detail) == may_be_done
    assert error.side_effects == ("possible" if may_be_done else "none")
    assert ("operator" in error.detail) == (headers is JSON)


@pytest.mark.parametrize("status", [302, 404, 502])
def test_a_refusal_without_a_problem_names_the_proxy(
    status: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("http_proxy", PROXY)
    headers = HTTPHeaderDict({"Location": "http://login.example/?u=1"})
    detail = from_failure(ApiException(status, "No", headers=headers), URL).detail
    assert f", or the proxy {PROXY} of http_proxy in its place, answered" in detail
    assert "NO_PROXY=robots.example goes past it" in detail


@pytest.mark.parametrize(
    ("status", "reason", "text"),
    [
        (0, "it did not answer in time", "The server was not asked"),
        (403, "403 Forbidden", "refused the way to"),
        (502, "502 Bad Gateway", f"on the way to {SECURE}, did not reach it"),
    ],
)
def test_a_proxy_that_opened_no_tunnel_is_at_fault(
    status: int, reason: str, text: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """In the same words for the evaluation server, for policies and in the kit."""
    monkeypatch.setenv("https_proxy", PROXY)
    fault = ProxyFault(reason, status)
    error = from_failure(fault, SECURE)
    assert error.detail.startswith(f"The proxy {PROXY} of https_proxy")
    assert f"({reason})" in error.detail
    assert text in error.detail
    assert (error.retryable, error.side_effects) == (status != 403, "none")
    of_policy = fault_of(SECURE, fault)
    assert isinstance(of_policy, Unreached) == error.retryable
    assert text in str(of_policy)
    of_kit = describe_failure(httpx.ProxyError(reason), SECURE)
    assert of_kit == f"the{error.detail[3:-1]}"


@pytest.mark.slow("waits for silent connections")
@pytest.mark.parametrize(
    ("variable", "text"),
    [
        ("", "did not answer in time. It takes connections and has not said"),
        ("https_proxy=http", "opened no connection to it (it did not answer"),
        ("http_proxy=https", "opened no connection to it (it did not answer"),
        ("http_proxy=http", "in its place, did not answer in time"),
    ],
)
def test_silence_ends_in_time_and_is_said(
    variable: str,
    text: str,
    silent_address: str,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """It is that of a server, or of a proxy in front of it. Expect a line while it is
    waited for, and in the end who was silent."""
    monkeypatch.setattr(connection, "FIRST_ANSWER_S", 0.4)
    monkeypatch.setattr(retry_policy, "_SILENT_S", 0.1)
    monkeypatch.setattr(control_client, "TIMEOUTS_S", (0.4, 60.0))
    url = f"http://{silent_address}"
    if variable:
        name, scheme = variable.split("=")
        monkeypatch.setenv(name, f"{scheme}://{silent_address}")
        url = SECURE if name == "https_proxy" else URL
    assert main(["benchmarks", "--url", url, "--retry-timeout-s", "0"]) == 2
    waiting, last = capsys.readouterr().err.splitlines()
    assert waiting == f"proctor: {url} has not answered yet. Waiting for up to 0.4 s …"
    assert text in last
