"""Submitting, reading and listing runs (RUN, LEASE-007)."""

import time
import uuid
from collections.abc import Callable
from functools import partial
from typing import Any
from urllib.parse import urljoin, urlsplit

from conformance.checks.support.given_states import expect_pointer
from conformance.checks.support.submissions import submit
from conformance.client.check_context import CheckContext
from conformance.client.run_client import RunClient
from conformance.runner.requirement import background, requirement
from conformance.verdicts import expect
from conformance.verdicts.expect import NotApplicable, SetUpFailed

_CHANGE_AFTER_S = 0.4
_LATE_S = 1.0
# Timers of the server and of this machine may disagree by so much.
_EARLY_S = 0.02


def uniquely_named_body(context: CheckContext) -> dict[str, Any]:
    """Give a body whose policy has a name that no other run has."""
    return context.submit_body(policy={"name": f"conformance kit {uuid.uuid4()}"})


def runs_of(context: CheckContext, body: dict[str, Any]) -> list[str]:
    """Find the runs of a body, by the name of its policy."""
    page = context.require(
        lambda: context.call("list_runs", params={"limit": 100}), 200, "list_runs"
    )
    return [r["run_id"] for r in page["runs"] if r["policy"] == body["policy"]]


@requirement("RUN-001")
def test_run_001_submit_returns_the_location(context: CheckContext) -> None:
    """A run is submitted and read at the Location. Expect 201, then the run."""
    answer = submit(context, context.submit_body())
    run = expect.ok(answer, 201)
    location = answer.headers.get("location", "")
    expect.true(location, "a Location header", "none")
    url = urljoin(f"{context.http_client.base_url}/v1/runs", location)
    expect.equal(
        expect.ok(context.http_client.request("GET", url))["run_id"],
        run["run_id"],
        "run_id",
    )


@requirement("RUN-002")
def test_run_002_begins_queued_or_ready(context: CheckContext) -> None:
    """Runs are submitted with and without time in the queue. Expect queued or ready."""
    for options in ({}, {"queue_s": 10}):
        run = expect.ok(submit(context, context.submit_body(options=options)), 201)
        expect.true(
            run["state"] in {"queued", "ready"}, "queued or ready", run["state"]
        )


@requirement("RUN-003")
def test_run_003_can_repeat_submit_with_the_same_key(context: CheckContext) -> None:
    """The response was lost: the same key and body again, also concurrently.

    Expect the first run each time, and no other run.
    """
    body, key = uniquely_named_body(context), {"Idempotency-Key": uuid.uuid4().hex}
    first = expect.ok(submit(context, body, headers=key), 201)
    for answer in context.call_concurrently(
        *[lambda: submit(context, body, headers=key)] * 3
    ):
        expect.equal(expect.ok(answer, 201)["run_id"], first["run_id"], "run_id")
    expect.equal(runs_of(context, body), [first["run_id"]], "the runs made of it")
    race, new = uniquely_named_body(context), {"Idempotency-Key": uuid.uuid4().hex}
    answers = context.call_concurrently(
        *[lambda: submit(context, race, headers=new)] * 4
    )
    ids = {expect.ok(answer, 201)["run_id"] for answer in answers}
    expect.equal(len(ids), 1, "runs returned to four submits at the same time")
    expect.equal(len(runs_of(context, race)), 1, "runs made of them")


@requirement("RUN-004")
def test_run_004_cannot_use_a_key_for_another_body(context: CheckContext) -> None:
    """A used key is sent with another body, then a new key with that body.

    Expect `idempotency_conflict` and no run, then a run.
    """
    key = {"Idempotency-Key": uuid.uuid4().hex}
    expect.ok(submit(context, uniquely_named_body(context), headers=key), 201)
    other = uniquely_named_body(context)
    refused = submit(context, other, headers=key)
    expect.refused(refused, "idempotency_conflict")
    expect.equal(runs_of(context, other), [], "the runs made of it")
    new = {"Idempotency-Key": uuid.uuid4().hex}
    expect.ok(submit(context, other, headers=new), 201)


