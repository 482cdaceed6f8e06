"""The HTTP client of a check: one account's token, raw responses, no status exceptions.

Every request carries `X-Correlation-Id: <check>/<n>`; every exchange is added to the
log of the check and passed to a judge, which knows the rules for all responses.
Requests are never corrected here: a check may send anything.
"""

import contextlib
import functools
import json as json_module
import re
import ssl
import time
from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import Any, Protocol

import httpx

from conformance.client.base_urls import BaseUrls
from conformance.client.connections.connection_faults import (
    causes_of,
    is_own_fault,
    is_repeatable,
)
from conformance.client.connections.connection_pool import (
    Connection,
    ConnectionPool,
    Connections,
)
from conformance.client.connections.failure_texts import PROXY_ERRORS, proxy_in_between
from conformance.client.connections.kept_connection import HttpRequest, HttpResponse
from conformance.client.connections.proxy_answers import find_proxy
from conformance.client.connections.transport.proxy_route import BadProxy, find_route
from conformance.client.connections.way_faults import (
    is_broken_answer,
    is_gateway_page,
)
from conformance.client.exchange_log import BODY_BYTES_STORED, ExchangeLog
from conformance.exchanges.answer import Answer, ParsedAnswer, media_type_of, parse
from conformance.exchanges.exchange import Exchange
from conformance.specification.document import EVENT_STREAM, JSON, Operation, Spec
from conformance.verdicts.expect import OwnConnectionFailed, SetUpFailed, Violation

OWN_TOKEN = "own"
# An event stream has no end: so many bytes of it are kept, and its first event is
# awaited for so long.
_STREAM_BYTES_STORED = 4096
_LARGE_BODY_BYTES = 10**6
_FIRST_EVENT_TIMEOUT_S = 3.0
_FIRST_EVENT = re.compile(rb"^data[^\r\n]*(\r\n|\n|\r){2}", re.MULTILINE)


class Judge(Protocol):
    """Judges every exchange: when it is sent, answered, or left unanswered."""

    def begin(self, operation: Operation | None, exchange: Exchange) -> None:
        """Note that a request is sent."""

    def observe(
        self, operation: Operation | None, answer: ParsedAnswer, exchange: Exchange
    ) -> None:
        """Judge an exchange that has ended."""

    def lose(self, operation: Operation | None, exchange: Exchange) -> None:
        """Note that no answer came."""


class NoAnswer(Violation):
    """The server closed the connection, refused it, or took too long."""

    @property
    def is_of_way(self) -> bool:
        """Whether a network or a gateway may have lost the answer."""
        return self.__cause__ is None or is_broken_answer(self.__cause__)


class LeftUnanswered(Exception):
    """The client closed its connection before an answer, as the check wanted."""


class AnsweredByProxy(SetUpFailed):
    """A proxy in front of the server refused the request, which did not reach it."""


class AnswerStream:
    """A response without an end: its parts, until either side closes it."""

    def __init__(
        self, response: HttpResponse, note_break: Callable[[str], None]
    ) -> None:
        self.body = b""
        self._response = response
        self._note_break = note_break
        self._is_shut_down = False

    def parts(self) -> Iterator[bytes]:
        """Give the parts as they arrive; a broken connection ends the stream."""
        try:
            for part in self._response.parts():
                self.body += part[: max(0, _STREAM_BYTES_STORED - len(self.body))]
                yield part
        except (httpx.RequestError, OSError) as error:
            if is_broken_answer(error) and not self._is_shut_down:
                self._note_break(f"{type(error).__name__}: {error}")

    def shut_down(self) -> None:
        """End it from another thread than the one that reads it."""
        self._is_shut_down = True
        self._response.shut_down()


def _send_once(connection: Connection, request: HttpRequest) -> HttpResponse:
    response = connection.send(request)
    if media_type_of(response.headers) != EVENT_STREAM:
        response.read()
    return response


