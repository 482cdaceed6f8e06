"""Parts of a benchmark, repetitions, and the forms of a result."""

import csv
import json
from pathlib import Path

import pytest

from reference_client.command.main import main
from reference_client.command.output.text_tables import (
    TextTable,
    latex,
    markdown,
)
from reference_client.evaluation.status_board import Pace, Progress
from tests.support.client.command import Proctor, options
from tests.support.client.direct_client import DirectClient
from tests.support.servers import ReferenceServer

pytestmark = pytest.mark.usefixtures("policy_folder")
FIVE = options(*["score"] * 5)


@pytest.mark.parametrize("workers", ["1", "3"])
@pytest.mark.parametrize("processes", [[], ["--processes"]])
def test_the_first_episodes_are_played(
    proctor: Proctor, server: ReferenceServer, workers: str, processes: list[str]
) -> None:
    """Two of five. Expect a score that says it is partial, no attempt lost, and that
    the run can be played to its end."""
    run = ["run", "--policy", "policies.py:Graded", *FIVE, "--workers", workers]
    assert proctor(*run, "--episodes", "2", *processes) == 0
    assert "partial, 2 of 5 episodes with mean " in proctor.out
    assert "To play the rest:" in proctor.err
    with DirectClient(server.url) as direct:
        run_id = direct.latest().run_id
        assert direct.control.get_run(run_id).live_workers == 0
        statuses = [
            episode.status.value
            for episode in direct.control.list_episodes(run_id).episodes
        ]
        assert statuses == ["scored"] * 2 + ["pending"] * 3
        rest = ["run", "--policy", "policies.py:Graded", "--run-id", run_id]
        assert proctor.json(*rest)["score"] == pytest.approx(2.5 / 5)
        assert direct.attempts(run_id) == [1] * 5


def test_repetitions_have_mean_and_spread(proctor: Proctor, tmp_path: Path) -> None:
    Path("scores").write_text("0")
    Path("growing.py").write_text(
        "import pathlib\nimport policies\n\n\ndef growing(observation):\n"
        "    score = float(pathlib.Path('scores').read_text())\n"
        "    pathlib.Path('scores').write_text(str(score + 0.5))\n"
        "    return policies.action(score=score, success=1.0, end=1.0)\n"
    )
    run = ["run", "--no-dry-turn", "--policy", "growing.py:growing", *options("score")]
    found = proctor.json(*run, "--repeat", "3", "--save", "out")
    assert (found["mean"], found["stdev"]) == (0.5, 0.5)
    assert len({one["run_id"] for one in found["runs"]}) == 3
    assert len([*(tmp_path / "out").glob("run_*/result.json")]) == 3
    assert proctor(*run, "--repeat", "2", "--run-id", "run_a") == 2


@pytest.mark.parametrize("command", ["run", "results"])
def test_a_result_is_saved(proctor: Proctor, command: str) -> None:
    run = ["run", "--policy", "policies.py:Graded", *FIVE]
    saved = ["--save", "deep/out"]
    run_id = proctor.json(*run, *(saved if command == "run" else []))["run_id"]
    if command == "results":
        assert proctor("results", run_id, *saved) == 0
    result = json.loads(Path("deep/out/result.json").read_text())
    assert result["run"]["run_id"] == result["score"]["run_id"] == run_id
    assert len(result["episodes"]) == 5
    with Path("deep/out/episodes.csv").open() as file:
        rows = [*csv.DictReader(file)]
    assert [float(row["score"]) for row in rows] == [0, 0.25, 0.5, 0.75, 1]
    assert {row["outcome"] for row in rows} == {"success"}
    assert {row["run_id"] for row in rows} == {run_id}
    replaced = f", in place of the result of {run_id}"
    assert proctor("results", run_id, *saved) == 0
    assert replaced not in proctor.err + proctor.out
    another = proctor.json(*run)["run_id"]
    assert proctor("results", another, *saved) == 0
    assert f"Saved: deep/out{replaced}\n" in proctor.err + proctor.out


def test_a_folder_that_cannot_be_made_is_refused_before_a_run(proctor: Proctor) -> None:
    Path("file").write_text("")
    before = proctor.json("status")
    run = ["run", "--policy", "policies.py:Graded", *FIVE, "--save", "file/out"]
    assert proctor(*run) == 2
    assert "/file/out cannot be written (Not a directory); --save" in proctor.err
    assert proctor.json("status") == before


