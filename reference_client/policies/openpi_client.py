"""A client of openpi's protocol: a WebSocket, one frame per request and response.

The server's first frame is metadata. A text frame is the traceback of an error. The
protocol has no reset, sequence number or session: a request contains all state, so a
lost one is sent again on a new connection.
"""

from __future__ import annotations

import contextlib
import os
import time
import weakref
from collections.abc import Callable, Mapping
from typing import Any, Self, TypeVar

from websockets.exceptions import InvalidURI, WebSocketException
from websockets.sync.client import ClientConnection, connect

from reference_client.errors import POLICY_FAILED, ProctorError, innermost_reason
from reference_client.policies.ndarray import BadMessage, pack, unpack

PAUSE_S = 0.2
OPEN_S = 5.0
CLOSE_S = 1.0  # a server that computes does not answer a close frame
FIRST_CONTACT_S = 3.0  # a mistyped URL is reported before the run is created

Answer = TypeVar("Answer")


class OpenpiClient:
    """The server at `url`, ws:// or wss://; connects at the first request.

    OPENPI_API_KEY of the environment is sent as its API key. retry_timeout_s: how long
    an unreachable server is retried. There is no timeout for a response: the first may
    take minutes, while the network is compiled.
    """

    def __init__(self, url: str, *, retry_timeout_s: float = 60.0) -> None:
        self._url = url
        self._retry_timeout_s = retry_timeout_s
        self._socket: ClientConnection | None = None
        self._connection_stack = contextlib.ExitStack()
        self._is_closed = False
        # Also where nothing calls `close`, at the latest at the end of the program.
        weakref.finalize(self, self._connection_stack.close)
        self.metadata: Any = None

    @classmethod
    def connect_to(cls, url: str) -> Self:
        """Connected. Raises ProctorError `policy_failed` if no server is there."""
        server = cls(url)
        server._retry(server._ensure_connected, FIRST_CONTACT_S)
        return server

    def infer(self, request: Mapping[str, Any]) -> Any:
        """Raises ProctorError `policy_failed`, with the last line of its traceback."""
        frame = pack(request)

        def exchange() -> str | bytes:
            socket = self._ensure_connected()
            socket.send(frame)
            return socket.recv()

        return self._read(self._retry(exchange, self._retry_timeout_s))

    def close(self) -> None:
        """Leave with a close frame; a request in progress fails."""
        self._is_closed = True
        self._drop()

    def _retry(self, attempt: Callable[[], Answer], retry_timeout_s: float) -> Answer:
        deadline = time.monotonic() + retry_timeout_s
        while True:
            try:
                return attempt()
            except InvalidURI as error:
                raise self._failed(f"has an invalid WebSocket URL: {error}") from error
            except (OSError, WebSocketException) as error:
                self._drop()
                if self._is_closed:
                    raise self._failed("was left") from error
                if time.monotonic() > deadline:
                    raise self._failed(
                        f"is unreachable ({innermost_reason(error)})"
                    ) from error
                time.sleep(PAUSE_S)

    def _ensure_connected(self) -> ClientConnection:
        if self._socket is None:
            key = os.environ.get("OPENPI_API_KEY")
            connecting = connect(
                self._url,
                compression=None,
                max_size=None,
                open_timeout=OPEN_S,
                close_timeout=CLOSE_S,
                # openpi's server computes in the event loop that would answer pings.
                ping_interval=None,
                additional_headers={"Authorization": f"Api-Key {key}"} if key else None,
                proxy=None,
            )
            self._socket = self._connection_stack.enter_context(connecting)
            self.metadata = self._read(self._socket.recv())
        return self._socket

    def _read(self, frame: str | bytes) -> Any:
        if isinstance(frame, str):
            self._drop()  # the server closes the connection after an error
            last = frame.strip().rpartition("\n")[2]
            raise self._failed(f"failed: {last}")
        try:
            return unpack(frame)
        except BadMessage as error:
            self._drop()
            raise self._failed(f"sent a frame that {error}") from error

    def _drop(self) -> None:
        self._socket = None
        self._connection_stack.close()

    def _failed(self, what: str) -> ProctorError:
        return ProctorError(POLICY_FAILED, f"The policy server at {self._url} {what}.")
