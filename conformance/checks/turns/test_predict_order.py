"""Exactly once: repeated and out-of-order turns, refused chunks (PRED)."""

import math
from typing import Any

from conformance.checks.support.given_states import (
    attach_workers,
    count,
    expect_pointer,
    require_not_seq_refusal,
    submit_and_attach,
)
from conformance.client.check_context import CheckContext
from conformance.client.run_client import WorkerClient
from conformance.runner.requirement import background, requirement
from conformance.verdicts import expect
from conformance.verdicts.expect import Inconclusive, NotApplicable, SetUpFailed


@requirement("PRED-002")
def test_pred_002_can_repeat_a_turn(context: CheckContext) -> None:
    """The response to a turn was lost twice: during an episode, and at its end.

    Expect the stored response each time, and nothing executed.
    """
    worker = submit_and_attach(context, "count", "count")
    for action in (context.action(), context.action(end=1)):
        turn = worker.predict(action, action)
        for _ in range(2):
            again = expect.ok(worker.try_predict(action, action, seq=worker.seq))
            expect.equal(again, turn, "the repeated turn")
    expect.equal(count(worker.predict(context.action())), [1], "count in episode 2")


@requirement("PRED-003")
def test_pred_003_cannot_repeat_with_another_body(context: CheckContext) -> None:
    """The last seq again with another action, another length, another `observe`.

    Expect `seq_conflict` and nothing executed; the original body is accepted again.
    """
    worker = submit_and_attach(context, "count")
    action, other = context.action(), context.action(score=0.5)
    worker.predict(action)
    last = worker.seq
    expect.refused(worker.try_predict(other, seq=last), "seq_conflict")
    expect.refused(worker.try_predict(action, action, seq=last), "seq_conflict")
    answer = worker.try_predict(action, seq=last, observe="all")
    expect.refused(answer, "seq_conflict")
    expect.require(worker.try_predict(action, seq=last), 200, "repeating the true body")
    expect.equal(count(worker.predict(other)), [2], "count in the next turn")


@requirement("PRED-004")
def test_pred_004_cannot_skip_or_go_back(context: CheckContext) -> None:
    """A seq too high and, after some turns, too low.

    Expect `seq_out_of_order` with the next seq in `expected_seq`, and nothing executed.
    """
    worker = submit_and_attach(context, "count")
    for wrong, following in (([2, 3, 2**53 - 1], 1), ([1, 2, 5, 6], 4)):
        for seq in wrong:
            answer = worker.try_predict(context.action(), seq=seq)
            expect.refused(answer, "seq_out_of_order", expected_seq=following)
        turn = worker.predict(context.action())
        expect.equal(count(turn), [following], "count in the next turn")
        worker.predict(context.action())
        worker.predict(context.action())


@requirement("PRED-005")
@background
def test_pred_005_repeat_waits_for_the_first(context: CheckContext) -> None:
    """A client repeats a turn while it is executed.

    Expect the same response to both, and the action executed once.
    """
    worker = submit_and_attach(context, "delay")
    action = context.action(delay_s=0.5)
    first, second = context.call_concurrently(*[lambda: worker.try_predict(action)] * 2)
    if max(first.started_at, second.started_at) > min(first.ended_at, second.ended_at):
        raise Inconclusive("the two requests did not overlap")
    turns = [expect.ok(first), expect.ok(second)]
    expect.equal(turns[1], turns[0], "the answer to the other request")
    worker.seq += 1
    expect.equal(count(worker.predict(context.action())), [2], "count in the next turn")


@requirement("PRED-010")
def test_pred_010_can_repeat_the_last_turn(context: CheckContext) -> None:
    """The response to the last turn of the run was lost.

    Expect it again when the `predict` is repeated, although the run is completed.
    """
    worker = submit_and_attach(context, "score")
    turn = worker.play(score=0.25)
    worker.run.until("completed")
    action = context.action(score=0.25, end=1)
    for _ in range(2):
        again = expect.ok(worker.try_predict(action, seq=worker.seq))
        expect.equal(again, turn, "the repeated turn")


@requirement("PRED-011")
def test_pred_011_cannot_play_on_when_done(context: CheckContext) -> None:
    """A session with `done` sends another turn, while another worker still plays and
    after the run has completed.

    Expect `no_episode` both times.
    """
    most = min(2, context.limits["max_workers"])
    workers = attach_workers(context.submit(*["score"] * most), most)
    for worker in workers:
        if not worker.play()["done"]:
            text = "the turn after the last episode is not `done`"
            raise SetUpFailed(text, breaks="PRED-009")
        expect.refused(worker.try_predict(context.action()), "no_episode")


def expect_invalid_values(
    worker: WorkerClient, values: dict[str, Any], *pointers: str, msgpack: bool = False
) -> None:
    """Expect an action refused with a pointer to its values."""
    answer = require_not_seq_refusal(
        worker.try_predict({"values": values}, msgpack=msgpack)
    )
    problem = expect.refused(answer, "invalid_request")
    expect_pointer(problem, *[f"/actions/0/values{pointer}" for pointer in pointers])


def expect_only_one_executed(
    worker: WorkerClient, executed: int, **values: Any
) -> None:
    """Expect that only this action was executed since the `executed` ones."""
    turn = worker.predict(worker.run.context.action(**values))
    expect.equal(count(turn), [executed + 1], "count in the next turn")


