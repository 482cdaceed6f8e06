"""Leases: how long a session lives without a request (LEASE).

These checks keep their own clock. A server is blamed only for what it did inside or
outside a lease whatever the network did meanwhile; when the kit itself was too slow to
ask in time, the story is told again, at most three times.
"""

import functools
import time
from collections.abc import Callable

from conformance.checks.support.given_states import took_its_time
from conformance.client.check_context import Story, Worker
from conformance.client.http_client import Answer
from conformance.runner.requirement import background, requirement
from conformance.verdicts import expect
from conformance.verdicts.expect import Inconclusive

Check = Callable[[Story], None]
TRIES = 3


def told_in_time(check: Check) -> Check:
    """Tell the story again when the kit was late."""

    @functools.wraps(check)
    def tell(story: Story) -> None:
        for _ in range(TRIES - 1):
            try:
                return check(story)
            except Inconclusive:
                continue
        return check(story)

    return tell


def lease_of(story: Story) -> float:
    """The shortest lease that the server allows and the network lets us watch."""
    shortest: float = story.limits["idle_timeout_s_min"]
    return max(1.0, shortest, 4 * story.tolerance_s)


def leased(story: Story) -> tuple[Worker, Answer]:
    """Attach a worker with a short lease; the answer that began it."""
    worker = story.submit("count", idle_timeout_s=lease_of(story)).worker()
    answer = worker.try_attach()
    worker.session_id = expect.given(answer, 200, "attach_worker")["session_id"]
    return worker, answer


def predicted(worker: Worker) -> Answer:
    """Play one action under the next seq; the answer is raw."""
    answer = worker.try_predict(worker.run.story.action())
    worker.seq += answer.status == 200
    return answer


def sleep_until(moment: float) -> None:
    """Sleep until a time of the monotonic clock."""
    time.sleep(max(0.0, moment - time.monotonic()))


def sleep_past(answer: Answer, story: Story) -> None:
    """Sleep until the lease that an answer began is surely over."""
    sleep_until(answer.ended_at + lease_of(story) + story.tolerance_s)


def must_be_inside(probe: Answer, lease_began: Answer, story: Story) -> None:
    """Go on only if a request was answered while the lease surely lived."""
    if probe.ended_at > lease_began.started_at + lease_of(story):
        raise Inconclusive("a request of the kit came too late to be inside the lease")


def must_have_ended(worker: Worker) -> None:
    """Go on only if leases end at all; LEASE-001 judges that."""
    expect.given(worker.try_heartbeat(), 409, "a session that is over")


@requirement("LEASE-001")
@background
def test_lease_001_session_ends(story: Story) -> None:
    """A worker plays a turn and then says nothing for longer than its lease.

    Expect `session_ended` for its next predict and its next heartbeat.
    """
    worker, _ = leased(story)
    turn = predicted(worker)
    expect.given(turn, 200, "predict")
    sleep_past(turn, story)
    expect.refused(predicted(worker), "session_ended")
    expect.refused(worker.try_heartbeat(), "session_ended")


@requirement("LEASE-002")
@background
@told_in_time
def test_lease_002_session_lives_until_then(story: Story) -> None:
    """A worker is silent for nearly its whole lease, another one for all of it.

    Expect the turn of the first to be accepted.
    """
    silent, silent_began = leased(story)
    worker, began = leased(story)
    margin_s = 0.1 + story.tolerance_s / 2
    sleep_until(began.started_at + lease_of(story) - margin_s)
    probe = predicted(worker)
    if probe.status != 200:
        must_be_inside(probe, began, story)
    expect.ok(probe)
    sleep_past(silent_began, story)
    must_have_ended(silent)


def extends(story: Story, extend: Callable[[Worker], Answer]) -> None:
    """Expect a request to extend the lease by its full length, and by no more."""
    silent, _ = leased(story)
    worker, began = leased(story)
    sleep_until(began.started_at + 0.6 * lease_of(story))
    extension = extend(worker)
    must_be_inside(extension, began, story)
    expect.given(extension, 200, "the request that extends the lease")
    sleep_past(began, story)
    probe = extend(worker)
    if probe.status != 200:
        must_be_inside(probe, extension, story)
    expect.ok(probe)
    sleep_past(probe, story)
    must_have_ended(silent)
    expect.refused(extend(worker), "session_ended")


@requirement("LEASE-003")
@background
@told_in_time
def test_lease_003_heartbeat_extends(story: Story) -> None:
    """A thinking worker sends a heartbeat, then another when the first lease is over.

    Expect the second accepted, and the session ended one lease after it.
    """
    extends(story, Worker.try_heartbeat)


@requirement("LEASE-004")
@background
@told_in_time
def test_lease_004_predict_extends(story: Story) -> None:
    """A worker plays a turn, then another when the lease of its attach is over.

    Expect the second accepted, and the session ended one lease after it.
    """
    extends(story, predicted)


@requirement("LEASE-005")
@background
@told_in_time
def test_lease_005_execution_does_not_count(story: Story) -> None:
    """A turn takes half a lease longer than the lease; the next follows at once.

    Expect the next one to be accepted.
    """
    lease_s = lease_of(story)
    worker = story.submit("delay", idle_timeout_s=lease_s, max_steps=100).worker()
    worker.attach()
    steps = int(1.5 * lease_s / 5) + 1
    long = [story.action(delay_s=1.5 * lease_s / steps)] * steps
    turn = worker.try_predict(*long, timeout_s=30 + 2 * lease_s)
    expect.ok(turn)
    took_its_time(turn, 1.5 * lease_s)
    worker.seq += 1
    probe = worker.try_predict(story.action())
    if probe.status != 200 and probe.ended_at - turn.ended_at > lease_s / 2:
        raise Inconclusive("the turn after the long one came late")
    expect.ok(probe)


@requirement("LEASE-006")
@background
def test_lease_006_end_of_lease_frees_the_slot(story: Story) -> None:
    """The only slot of a run is taken by a worker that falls silent.

    Expect another worker to be let in when the lease has ended.
    """
    lease_s = lease_of(story)
    run = story.submit("score", "score", max_workers=1, idle_timeout_s=lease_s)
    silent, waiting = run.worker(), run.worker()
    began = silent.try_attach()
    silent.session_id = expect.given(began, 200, "attach_worker")["session_id"]
    expect.given(waiting.try_attach(), 429, "attaching to a full run")
    sleep_past(began, story)
    answer = waiting.try_attach()
    must_have_ended(silent)
    expect.ok(answer)


@requirement("LEASE-008")
@background
@told_in_time
def test_lease_008_refusals_do_not_extend(story: Story) -> None:
    """A worker's last accepted request is its attach; later it sends refused ones.

    Expect the session ended one lease after the attach.
    """
    silent, _ = leased(story)
    worker, began = leased(story)
    sleep_until(began.started_at + 0.6 * lease_of(story))
    action, bad = story.action(), story.action(vector=[])
    expect.given(worker.try_predict(action, seq=7), 409, "a wrong seq")
    last = worker.try_predict(bad)
    expect.given(last, 422, "a bad action")
    sleep_past(began, story)
    probe = worker.try_predict(action)
    if probe.status != 200:
        must_be_inside(probe, last, story)
    must_have_ended(silent)
    expect.refused(probe, "session_ended")
