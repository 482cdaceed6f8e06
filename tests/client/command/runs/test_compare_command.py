"""`proctor compare`: a gate for scripts, a table for people."""

from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from reference_record.comparison.difference_evidence import (
    Evidence,
    GroupEvidence,
    weigh_differences,
)
from reference_record.comparison.release import explain_release, may_release
from tests.support.client.command import Proctor, options

pytestmark = pytest.mark.usefixtures("policy_folder")
TASKS = ("score", "score", "count")
UNDECIDED: Any = SimpleNamespace(better=None)
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


def run(proctor: Proctor, scores: str, name: str = "graded") -> str:
    Path("scores").write_text(scores)
    made = ["run", "--policy", "graded.py:graded", "--name", name, *options(*TASKS)]
    run_id: str = proctor.json(*made)["run_id"]
    assert proctor.code == 0
    return run_id


def test_the_tolerance_decides_the_exit_code(proctor: Proctor) -> None:
    """Expect 0 where nothing differs beyond the tolerance, and 1 where something does.
    It takes one run beyond it among several to close the gate."""
    base, same, worse = (run(proctor, s) for s in ("1 0 1", "1 0 1", "0.75 0 1"))
    assert proctor("compare", base, same) == 0
    assert proctor("compare", base, worse) == 1
    assert proctor("compare", base, same, worse) == 1
    assert proctor("compare", base, same, worse, "--tolerance", "0.125") == 0


def test_a_table_for_a_publication_has_a_column_for_each_policy(
    proctor: Proctor,
) -> None:
    base, same, worse = (
        run(proctor, scores, name)
        for scores, name in (("1 0 1", "pi_0"), ("1 0 1", "ours"), ("1 0 0", "ours"))
    )
    assert proctor("compare", base, same, worse, "--format", "latex") == 1
    _, head, *rows, end, _, note = proctor.out.splitlines()
    assert end == r"\end{tabular}"
    assert note.startswith("% Benchmark calibration, version ")
    assert "mean score of one split, with its 95 % Wilson interval" in note
    names = (r"pi\_0", rf"ours (run\_{same[4:]})", rf"ours (run\_{worse[4:]})")
    assert head == " & ".join(["", "episodes", *names]) + r" \\ \hline"
    assert rows[2] == (
        r"even: count & 1 & 1.000 {[}0.21, 1.00] & 1.000 {[}0.21, 1.00] & "
        r"0.000 {[}0.00, 0.79] \\"
    )
    assert [row.partition(" &")[0] for row in rows] == [
        *("split even", "even: score", "even: count", "split odd", "odd: score"),
    ]


PART = "splits even, and nothing else"


@pytest.mark.parametrize(
    ("options_of_compare", "said"),
    [
        ((), (f"part {PART}",)),
        (("--format", "latex"), ("split even & 2 & 0.500", f", {PART}. Each number")),
        (("--format", "markdown"), ("| split even | 2 | 0.500", f", {PART}. Each num")),
    ],
)
def test_a_comparison_of_a_part_names_it_and_has_its_mean(
    proctor: Proctor, options_of_compare: tuple[str, ...], said: tuple[str, ...]
) -> None:
    """A reader takes a split for the benchmark, where its table does not say it."""
    Path("scores").write_text("1 0")
    made = ["run", "--policy", "graded.py:graded", "--split", "even", *options(*TASKS)]
    base, other = (proctor.json(*made)["run_id"] for _ in range(2))
    assert proctor("compare", base, other, *options_of_compare) == 0
    shown = " ".join(proctor.out.split())
    assert [text in shown for text in said] == [True] * len(said), shown
    assert proctor.json("compare", base, other)["select"]["splits"] == ["even"]


