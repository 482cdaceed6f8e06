"""One server and one robot for all tests of cells."""

from __future__ import annotations

import tempfile
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.support.cells.stop_cases import StopBench, stop_bench


@pytest.fixture(scope="package")
def shared_bench() -> Iterator[StopBench]:
    with tempfile.TemporaryDirectory() as folder, stop_bench(Path(folder)) as made:
        yield made


@pytest.fixture
def bench(shared_bench: StopBench) -> Iterator[StopBench]:
    """A test that fails in the middle of a trial leaves the next one a free cell."""
    yield shared_bench
    shared_bench.restore()
