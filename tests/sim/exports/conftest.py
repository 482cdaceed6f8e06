"""A folder in which a test plays a record and exports it."""

from pathlib import Path

import pytest


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A folder with an empty folder `recordings`."""
    (tmp_path / "recordings").mkdir()
    return tmp_path
