"""One server for the tests of the client, its users, and a folder with policies."""

import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.support.client.command import POLICIES, Proctor
from tests.support.client.direct_client import DirectClient
from tests.support.servers import TOKENS, ReferenceServer


@pytest.fixture(scope="session")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[ReferenceServer]:
    folder = tmp_path_factory.mktemp("server")
    with ReferenceServer(folder, PROCTOR_RECORD_IMPORTS="on") as server:
        yield server


@pytest.fixture(autouse=True)
def _no_terminal(monkeypatch: pytest.MonkeyPatch) -> None:
    """The environment of the tests may name a width, which wraps what is piped, too."""
    monkeypatch.delenv("COLUMNS", raising=False)


@pytest.fixture
def direct(server: ReferenceServer) -> Iterator[DirectClient]:
    with DirectClient(server.url) as direct:
        yield direct


@pytest.fixture
def proctor(server: ReferenceServer, capsys: pytest.CaptureFixture[str]) -> Proctor:
    return Proctor(server.url, capsys)


@pytest.fixture
def policy_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with the policies, in which the command is called."""
    (tmp_path / "policies.py").write_text(POLICIES)
    monkeypatch.chdir(tmp_path)
    monkeypatch.syspath_prepend(str(tmp_path))
    monkeypatch.delitem(sys.modules, "policies", raising=False)
    monkeypatch.setenv("PROCTOR_TOKEN", TOKENS["alice"])
    return tmp_path


@pytest.fixture
def no_proxies(monkeypatch: pytest.MonkeyPatch) -> None:
    for name in ("http_proxy", "https_proxy", "all_proxy", "no_proxy", "proctor_proxy"):
        monkeypatch.delenv(name, raising=False)
        monkeypatch.delenv(name.upper(), raising=False)
