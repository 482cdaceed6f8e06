"""The exception of a call whose answer is not the message expected.

Written by hand, beside what is generated from the specification.
"""

from __future__ import annotations

from collections.abc import Mapping
from urllib.parse import urljoin, urlsplit

from .models import Problem
from .transport.fault_texts import (
    cure_of_page,
    describe_page,
    is_of_proctor,
    who_answered,
)
from .transport.proxy_route import find_route

# A gateway that answers so never lets this request pass.
_UNPASSABLE = frozenset({400, 405, 411, *range(413, 418), 421, 426, 431, 501, 505})


class ApiException(Exception):
    """The server refused a request, or its answer is not what the operation promises.

    status: the HTTP status; 0 for a success that is not the message expected. Then what
        was requested may have been carried out.
    reason: the phrase of the status, or what is wrong with the message.
    data: the problem document; None if there is none, as in the refusal of a gateway.
    body: the text of the refusal. headers: the headers of the answer.
    method: of the request, and url: of the server; empty where they are not known.
    """

    method = url = ""

    def __init__(
        self,
        status: int = 0,
        reason: str | None = None,
        *,
        body: str | None = None,
        data: Problem | None = None,
        headers: Mapping[str, str] | None = None,
    ) -> None:
        super().__init__(status, reason)
        self.status = status
        self.reason = reason
        self.body = body
        self.data = data
        self.headers: Mapping[str, str] = {} if headers is None else headers

    @property
    def retry_after_s(self) -> float | None:
        """The server's Retry-After in seconds; None without one, and for a date."""
        text = self.headers.get("Retry-After", "")
        return float(text) if text.isdecimal() else None

    @property
    def location(self) -> str | None:
        """Where the answer redirects to, as the server wrote it; None if it does not."""
        is_redirect = 300 <= self.status < 400 and self.status != 304
        return self.headers.get("Location") if is_redirect else None

    def may_repeat(self, *, has_answered: bool) -> bool:
        """Whether the same request can succeed later.

        The server says so, or a gateway has failed. has_answered: whether a server of
        Proctor has answered there before; then a page in its place may soon be gone.
        A repeat executes nothing twice only where the request carries its key:
        Idempotency-Key, attach_key or seq.
        """
        if self.data is not None:
            return self.data.retryable
        is_page = describe_page(self.headers) is not None
        if self.status in _UNPASSABLE or (not self.status and not is_page):
            return False
        is_of_gateway = self.status == 429 or self.status >= 500
        return is_of_gateway or (has_answered and not is_of_proctor(self.headers))

    def __str__(self) -> str:
        if self.data is not None:
            return f"{self.data.detail} [{self.data.code}]"
        what = f"{self.status} {self.reason}" if self.status else str(self.reason)
        if not self.url:
            return what
        route = find_route(self.url)
        cure = self._new_place() or cure_of_page(route)
        return f"{who_answered(self.url, route)} answered {what}. {cure}"

    def _new_place(self) -> str:
        """Say where the answer redirects to, without what may be a secret."""
        if self.location is None:
            return ""
        place = urlsplit(urljoin(self.url, self.location))
        base, version, _ = place.path.partition("/v1")
        base = f"{place.scheme}://{place.netloc.rpartition('@')[2]}{base}"
        if version:
            return f"The server has moved to {base}: give that as the base URL."
        return f"It redirects to {base}."
