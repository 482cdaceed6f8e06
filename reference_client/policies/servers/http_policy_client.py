"""A client of policy servers over HTTP: a request is a POST to one URL.

The formats and the names are those of the mapping file. A request without a response is
repeated.
"""

from __future__ import annotations

import contextlib
from collections.abc import Collection, Mapping
from errno import ETIMEDOUT
from http.client import HTTPException, IncompleteRead
from typing import Any, Self
from urllib.parse import urljoin

import urllib3
from proctor_client import ProxyFault
from proctor_client.cut_answers import is_cut
from proctor_client.transport.fault_texts import NO_PASSWORD

from reference_client.errors import ProctorError, innermost_reason
from reference_client.policies.servers.bounded_answers import (
    AnswerTooLong,
    HttpAnswer,
    read_whole,
)
from reference_client.policies.servers.server_faults import (
    beginning,
    check_answer,
    describe_format,
    describe_key,
    error_text,
    failed,
    key_of,
    last_exception,
    moved,
    text_of,
    who_speaks_at,
    without_numbers,
)
from reference_client.policies.servers.server_transport import (
    Silent,
    Unreached,
    describe_no_way,
    fault_of,
    first_contact,
    http_connections,
    in_its_place,
    repeat_until_reached,
    report_answer_read,
    report_request_sent,
    route_to,
)
from reference_client.policies.servers.wire_formats import BadMessage, pack, unpack
from reference_client.policies.servers.wire_settings import (
    FIRST_CONTACT_S,
    LIMIT_OF_ANSWERS,
    ServerSettings,
)
from reference_client.protocol.connection_advice import causes_of

KEY = "PROCTOR_POLICY_KEY"
CONNECT_S = 5.0
FIRST_ANSWER_S = 10.0
_SUCCESSES = range(200, 300)  # where no numbers are read from the answer
RETRY_STATUSES = (429, 502, 503, 504)
_MEDIA_TYPES = {"json": "application/json", "msgpack": "application/msgpack"}


class HttpPolicyClient:
    """The server at `url`, http:// or https://, which is posted every request.

    PROCTOR_POLICY_KEY of the environment is sent as bearer token. retry_timeout_s: how
    long an unreachable server is retried.
    """

    def __init__(
        self, url: str, settings: ServerSettings, *, retry_timeout_s: float = 60.0
    ) -> None:
        self.url = url
        self._settings = settings
        self._retry_timeout_s = retry_timeout_s
        self._pool = http_connections(url, maxsize=1)

    def connected(self) -> Self:
        """Itself, if an HTTP server answers a GET, whatever its status."""
        with first_contact(self.url):
            self._call("GET", self.url, None, FIRST_CONTACT_S, FIRST_ANSWER_S)
        return self

    def infer(self, request: Mapping[str, Any]) -> Any:
        """Raises ProctorError `policy_failed`, with the error text of the server."""
        answer = self._post(self.url, request)
        try:
            return self._read(self.url, answer)
        except BadMessage as error:
            other = describe_format(self.url, answer.data, self._settings.format)
            shown = beginning(answer.data, answer.media_type)
            what = f"sent an answer that {error}; {shown}{in_its_place(self.url)}"
            raise failed(self.url, other or what) from error

    def begin_episode(self, message: Mapping[str, Any] | None) -> None:
        """message: posted to `reset_path` before the first request of an episode."""
        path = self._settings.reset_path
        if message is not None or path is not None:
            url = urljoin(self.url, path or "")
            # Any answer acknowledges it, as long as it reports no error.
            with contextlib.suppress(BadMessage):
                self._read(url, self._post(url, message, _SUCCESSES))

    def without_numbers(self, answer: Any, why: str) -> ProctorError:
        return without_numbers(self.url, answer, why, KEY)

    def close(self) -> None:
        self._pool.clear()

    def _post(
        self,
        url: str,
        message: Mapping[str, Any] | None,
        accepted: Collection[int] = (200,),
    ) -> HttpAnswer:
        """The answer of an accepted status; message: None for one without a body."""
        settings = self._settings
        if settings.envelope is not None and message is not None:
            message = {settings.envelope: pack(message, settings.format).decode()}
        answer = self._call(
            "POST",
            url,
            b"" if message is None else pack(message, settings.format),
            self._retry_timeout_s,
            settings.answer_s,
        )
        if answer.status not in accepted:
            raise failed(url, _answered(url, answer))
        return answer

    def _read(self, url: str, answer: HttpAnswer) -> Any:
        value = unpack(answer.data, self._settings.format)
        if isinstance(value, str) and value.lstrip()[:1] in ("[", "{"):
            value = unpack(value, self._settings.format)  # JSON text within JSON
        check_answer(url, value, KEY)
        return value

    def _call(
        self,
        method: str,
        url: str,
        content: bytes | None,
        retry_timeout_s: float,
        answer_s: float,
    ) -> HttpAnswer:
        """One request, repeated without a response and on retryable statuses."""

        def attempt() -> HttpAnswer:
            headers = _headers(self._settings.format, content)
            answer = request_once(
                self._pool,
                method,
                url,
                content=content,
                headers=headers,
                answer_s=answer_s,
                limit="" if content is None else LIMIT_OF_ANSWERS,
            )
            wrong = wrong_server(url, answer)
            if wrong is not None:
                raise failed(url, wrong)
            if answer.status in RETRY_STATUSES:
                raise Unreached(_answered(url, answer))
            return answer

        return repeat_until_reached(attempt, url, retry_timeout_s)


