"""The kit's model of a run: what it allows, what it refuses, and in which order."""

import inspect
import re
from dataclasses import replace
from typing import Any

import pytest

from conformance.oracle import allowed_answers, linearizability, run_model
from conformance.oracle.allowed_answers import Deviation, PossibleRuns, advance
from conformance.oracle.linearizability import TimedExchange, explain, split_command
from conformance.oracle.run_model import (
    AnswerSummary,
    Attach,
    Detach,
    EpisodeModel,
    Heartbeat,
    Predict,
    Read,
    ReadEpisodes,
    Request,
    Resume,
    Rules,
    RunModel,
    Step,
    Stop,
)
from conformance.specification.document import load_spec
from conformance.specification.ledger import load_ledger
from tests.support.kit.run_answers import refused, run

RULES = Rules.of(load_spec().lifecycle, max_workers=1, max_steps=3, max_attempts=2)
START: PossibleRuns = frozenset({RunModel("ready", (EpisodeModel(), EpisodeModel()))})
STEP, END = Step(0.25), Step(0.5, success=1, end=1)


def shown(
    index: int | None, step: int, attempt: int = 1, **more: Any
) -> dict[str, Any]:
    """The part of a turn that shows an episode."""
    if index is None:
        return {"done": True, **more}
    episode = {"index": index, "step": step, "attempt": attempt}
    return {
        "done": False,
        "episode": episode,
        "observation": {"state": {"count": [step]}},
        **more,
    }


def turn_0(
    session: str, index: int | None, step: int = 0, attempt: int = 1
) -> AnswerSummary:
    turn = shown(index, step, attempt, session_id=session, seq=0)
    return AnswerSummary(200, None, {**turn, "executed_steps": 0, "rewards": []})


def turn(
    session: str, seq: int, steps: list[Step], view: dict[str, Any]
) -> AnswerSummary:
    body = {
        "session_id": session,
        "seq": seq,
        "executed_steps": len(steps),
        "stopped_early": False,
        "rewards": [step.score for step in steps],
        "terminated": bool(steps[-1].end),
        "truncated": False,
        **view,
    }
    return AnswerSummary(200, None, body)


def result(index: int, steps: int, attempt: int = 1) -> dict[str, Any]:
    outcome = {"outcome": "success", "score": 0.5}
    return {"index": index, "steps": steps, "attempt": attempt, **outcome}


def after(
    *exchanges: tuple[Request, AnswerSummary], models: PossibleRuns = START
) -> PossibleRuns:
    for request, summary in exchanges:
        for part in split_command(request, summary):
            models = advance(RULES, models, part, summary)
    return models


OPEN = (Attach("a", "k1"), turn_0("s1", 0))
PLAY = (Predict("a", "s1", 1, (STEP,)), turn("s1", 1, [STEP], shown(0, 1)))
TAKE = (Attach("a", "k2", takeover=True), turn_0("s2", 0, step=1))
FINISH = (
    Predict("a", "s1", 2, (END,)),
    turn("s1", 2, [END], shown(1, 0, episode_result=result(0, 2))),
)
ALL = (
    Predict("a", "s1", 3, (END,)),
    turn("s1", 3, [END], shown(None, 0, episode_result=result(1, 1))),
)
ABORT = (Stop("abort"), run("stopped", 0, 0, 0, 2))
DRAIN = (Stop("drain"), run("stopping", 1, 0, 1, 1))
OK, GONE = AnswerSummary(200, None, {}), AnswerSummary(204, None, None)

ALLOWED: dict[str, list[tuple[Request, AnswerSummary]]] = {
    "a repeated attach": [OPEN, (Attach("a", "k1"), OPEN[1])],
    "a repeated turn": [OPEN, PLAY, PLAY],
    "another body": [
        OPEN,
        PLAY,
        (replace(PLAY[0], steps=(END,)), refused("seq_conflict")),
    ],
    "a skipped turn": [
        OPEN,
        (replace(PLAY[0], seq=2), refused("seq_out_of_order", expected_seq=1)),
    ],
    "another key": [OPEN, (Attach("a", "k2"), refused("worker_busy"))],
    "one worker too many": [OPEN, (Attach("b", "k2"), refused("worker_limit"))],
    "a takeover": [
        *(OPEN, PLAY, TAKE),
        (Heartbeat("a", "s1"), refused("session_superseded")),
        (Detach("a", "s1"), refused("session_superseded")),
        (Heartbeat("a", "s2"), OK),
        (Detach("a", "s2"), GONE),
        (Detach("a", "s1"), GONE),
        (Read(), run("ready", 0, 0, 0, 2)),
        (Attach("a", "k3"), turn_0("s3", 0, attempt=2)),
    ],
    "the end": [
        *(OPEN, PLAY, FINISH, ALL, ALL),
        (Predict("a", "s1", 4, (STEP,)), refused("no_episode")),
        (Read(), run("completed", 0, 2, 0, 0)),
        (Attach("b", "k2"), refused("illegal_transition", state="completed")),
        (Resume(), refused("illegal_transition", state="completed")),
    ],
    "an abort": [
        *(OPEN, PLAY, ABORT),
        (Predict("a", "s1", 2, (STEP,)), refused("session_ended")),
        (Resume(), run("queued", 0, 0, 0, 2)),
        (Read(), run("ready", 0, 0, 0, 2)),
        (Attach("a", "k2"), turn_0("s2", 0, attempt=2)),
    ],
    "an attempt without an action": [
        *(OPEN, ABORT),
        (Resume(), run("ready", 0, 0, 0, 2)),
        (Attach("a", "k2"), turn_0("s2", 0)),
    ],
    "a drain": [
        *(OPEN, PLAY, DRAIN),
        (FINISH[0], turn("s1", 2, [END], shown(None, 0, episode_result=result(0, 2)))),
        (Read(), run("stopped", 0, 1, 0, 1)),
    ],
    "two attempts given up": [
        *(OPEN, PLAY, (Detach("a", "s1"), GONE)),
        (Attach("a", "k2"), turn_0("s2", 0, attempt=2)),
        (Predict("a", "s2", 1, (STEP,)), turn("s2", 1, [STEP], shown(0, 1, attempt=2))),
        (Stop("abort"), run("stopped", 0, 1, 0, 1)),
        (
            ReadEpisodes(),
            AnswerSummary(
                200,
                None,
                [
                    {
                        "index": 0,
                        "status": "scored",
                        "attempt": 2,
                        "result": {"outcome": "abandoned", "score": 0.0},
                    },
                    {"index": 1, "status": "pending", "attempt": 1},
                ],
            ),
        ),
    ],
}


