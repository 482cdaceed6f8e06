"""Services that are reached at several base URLs: the profile `cluster` (CLU).

All other checks spread their requests over the base URLs; these send each request to
one that they choose.
"""

import copy
import itertools
import uuid
from collections.abc import Iterator
from functools import partial
from typing import Any

from conformance.checks.profiles.test_events import (
    episodes_in,
    expect_change_in_time,
    ids_of,
    in_state,
    read_events,
)
from conformance.checks.runs.test_conditional_reads import (
    change_later,
    etag_of,
    wait_header,
)
from conformance.checks.runs.test_idempotency import new_key
from conformance.checks.support.expected_states import WAIT_S, expect_changed
from conformance.checks.support.given_states import (
    count,
    require_worker_limit,
    submit_and_attach,
)
from conformance.checks.support.submissions import runs_of, submit, uniquely_named_body
from conformance.checks.turns.test_lease import (
    attach_with_lease,
    expect_inside_lease,
    sleep_nearly_through,
    sleep_past,
)
from conformance.client.check_context import CheckContext
from conformance.client.event_reader import follow_run
from conformance.client.http_client import HttpClient
from conformance.client.run_client import RunClient, WorkerClient
from conformance.exchanges.answer import Answer
from conformance.runner.requirement import background, requirement
from conformance.verdicts import expect

# A server that decides requests at the same moment apart does so in one of them.
ROUNDS = 4
LATE_S = 1.0


def at(run: RunClient, http_client: HttpClient) -> RunClient:
    """Give the same run, all of whose requests go to one base URL."""
    return RunClient(run.context, run.body, http_client)


def worker_at(worker: WorkerClient, http_client: HttpClient) -> WorkerClient:
    """Give the same worker with its session, whose requests go to one base URL."""
    same = copy.copy(worker)
    same.run = at(worker.run, http_client)
    return same


def pairs_of(context: CheckContext) -> Iterator[tuple[HttpClient, HttpClient]]:
    """Give a client of each base URL, with one of the next."""
    clients = context.clients_by_url
    return itertools.pairwise([*clients, clients[0]])


def views_at(run: RunClient, http_client: HttpClient) -> dict[str, Any]:
    """Read all that is shown of a run at one base URL; none of it may be refused."""
    run_there = at(run, http_client)
    names = ("get_run", "list_episodes", "get_score")
    views = {name: expect.ok(run_there.call(name)) for name in names}
    views["get_run"].pop("queue_position", None)
    return views


@requirement("CLU-001")
def test_clu_001_goes_by_what_another_url_has_answered(context: CheckContext) -> None:
    """At each base URL a run is submitted, played, stopped and resumed; after each
    answer it is read, listed and continued at the next one. Expect there the state of
    the last answer, at once."""
    for here, there in pairs_of(context):
        run = context.submit("score", "count", http_client=here)
        run_there = at(run, there)
        worker = run.worker()
        expect.equal(expect.ok(run_there.call("get_run"))["state"], "ready", "state")
        worker.attach()
        shown = expect.ok(run_there.call("get_run"))
        expect.equal(shown["live_workers"], 1, "live_workers")
        ended = worker.play(score=1, success=1)["episode_result"]
        listed = expect.ok(run_there.call("list_episodes"))["episodes"]
        expect.equal(listed[0]["result"], ended, "the result of the first episode")
        turn = expect.ok(worker_at(worker, there).try_predict(context.action()))
        expect.equal(count(turn), [1], "count in the second episode")
        worker.seq += 1
        run.stop()
        expect.equal(expect.ok(run_there.call("get_run"))["state"], "stopped", "state")
        late = worker_at(worker, there).try_predict(context.action())
        expect.refused(late, "session_ended")
        expect.ok(run_there.call("resume_run"))
        state = expect.ok(run.call("get_run"))["state"]
        expect.true(state != "stopped", "a run that was resumed", state)
        newest = expect.ok(context.call("list_runs", http_client=there))["runs"]
        ids = [listed_run["run_id"] for listed_run in newest]
        expect.true(run.id in ids, "the run in `list_runs`", ids[:3])


