"""A server, and the packages of clients/ built where `make interop` builds them."""

from __future__ import annotations

import signal
from collections.abc import Iterator

import pytest

from tests.interop.clients import PACKAGES, Language
from tests.interop.scenarios import Program, Server
from tests.support.servers import TOKENS, ReferenceServer


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Server]:
    server = ReferenceServer(tmp_path_factory.mktemp("interop"))

    def restart() -> str:
        server.end(signal.SIGKILL)
        server.start()
        return server.url

    yield Server(server.url, TOKENS["alice"], restart)
    server.end(signal.SIGKILL)


def built(language: Language) -> Program:
    language.build()
    command = language.command(language.directory)
    return Program(language.name, command, language.env())


@pytest.fixture(scope="module")
def typescript() -> Program:
    if missing := PACKAGES["typescript"].missing():
        need = f"{missing}: clients/typescript is tested with Node.js 20.3 or newer"
        pytest.fail(need, pytrace=False)
    return built(PACKAGES["typescript"])


@pytest.fixture(scope="module")
def cpp() -> Program:
    if missing := PACKAGES["cpp"].missing():
        pytest.skip(f"set-up brings no C++: {missing}")
    return built(PACKAGES["cpp"])
