"""Episodes: order, attempts, results (EPI)."""

import itertools
import time
from collections.abc import Callable
from functools import partial
from typing import Any

from conformance.checks.support.expected_states import (
    CLOCK_TOLERANCE,
    expect_state_soon,
)
from conformance.checks.support.given_states import (
    attach_workers,
    index_of,
    submit_and_attach,
    without,
)
from conformance.checks.support.long_run import EPISODES, long_run
from conformance.client.check_context import CheckContext
from conformance.client.run_client import RunClient, WorkerClient
from conformance.exchanges.pages import read_pages
from conformance.runner.requirement import background, on_long_run, requirement
from conformance.verdicts import expect
from conformance.verdicts.expect import SetUpFailed


def read_closed_episode(run: RunClient) -> dict[str, Any]:
    """Read the first episode, whose attempt was closed."""
    episode = run.episodes()[0]
    if episode["status"] == "in_progress":
        text = "the episode is still in progress"
        raise SetUpFailed(text, breaks=expect.ANY_SEQUENCE)
    return episode


@on_long_run
@requirement("EPI-001")
def test_epi_001_hands_out_in_manifest_order(context: CheckContext) -> None:
    """A worker plays while another one (if allowed) holds an episode; also in a run of
    a hundred and eighty episodes. Workers return episodes while others are pending.
    Expect each to get the first pending episode in manifest order, also when it
    returned that episode itself."""
    tasks = context.tasks("score", "count", "echo", "delay", "fault")
    workers = attach_workers(context.submit(*tasks), context.worker_count(2))
    for _ in range(len(workers), len(tasks) - 1):
        workers[0].play()
    if context.offers("sessions"):
        workers[0].predict(context.action())
        workers[0].detach()
        workers[0].attach()
        workers = attach_workers(context.submit(*["score"] * 5), len(workers))
        for worker in reversed(workers):
            worker.predict(context.action())
            worker.detach()
        for worker in workers:
            worker.attach()
        workers[0].play()
    long_run(context)


def close_by_stop(worker: WorkerClient) -> None:
    """Close the attempt by a stop, and resume."""
    worker.run.stop()
    resume_unless_completed(worker.run)


def close_in_drain(worker: WorkerClient) -> None:
    """Close the attempt by a detach while the run drains, and resume."""
    worker.run.stop("drain")
    worker.detach()
    resume_unless_completed(worker.run)


def close_by_stop_in_drain(worker: WorkerClient) -> None:
    """Close the attempt by a stop while the run drains, and resume."""
    worker.run.stop("drain")
    worker.run.stop()
    resume_unless_completed(worker.run)


def resume_unless_completed(run: RunClient) -> None:
    """Resume a stopped run; one whose last episode is scored has completed."""
    if run.get()["state"] != "completed":
        run.resume(until_ready=True)


MANY_ATTEMPTS = 10  # the most that a run may have
CLOSES: list[Callable[[WorkerClient], None]] = [
    *(WorkerClient.detach, close_by_stop, close_in_drain, close_by_stop_in_drain)
]


def closes(context: CheckContext) -> list[Callable[[WorkerClient], None]]:
    """Give the ways to close an attempt after which the run goes on."""
    return CLOSES if context.offers("control") else CLOSES[:1]


@requirement("EPI-003")
def test_epi_003_closed_attempt_goes_back_to_the_queue(context: CheckContext) -> None:
    """Attempts with one action are closed: by a detach and a stop, also in a drain. One
    of an episode that then faults is, too, and its run is stopped and resumed. Expect
    the episode pending and unscored at the next attempt, starting at step 0."""
    worker = submit_and_attach(context, "count", max_attempts=10)
    for close in closes(context):
        worker.predict(context.action())
        close(worker)
        read_closed_episode(worker.run)
        worker.attach()
    worker.play()
    if not context.offers("faults"):
        return
    faulty = submit_and_attach(context, "fault", max_attempts=10)
    faulty.predict(context.action())
    faulty.detach()
    faulty.attach()
    faulty.predict(context.action(fault=1))
    close_by_stop(faulty)
    episode = read_closed_episode(faulty.run)
    expect.equal(episode["attempt"], 2, "attempt after a fault and a resume")