@pytest.mark.parametrize("style", ["latex", "markdown"])
def test_a_cell_of_a_partial_run_has_its_number_of_episodes(
    proctor: Proctor, style: str
) -> None:
    base = run(proctor, "1 0 1")
    made = ["run", "--policy", "graded.py:graded", "--name", "part", *options(*TASKS)]
    part = proctor.json(*made, "--episodes", "1")["run_id"]
    assert proctor("compare", base, part, "--format", style) == 1
    (row,) = (line for line in proctor.out.splitlines() if "split even" in line)
    assert row.count("(1 of 2)") == 1
    (note,) = (line for line in proctor.out.splitlines() if "Wilson" in line)
    assert note.startswith("% ") == (style == "latex")


def test_a_difference_over_several_splits_begins_with_that_of_each(
    proctor: Proctor,
) -> None:
    assert proctor("compare", run(proctor, "1 0 1"), run(proctor, "1 0 0")) == 1
    text = "even -0.5000, odd +0.0000; all splits mixed -0.3333: baseline 0.6667"
    assert text in " ".join(proctor.out.split())


def test_a_difference_of_a_part_says_of_which_episodes_it_is(
    proctor: Proctor,
) -> None:
    """The runs are of one split alone, although the benchmark has two."""
    base = run(proctor, "1 0 1")
    made = ["run", "--policy", "graded.py:graded", "--name", "part", *options(*TASKS)]
    part = proctor.json(*made, "--episodes", "1")["run_id"]
    assert proctor("compare", base, part) == 1
    said = " ".join(proctor.out.split())
    assert "difference even +0.0000 of the 1 episode scored in both: base" in said


@pytest.mark.parametrize(
    ("baseline", "played", "code", "reason"),
    [
        ("0 1 1", "1 1 1", 0, "better by more overall and in score"),
        ("0 1 1", "1 1 0", 1, "not decided: worse by more than 0.05 in count"),
        ("0.5 1 1", "0.54 1 1", 0, "yes: no difference exceeds 0.05"),
        (
            "1 1 1",
            "1 0 1",
            1,
            "not decided: worse by more than 0.05 overall and in score",
        ),
    ],
)
def test_only_what_is_worse_is_a_reason_against_a_release(
    proctor: Proctor, baseline: str, played: str, code: int, reason: str
) -> None:
    """The protocol's own `release` asks for equality in both directions."""
    assert proctor("compare", run(proctor, baseline), run(proctor, played)) == code
    assert reason in " ".join(proctor.out.split())


def test_a_task_may_be_called_overall() -> None:
    """It is worse and shown to be, while the whole is better. Expect its name alone."""
    task = SimpleNamespace(difference=0.5)
    run: Any = SimpleNamespace(
        complete=True, difference=-0.1, by_task={"overall": task}, wins=9, losses=0
    )
    nothing, worse = GroupEvidence(9, 0, 1.0), GroupEvidence(0, 9, 0.001)
    evidence = Evidence(nothing, {"overall": worse})
    assert not may_release(run, 0.05)
    said = explain_release(run, 0.05, evidence, UNDECIDED)
    assert said == "no: worse by more than 0.05 in overall"
    run.by_task["push"] = task
    said = explain_release(run, 0.05, evidence, UNDECIDED)
    assert said.endswith(
        " in overall; also worse in push, where chance alone may "
        "explain it; more episodes decide"
    )
    said = explain_release(run, 0.05, Evidence(worse, {}), UNDECIDED)
    assert said.startswith("not decided")


@pytest.mark.parametrize(
    ("losses", "p_value", "of_scores", "better", "verdict"),
    [
        (8, 0.0078, 0.0078, None, "no: worse"),
        (8, 0.0078, 0.45, None, "no: worse"),  # graded scores show nothing
        (3, 0.25, 0.02, None, "no: worse"),  # successes show nothing
        (9, 0.06, 0.06, "baseline", "no: worse"),  # and decided on the way
        (3, 0.25, 0.25, None, "not decided: worse"),
        (0, 0.0078, 0.45, None, "not decided: worse"),  # it succeeds more often
    ],
)
def test_the_verdict_agrees_with_every_test_in_the_table(
    losses: int, p_value: float, of_scores: float, better: str | None, verdict: str
) -> None:
    """Chance is named only where no line of the same table rules it out."""
    known = {"complete": True, "difference": 0.1, "by_task": {}, "wins": 1}
    run: Any = SimpleNamespace(**known, losses=losses)
    run.p_value = p_value
    watched: Any = SimpleNamespace(better=better)
    evidence = Evidence(GroupEvidence(1, 9, of_scores), {})
    said = explain_release(run, 0.05, evidence, watched)
    assert said.startswith(f"{verdict} by more than 0.05 overall")
    assert ("chance" in said) == verdict.startswith("not")


