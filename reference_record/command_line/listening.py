"""The socket that a program serves on, bound before it says so."""

from __future__ import annotations

import errno
import socket


class CannotListen(Exception):
    """The address is in use, or is none of this machine; the text is for people."""


def bind(host: str, port: int, option: str = "--port") -> socket.socket:
    """A socket that listens there. Raises CannotListen, which names the option."""
    family = socket.AF_INET6 if ":" in host else socket.AF_INET
    # asyncio sets TCP_NODELAY only if the protocol is given; without it each response
    # waits 40 ms for an acknowledgement.
    listener = socket.socket(family, socket.SOCK_STREAM, socket.IPPROTO_TCP)
    listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    try:
        listener.bind((host, port))
        # Two sockets may be bound to one port until one of them listens.
        listener.listen()
    except OSError as error:
        listener.close()
        raise CannotListen(
            f"cannot listen on {host}:{port} ({error.strerror}); "
            f"{_way_out(error, option)}"
        ) from error
    return listener


def _way_out(error: OSError, option: str) -> str:
    if error.errno == errno.EADDRINUSE:
        return f"end the server that is there, or choose another port with {option}"
    if error.errno in (errno.EACCES, errno.EPERM):
        return f"choose a port that this user may listen on with {option}"
    option = option.replace("port", "host")
    return f"name an address of this machine, such as 127.0.0.1, with {option}"
