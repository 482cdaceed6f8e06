"""Reading a run only when it has changed: ETags and long polls (RUN)."""

import time
from collections.abc import Callable
from functools import partial
from typing import Any

from conformance.checks.support.expected_states import EARLY_S, WAIT_S, expect_changed
from conformance.checks.support.given_states import (
    attach_workers,
    make_run_in_state,
    submit_and_attach,
)
from conformance.client.check_context import CheckContext
from conformance.client.run_client import RunClient, WorkerClient
from conformance.exchanges.answer import Answer
from conformance.runner.private_server import open_quiet_server
from conformance.runner.requirement import background, more_with_minutes, requirement
from conformance.verdicts import expect
from conformance.verdicts.expect import Inconclusive, NotApplicable, SetUpFailed

_FAULTS = 6
_FAULT_EVERY_S = 0.32
_QUEUE_S = 1.0
_CHANGE_AFTER_S = 0.4
_LATE_S = 1.0
_POLL_EVERY_S = 0.05
# During a wait: the first may come before it, and the last at its very end.
_CHANGES_MIN = 3
# Far longer than any answer takes that is not waited for.
_LONG_WAIT_S, _LEAST_WAIT_S = 10, 4


def etag_of(run: RunClient) -> dict[str, str]:
    """Read the run and give the header for a conditional read."""
    answer = run.call("get_run")
    etag = answer.headers.get("etag")
    if answer.status != 200 or etag is None:
        raise SetUpFailed(f"`get_run` gives no ETag: {expect.describe_answer(answer)}")
    return {"If-None-Match": etag}


@requirement("RUN-011")
def test_run_011_unchanged_run_is_not_sent_again(context: CheckContext) -> None:
    """A run is read again with its ETag, alone, among others, and with `*`. Expect 304
    without a body; the run for texts that are not its ETag, and with another ETag after
    a change."""
    run = context.submit()
    headers = etag_of(run)
    etag = headers["If-None-Match"]
    lists = [etag, f'"none", {etag}', f'{etag},"none"', f'"a" , {etag} , "b"', "*"]
    for text in lists:
        answer = run.call("get_run", headers={"If-None-Match": text})
        expect.ok(answer, 304)
        expect.equal(answer.body, b"", "the body of a 304")
    for text in ('"none"', f'"x{etag[1:]}', f'{etag[:-1]}x"', etag[1:-1], '"*"', '""'):
        expect.ok(run.call("get_run", headers={"If-None-Match": text}))
    run.stop()
    changed = run.call("get_run", headers=headers)
    expect.equal(expect.ok(changed)["state"], "stopped", "state")
    etag = changed.headers.get("etag")
    expect.true(etag not in (None, headers["If-None-Match"]), "another ETag", etag)


def wait_header(context: CheckContext, wait_s: int) -> dict[str, str]:
    """Give the header of a long-poll."""
    if context.limits["wait_s_max"] < wait_s:
        raise NotApplicable(f"server does not grant a wait of {wait_s} s")
    return {"Prefer": f"wait={wait_s}"}


def wait_for_state(
    run: RunClient, state: str, headers: dict[str, str], until: float
) -> Answer:
    """Give the answer that ended the last wait; other members may change before.

    Expect each answer with the run to have another ETag than its request named.
    """
    while True:
        answer = run.call("get_run", headers=headers)
        if answer.status == 304:
            return answer
        ended, etag = expect.ok(answer), answer.headers.get("etag")
        named = headers["If-None-Match"]
        expect.true(etag not in (None, named), "another ETag beside a 200", etag)
        if ended["state"] == state or answer.ended_at > until:
            return answer
        headers = headers | {"If-None-Match": answer.headers["etag"]}
        time.sleep(_POLL_EVERY_S)  # a server that never waits is asked seldom


def change_later(change: Callable[[], Any]) -> float:
    """Make a change after a delay, and give its time."""
    time.sleep(_CHANGE_AFTER_S)
    change()
    return time.monotonic()


def changes_of(context: CheckContext) -> list[tuple[RunClient, str, Callable[[], Any]]]:
    """Give changes to make one after another, each with its run and the state then."""
    attached, stopped = context.submit("score", "score"), context.submit()
    worker = attached.worker()
    failing = submit_and_attach(context, "fault", max_faults=1)
    changes: list[tuple[RunClient, str, Callable[[], Any]]] = [
        (attached, "running", worker.attach),
        (attached, "running", worker.play),
        (attached, "ready", worker.detach),
        (stopped, "stopped", stopped.stop),
        (failing.run, "failed", partial(failing.try_next, fault=1)),
    ]
    if context.worker_count(2) > 1:
        _, leaving = attach_workers(context.submit("score", "score"), 2)
        changes.append((leaving.run, "running", leaving.detach))
    return changes