@requirement("RUN-005")
def test_run_005_key_of_another_account_has_no_effect(context: CheckContext) -> None:
    """Two accounts use the same key, with different bodies and with the same body.

    Expect runs of its own for each account.
    """
    second_account = context.second_account
    ids = []
    for second in (uniquely_named_body(context), None):
        key, first = {"Idempotency-Key": uuid.uuid4().hex}, uniquely_named_body(context)
        for body, http_client in (
            (first, context.http_client),
            (second or first, second_account),
        ):
            run = expect.ok(
                submit(context, body, headers=key, http_client=http_client), 201
            )
            expect.equal(run["policy"], body["policy"], "policy")
            ids.append(run["run_id"])
    expect.equal(len(set(ids)), len(ids), "different runs")


@requirement("RUN-006")
def test_run_006_cannot_submit_for_an_unknown_benchmark(context: CheckContext) -> None:
    """An unknown benchmark. Expect `invalid_request` at `/benchmark_id`."""
    answer = submit(context, context.submit_body(benchmark_id="no_such_benchmark"))
    expect.refused(answer, "invalid_request", pointer="/benchmark_id")
    expect.ok(submit(context, context.submit_body()), 201)


@requirement("RUN-007")
def test_run_007_cannot_set_options_of_another_benchmark(context: CheckContext) -> None:
    """Options are sent for a benchmark with a fixed manifest.

    Expect `invalid_request` at `/options`, and a run without them.
    """
    listed = context.require(
        lambda: context.call("list_benchmarks"), 200, "list_benchmarks"
    )
    ids = [benchmark["benchmark_id"] for benchmark in listed["benchmarks"]]
    others = [benchmark_id for benchmark_id in ids if benchmark_id != "calibration"]
    if not others:
        raise NotApplicable("server offers no other benchmark than `calibration`")
    for benchmark_id in others:
        body = context.submit_body(benchmark_id=benchmark_id)
        if submit(context, body).status == 201:
            answer = submit(context, body | {"options": {"max_steps": 5}})
            expect.refused(answer, "invalid_request", pointer="/options")
            return
    raise SetUpFailed(f"none of {others} can be submitted now", allowed=True)


@requirement("RUN-008")
def test_run_008_only_a_queued_run_has_a_queue_position(context: CheckContext) -> None:
    """A run waits in the queue, and others are in later states.

    Expect a number from 1, then null.
    """
    queued = context.submit(wait_ready=False, queue_s=10)
    if queued.body["state"] != "queued":
        raise SetUpFailed(f"run state is {queued.body['state']} despite queue_s 10")
    for body in (queued.body, expect.ok(queued.call("get_run"))):
        position = body["queue_position"]
        is_from_1 = isinstance(position, int) and position >= 1
        expect.true(is_from_1, "a queue_position from 1", position)
    run = context.submit("score")
    expect.equal(run.get()["queue_position"], None, "queue_position when ready")
    run.worker().attach()
    expect.equal(run.get()["queue_position"], None, "queue_position when running")
    expect.equal(run.stop()["queue_position"], None, "queue_position when stopped")


@requirement("RUN-009")
def test_run_009_pages_show_each_run_once_newest_first(context: CheckContext) -> None:
    """Five runs are submitted; pages of two are read while more runs are submitted.

    Expect the five in reverse order, and no run twice.
    """
    ids = [context.submit(wait_ready=False).id for _ in range(5)]
    seen: list[str] = []
    params: dict[str, Any] = {"limit": 2}
    while not set(ids) <= set(seen):
        page = expect.ok(context.call("list_runs", params=params))
        expect.true(len(page["runs"]) <= 2, "at most 2 runs on a page of 2")
        seen += [run["run_id"] for run in page["runs"]]
        if page["next_cursor"] is None or len(seen) > 500:
            break
        params["cursor"] = page["next_cursor"]
        context.submit(wait_ready=False)
    expect.equal([i for i in seen if i in ids], ids[::-1], "the five runs")
    expect.equal(len(set(seen)), len(seen), "runs that are listed once")


