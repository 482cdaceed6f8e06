"""Lost answers of EBench: which step repeats the last one, and which is new."""

import gc
from typing import Any

import pytest

from reference_server.profiles.ebench.long_chunks import LongChunks, split
from reference_server.profiles.ebench.lost_answers import LostAnswers
from reference_server.rules.runs import effects
from reference_server.rules.runs.lifecycle import Predict, Replay, decide
from reference_server.rules.runs.run import Session
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


# --- lists of steps that are longer than a turn ---


class FailingSession:
    """Plays turns; the turn with the seq `fails` fails once, before or after it ran."""

    def __init__(self, fails: int, *, is_begun: bool) -> None:
        self.session = Session("s", "w", "key", 10.0, 100, NOW)
        self.executed: list[int] = []
        self._fails, self._is_begun = fails, is_begun

    async def play(self, command: Predict) -> dict[str, Any]:
        is_failing = command.seq == self._fails
        if is_failing:
            self._fails = 0
        if is_failing and not self._is_begun:
            raise RuntimeError("no simulator is free")
        if command.seq == self.session.seq + 1:  # else it is answered again
            self.session.seq = command.seq
            self.executed.append(len(command.actions))
        if is_failing:
            raise RuntimeError("the answer was lost")
        steps = len(command.actions)
        return {"seq": command.seq, "executed_steps": steps, "done": False}


@pytest.mark.parametrize("is_begun", [False, True])
@pytest.mark.parametrize("fails", [1, 2, 3])
async def test_a_list_that_failed_goes_on_with_the_failed_turn(
    fails: int, is_begun: bool
) -> None:
    """Expect each action to be executed once, and an answer that counts them all."""
    player, chunks = FailingSession(fails, is_begun=is_begun), LongChunks()
    session = player.session
    turns = split(Predict("w", "s", 1, [ACTION] * 10), 4)
    with pytest.raises(RuntimeError):
        await chunks.start(session, "digest", turns, player.play).result()
    assert chunks.find_repeated(session, "digest") is None
    assert chunks.find_failed(session, "another") is None
    failed = chunks.find_failed(session, "digest")
    assert failed is not None
    again = chunks.start(session, "digest", failed.turns, player.play, failed.executed)
    turn = await again.result()
    assert player.executed == [4, 4, 2]
    assert (turn["executed_steps"], turn["stopped_early"]) == (10, False)
    assert chunks.find_failed(session, "digest") is None
    assert chunks.find_repeated(session, "digest") is again


async def test_a_list_that_failed_is_over_when_something_else_was_played() -> None:
    player, chunks = FailingSession(2, is_begun=False), LongChunks()
    turns = split(Predict("w", "s", 1, [ACTION] * 10), 4)
    with pytest.raises(RuntimeError):
        await chunks.start(player.session, "digest", turns, player.play).result()
    player.session.seq += 2
    assert chunks.find_failed(player.session, "digest") is None