def request_once(
    pool: urllib3.PoolManager,
    method: str,
    url: str,
    *,
    content: bytes | None,
    headers: dict[str, str],
    answer_s: float,
    limit: str = "",
) -> HttpAnswer:
    """Raises Unreached, Silent, or ProctorError for what the next attempt meets again.

    answer_s: how long the whole answer may take. limit: says who sets that.
    """
    response: urllib3.BaseHTTPResponse | None = None
    if content is not None:
        report_request_sent(url, len(content))
    try:
        response = pool.request(
            method,
            url,
            body=content,
            headers=headers,
            timeout=urllib3.Timeout(connect=CONNECT_S, read=answer_s),
            redirect=False,
            preload_content=False,
        )
        answer = _checked(read_whole(response))
    except AnswerTooLong as error:
        raise failed(url, str(error)) from error
    except urllib3.exceptions.ReadTimeoutError as error:
        what = f"within {answer_s:g} s" + (f"; {limit}" if limit else "")
        if response is not None:
            what = f"began its answer, and did not end it {what}"
            raise failed(url, what) from error
        raise _unanswered(url, what, error, is_first=content is None) from error
    except urllib3.exceptions.LocationValueError as error:
        raise failed(url, f"has an invalid URL: {error}") from error
    except urllib3.exceptions.ProtocolError as error:
        raise _broken_answer(url, error) from error
    except urllib3.exceptions.HTTPError as error:
        raise fault_of(url, error) from error
    if content is not None:
        report_answer_read(url, len(answer.data))
    return answer


def _unanswered(url: str, what: str, error: Exception, *, is_first: bool) -> Exception:
    """is_first: whether nothing is known of the server yet."""
    if any(getattr(cause, "errno", None) == ETIMEDOUT for cause in causes_of(error)):
        return fault_of(url, error)  # of probes, and not of the limit
    if is_first:
        return failed(url, f"did not answer {what}: {who_speaks_at(url)}")
    return Silent(f"did not answer {what}")


def _checked(answer: HttpAnswer) -> HttpAnswer:
    if answer.data and is_cut(answer):  # an empty one may be all that is said
        raise Unreached(f"broke off its answer: {len(answer.data)} bytes came")
    return answer


def _broken_answer(url: str, error: urllib3.exceptions.ProtocolError) -> Unreached:
    """Says how much of an answer came; without any, who may be there instead."""
    reason = innermost_reason(error)
    what = f"closed the connection without an answer ({reason}): "
    for cause in causes_of(error):
        if isinstance(cause, IncompleteRead):
            return Unreached(f"broke off its answer: {_came(cause)}")
        if isinstance(cause, HTTPException) and not isinstance(cause, OSError):
            what = f"is no HTTP server ({reason}): "
    return Unreached(what, lambda: who_speaks_at(url))


def _came(cut: IncompleteRead) -> str:
    partial: Any = cut.partial  # urllib3's own kind has their number in their place
    came = partial if isinstance(partial, int) else len(partial)
    if not cut.expected:
        return f"{came} bytes came, and there were to be more"
    return f"{came} of {came + cut.expected} bytes came"


def wrong_server(url: str, answer: HttpAnswer) -> str | None:
    """Describes a WebSocket server, a redirect and a refused key; else None."""
    if answer.status == NO_PASSWORD and route_to(url).url:
        phrase = f"{answer.status} {answer.reason or ''}".strip()
        return describe_no_way(url, ProxyFault(phrase, answer.status))
    if answer.status == 426:
        return (
            "is a WebSocket server: it is --policy ws://…, openpi:ws://… or "
            f"vla-eval:ws://…{in_its_place(url)}"
        )
    if answer.status in (301, 302, 303, 307, 308):
        what = moved(url, answer.status, answer.headers.get("Location"))
        return f"{what}{in_its_place(url)}"
    if answer.status in (401, 403):
        what = _answered(url, answer)
        return f"{what}; {describe_key(KEY)}"
    return None


def _answered(url: str, answer: HttpAnswer) -> str:
    return f"answered {answer.status}{_said(answer)}{in_its_place(url)}"


def _headers(wire_format: str, content: bytes | None) -> dict[str, str]:
    media_type = _MEDIA_TYPES[wire_format.partition("-")[0]]
    headers = {"Accept": media_type}
    if content:
        headers["Content-Type"] = media_type
    key = key_of(KEY)
    return headers | ({"Authorization": f"Bearer {key}"} if key else {})


def _said(answer: HttpAnswer) -> str:
    """The error text of a response, for the policy's author."""
    text = text_of(answer.data[:65536], answer.media_type)
    try:
        return f": {error_text(unpack(text, 'json'))}"
    except BadMessage:
        if text.lstrip().startswith("<"):
            return f"; {beginning(answer.data, answer.media_type)}"
        return f": {last_exception(text)}" if text.strip() else ""
