"""The connections to one server, and the sending and reading of all operations.

Written by hand, beside what is generated from the specification.
"""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Mapping
from copy import copy
from dataclasses import dataclass
from typing import Any, BinaryIO, Generic, ParamSpec, Self, TypeVar, overload
from urllib.parse import quote, urlencode, urljoin, urlsplit

import urllib3

from .configuration import Configuration
from .exceptions import ApiException
from .message import Message
from .models import Problem
from .cut_answers import is_cut
from .transport.fault_texts import is_of_proctor
from .version import __version__

Arguments = ParamSpec("Arguments")
Result = TypeVar("Result")
Answer = TypeVar("Answer", bound=Message)

_REDIRECTS_MAX = 5
# Seconds for the whole request, or a pair for connecting and for each read.
Timeout = float | tuple[float, float]


@dataclass(frozen=True)
class ApiResponse(Generic[Result]):
    """The answer of an operation with its status and headers."""

    status_code: int
    headers: Mapping[str, str]
    data: Result
    raw_data: bytes


class ApiClient:
    """The connections to a server. Any number of threads may use one.

    default_headers: sent with every request.
    """

    def __init__(self, configuration: Configuration | None = None) -> None:
        self.configuration = configuration or Configuration()
        self.default_headers = {"User-Agent": f"proctor-client/{__version__}"}
        self.pool_manager = self.configuration.pool_manager()
        self._on_answer: Callable[[ApiResponse[Any]], None] = _ignore

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """Close the connections that are not in use."""
        self.pool_manager.clear()

    @overload
    def call(
        self, method: str, path: str, answer: type[Answer], **parts: Any
    ) -> Answer: ...

    @overload
    def call(self, method: str, path: str, answer: None, **parts: Any) -> None: ...

    def call(
        self, method: str, path: str, answer: type[Answer] | None, **parts: Any
    ) -> Answer | None:
        """Send a request and read its answer, which is the message `answer`, or empty.

        parts: as `send` takes them. Raises ApiException, and urllib3's HTTPError if no
        answer comes.
        """
        response = self.send(method, path, **parts)
        try:
            if not 200 <= response.status <= 299:
                raise refusal(response)
            message = None if answer is None else _read(answer, response)
        except ApiException as error:
            error.method, error.url = method, self.configuration.host
            if error.data is None and not is_of_proctor(error.headers):
                self.close()  # another connection may lead to the server
            raise
        status, headers = response.status, response.headers
        self._on_answer(ApiResponse(status, headers, message, response.data))
        return message

    def send(
        self,
        method: str,
        path: str,
        *,
        path_parameters: Mapping[str, str] | None = None,
        query: Mapping[str, Any] | None = None,
        headers: Mapping[str, str | None] | None = None,
        more_headers: Mapping[str, str] | None = None,
        body: Message | bytes | BinaryIO | None = None,
        content_type: str = "application/json",
        timeout: Timeout | None = None,
        stream: bool = False,
    ) -> urllib3.BaseHTTPResponse:
        """Send a request: parameters that are None are left out.

        stream: the body is not read yet. The redirection of a GET is followed within
        the origin of the server; the answer is that redirection otherwise.
        """
        for name, value in (path_parameters or {}).items():
            path = path.replace("{" + name + "}", quote(value, safe=""))
        url = self.configuration.host.rstrip("/") + path
        if text := urlencode(_given(query), quote_via=quote):
            url += f"?{text}"
        lines = urllib3.HTTPHeaderDict(self.default_headers)
        lines["Accept"] = "application/json, application/problem+json"
        if self.configuration.access_token:
            lines["Authorization"] = f"Bearer {self.configuration.access_token}"
        if body is not None:
            lines["Content-Type"] = content_type
        for name, value in (_given(headers) | dict(more_headers or {})).items():
            lines[name] = value
        for left in reversed(range(_REDIRECTS_MAX)):
            response = self.pool_manager.request(
                method,
                url,
                body=body.to_json() if isinstance(body, Message) else body,
                headers=lines,
                timeout=_timeout(timeout),
                redirect=False,
                preload_content=not stream,
            )
            place = response.get_redirect_location()
            following = urljoin(url, place) if place else url
            is_near = urlsplit(following)[:2] == urlsplit(url)[:2]
            if method != "GET" or not place or not is_near or not left:
                break
            response.drain_conn()
            url = following
        return response


def refusal(response: urllib3.BaseHTTPResponse) -> ApiException:
    """Make the exception for an answer that is not a success; reads its body."""
    body, problem = response.data, None
    with contextlib.suppress(ValueError):  # a gateway's answer is no problem document
        problem = Problem.from_json(body)
    return ApiException(
        response.status,
        response.reason,
        body=body.decode(errors="replace"),
        data=problem,
        headers=response.headers,
    )


def with_http_info(
    operation: Callable[Arguments, Result],
    *arguments: Arguments.args,
    **named: Arguments.kwargs,
) -> ApiResponse[Result]:
    """Call an operation; returns its answer together with the status and the headers.

    with_http_info(control.get_run, run_id).headers["ETag"]
    """
    answers: list[ApiResponse[Result]] = []
    method: Any = operation
    api = copy(method.__self__)
    api.api_client = copy(api.api_client)
    api.api_client._on_answer = answers.append
    getattr(api, method.__name__)(*arguments, **named)
    return answers[-1]


def _given(parameters: Mapping[str, Any] | None) -> dict[str, str]:
    """The parameters that are not None, as text."""
    return {
        name: str(value).lower() if isinstance(value, bool) else str(value)
        for name, value in (parameters or {}).items()
        if value is not None
    }


def _ignore(_: ApiResponse[Any]) -> None:
    """Do nothing: `with_http_info` does not wait for this answer."""


def _timeout(timeout: Timeout | None) -> urllib3.Timeout | None:
    if timeout is None:
        return None
    if isinstance(timeout, tuple):
        return urllib3.Timeout(connect=timeout[0], read=timeout[1])
    return urllib3.Timeout(total=timeout)


def _read(message: type[Answer], response: urllib3.BaseHTTPResponse) -> Answer:
    try:
        return message.from_json(response.data)
    except ValueError as error:
        if is_cut(response):
            text = "the connection ended before the answer was whole"
            raise urllib3.exceptions.ProtocolError(text) from error
        raise ApiException(
            reason=f"the answer is not the message {message.__name__}: {error}",
            headers=response.headers,
        ) from error
