"""`proctor compare`: a gate for scripts, a table for people."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.support.client.command import ProctorCommand, options

pytestmark = pytest.mark.usefixtures("policy_folder")
TASKS = ("score", "score", "count")
# Ends each episode at once, with the score that its number has in the file `scores`.
GRADED = """
import pathlib
import policies


def graded(observation):
    scores = pathlib.Path("scores").read_text().split()
    score = float(scores[int(observation.episode_id[1:])])
    return policies.action(score=score, success=float(score > 0.5), end=1.0)
"""


@pytest.fixture(autouse=True)
def graded(policy_folder: Path) -> None:
    (policy_folder / "graded.py").write_text(GRADED)


def run(proctor: ProctorCommand, scores: str) -> str:
    Path("scores").write_text(scores)
    made = ["run", "--policy", "graded.py:graded", *options(*TASKS)]
    run_id: str = proctor.json(*made)["run_id"]
    assert proctor.code == 0
    return run_id


def test_the_tolerance_decides_the_exit_code(proctor: ProctorCommand) -> None:
    """Expect 0 where nothing differs beyond the tolerance, and 1 where something does.

    It takes one run beyond it among several to close the gate.
    """
    base, same, worse = (run(proctor, s) for s in ("1 0 1", "1 0 1", "0.75 0 1"))
    assert proctor("compare", base, same) == 0
    assert proctor("compare", base, worse) == 1
    assert proctor("compare", base, same, worse) == 1
    assert proctor("compare", base, same, worse, "--tolerance", "0.125") == 0
    assert proctor("compare", worse, base, "--tolerance", "0.124") == 1


def test_a_script_reads_the_specification_s_words(proctor: ProctorCommand) -> None:
    base, worse = run(proctor, "1 1 1"), run(proctor, "0 1 1")
    found = proctor.json("compare", base, worse, base)
    assert (found["baseline"], found["tolerance"]) == (base, 0.05)
    assert [one["run_id"] for one in found["runs"]] == [worse, base]
    first = found["runs"][0]
    assert (first["losses"], first["wins"], first["p_value"]) == (1, 0, 1.0)
    assert first["by_task"]["score"]["difference"] == 0.5
    assert first["by_task"]["count"]["difference"] == 0.0


def test_people_read_a_table(
    proctor: ProctorCommand, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Expect the numbers and where they are beyond the tolerance, in 80 columns."""
    monkeypatch.setenv("COLUMNS", "80")
    base, worse = run(proctor, "1 1 1"), run(proctor, "0 1 1")
    assert proctor("compare", base, worse) == 1
    lines = [" ".join(line.split()) for line in proctor.out.splitlines()]
    assert max(map(len, proctor.out.splitlines())) <= 80
    better = "difference -0.3333: baseline 1.0000, run 0.6667 (plus is better)"
    assert better in lines
    assert "release no: difference exceeds 0.05 in overall, score" in lines
    assert "score 2 1.000 0.500 -0.500" in lines
    assert "count 1 1.000 1.000 +0.000" in lines
    assert proctor("compare", base, base) == 0
    assert "yes: no difference exceeds 0.05" in proctor.out


def test_an_incomplete_run_is_not_released(proctor: ProctorCommand) -> None:
    base = run(proctor, "1 1 1")
    empty = proctor.json("submit", *options(*TASKS))["run_id"]
    assert proctor("compare", base, empty) == 1
    assert "0 episodes are scored in both; incomplete" in proctor.out
    assert "no: not every episode is scored in both" in proctor.out
    assert "–" in proctor.out


def test_runs_that_cannot_be_compared_give_exit_code_2(proctor: ProctorCommand) -> None:
    base = run(proctor, "1 1 1")
    other = proctor.json("submit", *options("echo"))["run_id"]
    assert proctor("compare", base, other) == 2
    assert proctor.err.startswith("proctor: ")
    assert "[not_comparable]" in proctor.err
    assert proctor("compare", base, "run_none") == 2
    assert "[not_found]" in proctor.err
    for wrong in ("1.5", "nan", "some"):
        assert proctor("compare", base, base, "--tolerance", wrong) == 2
        assert "expected a number from 0 to 1" in proctor.err
    assert proctor("compare", base) == 2
