"""A server with the FlagEval profile for each test file, a client, and a model."""

from collections.abc import Iterator

import httpx
import pytest

from conformance.policy.scripted_chat import ScriptedChat
from tests.support.profiles.flageval_client import KEY
from tests.support.push_runs import start_push_server
from tests.support.servers import ReferenceServer


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[ReferenceServer]:
    path = tmp_path_factory.mktemp("flageval")
    yield from start_push_server(path, PROCTOR_PROFILES="flageval")
    stored_files = [p.read_bytes() for p in path.rglob("*") if p.is_file()]
    assert KEY.encode() not in b"".join(stored_files)


@pytest.fixture
def client(server: ReferenceServer) -> Iterator[httpx.Client]:
    with server.client() as opened:
        yield opened


@pytest.fixture
def chat() -> Iterator[ScriptedChat]:
    with ScriptedChat("1") as server:
        yield server
