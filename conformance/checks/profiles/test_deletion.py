"""Deleting runs: which may be, what is left, and what stays counted (DEL)."""

import uuid
from typing import Any

from conformance.checks.support.given_states import submit_and_attach
from conformance.checks.support.published_runs import require_entry
from conformance.checks.support.submissions import submit
from conformance.client.check_context import CheckContext
from conformance.client.http_client import HttpClient
from conformance.client.run_client import RunClient, adopt_run
from conformance.exchanges.answer import Answer
from conformance.runner.requirement import requirement
from conformance.verdicts import expect
from conformance.verdicts.expect import NotApplicable, SetUpFailed

NEWEST_RUNS = 1000
UNPLAYED_RUNS = 3
TRIES = 3


def delete(run: RunClient) -> Answer:
    return run.call("delete_run")


def play_one_action(
    context: CheckContext, http_client: HttpClient | None = None
) -> RunClient:
    """Give a run in which one action was executed, and which no worker plays."""
    worker = submit_and_attach(context, "score", http_client=http_client)
    worker.predict(context.action())
    worker.detach()
    worker.run.until("ready")
    return worker.run


def newest_runs(
    context: CheckContext, http_client: HttpClient | None = None
) -> list[dict[str, Any]]:
    """Give the page of `list_runs` with the newest runs of the account."""
    params = {"limit": NEWEST_RUNS}
    page = context.require(
        lambda: context.call("list_runs", params=params, http_client=http_client),
        200,
        "list_runs",
    )
    runs: list[dict[str, Any]] = page["runs"]
    return runs


def expect_unknown(run: RunClient, operation_id: str, **how: Any) -> None:
    """Expect `not_found`; until a deletion, the same request succeeded."""
    expect.refused(run.call(operation_id, **how), "not_found")


@requirement("DEL-001")
def test_del_001_can_delete_what_was_never_played(context: CheckContext) -> None:
    """Runs that are queued, ready, stopped, and attached to without an action. Expect
    204 for each."""
    queued = context.submit("score", wait_ready=False, queue_s=10.0)
    ready, stopped, left = (context.submit("score") for _ in range(3))
    stopped.stop()
    worker = left.worker()
    worker.attach()
    worker.detach()
    left.until("ready")
    for run in (queued, ready, stopped, left):
        expect.ok(delete(run), 204)


@requirement("DEL-002")
def test_del_002_cannot_delete_a_run_in_play(context: CheckContext) -> None:
    """A run with a worker that has not played, then one that is stopping. Expect
    `illegal_transition` and an unchanged run, the worker included; 204 for the first
    one when it is stopped."""
    worker = submit_and_attach(context, "score", "score")
    before = worker.run.snapshot()
    expect.refused(delete(worker.run), "illegal_transition")
    expect.equal(worker.run.snapshot(), before, "the running run")
    draining = submit_and_attach(context, "count", "score")
    draining.predict(context.action())
    draining.run.stop("drain")
    before = draining.run.snapshot()
    expect.refused(delete(draining.run), "illegal_transition")
    expect.equal(draining.run.snapshot(), before, "the stopping run")
    expect.ok(draining.try_predict(context.action()))
    worker.run.stop()
    expect.ok(delete(worker.run), 204)


@requirement("DEL-003")
def test_del_003_what_was_played_is_deleted_or_stays(context: CheckContext) -> None:
    """Runs in which an action was executed: ready, stopped, and completed. Expect 204
    and no run any more, or `not_deletable` and an unchanged run."""
    ready, stopped = (play_one_action(context) for _ in range(2))
    stopped.stop()
    worker = submit_and_attach(context, "score")
    worker.play()
    for run in (ready, stopped, worker.run):
        before = run.snapshot()
        answer = delete(run)
        if answer.status == 204:
            expect_unknown(run, "get_run")
        else:
            expect.refused(answer, "not_deletable")
            state = before["get_run"]["state"]
            expect.equal(run.snapshot(), before, f"the {state} run")


@requirement("DEL-008")
def test_del_008_a_run_on_the_leaderboard_stays(context: CheckContext) -> None:
    """A completed run is published, deleted, and deleted once its entry is withdrawn.
    Expect `not_deletable` and an unchanged run and entry, then what DEL-003 allows."""
    if not context.offers("board"):
        raise NotApplicable("the server has no leaderboard: the profile `board`")
    worker = submit_and_attach(context, "score")
    worker.play()
    run = worker.run
    run.until("completed")
    entry_id = require_entry(run)["entry_id"]
    before = run.snapshot()
    expect.refused(delete(run), "not_deletable")
    expect.equal(run.snapshot(), before, "the published run")
    expect.ok(context.call("get_entry", entry_id=entry_id))
    context.require(lambda: run.call("withdraw_entry"), 200, "withdraw_entry")
    answer = delete(run)
    if answer.status != 204:
        expect.refused(answer, "not_deletable")


