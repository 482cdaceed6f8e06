"""Sessions that are done, have ended, or belong to another worker (ATT, DET)."""

from collections.abc import Callable
from functools import partial
from typing import Any

from conformance.checks.support.expected_states import (
    expect_state_soon,
    expect_unchanged,
)
from conformance.checks.support.given_states import (
    attach_workers,
    count,
    fail_run,
    index_of,
    play_until_done,
    require_not_state_refusal,
    require_worker_limit,
    start_drain,
    submit_and_attach,
)
from conformance.checks.support.long_turns import during_turn
from conformance.client.check_context import CheckContext
from conformance.client.run_client import WorkerClient
from conformance.runner.requirement import background, requirement
from conformance.verdicts import expect
from conformance.verdicts.expect import Inconclusive


@requirement("ATT-014")
def test_att_014_done_session_holds_no_slot(context: CheckContext) -> None:
    """`max_workers` is 2; of two workers one is done when two more attach, which are
    done as well, and another one when the episode in play was given back. Expect all of
    them to attach."""
    require_worker_limit(context, 2)
    run = context.submit("score", "score", max_workers=2)
    first, second = attach_workers(run, 2)
    play_until_done(first)
    for _ in range(2):
        expect.ok(run.worker().try_attach())
    second.detach()
    expect.ok(run.worker().try_attach())


@requirement("ATT-015")
def test_att_015_no_run_waits_for_a_done_session(context: CheckContext) -> None:
    """A session is done in a drain, and another one while its neighbour detaches.
    Neither of them is detached. Expect the runs `stopped` and `ready`."""
    worker = submit_and_attach(context, "score", "score")
    if context.offers("control"):
        start_drain(worker.run)
        play_until_done(worker)
        expect_state_soon(worker.run, "stopped")
    require_worker_limit(context, 2)
    run = context.submit("score", "score")
    first, second = attach_workers(run, 2)
    play_until_done(first)
    expect.equal(run.get()["state"], "running", "state with an episode in play")
    second.detach()
    expect_state_soon(run, "ready")


@requirement("ATT-018")
def test_att_018_key_names_one_session(context: CheckContext) -> None:
    """The longest key, which ends in a space; keys that differ in the last character,
    in case, in length, in how a letter is composed; the key under another worker, in
    another run, after a takeover, and after the end of the session; a worker and a key
    that together read like others. Expect `worker_busy` for the different ones and
    after the takeover, and never the same session for the others."""
    run = context.submit("count", "count", "count")
    worker, key = run.worker("one"), "e\u0301" + "k" * 124 + "Z "
    worker.attach(attach_key=key)
    worker.predict(context.action())
    others = [key[:-1] + "\t", key[:-2] + "z ", key[:-1], "\u00e9" + key[2:]]
    for other_key in (*others, "E" + key[1:]):
        require_not_state_refusal(worker.try_attach(attach_key=other_key))
    expect.ok(worker.try_attach(attach_key=key))
    for name in ("two", "three")[: context.worker_count(3) - 1]:
        run.worker(name).try_attach(attach_key=key)
    for sign in ("-", "_") if context.worker_count(2) > 1 else ():
        first = submit_and_attach(context, "count", "count")
        joined = first.run.worker(f"{first.id}{sign}{first.id}")
        joined.attach(attach_key=first.attach_key)
        joined_key = f"{first.id}{sign}{first.attach_key}"
        first.try_attach(attach_key=joined_key, takeover=True)
    context.submit("count").worker("one").try_attach(attach_key=key)
    if not context.offers("sessions"):
        return
    later = run.worker("one")
    later.attach(takeover=True)
    worker.try_attach(attach_key=key)
    later.detach()
    for ended in (worker, later):
        worker.try_attach(attach_key=ended.attach_key, takeover=True)


