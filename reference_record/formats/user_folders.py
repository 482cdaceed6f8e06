"""The folders in which programs of this project keep small files of a user.

They follow the XDG Base Directory Specification, which lets a variable name another
place and gives a relative path in it no meaning. Both raise RuntimeError where there is
no home directory either.
"""

from __future__ import annotations

import contextlib
import hashlib
import os
import socket
from ipaddress import ip_address
from pathlib import Path
from urllib.parse import urlsplit


def state_folder() -> Path:
    """Keys of servers, links to tokens, checkpoints: what a program finds again."""
    return _folder("XDG_STATE_HOME", ".local/state")


def config_folder() -> Path:
    """The key with which this user signs."""
    return _folder("XDG_CONFIG_HOME", ".config")


def name_of_url(url: str) -> str:
    """The name of a file about the server at a URL.

    It differs by machine where the URL is of each machine itself, since several may
    share a home.
    """
    text = url.rstrip("/")
    with contextlib.suppress(ValueError):  # a name, or no URL
        host = urlsplit(url).hostname or ""
        if host == "localhost" or ip_address(host).is_loopback:
            text = f"{socket.gethostname()} {text}"
    return _hashed(text)


def former_name_of_url(url: str) -> str:
    """The name that such a file had before names differed by machine."""
    return _hashed(url.rstrip("/"))


def _hashed(text: str) -> str:
    return hashlib.sha256(text.encode()).hexdigest()[:32]


def _folder(variable: str, below_home: str) -> Path:
    named = Path(os.environ.get(variable, ""))
    if named.is_absolute():
        return named / "proctor"
    try:
        return Path.home() / below_home / "proctor"
    except RuntimeError as error:
        text = f"this account has no home directory; {variable} names another folder"
        raise RuntimeError(text) from error
