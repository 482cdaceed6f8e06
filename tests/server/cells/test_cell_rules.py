"""The phases of a cell, the acts of its operator, and the order of its trials."""

from __future__ import annotations

import re
from pathlib import Path
from types import SimpleNamespace
from typing import Any, get_args

import pytest

from reference_record.generated.answers import Rubric
from reference_server.cells.act_log import ActLine, ActLog
from reference_server.cells.cell_queue import CellQueue
from reference_server.cells.cell_rules import (
    TRANSITIONS,
    CellPhase,
    CellState,
    OperatorAct,
    ServerEvent,
    TrialAct,
    apply,
    apply_act,
    refuse_act,
)
from reference_server.cells.judged_run import judged_run
from reference_server.cells.robot_cell import RobotCell
from reference_server.cells.trial_order import next_run
from tests.support.cells.stop_cases import UNANSWERED
from tests.support.paths import ROOT

RUBRIC: Rubric = {
    "success": "It is there.",
    "criteria": ["It was touched.", "It moved."],
}
PHASES: tuple[CellPhase, ...] = get_args(CellPhase)
EVENTS = (*get_args(ServerEvent), *get_args(TrialAct))


def state(phase: CellPhase = "free", **members: Any) -> CellState:
    return CellState(phase=phase, number=3, **({"operator": "olga"} | members))


def act(name: Any, **members: Any) -> OperatorAct:
    given: dict[str, Any] = {"operator": "olga", "trial": 3} | members
    return OperatorAct(name, **given)


def stated_table() -> dict[tuple[str, str], str]:
    """The table of phases of the specification."""
    text = (ROOT / "spec/profiles/physical.md").read_text()
    lines = re.findall(r"^\|(.*)\|$", text, re.MULTILINE)
    rows = [[cell.strip(" `") for cell in line.split("|")] for line in lines]
    header = next(row for row in rows if row[:2] == ["phase", "take"])
    return {
        (row[0], event): after
        for row in rows
        if row[0] in PHASES and len(row) == len(header)
        for event, after in zip(header[1:], row[1:], strict=True)
        if after
    }


def test_the_table_is_that_of_the_specification() -> None:
    assert {str(key): after for key, after in TRANSITIONS.items()} == {
        str(key): after for key, after in stated_table().items()
    }


@pytest.mark.parametrize("phase", PHASES)
@pytest.mark.parametrize("event", EVENTS)
def test_an_event_without_a_row_changes_nothing(phase: CellPhase, event: Any) -> None:
    now = state(phase)
    after = TRANSITIONS.get((phase, event))
    assert apply(now, event, "why") == (after is not None)
    assert now.phase == (after or phase)


@pytest.mark.parametrize("phase", PHASES)
@pytest.mark.parametrize("name", ["ready", "judge", "void", "next"])
def test_an_act_is_refused_where_the_table_has_no_row(
    phase: CellPhase, name: Any
) -> None:
    refused = refuse_act(state(phase), act(name, reason="why", success=True), RUBRIC)
    assert (refused is None) == ((phase, name) in TRANSITIONS)
    assert refused is None or refused.requirement == "PHY-010"


@pytest.mark.parametrize("phase", PHASES)
@pytest.mark.parametrize("operator", [None, "olga", "otto"])
def test_a_stop_is_never_refused(phase: CellPhase, operator: str | None) -> None:
    now = state(phase, operator=operator)
    assert refuse_act(now, act("stop", trial=None), RUBRIC) is None
    apply_act(now, act("stop"), RUBRIC)
    assert now.phase == TRANSITIONS.get((phase, "stop"), phase)


@pytest.mark.parametrize(
    ("now", "wanted", "rule"),
    [
        (state(operator=None), act("claim"), None),
        (state(operator="olga"), act("claim"), None),
        (state(operator="otto"), act("claim"), "PHY-012"),
        (state(operator="otto"), act("claim", takes_over=True), None),
        (state("preparing", operator="otto"), act("ready"), "PHY-012"),
        (state("preparing", operator=None), act("ready"), "PHY-012"),
        (state(operator="otto"), act("pause"), "PHY-012"),
        (state(), act("release", trial=None), None),
        (state("preparing"), act("ready", trial=2), "PHY-011"),
        (state("judging"), act("judge", trial=None), "PHY-011"),
    ],
)
def test_one_account_operates_the_trial_that_it_sees(
    now: CellState, wanted: OperatorAct, rule: str | None
) -> None:
    refused = refuse_act(now, wanted, RUBRIC)
    assert (refused and refused.requirement) == rule


@pytest.mark.parametrize(
    ("wanted", "pointer"),
    [
        (act("void"), "/reason"),
        (act("judge"), "/success"),
        (act("judge", success=True, met=[2]), "/met"),
        (act("judge", success=False, met=[0, -1]), "/met"),
    ],
)
def test_an_incomplete_act_is_refused(wanted: OperatorAct, pointer: str) -> None:
    refused = refuse_act(state("judging"), wanted, RUBRIC)
    assert refused is not None
    assert refused.errors[0][0] == pointer
    if pointer == "/success":  # which the page of the operator says in these words
        assert UNANSWERED in refused.detail


