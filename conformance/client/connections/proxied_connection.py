"""A connection through the proxy that the environment names; httpx speaks with it.

Has the interface of KeptConnection.
"""

import http.cookiejar
import ssl
from collections.abc import Callable, Iterator
from typing import Any

import httpx

from conformance.client.connections.kept_connection import (
    HttpRequest,
    HttpResponse,
    can_be_stale,
)
from conformance.client.connections.transport.proxy_route import ProxyRoute


class ProxiedConnection:
    """One client of httpx, which keeps its connections; for one thread."""

    def __init__(
        self, certificates: Callable[[], ssl.SSLContext], route: ProxyRoute
    ) -> None:
        no_cookies = http.cookiejar.DefaultCookiePolicy(allowed_domains=[])
        self._client = httpx.Client(
            follow_redirects=False,
            cookies=http.cookiejar.CookieJar(policy=no_cookies),
            verify=certificates(),
            trust_env=False,
            proxy=httpx.Proxy(
                route.url,
                headers=dict(route.headers),
                ssl_context=certificates() if route.url[:6] == "https:" else None,
            ),
        )
        self._response: httpx.Response | None = None
        self._is_new = self._has_answer = False

    def send(self, request: HttpRequest) -> HttpResponse:
        """Send a request and receive the head of its response."""
        self._is_new = self._has_answer = False
        built = self._client.build_request(
            request.method,
            request.url,
            content=request.content,
            headers=list(request.headers.values()),
            timeout=request.timeout_s,
            extensions={"trace": self._trace},
        )
        response = self._response = self._client.send(built, stream=True)
        self._has_answer = True
        network = response.extensions["network_stream"]
        sock = network.get_extra_info("socket")
        return HttpResponse(self, sock, response.status_code, response.headers)

    def _trace(self, event: str, _info: dict[str, Any]) -> None:
        if event == "connection.connect_tcp.started":
            self._is_new = True

    def was_closed_before_use(self, error: BaseException) -> bool:
        """As of KeptConnection."""
        return not (self._is_new or self._has_answer) and can_be_stale(error)

    def read_parts(self) -> Iterator[bytes]:
        """Give the parts of a body, still compressed if it is."""
        if self._response is not None:
            yield from self._response.iter_raw()

    def close_unless_idle(self) -> None:
        """Close the response; the client keeps its connection if it was read."""
        if self._response is not None:
            self._response.close()

    def close(self) -> None:
        """Close all of its connections."""
        self._client.close()
