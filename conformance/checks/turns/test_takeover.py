"""Takeover: what goes over to the next session, and what does not (ATT)."""

import time
from typing import Any

from conformance.checks.support.given_states import (
    attach_workers,
    index_of,
    require_duration,
    require_not_state_refusal,
    require_worker_limit,
    results,
    start_drain,
    submit_and_attach,
)
from conformance.checks.support.long_turns import long_turn_s
from conformance.client.check_context import CheckContext
from conformance.client.run_client import WorkerClient
from conformance.exchanges.answer import Answer
from conformance.runner.requirement import background, requirement
from conformance.verdicts import expect
from conformance.verdicts.expect import Inconclusive, SetUpFailed

_NO_ACTION = {"executed_steps": 0, "rewards": [], "stopped_early": False}
_NO_ACTION |= {"terminated": False, "truncated": False}
_OF_ACTIONS = [*_NO_ACTION, "observations", "episode_result"]


def expect_new_session(worker: WorkerClient, *before: str, **how: Any) -> None:
    """Expect a takeover to open a session other than those before."""
    answer = require_not_state_refusal(worker.try_attach(takeover=True, **how))
    worker.turn = turn = expect.ok(answer)
    worker.session_id, worker.seq = turn["session_id"], turn["seq"]
    expect.true(worker.session_id not in before, "another session_id", before)


def expect_next_step(worker: WorkerClient, executed: int) -> None:
    """Expect a turn of one action, after so many executed ones."""
    turn = expect.ok(worker.try_predict(worker.run.context.action()))
    worker.seq += 1
    expect.equal(turn["episode"]["step"], executed + 1, "step after the next turn")


@requirement("ATT-016")
def test_att_016_can_repeat_an_attach_at_any_time(context: CheckContext) -> None:
    """The response to a takeover was lost; it is repeated at once, and in a drain, also
    with an assumption that would have been refused.

    Expect the same session each time, and its turn to be the next.
    """
    worker = submit_and_attach(context, "count", "count")
    worker.predict(context.action())
    worker.attach(takeover=True)
    session_id = worker.session_id
    for is_draining in (False, True) if context.offers("control") else (False,):
        if is_draining:
            start_drain(worker.run)
        for takeover in (True, False):
            again = expect.ok(
                worker.try_attach(takeover=takeover, attach_key=worker.attach_key)
            )
            expect.equal(again["session_id"], session_id, "session_id")
        if not context.offers("conventions"):
            continue
        assumes = {"control_rate_hz": 20}
        again = expect.ok(
            worker.try_attach(attach_key=worker.attach_key, assumes=assumes)
        )
        expect.equal(again["session_id"], session_id, f"session_id with {assumes}")
    expect_next_step(worker, 1)


@requirement("ATT-017")
def test_att_017_refused_takeover_changes_nothing(context: CheckContext) -> None:
    """A takeover with a wrong assumption, and one in a `stopping` run.

    Expect `convention_mismatch` and `illegal_transition`, and the session to play on;
    a takeover with the right assumption is accepted.
    """
    run = context.submit("count", "count")
    worker, successor = run.worker("same"), run.worker("same")
    worker.attach()
    worker.attach(takeover=True, assumes={"control_rate_hz": 10})
    answer = successor.try_attach(takeover=True, assumes={"control_rate_hz": 20})
    expect.refused(answer, "convention_mismatch")
    expect_next_step(worker, 0)
    start_drain(run)
    if run.worker().try_attach().status == 200:
        raise SetUpFailed("a `stopping` run accepts an attach; see LIFE-401")
    before = run.snapshot()
    expect.refused(successor.try_attach(takeover=True), "illegal_transition")
    expect.equal(run.snapshot(), before, "the run afterwards")
    expect_next_step(worker, 1)