@pytest.mark.parametrize(
    ("success", "met", "score"),
    [(True, [], 1.0), (False, [], 0.0), (False, [1], 1 / 3), (False, [0, 1, 1], 2 / 3)],
)
def test_a_score_follows_from_the_rubric(
    success: bool, met: list[int], score: float
) -> None:
    now = state("judging")
    apply_act(now, act("judge", success=success, met=met, note="n"), RUBRIC)
    assert now.phase == "done"
    assert now.judgement is not None
    assert now.judgement.score == pytest.approx(score)


def test_void_trials_are_counted_by_reason() -> None:
    now = state("judging")
    for reason in ("dark", "dark", "broken"):
        now.phase = "judging"
        apply_act(now, act("void", reason=reason), RUBRIC)
    assert now.voids == {"dark": 2, "broken": 1}
    assert "broken" in now.notice


def test_claims_pauses_and_releases_change_what_they_say() -> None:
    now = state(operator=None)
    apply_act(now, act("claim"), RUBRIC)
    apply_act(now, act("pause"), RUBRIC)
    assert (now.operator, now.is_paused) == ("olga", True)
    apply_act(now, act("continue"), RUBRIC)
    apply_act(now, act("release"), RUBRIC)
    assert (now.operator, now.is_paused) == (None, False)


def test_policies_take_turns_in_blocks_and_none_is_always_first() -> None:
    """Two runs that always wait. Expect each once a block, and both orders."""
    taken = {"run_a": 0, "run_b": 0}
    order = []
    for _ in range(40):
        waiting = list(taken.items())
        run_id = waiting[next_run(waiting, 7)][0]
        taken[run_id] += 1
        order.append(run_id)
    blocks = [tuple(order[at : at + 2]) for at in range(0, 40, 2)]
    assert {len(set(block)) for block in blocks} == {2}
    assert len(set(blocks)) == 2


def test_the_acts_outlive_a_crash_that_cuts_a_line(tmp_path: Path) -> None:
    path = tmp_path / "acts.jsonl"
    acts = ActLog(path)
    acts.add(act="void", reason="dark")
    name = acts.pseudonym("olga")
    path.write_bytes(path.read_bytes() + b'{"act": "jud')
    again = ActLog(path)
    again.open()
    again.add(act="next")
    assert again.pseudonym("olga") == name != again.pseudonym("otto")
    read = ActLog(path)
    read.open()
    assert [line.get("act") for line in read.lines] == [None, "void", "next"]


def test_a_restarted_server_goes_on_counting() -> None:
    """Expect a new number for the next trial, and the turns of each run kept."""
    acts = ActLog(None)
    acts.add(cell="other", act="ready", trial=9, run="c")
    for trial, run in enumerate("aab", 1):
        acts.add(cell="arm", act="ready", trial=trial, run=run)
        acts.add(cell="arm", act="void", trial=trial, run=run, reason="dark")
    queue = CellQueue("arm", 7, acts.lines)
    cell = RobotCell("arm", {"order_seed": 7}, acts, queue)
    assert (cell.state.number, cell.state.voids) == (3, {"dark": 3})
    assert queue.trials_by_run == {"a": 2, "b": 1}


JUDGED = {"act": "judge", "operator": "olga", "note": "", "blind": True}


@pytest.mark.parametrize(
    ("acts", "expected"),
    [
        ([], None),
        ([{"act": "ready"}], None),
        ([JUDGED | {"episode": "e0"}], (["OLGA"], 1, True, {}, {})),
        (
            [
                JUDGED | {"episode": "e0", "note": "fell"},
                JUDGED | {"episode": "e1", "operator": "anna", "blind": False},
            ],
            (["ANNA", "OLGA"], 2, False, {}, {"e0": "fell"}),
        ),
        (
            [JUDGED | {"episode": "e0", "note": note} for note in ("before", "again")],
            (["OLGA"], 1, True, {}, {"e0": "again"}),
        ),
        ([{"act": "void", "reason": "dark"}] * 2, ([], 0, True, {"dark": 2}, {})),
    ],
)
def test_a_run_shows_how_it_was_judged(
    acts: list[ActLine], expected: tuple[Any, ...] | None
) -> None:
    judged = judged_run(acts, str.upper)
    members = "judges", "judgements", "blind", "voids", "notes"
    assert judged == (expected and dict(zip(members, expected, strict=True)))


@pytest.mark.parametrize(
    ("cells", "text"),
    [
        ([state("done")], "The robot waits until its operator presses Next."),
        ([state(is_paused=True)], "The robot is paused by its operator."),
        ([state("playing")], "The robot is used for another attempt."),
        ([state("playing", is_paused=True)], "The robot is used for another attempt."),
        (
            [state("done"), state("judging")],
            (
                "The benchmark has 2 robots: 1 waits until its operator presses Next, "
                "1 is used for another attempt."
            ),
        ),
    ],
)
def test_an_attempt_says_for_what_it_waits(cells: list[CellState], text: str) -> None:
    queue = CellQueue("b", 0, [])
    queue.cells = [SimpleNamespace(state=state) for state in cells]
    assert queue.wait_text() == text