@requirement("RUN-010")
def test_run_010_cannot_get_an_unknown_run(context: CheckContext) -> None:
    """An unknown id, then the id of a run. Expect `not_found`, then the run."""
    run = context.submit()
    unknown = uuid.uuid4().hex
    expect.refused(context.call("get_run", run_id=unknown), "not_found")
    expect.equal(expect.ok(run.call("get_run"))["run_id"], run.id, "run_id")


def etag_of(run: RunClient) -> dict[str, str]:
    """Read the run and give the header for a conditional read."""
    answer = run.call("get_run")
    etag = answer.headers.get("etag")
    if answer.status != 200 or etag is None:
        raise SetUpFailed(f"`get_run` gives no ETag: {expect.describe_answer(answer)}")
    return {"If-None-Match": etag}


@requirement("RUN-011")
def test_run_011_unchanged_run_is_not_sent_again(context: CheckContext) -> None:
    """A run is read again with its ETag, before and after a change.

    Expect 304 without a body, then 200 with another ETag.
    """
    run = context.submit()
    known = etag_of(run)
    answer = run.call("get_run", headers=known)
    expect.ok(answer, 304)
    expect.equal(answer.body, b"", "the body of a 304")
    run.stop()
    changed = run.call("get_run", headers=known)
    expect.equal(expect.ok(changed)["state"], "stopped", "state")
    etag = changed.headers.get("etag")
    expect.true(etag not in (None, known["If-None-Match"]), "another ETag", etag)


def wait_header(context: CheckContext, wait_s: int) -> dict[str, str]:
    """Give the header of a long-poll."""
    if context.limits["wait_s_max"] < wait_s:
        raise NotApplicable(f"server does not grant a wait of {wait_s} s")
    return {"Prefer": f"wait={wait_s}"}


def change_later(change: Callable[[], Any]) -> float:
    """Make a change after a delay, and give its time."""
    time.sleep(_CHANGE_AFTER_S)
    change()
    return time.monotonic()


@background
@requirement("RUN-012")
def test_run_012_long_poll_ends_when_the_run_changes(context: CheckContext) -> None:
    """Two long-polls wait for changes; one run gets a worker, the other is stopped.

    Expect both to return at once with the new state.
    """
    wait = wait_header(context, 5)
    attached, stopped = context.submit(), context.submit()
    worker = attached.worker()
    changes = ((attached, "running", worker.attach), (stopped, "stopped", stopped.stop))
    for run, state, change in changes:
        headers = etag_of(run) | wait
        polled, changed_at = context.call_concurrently(
            partial(run.call, "get_run", headers=headers), partial(change_later, change)
        )
        expect.equal(expect.ok(polled)["state"], state, "state")
        limit_s = _LATE_S + context.tolerance_s
        expect.in_time(polled.ended_at - changed_at, limit_s, "the answer to a change")


@background
@requirement("RUN-013")
def test_run_013_long_poll_ends_with_304_after_its_time(context: CheckContext) -> None:
    """The run does not change for two seconds. Expect 304 then, and not before."""
    wait = wait_header(context, 2)
    run = context.submit()
    answer = run.call("get_run", headers=etag_of(run) | wait)
    expect.ok(answer, 304)
    took = f"after {answer.elapsed_s:.2f} s"
    expect.true(answer.elapsed_s >= 2 - _EARLY_S, "304 after 2 s, not before", took)
    limit_s = 2 + _LATE_S + context.tolerance_s
    expect.in_time(answer.elapsed_s, limit_s, "304 after 2 s")


