"""Leases: how long a session lives without a request (LEASE).

These checks use their own clock. A server is judged only by responses that were surely
inside or outside a lease, whatever the network delay; if the kit was late, the check is
repeated, at most three times.
"""

import functools
import time
from collections.abc import Callable

from conformance.checks.support.given_states import require_duration
from conformance.client.check_context import CheckContext
from conformance.client.run_client import WorkerClient
from conformance.exchanges.answer import Answer
from conformance.runner.requirement import background, requirement
from conformance.verdicts import expect
from conformance.verdicts.expect import Inconclusive

Check = Callable[[CheckContext], None]
TRIES = 3


def retry_when_late(check: Check) -> Check:
    """Repeat a check when the kit was late."""

    @functools.wraps(check)
    def retried(context: CheckContext) -> None:
        for _ in range(TRIES - 1):
            try:
                return check(context)
            except Inconclusive:
                continue
        return check(context)

    return retried


def lease_of(context: CheckContext) -> float:
    """Give the shortest lease that the server allows and the network delay permits."""
    shortest: float = context.limits["idle_timeout_s_min"]
    return max(1.0, shortest, 4 * context.tolerance_s)


def attach_with_lease(context: CheckContext) -> tuple[WorkerClient, Answer]:
    """Attach a worker with a short lease; give the answer that started it."""
    worker = context.submit("count", idle_timeout_s=lease_of(context)).worker()
    answer = worker.try_attach()
    worker.session_id = expect.require(answer, 200, "attach_worker")["session_id"]
    return worker, answer


def try_next_predict(worker: WorkerClient) -> Answer:
    """Play one action under the next seq; the answer is raw."""
    answer = worker.try_predict(worker.run.context.action())
    worker.seq += answer.status == 200
    return answer


def sleep_until(moment: float) -> None:
    """Sleep until a time of the monotonic clock."""
    time.sleep(max(0.0, moment - time.monotonic()))


def sleep_past(answer: Answer, context: CheckContext) -> None:
    """Sleep until the lease that an answer started is surely over."""
    sleep_until(answer.ended_at + lease_of(context) + context.tolerance_s)


def require_inside_lease(
    probe: Answer, lease_began: Answer, context: CheckContext
) -> None:
    """Require that a request was answered surely inside the lease."""
    if probe.ended_at > lease_began.started_at + lease_of(context):
        raise Inconclusive("a request of the kit came too late to be inside the lease")


def require_ended_session(worker: WorkerClient) -> None:
    """Require that leases end at all; LEASE-001 judges that."""
    expect.require(worker.try_heartbeat(), 409, "a session that is over")


@requirement("LEASE-001")
@background
def test_lease_001_session_ends(context: CheckContext) -> None:
    """A worker plays a turn and then sends nothing for longer than its lease.

    Expect `session_ended` for its next predict and its next heartbeat.
    """
    worker, _ = attach_with_lease(context)
    turn = try_next_predict(worker)
    expect.require(turn, 200, "predict")
    sleep_past(turn, context)
    expect.refused(try_next_predict(worker), "session_ended")
    expect.refused(worker.try_heartbeat(), "session_ended")


@requirement("LEASE-002")
@background
@retry_when_late
def test_lease_002_session_lives_for_its_lease(context: CheckContext) -> None:
    """A worker sends nothing for nearly its whole lease, another one for all of it.

    Expect the turn of the first to be accepted.
    """
    silent, silent_began = attach_with_lease(context)
    worker, began = attach_with_lease(context)
    margin_s = 0.1 + context.tolerance_s / 2
    sleep_until(began.started_at + lease_of(context) - margin_s)
    probe = try_next_predict(worker)
    if probe.status != 200:
        require_inside_lease(probe, began, context)
    expect.ok(probe)
    sleep_past(silent_began, context)
    require_ended_session(silent)


def expect_lease_extension(
    context: CheckContext, extend: Callable[[WorkerClient], Answer]
) -> None:
    """Expect a request to extend the lease by its full length, and by no more."""
    silent, _ = attach_with_lease(context)
    worker, began = attach_with_lease(context)
    sleep_until(began.started_at + 0.6 * lease_of(context))
    extension = extend(worker)
    require_inside_lease(extension, began, context)
    expect.require(extension, 200, "the request that extends the lease")
    sleep_past(began, context)
    probe = extend(worker)
    if probe.status != 200:
        require_inside_lease(probe, extension, context)
    expect.ok(probe)
    sleep_past(probe, context)
    require_ended_session(silent)
    expect.refused(extend(worker), "session_ended")


@requirement("LEASE-003")
@background
@retry_when_late
def test_lease_003_heartbeat_extends(context: CheckContext) -> None:
    """A worker sends a heartbeat, then another when its first lease is over.

    Expect the second accepted, and the session ended one lease after it.
    """
    expect_lease_extension(context, WorkerClient.try_heartbeat)


@requirement("LEASE-004")
@background
@retry_when_late
def test_lease_004_predict_extends(context: CheckContext) -> None:
    """A worker plays a turn, then another when the lease of its attach is over.

    Expect the second accepted, and the session ended one lease after it.
    """
    expect_lease_extension(context, try_next_predict)


@requirement("LEASE-005")
@background
@retry_when_late
def test_lease_005_execution_does_not_count(context: CheckContext) -> None:
    """A turn takes half a lease longer than the lease; the next follows at once.

    Expect the next one to be accepted.
    """
    lease_s = lease_of(context)
    worker = context.submit("delay", idle_timeout_s=lease_s, max_steps=100).worker()
    worker.attach()
    steps = int(1.5 * lease_s / 5) + 1
    long = [context.action(delay_s=1.5 * lease_s / steps)] * steps
    turn = worker.try_predict(*long, timeout_s=30 + 2 * lease_s)
    expect.ok(turn)
    require_duration(turn, 1.5 * lease_s)
    worker.seq += 1
    probe = worker.try_predict(context.action())
    if probe.status != 200 and probe.ended_at - turn.ended_at > lease_s / 2:
        raise Inconclusive("the turn after the long one came late")
    expect.ok(probe)


@requirement("LEASE-006")
@background
def test_lease_006_end_of_lease_frees_the_slot(context: CheckContext) -> None:
    """The worker in the only slot of a run stops sending requests.

    Expect another worker to attach when the lease has ended.
    """
    lease_s = lease_of(context)
    run = context.submit("score", "score", max_workers=1, idle_timeout_s=lease_s)
    silent, waiting = run.worker(), run.worker()
    began = silent.try_attach()
    silent.session_id = expect.require(began, 200, "attach_worker")["session_id"]
    expect.require(waiting.try_attach(), 429, "attaching to a full run")
    sleep_past(began, context)
    answer = waiting.try_attach()
    require_ended_session(silent)
    expect.ok(answer)


@requirement("LEASE-008")
@background
@retry_when_late
def test_lease_008_refusals_do_not_extend(context: CheckContext) -> None:
    """A worker attaches; all its later requests are refused.

    Expect the session ended one lease after the attach.
    """
    silent, _ = attach_with_lease(context)
    worker, began = attach_with_lease(context)
    sleep_until(began.started_at + 0.6 * lease_of(context))
    action, bad = context.action(), context.action(vector=[])
    expect.require(worker.try_predict(action, seq=7), 409, "a wrong seq")
    last = worker.try_predict(bad)
    expect.require(last, 422, "a bad action")
    sleep_past(began, context)
    probe = worker.try_predict(action)
    if probe.status != 200:
        require_inside_lease(probe, last, context)
    require_ended_session(silent)
    expect.refused(probe, "session_ended")
