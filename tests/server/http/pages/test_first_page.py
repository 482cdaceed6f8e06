"""No page waits for the templates: they are compiled while a person signs in."""

from __future__ import annotations

import asyncio
import threading
from collections.abc import Iterator

import pytest
from jinja2 import Environment
from starlette.applications import Starlette
from starlette.types import Message

from reference_record.pages import page_templates
from reference_server.assembly.nearest_path import UnknownPath
from reference_server.http.pages.page_routes import Pages
from reference_server.settings.allowed_hosts import ANY_HOST
from tests.support.pages.page_api import RESULT, PageApi, client_of, sign_in


class Compiled:
    """Each template that is compiled: its name, and in which thread."""

    def __init__(self, patch: pytest.MonkeyPatch) -> None:
        self.templates: list[tuple[str, int]] = []
        right = Environment.compile

        def compile_(
            environment: Environment, source: str, name: str, filename: str
        ) -> object:
            self.templates.append((name, threading.get_ident()))
            return right(environment, source, name, filename)

        patch.setattr(Environment, "compile", compile_)

    @property
    def names(self) -> set[str]:
        return {name for name, _ in self.templates}


@pytest.fixture
def compiled(monkeypatch: pytest.MonkeyPatch) -> Iterator[Compiled]:
    """As in a server that has just started."""
    caches = (page_templates._environment, page_templates.compile_templates)
    for one in caches:
        one.cache_clear()
    yield Compiled(monkeypatch)
    for one in caches:
        one.cache_clear()


LOGIN_NEEDS = {"login.html.j2", "layout.html.j2"}


async def test_the_first_page_after_the_sign_in_compiles_nothing(
    compiled: Compiled,
) -> None:
    api = PageApi()
    api.add("played", RESULT, None)
    async with client_of(api) as client:
        await sign_in(client, "alice")
        assert compiled.names >= {"run.html.j2", "parts/summary.html.j2"}
        compiled.templates.clear()
        for path in ("/pages/runs", "/pages/runs/played", "/pages/nothing"):
            assert (await client.get(path)).text
        await client.get("/pages/login")
        assert compiled.templates == []


async def test_the_sign_in_itself_does_not_wait(compiled: Compiled) -> None:
    """Expect the page sent before, and turns of others played meanwhile."""
    sent: list[set[str]] = []
    pages = Pages(UnknownPath([]), ANY_HOST, "")
    app = Starlette(routes=pages.routes())
    scope = {
        "type": "http",
        "method": "GET",
        "path": "/pages/login",
        "query_string": b"",
        "headers": [(b"host", b"server")],
    }

    async def receive() -> Message:
        return await asyncio.Future()

    async def send(message: Message) -> None:
        if message["type"] == "http.response.body":
            sent.append(compiled.names)

    await app(scope, receive, send)
    assert sent[-1] == LOGIN_NEEDS, "what else was compiled before the page was sent"
    here = threading.get_ident()
    later = {thread for name, thread in compiled.templates if name not in LOGIN_NEEDS}
    assert later, "the others were compiled then"
    assert here not in later, "in another thread than that of the event loop"
