"""Connections that read past interim answers, which http.client takes for the answer.

Generated from spec/openapi.yaml by `make generate`; never edited by hand.
A server or a gateway may send any number of answers such as 103 before the answer.
"""

from __future__ import annotations

from http.client import HTTPException, HTTPResponse

import urllib3
from urllib3.connection import HTTPConnection, HTTPSConnection

_INTERIM_MAX = 100
_UPGRADED = 101


class _FinalResponse(HTTPResponse):
    """The first answer that is not an interim one."""

    def begin(self) -> None:
        for _ in range(_INTERIM_MAX):
            super().begin()
            if not 100 <= self.status < 200 or self.status == _UPGRADED:
                return
            self.headers = None  # type: ignore[assignment] # begin() reads once only
        raise HTTPException(f"more than {_INTERIM_MAX} interim answers")


class _HttpConnection(HTTPConnection):
    response_class = _FinalResponse


class _HttpsConnection(HTTPSConnection):
    response_class = _FinalResponse


class _HttpPool(urllib3.HTTPConnectionPool):
    ConnectionCls = _HttpConnection


class _HttpsPool(urllib3.HTTPSConnectionPool):
    ConnectionCls = _HttpsConnection


def past_interim_answers(manager: urllib3.PoolManager) -> urllib3.PoolManager:
    """The same manager; its connections read past interim answers."""
    manager.pool_classes_by_scheme = {"http": _HttpPool, "https": _HttpsPool}
    return manager
