"""The folders in which programs of this project keep small files of a user.

They follow the XDG Base Directory Specification, which lets a variable name another
place and gives a relative path in it no meaning. Both raise RuntimeError where there is
no home directory either.
"""

from __future__ import annotations

import os
from pathlib import Path


def state_folder() -> Path:
    """Keys of servers, links to tokens, checkpoints: what a program finds again."""
    return _folder("XDG_STATE_HOME", ".local/state")


def config_folder() -> Path:
    """The key with which this user signs."""
    return _folder("XDG_CONFIG_HOME", ".config")


def _folder(variable: str, below_home: str) -> Path:
    named = Path(os.environ.get(variable, ""))
    if named.is_absolute():
        return named / "proctor"
    try:
        return Path.home() / below_home / "proctor"
    except RuntimeError as error:
        text = f"this account has no home directory; {variable} names another folder"
        raise RuntimeError(text) from error
