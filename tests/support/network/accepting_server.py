"""A server whose test chooses each byte: a function talks to each connection."""

from __future__ import annotations

import contextlib
import socket
import threading
from collections.abc import Callable


class AcceptingServer:
    """A server at `url`, the free port `port`, from its construction until `close`.

    converse: is called with each connection, in a thread of its own, and may raise
    OSError; the connection is closed then. connections: how many were made.
    """

    def __init__(self, converse: Callable[[socket.socket], object]) -> None:
        self._converse = converse
        self.connections = 0
        self._listener = socket.create_server(("127.0.0.1", 0))
        self.port: int = self._listener.getsockname()[1]
        self.url = f"http://127.0.0.1:{self.port}"
        threading.Thread(target=self._accept, daemon=True).start()

    def _accept(self) -> None:
        with contextlib.suppress(OSError):
            while True:
                connection, _ = self._listener.accept()
                self.connections += 1
                serve = threading.Thread(
                    target=self._serve, args=[connection], daemon=True
                )
                serve.start()

    def _serve(self, connection: socket.socket) -> None:
        with connection, contextlib.suppress(OSError):
            self._converse(connection)

    def close(self) -> None:
        """Take no further connection."""
        with contextlib.suppress(OSError):
            self._listener.shutdown(socket.SHUT_RDWR)
        self._listener.close()
