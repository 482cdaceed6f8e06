"""Exactly once: repeated and out-of-order turns, refused chunks (PRED)."""

import math
import time
from collections.abc import Sequence
from typing import Any

from conformance.checks.support.given_states import (
    attach_workers,
    count,
    expect_pointer,
    require_not_seq_refusal,
    start_drain,
    submit_and_attach,
)
from conformance.checks.support.long_turns import during_turn
from conformance.checks.support.submissions import NAMES_OF_LANGUAGES
from conformance.client.check_context import CheckContext
from conformance.client.run_client import WorkerClient
from conformance.runner.requirement import background, requirement
from conformance.verdicts import expect
from conformance.verdicts.expect import Inconclusive, NotApplicable

# So that the index of an action has two digits.
LONG_CHUNK = 12
_DELAY_S = 0.3


@requirement("PRED-002", "PRED-003", "PRED-024")
def test_pred_002_can_repeat_a_turn(context: CheckContext) -> None:
    """The response to a turn was lost, during an episode and at its end. Between the
    repeats come a heartbeat, a repeated attach, turns of another worker, refused turns,
    and the last seq with another first or last value, order, length or `observe`.
    Expect the stored response each time, `seq_conflict` for other bodies, and nothing
    executed."""
    run = context.submit("count", "count", "count")
    worker, *others = attach_workers(run, context.worker_count(2))
    first, second = context.action(), context.action(vector=[0.0] * 7 + [0.25])
    changed = context.action(vector=[0.0] * 7 + [math.nextafter(0.25, 1)])
    for chunk in ([first, second], [second, context.action(end=1)]):
        worker.try_predict(context.action(vector=[0.0] * 7))
        worker.predict(*chunk)
        for disturb in (
            worker.heartbeat if context.offers("sessions") else worker.run.get,
            lambda: [beside.predict(context.action()) for beside in others],
            lambda: worker.try_attach(attach_key=worker.attach_key),
            lambda: worker.try_predict(context.action(vector=[0.0] * 7)),
        ):
            again = worker.try_predict(*chunk, seq=worker.seq)
            expect.require(again, 200, "repeating the turn")
            disturb()
        for actions in (
            [context.action(score=1), *chunk[1:]],
            [changed if action is second else action for action in chunk],
            [chunk[0], context.action(success=1)],
            chunk[::-1],
            chunk[:1],
            [*chunk, first],
        ):
            worker.try_predict(*actions, seq=worker.seq)
        if context.offers("observations"):
            worker.try_predict(*chunk, seq=worker.seq, observe="all")
        again = worker.try_predict(*chunk, seq=worker.seq)
        expect.require(again, 200, "repeating the true body")
    worker.predict(context.action(clipped=[2.0, 0.0]))
    worker.try_predict(context.action(clipped=[3.0, 0.0]), seq=worker.seq)
    worker.predict(first)


@requirement("PRED-004", "PRED-011", "PRED-027")
def test_pred_004_cannot_skip_or_go_back(context: CheckContext) -> None:
    """A seq too high and, after some turns, too low, also that of an ended episode; a
    session that is done plays on, while another worker still plays and after the run
    has completed; it, a superseded and a detached session send wrong seqs. Expect
    `seq_out_of_order` with the next seq, before it `session_superseded` and
    `session_ended`, after it `no_episode`, and nothing executed."""
    worker, action = submit_and_attach(context, "count", "count"), context.action()
    for wrong in ((2, 3, 2**53 - 1), (1, 2, 5, 6)):
        try_seqs(worker, *wrong)
        for _ in range(3):
            worker.predict(action)
    worker.predict(context.action(end=1))
    worker.predict(action)
    try_seqs(worker, 1, worker.seq - 1, worker.seq + 2)
    worker.predict(action)
    most = context.worker_count(2)
    for done in attach_workers(context.submit(*["score"] * most), most):
        done.play()
        try_seqs(done, 2, 3, 1, 2**53 - 1)
    if not context.shared.settings.quick:
        slow = submit_and_attach(context, "delay")
        during_turn(slow, lambda: try_seqs(slow, 9))
    if context.offers("sessions"):
        run = context.submit("count", "count")
        old, new = run.worker("same"), run.worker("same")
        old.attach()
        old.predict(action)
        new.attach(takeover=True)
        try_seqs(old, 1, 2, 7)
        new.detach()
        try_seqs(new, 1, 2, 7)


def try_seqs(worker: WorkerClient, *seqs: int) -> None:
    """Send an action under each seq."""
    for seq in seqs:
        worker.try_predict(worker.run.context.action(), seq=seq)


