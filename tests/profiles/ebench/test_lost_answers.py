"""Lost answers of EBench: which step repeats the last one, and which is new."""

import gc

import pytest

from reference_server.profiles.ebench.lost_answers import LostAnswers
from reference_server.rules import effects
from reference_server.rules.lifecycle import Predict, Replay, decide
from reference_server.rules.run import Session
from tests.support.server.runs import ACTION, NOW, add_session, make_run


def predict(seq: int) -> Predict:
    return Predict("w", "session-of-w", seq, [ACTION])


def unconfirmed(session: Session, seq: int, request_digest: str) -> LostAnswers:
    """What is known after turn `seq` was requested and its answer not confirmed."""
    lost_answers = LostAnswers()
    lost_answers.await_confirmation(session, predict(seq), request_digest)
    return lost_answers


def test_an_equal_step_repeats_the_turn_whose_answer_is_not_confirmed() -> None:
    """EBE-013, EBE-014: the same request, and its answer was not delivered."""
    run = make_run()
    session = add_session(run)
    lost_answers = unconfirmed(session, 3, "digest")
    again = lost_answers.find_repeated_turn(session, "digest")
    assert again == predict(3)
    assert isinstance(decide(run, again, NOW), Replay)
    assert lost_answers.find_repeated_turn(session, "another digest") is None
    session.seq = 4  # by a client that counts
    assert lost_answers.find_repeated_turn(session, "digest") is None


@pytest.mark.parametrize("seq", [None, 2, 4])
def test_any_other_turn_is_a_turn_of_its_own(seq: int | None) -> None:
    session = add_session(make_run())
    lost_answers = LostAnswers() if seq is None else unconfirmed(session, seq, "digest")
    assert lost_answers.find_repeated_turn(session, "digest") is None


def test_before_the_first_turn_there_is_nothing_to_repeat() -> None:
    session = add_session(make_run(), seq=0, request=None)
    lost_answers = unconfirmed(session, 0, "digest")
    assert lost_answers.find_repeated_turn(session, "digest") is None


def test_a_turn_is_confirmed_by_the_delivery_of_its_own_answer() -> None:
    session = add_session(make_run())
    lost_answers = LostAnswers()
    lost_answers.confirm_delivery(session, 3)  # nothing was requested
    lost_answers.await_confirmation(session, predict(3), "digest")
    lost_answers.confirm_delivery(session, 4)
    assert lost_answers.find_repeated_turn(session, "digest") == predict(3)
    lost_answers.confirm_delivery(session, 3)
    assert lost_answers.find_repeated_turn(session, "digest") is None


def test_a_turn_in_execution_stays_the_unconfirmed_one() -> None:
    session = add_session(make_run(), seq=0, request=None)
    lost_answers = unconfirmed(session, 1, "first")
    effects.begin_turn(session, predict(1), 0.0)
    lost_answers.await_confirmation(session, predict(2), "next")
    assert lost_answers.find_repeated_turn(session, "first") == predict(1)


def test_sessions_that_are_dropped_are_not_kept() -> None:
    run = make_run()
    lost_answers = unconfirmed(add_session(run), 3, "digest")
    assert len(lost_answers) == 1
    run.workers.clear()
    gc.collect()
    assert len(lost_answers) == 0
