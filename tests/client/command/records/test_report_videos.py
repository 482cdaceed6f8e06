"""`proctor report --videos`: a video stands beside the episode that it is of.

Two runs of one manifest, of which one fails and one succeeds, with videos in folders
and under names that say something else.
"""

import json
import shutil
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from pathlib import Path

import pytest

from reference_client.command.main import main
from reference_record.formats.video_origin import read_origin
from reference_record.recordings.recording import Turn
from reference_sim import benchmark_registry
from reference_sim.episode import Episode
from reference_sim.exports.__main__ import main as export
from reference_sim.interface import Simulator
from tests.support.record.played_records import (
    Change,
    Chunk,
    keep,
    play_chunks,
    save_played_record,
)
from tests.support.sim.echo_records import (
    ECHO,
    other_action,
    other_digest,
    play_45_steps,
)

pytestmark = pytest.mark.slow("plays records and draws videos")


def save(
    folder: Path,
    run_id: str,
    player: Callable[[Episode, Simulator], Iterable[Chunk]],
    change: Change = keep,
    name: str = "",
) -> Path:
    recordings = folder / f"recordings-{name or run_id}"
    recordings.mkdir()
    return save_played_record(
        folder / f"{name or run_id}.proctor",
        recordings,
        benchmark_registry.resolve("calibration", ECHO),
        player,
        change=change,
        options=ECHO,
        run_id=run_id,
    )


def draw(record: Path, output: str, **more: object) -> None:
    job = {"kind": "video", "record": str(record), "episodes": [0, 1]} | more
    assert export([json.dumps(job | {"output": str(record.parent / output)})]) == 0


