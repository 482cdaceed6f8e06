"""A server that may call policies on this machine, and the key of such policies."""

from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.support.client.command import Proctor
from tests.support.client.policy_apps import KEY
from tests.support.push_runs import start_push_server
from tests.support.servers import ReferenceServer


@pytest.fixture
def policy_key(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PROCTOR_POLICY_KEY", KEY)


@pytest.fixture(scope="module")
def push_server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[ReferenceServer]:
    yield from start_push_server(tmp_path_factory.mktemp("server"))


@pytest.fixture
def proctor(
    request: pytest.FixtureRequest, proctor: Proctor, policy_folder: Path
) -> Proctor:
    """The command in a folder that has the MAPPING of the test's file as `m.toml`."""
    (policy_folder / "m.toml").write_text(request.module.MAPPING)
    return proctor