@pytest.mark.parametrize("name", ALLOWED)
def test_model_allows(name: str) -> None:
    assert after(*ALLOWED[name])


FORBIDDEN: dict[str, tuple[list[tuple[Request, AnswerSummary]], str]] = {
    "an old session_id": ([OPEN, PLAY, (TAKE[0], turn_0("s1", 0, step=1))], "ATT-004"),
    "another turn": ([OPEN, PLAY, (PLAY[0], turn("s1", 1, [END], {}))], "PRED-002"),
    "a lost step": ([OPEN, PLAY, (TAKE[0], turn_0("s2", 0))], "ATT-004"),
    "the wrong episode": ([(OPEN[0], turn_0("s1", 1))], "EPI-001"),
    "a second worker": ([OPEN, (Attach("b", "k2"), turn_0("s2", 1))], "ATT-006"),
    "a living session": ([OPEN, ABORT, (Heartbeat("a", "s1"), OK)], "STOP-002"),
    "a missing count": ([OPEN, (PLAY[0], AnswerSummary(200, None, []))], "PRED-001"),
    "an attach when stopped": ([ABORT, OPEN], "LIFE-501"),
    "a run in play": ([OPEN, (Stop("abort"), run("stopped", 1, 0, 1, 1))], "RUN-014"),
}


@pytest.mark.parametrize("name", FORBIDDEN)
def test_model_forbids(name: str) -> None:
    exchanges, rule = FORBIDDEN[name]
    with pytest.raises(Deviation, match=rule):
        after(*exchanges)


def at(
    exchanges: tuple[Request, AnswerSummary], started_at: float, ended_at: float
) -> TimedExchange:
    return TimedExchange(*exchanges, started_at, ended_at)


def test_requests_at_the_same_time_may_have_any_order() -> None:
    busy = (Attach("a", "k2"), refused("worker_busy"))
    assert explain(RULES, START, [at(busy, 0, 2), at(OPEN, 0, 2)])
    assert not explain(RULES, START, [at(busy, 0, 1), at(OPEN, 2, 3)])
    both = [at(OPEN, 0, 2), at((Attach("a", "k2"), turn_0("s2", 0)), 0, 2)]
    assert not explain(RULES, START, both)


def test_run_in_an_answer_may_be_seen_later() -> None:
    resumed = (Resume(), run("ready", 0, 0, 0, 2))
    late = (ABORT[0], run("ready", 0, 0, 0, 2))
    assert explain(RULES, START, [at(late, 0, 9), at(resumed, 1, 8)])
    assert not explain(RULES, START, [at(late, 0, 1), at(resumed, 2, 3)])


def test_session_that_ends_in_its_turn_leaves_what_it_has_done() -> None:
    opened, ended = after(OPEN), refused("session_ended")
    cut = at((PLAY[0], ended), 0, 2)
    found = explain(RULES, opened, [cut, at(ABORT, 0, 2)])
    assert found
    # No request ended it: it is not the session that ended.
    assert not explain(RULES, opened, [cut])
    again = (Resume(), run("ready", 0, 0, 0, 2))
    for attempt in (1, 2):
        anew = (Attach("a", "k2"), turn_0("s2", 0, attempt=attempt))
        exchanges = [cut, at(ABORT, 0, 2), at(again, 3, 4), at(anew, 5, 6)]
        assert explain(RULES, opened, exchanges)


def test_turn_takes_its_seq_before_it_has_its_effect() -> None:
    opened = after(OPEN)
    long = at(PLAY, 0, 9)
    other = at((replace(PLAY[0], steps=(END,)), refused("seq_conflict")), 0, 1)
    summary = at((Read(), run("running", 1, 0, 1, 1)), 2, 3)
    cut = at((PLAY[0], refused("session_ended")), 0, 9)
    assert explain(RULES, opened, [other, summary, long])
    assert explain(RULES, opened, [other, cut, at((Detach("a", "s1"), GONE), 4, 5)])
    assert not explain(RULES, opened, [other, at(PLAY, 2, 3)])


def test_session_that_ends_while_it_opens_is_refused() -> None:
    cut = at((OPEN[0], refused("session_ended")), 0, 2)
    assert explain(RULES, START, [cut, at(ABORT, 0, 2)])
    assert not explain(RULES, START, [cut])


def test_model_cites_rules_that_exist() -> None:

    for module in (run_model, allowed_answers, linearizability):
        cited = re.findall(r"\b[A-Z]{2,6}-\d{3}\b", inspect.getsource(module))
        assert set(cited) <= set(load_ledger())
