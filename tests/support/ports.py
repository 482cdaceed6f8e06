"""Ports of this machine that servers of tests may use."""

import socket
from collections.abc import Iterator
from contextlib import contextmanager


def free_port() -> int:
    """Give a port that is free now; nothing keeps it so."""
    with socket.create_server(("127.0.0.1", 0)) as listener:
        port: int = listener.getsockname()[1]
        return port


@contextmanager
def closed_port() -> Iterator[int]:
    """A port of this machine that refuses every connection."""
    with socket.socket() as bound:
        bound.bind(("127.0.0.1", 0))
        yield int(bound.getsockname()[1])
