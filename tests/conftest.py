"""The fixture `server`, and what holds for every test process."""

import contextlib
import os
import signal
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

pytest.register_assert_rewrite("tests.support")

from tests.support.fast_tests import (  # noqa: E402 - after the line above
    pytest_collection,
    pytest_collection_finish,
    pytest_collection_modifyitems,
    pytest_pyfunc_call,
    pytest_runtest_protocol,
)
from tests.support.server.databases import database, postgresql  # noqa: E402
from tests.support.servers import ReferenceServer  # noqa: E402
from tests.support.tiers import pytest_configure  # noqa: E402

__all__ = [  # hooks and fixtures
    "database",
    "postgresql",
    "pytest_collection",
    "pytest_collection_finish",
    "pytest_collection_modifyitems",
    "pytest_configure",
    "pytest_pyfunc_call",
    "pytest_runtest_protocol",
]

# Environments that are made for one simulator or for Ray have no hypothesis.
with contextlib.suppress(ModuleNotFoundError):
    from hypothesis import HealthCheck, settings

    # How long an example takes says nothing on a machine that does other things, too.
    settings.register_profile(
        "any machine", deadline=None, suppress_health_check=[HealthCheck.too_slow]
    )
    settings.load_profile("any machine")

# A shell that starts pytest in the background makes it ignore SIGINT, and its children
# inherit that: tests of SIGINT would never end.
signal.signal(signal.SIGINT, signal.default_int_handler)

# A shell finds `proctor`, as in an environment that is activated.
os.environ["PATH"] += f"{os.pathsep}{Path(sys.executable).parent}"


@pytest.fixture(scope="session")
def anyio_backend() -> str:
    """Tests that are coroutine functions run on asyncio, as the programs do."""
    return "asyncio"


@pytest.fixture
def server(tmp_path: Path) -> Iterator[ReferenceServer]:
    """A server for one test."""
    with ReferenceServer(tmp_path) as server:
        yield server
