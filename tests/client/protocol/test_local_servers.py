"""The token of a server that one started here, and who else may listen at its port."""

import contextlib
import os
import socket
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest

from reference_client.errors import NOT_TRUSTED, ProctorError
from reference_client.protocol.connection import Connection
from reference_client.protocol.credentials import find_credential, saved_key_file
from reference_record.formats import local_servers

TOKEN = "proctor_sesame"
EVERY = "0.0.0.0"  # noqa: S104


@pytest.fixture(autouse=True)
def token_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.delenv("PROCTOR_TOKEN", raising=False)
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    return make_token(tmp_path / "proctor.sqlite.token", TOKEN)


def make_token(path: Path, token: str) -> Path:
    path.touch(0o600)
    path.write_text(token)
    return path


def listening(host: str, port: int = 0) -> socket.socket:
    family = socket.AF_INET6 if ":" in host else socket.AF_INET
    return socket.create_server((host, port), family=family)


def token_sent(host: str, port: int, *, as_if_found: str = "") -> str | None:
    """The token that a request to this address has; NOT_TRUSTED where it is not sent.

    as_if_found: the file whose token was found before, when nothing listened.
    """
    place = f"[{host}]" if ":" in host else host
    credential = find_credential(f"http://{place}:{port}")
    if as_if_found:
        credential = replace(credential, token=TOKEN, server_file=as_if_found)
    if credential.token is None:
        return None
    with socket.create_connection((host, port)) as connected:
        try:
            credential.check_connection(connected)
        except ProctorError as error:
            refused = error
        else:
            return credential.token
    assert "so the token is not sent" in refused.detail
    assert TOKEN not in refused.detail
    return refused.code


