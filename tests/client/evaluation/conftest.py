"""A server for each test file, and a wire to it that loses answers."""

from collections.abc import Iterator

import pytest

from tests.support.network.lossy_proxy import Proxy
from tests.support.servers import ReferenceServer


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[ReferenceServer]:
    with ReferenceServer(tmp_path_factory.mktemp("server")) as process:
        yield process


@pytest.fixture
def proxy(server: ReferenceServer) -> Iterator[Proxy]:
    with Proxy(server.url) as proxy:
        yield proxy
