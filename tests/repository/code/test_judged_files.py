"""Which files `make lint` and the tests of the code judge: ours, not people's own."""

import fnmatch
import shutil
import sys
import tomllib
from pathlib import Path

import pytest

from tests.support.paths import ROOT
from tests.support.processes import run_program
from tests.support.repository.imports import HAND_WRITTEN, entries_of_git, is_ours

PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text())["tool"]
UNTIDY = "import sys\ndef f( x ):\n  print(y)\n"
FOLDERS = {path.relative_to(ROOT).parts[0] for path in HAND_WRITTEN}
# README and docs/ have people write or copy these; the folder is what they add.
PEOPLES = ["evaluate.py", "my_env.py", "proctor_simulator.py", "lab/kitchen.py"]


@pytest.mark.parametrize("name", PEOPLES)
def test_files_of_people_are_not_judged(name: str, tmp_path: Path) -> None:
    assert not is_ours(ROOT / name)
    shutil.copy(ROOT / "pyproject.toml", tmp_path)
    for path in (tmp_path / name, tmp_path / "tools" / "tidy.py"):
        path.parent.mkdir(exist_ok=True)
        path.write_text(UNTIDY)
    command = [sys.executable, "-m", "ruff", "check", "--show-files", "."]
    listed = run_program(command, cwd=tmp_path, check=True).stdout
    assert {Path(line).name for line in listed.splitlines()} == {
        "pyproject.toml",
        "tidy.py",
    }


def test_every_folder_with_our_python_is_judged() -> None:
    assert entries_of_git() >= FOLDERS
    assert set(PROJECT["mypy"]["files"]) == FOLDERS
    patterns = [name for name in PROJECT["ruff"]["include"] if "/" in name]
    for folder in FOLDERS:
        file = f"{folder}/**/*.py"
        assert any(fnmatch.fnmatchcase(file, pattern) for pattern in patterns), folder
    assert set(PROJECT["ruff"]["lint"]["isort"]["known-first-party"]) == FOLDERS


@pytest.mark.parametrize("name", ["README.md", "tools/new.py", "tests/a/new.py"])
def test_what_is_added_to_our_folders_is_judged(name: str) -> None:
    assert is_ours(ROOT / name)
