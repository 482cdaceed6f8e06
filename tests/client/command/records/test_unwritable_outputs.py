"""An output that cannot be written: every command names its place and the way out."""

from pathlib import Path

import msgspec
import pytest

from reference_client.command.main import main
from reference_record.command_line.click_commands import WrongUsage
from reference_record.command_line.written_output import whole_or_gone, writing
from reference_record.pages import static_pages
from reference_sim.exports import __main__ as exports
from reference_sim.replay import __main__ as replay
from tests.support.record.played_records import save_calibration_record


@pytest.fixture
def taken(tmp_path: Path) -> Path:
    """A file where a folder would have to be: also root can write nothing in it."""
    path = tmp_path / "taken"
    path.write_text("")
    return path


@pytest.fixture(scope="module")
def record(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("record")
    return save_calibration_record(folder / "run-1.proctor", folder)


@pytest.mark.parametrize(
    ("command", "option"),
    [
        ("report missing.proctor -o TAKEN/report", "-o"),  # before it is read
        ("video run_1 --episode 0 -o TAKEN/videos/a", "-o"),
        ("run --policy mine.py:P --benchmark tabletop --save TAKEN/saved", "--save"),
    ],
)
def test_a_command_names_the_place_and_its_option(
    command: str,
    option: str,
    taken: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:
    assert main(command.replace("TAKEN", str(taken)).split()) == 2
    said = capsys.readouterr().err
    assert said.startswith(f"proctor: {taken}/")
    assert said.count("\n") == 1
    end = f" cannot be written (Not a directory); {option} names another place\n"
    assert said.endswith(end)


@pytest.fixture
def nothing_simulated(
    taken: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> pytest.CaptureFixture[str]:
    """The output of a replay that could neither begin nor keep its key."""
    monkeypatch.setenv("XDG_CONFIG_HOME", str(taken))
    monkeypatch.delattr(replay, "replay_record")
    return capsys


@pytest.mark.parametrize(
    ("words", "place"), [("--signing-key TAKEN/a/key", "a/key"), ("", "proctor/signi")]
)
def test_a_replay_needs_its_key_before_it_simulates(
    words: str,
    place: str,
    taken: Path,
    record: Path,
    nothing_simulated: pytest.CaptureFixture[str],
) -> None:
    given = words.replace("TAKEN", str(taken)).split()
    assert replay.main([str(record), *given]) == 2
    said = nothing_simulated.readouterr().err
    assert said.startswith(f"proctor replay: {taken}/{place}")
    cure = "--signing-key names another file, and --no-verdict signs nothing\n"
    assert said.endswith(f"cannot be written (Not a directory); {cure}")


def test_a_replay_needs_its_record_before_it_simulates(
    record: Path,
    nothing_simulated: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(replay, "check_writable", fill_disk)
    assert replay.main([str(record)]) == 2
    said = "cannot be written (No space left on device); --no-verdict leaves the record"
    assert said in nothing_simulated.readouterr().err


def test_an_export_names_its_folder(
    taken: Path, record: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    job = {"kind": "every-eval-ever", "record": str(record)}
    job["output"] = f"{taken}/export"
    assert exports.main([msgspec.json.encode(job).decode()]) == 2
    said = capsys.readouterr().err
    assert f"{taken}/export cannot be written (Not a directory); -o names" in said


def test_a_report_on_a_full_disk_leaves_nothing(
    record: Path,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """Expect that the same command is not refused because of what it has left."""
    command = ["report", str(record), "-o", str(tmp_path / "report")]
    with monkeypatch.context() as full:
        full.setattr(static_pages, "render_page", fill_disk)
        assert main(command) == 2
    assert "report cannot be written (No space left" in capsys.readouterr().err
    assert not (tmp_path / "report").exists()
    assert main(command) == 0


def make_and_end(folder: Path) -> None:
    (folder / "deep").mkdir(parents=True)
    raise KeyboardInterrupt


def fill_disk(*_: object, **__: object) -> None:
    raise OSError(28, "No space left on device")


@pytest.mark.parametrize(
    ("before", "after"), [(None, None), ([], []), (["others"], ["made", "others"])]
)
def test_a_command_that_fails_removes_its_folder_and_no_files_of_others(
    before: list[str] | None, after: list[str] | None, tmp_path: Path
) -> None:
    """before, after: names in the folder; None where it is not there."""
    folder = tmp_path / "out"
    for name in before or ():
        (folder / name).mkdir(parents=True)
    if before is not None:
        folder.mkdir(exist_ok=True)
    with pytest.raises(KeyboardInterrupt), whole_or_gone(folder):
        make_and_end(folder / "made")
    found = sorted(path.name for path in folder.iterdir()) if folder.exists() else None
    assert found == after


@pytest.mark.parametrize(
    ("error", "code"), [(None, 0), (KeyboardInterrupt(), 130), (OSError("full"), 2)]
)
def test_an_export_fills_an_empty_folder_and_never_replaces_it(
    error: BaseException | None,
    code: int,
    record: Path,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Behind a link, with a mode of its own. error: what ends the export."""
    folder, link = tmp_path / "folder", tmp_path / "link"
    folder.mkdir()
    folder.chmod(0o2770)
    link.symlink_to(folder)
    before = folder.stat()

    def end(*_: object) -> None:
        assert list(folder.rglob("*.json")), "nothing was written yet"
        if error is not None:
            raise error

    monkeypatch.setattr(exports, "_print", end)
    job = {"kind": "every-eval-ever", "record": str(record), "output": str(link)}
    assert exports.main([msgspec.json.encode(job).decode()]) == code
    assert link.is_symlink()
    after = folder.stat()
    assert (after.st_ino, after.st_mode) == (before.st_ino, before.st_mode)
    assert bool(list(folder.iterdir())) == (code == 0)


@pytest.mark.parametrize(
    ("error", "reason"),
    [
        (PermissionError(13, "Permission denied", ".a.part"), "Permission denied"),
        (OSError(28, "No space left on device"), "No space left on device"),
        (OSError("a library says it"), "a library says it"),
    ],
)
def test_a_name_in_the_current_folder_has_its_folder(
    error: OSError, reason: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    with pytest.raises(WrongUsage) as refused, writing(Path("a"), "--x", "is a cure"):
        raise error
    said = f"{tmp_path}/a cannot be written ({reason}); --x is a cure"
    assert str(refused.value) == said


def test_a_file_elsewhere_that_cannot_be_read_is_not_the_output_s_fault(
    tmp_path: Path,
) -> None:
    missing = FileNotFoundError(2, "No such file", str(tmp_path / "inputs" / "seeds"))
    with pytest.raises(FileNotFoundError), writing(tmp_path / "made" / "neu", "-o"):
        raise missing


def test_a_pipe_that_is_read_no_more_is_no_output_that_cannot_be_written() -> None:
    with pytest.raises(BrokenPipeError), writing(Path("a"), "-o"):
        raise BrokenPipeError
