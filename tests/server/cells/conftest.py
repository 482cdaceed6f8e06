"""One server and one robot for all tests of cells."""

from __future__ import annotations

import tempfile
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.support.cells.stop_cases import StopBench, stop_bench


@pytest.fixture(scope="package")
def bench() -> Iterator[StopBench]:
    with tempfile.TemporaryDirectory() as folder, stop_bench(Path(folder)) as made:
        yield made
