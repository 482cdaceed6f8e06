"""A file that is written again is the old one or the new one, never a half."""

import ast
import contextlib
import errno
import os
import re
import stat
from collections.abc import Callable
from pathlib import Path

import pytest

from reference_record.command_line.replaced_file import (
    check_writable,
    replace_file,
    replacing,
)
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


@pytest.mark.parametrize("mode", [0o600, 0o640, None])
def test_a_draft_is_never_more_open_than_its_file(
    mode: int | None, tmp_path: Path
) -> None:
    file = tmp_path / "result.json"
    if mode is not None:
        file.write_text("old")
        file.chmod(mode)
    with replacing(file) as draft:
        draft_mode = stat.S_IMODE(draft.stat().st_mode)
        draft.write_text("new")
    if mode is None:  # as any new file of this process
        (tmp_path / "other").touch()
        mode = draft_mode
        assert stat.S_IMODE((tmp_path / "other").stat().st_mode) == mode
    assert draft_mode & ~mode == 0
    assert (stat.S_IMODE(file.stat().st_mode), file.read_text()) == (mode, "new")


def test_a_name_may_be_as_long_as_a_disk_takes(tmp_path: Path) -> None:
    file = tmp_path / ("n" * 255)
    for text in ("one", "two"):
        replace_file(file, text)
        assert file.read_text() == text
    assert list(tmp_path.iterdir()) == [file]


def _refuse(number: int) -> Callable[..., None]:
    def refuse(*_: object) -> None:
        raise OSError(number, os.strerror(number))

    return refuse


@pytest.mark.parametrize(
    ("place", "number"),
    [
        ("pathlib.Path.replace", errno.EBUSY),  # it is mounted alone
        ("pathlib.Path.replace", errno.EPERM),  # of another owner, in /tmp
        ("os.open", errno.EACCES),  # its folder takes no new file
        ("os.open", errno.EROFS),
    ],
)
def test_a_file_that_cannot_be_replaced_is_written_in_its_place(
    place: str, number: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    file = tmp_path / "result.json"
    file.write_text("a longer old text")
    number_of_file = file.stat().st_ino
    with monkeypatch.context() as patch:
        patch.setattr(place, _refuse(number))
        replace_file(file, "new")
    assert (file.read_text(), file.stat().st_ino) == ("new", number_of_file)
    assert list(tmp_path.iterdir()) == [file]


@pytest.mark.parametrize(
    ("name", "error"),
    [
        ("there", None),
        ("new", None),
        ("link", None),
        ("/dev/null", None),
        ("folder", errno.EISDIR),
        ("missing/new", errno.ENOENT),
        ("there/new", errno.ENOTDIR),
    ],
)
def test_whether_a_file_can_be_written_is_known_before(
    name: str, error: int | None, tmp_path: Path
) -> None:
    """Expect what writing it would raise, and that nothing is changed or left."""
    (tmp_path / "there").write_text("old")
    (tmp_path / "link").symlink_to("there")
    (tmp_path / "folder").mkdir()
    before = sorted(tmp_path.rglob("*"))
    raised = None
    try:
        check_writable(tmp_path / name)
    except OSError as refused:
        raised = refused.errno
    assert raised == error
    assert sorted(tmp_path.rglob("*")) == before
    assert (tmp_path / "there").read_text() == "old"


@pytest.mark.parametrize("number", [errno.EROFS, errno.EACCES, errno.ENOSPC])
def test_a_folder_that_takes_no_file_is_known_before(
    number: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    with monkeypatch.context() as patch:
        patch.setattr("os.open", _refuse(number))
        patch.setattr("pathlib.Path.open", _refuse(number))
        with pytest.raises(OSError, match=re.escape(os.strerror(number))):
            check_writable(tmp_path / "new")


def test_a_full_disk_leaves_the_file(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    file = tmp_path / "result.json"
    file.write_text("old")
    with monkeypatch.context() as patch:
        patch.setattr("os.open", _refuse(errno.ENOSPC))
        with pytest.raises(OSError, match="No space left"):
            replace_file(file, "new")
    assert file.read_text() == "old"


def test_every_name_of_a_file_has_the_new_text(tmp_path: Path) -> None:
    file, second = tmp_path / "result.json", tmp_path / "second"
    file.write_text("old")
    second.hardlink_to(file)
    replace_file(file, "new")
    assert second.read_text() == "new"


def test_a_device_and_an_open_file_are_written_themselves(tmp_path: Path) -> None:
    """Also where a link leads there, as /dev/stdout does."""
    device = Path("/dev/null")
    replace_file(device, "x")
    assert device.is_char_device()
    output, link = tmp_path / "output", tmp_path / "link"
    with output.open("w") as file:
        open_file = Path(f"/proc/self/fd/{file.fileno()}")
        link.symlink_to(open_file)
        for place in (open_file, link):
            replace_file(place, "x")
            assert output.stat().st_ino == os.fstat(file.fileno()).st_ino


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
