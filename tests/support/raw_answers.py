"""HTTP answers read from a plain socket, for tests that choose each byte they send."""

import contextlib
import socket


def read_to_end(connection: socket.socket) -> bytes:
    """Read all until the server hangs up; a reset is an end, too."""
    parts = []
    with contextlib.suppress(ConnectionError):
        while part := connection.recv(2**16):
            parts.append(part)
    return b"".join(parts)


def read_answer(connection: socket.socket) -> tuple[int, bytes]:
    """Read status and body of one answer with a Content-Length, and not the next."""
    head = b""
    while not head.endswith(b"\r\n\r\n"):
        part = connection.recv(1)
        assert part, f"the server hung up after {head!r}"
        head += part
    left = int(head.lower().partition(b"content-length:")[2].split()[0])
    body = b""
    while len(body) < left:
        part = connection.recv(left - len(body))
        assert part, f"the server hung up after {len(body)} of {left} bytes"
        body += part
    return int(head.split()[1]), body
