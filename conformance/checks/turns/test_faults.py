"""Simulator faults: reported, and without cost for the policy (FAULT)."""

from conformance.checks.support.given_states import (
    attach_workers,
    count,
    results,
    submit_and_attach,
)
from conformance.client.check_context import CheckContext
from conformance.runner.requirement import requirement
from conformance.verdicts import expect


@requirement("FAULT-001")
def test_fault_001_episode_begins_again(context: CheckContext) -> None:
    """The simulator fails in the third step of an episode; the episode is repeated.

    Expect `fault` in that turn only, and the same episode and attempt at step 0.
    """
    worker = submit_and_attach(context, "fault", max_attempts=1)
    turn = worker.predict(context.action(), context.action())
    expect.true("fault" not in turn, "no fault before it breaks", turn.get("fault"))
    broken = turn["episode"]
    turn = expect.ok(worker.try_predict(context.action(fault=1)))
    worker.seq += 1
    expect.equal(turn["fault"]["episode_id"], broken["episode_id"], "fault.episode_id")
    expect.equal(turn["fault"]["faults"], 1, "fault.faults")
    expect.equal(turn["episode"], broken | {"step": 0}, "episode")
    expect.equal(count(turn), [0], "count")
    turn = worker.play(success=1)
    expect.true("fault" not in turn, "no fault when it goes well", turn.get("fault"))
    expect.equal(turn["episode_result"]["outcome"], "success", "outcome")
    expect.equal(turn["episode_result"]["attempt"], 1, "attempt")
    expect.equal(turn["episode_result"]["faults"], 1, "faults")


@requirement("FAULT-002")
def test_fault_002_failed_run_is_retryable(context: CheckContext) -> None:
    """An episode faults `max_faults` times. Expect a reason, and `retryable` true."""
    run = context.submit("fault", max_faults=2)
    worker = run.worker()
    worker.attach()
    worker.predict(context.action(fault=1))
    worker.try_predict(context.action(fault=1))
    failed = run.until("failed")
    expect.true(failed["reason"], "a reason", failed["reason"])
    expect.equal(failed["retryable"], True, "retryable")


@requirement("FAULT-003")
def test_fault_003_failed_run_can_go_on(context: CheckContext) -> None:
    """A run fails with one episode scored, and is resumed without further faults.

    Expect the result unchanged, and the run completed.
    """
    run = context.submit("score", "fault", max_faults=1)
    worker = run.worker()
    worker.attach()
    worker.play(score=0.75)
    before = results(run)[0]
    worker.try_predict(context.action(fault=1))
    run.until("failed")
    expect.equal(results(run)[0], before, "the result when failed")
    run.resume()
    run.until("ready")
    worker.attach()
    worker.play(success=1)
    after = results(run)
    expect.equal(after[0], before, "the result in the end")
    expect.true(after[1] is not None, "a result of the other episode", after)


@requirement("FAULT-004")
def test_fault_004_other_workers_are_not_disturbed(context: CheckContext) -> None:
    """The simulator of one worker fails repeatedly while another worker plays.

    Expect the other worker to play step by step, in one attempt, without a fault.
    """
    run = context.submit("fault", "count", max_faults=10, max_steps=100)
    unlucky, other = attach_workers(run, 2)
    before = other.turn["episode"]
    for step in range(1, 4):
        _, answer = context.call_concurrently(
            lambda: unlucky.predict(context.action(fault=1)),
            lambda: other.try_predict(context.action()),
        )
        turn = expect.ok(answer)
        other.seq += 1
        expect.true("fault" not in turn, "no fault of the other", turn.get("fault"))
        expect.equal(turn["episode"], before | {"step": step}, "episode of the other")
        expect.equal(count(turn), [step], "count of the other")


@requirement("FAULT-005")
def test_fault_005_unplayable_task_fails_the_run(context: CheckContext) -> None:
    """`max_faults` is 3, but the simulator reports the task as unplayable at once.

    Expect the run failed and not retryable.
    """
    run = context.submit("fault", max_faults=3)
    worker = run.worker()
    worker.attach()
    worker.try_predict(context.action(fault=2))
    failed = run.get()
    expect.equal(failed["state"], "failed", "state")
    expect.equal(failed["retryable"], False, "retryable")


@requirement("FAULT-006")
def test_fault_006_predict_that_fails_the_run(context: CheckContext) -> None:
    """A turn fails the run: by the last fault allowed, or by an unplayable task.

    Expect `session_ended` with `ended_by` `run_failed`; earlier turns succeed.
    """
    for fault in (1, 2):
        worker = submit_and_attach(context, "fault", max_faults=1)
        worker.predict(context.action())
        answer = worker.try_predict(context.action(fault=fault))
        expect.refused(answer, "session_ended", ended_by="run_failed")
