"""The measurement of experts: it judges rightly, and its page is what it wrote."""

import re
import sys

import pytest
from PIL import Image

from reference_sim.benchmarks.tabletop.experts import TabletopExpert
from tests.support.paths import ROOT
from tests.support.processes import run_program
from tools import __main__ as tools
from tools import experts

pytestmark = pytest.mark.slow("plays whole episodes")

PAGE = (ROOT / "docs" / "evaluate" / "tasks.md").read_text()
SHOWN = [
    (name, task)
    for name in experts.benchmark_names()
    for task in experts.manifest(name)["tasks"]
]


def test_experts_solve_every_task_and_random_actions_none() -> None:
    """One seed of each task and split, played for real."""
    done = run_program(
        [sys.executable, "-m", "tools", "experts", "tabletop", "--seeds", "1"],
        cwd=ROOT,
        timeout=120,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    state = experts.manifest("tabletop")
    players = 1 + len(experts.LUCK_SHARE)
    trials = players * len(state["tasks"]) * len(state["splits"])
    assert f"{trials} measured, 0 missed" in done.stdout
    assert "MISSED" not in done.stdout


@pytest.mark.parametrize(
    ("player", "successes", "missed"),
    [
        ("expert", 99, False),
        ("expert", 98, True),
        ("random", 2, False),
        ("random", 3, True),
        ("still", 3, True),
    ],
)
def test_a_missed_criterion_is_reported_and_fails(
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    player: str,
    successes: int,
    missed: bool,
) -> None:
    trial = experts.Trial("tabletop", "reach", "test", player, seeds=100)
    outcome = experts.TrialResult(trial, (10,) * successes)
    assert ("MISSED" in str(outcome)) == missed
    monkeypatch.setattr(experts, "measure", lambda *_: [outcome])
    assert tools.main(["experts"]) == missed
    assert f"1 measured, {int(missed)} missed" in capsys.readouterr().out


def test_the_tabletop_is_measured() -> None:
    assert "tabletop" in experts.benchmark_names()
    assert "runners" not in experts.benchmark_names()


@pytest.mark.parametrize(("name", "task"), SHOWN)
def test_the_page_shows_each_task_as_it_is(name: str, task: str) -> None:
    """Instruction, goal and stages as the code has them, and a small picture."""
    assert experts.task_section(name, task) in PAGE
    picture = ROOT / "docs" / "evaluate" / "tasks" / f"{name}_{task}.png"
    with Image.open(picture) as drawn:
        assert drawn.size == experts.PICTURE_SIZE
    assert picture.stat().st_size < 80_000


def test_the_figures_on_the_page_meet_the_criteria() -> None:
    """A page written by a short or a failed measurement is not to be kept."""
    rows = re.findall(r"^\| `(\w+)` \| (.*) \|$", PAGE, re.MULTILINE)
    assert [task for task, _ in rows] == [task for _, task in SHOWN]
    for task, cells in rows:
        of = [(int(n), int(m)) for n, m in re.findall(r"(\d+) of (\d+)", cells)]
        *expert, still, random = of
        assert expert, task
        for successes, seeds in expert:
            assert seeds >= 100, task
            assert successes >= experts.EXPERT_AT_LEAST * seeds, task
        for successes, seeds in (still, random):
            assert successes <= experts.LUCK_AT_MOST * seeds, task


def test_an_expert_rejects_an_unknown_instruction() -> None:
    expert = TabletopExpert()
    with pytest.raises(RuntimeError, match="reset"):
        expert.act({})
    with pytest.raises(KeyError):
        expert.reset("Juggle the cubes.")