@background
@requirement("RUN-012")
def test_run_012_long_poll_ends_when_the_run_changes(context: CheckContext) -> None:
    """Two long-polls wait, one of them for longer than the server lets it, while a run
    gets a worker, gets a result, loses its worker, others are stopped, fail, and lose
    one worker of two. One waits for the end of the queue, which its run has entered
    again, and one with `*` while its run changes again and again. Where the kit starts
    servers, no other check sends requests to this one. Expect each to return at once
    with the new state."""
    with open_quiet_server(context) as quiet:
        wait_for_the_queue(quiet)
        wait = wait_header(quiet, WAIT_S)
        longest = {"Prefer": f"wait={min(9999, quiet.limits['wait_s_max'] + 1)}"}
        for run, state, change in changes_of(quiet):
            headers, until = etag_of(run), time.monotonic() + WAIT_S
            polls = [
                partial(wait_for_state, run, state, headers | how, until)
                for how in (wait, longest)
            ]
            *answers, changed_at = quiet.call_concurrently(
                *polls, partial(change_later, change)
            )
            limit_s = _LATE_S + quiet.tolerance_s
            for polled in answers:
                took_s = polled.ended_at - changed_at
                expect_changed(polled, state, took_s, limit_s, "the answer to a change")
        if not context.shared.settings.quick:
            wait_for_any_change(quiet)


def wait_for_the_queue(context: CheckContext) -> None:
    """Expect a wait to end with the time of a run in the queue."""
    queue_s = min(context.choose_queue_s(_QUEUE_S), WAIT_S - 1)
    requeued = context.submit(queue_s=queue_s)
    requeued.stop()
    before = time.monotonic()
    requeued.resume()
    resumed_at = time.monotonic()
    queued = etag_of(requeued)
    if time.monotonic() > before + queue_s / 2:
        raise Inconclusive("the kit began to wait too late for the end of the queue")
    limit_s = queue_s + _LATE_S + context.tolerance_s
    headers, until = queued | wait_header(context, WAIT_S), resumed_at + limit_s
    answer = wait_for_state(requeued, "ready", headers, until)
    took_s, what = answer.ended_at - resumed_at, "the answer to the end of the queue"
    expect_changed(answer, "ready", took_s, limit_s, what)


def attach_and_detach(worker: WorkerClient, until: float) -> list[float]:
    """Attach a worker and detach it, again and again, up to a time.

    Gives when each of these changes was made.
    """
    changed_at: list[float] = []
    while time.monotonic() < until:
        for change in (worker.attach, worker.detach):
            change()
            changed_at.append(time.monotonic())
            time.sleep(_CHANGE_AFTER_S)
    return changed_at


def wait_for_any_change(context: CheckContext) -> None:
    """Expect a wait with `*` to end, whenever it began, while the run changes."""
    worker, wait_s = context.submit("score").worker(), 2
    until = time.monotonic() + wait_s + _LATE_S + context.tolerance_s
    headers = {"If-None-Match": "*"} | wait_header(context, wait_s)
    poll = partial(worker.run.call, "get_run", headers=headers)
    changes = partial(attach_and_detach, worker, until)
    answer, changed_at = context.call_concurrently(poll, changes)
    if answer.status == 304:
        expect_end_of_wait(context, answer, wait_s)
        inside = [at for at in changed_at if answer.started_at < at < answer.ended_at]
        if len(inside) < _CHANGES_MIN:
            raise Inconclusive("the kit made too few changes during a wait")
    expect.ok(answer)


