"""A small HTTP client on a socket: sends any bytes and reads one answer at a time.

Small so that it costs the machine less than the server it attacks. It knows statuses,
Content-Length and problem codes, and no rule.
"""

from __future__ import annotations

import contextlib
import json
import re
import socket
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Self
from urllib.parse import urlsplit

JSON = "application/json"
_CODE = re.compile(rb'"code":\s*"([a-z_]+)"')
_LENGTH = re.compile(rb"\r\ncontent-length:\s*(\d+)", re.IGNORECASE)


class NoAnswer(Exception):
    """Nothing came in time: a hang, where an answer was due."""


@dataclass(frozen=True)
class Answer:
    status: int
    head: bytes
    body: bytes

    @property
    def code(self) -> str:
        """The code of a problem, or empty."""
        found = _CODE.search(self.body[:4096]) if self.status >= 400 else None
        return found[1].decode() if found else ""

    def json(self) -> Any:
        return json.loads(self.body)


class RawClient:
    """One connection at a time, opened when it is needed and again when it was closed.

    source: the address of this side, so that clients count as several.
    """

    def __init__(
        self, url: str, token: str, *, timeout_s: float = 10.0, source: str = ""
    ) -> None:
        parts = urlsplit(url)
        assert parts.hostname is not None
        assert parts.port is not None
        self._address = (parts.hostname, parts.port)
        self._host = parts.netloc
        self._token = token
        self._timeout_s = timeout_s
        self._source = (source, 0) if source else None
        self._socket: socket.socket | None = None
        self._unread = b""

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def connect(self) -> socket.socket:
        """A connection that the caller may use as it is; raises OSError."""
        if self._socket is None:
            self._unread = b""
            self._socket = socket.create_connection(
                self._address, self._timeout_s, self._source
            )
            self._socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        return self._socket

    def close(self) -> None:
        if self._socket is not None:
            self._socket.close()
            self._socket = None

    def head(self, method: str, path: str, headers: Mapping[str, str]) -> bytes:
        lines = {"Host": self._host, "Authorization": f"Bearer {self._token}"}
        lines |= headers
        text = "".join(f"{name}: {value}\r\n" for name, value in lines.items())
        return f"{method} {path} HTTP/1.1\r\n{text}\r\n".encode("latin-1", "replace")

    def request(
        self,
        method: str,
        path: str,
        body: bytes | dict[str, Any] | None = None,
        content_type: str = JSON,
        **headers: str,
    ) -> Answer:
        """Send and read the answer. Raises NoAnswer, and OSError when it was closed.

        headers: names with _ for -.
        """
        return self.exchange(self.encode(method, path, body, content_type, **headers))

    def encode(
        self,
        method: str,
        path: str,
        body: bytes | dict[str, Any] | None = None,
        content_type: str = JSON,
        **headers: str,
    ) -> bytes:
        """One request, as it is sent."""
        data = json.dumps(body).encode() if isinstance(body, dict) else body
        lines = {name.replace("_", "-"): value for name, value in headers.items()}
        if data is not None:
            lines |= {"Content-Type": content_type, "Content-Length": str(len(data))}
        return self.head(method, path, lines) + (data or b"")

    def exchange(self, sent: bytes) -> Answer:
        """Send bytes that are one request, and read its answer; raises as `request`."""
        is_new = self._socket is None
        try:
            return self._exchange(sent)
        except OSError:
            if is_new:
                raise
        # The server may have closed a connection that was idle.
        return self._exchange(sent)

    def _exchange(self, sent: bytes) -> Answer:
        try:
            connection = self.connect()
            # It may answer and hang up before all is read.
            with contextlib.suppress(BrokenPipeError, ConnectionResetError):
                connection.sendall(sent)
            return self.read_answer()
        except TimeoutError as error:
            self.close()
            raise NoAnswer from error
        except OSError:
            self.close()
            raise

    def read_answer(self) -> Answer:
        """The next answer of this connection; raises OSError."""
        connection = self.connect()
        while (end := self._unread.find(b"\r\n\r\n")) < 0:
            self._unread += self._receive(connection)
        head, self._unread = self._unread[: end + 2], self._unread[end + 4 :]
        length = _LENGTH.search(head)
        size = int(length[1]) if length else 0
        parts = [self._unread]
        missing = size - len(self._unread)
        while missing > 0:
            parts.append(self._receive(connection))
            missing -= len(parts[-1])
        whole = b"".join(parts)
        body, self._unread = whole[:size], whole[size:]
        if b"\r\nconnection: close" in head.lower():
            self.close()
        return Answer(int(head.split(b" ", 2)[1]), head, body)

    def _receive(self, connection: socket.socket) -> bytes:
        part = connection.recv(2**18)
        if not part:
            raise ConnectionResetError("the server hung up")
        return part


def try_request(client: RawClient, *arguments: Any, **options: Any) -> Answer | None:
    """An answer, or None where the server closed the connection without one.

    Raises NoAnswer.
    """
    try:
        return client.request(*arguments, **options)
    except OSError:
        return None
