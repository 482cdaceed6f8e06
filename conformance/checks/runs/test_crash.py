"""A server that is killed with SIGKILL and restarted (CRASH)."""

import threading
import time
from typing import Any

from conformance.checks.support.given_states import attach_workers
from conformance.client.check_context import CheckContext
from conformance.client.run_client import RunClient, WorkerClient
from conformance.runner.private_server import PrivateServer, open_private_server
from conformance.runner.requirement import requirement
from conformance.verdicts import expect
from conformance.verdicts.expect import SetUpFailed

KILLS = 3
FIRST_RESULT_S = 10.0


def play_until_killed(worker: WorkerClient, results: list[dict[str, Any]]) -> None:
    """Play episode after episode, and collect every result received."""
    number = 0
    try:
        while not worker.turn["done"]:
            number += 1
            turn = worker.play(score=number % 8 / 8, steps=1 + number % 2)
            results.append(turn["episode_result"])
    except SetUpFailed:
        return  # the server is gone


def kill_server_under_load(
    server: PrivateServer, after_s: float
) -> tuple[RunClient, list[Any]]:
    """Kill the server while workers play; give the run and the results received."""
    context = server.context
    run = context.submit(*["score"] * 1000)
    workers = attach_workers(run, min(3, context.limits["max_workers"]))
    results: list[dict[str, Any]] = []
    threads = [
        threading.Thread(target=play_until_killed, args=(worker, results), daemon=True)
        for worker in workers
    ]
    for thread in threads:
        thread.start()
    # The moment is random, but after the first result: before it nothing can be lost.
    deadline = time.monotonic() + FIRST_RESULT_S
    while not results and time.monotonic() < deadline:
        time.sleep(0.005)
    time.sleep(after_s)
    server.kill9()
    server.restart()
    for thread in threads:
        thread.join(timeout=30)
    return run, results


@requirement("CRASH-001")
def test_crash_001_sent_results_survive_a_crash(context: CheckContext) -> None:
    """Workers play at full speed; the server is killed at random moments.

    Expect every result that a worker received, unchanged, after each restart.
    """
    with open_private_server(context) as server:
        results_by_run: list[tuple[RunClient, list[Any]]] = []
        for _ in range(KILLS):
            results_by_run.append(
                kill_server_under_load(server, context.random.uniform(0.05, 0.3))
            )
            for run, results in results_by_run:
                if not results:
                    raise SetUpFailed("no episode was scored before the kill")
                expect.ok(run.call("get_run"))
                listed = {e["index"]: e.get("result") for e in run.episodes()}
                for result in results:
                    index = result["index"]
                    expect.equal(listed[index], result, f"result of episode {index}")


def play_to_the_end(worker: WorkerClient) -> None:
    """Expect a worker to attach again, and to play to the end."""
    turn = expect.ok(worker.try_attach(takeover=True))
    worker.session_id, worker.seq = turn["session_id"], turn["seq"]
    while not turn["done"]:
        turn = expect.ok(worker.try_predict(worker.run.context.action(end=1)))
        worker.seq += 1


@requirement("CRASH-002")
def test_crash_002_costs_no_attempt(context: CheckContext) -> None:
    """`max_attempts` is 1; the server is killed with two episodes in progress.

    Expect both pending at attempt 1, and the run to complete, after a resume if its
    state requires one.
    """
    with open_private_server(context) as server:
        run = server.context.submit("score", "count", "score", max_attempts=1)
        workers = attach_workers(run, min(2, server.context.limits["max_workers"]))
        workers[0].play(score=0.75)
        for worker in workers:
            worker.predict(server.context.action())
        server.kill9()
        server.restart()
        expect.ok(run.call("get_run"))
        if run.get()["state"] in ("stopped", "failed"):
            expect.ok(run.call("resume_run"))
            run.until("ready")
        attempts = [episode["attempt"] for episode in run.episodes()]
        expect.equal(attempts, [1, 1, 1], "attempts after the restart")
        for worker in workers:
            if run.get()["state"] != "completed":
                play_to_the_end(worker)
        expect.equal(run.get()["state"], "completed", "state in the end")
