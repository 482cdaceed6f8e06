"""Connections that know the answers which are not those of the server.

Interim answers, which http.client takes for the answer, are read past; what a proxy
answers to the request for a tunnel is a ProxyFault. A head that breaks off, which
http.client takes for a whole one, is a lost answer.

Written by hand, beside what is generated from the specification.
A server or a gateway may send any number of answers such as 103 before the answer.
"""

from __future__ import annotations

import contextlib
from http.client import (
    HTTPException,
    HTTPResponse,
    RemoteDisconnected,
    parse_headers,
)
from typing import Any, BinaryIO

import urllib3
from urllib3.connection import HTTPConnection, HTTPSConnection

from .transport.proxy_route import ProxyFault

_INTERIM_MAX = 100
_UPGRADED = 101


class _HeadLines:
    """The lines of a head. Raises RemoteDisconnected where the stream ends in it."""

    def __init__(self, stream: BinaryIO) -> None:
        self._stream = stream
        self.close = stream.close

    def readline(self, most: int) -> bytes:
        line = self._stream.readline(most)
        if line.endswith(b"\n") or len(line) == most:
            return line
        raise RemoteDisconnected("the connection ended before the head was whole")


class _WholeHeadResponse(HTTPResponse):
    """An answer whose head has arrived to its empty line."""

    def begin(self) -> None:
        stream = self.fp
        lines: Any = _HeadLines(stream)
        self.fp = lines
        try:
            super().begin()
        finally:
            if self.fp is lines:  # it is not where the connection was closed
                self.fp = stream


class FinalResponse(_WholeHeadResponse):
    """The first answer that is not an interim one."""

    def begin(self) -> None:
        for _ in range(_INTERIM_MAX):
            super().begin()
            if not 100 <= self.status < 200 or self.status == _UPGRADED:
                return
            self.headers = None  # type: ignore[assignment] # begin() reads once only
        raise HTTPException(f"more than {_INTERIM_MAX} interim answers")


class _AnswerOfProxy(HTTPResponse):
    """The answer to the request for a tunnel. Raises ProxyFault for a refusal."""

    def _read_status(self) -> tuple[str, int, str]:
        version, status, phrase = super()._read_status()  # type: ignore[misc]
        if status == 200:
            return version, status, phrase
        challenges = []
        with contextlib.suppress(OSError, HTTPException):
            challenges = parse_headers(self.fp).get_all("Proxy-Authenticate", [])
        raise ProxyFault(f"{status} {phrase}".strip(), status, challenges)


class HttpConnection(HTTPConnection):
    response_class = FinalResponse


class HttpsConnection(HTTPSConnection):
    """A connection with TLS: to a server, or to a proxy.

    Raises ProxyFault where the proxy is at fault, and no request reached the server.
    """

    response_class: type[HTTPResponse] = FinalResponse

    def connect(self) -> None:
        try:
            super().connect()
        except ProxyFault:
            raise
        except OSError as error:
            if self.proxy is None or self.has_connected_to_proxy:
                raise
            raise _silence(error) from error

    def _tunnel(self) -> None:
        self.response_class = _AnswerOfProxy
        try:
            super()._tunnel()
        except ProxyFault:
            raise
        except (OSError, HTTPException) as error:
            raise _silence(error) from error
        finally:
            del self.response_class  # that of the class again


def _silence(error: Exception) -> ProxyFault:
    """The fault of a proxy that gave no answer."""
    if isinstance(error, TimeoutError):
        return ProxyFault("it did not answer in time")
    return ProxyFault(str(error) or "it ended the connection")


class _HttpPool(urllib3.HTTPConnectionPool):
    ConnectionCls = HttpConnection


class _HttpsPool(urllib3.HTTPSConnectionPool):
    ConnectionCls = HttpsConnection


def past_interim_answers(manager: urllib3.PoolManager) -> urllib3.PoolManager:
    """The same manager; its connections read past interim answers."""
    manager.pool_classes_by_scheme = {"http": _HttpPool, "https": _HttpsPool}
    return manager
