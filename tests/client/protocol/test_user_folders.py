"""Small files of a user are where a variable says, or below the home directory."""

from collections.abc import Callable
from pathlib import Path

import pytest

from reference_record.formats.user_folders import config_folder, state_folder


@pytest.mark.parametrize(
    ("folder", "variable", "place"),
    [
        (state_folder, "XDG_STATE_HOME=/scratch/x", "/scratch/x/proctor"),
        (state_folder, "XDG_STATE_HOME=", "/home/ada/.local/state/proctor"),
        (state_folder, "XDG_STATE_HOME=relative", "/home/ada/.local/state/proctor"),
        (config_folder, "XDG_CONFIG_HOME=/scratch/x", "/scratch/x/proctor"),
        (config_folder, "XDG_CONFIG_HOME=", "/home/ada/.config/proctor"),
        (config_folder, "XDG_CONFIG_HOME=relative", "/home/ada/.config/proctor"),
    ],
)
def test_an_absolute_path_of_the_variable_names_the_folder(
    folder: Callable[[], Path],
    variable: str,
    place: str,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setenv(*variable.split("="))
    monkeypatch.setenv("HOME", "/home/ada")
    assert folder() == Path(place)


def no_home() -> Path:
    raise RuntimeError("Could not determine home directory.")


def test_an_account_without_a_home_is_shown_the_variable(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(Path, "home", no_home)
    monkeypatch.delenv("XDG_STATE_HOME", raising=False)
    with pytest.raises(RuntimeError, match="XDG_STATE_HOME names another folder"):
        state_folder()