@pytest.fixture(scope="module")
def played(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """run_a fails, run_b succeeds; `again` has the id of run_a and other recordings.
    `similar` has another digest in its episode 1, `diverged` another result there."""
    folder = tmp_path_factory.mktemp("played")

    def later(_index: int, _number: int, turn: Turn) -> Turn:
        turn.think_ms += 1
        return turn

    save(folder, "run_a", play_45_steps)
    save(folder, "run_b", play_chunks)
    save(folder, "run_a", play_45_steps, later, name="again")
    save(folder, "run_similar", play_45_steps, other_digest)
    save(folder, "run_diverged", play_45_steps, other_action)
    for name in ("run_a", "run_b", "again", "run_similar", "run_diverged"):
        draw(folder / f"{name}.proctor", f"{name}-videos", anyway=True)
    return folder


@pytest.fixture
def folder(played: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A copy, in which the tests work."""
    copy = tmp_path / "copy"
    shutil.copytree(played, copy)
    monkeypatch.chdir(copy)
    return copy


def shown(folder: Path, page: str) -> list[Path]:
    """The files of the videos of a page, by its address in the report."""
    path = folder / "out" / page
    parts = path.read_text("utf-8").split("<video ")[1:]
    names = [part.partition('src="')[2].partition('"')[0] for part in parts]
    return [(path.parent / name).resolve() for name in names]


def report(*words: str, videos: Iterable[str] = ()) -> int:
    named = [word for name in videos for word in ("--videos", f"{name}-videos")]
    return main(["report", *words, *named, "-o", "out"])


def test_the_videos_of_one_run_are_not_shown_beside_another(folder: Path) -> None:
    """The call of a newcomer: both runs, the videos of the one that failed."""
    assert report("run_a.proctor", "run_b.proctor", videos=["run_a"]) == 0
    (first,) = shown(folder, "runs/1/episodes/00000.html")
    assert first.read_bytes() == (folder / "run_a-videos/00000.mp4").read_bytes()
    assert shown(folder, "runs/2/episodes/00000.html") == []
    assert shown(folder, "comparisons/1-2/00000.html") == [first]


@pytest.mark.parametrize(
    ("runs", "has_page"),
    [(["run_a", "run_b"], False), (["run_a", "run_b", "run_similar"], True)],
)
def test_more_than_two_runs_are_compared_on_one_page(
    folder: Path, runs: list[str], has_page: bool
) -> None:
    assert report(*(f"{run}.proctor" for run in runs)) == 0
    page = folder / "out" / "comparisons" / "several-1.html"
    assert page.is_file() is has_page
    about = (folder / "out" / "runs" / "1" / "index.html").read_text("utf-8")
    assert ("../../comparisons/several-1.html" in about) is has_page
    index = (folder / "out" / "index.html").read_text("utf-8")
    assert ('href="comparisons/several-1.html"' in index) is has_page
    assert 'href="comparisons/1-2/index.html"' in index
    if has_page:
        shown_runs = page.read_text("utf-8")
        assert all(f"<small>{run}</small>" in shown_runs for run in runs)
        assert "1-2/index.html" in shown_runs, "each beside the first"


def test_two_runs_have_the_videos_of_each(folder: Path) -> None:
    runs = ["run_a", "run_b"]
    assert report(*(f"{run}.proctor" for run in runs), videos=runs) == 0
    for number, run in enumerate(runs, start=1):
        for index in (0, 1):
            page = f"runs/{number}/episodes/{index:05d}.html"
            (path,) = shown(folder, page)
            origin = read_origin(path)
            assert origin is not None
            assert (origin.run_id, origin.episode_index) == (run, index), page
    sides = shown(folder, "comparisons/1-2/00001.html")
    origins = [read_origin(path) for path in sides]
    assert [one.run_id for one in origins if one is not None] == runs


def strip(path: Path) -> None:
    """As an earlier version or another program has written it."""
    data = path.read_bytes()
    path.write_bytes(data[: data.rindex(b"uuid") - 4])


@dataclass(frozen=True)
class Case:
    """A folder `run_a-videos` that was changed, and the report of run_a with it. shown:
    the videos of each of its two episodes. said: a part of the one line."""

    change: Callable[[Path], object]
    shown: tuple[int, int]
    said: str = ""


CASES = {
    "as it was made": Case(lambda _: None, (1, 1)),
    "a video is renamed": Case(
        lambda there: (there / "00000.mp4").rename(there / "of the first.mp4"), (1, 1)
    ),
    "two videos change their names": Case(
        lambda there: (
            (there / "00000.mp4").rename(there / "00002.mp4"),
            (there / "00001.mp4").rename(there / "00000.mp4"),
        ),
        (1, 1),
    ),
    "another run's video has the name of an own": Case(
        lambda there: shutil.copy(
            there.parent / "run_b-videos" / "00001.mp4", there / "00001.mp4"
        ),
        (1, 0),
        "1 of the run run_b, which is not in this report",
    ),
    "videos of another record of the same id": Case(
        lambda there: [
            shutil.copy(path, there / f"again-{path.name}")
            for path in (there.parent / "again-videos").iterdir()
        ],
        (1, 1),
        "2 drawn from a recording that is not in this report",
    ),
    "a video that says nothing": Case(
        lambda there: strip(there / "00001.mp4"), (1, 0), "1 without a word of which"
    ),
    "one video twice": Case(
        lambda there: shutil.copy(there / "00001.mp4", there / "copy.mp4"),
        (1, 1),
        "1 of an episode and a camera that another file shows",
    ),
    "another file, which is no video": Case(
        lambda there: (there / "notes.mp4").write_bytes(b"\x00" * 100),
        (1, 1),
        "1 without a word of which",
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_a_folder_that_was_changed(
    name: str, folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    case = CASES[name]
    case.change(folder / "run_a-videos")
    assert report("run_a.proctor", videos=["run_a"]) == 0
    for index, count in enumerate(case.shown):
        found = shown(folder, f"runs/1/episodes/{index:05d}.html")
        assert len(found) == count, index
        for path in found:
            origin = read_origin(path)
            assert origin is not None
            assert (origin.run_id, origin.episode_index) == ("run_a", index)
    lines = capsys.readouterr().err.splitlines()
    assert len(lines) == bool(case.said)
    assert all(case.said in line and "run_a-videos: " in line for line in lines)


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (
            lambda there: shutil.copytree(
                there.parent / "run_b-videos", there, dirs_exist_ok=True
            ),
            "no video of a run in this report: its videos are of run_b",
        ),
        (
            lambda there: list(map(strip, there.iterdir())),
            "says which episode it shows",
        ),
        (lambda there: [path.unlink() for path in there.iterdir()], "has no videos"),
    ],
)
def test_a_folder_without_an_own_video_is_refused(
    change: Callable[[Path], object],
    said: str,
    folder: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """Nothing is written: it was meant for another report."""
    change(folder / "run_a-videos")
    assert report("run_a.proctor", videos=["run_a"]) == 2
    assert said in capsys.readouterr().err
    assert not (folder / "out").exists()


def test_a_similar_episode_is_shown_as_one(folder: Path) -> None:
    assert report("run_similar.proctor", videos=["run_similar"]) == 0
    note = "a similar episode, whose states differ from turn 3 on"
    for index, is_noted in ((0, False), (1, True)):
        page = f"runs/1/episodes/{index:05d}.html"
        assert len(shown(folder, page)) == 1
        assert (note in (folder / "out" / page).read_text()) == is_noted


def test_another_result_is_not_shown_whatever_its_file_is_called(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    videos = folder / "run_diverged-videos"
    (videos / "00001-diverged.mp4").rename(videos / "00001.mp4")
    assert report("run_diverged.proctor", videos=["run_diverged"]) == 0
    assert len(shown(folder, "runs/1/episodes/00000.html")) == 1
    assert shown(folder, "runs/1/episodes/00001.html") == []
    assert "another result than the recorded episode" in capsys.readouterr().err


def test_a_report_never_shows_files_of_the_one_before_it(folder: Path) -> None:
    """Both have a first run with a video of its first episode."""
    assert report("run_b.proctor", videos=["run_b"]) == 0
    assert report("run_a.proctor", "--force", videos=["run_a"]) == 0
    (path,) = shown(folder, "runs/1/episodes/00000.html")
    assert path.read_bytes() == (folder / "run_a-videos/00000.mp4").read_bytes()
    assert report("run_b.proctor", "--force") == 0
    assert shown(folder, "runs/1/episodes/00000.html") == []


def test_each_run_has_the_page_of_its_own_version(folder: Path) -> None:
    """Two runs of one benchmark with different options."""
    other = {"tasks": ["score"], "max_steps": 12}
    (folder / "recordings-other").mkdir()
    save_played_record(
        folder / "run_other.proctor",
        folder / "recordings-other",
        benchmark_registry.resolve("calibration", other),
        play_chunks,
        options=other,
        run_id="run_other",
    )
    assert report("run_a.proctor", "run_other.proctor") == 0
    for number, steps in ((1, 45), (2, 12)):
        page = (folder / "out" / f"runs/{number}/index.html").read_text()
        assert f"benchmarks/{number}.html" in page
        described = (folder / "out" / f"benchmarks/{number}.html").read_text()
        assert f"<dd>{steps} steps</dd>" in described