@requirement("PRED-005")
@background
def test_pred_005_repeat_waits_for_the_first(context: CheckContext) -> None:
    """A client repeats a turn while it is executed; another time it closes the
    connection in the middle of a chunk, and repeats it at once or later. Expect the
    same response to both, and each action executed once."""
    worker = submit_and_attach(context, "delay")
    action = context.action(delay_s=0.5)
    first, second = context.call_concurrently(*[lambda: worker.try_predict(action)] * 2)
    if max(first.started_at, second.started_at) > min(first.ended_at, second.ended_at):
        raise Inconclusive("the two requests did not overlap")
    turns = [expect.ok(first), expect.ok(second)]
    expect.equal(turns[1], turns[0], "the answer to the other request")
    worker.seq += 1
    for pause_s in (0, 3 * _DELAY_S):
        repeat = worker.leave_turn(*[context.action(delay_s=_DELAY_S)] * 2, after_s=0.1)
        time.sleep(pause_s)
        expect.equal(expect.ok(repeat())["executed_steps"], 2, "executed_steps")
        worker.seq += 1
    expect.equal(count(worker.predict(context.action())), [6], "count in the next turn")


@requirement("PRED-010")
def test_pred_010_can_repeat_the_last_turn(context: CheckContext) -> None:
    """The response to the last turn of the run was lost, and of another worker, which
    was done before; and to the last turn of a drain. Expect it again when the `predict`
    is repeated, although the run is completed, or has stopped."""
    worker = submit_and_attach(context, "score")
    worker.play(score=0.25)
    worker.run.until("completed")
    action = context.action(score=0.25, end=1)
    for _ in range(2):
        expect.ok(worker.try_predict(action, seq=worker.seq))
    if context.worker_count(2) > 1:
        early, late = attach_workers(context.submit("score", "score"), 2)
        early.play(score=0.25)
        late.play()
        late.run.until("completed")
        expect.ok(early.try_predict(action, seq=early.seq))
    if not context.offers("control"):
        return
    drained = submit_and_attach(context, "score", "score")
    start_drain(drained.run)
    drained.play(score=0.25)
    drained.run.until("stopped")
    expect.ok(drained.try_predict(action, seq=drained.seq))


def expect_invalid(
    worker: WorkerClient,
    before: list[Any],
    values: dict[str, Any],
    pointers: Sequence[str],
    **how: Any,
) -> None:
    """Expect a chunk refused for its last action, with a pointer to its values."""
    answer = worker.try_predict(*before, {"values": values}, **how)
    problem = expect.refused(require_not_seq_refusal(answer), "invalid_request")
    at = f"/actions/{len(before)}/values"
    expect_pointer(problem, *[f"{at}{pointer}" for pointer in pointers])


def expect_invalid_values(
    worker: WorkerClient, values: dict[str, Any], *pointers: str, **how: Any
) -> None:
    """Expect a single action refused with a pointer to its values."""
    expect_invalid(worker, [], values, pointers, **how)


def expect_last_bad(
    worker: WorkerClient, values: dict[str, Any], *pointers: str
) -> None:
    """Expect a chunk refused for its last action, with a pointer into that."""
    context = worker.run.context
    last = min(LONG_CHUNK, context.limits["max_chunk"]) - 1
    expect_invalid(worker, [context.action()] * last, values, pointers)


def expect_one_executed(worker: WorkerClient, executed: int, **values: Any) -> None:
    """Expect that only this action was executed since the `executed` ones."""
    turn = worker.predict(worker.run.context.action(**values))
    expect.equal(count(turn), [executed + 1], "count in the next turn")


@requirement("PRED-013")
def test_pred_013_cannot_send_a_wrong_length(context: CheckContext) -> None:
    """Every vector too short, too long and empty, in the only and in the last action.
    Expect `invalid_request` pointing at the vector, and nothing executed."""
    worker = submit_and_attach(context, "count")
    good = context.action()["values"]
    for name, vector in good.items():
        for length in sorted({0, len(vector) - 1, len(vector) + 1}):
            expect_invalid_values(worker, good | {name: [0.0] * length}, f"/{name}")
        longer = good | {name: [0.0] * (len(vector) + 1)}
        expect_last_bad(worker, longer, f"/{name}")
    expect_one_executed(worker, 0)


