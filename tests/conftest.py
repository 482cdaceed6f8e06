"""The fixture `server`, and what holds for every test process."""

import signal
from collections.abc import Iterator
from pathlib import Path

import pytest

pytest.register_assert_rewrite("tests.support")

from tests.support.servers import ReferenceServer  # noqa: E402 - after the line above

# A shell that starts pytest in the background makes it ignore SIGINT, and its children
# inherit that: tests of SIGINT would never end.
signal.signal(signal.SIGINT, signal.default_int_handler)


@pytest.fixture
def server(tmp_path: Path) -> Iterator[ReferenceServer]:
    """A server for one test."""
    with ReferenceServer(tmp_path) as server:
        yield server