@requirement("DEL-004")
def test_del_004_a_deleted_run_is_unknown(context: CheckContext) -> None:
    """A run is deleted between two others. Expect `not_found` from every operation on
    it, a list with the others alone, and both of them as they were."""
    older, run, newer = (context.submit("score") for _ in range(3))
    worker = run.worker()
    others = [older.snapshot(), newer.snapshot()]
    expect.ok(delete(run), 204)
    for operation_id in ("get_run", "list_episodes", "get_score", "delete_run"):
        expect_unknown(run, operation_id)
    expect_unknown(run, "stop_run", json={"mode": "abort"})
    expect_unknown(run, "resume_run")
    expect.refused(worker.try_attach(), "not_found")
    if context.offers("events"):
        expect_unknown(run, "stream_events")
    if context.offers("record"):
        expect_unknown(run, "fetch_record")
        expect_unknown(run, "fetch_recording", episode_id="e0000")
    if context.offers("compare"):
        for pair in ((run.id, older.id), (older.id, run.id)):
            params = dict(zip(("baseline", "runs"), pair, strict=True))
            expect_unknown(older, "compare_runs", params=params)
    listed = [run_body["run_id"] for run_body in newest_runs(context)]
    shown = [run_id for run_id in listed if run_id in (older.id, run.id, newer.id)]
    expect.equal(shown, [newer.id, older.id], "those of the three that are listed")
    expect.equal([older.snapshot(), newer.snapshot()], others, "the other runs")


@requirement("DEL-005")
def test_del_005_the_key_of_a_deleted_run_stays_used(context: CheckContext) -> None:
    """The submission of a deleted run is repeated with its Idempotency-Key, twice.
    Expect `not_found` and no run; the run of a key whose run was not deleted."""
    names = [f"deleted-{uuid.uuid4().hex}" for _ in range(2)]
    bodies = [context.submit_body(policy={"name": name}) for name in names]
    keys = [{"Idempotency-Key": uuid.uuid4().hex} for _ in range(2)]
    runs = []
    for body, headers in zip(bodies, keys, strict=True):
        accepted = submit(context, body, headers=headers)
        if accepted.status != 201:
            raise SetUpFailed("no run could be submitted")
        runs.append(adopt_run(context, accepted.json))
    expect.ok(delete(runs[0]), 204)
    for _ in range(2):
        expect.refused(submit(context, bodies[0], headers=keys[0]), "not_found")
    again = expect.ok(submit(context, bodies[1], headers=keys[1]), 201)
    expect.equal(again["run_id"], runs[1].id, "run_id of the other key")
    listed = [run_body["policy"]["name"] for run_body in newest_runs(context)]
    expect.equal([n for n in listed if n in names], names[1:], "policies with a run")


def count_of(run: RunClient) -> int:
    """Give `runs_played_before` of a run that was played."""
    shown = run.get()
    count = shown.get("runs_played_before")
    expect.true(isinstance(count, int), "`runs_played_before` of a played run", shown)
    return int(str(count))


def expect_own_runs_counted(context: CheckContext) -> None:
    """Expect the runs of one account not to count for another one."""
    second_account = context.second_account
    for last_try in (number == TRIES - 1 for number in range(TRIES)):
        before = count_of(play_one_action(context, second_account))
        play_one_action(context)
        after = count_of(play_one_action(context, second_account))
        listed = newest_runs(context, second_account)
        shown = {run.get("runs_played_before") for run in listed}
        missing = set(range(before + 1, after)) - shown
        if not missing:
            return
        what = "each number is that of a run of the account"
        expect.true(not last_try, what, missing)


@requirement("DEL-006")
def test_del_006_what_was_played_stays_counted(context: CheckContext) -> None:
    """A run is played and deleted, some are not played, then another one is played;
    with a token of another account, one of that is played between two others. Expect no
    `runs_played_before` of what was not played; a number that grows with each run that
    was, the same in every view, and none that no run of the account has."""
    for last_try in (number == TRIES - 1 for number in range(TRIES)):
        first = play_one_action(context)
        count = count_of(first)
        delete(first)
        unplayed = [context.submit("score") for _ in range(UNPLAYED_RUNS)]
        second, third = play_one_action(context), play_one_action(context)
        counts = [count, count_of(second), count_of(third)]
        expect.true(counts == sorted(set(counts)), "a number that grows", counts)
        listed = newest_runs(context)
        shown = {run["run_id"]: run.get("runs_played_before") for run in listed}
        for run in unplayed:
            expect.true("runs_played_before" not in run.get(), "none", run.body)
            expect.equal(shown.get(run.id), None, "of a listed run that is not played")
        expect.equal(shown.get(third.id, counts[2]), counts[2], "in list_runs")
        missing = set(range(counts[0] + 1, counts[2])) - set(shown.values())
        if not missing:  # another check may have deleted what it had played
            break
        expect.true(not last_try, "each number is that of a run", missing)
    if context.shared.settings.token_2 is not None:
        expect_own_runs_counted(context)