@requirement("CLU-002")
def test_clu_002_shows_the_same_at_each_base_url(context: CheckContext) -> None:
    """The service, its benchmarks, and a run that is ready, in play, and completed.
    Expect the same bodies, but for the time of the server, and the same ETag."""
    clients = context.clients_by_url
    for operation in ("describe_service", "list_benchmarks"):
        first, *others = [
            expect.ok(context.call(operation, http_client=client)) for client in clients
        ]
        for answer in (first, *others):
            answer.pop("server_time", None)
        for body in others:
            expect.equal(body, first, f"the answer of `{operation}`")
    run = context.submit("score")
    worker = run.worker()
    for change in (None, worker.attach, worker.play):
        if change is not None:
            change()
        first, *others = [views_at(run, client) for client in clients]
        for body in others:
            expect.equal(body, first, "the views of the run")
        tags = {etag_of(at(run, client))["If-None-Match"] for client in clients}
        expect.equal(len(tags), 1, "different ETags of the run")


@requirement("CLU-003")
def test_clu_003_repeat_at_another_base_url_is_a_repeat(context: CheckContext) -> None:
    """A submit, an attach and turns are repeated at another base URL: after the answer,
    and at the moment of the first request. Expect one run, one session, and each action
    executed once."""
    for here, there in pairs_of(context):
        body, key = uniquely_named_body(context), new_key()
        both = (here, there)
        answers = context.call_concurrently(
            *[partial(submit, context, body, headers=key, http_client=c) for c in both]
        )
        answers.append(submit(context, body, headers=key, http_client=there))
        ids = {expect.ok(answer, 201)["run_id"] for answer in answers}
        expect.equal(len(ids), 1, "runs returned to one Idempotency-Key")
        expect.equal(runs_of(context, body), list(ids), "the runs made of it")
        worker = context.submit("count", "count", http_client=here).worker()
        expect_one_session(context, worker, both)
        expect_one_execution(context, worker, both)


def expect_one_session(
    context: CheckContext, worker: WorkerClient, clients: tuple[HttpClient, ...]
) -> None:
    """Expect one session of attaches with one key, with which the worker goes on."""
    key = uuid.uuid4().hex
    attach = [partial(worker_at(worker, c).try_attach, attach_key=key) for c in clients]
    answers = [*context.call_concurrently(*attach), *[send() for send in attach]]
    sessions = {expect.ok(answer)["session_id"] for answer in answers}
    expect.equal(len(sessions), 1, "sessions of one attach_key")
    worker.session_id = sessions.pop()


def expect_one_execution(
    context: CheckContext, worker: WorkerClient, clients: tuple[HttpClient, ...]
) -> None:
    """Expect turns to be executed once, wherever they are sent and repeated."""
    for executed in range(1, ROUNDS + 1):
        action = context.action()
        send = [partial(worker_at(worker, c).try_predict, action) for c in clients]
        answers = [*context.call_concurrently(*send), *[again() for again in send]]
        first, *others = [expect.ok(answer) for answer in answers]
        expect.equal(count(first), [executed], "count after the turn")
        for turn in others:
            expect.equal(turn, first, "the repeated turn")
        worker.seq += 1


