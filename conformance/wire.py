"""HTTP as a check sees it: one account's token, every answer, no exceptions on status.

Every request carries `X-Correlation-Id: <check>/<n>`; every exchange goes to the
check's journal and is judged by the rules that hold for all answers. What is sent is
never corrected here: a check may send anything.
"""

import functools
import http.cookiejar
import ipaddress
import json as json_module
import ssl
import time
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any
from urllib.parse import urlsplit

import httpx
import msgspec

from conformance.expect import Violation
from conformance.journal import Exchange, Journal
from conformance.judge import Judged, Tally
from conformance.spec import JSON, MSGPACK, PROBLEM_JSON, Operation, Spec

OWN_TOKEN = "own"
_CONNECTIONS = httpx.Limits(
    max_connections=200, max_keepalive_connections=60, keepalive_expiry=2.0
)


class NoAnswer(Violation):
    """The server closed the connection, refused it, or took too long."""


@dataclass(frozen=True)
class Answer:
    """One HTTP answer; `json` is the parsed body, JSON or MessagePack, or None."""

    status: int
    headers: httpx.Headers
    body: bytes
    started_at: float
    ended_at: float
    json: Any
    exchange: int

    @property
    def elapsed_s(self) -> float:
        """Time from sending the request to having read the answer."""
        return self.ended_at - self.started_at

    @property
    def code(self) -> str | None:
        """The problem code, if the body is an object that has one."""
        code = self.json.get("code") if isinstance(self.json, dict) else None
        return code if self.status >= 400 and isinstance(code, str) else None

    @property
    def media_type(self) -> str:
        """Content type without parameters, in lower case."""
        return media_type_of(self.headers)


def media_type_of(headers: Mapping[str, str]) -> str:
    """Give the content type without parameters, in lower case."""
    return headers.get("content-type", "").partition(";")[0].strip().lower()


def parse(media_type: str, body: bytes) -> tuple[Any, bool]:
    """Read a body by its media type; strictly, so that NaN is an error."""
    try:
        if media_type in (JSON, PROBLEM_JSON):
            return msgspec.json.decode(body), True
        if media_type == MSGPACK:
            return msgspec.msgpack.decode(body), True
    except (msgspec.DecodeError, UnicodeDecodeError, RecursionError):
        pass
    return None, False


def open_connections(url: str) -> httpx.Client:
    """Open the pool that all wires of one process share."""
    no_cookies = http.cookiejar.DefaultCookiePolicy(allowed_domains=[])
    return httpx.Client(
        limits=_CONNECTIONS,
        follow_redirects=False,
        cookies=http.cookiejar.CookieJar(policy=no_cookies),
        verify=_certificates(),
        # Proxies from the environment help to reach the world, not this machine.
        trust_env=not _is_this_machine(url),
    )


@functools.cache
def _certificates() -> ssl.SSLContext:
    """Read the authorities once: it takes longer than all else here together."""
    return httpx.create_ssl_context()


def _is_this_machine(url: str) -> bool:
    host = urlsplit(url).hostname or ""
    try:
        return ipaddress.ip_address(host).is_loopback
    except ValueError:
        return host == "localhost"


class Wire:
    """Requests of one account to one server; safe for several threads."""

    def __init__(
        self,
        *,
        client: httpx.Client,
        spec: Spec,
        base_url: str,
        token: str | None,
        token_name: str,
        journal: Journal,
        tally: Tally,
    ) -> None:
        self.base_url = base_url.rstrip("/")
        self.token = token
        self._token_name = token_name
        self._client = client
        self._spec = spec
        self._journal = journal
        self._tally = tally

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

        Raises NoAnswer when there is no answer at all.
        """
        if json is not None:
            content = json_module.dumps(json).encode()
            headers = {"Content-Type": JSON, **(headers or {})}
        url = path if "://" in path else self.base_url + path
        number = self._journal.next_number()
        correlation_id = f"{self._journal.name}/{number}"
        own_headers = {"X-Correlation-Id": correlation_id}
        bearer = self.token if token == OWN_TOKEN else token
        if bearer is not None:
            own_headers["Authorization"] = f"Bearer {bearer}"
        request = self._client.build_request(
            method,
            url,
            content=content,
            headers={**own_headers, **(headers or {})},
            params=params,
            timeout=timeout_s,
        )
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
        if operation is None:
            operation = self._operation_of(method, str(request.url))
        return self._send(request, exchange, operation)

    def _send(
        self, request: httpx.Request, exchange: Exchange, operation: Operation | None
    ) -> Answer:
        exchange.started_at = started_at = time.monotonic()
        try:
            response = self._client.send(request)
        except (httpx.TransportError, OSError) as error:
            exchange.elapsed_s = time.monotonic() - started_at
            exchange.error = f"{type(error).__name__}: {error}"
            self._journal.add(exchange)
            raise NoAnswer("an answer", exchange.error, exchange.number) from error
        ended_at = time.monotonic()
        value, is_readable = parse(media_type_of(response.headers), response.content)
        exchange.elapsed_s = ended_at - started_at
        exchange.status = response.status_code
        exchange.answer_headers = dict(response.headers)
        exchange.answer_body = response.content
        self._journal.add(exchange)
        judged = Judged(
            status=response.status_code,
            headers=response.headers,
            media_type=media_type_of(response.headers),
            body=response.content,
            value=value,
            is_readable=is_readable,
        )
        self._tally.observe(operation, judged, exchange)
        return Answer(
            status=response.status_code,
            headers=response.headers,
            body=response.content,
            started_at=started_at,
            ended_at=ended_at,
            json=value,
            exchange=exchange.number,
        )

    def _name_of(self, authorization: str | None) -> str | None:
        """Say which token it was, never what it was."""
        if authorization is None:
            return None
        is_own = authorization == f"Bearer {self.token}"
        return self._token_name if is_own else "WRONG_TOKEN"

    def _operation_of(self, method: str, url: str) -> Operation | None:
        if not url.startswith(self.base_url):
            return None
        path = url.removeprefix(self.base_url).partition("?")[0]
        return self._spec.find(method, path)
