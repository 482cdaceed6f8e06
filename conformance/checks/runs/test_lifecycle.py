"""The lifecycle of a run: one check per cell of the table `x-lifecycle` (LIFE).

The table is read from the specification, not repeated here. A run is brought into the
state `from`, gets the command, and must be in the state `to`.
"""

import contextlib
import time
from collections.abc import Callable, Mapping
from functools import partial
from typing import Any

import pytest

from conformance.checks.support.expected_states import (
    CLOCK_TOLERANCE,
    expect_state_soon,
    expect_unchanged,
    looks,
)
from conformance.checks.support.given_states import (
    attach_workers,
    detach_only_worker,
    make_run_in_state,
    play_until_done,
    require_worker_limit,
    start_drain,
    submit_and_attach,
    unless_left_the_queue,
)
from conformance.client.check_context import CheckContext
from conformance.client.request_context import LONGEST_QUEUE_S
from conformance.client.run_client import RunClient
from conformance.exchanges.answer import Answer
from conformance.runner.requirement import background, each_requirement, requirement
from conformance.specification.document import load_spec
from conformance.verdicts import expect
from conformance.verdicts.expect import Inconclusive, SetUpFailed

POLL_S = 0.05
SHORT_QUEUE_S, VISIBLE_QUEUE_S = 0.5, 0.2
HOLDING_STATES = ("ready", "running", "stopping")

COMMANDS: dict[str, Callable[[RunClient], Answer]] = {
    "attach_worker": lambda run: run.worker("newcomer").try_attach(),
    "stop_abort": lambda run: run.call("stop_run", json={"mode": "abort"}),
    "stop_drain": lambda run: run.call("stop_run", json={"mode": "drain"}),
    "resume_run": lambda run: run.call("resume_run"),
}


def rows(wanted: Callable[[Mapping[str, Any]], bool]) -> list[Any]:
    """Rows of the table that begin with a command, as parameters of a check."""
    return [
        pytest.param(
            row,
            id=f"{row['id']} {row['from']} {row['event']}",
            marks=pytest.mark.requirement(row["id"]),
        )
        for row in load_spec().lifecycle["transitions"]
        if row["event"] in COMMANDS and wanted(row)
    ]


def is_refused(row: Mapping[str, Any]) -> bool:
    """Whether the state refuses the command."""
    return bool(row["to"] == "refused")


def is_same(row: Mapping[str, Any]) -> bool:
    """Whether the command changes nothing; an attach always opens a session."""
    return bool(row["to"] == row["from"] and row["event"] != "attach_worker")


def given_state_of(row: Mapping[str, Any]) -> str:
    """Name the given state of a row."""
    failed_for_good = row.get("when") == "not_retryable"
    return f"{row['from']} not_retryable" if failed_for_good else str(row["from"])


@pytest.mark.parametrize("row", rows(is_refused))
def test_life_cannot(context: CheckContext, row: Mapping[str, Any]) -> None:
    """A command that the run's state does not allow. A `ready` run accepts the same
    command. Expect `illegal_transition` in this state, and the run unchanged."""
    command = COMMANDS[row["event"]]
    expect.require(command(context.submit("score")), 200, f"{row['event']} when ready")
    with unless_left_the_queue(given_state_of(row)):
        run = make_run_in_state(context, given_state_of(row))
        with expect_unchanged(run):
            expect.refused(command(run), "illegal_transition")


@pytest.mark.parametrize("row", rows(is_same))
def test_life_can_unchanged(context: CheckContext, row: Mapping[str, Any]) -> None:
    """A command for a state that the run already has. Expect success and no change."""
    # A run that is put into the queue again is seen there.
    has_queue = context.offers("control") and row["from"] != "queued"
    queue = {"queue_s": VISIBLE_QUEUE_S} if has_queue else {}
    with unless_left_the_queue(given_state_of(row)):
        run = make_run_in_state(context, given_state_of(row), **queue)
        with expect_unchanged(run):
            answer = expect.ok(COMMANDS[row["event"]](run))
            expect.equal(answer["state"], row["to"], "state in the answer")


