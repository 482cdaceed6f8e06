"""The corners of the kit's model: answers, ends and orders that are seldom met."""

from dataclasses import replace
from typing import Any, cast

import pytest

from conformance.oracle import allowed_answers, run_model
from conformance.oracle.allowed_answers import Deviation, PossibleRuns, advance
from conformance.oracle.linearizability import TimedExchange, explain
from conformance.oracle.run_model import (
    AnswerSummary,
    Attach,
    Detach,
    EpisodeModel,
    Heartbeat,
    Predict,
    Read,
    Request,
    Rules,
    RunModel,
    Step,
    Stop,
)
from conformance.specification.document import load_spec
from tests.support.kit.run_answers import refused, run

RULES = Rules.of(load_spec().lifecycle, max_workers=2, max_steps=3, max_attempts=2)
STEP, END = Step(0.25), Step(0.5, end=1)
OK, GONE = AnswerSummary(200, None, {}), AnswerSummary(204, None, None)


def one_episode_run(attempt: int = 1) -> PossibleRuns:
    """A run of one episode."""
    return frozenset({RunModel("ready", (EpisodeModel(attempt),))})


def turn(session: str, seq: int, steps: list[Step], attempt: int = 1) -> AnswerSummary:
    """An answer whose episode goes on, or the one that is done after an end."""
    body: dict[str, Any] = {
        "session_id": session,
        "seq": seq,
        "executed_steps": len(steps),
        "stopped_early": False,
        "rewards": [step.score for step in steps],
        "terminated": bool(steps and steps[-1].end),
        "truncated": False,
        "done": False,
    }
    if steps and steps[-1].end:
        result = {"index": 0, "outcome": "failure", "score": 0.5}
        result |= {"steps": len(steps), "attempt": attempt}
        return AnswerSummary(200, None, body | {"done": True, "episode_result": result})
    episode = {"index": 0, "attempt": attempt, "step": len(steps)}
    observation = {"state": {"count": [len(steps)]}}
    return AnswerSummary(
        200, None, body | {"episode": episode, "observation": observation}
    )


def advance_all(
    models: PossibleRuns, *exchanges: tuple[Request, AnswerSummary]
) -> PossibleRuns:
    for request, summary in exchanges:
        models = advance(RULES, models, request, summary)
    return models


def attach_exchange(attempt: int = 1) -> tuple[Request, AnswerSummary]:
    return Attach("a", "k1"), turn("s1", 0, [], attempt)


def two_sessions() -> PossibleRuns:
    """s1 of worker a plays the first episode, s2 of worker b the second."""
    second = turn("s2", 0, [])
    second.body["episode"]["index"] = 1
    two = frozenset({RunModel("ready", (EpisodeModel(), EpisodeModel()))})
    return advance_all(two, attach_exchange(), (Attach("b", "k2"), second))


PLAY = Predict("a", "s1", 1, (STEP,))
LAST = (Predict("a", "s1", 1, (END,)), turn("s1", 1, [END]))


# --- single answers ---


def test_a_body_that_is_not_a_turn_freezes_to_nothing() -> None:
    assert run_model.turn_text(None) == run_model.turn_text([]) == ""


def test_a_member_that_must_be_absent_is_named() -> None:
    early = turn("s1", 0, [])
    body = early.body | {"episode_result": {}}
    with pytest.raises(Deviation, match="episode_result absent"):
        advance_all(
            one_episode_run(), (attach_exchange()[0], replace(early, body=body))
        )


def test_an_unmodelled_request_has_no_demands() -> None:
    (model,) = one_episode_run()
    assert (
        list(allowed_answers.allowed_answers(RULES, model, cast(Any, "get_run"))) == []
    )


def test_a_second_detach_succeeds() -> None:
    gone = advance_all(one_episode_run(), attach_exchange(), (Detach("a", "s1"), GONE))
    assert advance_all(gone, (Detach("a", "s1"), GONE)) == gone
    with pytest.raises(Deviation, match="DET-002"):
        advance_all(gone, (Detach("a", "s1"), refused("session_ended")))


def test_abort_of_the_last_attempt_completes_the_run() -> None:
    played = advance_all(
        one_episode_run(attempt=2),
        attach_exchange(attempt=2),
        (PLAY, turn("s1", 1, [STEP], attempt=2)),
    )
    after = advance_all(played, (Stop("abort"), OK))
    assert advance_all(after, (Read(), run("completed", 0, 1, 0, 0)))
    for state, scored in (("stopped", 1), ("completed", 0)):
        with pytest.raises(Deviation):
            advance_all(after, (Read(), run(state, 0, scored, 0, 1 - scored)))


def test_abort_ends_a_session_that_is_done() -> None:
    """It holds no episode, so nothing is given back with it."""
    draining = advance_all(
        two_sessions(),
        (Stop("drain"), OK),
        LAST,
        (Stop("abort"), OK),
    )
    assert advance_all(draining, (Read(), run("stopped", 0, 1, 0, 1)))
    # No rule says what becomes of its kept turn: both are allowed, see STOP-002.
    assert advance_all(draining, LAST)
    assert advance_all(draining, (LAST[0], refused("session_ended")))


def limit_reached() -> AnswerSummary:
    return AnswerSummary(429, "worker_limit", {"code": "worker_limit"})


def test_a_session_that_is_done_holds_no_slot() -> None:
    full = two_sessions()
    assert advance_all(full, (Attach("c", "k3"), limit_reached()))
    one_is_done = advance_all(full, LAST)
    with pytest.raises(Deviation, match="ATT-012"):
        advance_all(one_is_done, (Attach("c", "k3"), limit_reached()))