@background
@requirement("RUN-013")
@more_with_minutes
def test_run_013_long_poll_ends_with_304_after_its_time(context: CheckContext) -> None:
    """The run does not change for no, one and two seconds; also with `*`, in states
    that end it, while the simulator of a worker fails again and again, and while
    another run changes; with `--minutes` for as long as a server lets it wait. Expect
    304 then, and not before; beside faults also the run, if it shows them."""
    wait_header(context, 2)
    run = context.submit()
    for wait_s, headers in (
        *((0, etag_of(run)), (1, etag_of(run)), (2, etag_of(run))),
        (1, {"If-None-Match": "*"}),
    ):
        answer = run.call("get_run", headers=headers | wait_header(context, wait_s))
        expect.ok(answer, 304)
        expect_end_of_wait(context, answer, wait_s)
    for state in ("completed", "stopped", "failed"):
        wait_without_a_change(make_run_in_state(context, state), 1, context)
    worker = submit_and_attach(context, "fault", max_faults=10)
    headers = etag_of(worker.run)

    def fail_again_and_again() -> None:
        began_at = time.monotonic()
        for number in range(1, _FAULTS + 1):
            worker.predict(context.action(fault=1))
            due_at = began_at + number * _FAULT_EVERY_S
            time.sleep(max(0.0, due_at - time.monotonic()))

    poll = partial(
        worker.run.call, "get_run", headers=headers | wait_header(context, 2)
    )
    answer, _ = context.call_concurrently(poll, fail_again_and_again)
    if answer.status == 304:
        expect_end_of_wait(context, answer, 2)
    else:
        expect.ok(answer)
        etag = answer.headers.get("etag")
        expect.true(etag != headers["If-None-Match"], "another ETag beside a 200", etag)
    if not context.shared.settings.quick:
        wait_beside_another_run(context)
    if context.shared.settings.minutes:
        wait_without_a_change(run, context.limits["wait_s_max"], context)


def wait_without_a_change(run: RunClient, wait_s: int, context: CheckContext) -> None:
    """Expect a wait to end at its time, in a run that nothing changes."""
    headers = etag_of(run) | wait_header(context, wait_s)
    answer = run.call("get_run", headers=headers, timeout_s=wait_s + 30.0)
    expect.ok(answer, 304)
    expect_end_of_wait(context, answer, wait_s)


def wait_beside_another_run(context: CheckContext) -> None:
    """Expect a wait to end at its time while another run changes again and again."""
    wait_s, quiet = 1, context.submit()
    headers = etag_of(quiet) | wait_header(context, wait_s)
    busy_worker = context.submit("score").worker()
    until = time.monotonic() + wait_s + 2 * _LATE_S + context.tolerance_s

    poll = partial(quiet.call, "get_run", headers=headers)
    changes = partial(attach_and_detach, busy_worker, until)
    answer, _ = context.call_concurrently(poll, changes)
    expect.ok(answer, 304)
    expect_end_of_wait(context, answer, wait_s)


def expect_end_of_wait(context: CheckContext, answer: Answer, wait_s: int) -> None:
    """Expect that a wait without a change lasted as long as it was to."""
    took, due = f"after {answer.elapsed_s:.2f} s", f"304 after {wait_s} s"
    expect.true(answer.elapsed_s >= wait_s - EARLY_S, f"{due}, not before", took)
    expect.in_time(answer.elapsed_s, wait_s + _LATE_S + context.tolerance_s, due)


@requirement("RUN-030")
def test_run_030_etag_changes_with_every_member(context: CheckContext) -> None:
    """A run is read after each request of its life, with all ETags that it had before;
    one in the queue, before and after another one leaves it. Expect another ETag
    whenever a member of it is another, and the new run."""
    run = context.submit("score", "count", "score", queue_s=0)
    worker = run.worker()
    steps: list[Callable[[], Any]] = [worker.attach, worker.play, worker.play]
    steps += [worker.detach, worker.attach, partial(run.stop, "drain"), run.stop]
    steps += [run.resume, partial(run.until, "ready"), worker.attach, worker.play]
    for step in steps:
        headers = etag_of(run)
        step()
        run.call("get_run", headers=headers)
    run.get()
    first, second = (context.submit(wait_ready=False, queue_s=10) for _ in range(2))
    for leave in (second.get, first.stop):
        leave()
        second.get()


@requirement("RUN-031")
def test_run_031_answers_at_once_without_a_wait(context: CheckContext) -> None:
    """A long wait without If-None-Match, with another ETag, and with an old one. Expect
    the run long before the time is over."""
    wait_s = min(_LONG_WAIT_S, max(_LEAST_WAIT_S, context.limits["wait_s_max"]))
    wait = wait_header(context, wait_s)
    run = context.submit()
    old = etag_of(run)
    run.stop()
    for headers in ({}, {"If-None-Match": '"none"'}, old, {"If-None-Match": "none"}):
        answer = run.call("get_run", headers=wait | headers)
        expect.equal(expect.ok(answer)["state"], "stopped", "state")
        limit_s, what = wait_s - _LATE_S, "the run at once"
        expect.in_time(answer.elapsed_s, limit_s, what, may_be_noise=False)
