"""A server that is killed with SIGKILL and restarted (CRASH)."""

import threading
import time
import uuid
from datetime import datetime
from functools import partial
from typing import Any

from conformance.checks.support.expected_states import expect_state_soon
from conformance.checks.support.generated.mixed_histories import (
    expect_histories_with_kills,
)
from conformance.checks.support.given_states import (
    attach_workers,
    make_run_in_state,
    start_drain,
    submit_and_attach,
    without,
)
from conformance.checks.support.planned_run import ABANDONED, PlannedEpisode, PlannedRun
from conformance.checks.support.submissions import find_listed, submit
from conformance.client.check_context import CheckContext
from conformance.client.event_reader import follow_run
from conformance.client.run_client import RunClient, WorkerClient
from conformance.runner.private_server import PrivateServer, open_private_server
from conformance.runner.requirement import plays_histories, requirement
from conformance.verdicts import expect
from conformance.verdicts.expect import SetUpFailed

KILLS = 3
QUEUE_S = 2.0
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


def kill_under_load(
    server: PrivateServer, after_s: float
) -> tuple[RunClient, list[Any]]:
    """Kill the server while workers play; give the run and the results received."""
    context = server.context
    run = context.submit(*["score"] * 1000)
    workers = attach_workers(run, context.worker_count(3))
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
    """Workers play at full speed; the server is killed at random moments. Expect every
    result that a worker received, unchanged, after each restart."""
    with open_private_server(context) as server:
        results_by_run: list[tuple[RunClient, list[Any]]] = []
        for _ in range(KILLS):
            results_by_run.append(
                kill_under_load(server, context.random.uniform(0.05, 0.3))
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
    if not turn["done"]:
        expect.equal(turn["episode"]["attempt"], 1, "attempt after the crash")
    while not turn["done"]:
        turn = expect.ok(worker.try_predict(worker.run.context.action(end=1)))
        worker.seq += 1


def kill_in_two_episodes(server: PrivateServer, run: RunClient) -> list[WorkerClient]:
    """Score an episode, begin two, and restart the server after a kill."""
    workers = attach_workers(run, server.context.worker_count(2))
    workers[0].play(score=0.75)
    for worker in workers:
        worker.predict(server.context.action())
    server.kill9()
    server.restart()
    return workers


@requirement("CRASH-005")
def test_crash_005_runs_for_a_session(context: CheckContext) -> None:
    """The server is killed with episodes in progress. Expect the run to be `running`
    only if a session has outlived the restart: workers would wait for its end
    (LIFE-802), and a drain of it would never end."""
    with open_private_server(context) as server:
        run = server.context.submit("score", "score", "score")
        workers = kill_in_two_episodes(server, run)
        living = [worker for worker in workers if worker.try_heartbeat().status == 200]
        state = expect.ok(run.call("get_run"))["state"]
        text = "a run without a living session is not `running` after the restart"
        expect.true(living or state != "running", text, state)


@requirement("CRASH-002")
def test_crash_002_costs_no_attempt(context: CheckContext) -> None:
    """`max_attempts` is 1; the server is killed with two episodes in progress. Expect
    both pending at attempt 1, and the run to complete, after a resume if its state
    requires one."""
    with open_private_server(context) as server:
        run = server.context.submit("score", "count", "score", max_attempts=1)
        workers = kill_in_two_episodes(server, run)
        if run.get()["state"] in ("stopped", "failed"):
            expect.ok(run.call("resume_run"))
            run.until("ready")
        attempts = [episode["attempt"] for episode in run.episodes()]
        expect.equal(attempts, [1, 1, 1], "attempts after the restart")
        for worker in workers:
            if run.get()["state"] != "completed":
                play_to_the_end(worker)
        expect.equal(run.get()["state"], "completed", "state in the end")


def make_resting_runs(context: CheckContext) -> list[RunClient]:
    """Submit runs that no restart may change: completed, stopped and failed ones."""
    completed = PlannedRun(context, [PlannedEpisode("success", 1 / 3), ABANDONED])
    completed.play_all()
    lease_s = (context.limits["idle_timeout_s_min"] + 7) / 2
    images = context.benchmark["image_sizes"][-1] | {"codec": "raw"}
    # Characters at which some programs end a line, and others a text.
    policy = {"name": "kit \u2028\x85\x0c\r\n\x1f end", "version": "7"}
    policy |= {"submitter": "a", "homepage": "http://b"}
    body = context.submit_body(
        policy=policy,
        max_workers=1,
        idle_timeout_s=min(lease_s, context.limits["idle_timeout_s_max"]),
        images=images,
        options={"tasks": ["score"] * 3, "max_attempts": 1},
    )
    answer = context.call("submit_run", json=body)
    stopped = context.adopt(expect.require(answer, 201, "`submit_run`"))
    stopped.until("ready")
    worker = stopped.worker()
    worker.attach()
    worker.play(score=0.1)
    worker.predict(context.action())
    stopped.stop()
    failed = [make_run_in_state(context, s) for s in ("failed", "failed not_retryable")]
    return [completed.run, complete_chosen_run(context), stopped, *failed]


def complete_chosen_run(context: CheckContext) -> RunClient:
    """Complete a run of a part of its tasks, with sealed seeds, where offered."""
    chosen: dict[str, Any] = {}
    if context.offers("subsets"):
        chosen["select"] = {"tasks": ["score"]}
    if context.offers("sealed_seeds"):
        chosen["sealed"] = True
    worker = submit_and_attach(context, "score", "score", "count", **chosen)
    while not worker.turn["done"]:
        worker.play()
    return worker.run


def listed_ids(context: CheckContext, runs: list[RunClient]) -> list[str]:
    """Read the ids of some runs, which are among the newest, from `list_runs`."""
    answer = expect.ok(context.call("list_runs", params={"limit": 100}))
    ids = {run.id for run in runs}
    return [run["run_id"] for run in answer["runs"] if run["run_id"] in ids]


def shown_manifests(context: CheckContext) -> dict[str, str]:
    """Read the hashes of the benchmarks and of a new run, sealed where offered."""
    listed = expect.ok(context.call("list_benchmarks"))["benchmarks"]
    shown = {summary["benchmark_id"]: summary["manifest_sha256"] for summary in listed}
    sealed: dict[str, Any] = {"sealed": True} if context.offers("sealed_seeds") else {}
    run = context.submit("score", "count", **sealed)
    return shown | {"a new run": run.body["manifest_sha256"]}


def expect_alike_in_all_views(context: CheckContext, runs: list[RunClient]) -> None:
    """Expect `list_runs` and the events of runs to show what the other reads show."""
    listed = find_listed(context, {run.id for run in runs})
    for run in runs:
        for view in (listed[run.id], run.get()):
            view.pop("updated_at", None)
        expect.equal(listed[run.id], run.body, "the run in `list_runs`")
        if context.offers("events") and run.body["state"] == "completed":
            with follow_run(run) as reader:
                events = reader.until(lambda event: event.kind == "run", "a `run`")
            sent = {e.body["index"]: e.body for e in events if e.kind == "episode"}
            shown = {episode["index"]: episode for episode in run.episodes()}
            expect.equal(sent, shown, "the episodes in the events")


def require_no_step_back(run: RunClient, updated_at: str) -> None:
    """Require that a restart did not set back when a run changed last."""
    run.get()
    times = (run.body["created_at"], updated_at, run.body["updated_at"])
    moments = [datetime.fromisoformat(time_) for time_ in times]
    if moments != sorted(moments):
        text = f"updated_at was {updated_at}, and is {run.body['updated_at']}"
        raise SetUpFailed(f"{text} after a restart", breaks="RUN-021")


def expect_key_in_use(context: CheckContext, key: str, first: dict[str, Any]) -> None:
    """Expect the run of a key for its body, and a conflict for another body.

    For another account it is a new key.
    """
    body = context.submit_body(options={"tasks": ["score", "count"]})
    second_body = context.submit_body(options={"tasks": ["count", "score"]})
    headers = {"Idempotency-Key": key}
    again = expect.ok(submit(context, body, headers=headers), 201)
    expect.equal(again["run_id"], first["run_id"], "run_id for the same key")
    conflict = submit(context, second_body, headers=headers)
    expect.refused(conflict, "idempotency_conflict")
    new = {"Idempotency-Key": uuid.uuid4().hex}
    another = expect.ok(submit(context, body, headers=new), 201)
    expect.true(another["run_id"] != first["run_id"], "a run for a new key", another)
    if context.shared.settings.token_2 is not None:
        second = {"headers": headers, "http_client": context.second_account}
        theirs = expect.ok(submit(context, body, **second), 201)
        expect.true(theirs["run_id"] != first["run_id"], "a run of its own", theirs)


def play_and_read_etags(worker: WorkerClient) -> dict[str, dict[str, Any]]:
    """Attach, play an action and detach; give each ETag of the run, with the run."""
    shown: dict[str, dict[str, Any]] = {}
    play = partial(worker.predict, worker.run.context.action())
    for step in (worker.run.get, worker.attach, play, worker.detach):
        step()
        answer = worker.run.call("get_run")
        shown[answer.headers.get("etag", "")] = expect.require(answer, 200, "get_run")
    return shown


@requirement("CRASH-003")
@plays_histories
def test_crash_003_runs_survive_a_crash(context: CheckContext) -> None:
    """Completed, stopped and failed runs, with abandoned episodes and choices of their
    own, a run with an Idempotency-Key, and one that is played before and after, when
    the server is killed. Then it is killed in the middle of generated histories. Expect
    each run, its episodes, its score, their order, the key, and the hashes of
    benchmarks and of new runs as before, also in lists and events; then every answer
    and event as the oracle allows."""
    with open_private_server(context) as server:
        manifests = shown_manifests(server.context)
        runs = make_resting_runs(server.context)
        played = server.context.submit("count", max_attempts=10).worker()
        etags = play_and_read_etags(played)
        key = uuid.uuid4().hex
        body = server.context.submit_body(options={"tasks": ["score", "count"]})
        answer = submit(server.context, body, headers={"Idempotency-Key": key})
        first = expect.require(answer, 201, "`submit_run`")
        before = [run.snapshot() for run in runs]
        updated = [run.body["updated_at"] for run in runs]
        order = listed_ids(server.context, runs)
        server.kill9()
        server.restart()
        for run, shown in zip(runs, before, strict=True):
            expect.ok(run.call("get_run"))
            now = run.snapshot()
            for part in ("list_episodes", "get_score"):
                expect.equal(now[part], shown[part], f"`{part}` of the run")
            wanted = without(shown["get_run"], "reason")
            expect.equal(without(now["get_run"], "reason"), wanted, "the run")
            if shown["get_run"]["state"] == "failed":
                expect.true(now["get_run"]["reason"], "a reason when failed", None)
        for run, updated_at in zip(runs, updated, strict=True):
            require_no_step_back(run, updated_at)
        expect.equal(listed_ids(server.context, runs), order, "runs listed")
        expect_alike_in_all_views(server.context, runs)
        expect_key_in_use(server.context, key, first)
        manifests_after = shown_manifests(server.context)
        expect.equal(manifests_after, manifests, "manifest_sha256 after the restart")
        if played.run.get()["state"] == "stopped":
            played.run.resume()
        played.run.until("ready")
        for etag, body in play_and_read_etags(played).items():
            if etags.get(etag, body) != body:
                text = f"the ETag {etag} of before the restart names another state"
                raise SetUpFailed(text, breaks="RUN-030")
        expect_histories_with_kills(server.context, partial(kill_and_restart, server))


def kill_and_restart(server: PrivateServer) -> None:
    """Kill a server, and start it again on its data."""
    server.kill9()
    server.restart()


def expect_to_leave_the_queue(run: RunClient) -> None:
    """Expect a long-poll to end when a queued run becomes ready, without a request."""
    wait_s = min(5, run.context.limits["wait_s_max"])
    read = run.call("get_run")
    if expect.ok(read)["state"] != "queued" or wait_s < 5:
        return
    tag = {"If-None-Match": read.headers.get("etag", "")}
    polled = run.call("get_run", headers=tag | {"Prefer": f"wait={wait_s}"})
    limit_s = QUEUE_S + 1 + run.context.tolerance_s
    expect.in_time(polled.elapsed_s, limit_s, "the answer to a long-poll in the queue")
    expect.equal(polled.status, 200, "status of a long-poll in the queue")


def expect_attempt_and_fault(worker: WorkerClient) -> None:
    """Expect attempt 2 and one fault of two, and a run that goes on and can fail."""
    run, context = worker.run, worker.run.context
    expect.ok(run.call("get_run"))
    expect.members(run.episodes()[0], {"attempt": 2, "faults": 1})
    if run.get()["state"] in ("stopped", "failed"):
        run.resume(until_ready=True)
    turn = worker.attach(takeover=True)
    expect.equal(turn["episode"]["attempt"], 2, "attempt of the turn")
    # Whether a restart queues the run, and forgives the fault, is the server's choice.
    if worker.try_predict(context.action(fault=1)).status == 200:
        worker.seq += 1
        worker.try_predict(context.action(fault=1))
    expect.equal(run.get()["state"], "failed", "state after two more faults")


def make_counted_runs(context: CheckContext) -> list[tuple[RunClient, str, int, str]]:
    """Make runs of which something is counted.

    Gives for each the member of its episode, what is to be in it, and words for it.
    """
    lease_s = max(1.0, context.limits["idle_timeout_s_min"])
    silent = submit_and_attach(context, "count", idle_timeout_s=lease_s)
    silent.predict(context.action())
    detached = submit_and_attach(context, "count")
    detached.predict(context.action())
    detached.detach()
    faulty = submit_and_attach(context, "fault", max_faults=3)
    faulty.predict(context.action(fault=1))
    faulty.run.stop()
    faulty.run.resume()
    silent.run.until("ready", lease_s + 5)
    return [
        (silent.run, "attempt", 2, "an episode whose lease has ended"),
        (detached.run, "attempt", 2, "an episode in the queue"),
        (faulty.run, "faults", 1, "an episode that was resumed"),
    ]


def expect_no_old_fault_to_count(run: RunClient) -> None:
    """Expect a run that was resumed after two faults of two to outlive one more."""
    expect.equal(expect.ok(run.call("get_run"))["retryable"], None, "retryable")
    if run.get()["state"] == "stopped":
        run.resume()
    run.until("ready")
    worker = run.worker()
    worker.attach()
    expect.ok(worker.try_next(fault=1))
    expect.equal(run.get()["state"], "running", "state after a fault of two")


@requirement("CRASH-004")
def test_crash_004_commands_survive_a_crash(context: CheckContext) -> None:
    """Runs are draining with an episode in play, resumed, in the queue, and stopped
    again, and an episode is at its second attempt with a fault, when the server is
    killed, twice; attempts were ended by a detach and by a lease, a fault was before a
    resume, and a run that failed was resumed. Expect the first and the stopped one
    `stopped`, the others to become `ready`, the attempts and the faults counted, and no
    fault of before the resume against the run."""
    with open_private_server(context) as server:
        context = server.context
        stopped, resumed = context.submit("score"), context.submit("score")
        requeued = context.submit("score", queue_s=0.5)
        faulty = submit_and_attach(context, "fault", max_faults=2)
        faulty.predict(context.action())
        faulty.detach()
        faulty.attach()
        faulty.predict(context.action(fault=1))
        counted = make_counted_runs(context)
        worker = submit_and_attach(context, "fault", max_faults=2)
        worker.predict(context.action(fault=1))
        worker.try_next(fault=1)
        worker.run.until("failed")
        worker.run.resume()
        forgiven = worker.run
        for run in (stopped, resumed, requeued):
            run.stop()
            run.resume()
        draining = submit_and_attach(context, "score", "score").run
        submitted = context.submit("score", wait_ready=False, queue_s=QUEUE_S)
        stopped.stop()
        start_drain(draining)
        for _ in range(2):  # what outlives one crash may not outlive the next
            server.kill9()
            server.restart()
        for run in (draining, stopped):
            expect.equal(expect.ok(run.call("get_run"))["state"], "stopped", "state")
        expect_to_leave_the_queue(submitted)
        for run in (submitted, resumed, requeued):
            expect_state_soon(run, "ready")
        expect_attempt_and_fault(faulty)
        expect_no_old_fault_to_count(forgiven)
        for run, member, number, what in counted:
            expect.ok(run.call("get_run"))
            expect.equal(run.episodes()[0][member], number, f"{member} of {what}")
