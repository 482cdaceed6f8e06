"""Takeover: what goes over to the next session, and what does not (ATT)."""

from functools import partial
from typing import Any

from conformance.checks.support.expected_states import expect_unchanged
from conformance.checks.support.given_states import (
    attach_workers,
    play_until_done,
    require_duration,
    require_not_state_refusal,
    require_worker_limit,
    start_drain,
    submit_and_attach,
)
from conformance.checks.support.long_turns import during_turn, long_turn_s
from conformance.client.check_context import CheckContext
from conformance.client.run_client import WorkerClient
from conformance.runner.requirement import background, requirement
from conformance.verdicts import expect
from conformance.verdicts.expect import Inconclusive, SetUpFailed


def expect_new_session(worker: WorkerClient) -> None:
    """Expect a takeover to open a session, and play one action in it."""
    answer = require_not_state_refusal(worker.try_attach(takeover=True))
    worker.turn = turn = expect.ok(answer)
    worker.session_id, worker.seq = turn["session_id"], turn["seq"]
    worker.predict(worker.run.context.action())


def expect_next_step(worker: WorkerClient, executed: int) -> None:
    """Expect a turn of one action, after so many executed ones."""
    turn = expect.ok(worker.try_predict(worker.run.context.action()))
    worker.seq += 1
    expect.equal(turn["episode"]["step"], executed + 1, "step after the next turn")


@requirement("ATT-016")
def test_att_016_can_repeat_an_attach_at_any_time(context: CheckContext) -> None:
    """The response to a takeover was lost; it is repeated at once, and in a drain, also
    with an assumption that would have been refused. Expect the same session each time,
    and its turn to be the next."""
    worker = submit_and_attach(context, "count", "count")
    worker.predict(context.action())
    worker.attach(takeover=True)
    repeats: list[dict[str, Any]] = [{"takeover": True}, {"takeover": False}]
    if context.offers("conventions"):
        repeats.append({"assumes": {"control_rate_hz": 20}})
    for is_draining in (False, True) if context.offers("control") else (False,):
        if is_draining:
            start_drain(worker.run)
        for how in repeats:
            expect.ok(worker.try_attach(attach_key=worker.attach_key, **how))
    expect.ok(worker.try_next())


@requirement("ATT-017")
def test_att_017_refused_takeover_changes_nothing(context: CheckContext) -> None:
    """A takeover with a wrong assumption, and one in a `stopping` run. Expect
    `convention_mismatch` and `illegal_transition`, and the session to play on; a
    takeover with the right assumption is accepted."""
    run = context.submit("count", "count")
    worker, successor = run.worker("same"), run.worker("same")
    worker.attach()
    if context.offers("conventions"):
        worker.attach(takeover=True, assumes={"control_rate_hz": 10})
        answer = successor.try_attach(takeover=True, assumes={"control_rate_hz": 20})
        expect.refused(answer, "convention_mismatch")
    expect_next_step(worker, 0)
    if context.offers("conventions") and not context.offers("control"):
        return
    start_drain(run)
    if run.worker().try_attach().status == 200:
        raise SetUpFailed("a `stopping` run accepts an attach; see LIFE-401")
    with expect_unchanged(run):
        expect.refused(successor.try_attach(takeover=True), "illegal_transition")
    expect_next_step(worker, 1)


@requirement("ATT-004", "ATT-005", "ATT-022")
def test_att_004_can_take_over(context: CheckContext) -> None:
    """A restarted client takes its worker over: at step 0, after a chunk (of which all
    is observed, with `observations`), again, and after the turn that ended an episode.
    The new session sends the bodies of the one before and a wrong seq; the old client
    continues. Expect a new session of no action with the same episode, attempt, step
    and observation, and `session_superseded` for each request of the old one."""
    has_all = context.offers("observations")
    task, observe = ("echo", "all") if has_all else ("count", None)
    run = context.submit(task, task, max_steps=7)
    old, new = run.worker("same"), run.worker("same")
    old.attach()
    new.attach(takeover=True)
    values = [[1.5] * 8, [2.5] * 8]
    new.predict(*[context.action(vector=v) for v in values], observe=observe)
    for _ in range(2):
        new.attach(takeover=True)
        for _ in range(2):
            new.predict(context.action())
        new.try_predict(context.action(), seq=5)
        old.try_predict(context.action())
        old.try_heartbeat()
        old.try_detach()
        new.heartbeat()
    new.attach(takeover=True)
    new.predict(context.action())
    new.attach(takeover=True)
    run.results()
    new.detach()


@requirement("ATT-019")
def test_att_019_takeover_begins_with_seqs_of_its_own(context: CheckContext) -> None:
    """Three takeovers in one episode; each session sends the bodies of the one before.
    Expect seq 0 for each, its turns executed, and all steps counted in the result."""
    worker = submit_and_attach(context, "count", "count", max_steps=6)
    worker.predict(context.action())
    for steps in (2, 2, 1):
        worker.attach(takeover=True)
        for _ in range(steps):
            worker.predict(context.action())


@requirement("ATT-020")
def test_att_020_can_take_over_whatever_there_is(context: CheckContext) -> None:
    """A takeover without a session, with the last slot, and of a session that is done.
    Expect a new session each time, the last one with the episode given back meanwhile.
    """
    single = context.submit("count", "count", max_workers=1).worker()
    expect_new_session(single)
    expect_new_session(single)
    require_worker_limit(context, 2)
    first, second = attach_workers(context.submit("count", "count"), 2)
    play_until_done(first)
    second.detach()
    expect_new_session(first)


@requirement("ATT-021")
@background
def test_att_021_takeover_during_a_turn(context: CheckContext) -> None:
    """A worker is taken over in the middle of a turn of three actions. Expect the new
    session after all if the turn is answered, and before them if it is refused; its
    next turn goes on from there."""
    run, turn_s = context.submit("delay", "delay", max_steps=100), long_turn_s(context)
    worker, successor = run.worker("same"), run.worker("same")
    worker.attach()
    worker.predict(context.action())
    chunk = [context.action(), *[context.action(delay_s=turn_s / 2)] * 2]
    take_over = partial(successor.try_attach, takeover=True)
    turn, attach = during_turn(worker, take_over, *chunk)
    if turn.status == 200:
        require_duration(turn, turn_s)
    if attach.started_at >= turn.ended_at:
        raise Inconclusive("the takeover came after the turn")
    successor.turn = opened = expect.ok(require_not_state_refusal(attach))
    successor.session_id = opened["session_id"]
    due = {"step": 4 if turn.code is None else 1, "attempt": 1}
    expect.members(opened["episode"], due, f"after a turn answered {turn.status}")
    expect_next_step(successor, due["step"])