@pytest.mark.parametrize("row", rows(lambda r: not (is_refused(r) or is_same(r))))
def test_life_can(context: CheckContext, row: Mapping[str, Any]) -> None:
    """A command that the state allows. Expect success and the run in its new state, in
    the response and when read again. A run that becomes `queued` must leave that state
    again."""
    if (row["from"], row["event"]) == ("running", "attach_worker"):
        require_worker_limit(context, 2)
    queue_s = context.choose_queue_s(SHORT_QUEUE_S)
    queue = {"queue_s": queue_s} if row.get("when") == "retryable" else {}
    run = make_run_in_state(context, given_state_of(row), **queue)
    began_at = time.monotonic()
    answer = expect.ok(COMMANDS[row["event"]](run))
    is_late = time.monotonic() > began_at + queue_s
    if queue and answer["state"] == "ready" and is_late:
        raise Inconclusive(f"the answer came after the queue_s of {queue_s:g}")
    if row["event"] != "attach_worker":
        expect.equal(answer["state"], row["to"], "state in the answer")
    states = ["queued", "ready"] if row["to"] == "queued" else [row["to"]]
    expect.true(run.get()["state"] in states, f"a run {states}", run.body["state"])


def expect_ready(context: CheckContext, run: RunClient, within_s: float) -> None:
    """Expect a queued run to become ready, if there is a place for any."""
    try:
        expect_state_soon(run, "ready", within_s)
    except expect.Violation:
        second = context.submit(wait_ready=False)
        with contextlib.suppress(SetUpFailed):
            second.until("ready")
        listed = expect.ok(context.call("list_runs", params={"limit": 100}))["runs"]
        held = sum(run_body["state"] in HOLDING_STATES for run_body in listed)
        if second.body["state"] == "queued" and held:
            raise SetUpFailed(
                f"no run becomes ready while {held} others of the kit's account are: "
                "the checks need places for about fifty runs at once"
            ) from None
        raise


@requirement("LIFE-801")
@background
def test_life_801_queued_becomes_ready(context: CheckContext) -> None:
    """A run is queued for a moment, then stopped and resumed, twice. Expect it `ready`
    without a request, each time."""
    queue_s = context.choose_queue_s(1)
    run = make_run_in_state(context, "queued", queue_s=queue_s)
    expect_ready(context, run, queue_s + 4)
    for _ in range(2):
        run.stop()
        run.resume()
        expect_ready(context, run, queue_s + 4)


@each_requirement("then", {"LIFE-802": "ready", "LIFE-803": "stopped"})
def test_life_802_ends_with_its_last_worker(context: CheckContext, then: str) -> None:
    """The workers of a running run, two if allowed, detach one after another, twice; so
    do those of a draining one, and one that is done while the other plays. Expect
    `running` or `stopping` while one is left, and then `ready` or `stopped`."""
    run, is_draining = context.submit("count", "count", "count"), then == "stopped"
    before = "stopping" if is_draining else "running"
    for _ in range(2):
        *others, last = attach_workers(run, context.worker_count(2))
        run.until("running")
        if is_draining:
            start_drain(run)
        for worker in others:
            worker.detach()
            expect.equal(run.get()["state"], before, "state with a worker left")
        detach_only_worker(last)
        expect_state_soon(run, then)
        if is_draining:
            run.resume(until_ready=True)
    if is_draining and context.worker_count(2) > 1:
        done, playing = attach_workers(context.submit("count", "count"), 2)
        play_until_done(done)
        start_drain(done.run)
        done.detach()
        state = done.run.get()["state"]
        expect.equal(state, "stopping", "state when one that is done has left")
        expect.ok(playing.try_next())