@requirement("EPI-002", "EPI-004", "EPI-010")
def test_epi_004_last_attempt_closed_is_abandoned(context: CheckContext) -> None:
    """`max_attempts` is 1; workers attach and detach without an action. It is 2; of
    each episode the first attempt has one action and is detached, the second has three
    and is closed in each way; so it is with one attempt. At last there are ten of one
    episode. Expect no attempt counted without an action, and no result before the last
    attempt; then `abandoned` with score 0, the steps of the last attempt, neither
    terminated nor truncated."""
    best = context.action(score=0.9, success=1)
    run = context.submit("score", max_attempts=1)
    for _ in range(3):
        worker = run.worker()
        worker.attach()
        worker.detach()
        read_closed_episode(run)
    worker.attach()
    worker.play()
    for attempts in (2, 1):
        worker = submit_and_attach(context, *["score"] * 5, max_attempts=attempts)
        for close in closes(context):
            for _ in range(attempts - 1):
                worker.predict(best)
                worker.detach()
                read_closed_episode(worker.run)
                worker.attach()
            worker.predict(best, best)
            worker.predict(best)
            close(worker)
            worker.run.episodes()
            worker.attach()
    worker = context.submit("score", max_attempts=MANY_ATTEMPTS).worker()
    for _ in range(MANY_ATTEMPTS):
        worker.attach()
        worker.predict(best)
        worker.detach()
        read_closed_episode(worker.run)


def play_all(worker: WorkerClient) -> None:
    """Play until no episode is pending, and repeat every turn."""
    action = worker.run.context.action(score=1 / 3, end=1)
    while not worker.turn["done"]:
        worker.predict(action)
        again = worker.try_predict(action, seq=worker.seq)
        expect.require(again, 200, "repeating a turn")


@requirement("EPI-005")
def test_epi_005_shown_result_stays(context: CheckContext) -> None:
    """Three workers play nine episodes concurrently, and repeat every turn. Expect each
    result to stay, in later turns and in the completed run."""
    run = context.submit(*["score"] * 9)
    workers = attach_workers(run, context.worker_count(3))
    context.call_concurrently(*[partial(play_all, worker) for worker in workers])
    run.until("completed")
    run.results()


def read_all(run: RunClient, *limits: int) -> None:
    """Read all pages of the episodes, with each limit in its turn."""
    limit = itertools.cycle(limits)

    def read(params: dict[str, Any]) -> Any:
        params = params | {"limit": next(limit)}
        return expect.ok(run.call("list_episodes", params=params))

    for count, _ in enumerate(read_pages(read), start=1):
        expect.true(count <= EPISODES + 1, "an end of the pages", count)


@on_long_run
@requirement("EPI-006")
def test_epi_006_pages_show_every_episode_once(context: CheckContext) -> None:
    """Seven episodes, some scored, and a hundred and eighty are read in pages of
    several sizes, also of one after another. Expect no page longer than its limit, and
    each episode once, in order."""
    worker = submit_and_attach(context, *["score"] * 7)
    worker.play()
    for limit in (1, 2, 3, 7, 100):
        read_all(worker.run, limit)
    read_all(worker.run, 2, 3, 1)
    for limit in (11, 45, 90, 99, 100, 101, 179, 180, 181, 1000):
        read_all(long_run(context).run, limit)


def find_seeds(value: Any, seeds: list[int], path: str = "") -> list[str]:
    """Find members named `seed`, or equal to a seed, in a turn."""
    if isinstance(value, dict):
        pointers = [f"{path}/{name}" for name in value if name == "seed"]
        for name, item in value.items():
            pointers += find_seeds(item, seeds, f"{path}/{name}")
        return pointers
    if isinstance(value, list):
        return [leak for item in value for leak in find_seeds(item, seeds, f"{path}/-")]
    is_number = isinstance(value, int | float) and not isinstance(value, bool)
    return [path] if is_number and value in seeds else []


@requirement("EPI-007")
def test_epi_007_seeds_are_not_in_turns(context: CheckContext) -> None:
    """Episodes of several tasks are played; their results then contain the seeds.
    Expect no turn to hold a seed outside `episode_result`, by name or by value."""
    worker = submit_and_attach(context, *context.tasks("score", "echo", "count"))
    turns, observe = [worker.turn], "all" if context.offers("observations") else None
    while not worker.turn["done"]:
        turns.append(worker.predict(context.action(), observe=observe))
        turns.append(worker.predict(context.action(end=1)))
    seeds = [turn["episode_result"]["seed"] for turn in turns[2::2]]
    for turn in turns:
        # A lease may well be as long as a seed is large.
        pointers = find_seeds(without(turn, "episode_result", "lease", "timing"), seeds)
        expect.true(not pointers, "no seed in the turn", pointers)


