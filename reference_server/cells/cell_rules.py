"""The phases of a robot cell and the acts of its operator: a table and a few guards.

Pure: no clock, no socket, no `await`. `robot_cell.py` sends and waits. An attempt on a
robot is a *trial* of its cell: a person prepares it, the policy plays, a person judges.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Literal

from reference_record.generated.answers import Rubric
from reference_server.rules.runs.lifecycle import Refuse

CellPhase = Literal["free", "preparing", "resetting", "playing", "judging", "done"]
ServerEvent = Literal["take", "begun", "ended", "fault", "leave"]
TrialAct = Literal["ready", "stop", "judge", "void", "next"]
CellEvent = ServerEvent | TrialAct
Act = TrialAct | Literal["claim", "release", "pause", "continue"]

# PHY-009: (phase, event) → phase; a missing key refuses the act of an operator, and is
# no change for an event of the server.
TRANSITIONS: dict[tuple[CellPhase, CellEvent], CellPhase] = {
    ("free", "take"): "preparing",
    ("preparing", "ready"): "resetting",
    ("preparing", "void"): "free",
    ("preparing", "leave"): "free",
    ("preparing", "fault"): "free",
    ("resetting", "begun"): "playing",
    ("resetting", "stop"): "preparing",
    ("resetting", "fault"): "free",
    ("resetting", "leave"): "free",
    ("playing", "stop"): "judging",
    ("playing", "ended"): "judging",
    ("playing", "fault"): "free",
    ("playing", "leave"): "free",
    ("judging", "judge"): "done",
    ("judging", "void"): "free",
    ("judging", "fault"): "free",
    ("judging", "leave"): "free",
    ("done", "next"): "free",
}
_OF_A_TRIAL = frozenset({"ready", "judge", "void", "next"})


@dataclass(frozen=True, slots=True)
class OperatorAct:
    """An act that an operator asks for. trial: the number that its page shows.

    met: numbers of the rubric's criteria, from 0, that were met.
    """

    act: Act
    operator: str
    trial: int | None = None
    reason: str = ""
    success: bool | None = None
    met: Sequence[int] = ()
    note: str = ""
    takes_over: bool = False


@dataclass(frozen=True, slots=True)
class Judgement:
    """The judgement of a person. score: 1 for a success, else by what was met.

    blind: whether the person knew nothing of the policy. cell: where it was played.
    """

    judge: str
    success: bool
    score: float
    met: Sequence[int]
    note: str
    blind: bool = True
    cell: str = ""


@dataclass(slots=True)
class CellState:
    """number: of the trial that the cell has, or had last; from 1.

    stopped_by: why the trial ended or was stopped. notice: what became of the trial
    before, for the operator. voids: how many were void, by their reason.
    """

    phase: CellPhase = "free"
    number: int = 0
    operator: str | None = None
    is_paused: bool = False
    stopped_by: str = ""
    notice: str = ""
    judgement: Judgement | None = None
    voids: dict[str, int] = field(default_factory=dict)


def refuse_act(state: CellState, act: OperatorAct, rubric: Rubric) -> Refuse | None:
    """Why the act is refused; None if it is not. PHY-005: a stop never is."""
    if act.act == "stop":
        return None
    takes = act.act == "claim" and (act.takes_over or state.operator is None)
    if state.operator != act.operator and not takes:
        holder = state.operator or "no operator"
        return _refusal(f"{holder} operates the cell: claim it first", "PHY-012")
    if act.act in _OF_A_TRIAL:
        return _refuse_for_trial(state, act, rubric)
    return None


def _refuse_for_trial(
    state: CellState, act: OperatorAct, rubric: Rubric
) -> Refuse | None:
    if act.trial != state.number:
        return _refusal(
            f"trial {act.trial} is over; the cell has trial {state.number}", "PHY-011"
        )
    if (state.phase, act.act) not in TRANSITIONS:
        return _refusal(f"a cell that is {state.phase} takes no {act.act}", "PHY-010")
    if act.act == "void" and not act.reason:
        return _invalid("/reason", "a void trial needs its reason")  # PHY-018
    if act.act == "judge" and act.success is None:
        return _invalid("/success", "a judgement needs an answer, yes or no")  # PHY-033
    return refuse_criteria(act.met, rubric)


def refuse_criteria(met: Sequence[int], rubric: Rubric) -> Refuse | None:
    """Why a judgement does not fit the rubric; None if it does."""
    criteria = len(rubric["criteria"])
    if any(not 0 <= number < criteria for number in met):
        return _invalid("/met", f"the rubric has {criteria} criteria")
    return None


def score_of(success: bool, met: Sequence[int], rubric: Rubric) -> float:
    """PHY-017: 1 for a success; k / (n + 1) for k of the n criteria."""
    if success:
        return 1.0
    return len(set(met)) / (len(rubric["criteria"]) + 1)


def apply(state: CellState, event: CellEvent, why: str = "") -> bool:
    """Change the phase as the table says; whether it has such a row."""
    after = TRANSITIONS.get((state.phase, event))
    if after is None:
        return False
    if event == "take":
        state.number += 1
        state.stopped_by, state.judgement = "", None
    if event in ("stop", "ended"):
        state.stopped_by = why
    if event == "void":
        state.voids[why] = state.voids.get(why, 0) + 1
    if event == "stop" and after == "judging":
        state.notice = ""
    elif event in _NOTICES:
        state.notice = f"Trial {state.number}: {_NOTICES[event]} ({why})."
    elif event in ("judge", "next", "ended"):
        state.notice = ""
    state.phase = after
    return True


_NOTICES = {
    "void": "void",
    "fault": "the robot had a fault",
    "leave": "the policy went away",
    "stop": "its reset was stopped",
}


def apply_act(state: CellState, act: OperatorAct, rubric: Rubric) -> None:
    """Carry out an act that `refuse_act` lets pass."""
    match act.act:
        case "claim":
            state.operator = act.operator
        case "release":
            state.operator = None
        case "pause" | "continue":
            state.is_paused = act.act == "pause"
        case "judge":
            state.judgement = Judgement(
                act.operator,
                bool(act.success),
                score_of(bool(act.success), act.met, rubric),
                tuple(sorted(set(act.met))),
                act.note,
            )
            apply(state, "judge")
        case "stop":
            apply(state, "stop", f"stopped by {act.operator}")
        case "void":
            apply(state, "void", act.reason)
        case "ready" | "next":
            apply(state, act.act)


def _refusal(detail: str, rule: str) -> Refuse:
    return Refuse("illegal_transition", f"{detail}; nothing was changed.", rule)


def _invalid(pointer: str, detail: str) -> Refuse:
    text = f"The act is not valid: {detail}; nothing was changed."
    return Refuse("invalid_request", text, errors=((pointer, detail),))
