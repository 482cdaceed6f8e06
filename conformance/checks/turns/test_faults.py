"""Simulator faults: reported, and without cost for the policy (FAULT)."""

from conformance.checks.support.given_states import (
    attach_workers,
    index_of,
    start_drain,
    submit_and_attach,
)
from conformance.checks.support.long_turns import during_turn
from conformance.client.check_context import CheckContext
from conformance.client.run_client import RunClient
from conformance.runner.requirement import each_requirement, requirement
from conformance.verdicts import expect


@requirement("FAULT-001", "FAULT-009")
def test_fault_001_episode_begins_again(context: CheckContext) -> None:
    """The simulator fails in the third step of an episode; the episode is repeated. It
    fails in a run that drains. Another episode faults in two attempts, fails the run,
    and faults after the resume. Expect `fault` in those turns only, and the same
    episode and attempt at step 0, as it was seen first; the faults counted in turns,
    list and result."""
    worker = submit_and_attach(context, "fault", max_attempts=1)
    worker.predict(*[context.action(vector=[0.5] * 8, clipped=[0.5] * 2)] * 2)
    worker.predict(context.action(fault=1))
    worker.play(success=1)
    draining = submit_and_attach(context, "fault", "fault")
    draining.predict(context.action())
    start_drain(draining.run)
    draining.predict(context.action(fault=1))
    worker = submit_and_attach(context, "fault", "fault", max_faults=2)
    worker.predict(context.action(fault=1))
    worker.predict(context.action())
    worker.detach()
    worker.attach()
    worker.run.episodes()
    worker.try_predict(context.action(fault=1))
    worker.run.until("failed")
    worker.run.episodes()
    worker.run.resume(until_ready=True)
    worker.attach()
    worker.predict(context.action(fault=1))
    for _ in range(2):
        worker.play()
        worker.run.episodes()


@each_requirement("member", {"FAULT-002": "reason", "FAULT-015": "retryable"})
def test_fault_002_failed_run_says_why(context: CheckContext, member: str) -> None:
    """An episode faults `max_faults` times; that of another run does so in a drain.
    Expect a reason, and `retryable` true."""
    for is_draining in (False, True):
        worker = submit_and_attach(context, "fault", max_faults=2)
        if is_draining:
            start_drain(worker.run)
        worker.predict(context.action(fault=1))
        worker.try_predict(context.action(fault=1))
        shown = worker.run.until("failed")[member]
        expect.true(shown, f"the {member} of a failed run", shown)


@requirement("FAULT-003")
def test_fault_003_failed_run_can_go_on(context: CheckContext) -> None:
    """A run fails with one episode scored, and is resumed without further faults.
    Expect the result unchanged, and the run completed."""
    worker = submit_and_attach(context, "score", "fault", max_faults=1)
    worker.play(score=0.75)
    worker.run.results()
    worker.try_predict(context.action(fault=1))
    worker.run.until("failed")
    worker.run.results()
    worker.run.resume(until_ready=True)
    worker.attach()
    worker.play(success=1)
    worker.run.results()


@requirement("FAULT-004")
def test_fault_004_other_workers_are_not_disturbed(context: CheckContext) -> None:
    """The simulator of one worker fails repeatedly while another worker plays. Expect
    the other worker to play step by step, in one attempt, without a fault."""
    run = context.submit("fault", "count", max_faults=10, max_steps=100)
    unlucky, second = attach_workers(run, 2)
    for _ in range(3):
        _, answer = context.call_concurrently(
            lambda: unlucky.predict(context.action(fault=1)),
            lambda: second.try_predict(context.action()),
        )
        expect.ok(answer)
        second.seq += 1


@requirement("FAULT-005")
def test_fault_005_unplayable_task_fails_the_run(context: CheckContext) -> None:
    """`max_faults` is 3, but the simulator reports the task as unplayable at once.
    Expect the run failed and not retryable."""
    worker = submit_and_attach(context, "fault", max_faults=3)
    run = worker.run
    worker.try_predict(context.action(fault=2))
    expect.members(run.get(), {"state": "failed", "retryable": False})


@requirement("FAULT-006")
def test_fault_006_predict_that_fails_the_run(context: CheckContext) -> None:
    """A turn fails the run: by the last fault allowed, or by an unplayable task. Expect
    `session_ended` with `ended_by` `run_failed`; earlier turns succeed."""
    for fault in (1, 2):
        worker = submit_and_attach(context, "fault", max_faults=1)
        worker.predict(context.action())
        answer = worker.try_predict(context.action(fault=fault))
        expect.refused(answer, "session_ended", ended_by="run_failed")


def fail_beside_a_turn(context: CheckContext) -> None:
    """Expect no attempt counted when a run fails while another worker has a turn."""
    if context.limits["max_workers"] < 2:
        return
    run = context.submit("fault", "delay", max_faults=1, max_attempts=1)
    unlucky, busy = attach_workers(run, 2)
    busy.predict(context.action())
    during_turn(busy, lambda: unlucky.try_predict(context.action(fault=1)))
    expect_unplayed(run, "beside a turn")


def expect_unplayed(run: RunClient, what: str) -> None:
    """Expect a run that fails to count no attempt."""
    run.until("failed")
    for episode in run.episodes():
        expect.members(episode, {"status": "pending", "attempt": 1}, what)