@pytest.mark.parametrize(
    ("tasks", "episodes", "can_decide"),
    [(1, 5, False), (1, 6, True), (8, 8, False), (8, 9, True), (2, 7, True)],
)
def test_too_few_episodes_of_a_task_are_said_to_decide_nothing(
    tasks: int, episodes: int, can_decide: bool
) -> None:
    """The most uneven result of a task, all lost, is shown exactly where it can be."""
    pairs = [(f"task {n}", 1.0, 0.0) for n in range(tasks) for _ in range(episodes)]
    found = weigh_differences(pairs)
    assert {one.can_decide for one in found.by_task.values()} == {can_decide}
    assert {one.is_shown for one in found.by_task.values()} == {can_decide}
    lost = SimpleNamespace(difference=1.0)
    run: Any = SimpleNamespace(
        complete=True, difference=1.0, by_task=dict.fromkeys(found.by_task, lost)
    )
    run.wins, run.losses, run.p_value = 0, 0, 1.0
    said = explain_release(run, 0.05, found, UNDECIDED)
    assert ("too few episodes ever to decide it" in said) is not can_decide


def test_a_script_reads_the_specification_s_words(proctor: Proctor) -> None:
    base, worse = run(proctor, "1 1 1"), run(proctor, "0 1 1")
    found = proctor.json("compare", base, worse, base)
    assert (found["baseline"], found["tolerance"]) == (base, 0.05)
    assert [one["run_id"] for one in found["runs"]] == [worse, base]
    first = found["runs"][0]
    assert (first["losses"], first["wins"], first["p_value"]) == (1, 0, 1.0)
    assert first["by_task"]["score"]["difference"] == 0.5
    assert first["by_task"]["count"]["difference"] == 0.0


def test_people_read_a_table(proctor: Proctor, monkeypatch: pytest.MonkeyPatch) -> None:
    """Expect the numbers and where they are beyond the tolerance, in 80 columns."""
    monkeypatch.setenv("COLUMNS", "80")
    base, worse = run(proctor, "1 1 1"), run(proctor, "0 1 1")
    assert proctor("compare", base, worse) == 1
    lines = [" ".join(line.split()) for line in proctor.out.splitlines()]
    assert max(map(len, proctor.out.splitlines())) <= 80
    said = " ".join(lines)
    mixed = "all splits mixed -0.3333: baseline 1.0000, run 0.6667"
    numbers = f"difference even -0.5000, odd +0.0000; {mixed}"
    assert f"{numbers} (plus is better; it has no interval)" in said
    assert "release not decided: worse by more than 0.05 overall and in score" in said
    assert "chance alone may explain it; the benchmark has too few episodes" in said
    assert "scores 0 episodes better, 1 worse" in lines
    assert "successes 0 of the run alone, 1 of the baseline alone; p " in said
    assert "score 2 1.000 0.500 -0.500" in lines
    assert "count 1 1.000 1.000 +0.000" in lines
    assert proctor("compare", base, base) == 0
    assert "yes: no difference exceeds 0.05" in proctor.out