def _send_or_repeat(
    connection: Connection, request: HttpRequest, operation_id: str | None
) -> HttpResponse:
    """Send a request, once more if its connection was closed before its use."""
    try:
        return _send_once(connection, request)
    except httpx.TransportError as error:
        is_whole = isinstance(request.content, bytes | None)
        if (
            not connection.was_closed_before_use(error)
            or not is_whole
            or not is_repeatable(request.method, request.headers, operation_id)
        ):
            raise
    return _send_once(connection, request)


def _parse(response: HttpResponse, body: bytes) -> ParsedAnswer:
    headers = dict(response.headers.items())
    media_type = media_type_of(headers)
    value, is_readable = parse(media_type, body)
    return ParsedAnswer(
        status=response.status,
        headers=headers,
        media_type=media_type,
        body=body,
        value=value,
        is_readable=is_readable,
    )


def _is_of_own_proxy(error: Exception, url: str) -> bool:
    """Whether the proxy that the environment names failed, before any server."""
    is_of_tls = any(isinstance(cause, ssl.SSLError) for cause in causes_of(error))
    return (
        isinstance(error, PROXY_ERRORS) and not is_of_tls and bool(find_route(url).url)
    )


def _read_first_event(response: HttpResponse, stream: AnswerStream) -> bytes:
    """Read the first event of a stream that may have no end."""
    until = time.monotonic() + _FIRST_EVENT_TIMEOUT_S
    with contextlib.closing(response):
        for _ in stream.parts():
            if _FIRST_EVENT.search(stream.body) or time.monotonic() > until:
                break
    return stream.body


@functools.lru_cache(maxsize=512)
def _parse_url(url: str) -> httpx.URL:
    try:
        return httpx.URL(url)
    except httpx.InvalidURL as error:
        # Paths of the kit are valid; `endpoint` is the server's.
        raise Violation("a valid URL", f"{url!r}: {error}") from error


# The value of a header Accept that is not sent, as by programs that name none.
NO_ACCEPT = ""
# Headers of every request that does not name others.
_DEFAULT_HEADERS = {
    "accept": ("Accept", "*/*"),
    "accept-encoding": ("Accept-Encoding", "gzip, deflate"),
    "connection": ("Connection", "keep-alive"),
    "user-agent": ("User-Agent", "proctor-conformance"),
}


def _logged_parts(parts: Iterable[bytes], exchange: Exchange) -> Iterator[bytes]:
    """Give the parts of a body, and note its beginning and how much was sent of it."""
    size = 0
    for part in parts:
        exchange.request_body += part[: max(BODY_BYTES_STORED - size, 0)]
        size += len(part)
        exchange.request_size = size
        yield part


