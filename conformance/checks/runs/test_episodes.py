"""Episodes: order, attempts, results (EPI)."""

import itertools
import time
from collections.abc import Callable
from typing import Any

from conformance.checks.support.expected_states import (
    CLOCK_TOLERANCE,
    expect_state_soon,
)
from conformance.checks.support.given_states import (
    attach_workers,
    count,
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


def read_closed_episode(run: RunClient, index: int = 0) -> dict[str, Any]:
    """Read an episode whose attempt was closed."""
    episode = run.episodes()[index]
    if episode["status"] == "in_progress":
        text = "the episode is still in progress"
        raise SetUpFailed(text, breaks=expect.ANY_SEQUENCE)
    return episode


def episode_of(worker: WorkerClient) -> tuple[int, str]:
    """Give the episode of the latest turn of a worker."""
    episode = worker.turn["episode"]
    return episode["index"], episode["task"]


def expect_returned_first(context: CheckContext) -> None:
    """Expect returned episodes before those that were never handed out, in order."""
    run = context.submit(*["score"] * 5)
    workers = attach_workers(run, context.worker_count(2))
    for worker in reversed(workers):
        worker.predict(context.action())
        worker.detach()
    for index, worker in enumerate(workers):
        worker.attach()
        expect.equal(index_of(worker), index, "an episode that was returned")
    workers[0].play()
    expect.equal(index_of(workers[0]), len(workers), "the episode after those")


@on_long_run
@requirement("EPI-001")
def test_epi_001_hands_out_in_manifest_order(context: CheckContext) -> None:
    """A worker plays while another one (if allowed) holds an episode; also in a run of
    a hundred and eighty episodes. Workers return episodes while others are pending.

    Expect each to get the first pending episode in manifest order, also when it
    returned that episode itself.
    """
    tasks = context.tasks("score", "count", "echo", "delay", "fault")
    run = context.submit(*tasks)
    attached_workers = attach_workers(run, context.worker_count(2))
    for index, worker in enumerate(attached_workers):
        expect.equal(episode_of(worker), (index, tasks[index]), "a first episode")
    for index in range(len(attached_workers), len(tasks) - 1):
        attached_workers[0].play()
        expect.equal(
            episode_of(attached_workers[0]), (index, tasks[index]), "the next episode"
        )
    if context.offers("sessions"):
        worker = attached_workers[0]
        returned_episode = episode_of(worker)
        worker.predict(context.action())
        worker.detach()
        worker.attach()
        expect.equal(episode_of(worker), returned_episode, "the episode given back")
        expect_returned_first(context)
    handed_out = long_run(context).handed_out
    first = EPISODES - len(handed_out)  # the other worker holds the episodes before
    expect.equal(handed_out, list(range(first, EPISODES)), "episodes of a long run")


@requirement("EPI-002")
def test_epi_002_attempt_without_an_action_is_not_counted(
    context: CheckContext,
) -> None:
    """`max_attempts` is 1; workers attach and detach without an action.

    Expect the episode to stay at attempt 1, and to be playable.
    """
    run = context.submit("score", max_attempts=1)
    for _ in range(3):
        worker = run.worker()
        worker.attach()
        worker.detach()
        episode = read_closed_episode(run)
        expect.equal(episode["attempt"], 1, "attempt")
        expect.equal(episode["status"], "pending", "status")
    worker = run.worker()
    worker.attach()
    expect.equal(worker.turn["episode"]["attempt"], 1, "attempt of the turn")
    expect.equal(worker.play()["episode_result"]["attempt"], 1, "attempt of the result")


def close_by_detach(worker: WorkerClient) -> None:
    """Close the attempt by a detach."""
    worker.detach()


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
        run.resume()
        run.until("ready")


MANY_ATTEMPTS = 10  # the most that a run may have
CLOSES: list[Callable[[WorkerClient], None]] = [
    close_by_detach,
    close_by_stop,
    close_in_drain,
    close_by_stop_in_drain,
]


def closes(context: CheckContext) -> list[Callable[[WorkerClient], None]]:
    """Give the ways to close an attempt after which the run goes on."""
    return CLOSES if context.offers("control") else CLOSES[:1]


@requirement("EPI-003")
def test_epi_003_closed_attempt_goes_back_to_the_queue(context: CheckContext) -> None:
    """Attempts with one action are closed: by a detach and a stop, also in a drain. One
    of an episode that then faults is, too, and its run is stopped and resumed.

    Expect the episode pending and unscored at the next attempt, starting at step 0.
    """
    worker = submit_and_attach(context, "count", max_attempts=10)
    for attempt, close in enumerate(closes(context), start=2):
        worker.predict(context.action())
        close(worker)
        episode = read_closed_episode(worker.run)
        expect.equal(episode["status"], "pending", "status")
        expect.equal(episode["attempt"], attempt, "attempt")
        turn = worker.attach()
        expect.equal(turn["episode"]["attempt"], attempt, "attempt of the turn")
        expect.equal(turn["episode"]["step"], 0, "step of the turn")
        expect.equal(count(turn), [0], "count in the turn")
    result = worker.play()["episode_result"]
    expect.equal(result["attempt"], attempt, "attempt of the result")
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


@requirement("EPI-004")
def test_epi_004_last_attempt_closed_is_abandoned(context: CheckContext) -> None:
    """`max_attempts` is 2; both attempts are closed after an action with score 0.9.
    Then it is 1, and attempts are closed in each way. At last it is ten.

    Expect no result after the first of two and nine of ten; after the last,
    `abandoned` with score 0, and the next episode to be the next.
    """
    worker = submit_and_attach(context, "score", "score", max_attempts=2)
    first = index_of(worker)
    worker.predict(context.action(score=0.9, success=1))
    worker.detach()
    episode = read_closed_episode(worker.run, first)
    expect.equal(episode["status"], "pending", "status after one attempt")
    worker.attach()
    worker.predict(context.action(score=0.9, success=1))
    worker.detach()
    episode = read_closed_episode(worker.run, first)
    expect.equal(episode["status"], "scored", "status after two attempts")
    result = episode.get("result", {})
    expect.equal(result.get("outcome"), "abandoned", "outcome")
    expect.equal(result.get("score"), 0, "score")
    worker.attach()
    expect.true(index_of(worker) != first, "another episode next", worker.turn)
    worker = submit_and_attach(context, *["score"] * 5, max_attempts=1)
    abandoned: set[int] = set()
    for close in closes(context):
        expect.true(index_of(worker) not in abandoned, "another episode", worker.turn)
        abandoned.add(index_of(worker))
        worker.predict(context.action(score=0.9, success=1))
        close(worker)
        outcomes = [e.get("result", {}).get("outcome") for e in worker.run.episodes()]
        expected = ["abandoned" if i in abandoned else None for i in range(5)]
        expect.equal(outcomes, expected, f"outcomes after {close.__name__}")
        worker.attach()
    worker = submit_and_attach(context, "score", max_attempts=MANY_ATTEMPTS)
    for attempt in range(1, MANY_ATTEMPTS + 1):
        expect.equal(worker.turn["episode"]["attempt"], attempt, "attempt of the turn")
        worker.predict(context.action())
        worker.detach()
        if attempt < MANY_ATTEMPTS:
            status = read_closed_episode(worker.run)["status"]
            expect.equal(status, "pending", f"status after attempt {attempt}")
            worker.attach()
    result = read_closed_episode(worker.run).get("result", {})
    expect.equal(result.get("outcome"), "abandoned", "outcome of the tenth attempt")


def play_all(worker: WorkerClient, received: list[dict[str, Any]]) -> None:
    """Play until no episode is pending, and repeat every turn."""
    action = worker.run.context.action(score=1 / 3, end=1)
    while not worker.turn["done"]:
        turn = worker.predict(action)
        received.append(turn["episode_result"])
        again = worker.try_predict(action, seq=worker.seq)
        expect.require(again, 200, "repeating a turn")


@requirement("EPI-005")
def test_epi_005_scores_every_episode_once(context: CheckContext) -> None:
    """Three workers play nine episodes concurrently, and repeat every turn.

    Expect the result of each episode once in the turns, and the same in the completed
    run.
    """
    run = context.submit(*["score"] * 9)
    attached_workers = attach_workers(run, context.worker_count(3))
    received: list[dict[str, Any]] = []
    context.call_concurrently(
        *[
            lambda worker=worker: play_all(worker, received)
            for worker in attached_workers
        ]
    )
    run.until("completed")
    received.sort(key=lambda result: result["index"])
    expect.equal(
        [r["index"] for r in received],
        list(range(9)),
        "episodes with a result in a turn",
    )
    expect.equal(run.results(), received, "results listed")


def pages(run: RunClient, *limits: int) -> list[list[dict[str, Any]]]:
    """Read all pages of the episodes, with each limit in its turn."""
    limit = itertools.cycle(limits)
    episodes: list[list[dict[str, Any]]] = []

    def read(params: dict[str, Any]) -> Any:
        params = params | {"limit": next(limit)}
        return expect.ok(run.call("list_episodes", params=params))

    for page in read_pages(read):
        episodes.append(page["episodes"])
        count = len(episodes)
        expect.true(count <= EPISODES + 1, "an end of the pages", count)
    return episodes


@on_long_run
@requirement("EPI-006")
def test_epi_006_pages_show_every_episode_once(context: CheckContext) -> None:
    """Seven episodes, some scored, and a hundred and eighty are read in pages of
    several sizes, also of one after another.

    Expect no page longer than its limit, and each episode once, in order.
    """
    worker = submit_and_attach(context, *["score"] * 7)
    worker.play()
    for limit in (1, 2, 3, 7, 100):
        read = pages(worker.run, limit)
        lengths = [len(page) for page in read]
        expect.true(max(lengths) <= limit, f"at most {limit} on a page", lengths)
        indices = [episode["index"] for page in read for episode in page]
        expect.equal(indices, list(range(7)), f"episodes in pages of {limit}")
    mixed = [
        episode["index"] for page in pages(worker.run, 2, 3, 1) for episode in page
    ]
    expect.equal(mixed, list(range(7)), "episodes in pages of 2, 3 and 1")
    for limit in (11, 45, 90, 99, 100, 101, 179, 180, 181, 1000):
        read = pages(long_run(context).run, limit)
        indices = [episode["index"] for page in read for episode in page]
        expect.equal(indices, list(range(EPISODES)), f"episodes in pages of {limit}")


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

    Expect no turn to hold a seed outside `episode_result`, by name or by value.
    """
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


def expect_episode_of_one_worker(context: CheckContext) -> None:
    """Expect a second worker, if it is admitted, to get another episode."""
    first = submit_and_attach(context, "score", "score")
    answer = first.run.worker().try_attach()
    if answer.status == 200 and "episode" in answer.json:
        index = answer.json["episode"]["index"]
        expect.true(index != index_of(first), "another episode", index)
    expect.ok(first.try_next())


@requirement("EPI-008")
def test_epi_008_no_episode_is_held_twice(context: CheckContext) -> None:
    """Four workers attach at once, and end their episodes at once, several times. The
    one with the first episode is taken over, and another one attaches again.

    Expect different episodes for all workers.
    """
    workers = context.worker_count(4)
    if workers == 1:
        expect_episode_of_one_worker(context)
        return
    run = context.submit(*["score"] * 4 * workers)
    attached_workers = [run.worker() for _ in range(workers)]
    context.call_concurrently(*[worker.attach for worker in attached_workers])
    held = sorted(map(index_of, attached_workers))
    expect.equal(held, sorted(set(held)), "episodes held after the attaches")
    for number in range(3):
        context.call_concurrently(*[worker.play for worker in attached_workers])
        held = sorted([*held, *map(index_of, attached_workers)])
        expect.equal(held, sorted(set(held)), f"episodes held after {number + 1}")
    first, second, *_ = sorted(attached_workers, key=index_of)
    first.attach(takeover=True)
    second.detach()
    again = expect.ok(second.try_attach())
    both = [index_of(first), again["episode"]["index"]]
    expect.true(both[0] != both[1], "another episode than after the takeover", both)


def close_by_lease(worker: WorkerClient) -> None:
    """Send nothing until the lease is over."""
    time.sleep(worker.run.body["idle_timeout_s"] + worker.run.context.tolerance_s)


@requirement("EPI-009")
@background
def test_epi_009_completed_whatever_closed_the_last_attempt(
    context: CheckContext,
) -> None:
    """`max_attempts` is 1; the attempt of the last episode is closed after an action:
    by a detach, a stop, both in a drain, and the end of a lease.

    Expect the run `completed`.
    """
    shortest_s = max(2.0, context.limits["idle_timeout_s_min"])
    for close in (*closes(context), close_by_lease):
        lease_s = shortest_s if close is close_by_lease else None
        run = context.submit("score", "score", max_attempts=1, idle_timeout_s=lease_s)
        worker = run.worker()
        worker.attach()
        worker.play()
        worker.predict(context.action())
        close(worker)
        expect_state_soon(run, "completed")
        expect.equal(run.score()["complete"], True, "complete")


@requirement("EPI-010")
def test_epi_010_result_of_an_abandoned_episode(context: CheckContext) -> None:
    """`max_attempts` is 2; the first attempt has one action, the second has three.

    Expect `attempt` 2 and `steps` 3, neither terminated nor truncated.
    """
    worker = submit_and_attach(context, *["count"] * 5, max_attempts=2)
    for close in closes(context):
        index = index_of(worker)
        worker.predict(context.action())
        worker.detach()
        worker.attach()
        worker.predict(context.action(), context.action())
        worker.predict(context.action())
        close(worker)
        result = worker.run.episodes()[index].get("result")
        if result is None:
            raise SetUpFailed("the episode is not abandoned; see EPI-004")
        expected = {"attempt": 2, "steps": 3, "terminated": False, "truncated": False}
        members = {name: result[name] for name in expected}
        expect.equal(members, expected, f"the result after {close.__name__}")
        worker.attach()


@requirement("EPI-011")
@background
def test_epi_011_think_time_is_that_between_turns(context: CheckContext) -> None:
    """A policy thinks in its first attempt, and in the second one before and after a
    turn that takes some time; a heartbeat and a refused turn come in between. Another
    one thinks before its worker is taken over, and then plays the next episode.

    Expect `think_s` of the whole second attempt alone, each time once, without the time
    of its long turn; and none of the first episode in the next one.
    """
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

    Expect three steps, then the end, and a failure.
    """
    worker = submit_and_attach(
        context, "count", max_steps=3, max_attempts=10, success_rule="any_step"
    )
    for close in closes(context)[:2]:
        worker.predict(context.action(success=1), context.action())
        close(worker)
        worker.attach()
    turn = expect.ok(worker.try_predict(context.action(), context.action()))
    worker.seq += 1
    expect.true("episode_result" not in turn, "no end after two of three steps", turn)
    turn = expect.ok(worker.try_predict(context.action(), context.action()))
    expect.equal(turn["executed_steps"], 1, "executed_steps")
    result = worker.run.episodes()[0].get("result", {})
    expect.equal(result.get("steps"), 3, "steps")
    expect.equal(result.get("outcome"), "failure", "outcome")
