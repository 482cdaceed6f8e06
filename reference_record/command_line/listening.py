"""The socket that a program serves on, bound before it says so."""

from __future__ import annotations

import socket


class CannotListen(Exception):
    """The address is in use, or is none of this machine; the text is for people."""


def bind(host: str, port: int, option: str = "--port") -> socket.socket:
    """A socket bound there. Raises CannotListen, which names the option."""
    family = socket.AF_INET6 if ":" in host else socket.AF_INET
    # asyncio sets TCP_NODELAY only if the protocol is given; without it each response
    # waits 40 ms for an acknowledgement.
    listener = socket.socket(family, socket.SOCK_STREAM, socket.IPPROTO_TCP)
    listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    try:
        listener.bind((host, port))
    except OSError as error:
        listener.close()
        raise CannotListen(
            f"cannot listen on {host}:{port} ({error.strerror}); end the server that "
            f"is there, or choose another port with {option}"
        ) from error
    return listener
