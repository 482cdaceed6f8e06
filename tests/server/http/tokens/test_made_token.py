"""The token that a server makes: its entry, and the address at which it is used."""

import socket
from pathlib import Path

import pytest

from reference_server.__main__ import _publish, _startup_message
from reference_server.settings import Settings


@pytest.mark.parametrize("is_own", [True, False])
def test_an_entry_that_cannot_be_made_is_one_line(
    is_own: bool,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """Expect the place, its fault and both ways out; and nothing of a server that was
    given its tokens, for which no client looks there."""
    taken = tmp_path / "taken"
    taken.write_text("")
    monkeypatch.setenv("XDG_STATE_HOME", str(taken))
    token = tmp_path / "a b.token"
    with socket.create_server(("127.0.0.1", 0)) as listener:
        _publish(listener, token if is_own else None, is_own=is_own)
        name = f"{socket.gethostname()}/127.0.0.1-{listener.getsockname()[1]}"
    entry = taken / "proctor" / "servers" / name
    expected = (
        f"proctor: {entry} cannot be written (Not a directory); "
        f"export PROCTOR_TOKEN=$(cat '{token}') for clients here, or name a folder for "
        "both with XDG_STATE_HOME\n"
    )
    assert capsys.readouterr().err == (expected if is_own else "")


@pytest.mark.parametrize("is_own", [True, False])
def test_an_account_without_a_home_is_no_failure(
    is_own: bool, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def no_home() -> Path:
        raise RuntimeError

    monkeypatch.setattr(Path, "home", no_home)
    monkeypatch.delenv("XDG_STATE_HOME", raising=False)
    with socket.create_server(("127.0.0.1", 0)) as listener:
        _publish(listener, None, is_own=is_own)
    assert ("XDG_STATE_HOME" in capsys.readouterr().err) == is_own


@pytest.mark.parametrize(
    ("host", "here"),
    [
        ("0.0.0.0", "http://127.0.0.1:8460"),  # noqa: S104
        ("::", "http://[::1]:8460"),
        ("127.0.0.1", None),
        ("10.0.0.7", None),
    ],
)
def test_every_address_is_none_for_clients(
    host: str, here: str | None, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Expect the name of the machine, and commands with an address that works here."""
    monkeypatch.setattr("socket.gethostname", lambda: "node03")
    settings = Settings(host=host, database="p.sqlite", pages="on", tokens="a:t" * 9)
    lines = _startup_message(settings, 8460, "secret", shows_token=True).splitlines()
    listening = lines[0].removeprefix("Proctor listens at ")
    others = lines[1:3] == ["from other machines:", "http://node03:8460"]
    assert others == (here is not None)
    used = [line for line in lines[3:] if "://" in line]
    assert len(used) == 3
    assert all((here or listening) in line for line in used)