@requirement("ATT-019")
def test_att_019_takeover_begins_with_seqs_of_its_own(context: CheckContext) -> None:
    """Three takeovers in one episode; each session sends the bodies of the one before.

    Expect seq 0 for each and its turns executed, the first session superseded also
    after the second takeover, and the result to count all steps up to `max_steps`.
    """
    run = context.submit("count", "count", max_steps=6)
    old, worker = run.worker("same"), run.worker("same")
    old.attach()
    expect_next_step(old, 0)
    for executed in (1, 3):
        worker.attach(takeover=True)
        expect.equal(worker.turn["seq"], 0, "seq of the first turn")
        expect.equal(worker.turn["executed_steps"], 0, "executed_steps")
        expect.equal(worker.turn["episode"]["step"], executed, "episode.step")
        expect_next_step(worker, executed)
        expect_next_step(worker, executed + 1)
        refused = worker.try_predict(context.action(), seq=5)
        expect.refused(refused, "seq_out_of_order", expected_seq=3)
    expect.refused(old.try_heartbeat(), "session_superseded")
    expect.refused(old.try_predict(context.action()), "session_superseded")
    worker.attach(takeover=True)
    index = index_of(worker)
    expect.ok(worker.try_predict(context.action()))
    result = results(run)[index] or {}
    expect.equal(result.get("steps"), 6, "steps of the result")
    expect.equal(result.get("attempt"), 1, "attempt of the result")


@requirement("ATT-022")
def test_att_022_turn_0_is_of_no_action(context: CheckContext) -> None:
    """Sessions are opened and taken over: at step 0, after a chunk, and after the turn
    that ended an episode, whose response may have been lost.

    Expect turns 0 without steps, rewards, observations and a result, which
    `list_episodes` has.
    """
    worker = submit_and_attach(context, "score", "score", max_steps=9)
    worker.attach(takeover=True)
    worker.predict(context.action(score=1), context.action(score=1), observe="all")
    worker.attach(takeover=True)
    worker.play(score=1)
    worker.attach(takeover=True)
    scored = [result for result in results(worker.run) if result is not None]
    expect.equal(len(scored), 1, "results listed")


@requirement("ATT-020")
def test_att_020_can_take_over_whatever_there_is(context: CheckContext) -> None:
    """A takeover without a session, with the last slot, and of a session that is done.

    Expect a new session each time, the last one with the episode given back meanwhile.
    """
    single = context.submit("count", "count", max_workers=1).worker()
    expect_new_session(single)
    expect_next_step(single, 0)
    expect_new_session(single, single.session_id)
    expect_next_step(single, 1)
    require_worker_limit(context, 2)
    first, second = attach_workers(context.submit("count", "count"), 2)
    if not first.play()["done"]:
        raise SetUpFailed("the turn after the last episode is not `done`")
    second.detach()
    expect_new_session(first, first.session_id)
    expect.equal(first.turn["done"], False, "done with an episode given back")
    expect_next_step(first, 0)


def take_over_during_turn(
    worker: WorkerClient, successor: WorkerClient
) -> list[Answer]:
    """Take a worker over in the middle of a turn; give both answers."""
    context = worker.run.context
    turn_s = long_turn_s(context)
    chunk = [context.action(), *[context.action(delay_s=turn_s / 2)] * 2]

    def take_over() -> Answer:
        time.sleep(turn_s / 4)
        return successor.try_attach(takeover=True)

    turn, attach = context.call_concurrently(
        lambda: worker.try_predict(*chunk), take_over
    )
    if turn.status == 200:
        require_duration(turn, turn_s)
    if attach.started_at >= turn.ended_at:
        raise Inconclusive("the takeover came after the turn")
    return [turn, attach]


@requirement("ATT-021")
@background
def test_att_021_takeover_during_a_turn(context: CheckContext) -> None:
    """A worker is taken over in the middle of a turn of three actions.

    Expect the new session after all if the turn is answered, and before them if it is
    refused; its next turn goes on from there.
    """
    run = context.submit("delay", "delay", max_steps=100)
    worker, successor = run.worker("same"), run.worker("same")
    worker.attach()
    worker.predict(context.action())
    turn, attach = take_over_during_turn(worker, successor)
    successor.turn = opened = expect.ok(require_not_state_refusal(attach))
    successor.session_id = opened["session_id"]
    due = 4 if turn.code is None else 1
    step = opened["episode"]["step"]
    expect.equal(step, due, f"episode.step after a turn answered {turn.status}")
    expect.equal(opened["episode"]["attempt"], 1, "attempt")
    expect_next_step(successor, step)
