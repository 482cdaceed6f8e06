"""Whose fault it is that a request got no answer, and whether it may be repeated.

Knows the errors of the operating system; sends nothing and judges nothing.
"""

import errno
from collections.abc import Container, Iterator

# Errors of this machine, which has run out of something, or of the kit's own socket:
# they prove nothing about the server.
_OWN_ERRORS = frozenset(
    {
        *(errno.EBADF, errno.ENOTSOCK, errno.EMFILE, errno.ENFILE),
        *(errno.ENOBUFS, errno.ENOMEM, errno.EADDRNOTAVAIL),
    }
)
# The rules of these operations say that a repeat has the effect of the first request.
_REPEATABLE_METHODS = frozenset({"GET", "HEAD", "OPTIONS", "DELETE"})
_REPEATABLE_OPERATIONS = frozenset(
    {"attach_worker", "predict", "heartbeat", "stop_run", "resume_run"}
)


def is_own_fault(error: BaseException) -> bool:
    """Say whether the kit's own side of the connection failed."""
    return any(
        isinstance(cause, OSError) and is_own_error(cause) for cause in causes_of(error)
    )


def is_own_error(error: OSError) -> bool:
    """Say whether this machine or the kit caused an error of a socket."""
    return error.errno in _OWN_ERRORS


def causes_of(error: BaseException | None) -> Iterator[BaseException]:
    """Give the error, and those that it was raised from."""
    visited: set[int] = set()
    while error is not None and id(error) not in visited:
        visited.add(id(error))
        yield error
        error = error.__cause__ or error.__context__


def is_repeatable(
    method: str, headers: Container[str], operation_id: str | None
) -> bool:
    """Say whether a client may send a request again that got no answer.

    headers: their names in lower case.
    """
    return (
        method in _REPEATABLE_METHODS
        or operation_id in _REPEATABLE_OPERATIONS
        or "idempotency-key" in headers
    )
