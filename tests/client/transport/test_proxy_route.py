"""Which proxy a request goes through, by a table of what shells have."""

import base64
import os
import socket

import pytest
from proctor_client import BadProxy, find_route

SERVER, SECURE = "http://robots.example:8460", "https://robots.example"


def route(monkeypatch: pytest.MonkeyPatch, url: str, **environment: str) -> str:
    """The proxy for a URL in an environment that has nothing else."""
    for name in os.environ:
        if name.lower().endswith("_proxy"):
            monkeypatch.delenv(name)
    for name, value in environment.items():
        monkeypatch.setenv(name, value)
    return find_route(url).url


@pytest.mark.parametrize(
    ("url", "environment", "proxy"),
    [
        (SERVER, {}, ""),
        (SERVER, {"http_proxy": "http://p:3128"}, "http://p:3128"),
        (SERVER, {"HTTP_PROXY": "http://p:3128/"}, "http://p:3128"),
        (SERVER, {"http_proxy": "p:3128", "HTTP_PROXY": "q:1"}, "http://p:3128"),
        (SERVER, {"http_proxy": "", "HTTP_PROXY": "q:1"}, ""),
        (SERVER, {"http_proxy": " ", "all_proxy": "p:1"}, "http://p:1"),
        (SERVER, {"HTTP_PROXY": "q:1", "REQUEST_METHOD": "GET"}, ""),
        (SERVER, {"https_proxy": "p:1"}, ""),
        (SECURE, {"https_proxy": "p:1", "all_proxy": "q:1"}, "http://p:1"),
        (SECURE, {"ALL_PROXY": "https://p"}, "https://p:443"),
        (SERVER, {"http_proxy": "proxy"}, "http://proxy:80"),
        (SERVER, {"http_proxy": '"http://p:1"\r\n'}, "http://p:1"),
        (SERVER, {"http_proxy": "HTTP://[::1]:3128"}, "http://[::1]:3128"),
        (SERVER, {"http_proxy": "http://u:w%40rd@p:1"}, "http://p:1"),
        ("http://127.0.0.1:1", {"http_proxy": "p:1"}, ""),
        ("http://127.9.9.9", {"http_proxy": "p:1"}, ""),
        ("http://[::1]:1", {"all_proxy": "p:1"}, ""),
        ("http://[::ffff:127.0.0.1]", {"all_proxy": "p:1"}, ""),
        ("http://0.0.0.0:1", {"all_proxy": "p:1"}, ""),
        ("http://LOCALHOST.:1", {"http_proxy": "p:1"}, ""),
        ("http://a.localhost", {"http_proxy": "p:1"}, ""),
        (f"http://{socket.gethostname()}", {"http_proxy": "p:1"}, ""),
        ("http://localhost.example", {"http_proxy": "p:1"}, "http://p:1"),
        ("http://127.0.0.1", {"PROCTOR_PROXY": "p:1"}, "http://p:1"),
        (SECURE, {"PROCTOR_PROXY": "p:1", "NO_PROXY": "*"}, "http://p:1"),
        (SERVER, {"PROCTOR_PROXY": "none", "http_proxy": "p:1"}, ""),
        ("http://127.0.0.1", {"all_proxy": "socks5://p:1"}, ""),
    ],
)
def test_a_proxy_is_used_or_not(
    monkeypatch: pytest.MonkeyPatch, url: str, environment: dict[str, str], proxy: str
) -> None:
    assert route(monkeypatch, url, **environment) == proxy


@pytest.mark.parametrize(
    ("entries", "url", "is_excluded"),
    [
        ("robots.example", SERVER, True),
        ("ROBOTS.example", SERVER, True),
        ("example", SERVER, True),
        (".example", SERVER, True),
        ("*.example", SERVER, True),
        ("ample", SERVER, False),
        ("other.example, robots.example", SERVER, True),
        ("other.example robots.example", SERVER, True),
        ('"robots.example"', SERVER, True),
        ("*", SERVER, True),
        ("robots.*", SERVER, True),
        ("sub.robots.example", SERVER, False),
        ("robots.example:8460", SERVER, True),
        ("robots.example:80", SERVER, False),
        ("robots.example:443", SECURE, True),
        ("10.0.0.0/8", "http://10.1.2.3", True),
        ("10.0.0.1/8", "http://10.1.2.3", True),
        ("10.0.0.0/8", "http://11.1.2.3", False),
        ("10.0.0.0/8", SERVER, False),
        ("10.1.*", "http://10.1.2.3", True),
        ("10.1.2.3", "http://10.1.2.3:8460", True),
        ("fd00::/8", "http://[fd00::7]:1", True),
        ("fd00::/8", "http://10.1.2.3", False),
        ("fd00:0::7", "http://[fd00::7]:1", True),
        ("[fd00::7]", "http://[fd00::7]:1", True),
        ("[fd00::7]:1", "http://[fd00::7]:1", True),
        ("[fd00::7]:2", "http://[fd00::7]:1", False),
        ("", SERVER, False),
    ],
)
@pytest.mark.parametrize("name", ["no_proxy", "NO_PROXY"])
def test_hosts_that_go_past_the_proxy(
    monkeypatch: pytest.MonkeyPatch,
    name: str,
    entries: str,
    url: str,
    is_excluded: bool,
) -> None:
    variables = {"ALL_PROXY": "http://p:1", name: entries}
    assert route(monkeypatch, url, **variables) == ("" if is_excluded else "http://p:1")


@pytest.mark.parametrize(
    "value",
    [
        "socks5://u:s3cret@p:1",
        "socks5h://p:1",
        "SOCKS4://p:1",
        "ftp://u:s3cret@p:1",
        "http://u:s3#cret@p:1",
        "http://u:s3/cret@p:1",
        "http://u:s3cret@p:port",
        "http://u:s3cret@p:99999",
        "http://u:s3cret@",
        "http://u:s3cret@p:1/path",
        "http://u:s3cret@[::1:1",
        "http://u:s3cret@[fe80::1%25eth0]:1",
        "http://u:s3cret@p q:1",
        "http://",
    ],
)
@pytest.mark.parametrize("name", ["http_proxy", "ALL_PROXY", "PROCTOR_PROXY"])
def test_what_cannot_be_used_is_refused_with_its_variable(
    monkeypatch: pytest.MonkeyPatch, name: str, value: str
) -> None:
    with pytest.raises(BadProxy) as refusal:
        route(monkeypatch, SERVER, **{name: value})
    assert str(refusal.value).startswith(f"{name} ")
    assert "\n" not in str(refusal.value)
    assert "cret" not in str(refusal.value)


def test_a_network_that_is_none_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    with pytest.raises(BadProxy, match=r"NO_PROXY has the entry '10.0.0.0/99'"):
        route(monkeypatch, SERVER, http_proxy="p:1", NO_PROXY="10.0.0.0/99")
    assert not route(monkeypatch, SERVER, NO_PROXY="10.0.0.0/99")


def test_the_password_is_sent_and_not_shown(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PROCTOR_PROXY", "http://us%20er:s3%40cret@p:1")
    found = find_route(SERVER)
    _, _, sent = found.headers["Proxy-Authorization"].partition(" ")
    assert base64.b64decode(sent) == b"us er:s3@cret"
    assert "cret" not in f"{found} {found.how} {found.advice}"
