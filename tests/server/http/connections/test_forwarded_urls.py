"""The base URL of a request, and what a trusted proxy may change of it."""

from __future__ import annotations

import pytest
from pydantic import ValidationError
from starlette.requests import Request

from reference_server.http.connections.forwarded_urls import base_url_of
from reference_server.settings import Settings

HOST = "eval.example.org:8460"
URL = f"http://{HOST}"


def url_of(
    headers: dict[str, str], peer: str = "127.0.0.1", trusted: str = "127.0.0.1,::1"
) -> str:
    lines = {"host": HOST, **headers}
    scope = {
        "type": "http",
        "path": "/v1/runs",
        "scheme": "http",
        "query_string": b"",
        "client": (peer, 50000) if peer else None,
        "headers": [(name.encode(), text.encode()) for name, text in lines.items()],
    }
    return base_url_of(Request(scope), trusted)


@pytest.mark.parametrize(
    ("prefix", "shown"),
    [
        ("/proctor", f"{URL}/proctor"),
        ("/proctor/", f"{URL}/proctor"),
        ("/a/b-c/d.e_f~g", f"{URL}/a/b-c/d.e_f~g"),
        *((text, URL) for text in ("", "/", "//", "proctor", "/a//b", "/..", "/a/..")),
        *((text, URL) for text in ("//evil.example", "/a?b", "/a#b", "/a b", "/a@b")),
        *((text, URL) for text in ("/%2e%2e", "/a\\b", "/a,/b", "/" + 65 * "a")),
        ("/a" * 17, URL),
    ],
)
def test_a_prefix_is_a_plain_path(prefix: str, shown: str) -> None:
    assert url_of({"x-forwarded-prefix": prefix}) == shown


@pytest.mark.parametrize(
    ("scheme", "shown"),
    [
        ("https", "https"),
        ("https, http", "https"),
        ("http", "http"),
        ("", "http"),
        ("javascript", "http"),
        ("https://evil.example", "http"),
    ],
)
def test_a_scheme_is_http_or_https(scheme: str, shown: str) -> None:
    assert url_of({"x-forwarded-proto": scheme}) == f"{shown}://{HOST}"


@pytest.mark.parametrize(
    ("peer", "trusted", "is_trusted"),
    [
        ("127.0.0.1", "127.0.0.1,::1", True),
        ("::1", "127.0.0.1,::1", True),
        ("::ffff:127.0.0.1", "127.0.0.1", True),
        ("10.0.0.7", "127.0.0.1,::1", False),
        ("10.0.0.7", "10.0.0.0/8", True),
        ("10.0.0.7", "all", True),
        ("127.0.0.1", "", False),
        ("", "127.0.0.1", False),
        ("testclient", "127.0.0.1", False),
    ],
)
def test_only_a_trusted_proxy_is_believed(
    peer: str, trusted: str, is_trusted: bool
) -> None:
    headers = {"x-forwarded-prefix": "/p", "x-forwarded-proto": "https"}
    shown = f"https://{HOST}/p" if is_trusted else URL
    assert url_of(headers, peer, trusted) == shown


@pytest.mark.parametrize("text", ["nginx", "10.0.0.1/8", "127.0.0.1;::1"])
def test_a_setting_that_is_no_list_of_networks_is_refused(text: str) -> None:
    with pytest.raises(ValidationError, match="trusted_proxies"):
        Settings(trusted_proxies=text, _env_file=None)
