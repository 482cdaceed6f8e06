"""`proctor login`: a key that cannot be kept is not made, or is named as valid."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from reference_client.command import signing_in
from reference_client.command.output.printer import Printer
from reference_client.command.signing_in import DeviceKey, login
from reference_client.command.usage_error import UsageError
from reference_client.errors import ProctorError
from reference_record.command_line.click_commands import WrongUsage

URL = "http://127.0.0.1:8000"
ARGS: Any = SimpleNamespace(url=URL, forget=False, ca=None)


@pytest.fixture
def confirmed(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> list[str]:
    """The codes that a person was shown, who confirms at once; no key is kept yet."""
    asked: list[str] = []

    @contextmanager
    def connect(*_: Any, **__: Any) -> Iterator[tuple[Any, Any]]:
        yield SimpleNamespace(url=URL), None

    def log_in(*_: Any) -> DeviceKey:
        asked.append("a code")
        return DeviceKey(access_token="k", account="ada", expires_in=86_400)

    monkeypatch.setattr(signing_in, "connect", connect)
    monkeypatch.setattr(signing_in, "require_accounts", lambda *_: None)
    monkeypatch.setattr(signing_in, "log_in", log_in)
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    return asked


def test_a_place_that_cannot_be_written_is_found_before_the_code_is_shown(
    confirmed: list[str], tmp_path: Path
) -> None:
    (tmp_path / "state").write_text("a file in place of the folder")
    refusal = r"/keys cannot be written \(.*\); XDG_STATE_HOME names another place"
    with pytest.raises(WrongUsage, match=refusal):
        login(ARGS, Printer(as_json=False))
    assert confirmed == []


@pytest.mark.usefixtures("confirmed")
@pytest.mark.parametrize("code", ["forbidden", "not_found", "unavailable"])
def test_a_sign_in_without_a_key_says_how_to_begin_again(
    monkeypatch: pytest.MonkeyPatch, code: str
) -> None:
    def refuse(*_: Any) -> DeviceKey:
        raise ProctorError(code, "There is no key.")

    monkeypatch.setattr(signing_in, "log_in", refuse)
    monkeypatch.setenv("PROCTOR_URL", "http://127.0.0.1:1")
    with pytest.raises(ProctorError) as refused:
        login(ARGS, Printer(as_json=False))
    said = f"There is no key. `proctor login --url {URL}` shows a new code."
    assert (refused.value.code, refused.value.detail) == (code, said)


def test_a_key_that_cannot_be_kept_after_all_is_to_be_revoked(
    confirmed: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    def fill_disk(*_: object) -> Path:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(signing_in, "save_key", fill_disk)
    with pytest.raises(UsageError) as refused:
        login(ARGS, Printer(as_json=False))
    assert confirmed == ["a code"]
    assert "No space left on device" in str(refused.value)
    assert str(refused.value).endswith(f"stays valid: revoke it on {URL}/hosting/keys")
