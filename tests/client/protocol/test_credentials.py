"""Which token is sent: the one given, the environment's, or that of a local server."""

import socket
import threading
from http.server import BaseHTTPRequestHandler, HTTPServer
from pathlib import Path

import pytest
from proctor_client import ApiException
from urllib3.exceptions import HTTPError

from reference_client.protocol.connection import Connection
from reference_client.protocol.credentials import (
    find_credential,
    saved_key_file,
    without_secrets,
)
from reference_record.formats import local_servers
from reference_record.formats.local_servers import LocalServer

URL = "http://127.0.0.1:8460"


@pytest.fixture
def token_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The token of a server that was at port 8460 of 0.0.0.0; nothing listens there."""
    monkeypatch.delenv("PROCTOR_TOKEN", raising=False)
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path))
    monkeypatch.setattr(socket, "gethostname", lambda: "node03")
    monkeypatch.setattr(LocalServer, "is_at", lambda *_: None)
    path = tmp_path / "proctor.sqlite.token"
    write_token(path)
    with socket.create_server(("127.0.0.1", 0)) as listener:
        local_servers.publish(listener, path)
        entry = local_servers.entry_file(*listener.getsockname())
    entry.rename(local_servers.entry_file("0.0.0.0", 8460))  # noqa: S104
    return path


def write_token(path: Path, mode: int = 0o600) -> None:
    path.touch(mode)
    path.chmod(mode)
    path.write_text("proctor_sesame\n")


@pytest.mark.usefixtures("token_file")
def test_what_is_given_comes_first(monkeypatch: pytest.MonkeyPatch) -> None:
    assert find_credential(URL).token == "proctor_sesame"
    monkeypatch.setenv("PROCTOR_TOKEN", "of-the-environment")
    assert find_credential(URL).token == "of-the-environment"
    assert find_credential(URL, "given").token == "given"


OWN_ADDRESSES = [
    *("localhost", "127.0.0.1", "127.0.0.9", "[::ffff:127.0.0.1]"),
    "0.0.0.0",  # noqa: S104 - as a server prints it
]


@pytest.mark.usefixtures("token_file")
@pytest.mark.parametrize("host", OWN_ADDRESSES)
def test_a_server_on_this_machine_is_known_by_its_port(host: str) -> None:
    assert find_credential(f"http://{host}:8460/").token == "proctor_sesame"
    assert find_credential(f"http://{host}:8461").token is None


@pytest.mark.parametrize(
    ("host", "is_sent"),
    [
        ("node03", True),
        ("NODE03.cluster.example", True),
        ("node03.other.example", False),
        ("node04", False),
        ("node04.cluster.example", False),
    ],
)
@pytest.mark.parametrize("own_name", ["node03", "node03.cluster.example"])
@pytest.mark.usefixtures("token_file")
def test_the_name_of_this_machine_is_one_of_its_addresses(
    monkeypatch: pytest.MonkeyPatch, host: str, own_name: str, is_sent: bool
) -> None:
    """If it leads here: a machine of another domain may have the same name."""
    addresses = {"node03": "127.0.0.3", "node03.cluster.example": "127.0.0.3"}
    addresses |= {"node03.other.example": "198.51.100.7", "node04": "127.0.0.4"}
    look_up = socket.getaddrinfo
    entry = local_servers.entry_file("0.0.0.0", 8460)  # noqa: S104
    monkeypatch.setattr(socket, "gethostname", lambda: own_name)
    entry.parent.rename(entry.parent.with_name(own_name))
    monkeypatch.setattr(
        socket,
        "getaddrinfo",
        lambda host, *given, **more: look_up(addresses.get(host, host), *given, **more),
    )
    assert (find_credential(f"http://{host}:8460").token is not None) == is_sent


@pytest.mark.parametrize(
    "url",
    [
        "http://example.org:8460",
        "http://10.0.0.1:8460",
        "https://127.0.0.1:8460",
        "http://127.0.0.1:x",
        "http://",
        "8460",
    ],
)
@pytest.mark.usefixtures("token_file")
def test_no_other_server_is_sent_the_token(url: str) -> None:
    assert find_credential(url).token is None


@pytest.mark.parametrize("mode", [0o644, 0o620])
@pytest.mark.parametrize("is_entry", [True, False])
def test_a_file_that_others_can_use_holds_no_token(
    token_file: Path, is_entry: bool, mode: int
) -> None:
    entry = local_servers.entry_file("0.0.0.0", 8460)  # noqa: S104
    (entry if is_entry else token_file).chmod(mode)
    assert find_credential(URL).token is None


def test_a_text_for_others_has_no_secret(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PROCTOR_POLICY_KEY", "sk-12345678")
    monkeypatch.setenv("DB_PASSWORD", "short")
    text = "wss://me:pw@host/x?k=a@b 401 for sk-12345678 and my-token; short of a@b.c"
    shown = without_secrets(text, "my-token")
    assert shown == (
        "wss://host/x?… 401 for (value of PROCTOR_POLICY_KEY) and (token); "
        "short of a@b.c"
    )
    assert without_secrets(text, None).count("my-token") == 1


def test_an_entry_of_a_file_that_is_gone_is_no_token(token_file: Path) -> None:
    token_file.unlink()
    assert find_credential(URL).token is None


HOST = "https://eval.example.org"


@pytest.mark.parametrize(
    "case",
    [
        (HOST, [], "", "", True, ["sent none", f"`proctor login --url {HOST}`"]),
        (HOST, [], "", "", False, ["sent none", "/proctor has none", "The operator"]),
        (URL, [], "", "", False, ["sent none", "The server printed a token"]),
        (URL, ["open"], "", "", False, ["other accounts may read", "chmod 600"]),
        (HOST, ["key"], "", "", True, ["sent the key that", f"login --url {HOST}`"]),
        (HOST, ["key"], "", "", True, [f"suspended account makes none: {HOST}/hosti"]),
        (HOST, [], "", "x", True, ["PROCTOR_TOKEN", "login", "unset PROCTOR_TOKEN"]),
        (HOST, ["key"], "", "x", True, ["To use the key that", "unset PROCTOR_TOKEN"]),
        (URL, ["server"], "", "x", False, ["To use the token that the server keeps"]),
        (HOST, ["key"], "x", "y", True, ["argument `token`. To use the key", "out."]),
        (HOST, [], "x", "", False, ["value of the argument `token`", "The operator"]),
        (URL, ["server"], "", "", False, ["sent the token that the server keeps in"]),
    ],
)
def test_a_refusal_names_what_was_sent_and_what_to_do(
    token_file: Path,
    monkeypatch: pytest.MonkeyPatch,
    case: tuple[str, list[str], str, str, bool, list[str]],
) -> None:
    """Also that no text has the secret. case: URL, files, the token given,
    PROCTOR_TOKEN, whether people register there, and what is said."""
    url, keeps, given, variable, has_accounts, said = case
    token_file.unlink()
    for kept in keeps:
        path = saved_key_file(url) if kept == "key" else token_file
        path.parent.mkdir(exist_ok=True)
        write_token(path, 0o644 if kept == "open" else 0o600)
    if variable:
        monkeypatch.setenv("PROCTOR_TOKEN", variable)
    credential = find_credential(url, given)
    text = credential.explain_refusal(has_accounts=has_accounts)
    assert all(part in text for part in said), text
    assert "sesame" not in f"{text}{credential}"


class _AnsweringOnce(BaseHTTPRequestHandler):
    """It notes the token, and answers what is no service of Proctor."""

    tokens: list[str | None]

    def do_GET(self) -> None:
        self.tokens.append(self.headers["Authorization"])
        self.send_error(404)

    def log_message(self, *_args: object) -> None:
        pass


@pytest.mark.parametrize("given", [None, "given"])
@pytest.mark.parametrize("has_earlier", [True, False])
def test_a_server_that_is_waited_for_makes_its_token(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    has_earlier: bool,
    given: str | None,
) -> None:
    """It binds its port, writes its token, and listens then."""
    monkeypatch.delenv("PROCTOR_TOKEN", raising=False)
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path))
    tokens: list[str | None] = []
    handler = type("Handler", (_AnsweringOnce,), {"tokens": tokens})
    path = tmp_path / "token"
    with HTTPServer(("127.0.0.1", 0), handler, bind_and_activate=False) as server:
        server.server_bind()
        if has_earlier:
            write_token(path)
            path.write_text("proctor_of_an_earlier_server")
            local_servers.publish(server.socket, path)
        url = f"http://127.0.0.1:{server.server_port}"
        with Connection(url, find_credential(url, given), requests=1) as connection:
            with pytest.raises(HTTPError):
                connection.control.describe_service()
            write_token(path)
            local_servers.publish(server.socket, path)
            server.server_activate()
            thread = threading.Thread(target=server.handle_request)
            thread.start()
            with pytest.raises(ApiException):
                connection.control.describe_service()
            thread.join()
            assert connection.credential.token == (given or "proctor_sesame")
            connection.contact.has_answered = True
            path.write_text("proctor_of_another_account")
            connection.data(url)
            assert connection.credential.token == (given or "proctor_sesame")
    assert tokens == [f"Bearer {given or 'proctor_sesame'}"]