def test_a_done_session_may_be_given_to_its_key_after_a_later_one() -> None:
    """Whether it still counts as live for its key is the server's choice."""
    body = {"session_id": "s3", "seq": 0, "executed_steps": 0, "rewards": []}
    later = AnswerSummary(200, None, body | {"done": True})
    two = advance_all(two_sessions(), LAST, (Attach("a", "k3"), later))
    assert advance_all(two, (Attach("a", "k1"), LAST[1])) == two
    assert advance_all(two, (Attach("a", "k1"), refused("worker_busy"))) == two
    for worker, key, answer in (("a", "k1", later), ("b", "k1", LAST[1])):
        with pytest.raises(Deviation):
            advance_all(two, (Attach(worker, key), answer))


def test_of_several_refusals_of_attach_any_is_allowed() -> None:
    full = two_sessions()
    for code in ("worker_busy", "worker_limit"):
        answer = limit_reached() if code == "worker_limit" else refused(code)
        assert advance_all(full, (Attach("a", "k3"), answer)) == full


def test_a_repeated_attach_is_not_refused_in_a_drain() -> None:
    draining = advance_all(two_sessions(), (Stop("drain"), OK))
    assert advance_all(draining, attach_exchange()) == draining
    illegal = refused("illegal_transition", state="stopping")
    assert advance_all(draining, (Attach("a", "k3"), illegal)) == draining
    with pytest.raises(Deviation, match="ATT-002"):
        advance_all(draining, (Attach("a", "k1"), illegal))


def test_an_episode_may_be_scored_by_its_success() -> None:
    by_success = replace(RULES, scores_success=True)
    models = advance_all(one_episode_run(), attach_exchange())
    with pytest.raises(Deviation, match=r"episode_result\.score"):
        advance(by_success, models, *LAST)


# --- orders ---


def at(
    request: Request, summary: AnswerSummary, started_at: float, ended_at: float
) -> TimedExchange:
    return TimedExchange(request, summary, started_at, ended_at)


def test_a_failed_order_is_not_tried_again() -> None:
    models = advance_all(one_episode_run(), attach_exchange())
    beats = [at(Heartbeat("a", "s1"), OK, 0, 9) for _ in range(6)]
    assert explain(RULES, models, beats)
    wrong = at(Read(), run("ready", 0, 0, 0, 1), 0, 9)
    assert not explain(RULES, models, [*beats, wrong])


@pytest.mark.parametrize(
    ("beside", "summary"),
    [
        # It was refused itself: it never took its seq.
        (PLAY, refused("worker_busy")),
        # It is not the next one.
        (replace(PLAY, seq=2), turn("s1", 2, [STEP])),
        # Another session's, or no turn at all.
        (Predict("b", "s2", 1, (STEP,)), refused("session_ended")),
        (Heartbeat("a", "s1"), OK),
    ],
    ids=["a refused turn", "a later turn", "another's turn", "no turn"],
)
def test_only_a_turn_that_has_begun_takes_its_seq(
    beside: Request, summary: AnswerSummary
) -> None:
    models = two_sessions()
    other = at(replace(PLAY, steps=(END,)), refused("seq_conflict"), 0, 9)
    assert not explain(RULES, models, [other, at(beside, summary, 0, 9)])


def test_a_turn_that_a_takeover_ends_has_taken_its_seq() -> None:
    """Beside it another body under its seq, and the seq before."""
    models = advance_all(one_episode_run(), attach_exchange())
    taken_over = Attach("a", "another key", takeover=True)
    successor = turn("s2", 0, [])
    successor.body["observation"]["state"]["count"] = [0]
    begun = at(PLAY, refused("session_superseded"), 1, 9)
    over = at(taken_over, successor, 4, 8)
    conflict = at(replace(PLAY, steps=(END,)), refused("seq_conflict"), 2, 3)
    old = at(replace(PLAY, seq=0), refused("seq_out_of_order", expected_seq=1), 2, 3)
    assert explain(RULES, models, [begun, over])
    for beside in (conflict, old):
        assert explain(RULES, models, [begun, over, beside])
        assert not explain(
            RULES, models, [over, replace(beside, started_at=10, ended_at=11)]
        )


def test_a_turn_that_has_begun_explains_only_what_follows_from_it() -> None:
    models = advance_all(one_episode_run(), attach_exchange())
    begun = at(PLAY, turn("s1", 1, [STEP]), 0, 9)
    for due, is_so in ((2, True), (3, False)):
        ahead = refused("seq_out_of_order", expected_seq=due)
        other = at(replace(PLAY, seq=3), ahead, 0, 1)
        found = explain(RULES, models, [other, replace(begun, started_at=0.5)])
        assert bool(found) == is_so


def test_an_answered_seq_is_refused_during_a_turn_by_its_seq_or_the_next() -> None:
    """Expect 2 and 3 while the turn with seq 2 is executed, and nothing else."""
    answered = (PLAY, turn("s1", 1, [STEP]))
    models = advance_all(one_episode_run(), attach_exchange(), answered)
    second = turn("s1", 2, [STEP])
    second.body["episode"]["step"], second.body["observation"]["state"]["count"] = (
        2,
        [2],
    )
    begun = at(replace(PLAY, seq=2), second, 0, 9)
    for due, is_allowed in ((1, False), (2, True), (3, True), (4, False)):
        answer = refused("seq_out_of_order", expected_seq=due)
        other = at(replace(PLAY, steps=(STEP,)), answer, 1, 2)
        assert bool(explain(RULES, models, [begun, other])) == is_allowed