@requirement("CLU-004")
def test_clu_004_decides_one_request_after_the_other(context: CheckContext) -> None:
    """Workers attach at all base URLs at the same moment, and more of them than the run
    may have; then two actions under one seq arrive at two of them. Expect an episode
    for each worker, no worker too many, and one action executed."""
    for here, there in pairs_of(context):
        both = (here, there)
        for _ in range(ROUNDS):
            run = context.submit("count", "count", max_workers=1)
            attach = [worker_at(run.worker(), client).try_attach for client in both]
            expect_one_of(context.call_concurrently(*attach), "worker_limit")
            run.stop()
    require_worker_limit(context, 2)
    for here, there in pairs_of(context):
        run = context.submit("count", "count", max_workers=2)
        workers = [worker_at(run.worker(), client) for client in (here, there)]
        answers = context.call_concurrently(*[worker.try_attach for worker in workers])
        turns = [expect.ok(answer) for answer in answers]
        played = {turn["episode"]["index"] for turn in turns}
        expect.equal(len(played), 2, "episodes of two workers")
        worker = workers[0]
        worker.session_id = turns[0]["session_id"]
        for _ in range(ROUNDS):
            places = [worker_at(worker, client) for client in (here, there)]
            actions = [context.action(score=score) for score in (0, 1)]
            send = [
                partial(w.try_predict, a) for w, a in zip(places, actions, strict=True)
            ]
            expect_one_of(context.call_concurrently(*send), "seq_conflict")
            worker.seq += 1


def expect_one_of(answers: list[Answer], code: str) -> None:
    """Expect one request to succeed, and the others to be refused with this code."""
    succeeded = [answer for answer in answers if answer.status == 200]
    refused = [answer for answer in answers if answer.status != 200]
    for answer in refused:
        expect.refused(answer, code)
    expect.equal(len(succeeded), 1, "requests that succeeded")


@requirement("CLU-005")
@background
def test_clu_005_extends_a_lease_at_any_base_url(context: CheckContext) -> None:
    """Two workers attach at one base URL. Then one sends heartbeats and the other one
    turns to the next URL, each when its lease is nearly over. Expect them accepted, and
    the sessions ended one lease after the last."""
    for extend in (WorkerClient.try_heartbeat, WorkerClient.try_next):
        worker, last = attach_with_lease(context)
        for client in itertools.islice(itertools.cycle(context.clients_by_url), 4):
            sleep_nearly_through(last, context)
            away = worker_at(worker, client)
            answer = extend(away)
            worker.seq = away.seq
            expect_inside_lease(answer, last, context)
            last = answer
        sleep_past(last, context)
        expect.refused(worker.try_heartbeat(), "session_ended")


@requirement("CLU-006")
@background
def test_clu_006_changes_reach_every_base_url(context: CheckContext) -> None:
    """A run is changed at one base URL, while long polls, and a reader of its events,
    wait at the next one. Expect each of them to see the change within a second."""
    wait = wait_header(context, WAIT_S)
    limit_s = LATE_S + context.tolerance_s
    for here, there in pairs_of(context):
        run = context.submit("score", "score", http_client=here)
        run_there, worker = at(run, there), run.worker()
        for change, state in ((worker.attach, "running"), (run.stop, "stopped")):
            headers = etag_of(run_there) | wait
            polled, changed_at = context.call_concurrently(
                partial(run_there.call, "get_run", headers=headers),
                partial(change_later, change),
            )
            took_s, what = polled.ended_at - changed_at, "the answer elsewhere"
            expect_changed(polled, state, took_s, limit_s, what)
        if context.offers("events"):
            with follow_run(run_there) as reader:
                reader.until(in_state("stopped"), "`run` that is stopped")
                run.resume()
                expect_change_in_time(context, reader, in_state("ready"), "ready")


@requirement("CLU-007")
def test_clu_007_events_go_on_at_another_base_url(context: CheckContext) -> None:
    """Three of four episodes are scored; after each event of one base URL a reader goes
    on at the next one. Expect each of them to receive exactly the missing episodes."""
    if not context.offers("events"):
        raise expect.NotApplicable("profile events is not announced by the server")
    scored = 3
    for here, there in pairs_of(context):
        worker = submit_and_attach(context, *["score"] * (scored + 1), http_client=here)
        run = worker.run
        for _ in range(scored):
            worker.play()
        events = read_events(run, scored)
        expect.equal(episodes_in(events), list(range(scored)), "episodes received")
        for number, id_ in enumerate(ids_of(events)[:-1], start=1):
            received = read_events(at(run, there), scored, id_)
            missing = episodes_in(events[number:])
            expect.equal(episodes_in(received), missing, "episodes received elsewhere")
