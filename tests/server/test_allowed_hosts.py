"""Which hosts a request may be sent to, and that no other becomes an endpoint."""

from __future__ import annotations

import pytest

from reference_server.rules.refusal import Refused
from reference_server.settings.allowed_hosts import AllowedHosts
from tests.support.servers import ReferenceServer

HOSTS = AllowedHosts.parse("Eval.example.org, *.example.net, [::1]")


def is_allowed(hosts: AllowedHosts, host: str) -> bool:
    try:
        hosts.check(host)
    except Refused as refused:
        return (refused.code, refused.errors[0][0]) != (
            "invalid_request",
            "header:host",
        )
    return True


@pytest.mark.parametrize(
    "host",
    [
        *("eval.example.org", "EVAL.example.org:8460", "a.example.net", "[::1]:80"),
        *("a.b.example.net", "localhost", "127.0.0.1:8460", "[::1]"),
    ],
)
def test_names_and_subdomains_are_allowed(host: str) -> None:
    assert is_allowed(HOSTS, host)


@pytest.mark.parametrize(
    "host", ["example.org", "example.net", "xexample.net", "eval.example.org.x", "::1"]
)
def test_other_names_are_refused(host: str) -> None:
    assert not is_allowed(HOSTS, host)


@pytest.mark.parametrize("host", ["", "a b", "a/b", "a@b", "a:x", "a:123456", "[x]"])
def test_what_is_no_host_is_refused_always(host: str) -> None:
    assert not is_allowed(AllowedHosts(), host)
    assert is_allowed(AllowedHosts(), "anything-else.example:1")


@pytest.mark.parametrize("text", ["a b", "a:80", "*", "*.*.org", "http://a"])
def test_a_setting_that_is_no_list_of_names_is_an_error(text: str) -> None:
    with pytest.raises(ValueError, match="host name"):
        AllowedHosts.parse(text)


@pytest.mark.slow("starts a server")
def test_another_host_is_refused_and_never_an_endpoint(
    tmp_path_factory: pytest.TempPathFactory,
) -> None:
    path = tmp_path_factory.mktemp("hosts")
    submission = {"benchmark_id": "calibration", "policy": {"name": "p"}}
    with (
        ReferenceServer(path, PROCTOR_ALLOWED_HOSTS="eval.example.org") as server,
        server.client() as client,
    ):
        for host, status in (("eval.example.org", 201), ("evil.example", 422)):
            answer = client.post("/v1/runs", json=submission, headers={"Host": host})
            assert answer.status_code == status
            assert ("evil" in answer.text) is False