@each_requirement("state", {"LIFE-804": "running", "LIFE-805": "stopping"})
def test_life_804_completes_with_its_last_episode(
    context: CheckContext, state: str
) -> None:
    """Two episodes are played, the last one also in a drain. Expect `completed` after
    the second, not before."""
    worker = submit_and_attach(context, "score", "score")
    worker.play()
    if state == "stopping":
        start_drain(worker.run)
    expect.equal(worker.run.get()["state"], state, "state with an episode left")
    worker.try_predict(context.action(end=1))  # its answer is PRED-009, or STOP-004
    expect_state_soon(worker.run, "completed")


@each_requirement("state", {"LIFE-806": "running", "LIFE-807": "stopping"})
def test_life_806_fails_with_its_last_fault(context: CheckContext, state: str) -> None:
    """`max_faults` is 2; a run also drains. Expect `running`, or `stopping`, after one
    fault, then `failed`."""
    worker = submit_and_attach(context, "fault", "fault", max_faults=2)
    if state == "stopping":
        start_drain(worker.run)
    worker.seq += worker.try_predict(context.action(fault=1)).status == 200
    expect.equal(worker.run.get()["state"], state, "state after one fault of two")
    worker.try_predict(context.action(fault=1))
    expect_state_soon(worker.run, "failed")


def expect_queued_for(run: RunClient, since: float, queue_s: float) -> None:
    """Expect the run in the queue until `queue_s` after a moment before it entered."""
    for _ in looks(since + queue_s + 5, POLL_S):
        if run.get()["state"] != "queued":
            break
    else:
        raise SetUpFailed("the run stays `queued`; see LIFE-801")
    waited_s = time.monotonic() - since
    expect.true(
        waited_s >= CLOCK_TOLERANCE * queue_s,
        f"a run that is `queued` for {queue_s:g} s",
        f"{run.body['state']} after {waited_s:.3f} s",
    )


@requirement("LIFE-810")
@background
def test_life_810_stays_in_the_queue(context: CheckContext) -> None:
    """A run with `queue_s` waits; is stopped in the queue and resumed; is stopped when
    it is ready and resumed. Another one waits as long as a run may. Expect it `queued`
    for that time, counted from the submit or the last resume."""
    began_at = time.monotonic()
    longest = context.submit("score", wait_ready=False, queue_s=LONGEST_QUEUE_S)
    queue_s = 0.8
    before = time.monotonic()
    run = context.submit("score", wait_ready=False, queue_s=queue_s)
    expect_queued_for(run, before, queue_s)
    run = context.submit("score", wait_ready=False, queue_s=queue_s)
    for pause_s in (queue_s / 2, 0.0):
        time.sleep(pause_s)
        run.stop()
        before = time.monotonic()
        run.resume()
        expect_queued_for(run, before, queue_s)
    time.sleep(max(0.0, began_at + LONGEST_QUEUE_S - 1 - time.monotonic()))
    expect_queued_for(longest, began_at, LONGEST_QUEUE_S)


@requirement("LIFE-811")
@background
def test_life_811_stopped_in_the_queue_stays_stopped(context: CheckContext) -> None:
    """Runs are stopped in the queue, with `abort`, with `drain`, after a resume of a
    stopped run and after one of a queued run. Expect them `stopped` when their
    `queue_s` has passed."""
    queue_s = context.choose_queue_s(max(0.5, 2 * context.tolerance_s))
    stop, resume = RunClient.stop, RunClient.resume
    sequences = ([stop], [partial(stop, mode="drain")], [stop, resume, stop])
    stopped = partial(stopped_in_the_queue, context, queue_s)
    runs = [stopped(*commands) for commands in (*sequences, [resume, stop])]
    time.sleep(queue_s + 0.5)
    for run in runs:
        expect.equal(run.get()["state"], "stopped", "state after `queue_s`")


def stopped_in_the_queue(
    context: CheckContext, queue_s: float, *commands: Callable[[RunClient], object]
) -> RunClient:
    """Give a run that all commands reached while it was in the queue."""
    began_at = time.monotonic()
    run = context.submit("score", wait_ready=False, queue_s=queue_s)
    for command in commands:
        command(run)
    if time.monotonic() > began_at + queue_s:
        raise Inconclusive(f"the kit sent its requests too late for {queue_s:g} s")
    return run
