"""Connects to the socket that a policy made inside its sandbox.

The policy controls its files, and the platform can reach what the policy cannot. So no
link is followed: each folder of the path is opened by itself from the sandbox's root,
the last name must be a socket, and the connection goes to that very file. A policy that
puts a link to a socket of the host there is not connected to anything.
"""

from __future__ import annotations

import os
import socket
import stat
from pathlib import Path, PurePosixPath

from reference_platform.sandbox.sandbox_interface import SOCKET_PATH, NotListening

_FOLDER = os.O_PATH | os.O_DIRECTORY | os.O_NOFOLLOW | os.O_CLOEXEC
_ANY_FILE = os.O_PATH | os.O_NOFOLLOW | os.O_CLOEXEC


def connect_to_policy(process_fd: int, timeout_s: float) -> socket.socket:
    """A connection; process_fd: the folder in /proc of a process of the sandbox.

    That folder belongs to the process, also when its number has been given to another.
    Raises NotListening.
    """
    try:
        file_fd = _open_socket_file(process_fd)
    except OSError as error:
        raise NotListening(f"{SOCKET_PATH}: {error.strerror}") from error
    connection = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
    try:
        connection.settimeout(timeout_s)
        connection.connect(f"/proc/self/fd/{file_fd}")
    except OSError as error:
        connection.close()
        raise NotListening(f"{SOCKET_PATH}: {error.strerror or error}") from error
    finally:
        os.close(file_fd)
    return connection


def _open_socket_file(process_fd: int) -> int:
    # `root` is a link of the kernel to the root of the process.
    folder_fd = os.open("root", os.O_PATH | os.O_DIRECTORY, dir_fd=process_fd)
    try:
        if os.path.samestat(os.fstat(folder_fd), Path("/").stat()):
            # bubblewrap has not yet left the root of the host.
            raise FileNotFoundError(2, "the sandbox is not ready")
        *folders, name = PurePosixPath(SOCKET_PATH).parts[1:]
        for folder in folders:
            inner_fd = os.open(folder, _FOLDER, dir_fd=folder_fd)
            os.close(folder_fd)
            folder_fd = inner_fd
        file_fd = os.open(name, _ANY_FILE, dir_fd=folder_fd)
    finally:
        os.close(folder_fd)
    if not stat.S_ISSOCK(os.fstat(file_fd).st_mode):
        os.close(file_fd)
        raise FileNotFoundError(2, "it is not a socket")
    return file_fd
