"""Lists of a server, page by page."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from typing import Any, Protocol, TypeVar

from reference_client.protocol.connection import TIMEOUTS_S
from reference_client.protocol.retry_policy import RetryPolicy


class _Page(Protocol):
    next_cursor: str | None


Page = TypeVar("Page", bound=_Page)


def read_pages(
    retry_policy: RetryPolicy,
    operation: Callable[..., Page],
    *arguments: str,
    **choices: Any,
) -> Iterator[Page]:
    """The pages of a list; each is read when it is needed. Raises ProctorError.

    operation: of the generated client, with a `cursor` beside these arguments.
    """
    cursor: str | None = None
    while True:
        page = retry_policy.call(
            partial(
                operation,
                *arguments,
                cursor=cursor,
                _request_timeout=TIMEOUTS_S,
                **choices,
            )
        )
        yield page
        cursor = page.next_cursor
        if cursor is None:
            return