@requirement("PRED-014")
def test_pred_014_cannot_send_unknown_or_missing_names(context: CheckContext) -> None:
    """Unknown names, each name missing, and a misspelt one. Expect `invalid_request`
    pointing at it, and nothing executed."""
    worker = submit_and_attach(context, "count")
    good = context.action()["values"]
    less = {name: vector for name, vector in good.items() if name != "vector"}
    # Names that objects of a language have, and one that RFC 6901 writes otherwise.
    for name in ("gripper", *NAMES_OF_LANGUAGES):
        expect_invalid_values(worker, good | {name: [0.0]}, f"/{name}")
    expect_invalid_values(worker, good | {"a/b~/~": [0.0]}, "/a~1b~0~1~0")
    for missing in good:
        others = {name: vector for name, vector in good.items() if name != missing}
        expect_invalid_values(worker, others, "", f"/{missing}")
    expect_last_bad(worker, less, "", "/vector")
    expect_last_bad(worker, good | {"gripper": [0.0]}, "/gripper")
    expect_invalid_values(worker, less | {"Vector": good["vector"]}, "", "/Vector")
    expect_one_executed(worker, 0)


@requirement("PRED-015")
def test_pred_015_cannot_send_too_long_a_chunk(context: CheckContext) -> None:
    """One action more than `max_chunk`. Expect `invalid_request` pointing at
    `/actions`, and nothing executed; the longest chunk is executed completely."""
    longest = context.benchmark["max_chunk"]
    max_steps = min(10000, longest + 2)
    worker = submit_and_attach(context, "count", max_steps=max_steps)
    chunk = [context.action()] * (longest + 1)
    answer = worker.try_predict(*chunk)
    if answer.code == "body_too_large":
        raise NotApplicable("a chunk longer than `max_chunk` is too large a body")
    expect.refused(answer, "invalid_request", pointer="/actions")
    expect_one_executed(worker, 0)
    turn = expect.ok(worker.try_predict(*chunk[1:]))
    executed = min(longest, max_steps - 1)
    expect.equal(turn["executed_steps"], executed, "executed_steps of the longest")


def with_value(
    values: dict[str, Any], name: str, place: int, value: float
) -> dict[str, Any]:
    """Give the values of an action with one element of one vector replaced."""
    vector = list(values[name])
    vector[place] = value
    return values | {name: vector}


@requirement("PRED-016")
def test_pred_016_cannot_send_nan_or_infinity(context: CheckContext) -> None:
    """Numbers that JSON cannot carry, in MessagePack, as each element of the vectors.
    Expect `invalid_request` pointing at them, and nothing executed."""
    worker = submit_and_attach(context, "count")
    good = context.action()["values"]
    for value in (math.nan, math.inf, -math.inf):
        for name, place in (("vector", 0), ("vector", 7), ("clipped", 0)):
            expect_invalid_values(
                worker, with_value(good, name, place, value), f"/{name}", msgpack=True
            )
        for name in good:
            bad = with_value(good, name, -1, value)
            expect_invalid_values(worker, bad, f"/{name}", msgpack=True)
    turn = worker.predict(context.action(), msgpack=True)
    expect.equal(count(turn), [1], "count in the next turn")


@requirement("PRED-017")
def test_pred_017_cannot_send_values_out_of_range(context: CheckContext) -> None:
    """The doubles next to both ends of every range, outside and inside, in the only and
    in the last action; and the ends. Expect `invalid_request` pointing at those
    outside, and nothing executed."""
    worker = submit_and_attach(context, "count", "count")
    good = context.action()["values"]
    inside: dict[str, float] = {}
    ends = {"score": 1, "success": 1, "end": 1, "delay_s": 5, "fault": 2}
    for name, high in ends.items():
        for outside in (math.nextafter(high, 9), high + 1, -5e-324, -1):
            expect_invalid_values(worker, good | {name: [outside]}, f"/{name}")
        expect_last_bad(worker, good | {name: [high * 1.5]}, f"/{name}")
        inside[name] = math.nextafter(high, 0)
    expect_one_executed(worker, 0, score=0, delay_s=0)
    expect_one_executed(worker, 1, score=1, success=1, delay_s=5, fault=2)
    expect_one_executed(worker, 2, **inside)
    expect_one_executed(worker, 3, **dict.fromkeys(ends, 5e-324))
    expect_one_executed(worker, 4, **dict.fromkeys(ends, -0.0))
    turn = worker.predict(context.action(end=1))
    expect.equal(turn["terminated"], True, "terminated at the end of the range")