@requirement("FAULT-007")
def test_fault_007_a_failure_counts_no_attempt(context: CheckContext) -> None:
    """`max_attempts` is 1; two workers (if allowed) have executed actions when the
    simulator of the first one fails the run, by a fault or as unplayable; the other one
    is in the middle of a turn in a third run. Expect both episodes pending at attempt
    1."""
    if not context.shared.settings.quick:
        fail_beside_a_turn(context)
    for fault in (1, 2):
        run = context.submit("fault", "score", max_faults=1, max_attempts=1)
        workers = attach_workers(run, context.worker_count(2))
        for worker in workers:
            worker.predict(context.action(success=1))
        workers[0].try_predict(context.action(), context.action(fault=fault))
        expect_unplayed(run, "after a failure")


@requirement("FAULT-008")
def test_fault_008_steps_before_a_fault_do_not_count(context: CheckContext) -> None:
    """`max_steps` is 3; an episode faults after a success and two steps, and is played
    to the step limit. Another faults after an action, and its attempt is closed. Expect
    a failure with 3 steps; and the other episode at attempt 1, not abandoned."""
    worker = submit_and_attach(
        context, "fault", "fault", max_steps=3, max_attempts=1, success_rule="any_step"
    )
    first = index_of(worker)
    worker.predict(context.action(success=1), context.action())
    worker.predict(context.action(success=1, fault=1))
    worker.predict(context.action(), context.action())
    worker.predict(context.action())
    worker.run.results()
    worker.predict(context.action())
    worker.predict(context.action(fault=1))
    worker.detach()
    episode = worker.run.episodes()[1 - first]
    shown = [episode["status"], episode["attempt"]]
    expect.equal(shown, ["pending", 1], "status and attempt of the other episode")


@requirement("FAULT-010")
def test_fault_010_faults_count_since_the_run_was_queued(context: CheckContext) -> None:
    """`max_faults` is 2. Episodes fault: one once; the next in two attempts; then,
    after each resume, again, and in two sessions of which one takes over. Expect
    `failed` after two faults of one episode since the run was last queued; a resume of
    a run that is running counts for nothing."""
    worker = submit_and_attach(context, "fault", "fault", max_faults=2)
    run = worker.run

    def expect_fault(state: str, when: str) -> None:
        worker.seq += worker.try_predict(context.action(fault=1)).status == 200
        expect.equal(run.get()["state"], state, f"state after a fault {when}")

    def attach_again() -> None:
        run.resume(until_ready=True)
        worker.attach()

    expect_fault("running", "of the first episode")
    worker.play()
    expect_fault("running", "of the second episode")
    worker.predict(context.action())
    worker.detach()
    worker.attach()
    worker.predict(context.action())
    expect_fault("failed", "in its second attempt")
    for _ in range(2):
        attach_again()
        expect_fault("running", "since the resume")
        run.stop()
        attach_again()
        expect_fault("running", "since the stop and the resume")
        run.resume()
        expect_fault("failed", "as the second one")
    attach_again()
    expect_fault("running", "since the resume")
    worker.attach(takeover=True)
    expect_fault("failed", "after a takeover")


@requirement("FAULT-011")
def test_fault_011_can_repeat_the_turn_that_faulted(context: CheckContext) -> None:
    """`max_faults` is 2; the turn that faulted is repeated twice, then with another
    body, and the next is played. Expect the same turn, `seq_conflict`, one fault, and
    the run to go on."""
    worker = submit_and_attach(context, "fault", max_faults=2)
    chunk = [context.action(), context.action(fault=1)]
    worker.predict(*chunk)
    for _ in range(2):
        expect.ok(worker.try_predict(*chunk, seq=worker.seq))
    expect.refused(worker.try_predict(context.action(), seq=worker.seq), "seq_conflict")
    expect.equal(worker.run.episodes()[0]["faults"], 1, "faults")
    expect.ok(worker.try_predict(context.action()))


@requirement("FAULT-012")
def test_fault_012_nothing_of_the_chunk_is_executed(context: CheckContext) -> None:
    """The second of three actions breaks the simulator; the third would end it all.
    Expect no step, reward, observation of the chunk or result in the turn; and in the
    one that ends the episode later its result without `fault`."""
    worker = submit_and_attach(context, "fault", "score")
    chunk = [context.action(score=1), context.action(fault=1), context.action(end=1)]
    for observe in ("last", "all"):
        turn = worker.predict(*chunk, observe=observe)
        expect.true("fault" in turn, "`fault` in the turn", turn)
    turn = worker.predict(context.action(success=1, end=1))
    expect.true("fault" not in turn, "no `fault` beside a result", turn.get("fault"))


@requirement("FAULT-014")
def test_fault_014_a_failure_ends_every_session(context: CheckContext) -> None:
    """The first of two workers (if allowed) fails the run, in two ways; the other one
    has played, or has only attached, or is done. Expect `session_ended` with `ended_by`
    `run_failed` for requests of both; where one that is done was still live, for its
    heartbeat."""
    refused = []
    for fault in (1, 2):
        run = context.submit("fault", "score", "score", max_faults=1)
        workers = attach_workers(run, context.worker_count(2))
        for worker in workers:
            if fault == 1:  # otherwise none has sent a turn yet
                worker.predict(context.action())
            worker.heartbeat()
        workers[0].try_predict(context.action(fault=fault))
        run.until("failed")
        for worker in workers[::-1]:
            refused += [worker.try_predict(context.action()), worker.try_heartbeat()]
    if context.worker_count(2) > 1:
        done, failing = attach_workers(context.submit("count", "fault"), 2)
        done.play()
        accepted = done.try_heartbeat()
        failing.try_predict(context.action(fault=2))
        done.run.until("failed")
        refused += [done.try_heartbeat()] if accepted.status == 200 else []
    for answer in refused:
        expect.refused(answer, "session_ended", ended_by="run_failed")
