"""Which token a request carries: the one given, the environment's, or one in a file.

`proctor login` saves the key of a server in a file that only this user may read.

A server that was given no tokens makes one, keeps it in a file, and names the file by
its port in the folder of state of the account that runs it. Only that account can read
it; other programs on the machine find nothing. This module sends nothing.
"""

from __future__ import annotations

import hashlib
import os
from ipaddress import ip_address
from pathlib import Path
from urllib.parse import urlsplit

_TOKEN_BYTES_MAX = 4096


def find_token(url: str, given: str | None = None) -> str | None:
    """The token given, or PROCTOR_TOKEN, or a saved key, or that of a local server.

    Raises BadToken, a ValueError, for one that cannot be sent.
    """
    # Imported late: completion at a Tab imports this module, and often ends here.
    from proctor_client.transport.copied_text import read_token, token_of

    return (
        read_token(given or "", "this call (`token`)")
        or token_of("PROCTOR_TOKEN")
        or _saved_key(url)
        or _token_of_local_server(url)
    )


def token_file(url: str) -> Path | None:
    """The file in which a server of this account at a loopback URL keeps its token."""
    try:
        path = _path(url)
        return path.resolve() if path is not None and _read(path) else None
    except (OSError, RuntimeError, ValueError):  # no home, no file, no such URL
        return None


def saved_key_file(url: str) -> Path:
    """Where `proctor login` keeps the key for the server at a URL."""
    name = hashlib.sha256(url.rstrip("/").encode()).hexdigest()[:32]
    return _state_folder() / "keys" / name


def _saved_key(url: str) -> str | None:
    try:
        return _read(saved_key_file(url))
    except (OSError, RuntimeError, ValueError):  # as in token_file
        return None


def _state_folder() -> Path:
    state = os.environ.get("XDG_STATE_HOME")
    return (Path(state) if state else Path.home() / ".local" / "state") / "proctor"


def _token_of_local_server(url: str) -> str | None:
    try:
        path = _path(url)
        return None if path is None else _read(path)
    except (OSError, RuntimeError, ValueError):  # as in token_file
        return None


def _path(url: str) -> Path | None:
    parts = urlsplit(url)
    port = parts.port or 80
    if parts.scheme != "http" or not _is_loopback(parts.hostname or ""):
        return None
    return _state_folder() / "tokens" / str(port)


def _is_loopback(host: str) -> bool:
    return host == "localhost" or ip_address(host).is_loopback


def _read(path: Path) -> str | None:
    """The token in the file; None if another account could have read or written it."""
    with path.open("rb") as file:
        status = os.fstat(file.fileno())
        if status.st_uid != os.getuid() or status.st_mode & 0o077:
            return None
        return file.read(_TOKEN_BYTES_MAX).decode("ascii").strip() or None
