"""Lists of a service, page by page."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterator
from typing import Any

_PAGES_MAX = 2000


def read_pages(
    read: Callable[[dict[str, Any]], Any],
    endless: Exception | None = None,
    **params: Any,
) -> Iterator[dict[str, Any]]:
    """Give one page of a list after another; each is read when it is needed.

    read: gives the page that parameters name. endless: is raised if the list has too
    many pages. A wrong service may never end its list, so a caller without `endless`
    limits the pages that it takes.
    """
    for number in itertools.count(1):
        page = read(params)
        yield page
        if page["next_cursor"] is None:
            return
        if endless is not None and number == _PAGES_MAX:
            raise endless
        params = params | {"cursor": page["next_cursor"]}
