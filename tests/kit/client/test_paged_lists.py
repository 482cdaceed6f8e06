"""Lists are read page by page, each page when it is needed, up to a limit."""

from itertools import islice
from typing import Any

import pytest

from conformance.exchanges.pages import read_pages
from conformance.verdicts.expect import SetUpFailed


class PagedList:
    """A list of so many pages, or of pages without end (None)."""

    def __init__(self, pages: int | None) -> None:
        self.pages = pages
        self.asked: list[dict[str, Any]] = []

    def read(self, params: dict[str, Any]) -> dict[str, Any]:
        self.asked.append(params)
        number = int(params.get("cursor", "0")) + 1
        return {
            "runs": [number],
            "next_cursor": None if number == self.pages else str(number),
        }


def test_a_list_is_read_to_its_end() -> None:
    paged = PagedList(3)
    assert [page["runs"] for page in read_pages(paged.read, limit=5)] == [[1], [2], [3]]
    assert paged.asked == [
        {"limit": 5},
        {"limit": 5, "cursor": "1"},
        {"limit": 5, "cursor": "2"},
    ]


def test_a_page_that_is_not_needed_is_not_read() -> None:
    paged = PagedList(None)
    assert len(list(islice(read_pages(paged.read), 2))) == len(paged.asked) == 2


def test_a_list_without_an_end_breaks_its_rule() -> None:
    endless = SetUpFailed("`list_entries` does not end", breaks="BRD-007")
    pages = read_pages(PagedList(None).read, endless)
    with pytest.raises(SetUpFailed, match="`list_entries` does not end"):
        list(pages)