def test_chance_is_no_reason_against_a_release(proctor: Proctor) -> None:
    """One of nine episodes lost, then all of eight of one task. Expect no verdict, then
    the task by name, without the other one, which had the one loss."""
    made = ["run", "--policy", "graded.py:graded"]
    made += options("count", *["score"] * 8)
    ids = []
    for scores in ("1 " * 9, "0 " + "1 " * 8, "0 " + "0 " * 8):
        Path("scores").write_text(scores)
        ids.append(proctor.json(*made)["run_id"])
    base, once, often = ids
    assert proctor("compare", base, once) == 1
    assert "not decided: worse by more than 0.05 overall and in count" in proctor.out
    assert proctor("compare", base, often) == 1
    assert "no: worse by more than 0.05 overall and in score" in proctor.out
    assert "score, count" not in proctor.out
    found = proctor.json("compare", base, often)["evidence"][often]
    by_task = found["by_task"]
    assert (by_task["count"]["worse"], by_task["count"]["p_value"]) == (1, 1.0)
    assert by_task["score"]["p_value"] == pytest.approx(2 * 2 / 2**8)


def test_a_comparison_may_stop_before_the_end(proctor: Proctor) -> None:
    """Seven episodes of ten, all lost. Expect it decided, with the e-value."""
    tasks = ["score"] * 10
    made = ["run", "--policy", "graded.py:graded", *options(*tasks)]
    Path("scores").write_text("1 " * 10)
    base = proctor.json(*made)["run_id"]
    Path("scores").write_text("0 " * 10)
    worse = proctor.json(*made, "--episodes", "7")["run_id"]
    assert proctor("compare", base, worse) == 1
    assert "may stop " in proctor.out
    assert (
        "decided at e ≥ 20 (e = 26.8): on the first 7 of 10 episodes the baseline "
        "succeeds more often; the 3 left need not be played" in proctor.out
    )
    found = proctor.json("compare", worse, base)["sequential"][base]
    assert (found["better"], found["wins"], found["compared"]) == ("run", 7, 7)


def test_no_p_is_zero(proctor: Proctor) -> None:
    """Sixteen episodes, all lost: 2 of 65,536. Expect a bound, not four zeros."""
    made = ["run", "--policy", "graded.py:graded", *options(*["score"] * 16)]
    Path("scores").write_text("1 " * 16)
    base = proctor.json(*made)["run_id"]
    Path("scores").write_text("0 " * 16)
    assert proctor("compare", base, proctor.json(*made)["run_id"]) == 1
    assert "p < 0.0001 (exact McNemar)" in proctor.out


def test_how_often_each_account_tried_is_shown(proctor: Proctor) -> None:
    """Expect the runs played before, of both, where the server counts them."""
    first, second = run(proctor, "1 1 1"), run(proctor, "0 1 1")
    before = proctor.json("status", first)["runs_played_before"]
    assert proctor.json("results", second)["runs_played_before"] == before + 1
    assert proctor("compare", first, second) == 1
    assert (
        f"before the baseline {before}, before the run {before + 1}, each by its "
        "account" in proctor.out
    )
    for command in ("status", "results"):
        assert proctor(command, second) == 0
        assert "of this benchmark played by its account before this one" in proctor.out
    unplayed = proctor.json("submit", *options(*TASKS))["run_id"]
    proctor("status", unplayed)
    assert "earlier runs" not in proctor.out


def test_a_run_ends_with_the_lines_of_its_results(proctor: Proctor) -> None:
    run(proctor, "1 1 1")
    assert proctor("run", "--policy", "graded.py:graded", *options(*TASKS)) == 0
    lines = proctor.out.splitlines()
    run_id = next(line.split()[1] for line in lines if line.startswith("run "))
    assert proctor("results", run_id) == 0
    assert lines == proctor.out.splitlines()
    assert any(line.startswith("earlier runs") for line in lines)


def test_an_incomplete_run_is_not_released(proctor: Proctor) -> None:
    base = run(proctor, "1 1 1")
    empty = proctor.json("submit", *options(*TASKS))["run_id"]
    assert proctor("compare", base, empty) == 1
    assert "0 episodes are scored in both; incomplete" in proctor.out
    assert "no: not every episode is scored in both" in proctor.out
    assert "–" in proctor.out


def test_runs_that_cannot_be_compared_give_exit_code_2(proctor: Proctor) -> None:
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
