"""The address `unix:PATH` of a program that the server does not start.

A command with one word of this form names a socket at which the program listens.
"""

from __future__ import annotations

import os
import socket
from collections.abc import Sequence
from pathlib import Path

_PREFIX = "unix:"
_PATH_BYTES_MAX = 103  # of macOS; Linux allows four more


def is_socket(command: Sequence[str]) -> bool:
    """Whether the command is the address of a program that is started elsewhere."""
    return command[0].startswith(_PREFIX)


def resolve(command: Sequence[str], folder: Path) -> list[str]:
    """The address with its whole path. Raises ValueError if it is wrong."""
    path = command[0].removeprefix(_PREFIX)
    if not path or len(command) > 1:
        raise ValueError(f"{' '.join(command)}: write {_PREFIX}PATH and nothing behind")
    whole = str(folder / path)
    if len(os.fsencode(whole)) > _PATH_BYTES_MAX:
        raise ValueError(f"the path of a socket has at most {_PATH_BYTES_MAX} bytes")
    return [f"{_PREFIX}{whole}"]


def connect(command: Sequence[str]) -> socket.socket:
    """A connection to the program, which blocks. Raises OSError."""
    connection = socket.socket(socket.AF_UNIX)
    try:
        connection.setblocking(False)  # a full queue of the listener refuses at once
        connection.connect(command[0].removeprefix(_PREFIX))
        connection.setblocking(True)
    except BaseException:
        connection.close()
        raise
    return connection
