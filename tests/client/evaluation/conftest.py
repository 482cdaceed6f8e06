"""A server for each test file, and a wire to it that loses answers."""

from collections.abc import Iterator

import pytest

from tests.support.client.faulty_proxy import FaultyProxy, serve_in_thread
from tests.support.servers import ReferenceServer


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[ReferenceServer]:
    with ReferenceServer(tmp_path_factory.mktemp("server")) as process:
        yield process


@pytest.fixture
def proxy(server: ReferenceServer) -> Iterator[FaultyProxy]:
    with serve_in_thread(FaultyProxy(server.url)) as proxy:
        yield proxy
