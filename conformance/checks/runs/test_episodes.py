"""Episodes: order, attempts, results (EPI)."""

from collections.abc import Callable
from typing import Any

from conformance.checks.support.given_states import (
    attach_workers,
    count,
    index_of,
    require_worker_limit,
    submit_and_attach,
    without,
)
from conformance.client.check_context import CheckContext
from conformance.client.run_client import RunClient, WorkerClient
from conformance.runner.requirement import requirement
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


@requirement("EPI-001")
def test_epi_001_hands_out_in_manifest_order(context: CheckContext) -> None:
    """A worker plays while another one (if allowed) holds an episode.

    Expect it to get the first pending episode in manifest order, also when it
    returned that episode itself.
    """
    tasks = ["score", "count", "echo", "delay", "fault"]
    run = context.submit(*tasks)
    attached_workers = attach_workers(run, min(2, context.limits["max_workers"]))
    for index, worker in enumerate(attached_workers):
        expect.equal(episode_of(worker), (index, tasks[index]), "a first episode")
    for index in range(len(attached_workers), 4):
        attached_workers[0].play()
        expect.equal(
            episode_of(attached_workers[0]), (index, tasks[index]), "the next episode"
        )
    worker = attached_workers[0]
    returned_episode = episode_of(worker)
    worker.predict(context.action())
    worker.detach()
    worker.attach()
    expect.equal(episode_of(worker), returned_episode, "the episode given back")


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
    worker.run.resume()
    worker.run.until("ready")


@requirement("EPI-003")
def test_epi_003_closed_attempt_goes_back_to_the_queue(context: CheckContext) -> None:
    """An attempt with one action is closed by a detach, and another by a stop.

    Expect the episode pending and unscored at the next attempt, starting at step 0.
    """
    worker = submit_and_attach(context, "count")
    closes: list[Callable[[WorkerClient], None]] = [close_by_detach, close_by_stop]
    for attempt, close in enumerate(closes, start=2):
        worker.predict(context.action())
        close(worker)
        episode = read_closed_episode(worker.run)
        expect.equal(episode["status"], "pending", "status")
        expect.equal(episode["attempt"], attempt, "attempt")
        turn = worker.attach()
        expect.equal(turn["episode"]["attempt"], attempt, "attempt of the turn")
        expect.equal(turn["episode"]["step"], 0, "step of the turn")
        expect.equal(count(turn), [0], "count in the turn")


@requirement("EPI-004")
def test_epi_004_last_attempt_closed_is_abandoned(context: CheckContext) -> None:
    """`max_attempts` is 2; both attempts are closed after an action with score 0.9.

    Expect no result after the first; after the second, `abandoned` with score 0, and
    the other episode to be the next.
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


def play_all(worker: WorkerClient, received: list[dict[str, Any]]) -> None:
    """Play until no episode is pending, and repeat every turn."""
    action = worker.run.context.action(score=0.5, end=1)
    while not worker.turn["done"]:
        turn = worker.predict(action)
        received.append(turn["episode_result"])
        again = worker.try_predict(action, seq=worker.seq)
        expect.require(again, 200, "repeating a turn")


@requirement("EPI-005")
def test_epi_005_scores_every_episode_once(context: CheckContext) -> None:
    """Three workers play nine episodes concurrently, and repeat every turn.

    Expect one result per episode in the turns, equal to that of the completed run.
    """
    run = context.submit(*["score"] * 9)
    attached_workers = attach_workers(run, min(3, context.limits["max_workers"]))
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
    listed = [episode.get("result") for episode in run.episodes()]
    expect.equal(listed, received, "results listed")


def pages(run: RunClient, limit: int) -> list[list[dict[str, Any]]]:
    """Read all pages of the episodes with a limit."""
    read: list[list[dict[str, Any]]] = []
    params: dict[str, Any] = {"limit": limit}
    while "cursor" not in params or params["cursor"] is not None:
        page = expect.ok(run.call("list_episodes", params=params))
        read.append(page["episodes"])
        params["cursor"] = page["next_cursor"]
        expect.true(len(read) <= 9, "an end of the pages", len(read))
    return read


@requirement("EPI-006")
def test_epi_006_pages_show_every_episode_once(context: CheckContext) -> None:
    """Seven episodes, some scored, read in pages of 1, 2, 3, 7 and 100.

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


def find_seeds(value: Any, seeds: list[int], path: str = "") -> list[str]:
    """Find members named `seed`, or equal to a seed, in a turn."""
    if isinstance(value, dict):
        found = [f"{path}/{name}" for name in value if name == "seed"]
        for name, item in value.items():
            found += find_seeds(item, seeds, f"{path}/{name}")
        return found
    if isinstance(value, list):
        return [leak for item in value for leak in find_seeds(item, seeds, f"{path}/-")]
    is_number = isinstance(value, int | float) and not isinstance(value, bool)
    return [path] if is_number and value in seeds else []


@requirement("EPI-007")
def test_epi_007_seeds_are_not_in_turns(context: CheckContext) -> None:
    """Episodes of several tasks are played; their results then contain the seeds.

    Expect no turn to hold a seed outside `episode_result`, by name or by value.
    """
    worker = submit_and_attach(context, "score", "echo", "count")
    turns = [worker.turn]
    while not worker.turn["done"]:
        turns.append(worker.predict(context.action(), observe="all"))
        turns.append(worker.predict(context.action(end=1)))
    seeds = [turn["episode_result"]["seed"] for turn in turns[2::2]]
    for turn in turns:
        # A lease may well be as long as a seed is large.
        found = find_seeds(without(turn, "episode_result", "lease", "timing"), seeds)
        expect.true(not found, "no seed in the turn", found)


@requirement("EPI-008")
def test_epi_008_no_episode_is_held_twice(context: CheckContext) -> None:
    """Four workers attach at once, and end their episodes at once, several times.

    Expect different episodes for all workers.
    """
    workers = min(4, context.limits["max_workers"])
    require_worker_limit(context, 2)
    run = context.submit(*["score"] * 4 * workers)
    attached_workers = [run.worker() for _ in range(workers)]
    context.call_concurrently(*[worker.attach for worker in attached_workers])
    held = sorted(map(index_of, attached_workers))
    expect.equal(held, sorted(set(held)), "episodes held after the attaches")
    for number in range(3):
        context.call_concurrently(*[worker.play for worker in attached_workers])
        held = sorted([*held, *map(index_of, attached_workers)])
        expect.equal(held, sorted(set(held)), f"episodes held after {number + 1}")
