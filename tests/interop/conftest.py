"""A server, and programs that are built where `make interop` builds them."""

import signal
from collections.abc import Callable, Iterator

import pytest

from tests.interop.clients import Language
from tests.interop.scenarios import Program, Server
from tests.support.servers import TOKENS, ReferenceServer
from tools.interop import program_of


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Server]:
    server = ReferenceServer(tmp_path_factory.mktemp("interop"))

    def restart() -> str:
        server.end(signal.SIGKILL)
        server.start()
        return server.url

    yield Server(server.url, TOKENS["alice"], restart)
    server.end(signal.SIGKILL)


@pytest.fixture(scope="session")
def built() -> Callable[[Language], Program]:
    """Build the programs of a language, once for all tests of this process."""
    programs: dict[str, Program] = {}

    def build(language: Language) -> Program:
        if language.name not in programs:
            if missing := language.missing():
                skip_or_fail(language, missing)
            language.build()
            programs[language.name] = program_of(language)
        return programs[language.name]

    return build


def skip_or_fail(language: Language, missing: str) -> None:
    """Node.js is required for the tests; the other toolchains are optional."""
    if language.language == "typescript":
        pytest.fail(missing, pytrace=False)
    pytest.skip(missing)
