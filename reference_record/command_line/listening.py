"""The socket that a program serves on, bound before it says so."""

from __future__ import annotations

import errno
import socket


class CannotListen(Exception):
    """The address is in use, or is none of this machine; the text is for people."""


def bind(host: str, port: int, option: str = "--port") -> socket.socket:
    """A socket that is bound there. Raises CannotListen, which names the option."""
    family = socket.AF_INET6 if ":" in host else socket.AF_INET
    # asyncio sets TCP_NODELAY only if the protocol is given; without it each response
    # waits 40 ms for an acknowledgement.
    listener = socket.socket(family, socket.SOCK_STREAM, socket.IPPROTO_TCP)
    try:
        try:
            listener.bind((host, port))
        except OSError as error:
            if error.errno != errno.EADDRINUSE:
                raise
            # Connections of an earlier server may not be over.
            listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
            listener.bind((host, port))
    except OSError as error:
        listener.close()
        raise _cannot_listen(host, port, error, option) from error
    return listener


def listen(listener: socket.socket, option: str = "--port") -> None:
    """Take in connections, which wait until they are accepted. Raises CannotListen.

    A program that may refuse to start checks everything before.
    """
    try:
        # Its connections inherit that a server that starts later may have the port.
        listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        listener.listen()
    except OSError as error:
        host, port = listener.getsockname()[:2]
        raise _cannot_listen(host, port, error, option) from error


def _cannot_listen(host: str, port: int, error: OSError, option: str) -> CannotListen:
    return CannotListen(
        f"cannot listen on {host}:{port} ({error.strerror}); {_way_out(error, option)}"
    )


def _way_out(error: OSError, option: str) -> str:
    if error.errno == errno.EADDRINUSE:
        return f"end the server that is there, or choose another port with {option}"
    if error.errno in (errno.EACCES, errno.EPERM):
        return f"choose a port that this user may listen on with {option}"
    option = option.replace("port", "host")
    return f"name an address of this machine, such as 127.0.0.1, with {option}"