def test_runs_are_listed_with_scores_filters_and_pages(proctor: Proctor) -> None:
    run = ["run", "--policy", "policies.py:Graded", "--name", "listed"]
    ids = [proctor.json(*run, *FIVE)["run_id"] for _ in range(3)][::-1]
    found = proctor.json("status", "--name", "listed")
    assert [one["run_id"] for one in found] == ids
    assert [one["score"] for one in found] == [0.5] * 3
    assert proctor.json("status", "--name", "listed", "--state", "failed") == []
    assert proctor("status", "--name", "listed", "--limit", "2") == 0
    assert ids[2] not in proctor.out
    assert "More: --page 2" in proctor.out
    page = proctor.json("status", "--name", "listed", "--limit", "2", "--page", "2")
    assert [one["run_id"] for one in page] == ids[2:]
    assert "0.500" in proctor_text(proctor, "status", "--name", "listed")
    assert "score" in proctor_text(proctor, "status", ids[0])
    assert "0.5000" in proctor.out
    assert proctor.json("status", ids[0])["score"] == 0.5


def proctor_text(proctor: Proctor, *arguments: str) -> str:
    assert proctor(*arguments) == 0
    return proctor.out


def test_tables_have_three_forms(proctor: Proctor) -> None:
    text = proctor_text(proctor, "benchmarks", "--format", "markdown")
    assert text.startswith("| benchmark | version | episodes | title |\n| --- |")
    text = proctor_text(proctor, "benchmarks", "--format", "latex")
    assert text.startswith("\\begin{tabular}{llrl}\n")
    assert "tabletop\\_state &" in text


def test_special_characters_do_not_break_a_table() -> None:
    table = TextTable(("name", ">value"))
    table.add("a|b", "50 %")
    assert markdown(table) == "| name | value |\n| --- | ---: |\n| a\\|b | 50 % |\n"
    assert "a\\textbar{}b & 50 \\% \\\\\n" in latex(table)


# A text may not have these as they are: to LaTeX they are commands or other glyphs.
SPECIAL = {
    "\\": r"\textbackslash{}", "&": r"\&", "%": r"\%", "$": r"\$", "#": r"\#",
    "_": r"\_", "{": r"\{", "}": r"\}", "~": r"\textasciitilde{}",
    "^": r"\textasciicircum{}", "<": r"\textless{}", ">": r"\textgreater{}",
    "|": r"\textbar{}", '"': "''", "--": "-{}-{}", "[1]": "{[}1]", "*": "{*}",
    "≥": r"$\geq$", "≤": r"$\leq$", "–": "--", "…": r"\ldots{}", "×": r"$\times$",
}  # fmt: skip


@pytest.mark.parametrize("text", SPECIAL)
def test_a_special_character_of_latex_is_written_as_itself(text: str) -> None:
    table = TextTable((f"n{text}", "value"))
    table.add(text, f"a{text}b")
    written = SPECIAL[text]
    head, row = latex(table).splitlines()[1:3]
    assert head == rf"n{written} & value \\ \hline"
    assert row == rf"{written} & a{written}b \\"


@pytest.mark.parametrize(
    ("text", "written"),
    [
        ("-0.5", "$-$0.5"),
        ("[-1, 2]", "{[}$-$1, 2]"),
        ("run-4f", "run-{}4f"),
        ("2026-11-30", "2026-{}11-{}30"),
        ("--", "-{}-{}"),
    ],
)
def test_a_minus_sign_is_no_hyphen(text: str, written: str) -> None:
    table = TextTable(("name",))
    table.add(text)
    assert latex(table).splitlines()[2] == rf"{written} \\"


def test_the_version_is_printed(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as ended:
        main(["--version"])
    assert ended.value.code == 0
    assert "protocol version" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("at_once", "reports", "text"),
    [
        (1, [(0, 10)], ""),
        (1, [(0, 10), (50, 11)], ""),  # one episode says nothing
        (1, [(0, 10), (50, 11), (75, 12), (100, 13)], "~2:55 left"),
        (1, [(0, 10), (50, 11), (7250, 12), (14450, 13)], "~14:00:00 left"),
        (1, [(0, 17), (50, 18), (75, 19), (100, 20)], ""),  # all are scored
        (4, [(0, 0), (40, 4)], ""),  # the first round
        (4, [(0, 0), (40, 4), (80, 8)], "~2:00 left"),
        (1, [(0, 10), (1, 11), (2, 12), (3, 13), (900, 13)], ""),  # it stands still
    ],
)
def test_the_time_left_is_estimated(
    monkeypatch: pytest.MonkeyPatch,
    at_once: int,
    reports: list[tuple[int, int]],
    text: str,
) -> None:
    pace, said = Pace(), ""
    for now_s, scored in reports:
        monkeypatch.setattr("time.monotonic", lambda now_s=now_s: float(now_s))
        said = pace.left(Progress("run_1", 20, scored, 0.5, None, at_once=at_once))
    assert said == text
