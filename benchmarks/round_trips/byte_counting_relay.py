"""A TCP relay that counts the bytes between a client and a server.

Counts the payload of TCP, including HTTP heads, frames and TLS or WebSocket handshakes,
without packet headers. Knows no protocol.
"""

from __future__ import annotations

import contextlib
import socket
import threading
from typing import NamedTuple, Self

_CHUNK_BYTES = 2**18


class ByteCounts(NamedTuple):
    """Bytes from the client to the server, and from the server to the client."""

    up: int
    down: int


class Relay:
    """address: what a client takes for the server's, scheme and all."""

    def __init__(self, address: str) -> None:
        scheme, _, place = address.rpartition("//")
        host, _, port = place.partition(":")
        self._upstream = host, int(port)
        self._listener = socket.create_server(("127.0.0.1", 0))
        own = f"127.0.0.1:{self._listener.getsockname()[1]}"
        self.address = f"{scheme}//{own}" if scheme else own
        self._counts = {"up": 0, "down": 0}
        self._threads = [threading.Thread(target=self._accept, daemon=True)]

    def byte_counts(self) -> ByteCounts:
        """So far. A byte counts before it is sent on."""
        return ByteCounts(**self._counts)

    def __enter__(self) -> Self:
        self._threads[0].start()
        return self

    def __exit__(self, kind: object, *_: object) -> None:
        """Waits for both ends to be gone, unless something failed."""
        self._listener.shutdown(socket.SHUT_RDWR)
        self._threads.pop(0).join()
        self._listener.close()
        for thread in self._threads if kind is None else ():
            thread.join()

    def _accept(self) -> None:
        with contextlib.suppress(OSError):
            while True:
                client, _ = self._listener.accept()
                server = socket.create_connection(self._upstream)
                for ends in ((client, server, "up"), (server, client, "down")):
                    ends[0].setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
                    carrier = threading.Thread(
                        target=self._carry, args=ends, daemon=True
                    )
                    self._threads.append(carrier)
                    carrier.start()

    def _carry(self, source: socket.socket, sink: socket.socket, way: str) -> None:
        """Until the source ends; each thread closes what it reads from."""
        with contextlib.suppress(OSError), source:
            while data := source.recv(_CHUNK_BYTES):
                self._counts[way] += len(data)
                sink.sendall(data)
            sink.shutdown(socket.SHUT_WR)
