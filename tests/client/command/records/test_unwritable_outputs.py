"""An output that cannot be written: every command names its place and the way out."""

from pathlib import Path

import msgspec
import pytest

from reference_client.command.main import main
from reference_record.command_line.click_commands import WrongUsage
from reference_record.command_line.written_output import writing
from reference_sim.exports import __main__ as exports
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
        ("report RECORD -o TAKEN/report", "-o"),
        ("video run_1 --episode 0 -o TAKEN/videos/a", "-o"),
        ("run --policy mine.py:P --benchmark tabletop --save TAKEN/saved", "--save"),
    ],
)
def test_a_command_names_the_place_and_its_option(
    command: str,
    option: str,
    taken: Path,
    record: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:
    words = command.replace("TAKEN", str(taken)).replace("RECORD", str(record))
    assert main(words.split()) == 2
    said = capsys.readouterr().err
    assert said.startswith(f"proctor: {taken}/")
    assert said.count("\n") == 1
    end = f" cannot be written (Not a directory); {option} names another place\n"
    assert said.endswith(end)


def test_an_export_names_its_folder(
    taken: Path, record: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    job = {"kind": "every-eval-ever", "record": str(record)}
    job["output"] = f"{taken}/export"
    assert exports.main([msgspec.json.encode(job).decode()]) == 2
    said = capsys.readouterr().err
    assert f"{taken}/export cannot be written (Not a directory); -o names" in said


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


def test_a_pipe_that_is_read_no_more_is_no_output_that_cannot_be_written() -> None:
    with pytest.raises(BrokenPipeError), writing(Path("a"), "-o"):
        raise BrokenPipeError