class HttpClient:
    """Requests of one account to one service; safe for several threads."""

    def __init__(
        self,
        *,
        connections: ConnectionPool,
        spec: Spec,
        base_urls: BaseUrls,
        token: str | None,
        token_name: str,
        exchange_log: ExchangeLog,
        judge: Judge,
    ) -> None:
        self.base_url = base_urls.first
        self._base_urls = base_urls
        self.token = token
        self._token_name = token_name
        self._connections = connections
        self._spec = spec
        self._exchange_log = exchange_log
        self._way_faults = exchange_log.way_faults
        self._judge = judge

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
        leave_after_s: float | None = None,
        token: str | None = OWN_TOKEN,
        operation: Operation | None = None,
    ) -> Answer:
        """Send one request. `path` may be absolute; `token` None sends none.

        leave_after_s: the connection is closed after this time without an answer.
        Raises NoAnswer when there is no answer at all, LeftUnanswered then, and
        AnsweredByProxy. An event stream has no end: its answer is over with the first
        event, or after a few seconds.
        """
        if json is not None:
            content = json_module.dumps(json).encode()
            headers = {"Content-Type": JSON, **(headers or {})}
        request, exchange = self._prepare(
            method,
            path,
            content=content,
            headers=headers,
            params=params,
            timeout_s=timeout_s if leave_after_s is None else leave_after_s,
            token=token,
        )
        exchange.leave_after_s = leave_after_s
        if operation is None:
            operation = self._operation_of(method, exchange.url)
        with self._connections.borrow() as connections:
            response = self._send(connections, request, exchange, operation)
            body = response.body
            if body is None:
                stream = self._stream_of(response, operation, exchange)
                body = _read_first_event(response, stream)
        return self._log_and_observe(response, body, exchange, operation)

    @contextlib.contextmanager
    def stream(
        self, operation: Operation | None, path: str, headers: Mapping[str, str]
    ) -> Iterator[AnswerStream | Answer]:
        """Send a GET for a stream; gives an Answer if the response is none.

        operation: None for one of a profile.
        """
        # The connection is closed after the stream and not used again.
        headers = {"Connection": "close", **headers}
        request, exchange = self._prepare("GET", path, headers=headers)
        with self._connections.borrow() as connections:
            response = self._send(connections, request, exchange, operation)
            if response.body is not None:
                yield self._log_and_observe(
                    response, response.body, exchange, operation
                )
                return
            stream = self._stream_of(response, operation, exchange)
            try:
                yield stream
            finally:
                response.close()
                self._log_and_observe(response, stream.body, exchange, operation)

    def _stream_of(
        self, response: HttpResponse, operation: Operation | None, exchange: Exchange
    ) -> AnswerStream:
        note = functools.partial(
            self._way_faults.note, operation, exchange, is_of_stream=True
        )
        return AnswerStream(response, note)

    def _prepare(
        self,
        method: str,
        path: str,
        *,
        headers: Mapping[str, str] | None,
        content: bytes | Iterable[bytes] | None = None,
        params: Mapping[str, Any] | None = None,
        timeout_s: float = 30.0,
        token: str | None = OWN_TOKEN,
    ) -> tuple[HttpRequest, Exchange]:
        number = self._exchange_log.next_number()
        correlation_id = f"{self._exchange_log.name}/{number}"
        address = path if "://" in path else self.base_url + path
        url = _parse_url(self._base_urls.choose(address, correlation_id))
        if params is not None:
            url = httpx.URL(url, params=params)
        sent = _DEFAULT_HEADERS | {
            "x-correlation-id": ("X-Correlation-Id", correlation_id)
        }
        bearer = self.token if token == OWN_TOKEN else token
        if bearer is not None:
            sent["authorization"] = ("Authorization", f"Bearer {bearer}")
        sent |= {name.lower(): (name, value) for name, value in (headers or {}).items()}
        if sent["accept"][1] == NO_ACCEPT:
            del sent["accept"]
        size = len(content) if isinstance(content, bytes) else None
        exchange = Exchange(
            number=number,
            correlation_id=correlation_id,
            method=method,
            url=str(url),
            token_name=self._name_of(sent.get("authorization", ("", None))[1]),
            request_headers={
                name: value
                for name, value in (headers or {}).items()
                if name.lower() != "authorization"
            },
            request_body=content if isinstance(content, bytes) else b"",
            request_size=0 if content is None else size,
        )
        if content is not None and not isinstance(content, bytes):
            content = _logged_parts(content, exchange)
            if "content-length" not in sent:
                exchange.request_headers["Transfer-Encoding"] = "chunked"
        return HttpRequest(method.upper(), url, sent, content, timeout_s), exchange

    def _send(
        self,
        connections: Connections,
        request: HttpRequest,
        exchange: Exchange,
        operation: Operation | None,
    ) -> HttpResponse:
        """Give the response; of an event stream only the head."""
        exchange.started_at = time.monotonic()
        self._judge.begin(operation, exchange)
        self._way_faults.count(operation, exchange)
        try:
            return self._receive(connections, request, exchange, operation)
        except BaseException:
            self._judge.lose(operation, exchange)
            raise

    def _receive(
        self,
        connections: Connections,
        request: HttpRequest,
        exchange: Exchange,
        operation: Operation | None,
    ) -> HttpResponse:
        """Send a request and give the response.

        Raises httpx.LocalProtocolError, as of a mistake of the kit, when HTTP cannot
        carry the request.
        """
        operation_id = operation.operation_id if operation is not None else None
        try:
            connection = connections.to(request.url)
            response = _send_or_repeat(connection, request, operation_id)
        except httpx.LocalProtocolError:
            raise
        except BadProxy as error:
            raise OwnConnectionFailed(f"{request.url}: {error}") from error
        except (httpx.RequestError, OSError) as error:
            text = f"{type(error).__name__}: {error}"
            left_s = exchange.leave_after_s
            if left_s is not None and isinstance(error, httpx.TimeoutException):
                text = f"the client closed the connection after {left_s:g} s"
                raise LeftUnanswered from self._log_no_answer(exchange, text)
            if is_own_fault(error) or _is_of_own_proxy(error, str(request.url)):
                raise OwnConnectionFailed(f"{request.url}: {text}") from error
            if is_broken_answer(error):
                self._way_faults.note(operation, exchange, text)
            raise self._log_no_answer(exchange, text, operation_id) from error
        if response.body is not None:
            self._refuse_answer_of_proxy(response, response.body, exchange, operation)
        return response

    def _log_no_answer(
        self, exchange: Exchange, text: str, operation_id: str | None = None
    ) -> NoAnswer:
        exchange.elapsed_s = time.monotonic() - exchange.started_at
        exchange.error = text
        self._exchange_log.add(exchange)
        expected = f"an answer of `{operation_id}`" if operation_id else "an answer"
        waited = f"none within {exchange.elapsed_s:.0f} s ({text})"
        if (size := exchange.request_size or 0) > _LARGE_BODY_BYTES:
            waited += f", to a body of {size} bytes"
        observed = waited if "Timeout" in text else text
        return NoAnswer(expected, observed, exchange.number)

    def _refuse_answer_of_proxy(
        self,
        response: HttpResponse,
        body: bytes,
        exchange: Exchange,
        operation: Operation | None,
    ) -> None:
        """Raise if a proxy answered: a 5xx says that it got no answer, either."""
        status, headers = response.status, response.headers
        answer = _parse(response, body) if status >= 500 else None
        proxy = find_proxy(status, headers, body)
        proxy = proxy or proxy_in_between(status, headers, exchange.url)
        has_way = self._way_faults.has_way
        if not proxy and answer is not None and has_way and is_gateway_page(answer):
            proxy = "a gateway"
        if proxy is None:
            return
        text = f"{proxy}, in front of the server, answered {status} in its place"
        if answer is not None:
            self._way_faults.note(operation, exchange, text, answer)
        no_answer = self._log_no_answer(exchange, text)
        if status >= 500:
            raise no_answer
        raise AnsweredByProxy(
            f"the request did not reach the server: {text}", allowed=True
        )

    def _log_and_observe(
        self,
        response: HttpResponse,
        body: bytes,
        exchange: Exchange,
        operation: Operation | None,
    ) -> Answer:
        """Log an exchange and pass it to the judge."""
        ended_at = time.monotonic()
        parsed = _parse(response, body)
        exchange.elapsed_s = ended_at - exchange.started_at
        exchange.status = response.status
        exchange.answer_headers = dict(parsed.headers)
        exchange.answer_body = body
        self._exchange_log.add(exchange)
        self._judge.observe(operation, parsed, exchange)
        return Answer(
            status=response.status,
            headers=response.headers,
            body=body,
            started_at=exchange.started_at,
            ended_at=ended_at,
            json=parsed.value,
            exchange=exchange.number,
        )

    def _name_of(self, authorization: str | None) -> str | None:
        """Name the token that was sent, without its value."""
        if authorization is None:
            return None
        is_own = authorization == f"Bearer {self.token}"
        return self._token_name if is_own else "WRONG_TOKEN"

    def _operation_of(self, method: str, url: str) -> Operation | None:
        path = self._base_urls.path_of(url)
        if path is None:
            return None
        return self._spec.find(method, path.partition("?")[0])
