"""The exception of a call whose answer is not the message expected.

Written by hand, beside what is generated from the specification.
"""

from __future__ import annotations

from collections.abc import Mapping

from .models import Problem


class ApiException(Exception):
    """The server refused a request, or its answer is not what the operation promises.

    status: the HTTP status; 0 for a success that is not the message expected. Then what
        was requested may have been carried out.
    reason: the phrase of the status, or what is wrong with the message.
    data: the problem document; None if there is none, as in the refusal of a gateway.
    body: the text of the refusal. headers: the headers of the answer.
    method: of the request; empty where that is not known.
    """

    method = ""

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

    def __str__(self) -> str:
        if self.data is not None:
            return f"{self.data.detail} [{self.data.code}]"
        return f"{self.status} {self.reason}" if self.status else str(self.reason)