@requirement("PRED-018")
def test_pred_018_clips_where_declared(context: CheckContext) -> None:
    """Values outside a range declared `clip` and inside it, each in an action of its
    own, and all in chunks. Expect the nearest value of the range executed."""
    worker = submit_and_attach(context, "count", max_steps=1000)
    below, above = math.nextafter(-1, -2), math.nextafter(1, 2)
    low, high = math.nextafter(-1, 0), math.nextafter(1, 0)
    sent = [[-5, 7], [7, -5], [0.25, -0.5], [1e300, below], [above, -1e300]]
    sent += [[low, high], [high, 3], [-1, 1], [1 / 3, -1.7e308]]
    actions = [context.action(clipped=clipped) for clipped in sent]
    longest = min(4, context.benchmark["max_chunk"])
    observe = "all" if context.offers("observations") else None
    for size in (1, longest):
        for first in range(0, len(actions), size):
            chunk = actions[first : first + size]
            worker.predict(*chunk, observe=observe if size > 1 else None)


@requirement("PRED-019")
def test_pred_019_one_bad_action_refuses_the_chunk(context: CheckContext) -> None:
    """A chunk of valid actions with one that is invalid in some way: first, in the
    middle, last, and last of the longest chunk. Expect the whole chunk refused, and
    nothing executed; without it, all are executed."""
    worker = submit_and_attach(context, "count")
    good, bad = context.action(), context.action(vector=[0.0] * 7)
    nameless = {"values": {k: v for k, v in good["values"].items() if k != "end"}}
    longest = min(64, context.benchmark["max_chunk"])
    for wrong in (bad, nameless, context.action(score=2), context.action(end=-1)):
        expect.require(worker.try_predict(wrong), 422, "the bad action alone")
        for length, place in ((2, 0), (2, 1), (2, 2), (longest - 1, longest - 1)):
            chunk = [good] * length
            chunk.insert(place, wrong)
            answer = require_not_seq_refusal(worker.try_predict(*chunk))
            expect.refused(answer, "invalid_request")
    expect.equal(count(worker.predict(good, good)), [2], "count in the next turn")


def reversed_members(value: Any) -> Any:
    """Give an equal value whose members stand in the opposite order."""
    if isinstance(value, dict):
        return {k: reversed_members(value[k]) for k in reversed(value)}
    if isinstance(value, list):
        return [reversed_members(item) for item in value]
    return int(value) if isinstance(value, float) and value == int(value) else value


@requirement("PRED-025")
def test_pred_025_equal_values_are_the_same_body(context: CheckContext) -> None:
    """A client that writes its members in another order, 1.0 as 1, 0 as −0, repeats a
    turn; where MessagePack is offered, in that encoding, too. Expect the stored
    response; with another value, `seq_conflict`."""
    worker = submit_and_attach(context, "count")
    action = context.action(vector=[1.0, 2.0, 0.5, -4.0, 1e3, 0.0, 0.0, 0.0], score=1.0)
    body = {"session_id": worker.session_id, "seq": 1, "actions": [action, action]}
    how = {"worker_id": worker.id}
    turn = expect.require(worker.run.call("predict", json=body, **how), 200, "predict")
    signed = {"vector": [1.0, 2.0, 0.5, -4.0, 1e3, -0.0, -0.0, -0.0]}
    zeros = {"values": action["values"] | signed}
    for repeat in (body, body | {"actions": [zeros, action]}):
        worker.run.call("predict", json=reversed_members(repeat), **how)
    if context.speaks_msgpack:
        again = worker.run.call("predict", json=body, msgpack=True, **how)
        expect.equal(expect.ok(again), turn, "the turn repeated in MessagePack")
    other_body = {**body, "actions": [context.action(score=1), action]}
    answer = worker.run.call("predict", json=reversed_members(other_body), **how)
    expect.refused(answer, "seq_conflict")


@requirement("PRED-026")
@background
def test_pred_026_cannot_send_another_body_during_a_turn(context: CheckContext) -> None:
    """A client sends another body under the same seq in the middle of a turn. Expect
    one of the two executed, and `seq_conflict` for the other."""
    worker = submit_and_attach(context, "delay", max_steps=100)
    quick = [context.action()] * 2
    answers = during_turn(worker, lambda: worker.try_predict(*quick))
    if answers[1].started_at >= answers[0].ended_at:
        raise Inconclusive("the second body came after the turn")
    refused, executed = sorted(answers, key=lambda answer: answer.status == 200)
    expect.refused(refused, "seq_conflict")
    steps = 1 if executed is answers[0] else 2
    expect.equal(expect.ok(executed)["executed_steps"], steps, "executed_steps")
    worker.seq += 1
    step = worker.predict(context.action())["episode"]["step"]
    expect.equal(step, steps + 1, "step after the next turn")
