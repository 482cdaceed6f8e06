"""Whose fault it is that a request got no answer, and whether it may be repeated.

Knows the exceptions of the HTTP library; sends nothing and judges nothing.
"""

import errno
from collections.abc import Iterator
from typing import Any

import httpx

# What this machine has no more of, or what the kit did to its own socket.
_OWN_ERRORS = frozenset(
    {
        *(errno.EBADF, errno.ENOTSOCK, errno.EMFILE, errno.ENFILE),
        *(errno.ENOBUFS, errno.ENOMEM, errno.EADDRNOTAVAIL),
    }
)
# By the texts of their rules, a repeat of these finds what the first one did.
_REPEATABLE_METHODS = frozenset({"GET", "HEAD", "OPTIONS", "DELETE"})
_REPEATABLE_OPERATIONS = frozenset(
    {"attach_worker", "predict", "heartbeat", "stop_run", "resume_run"}
)


def is_own_fault(error: BaseException) -> bool:
    """Say whether the kit's own side of the connection failed."""
    if isinstance(error, httpx.PoolTimeout):
        return True
    return any(
        isinstance(cause, OSError) and cause.errno in _OWN_ERRORS
        for cause in _causes(error)
    )


def _causes(error: BaseException | None) -> Iterator[BaseException]:
    seen: set[int] = set()
    while error is not None and id(error) not in seen:
        seen.add(id(error))
        yield error
        error = error.__cause__ or error.__context__


def is_repeatable(request: httpx.Request, operation_id: str | None) -> bool:
    """Say whether a client may send a request again that got no answer."""
    return (
        request.method in _REPEATABLE_METHODS
        or operation_id in _REPEATABLE_OPERATIONS
        or "idempotency-key" in request.headers
    ) and isinstance(request.stream, httpx.ByteStream)


class ConnectionTrace:
    """What happened to the connection of a request; given to the HTTP library."""

    def __init__(self) -> None:
        self._is_new = False
        self._has_answer = False

    def __call__(self, event: str, _info: dict[str, Any]) -> None:
        """Take an event of the HTTP library."""
        if event == "connection.connect_tcp.started":
            self._is_new = True
        elif event == "http11.receive_response_headers.complete":
            self._has_answer = True

    def was_closed_before_use(self, error: BaseException) -> bool:
        """Say whether the other side closed a kept connection as it was used again.

        Every HTTP server may close one that is idle, at any moment.
        """
        if self._is_new or self._has_answer:
            return False
        return isinstance(
            error, httpx.RemoteProtocolError | httpx.ReadError | httpx.WriteError
        )