@pytest.mark.parametrize(
    "case",
    [
        ("127.0.0.1", "127.0.0.1", True),
        ("127.0.0.1", "localhost", True),
        ("127.0.0.3", "127.0.0.3", True),
        ("127.0.0.3", "127.0.0.1", False),
        (EVERY, "127.0.0.3", True),
        (EVERY, EVERY, True),
        ("::1", "::1", True),
        ("::", "::1", True),
        ("::", "127.0.0.1", True),
    ],
)
@pytest.mark.parametrize("knows_by", ["kernel", "lsof"])
def test_the_server_is_known_by_its_socket(
    case: tuple[str, str, bool],
    knows_by: str,
    token_file: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """At each address that leads to it, by what the kernel shows, or lsof.

    case: where the server listens, which address is asked, and whether it is sent.
    """
    server_at, asked, is_sent = case
    family = socket.AF_INET6 if ":" in server_at else socket.AF_INET
    is_dual = server_at == "::"
    with socket.create_server(
        (server_at, 0), family=family, dualstack_ipv6=is_dual
    ) as listener:
        port = listener.getsockname()[1]
        local_servers.publish(listener, token_file)
        if knows_by == "lsof":
            show_by_lsof(monkeypatch, token_file.parent, server_at, port)
        with contextlib.ExitStack() as stack:
            if not is_sent:  # what has the address is of another program
                stack.enter_context(listening(asked, port))
            # lsof does not show whether another user has the nearer socket of IPv4.
            is_unsure = knows_by == "lsof" and is_dual and ":" not in asked
            is_found = is_sent and not is_unsure
            assert token_sent(asked, port) == (TOKEN if is_found else None)


def show_by_lsof(
    monkeypatch: pytest.MonkeyPatch, folder: Path, host: str, port: int
) -> None:
    """As a system without the kernel's tables: lsof shows this process at the port."""
    shown = {EVERY: "*", "::": "*", "::1": "[::1]"}.get(host, host)
    family = "-i6TCP" if ":" in host else "-i4TCP"
    program = folder / "bin" / "lsof"
    program.parent.mkdir()
    program.write_text(
        "#!/bin/sh\n"
        f'case "$*" in "-nP -a -u {os.getuid()} -p {os.getpid()} {family}:{port} "*)\n'
        f"  printf 'p{os.getpid()}\\nf3\\nn{shown}:{port}\\n';; esac\n"
    )
    program.chmod(0o700)
    monkeypatch.setenv("PATH", f"{program.parent}:{os.environ['PATH']}")
    monkeypatch.setattr(local_servers, "_KERNEL_TABLES", (folder / "none",))


@contextlib.contextmanager
def port_of_an_ended_server(token_file: Path) -> Iterator[int]:
    """Its entry stays, as after a crash."""
    with listening("127.0.0.1") as listener:
        port = listener.getsockname()[1]
        local_servers.publish(listener, token_file)
    yield port


@pytest.mark.parametrize("knows_by", ["kernel", "lsof", "nothing"])
@pytest.mark.parametrize("found_before", [True, False])
def test_who_takes_the_port_of_an_ended_server_gets_nothing(
    knows_by: str,
    found_before: bool,
    token_file: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Another program of this user may be a tunnel to another machine.

    found_before: the token was looked up while nothing listened there.
    """
    kept = str(token_file) if found_before else ""
    with (
        port_of_an_ended_server(token_file) as port,
        listening("127.0.0.1", port),
    ):
        if knows_by != "kernel":
            show_by_lsof(monkeypatch, token_file.parent, "127.0.0.1", port + 1)
        if knows_by == "nothing":
            (token_file.parent / "bin" / "lsof").unlink()
            monkeypatch.setenv("PATH", str(token_file.parent))
        expected = NOT_TRUSTED if found_before else None
        assert token_sent("127.0.0.1", port, as_if_found=kept) == expected
        refusal = find_credential(f"http://127.0.0.1:{port}").explain_refusal(
            has_accounts=False
        )
        assert "another program listens at" in refusal
        assert str(token_file) in refusal


def test_a_socket_of_another_user_gets_nothing(
    token_file: Path, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """Expect so even where its number is that of the server's, as after a boot."""
    with listening("127.0.0.1") as listener:
        port = listener.getsockname()[1]
        local_servers.publish(listener, token_file)
        assert token_sent("127.0.0.1", port) == TOKEN
        inode = os.fstat(listener.fileno()).st_ino
        table = tmp_path / "tcp"
        line = f" 0: 0100007F:{port:04X} 00000000:0000 0A 0:0 0:0 0 %d 0 {inode} 1\n"
        monkeypatch.setattr(local_servers, "_KERNEL_TABLES", (table,))
        for uid, expected in ((os.getuid(), TOKEN), (os.getuid() + 1, None)):
            table.write_text(f"sl local_address\n{line % uid}")
            assert token_sent("127.0.0.1", port) == expected


def test_a_name_with_two_addresses_leads_to_the_server_or_nowhere(
    token_file: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """localhost: the server has 127.0.0.1, and another program ::1."""
    with listening("127.0.0.1") as listener:
        port = listener.getsockname()[1]
        local_servers.publish(listener, token_file)
        look_up = socket.getaddrinfo
        monkeypatch.setattr(
            socket,
            "getaddrinfo",
            lambda host, *given, **more: [
                entry
                for address in (["::1", "127.0.0.1"] if host == "localhost" else [host])
                for entry in look_up(address, *given, **more)
            ],
        )
        assert token_sent("localhost", port) == TOKEN
        with listening("::1", port):
            assert token_sent("localhost", port) == NOT_TRUSTED


def test_machines_and_addresses_have_entries_of_their_own(
    token_file: Path, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """One home, the same port: two servers on one machine, and one on another."""
    other = make_token(tmp_path / "other.token", "proctor_other")
    third = make_token(tmp_path / "third.token", "proctor_third")
    with listening("127.0.0.2") as listener:
        port = listener.getsockname()[1]
        with listening("127.0.0.3", port) as second:
            local_servers.publish(listener, token_file)
            local_servers.publish(second, other)
            keys = [saved_key_file(f"http://127.0.0.1:{port}")]
            keys += [saved_key_file("https://eval.example.org")]
            with monkeypatch.context() as elsewhere:
                elsewhere.setattr(socket, "gethostname", lambda: "node02")
                assert token_sent("127.0.0.2", port) is None
                local_servers.publish(second, third)
                assert token_sent("127.0.0.3", port) == "proctor_third"
                assert saved_key_file(f"http://127.0.0.1:{port}") != keys[0]
                assert saved_key_file("https://eval.example.org") == keys[1]
            assert token_sent("127.0.0.2", port) == TOKEN
            assert token_sent("127.0.0.3", port) == "proctor_other"
            files = {token_file, other, third}
            assert set(local_servers.token_files()) == files


def test_a_server_leaves_one_entry(token_file: Path, tmp_path: Path) -> None:
    """It moved to another port; that of a folder that is gone goes, too."""
    gone = make_token(tmp_path / "gone.token", "proctor_gone")
    with listening("127.0.0.1") as first, listening("127.0.0.1") as second:
        local_servers.publish(first, gone)
        gone.unlink()
        with listening("127.0.0.1") as third:
            local_servers.publish(third, token_file)
        local_servers.publish(second, token_file)
        kept = local_servers.entry_file(*second.getsockname())
        assert list(kept.parent.iterdir()) == [kept]
        assert kept.stat().st_mode & 0o777 == 0o600


@pytest.mark.parametrize("is_turn", [True, False])
def test_each_connection_is_checked(token_file: Path, is_turn: bool) -> None:
    """The server ended during a run, and another program took its port."""
    with listening("127.0.0.1") as listener:
        port = listener.getsockname()[1]
        local_servers.publish(listener, token_file)
        url = f"http://127.0.0.1:{port}"
        connection = Connection(url, find_credential(url), requests=1)
        plane = connection.data(url)
        connection.contact.has_answered = True
    with connection, listening("127.0.0.1", port) as other:
        send = connection.control.describe_service
        with pytest.raises(ProctorError) as refused:
            plane.http_connection.send_request(b"GET") if is_turn else send()
        assert refused.value.code == NOT_TRUSTED
        accepted, _ = other.accept()
        with accepted:
            assert accepted.recv(1) == b""
