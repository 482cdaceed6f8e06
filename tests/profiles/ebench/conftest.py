"""A server with the EBench profile for each test file, and a client of it."""

from collections.abc import Iterator

import httpx
import pytest

from tests.support.servers import ReferenceServer


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[ReferenceServer]:
    directory = tmp_path_factory.mktemp("server")
    with ReferenceServer(directory, PROCTOR_PROFILES="ebench") as server:
        yield server


@pytest.fixture
def http(server: ReferenceServer) -> Iterator[httpx.Client]:
    with server.client() as client:
        yield client
