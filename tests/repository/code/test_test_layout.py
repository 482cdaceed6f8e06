"""How the tests are laid out: no test file depends on another one.

What several test files need is in tests/support/; fixtures are in a conftest.py.
"""

from collections import Counter
from pathlib import Path

import pytest

from tests.support.paths import ROOT
from tests.support.repository.imports import imports, module_of, name_of

FILES = sorted((ROOT / "tests").rglob("*.py"))


def is_test_module(module: str) -> bool:
    last = module.rpartition(".")[2]
    return module.startswith("tests.") and (
        last.startswith("test_")
        or last in ("conftest", "metaworld_checks", "ray_checks")
    )


MODULES = {module_of(path) for path in FILES if is_test_module(module_of(path))}


@pytest.mark.parametrize("path", FILES, ids=name_of)
def test_no_test_module_is_imported(path: Path) -> None:
    assert imports(path, module_of(path)) & MODULES - {module_of(path)} == set()


def test_names_of_test_files_are_unique() -> None:
    names = Counter(path.name for path in FILES if path.name.startswith("test_"))
    assert [name for name, count in names.items() if count > 1] == []
