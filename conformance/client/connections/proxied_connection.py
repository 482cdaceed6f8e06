"""A connection through the proxy that the environment names; httpx speaks with it.

Has the interface of KeptConnection.
"""

import contextlib
import http.cookiejar
import socket
import ssl
import threading
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
        self._request: HttpRequest | None = None
        self._sock: socket.socket | None = None
        self._is_new = self._has_answer = self._is_late = self._has_tunnel = False
        self._timer = threading.Timer(0.0, self._end_late_answer)

    def send(self, request: HttpRequest) -> HttpResponse:
        """Send a request and receive the head of its response."""
        self._is_new = self._has_answer = self._is_late = False
        self._request = request
        self._timer.cancel()
        self._timer = threading.Timer(request.answer_timeout_s, self._end_late_answer)
        self._timer.daemon = True
        self._timer.start()
        built = self._client.build_request(
            request.method,
            request.url,
            content=request.content,
            headers=list(request.headers.values()),
            timeout=request.timeout_s,
            extensions={"trace": self._trace},
        )
        with self._late_answers():
            response = self._response = self._client.send(built, stream=True)
        self._has_answer = True
        network = response.extensions["network_stream"]
        sock = network.get_extra_info("socket")
        return HttpResponse(self, sock, response.status_code, response.headers)

    def _trace(self, event: str, info: dict[str, Any]) -> None:
        if event == "connection.connect_tcp.started":
            self._is_new, self._has_tunnel = True, False
        if event == "proxy.start_tls.started":
            self._has_tunnel = True
        if event.endswith((".connect_tcp.complete", ".start_tls.complete")):
            self._sock = info["return_value"].get_extra_info("socket")

    def _end_late_answer(self) -> None:
        """End an answer whose time is over, from the thread of the timer."""
        self._is_late = True
        if self._sock is not None:
            with contextlib.suppress(OSError):
                self._sock.shutdown(socket.SHUT_RDWR)

    @contextlib.contextmanager
    def _late_answers(self) -> Iterator[None]:
        """Name the reason if the timer has ended the connection."""
        try:
            yield
        except httpx.TransportError as error:
            self._timer.cancel()
            is_tunnel = self._request is not None and self._request.is_secure
            is_known = isinstance(error, httpx.ProxyError | httpx.ConnectError)
            if is_tunnel and self._is_new and not (self._has_tunnel or is_known):
                raise httpx.ProxyError("it did not answer in time") from error
            if self._is_late and self._request is not None:
                raise self._request.late() from error
            raise

    def was_closed_before_use(self, error: BaseException) -> bool:
        """As of KeptConnection."""
        return not (self._is_new or self._has_answer) and can_be_stale(error)

    def read_parts(self, *, is_endless: bool) -> Iterator[bytes]:
        """As of BodySource; the parts are still compressed if the body is."""
        if is_endless:
            self._timer.cancel()
        if self._response is not None:
            with self._late_answers():
                yield from self._response.iter_raw()
        self._timer.cancel()

    def close_unless_idle(self) -> None:
        """Close the response; the client keeps its connection if it was read."""
        self._timer.cancel()
        if self._response is not None:
            self._response.close()

    def close(self) -> None:
        """Close all of its connections."""
        self._timer.cancel()
        self._client.close()