@requirement("RUN-014")
def test_run_014_progress_adds_up(context: CheckContext) -> None:
    """Three episodes are played, started, returned and aborted.

    Expect scored + in progress + pending = 3 at every point.
    """
    run = context.submit("score", "score", "score")
    worker = run.worker()
    steps: list[Callable[[], Any]] = [run.get, worker.attach, worker.play]
    steps += [worker.detach, worker.attach, run.stop]
    for step in steps:
        step()
        progress = expect.ok(run.call("get_run"))["progress"]
        parts = ("episodes_scored", "episodes_in_progress", "episodes_pending")
        expect.equal(progress["episodes_total"], 3, "episodes_total")
        expect.equal(sum(progress[part] for part in parts), 3, f"the sum of {progress}")


@requirement("RUN-015")
def test_run_015_cannot_ask_for_more_workers_than_allowed(
    context: CheckContext,
) -> None:
    """One worker more than the limit, then the limit.

    Expect `invalid_request` at `/max_workers`, then a run.
    """
    limit = context.limits["max_workers"]
    beyond = submit(context, context.submit_body(max_workers=limit + 1))
    expect.refused(beyond, "invalid_request", pointer="/max_workers")
    run = expect.ok(submit(context, context.submit_body(max_workers=limit)), 201)
    expect.equal(run["max_workers"], limit, "max_workers")


@requirement("RUN-016")
def test_run_016_endpoint_serves_the_data_plane(context: CheckContext) -> None:
    """A worker uses only the endpoint of its run.

    Expect an absolute URL, and every data-plane operation under it.
    """
    run = context.submit("count")
    parts = urlsplit(run.body["endpoint"])
    is_absolute = parts.scheme in {"http", "https"} and bool(parts.netloc)
    expect.true(is_absolute, "an absolute http or https URL", run.body["endpoint"])
    worker = run.worker()
    turn = expect.ok(worker.try_attach())
    worker.session_id = turn["session_id"]
    expect.ok(worker.try_predict(context.action()))
    expect.ok(worker.try_heartbeat())
    expect.ok(worker.try_detach(), 204)


@requirement("RUN-017")
def test_run_017_cannot_choose_images_that_are_not_offered(
    context: CheckContext,
) -> None:
    """A size that is not offered, every codec that is not, then offered ones.

    Expect `invalid_request` pointing into `/images`, then a run that records it.
    """
    sizes, codecs = context.benchmark["image_sizes"], context.benchmark["image_codecs"]
    offered = {"codec": codecs[0], **sizes[-1]}
    wrong = [offered | {"width": offered["width"] + 1}]
    wrong += [offered | {"height": offered["height"] + 1}]
    known = context.spec.schema("ImageCodec")["x-extensible-enum"]
    wrong += [offered | {"codec": codec} for codec in known if codec not in codecs]
    for images in wrong:
        answer = submit(context, context.submit_body(images=images))
        expect_pointer(expect.refused(answer, "invalid_request"), "/images")
    run = expect.ok(submit(context, context.submit_body(images=offered)), 201)
    expect.equal(run["images"], offered, "images")


@requirement("LEASE-007")
def test_lease_007_cannot_ask_for_a_lease_out_of_range(context: CheckContext) -> None:
    """Leases outside both ends of the announced range, then the ends themselves.

    Expect `invalid_request` at `/idle_timeout_s`, then runs.
    """
    low, high = (
        context.limits["idle_timeout_s_min"],
        context.limits["idle_timeout_s_max"],
    )
    for lease_s in (low / 2, high + 1):
        answer = submit(context, context.submit_body(idle_timeout_s=lease_s))
        expect.refused(answer, "invalid_request", pointer="/idle_timeout_s")
    for lease_s in (low, high):
        run = expect.ok(
            submit(context, context.submit_body(idle_timeout_s=lease_s)), 201
        )
        expect.equal(run["idle_timeout_s"], lease_s, "idle_timeout_s")
