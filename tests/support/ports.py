"""Ports of this machine that servers of tests may use."""

import socket


def free_port() -> int:
    """Give a port that is free now; nothing keeps it so."""
    with socket.create_server(("127.0.0.1", 0)) as listener:
        port: int = listener.getsockname()[1]
        return port
