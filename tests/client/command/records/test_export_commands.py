"""`proctor export --to` and `proctor video`: what they make, and what they refuse."""

import importlib.util
import json
import os
import subprocess
import sys
from pathlib import Path

import pyarrow.parquet as pq
import pytest

from reference_client.command.main import main
from reference_record.command_line.installation import install_command
from reference_sim.exports import __main__ as exports
from tests.support.client.command import Proctor, options
from tests.support.paths import ROOT
from tests.support.processes import run_program
from tests.support.record.played_records import save_calibration_record
from tests.support.servers import ReferenceServer

Done = subprocess.CompletedProcess[str]


@pytest.fixture
def record(tmp_path: Path) -> Path:
    (tmp_path / "recordings").mkdir()
    return save_calibration_record(tmp_path / "run-1.proctor", tmp_path / "recordings")


def proctor(folder: Path, *words: str) -> Done:
    return run_program(
        [sys.executable, "-m", "reference_client.command", *words],
        cwd=folder,
        env=os.environ | {"PYTHONPATH": str(ROOT)},
    )


@pytest.mark.slow("starts programs")
def test_a_record_in_a_file_needs_no_server(record: Path) -> None:
    folder = record.parent
    done = proctor(folder, "export", "run-1.proctor", "--to", "parquet")
    assert done.returncode == 0, done.stderr
    assert done.stdout.splitlines()[1].startswith("run-1-parquet/turns.parquet")
    assert pq.read_table(folder / "run-1-parquet" / "turns.parquet").num_rows == 6
    again = proctor(folder, "export", "run-1.proctor", "--to", "parquet")
    assert again.returncode == 2
    assert "run-1-parquet exists and is not empty" in again.stderr
    drawn = proctor(folder, "video", "run-1.proctor", "--episode", "2", "--json")
    assert drawn.returncode == 0, drawn.stderr
    (file,) = json.loads(drawn.stdout)["files"]
    assert (folder / file["path"]).stat().st_size == file["bytes"]
    assert file["replay"] == "exact"


@pytest.mark.slow("starts a server and programs")
def test_the_record_of_a_run_is_saved_beside_its_export(
    server: ReferenceServer, policy_folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    command = Proctor(server.url, capsys)
    played = ("run", "--policy", "policies:best", *options("score", "echo"))
    assert command(*played) == 0
    run_id = command.json("status", "--state", "completed")[0]["run_id"]
    words = ("export", run_id, "--to", "every-eval-ever", "--url", server.url)
    done = proctor(policy_folder, *words)
    assert done.returncode == 0, done.stderr
    assert f"saved the record as {run_id}.proctor" in done.stderr
    assert (policy_folder / f"{run_id}.proctor").is_file()
    again = proctor(policy_folder, "export", run_id, "--url", server.url)
    assert again.returncode == 0, again.stderr
    assert f"{run_id}.proctor is saved already" in again.stderr
    elsewhere = policy_folder / "elsewhere"  # as from a folder that is read-only
    elsewhere.mkdir()
    done = proctor(elsewhere, *words, "-o", f"{policy_folder}/other/export")
    assert done.returncode == 0, done.stderr
    assert (policy_folder / "other" / f"{run_id}.proctor").is_file()
    assert not [*elsewhere.iterdir()]
    folder = policy_folder / f"{run_id}-every-eval-ever"
    assert len([*folder.rglob("*.json")]) == 1
    # The server sends the recordings of the record: a video of one fits the other.
    assert proctor(policy_folder, "video", run_id, "--episode", "1").returncode == 0
    shown = ("--videos", f"{run_id}-videos", "-o", "out", "--url", server.url)
    done = proctor(policy_folder, "report", run_id, *shown, "--json")
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout)["videos"] == 1


@pytest.mark.parametrize(
    "words", [["video", "--failures"], ["export", "--to", "lerobot"]]
)
def test_a_record_under_the_name_of_another_run_is_refused(
    words: list[str],
    record: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """The run is named by its id, and a file with that name lies there."""
    monkeypatch.chdir(record.parent)
    assert main([words[0], "1", *words[1:]]) == 2
    (line,) = capsys.readouterr().err.splitlines()
    assert "run-1.proctor is the record of the run r, not of 1" in line


@pytest.mark.parametrize(
    ("words", "text"),
    [
        (["video", "run-1.proctor"], "needs --episode N, or --failures"),
        (["video", "run-1.proctor", "--episode", "one"], "expected indices"),
        (["video", "run-1.proctor", "--episode", "e1,x2"], "expected indices"),
        (["video", "run-1.proctor", "--size", "8x8"], "each from 16 to 4096"),
        (["video", "run-1.proctor", "--size", "33x32"], "a video has even sides"),
        (["video", "absent.proctor", "--failures"], "absent.proctor: no such file"),
        (
            ["export", "run-1.proctor", "--to", "csv"],
            "--to: unknown value csv; there is ",
        ),
        (["export", "--to", "parquet"], "name a run, or the file of its record"),
        (["export", "RUN", "--failures"], "--failures is an option of video"),
        (
            ["export", "RUN", "--to", "parquet", "--size", "64x64"],
            "--size is an option of video",
        ),
    ],
)
def test_a_wrong_use_is_said_in_one_line(
    words: list[str],
    text: str,
    record: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(record.parent)
    assert main(words) == 2
    (line,) = capsys.readouterr().err.splitlines()
    assert text in line


@pytest.mark.parametrize(
    ("words", "missing", "extra"),
    [
        (["export", "RUN", "--to", "parquet"], "pyarrow", "client,parquet"),
        (["video", "RUN", "--failures"], "av", "server,video"),
        (["video", "RUN", "--failures"], "mujoco", "server,video"),
    ],
)
def test_what_is_not_installed_is_named_before_anything_is_fetched(
    words: list[str],
    missing: str,
    extra: str,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    find_spec = importlib.util.find_spec
    monkeypatch.setattr(
        importlib.util,
        "find_spec",
        lambda name: None if name == missing else find_spec(name),
    )
    assert main(words) == 2
    (line,) = capsys.readouterr().err.splitlines()
    assert f"needs {missing}, which is not installed" in line
    assert line.endswith(install_command(extra))


@pytest.mark.parametrize(
    ("error", "code"), [(KeyboardInterrupt(), 130), (BrokenPipeError(), 141)]
)
def test_an_export_that_is_broken_off_leaves_nothing(
    error: BaseException, code: int, record: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def break_off(*_: object) -> None:
        raise error

    monkeypatch.chdir(record.parent)
    monkeypatch.setattr(exports, "_print", break_off)
    monkeypatch.setattr(exports, "discard_standard_output", lambda: None)
    before = sorted(record.parent.iterdir())
    job = {"kind": "every-eval-ever", "record": record.name}
    assert exports.main([json.dumps(job)]) == code
    assert sorted(record.parent.iterdir()) == before
