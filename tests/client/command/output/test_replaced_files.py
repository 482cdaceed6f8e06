"""A file that is written again is the old one or the new one, never a half."""

import ast
import contextlib
import stat
from pathlib import Path

import pytest

from reference_record.command_line.replaced_file import replace_file, replacing
from tests.support.paths import ROOT

# Packages whose files people keep, and the modules that write them.
PACKAGES = ("reference_client", "reference_record", "conformance")
WRITERS = {"replaced_file.py"}
IN_PLACE = {"write_text", "write_bytes"}


def test_a_file_is_replaced_whole(tmp_path: Path) -> None:
    """By a text and by bytes, through a link, with the rights that it has."""
    file, link = tmp_path / "result.json", tmp_path / "latest"
    replace_file(file, "one\n")
    file.chmod(0o640)
    link.symlink_to(file)
    replace_file(link, b"two\n")
    assert link.is_symlink()
    assert file.read_text() == "two\n"
    assert stat.S_IMODE(file.stat().st_mode) == 0o640
    assert sorted(path.name for path in tmp_path.iterdir()) == ["latest", "result.json"]


@pytest.mark.parametrize("error", [OSError(28, "No space left"), KeyboardInterrupt()])
def test_a_file_stays_as_it_was_until_the_new_one_is_whole(
    error: BaseException, tmp_path: Path
) -> None:
    file = tmp_path / "result.json"
    file.write_text("old")
    with contextlib.suppress(type(error)), replacing(file) as draft:
        draft.write_text("hal")
        raise error
    assert file.read_text() == "old"
    assert [path.name for path in tmp_path.iterdir()] == ["result.json"]


def test_a_device_is_written_itself() -> None:
    device = Path("/dev/null")
    replace_file(device, "x")
    assert device.is_char_device()


def test_no_other_module_writes_a_file_in_its_place() -> None:
    found = []
    for package in PACKAGES:
        for path in sorted((ROOT / package).rglob("*.py")):
            if path.name in WRITERS:
                continue
            calls = (n for n in ast.walk(ast.parse(path.read_bytes())))
            names = {n.attr for n in calls if isinstance(n, ast.Attribute)}
            found += [f"{path.name}: {name}" for name in sorted(names & IN_PLACE)]
    assert found == []
