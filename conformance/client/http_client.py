"""The HTTP client of a check: one account's token, raw responses, no status exceptions.

Every request carries `X-Correlation-Id: <check>/<n>`; every exchange is added to the
log of the check and passed to an observer, which judges the rules for all responses.
Requests are never corrected here: a check may send anything.
"""

import contextlib
import functools
import http.cookiejar
import ipaddress
import json as json_module
import re
import socket
import ssl
import threading
import time
from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import Any
from urllib.parse import urlsplit

import httpx

from conformance.client.connection_faults import (
    ConnectionTrace,
    is_own_fault,
    is_repeatable,
)
from conformance.client.exchange_log import ExchangeLog
from conformance.client.proxy_answers import find_proxy
from conformance.exchanges.answer import Answer, ParsedAnswer, media_type_of, parse
from conformance.exchanges.exchange import Exchange
from conformance.specification.document import EVENT_STREAM, JSON, Operation, Spec
from conformance.verdicts.expect import OwnConnectionFailed, SetUpFailed, Violation

OWN_TOKEN = "own"
# Of a stream: the bytes stored, and the timeout for its first event.
_STREAM_BYTES_STORED = 4096
_FIRST_EVENT_TIMEOUT_S = 3.0
_FIRST_EVENT = re.compile(rb"^data[^\r\n]*(\r\n|\n|\r){2}", re.MULTILINE)
Observer = Callable[[Operation | None, ParsedAnswer, Exchange], None]
_LIMITS = httpx.Limits(
    max_connections=4, max_keepalive_connections=2, keepalive_expiry=2.0
)


class NoAnswer(Violation):
    """The server closed the connection, refused it, or took too long."""


class AnsweredByProxy(SetUpFailed):
    """A proxy in front of the server refused the request, which did not reach it."""


class ClientPool:
    """HTTP clients that keep their connections, each used by one thread at a time.

    One client for all threads is not safe: while one thread is given an idle
    connection, another may find that it has expired, and close it.
    """

    def __init__(self, url: str) -> None:
        self._url = url
        self._idle: list[httpx.Client] = []
        self._lock = threading.Lock()

    @contextlib.contextmanager
    def borrow(self) -> Iterator[httpx.Client]:
        """Give a client that nothing else uses until the end of the block.

        After an error its connections are closed: nothing is known about them.
        """
        with self._lock:
            client = self._idle.pop() if self._idle else None
        client = client or self._open()
        try:
            yield client
        except BaseException:
            client.close()
            raise
        with self._lock:
            self._idle.append(client)

    def _open(self) -> httpx.Client:
        no_cookies = http.cookiejar.DefaultCookiePolicy(allowed_domains=[])
        return httpx.Client(
            limits=_LIMITS,
            follow_redirects=False,
            cookies=http.cookiejar.CookieJar(policy=no_cookies),
            verify=_certificates(),
            # Proxies from the environment are for other machines, not for this one.
            trust_env=not _is_this_machine(self._url),
        )

    def close(self) -> None:
        """Close all clients that are not in use."""
        with self._lock:
            idle, self._idle = self._idle, []
        for client in idle:
            client.close()


@functools.cache
def _certificates() -> ssl.SSLContext:
    """Load the certificate authorities once: it is slow."""
    return httpx.create_ssl_context()


def _is_this_machine(url: str) -> bool:
    host = urlsplit(url).hostname or ""
    try:
        return ipaddress.ip_address(host).is_loopback
    except ValueError:
        return host == "localhost"


class AnswerStream:
    """A response without an end: its parts, until either side closes it."""

    def __init__(self, response: httpx.Response) -> None:
        self.body = b""
        self._response = response

    def parts(self) -> Iterator[bytes]:
        """Give the parts as they arrive; a broken connection ends the stream."""
        with contextlib.suppress(httpx.TransportError, OSError):
            for part in self._response.iter_bytes():
                self.body += part[: max(0, _STREAM_BYTES_STORED - len(self.body))]
                yield part

    def shut_down(self) -> None:
        """End it from another thread than the one that reads it."""
        network = self._response.extensions["network_stream"]
        with contextlib.suppress(OSError):
            network.get_extra_info("socket").shutdown(socket.SHUT_RDWR)