@requirement("DET-003")
@background
def test_det_003_session_ends_during_a_turn(context: CheckContext) -> None:
    """A worker has played one action; its session is detached, or its run aborted, in
    the middle of its next turn. Expect the attempt closed and counted, and the session
    ended: its turn is refused unless it was over by then and is answered whole, and so
    is its next request."""
    for ended_by in ("detached", "run_stopped"):
        worker = submit_and_attach(context, "delay", "delay", max_steps=100)
        worker.predict(context.action())
        turn, ended = during_turn(worker, partial(SESSION_ENDS[ended_by][0], worker))
        if ended.started_at >= turn.ended_at:
            raise Inconclusive("the turn was over before the session was ended")
        expect.true(ended.status in (200, 204), "the end accepted", ended.status)
        if turn.status == 200:
            expect.members(turn.json, {"seq": 2, "executed_steps": 1}, "of the turn")
        else:
            expect.refused(turn, "session_ended", ended_by=ended_by)
        expect.equal(worker.run.get()["live_workers"], 0, "live_workers")
        due = {"status": "pending", "attempt": 2}
        expect.members(worker.run.episodes()[index_of(worker)], due, "of the episode")
        refused = worker.try_predict(context.action(), seq=worker.seq + 2)
        expect.refused(refused, "session_ended", ended_by=ended_by)


def expect_refused(worker: WorkerClient, session_id: str) -> None:
    """Send the requests of a session that is not the worker's. Expect refusals."""
    action = worker.run.context.action()
    for answer in (
        *(worker.try_predict(action, seq=n, session_id=session_id) for n in (1, 2)),
        worker.try_heartbeat(session_id=session_id),
    ):
        expect.true(400 <= answer.status < 500, "a refusal", answer.status)
    worker.try_detach(session_id=session_id)


@requirement("DET-004")
def test_det_004_session_of_another_worker(context: CheckContext) -> None:
    """The id of a session under another worker of its run (with and without a session),
    under its worker in another run, with one letter more, and an id that never existed.
    Expect nothing to happen to any session; under the right worker it plays on."""
    first, second = (submit_and_attach(context, "count", "count") for _ in range(2))
    for own in (first, second):
        own.predict(context.action())
    workers = [first.run.worker("free"), second]
    if context.worker_count(2) > 1:
        workers.append(first.run.worker("second"))
        workers[-1].attach()
    with expect_unchanged(first.run, second.run):
        for wrong in workers:
            expect_refused(wrong, first.session_id)
            expect_refused(wrong, "unknown-session")
        expect_refused(first, first.session_id + "0")
    for worker in (first, second):
        turn = expect.ok(worker.try_predict(context.action()))
        expect.equal(count(turn), [2], "count in the session's next turn")


SESSION_ENDS: dict[str, tuple[Callable[[WorkerClient], Any], tuple[str, ...]]] = {
    "detached": (WorkerClient.try_detach, ("count", "count")),
    "run_stopped": (lambda w: w.run.call("stop_run", json={}), ("count", "count")),
    "run_failed": (lambda worker: fail_run(worker.run), ("count", "fault")),
}


@background
@requirement("DET-005")
def test_det_005_says_what_ended_a_session(context: CheckContext) -> None:
    """Sessions end by a detach, by an abort, by a failure of their run, and by their
    lease; but for the last they are then detached, and the run is aborted or resumed.
    Expect `session_ended` for heartbeat and predict, with what ended them, each time.
    """
    lease_s, action = context.limits["idle_timeout_s_min"], context.action()
    silent = submit_and_attach(context, "count", idle_timeout_s=lease_s)
    for ended_by, (end, tasks) in SESSION_ENDS.items():
        may_fail = context.offers("faults") and context.limits["max_workers"] > 1
        if ended_by == "run_failed" and not may_fail:
            continue
        options = {"max_faults": 1} if ended_by == "run_failed" else {}
        worker = submit_and_attach(context, *tasks, **options)
        worker.predict(action)
        end(worker)
        refused = [worker.try_heartbeat(), worker.try_predict(action)]
        refused.append(worker.try_predict(action, seq=worker.seq))
        run = worker.run
        resumes = ended_by != "detached" and context.offers("control")
        for change in (
            worker.try_detach,
            run.resume if resumes else run.stop,
        ):
            change()
            refused.append(worker.try_heartbeat())
        for answer in refused:
            expect.refused(answer, "session_ended", ended_by=ended_by)
    silent.run.until("ready", lease_s + 10.0)
    for answer in (silent.try_heartbeat(), silent.try_predict(action, seq=1)):
        expect.refused(answer, "session_ended", ended_by="lease_ended")