@requirement("EPI-008")
def test_epi_008_no_episode_is_held_twice(context: CheckContext) -> None:
    """Four workers attach at once, and end their episodes at once, several times. The
    one with the first episode is taken over, and another one attaches again. A second
    worker attaches to a run that may have one. Expect different episodes for all
    workers."""
    first = submit_and_attach(context, "score", "score", max_workers=1)
    first.run.worker().try_attach()
    expect.ok(first.try_next())
    workers = context.worker_count(4)
    if workers == 1:
        return
    run = context.submit(*["score"] * 4 * workers)
    attached_workers = [run.worker() for _ in range(workers)]
    context.call_concurrently(*[worker.attach for worker in attached_workers])
    held = sorted(map(index_of, attached_workers))
    for _ in range(3):
        context.call_concurrently(*[worker.play for worker in attached_workers])
        held = sorted([*held, *map(index_of, attached_workers)])
    expect.equal(held, sorted(set(held)), "episodes held")
    first, second, *_ = sorted(attached_workers, key=index_of)
    first.attach(takeover=True)
    second.detach()
    second.attach()


def close_by_lease(worker: WorkerClient) -> None:
    """Send nothing until the lease is over."""
    time.sleep(worker.run.body["idle_timeout_s"] + worker.run.context.tolerance_s)


@requirement("EPI-009")
@background
def test_epi_009_completed_whatever_closed_it(context: CheckContext) -> None:
    """`max_attempts` is 1; the attempt of the last episode is closed after an action:
    by a detach, a stop, both in a drain, and the end of a lease. Expect the run
    `completed`."""
    shortest_s = max(2.0, context.limits["idle_timeout_s_min"])
    for close in (*closes(context), close_by_lease):
        lease_s = shortest_s if close is close_by_lease else None
        worker = submit_and_attach(
            context, "score", "score", max_attempts=1, idle_timeout_s=lease_s
        )
        run = worker.run
        worker.play()
        worker.predict(context.action())
        close(worker)
        expect_state_soon(run, "completed")
        expect.equal(run.score()["complete"], True, "complete")


@requirement("EPI-011")
@background
def test_epi_011_think_time_is_that_between_turns(context: CheckContext) -> None:
    """A policy thinks in its first attempt, and in the second one before and after a
    turn that takes some time; a heartbeat and a refused turn come in between. Another
    one thinks before its worker is taken over, and then plays the next episode. Expect
    `think_s` of the whole second attempt alone, each time once, without the time of its
    long turn; and none of the first episode in the next one."""
    pause_s, delay_s = 0.2, 0.3
    worker = submit_and_attach(context, "delay", max_attempts=2)
    time.sleep(4 * pause_s)
    worker.predict(context.action())
    worker.detach()
    began = time.monotonic()
    worker.attach()
    time.sleep(pause_s)
    worker.predict(context.action(delay_s=delay_s))
    for _ in ("before the heartbeat", "after it"):
        time.sleep(pause_s)
        worker.heartbeat()
    expect.refused(worker.try_predict({"values": {}}), "invalid_request")
    turn = worker.predict(context.action(end=1))
    most_s = time.monotonic() - began - delay_s
    think_s = turn["episode_result"]["think_s"]
    least_s = CLOCK_TOLERANCE * 3 * pause_s
    in_range = least_s <= think_s <= most_s / CLOCK_TOLERANCE
    expect.true(in_range, f"`think_s` from {least_s:g} to {most_s:.3f}", think_s)
    worker = submit_and_attach(context, "delay", "delay")
    time.sleep(3 * pause_s)
    worker.predict(context.action())
    worker.attach(takeover=True)
    began = time.monotonic()  # the next episode begins before the answer arrives
    think_s = worker.predict(context.action(end=1))["episode_result"]["think_s"]
    least_s = CLOCK_TOLERANCE * 3 * pause_s
    expect.true(think_s >= least_s, f"`think_s` of {least_s:g} or more", think_s)
    think_s = worker.predict(context.action(end=1))["episode_result"]["think_s"]
    most_s = context.tolerance_s + time.monotonic() - began
    expect.true(think_s <= most_s, f"`think_s` of {most_s:.3f} at most", think_s)


@requirement("EPI-012")
def test_epi_012_an_attempt_begins_anew(context: CheckContext) -> None:
    """`max_steps` is 3; two attempts reach the goal in two steps and are closed, by a
    detach and by a stop. The next one is played to the step limit without the goal.
    Expect three steps, then the end, and a failure."""
    worker = submit_and_attach(
        context, "count", max_steps=3, max_attempts=10, success_rule="any_step"
    )
    for close in closes(context)[:2]:
        worker.predict(context.action(success=1), context.action())
        close(worker)
        worker.attach()
    for _ in range(2):
        worker.predict(context.action(), context.action())
    expect.equal(worker.run.episodes()[0].get("result", {}).get("steps"), 3, "steps")