def _send_once(
    client: httpx.Client, request: httpx.Request, is_stream: bool
) -> httpx.Response:
    response = client.send(request, stream=is_stream)
    if media_type_of(response.headers) != EVENT_STREAM:
        response.read()
    return response


def _read_first_event(response: httpx.Response) -> bytes:
    """Read the first event of a stream that may have no end."""
    stream, until = AnswerStream(response), time.monotonic() + _FIRST_EVENT_TIMEOUT_S
    with contextlib.closing(response):
        for _ in stream.parts():
            if _FIRST_EVENT.search(stream.body) or time.monotonic() > until:
                break
    return stream.body


# The value of a header Accept that is not sent, as by programs that name none.
NO_ACCEPT = ""


class HttpClient:
    """Requests of one account to one server; safe for several threads."""

    def __init__(
        self,
        *,
        clients: ClientPool,
        spec: Spec,
        base_url: str,
        token: str | None,
        token_name: str,
        exchange_log: ExchangeLog,
        observe: Observer,
    ) -> None:
        self.base_url = base_url.rstrip("/")
        self.token = token
        self._token_name = token_name
        self._clients = clients
        self._spec = spec
        self._exchange_log = exchange_log
        self._observe = observe

    def request(
        self,
        method: str,
        path: str,
        *,
        json: Any = None,
        content: bytes | Iterable[bytes] | None = None,
        headers: Mapping[str, str] | None = None,
        params: Mapping[str, Any] | None = None,
        timeout_s: float = 30.0,
        token: str | None = OWN_TOKEN,
        operation: Operation | None = None,
    ) -> Answer:
        """Send one request. `path` may be absolute; `token` None sends none.

        Raises NoAnswer when there is no answer at all, and AnsweredByProxy. Of an
        event stream, which has no end, the first event is the answer, or a few seconds.
        """
        if json is not None:
            content = json_module.dumps(json).encode()
            headers = {"Content-Type": JSON, **(headers or {})}
        with self._clients.borrow() as client:
            request, exchange = self._prepare(
                client,
                method,
                path,
                content=content,
                headers=headers,
                params=params,
                timeout_s=timeout_s,
                token=token,
            )
            if operation is None:
                operation = self._operation_of(method, str(request.url))
            response = self._send(client, request, exchange, operation)
            is_read = response.is_stream_consumed
            body = response.content if is_read else _read_first_event(response)
        return self._log_and_observe(response, body, exchange, operation)

    @contextlib.contextmanager
    def stream(
        self, operation: Operation, path: str, headers: Mapping[str, str]
    ) -> Iterator[AnswerStream | Answer]:
        """Send a GET for a stream; gives an Answer if the response is none."""
        # The connection is closed after the stream and not used again.
        headers = {"Connection": "close", **headers}
        with self._clients.borrow() as client:
            request, exchange = self._prepare(client, "GET", path, headers=headers)
            response = self._send(client, request, exchange, operation)
            if response.is_stream_consumed:
                yield self._log_and_observe(
                    response, response.content, exchange, operation
                )
                return
            stream = AnswerStream(response)
            try:
                yield stream
            finally:
                response.close()
                self._log_and_observe(response, stream.body, exchange, operation)

    def _prepare(
        self,
        client: httpx.Client,
        method: str,
        path: str,
        *,
        headers: Mapping[str, str] | None,
        content: bytes | Iterable[bytes] | None = None,
        params: Mapping[str, Any] | None = None,
        timeout_s: float = 30.0,
        token: str | None = OWN_TOKEN,
    ) -> tuple[httpx.Request, Exchange]:
        url = path if "://" in path else self.base_url + path
        number = self._exchange_log.next_number()
        correlation_id = f"{self._exchange_log.name}/{number}"
        own_headers = {"X-Correlation-Id": correlation_id}
        bearer = self.token if token == OWN_TOKEN else token
        if bearer is not None:
            own_headers["Authorization"] = f"Bearer {bearer}"
        try:
            request = client.build_request(
                method,
                url,
                content=content,
                headers={**own_headers, **(headers or {})},
                params=params,
                timeout=timeout_s,
            )
            if (headers or {}).get("Accept") == NO_ACCEPT:
                del request.headers["Accept"]  # of the library
        except httpx.InvalidURL as error:
            # Paths of the kit are valid; `endpoint` is the server's.
            raise Violation("a valid URL", f"{url!r}: {error}") from error
        size = len(content) if isinstance(content, bytes) else None
        exchange = Exchange(
            number=number,
            correlation_id=correlation_id,
            method=method,
            url=str(request.url),
            token_name=self._name_of(request.headers.get("authorization")),
            request_headers={
                name: value
                for name, value in (headers or {}).items()
                if name.lower() != "authorization"
            },
            request_body=content if isinstance(content, bytes) else b"",
            request_size=0 if content is None else size,
        )
        return request, exchange

    def _send(
        self,
        client: httpx.Client,
        request: httpx.Request,
        exchange: Exchange,
        operation: Operation | None,
    ) -> httpx.Response:
        """Give the response; of an event stream only the head.

        Raises httpx.LocalProtocolError, as of a mistake of the kit, when HTTP cannot
        carry the request.
        """
        is_stream = operation is not None and operation.is_event_stream
        operation_id = operation.operation_id if operation is not None else None
        exchange.started_at = time.monotonic()
        trace = ConnectionTrace()
        request.extensions["trace"] = trace
        try:
            try:
                response = _send_once(client, request, is_stream)
            except httpx.TransportError as error:
                if not trace.was_closed_before_use(error):
                    raise
                if not is_repeatable(request, operation_id):
                    raise
                response = _send_once(client, request, is_stream)
        except httpx.LocalProtocolError:
            raise
        except (httpx.RequestError, OSError) as error:
            text = f"{type(error).__name__}: {error}"
            if is_own_fault(error):
                raise OwnConnectionFailed(f"{request.url}: {text}") from error
            raise self._log_no_answer(exchange, text) from error
        if response.is_stream_consumed:
            self._refuse_answer_of_proxy(response, exchange)
        return response

    def _log_no_answer(self, exchange: Exchange, text: str) -> NoAnswer:
        exchange.elapsed_s = time.monotonic() - exchange.started_at
        exchange.error = text
        self._exchange_log.add(exchange)
        return NoAnswer("an answer", text, exchange.number)

    def _refuse_answer_of_proxy(
        self, response: httpx.Response, exchange: Exchange
    ) -> None:
        """Raise if a proxy answered: a 5xx says that it got no answer, either."""
        status = response.status_code
        proxy = find_proxy(status, response.headers, response.content)
        if proxy is None:
            return
        text = f"{proxy}, in front of the server, answered {status} in its place"
        no_answer = self._log_no_answer(exchange, text)
        if status >= 500:
            raise no_answer
        raise AnsweredByProxy(
            f"the request did not reach the server: {text}", allowed=True
        )

    def _log_and_observe(
        self,
        response: httpx.Response,
        body: bytes,
        exchange: Exchange,
        operation: Operation | None,
    ) -> Answer:
        """Log an exchange and pass it to the observer."""
        ended_at = time.monotonic()
        value, is_readable = parse(media_type_of(response.headers), body)
        exchange.elapsed_s = ended_at - exchange.started_at
        exchange.status = response.status_code
        exchange.answer_headers = dict(response.headers)
        exchange.answer_body = body
        self._exchange_log.add(exchange)
        parsed = ParsedAnswer(
            status=response.status_code,
            headers=response.headers,
            media_type=media_type_of(response.headers),
            body=body,
            value=value,
            is_readable=is_readable,
        )
        self._observe(operation, parsed, exchange)
        return Answer(
            status=response.status_code,
            headers=response.headers,
            body=body,
            started_at=exchange.started_at,
            ended_at=ended_at,
            json=value,
            exchange=exchange.number,
        )

    def _name_of(self, authorization: str | None) -> str | None:
        """Name the token that was sent, without its value."""
        if authorization is None:
            return None
        is_own = authorization == f"Bearer {self.token}"
        return self._token_name if is_own else "WRONG_TOKEN"

    def _operation_of(self, method: str, url: str) -> Operation | None:
        if not url.startswith(self.base_url):
            return None
        path = url.removeprefix(self.base_url).partition("?")[0]
        return self._spec.find(method, path)