@requirement("PRED-013")
def test_pred_013_cannot_send_a_wrong_length(context: CheckContext) -> None:
    """Vectors too short, too long and empty.

    Expect `invalid_request` pointing at the vector, and nothing executed.
    """
    worker = submit_and_attach(context, "count")
    good = context.action()["values"]
    for name, length in (("vector", 7), ("vector", 9), ("score", 2), ("clipped", 0)):
        expect_invalid_values(worker, good | {name: [0.0] * length}, f"/{name}")
    expect_only_one_executed(worker, 0)


@requirement("PRED-014")
def test_pred_014_cannot_send_unknown_or_missing_names(context: CheckContext) -> None:
    """An unknown name, a missing name, and a misspelt one.

    Expect `invalid_request` pointing at it, and nothing executed.
    """
    worker = submit_and_attach(context, "count")
    good = context.action()["values"]
    less = {name: vector for name, vector in good.items() if name != "vector"}
    expect_invalid_values(worker, good | {"gripper": [0.0]}, "/gripper")
    expect_invalid_values(worker, less, "", "/vector")
    expect_invalid_values(worker, less | {"Vector": good["vector"]}, "", "/Vector")
    expect_only_one_executed(worker, 0)


@requirement("PRED-015")
def test_pred_015_cannot_send_too_long_a_chunk(context: CheckContext) -> None:
    """One action more than `max_chunk`.

    Expect `invalid_request` pointing at `/actions`, and nothing executed; the longest
    chunk is accepted.
    """
    longest = context.benchmark["max_chunk"]
    worker = submit_and_attach(context, "count", max_steps=min(10000, longest + 2))
    chunk = [context.action()] * (longest + 1)
    answer = worker.try_predict(*chunk)
    if answer.code == "body_too_large":
        raise NotApplicable("a chunk longer than `max_chunk` is too large a body")
    expect.refused(answer, "invalid_request", pointer="/actions")
    expect_only_one_executed(worker, 0)
    worker.predict(*chunk[1:])


@requirement("PRED-016")
def test_pred_016_cannot_send_nan_or_infinity(context: CheckContext) -> None:
    """Numbers that JSON cannot carry, in MessagePack.

    Expect `invalid_request` pointing at them, and nothing executed.
    """
    worker = submit_and_attach(context, "count")
    good = context.action()["values"]
    for value in (math.nan, math.inf, -math.inf):
        for name, size in (("vector", 8), ("clipped", 2), ("score", 1)):
            bad = good | {name: [0.0] * (size - 1) + [value]}
            expect_invalid_values(worker, bad, f"/{name}", msgpack=True)
    turn = worker.predict(context.action(), msgpack=True)
    expect.equal(count(turn), [1], "count in the next turn")


@requirement("PRED-017")
def test_pred_017_cannot_send_values_out_of_range(context: CheckContext) -> None:
    """Values just outside their range, and at its ends.

    Expect `invalid_request` pointing at those outside, and nothing executed.
    """
    worker = submit_and_attach(context, "count")
    good = context.action()["values"]
    above, below = math.nextafter(1, 2), -5e-324
    for name, value in (
        ("score", above),
        ("score", below),
        ("success", 1.5),
        ("end", -1),
        ("delay_s", 5.001),
        ("fault", 3),
    ):
        expect_invalid_values(worker, good | {name: [value]}, f"/{name}")
    expect_only_one_executed(worker, 0, score=0, delay_s=0)
    expect_only_one_executed(worker, 1, score=1, success=1, delay_s=5, fault=2)


@requirement("PRED-018")
def test_pred_018_clips_where_declared(context: CheckContext) -> None:
    """Values outside a range declared `clip`, and inside it.

    Expect the nearest value of the range executed.
    """
    worker = submit_and_attach(context, "count")
    for sent, executed in (
        ([-5, 7], [-1, 1]),
        ([0.25, -0.5], [0.25, -0.5]),
        ([1e300, math.nextafter(-1, -2)], [1, -1]),
    ):
        turn = expect.ok(worker.try_predict(context.action(clipped=sent)))
        worker.seq += 1
        expect.equal(turn["observation"]["state"]["clipped"], executed, "clipped")


@requirement("PRED-019")
def test_pred_019_one_bad_action_refuses_the_chunk(context: CheckContext) -> None:
    """A chunk of valid actions with one invalid: first, in the middle, last.

    Expect the whole chunk refused, and nothing executed; without it, all are executed.
    """
    worker = submit_and_attach(context, "count")
    good, bad = context.action(), context.action(vector=[0.0] * 7)
    expect.require(worker.try_predict(bad), 422, "the bad action alone")
    for place in (0, 1, 2):
        chunk = [good, good]
        chunk.insert(place, bad)
        answer = require_not_seq_refusal(worker.try_predict(*chunk))
        expect.refused(answer, "invalid_request")
    turn = worker.predict(good, good)
    expect.equal(count(turn), [2], "count in the next turn")


@requirement("PRED-024")
def test_pred_024_refusal_does_not_use_up_seq(context: CheckContext) -> None:
    """A turn is refused, then sent again with the same seq and its error corrected.

    Expect it accepted.
    """
    worker = submit_and_attach(context, "count")
    bad = context.action(vector=[0.0] * 7)
    for seq in (1, 2):
        expect.require(worker.try_predict(bad), 422, "a bad action")
        expect.require(worker.try_predict(context.action(), seq=9), 409, "a wrong seq")
        turn = expect.ok(worker.try_predict(context.action(), seq=seq))
        worker.seq += 1
        expect.equal(turn["seq"], seq, "seq")
        expect.equal(count(turn), [seq], "count")
