"""A server that may call policies on this machine, and a client of it."""

from collections.abc import Iterator

import httpx
import pytest

from tests.support.push_runs import start_push_server
from tests.support.servers import ReferenceServer


@pytest.fixture(scope="module")
def push_server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[ReferenceServer]:
    yield from start_push_server(tmp_path_factory.mktemp("push_server"))


@pytest.fixture
def client(push_server: ReferenceServer) -> Iterator[httpx.Client]:
    with push_server.client() as opened:
        yield opened
