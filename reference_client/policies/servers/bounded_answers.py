"""Answers over HTTP that are bounded as a whole: in time and in bytes.

A limit of urllib3 is one for each read, so a server that sends a byte now and then is
never late.
"""

from __future__ import annotations

import contextlib
import io
import socket
import time
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import urllib3
from proctor_client.interim_answers import (
    FinalResponse,
    HttpConnection,
    HttpsConnection,
)

from reference_client.policies.servers.wire_settings import (
    ANSWER_BYTES_MAX,
    KEEPALIVE,
)

_PIECE_BYTES = 1 << 20


class AnswerTooLong(Exception):
    """An answer has more than ANSWER_BYTES_MAX bytes; the text says what it did."""

    def __init__(self) -> None:
        super().__init__(f"sends an answer of more than {ANSWER_BYTES_MAX} bytes")


@dataclass(frozen=True, slots=True)
class HttpAnswer:
    """A complete answer."""

    status: int
    reason: str
    headers: Mapping[str, str]
    data: bytes

    @property
    def media_type(self) -> str | None:
        return self.headers.get("Content-Type")


def with_whole_limits(manager: urllib3.PoolManager) -> urllib3.PoolManager:
    """The same manager; its limit for a read is one for the whole answer."""
    options = [*HttpConnection.default_socket_options, *KEEPALIVE]
    manager.connection_pool_kw["socket_options"] = options
    manager.pool_classes_by_scheme = {"http": _HttpPool, "https": _HttpsPool}
    return manager


def read_whole(response: urllib3.BaseHTTPResponse) -> HttpAnswer:
    """Reads to the end; raises AnswerTooLong, and what urllib3 raises."""
    data = bytearray()
    with contextlib.closing(response):
        for piece in response.stream(_PIECE_BYTES):
            data += piece
            if len(data) > ANSWER_BYTES_MAX:
                raise AnswerTooLong
    return HttpAnswer(
        response.status, response.reason or "", response.headers, bytes(data)
    )


class _LimitedReader(io.RawIOBase):
    """Reads from a socket until the time is over that it gives to one read."""

    def __init__(self, sock: socket.socket, raw: io.RawIOBase) -> None:
        self._sock, self._raw = sock, raw
        limit_s = sock.gettimeout()
        self._until = None if limit_s is None else time.monotonic() + limit_s

    def readable(self) -> bool:
        return True

    def readinto(self, buffer: Any) -> int | None:
        if self._until is not None:
            left_s = self._until - time.monotonic()
            if left_s <= 0:
                raise TimeoutError("timed out")
            self._sock.settimeout(left_s)
        return self._raw.readinto(buffer)

    def close(self) -> None:
        self._raw.close()
        super().close()


class _LimitedResponse(FinalResponse):
    def __init__(self, sock: socket.socket, *args: Any, **options: Any) -> None:
        super().__init__(sock, *args, **options)
        self.fp = io.BufferedReader(_LimitedReader(sock, self.fp.detach()))


class _HttpConnection(HttpConnection):
    response_class = _LimitedResponse


class _HttpsConnection(HttpsConnection):
    response_class = _LimitedResponse


class _HttpPool(urllib3.HTTPConnectionPool):
    ConnectionCls = _HttpConnection


class _HttpsPool(urllib3.HTTPSConnectionPool):
    ConnectionCls = _HttpsConnection
