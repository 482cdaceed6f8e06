"""Calls of the API from inside: lists of more than one page."""

from __future__ import annotations

import asyncio
import json
import re
from typing import Any
from urllib.parse import parse_qs

import pytest
from starlette.types import Receive, Scope, Send

from reference_server.generated.problem_codes import PROBLEMS
from reference_server.http.pages.api_documents import ApiDocuments, Problem
from reference_server.http.problems import problem_response
from reference_server.rules.refusal import Refused

OUTER: dict[str, Any] = {"asgi": {}, "headers": [], "scheme": "http"}
PAGES = {"": ([1, 2], "b"), "b": ([3], "c"), "c": ([], None)}


def _documents(asked: list[dict[str, list[str]]]) -> ApiDocuments:
    """Of an API with one list, in three pages."""

    async def app(scope: Scope, _: Receive, send: Send) -> None:
        query = parse_qs(scope["query_string"].decode())
        asked.append(query)
        items, following = PAGES[query.get("cursor", [""])[0]]
        body = json.dumps({"items": items, "next_cursor": following}).encode()
        await send({"type": "http.response.start", "status": 200, "headers": []})
        await send({"type": "http.response.body", "body": body})

    return ApiDocuments(app, OUTER, "token")


async def _read(api: ApiDocuments, **query: object) -> list[int]:
    return [item async for page in api.pages("list", **query) for item in page["items"]]


def test_all_pages_of_a_list_are_read() -> None:
    asked: list[dict[str, list[str]]] = []
    assert asyncio.run(_read(_documents(asked), limit=2)) == [1, 2, 3]
    assert [query.get("cursor") for query in asked] == [None, ["b"], ["c"]]
    assert all(query["limit"] == ["2"] for query in asked)


def test_a_list_is_read_from_a_cursor_on() -> None:
    assert asyncio.run(_read(_documents([]), cursor="b")) == [3]


@pytest.mark.parametrize("code", PROBLEMS)
async def test_no_page_shows_an_advice_about_messages(code: str) -> None:
    """A refusal on a page names no member and no header of an answer."""
    answer = problem_response(Refused(code, "It was so.", act=PROBLEMS[code]["act"]))

    async def app(scope: Scope, receive: Receive, send: Send) -> None:
        await answer({**scope, "path": "/"}, receive, send)

    with pytest.raises(Problem) as refused:
        await ApiDocuments(app, OUTER, "token").get("runs")
    assert refused.value.detail.startswith("It was so.")
    assert not re.search(r"`|Retry-After|detail", refused.value.detail)
