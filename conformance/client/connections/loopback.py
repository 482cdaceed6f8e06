"""The loopback address of servers of the kit: a machine may have no IPv4."""

import functools
import socket


@functools.cache
def loopback() -> str:
    """Give 127.0.0.1, or ::1 on a machine without it."""
    with socket.socket() as probe:
        try:
            probe.bind(("127.0.0.1", 0))
        except OSError:
            return "::1"
    return "127.0.0.1"


def in_url(host: str) -> str:
    """Write a host as a URL has it: an address of IPv6 in brackets."""
    return f"[{host}]" if ":" in host else host


def probing_socket() -> socket.socket:
    """Open a socket for the loopback address."""
    return socket.socket(socket.AF_INET6 if ":" in loopback() else socket.AF_INET)
