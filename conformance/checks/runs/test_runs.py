"""Submitting, reading and listing runs (RUN, LEASE-007)."""

import itertools
import time
import uuid
from collections.abc import Callable
from datetime import datetime, timedelta
from functools import partial
from itertools import islice
from typing import Any
from urllib.parse import urljoin, urlsplit

from conformance.checks.support.given_states import (
    expect_pointer,
    require_queued,
    submit_and_attach,
)
from conformance.checks.support.long_run import long_run
from conformance.checks.support.operation_samples import unknown_run_samples
from conformance.checks.support.submissions import submit
from conformance.client.check_context import CheckContext
from conformance.client.http_client import HttpClient
from conformance.exchanges.pages import read_pages
from conformance.runner.requirement import on_long_run, requirement
from conformance.verdicts import expect
from conformance.verdicts.expect import NotApplicable, SetUpFailed

_RUNS_READ = 300
_PAGES_READ = 300
_LONG_PAGE = 60
_LONGEST_PAGE = 1000
_LONGEST_PAGES_READ = 3  # an account may have any number of runs
_QUEUE_S = 0.4
_LONG_QUEUE_S = 10
_SAME_TIME = timedelta(seconds=1)


@requirement("RUN-001")
def test_run_001_submit_returns_the_location(context: CheckContext) -> None:
    """A run is submitted and read at the Location; again with a query that the
    operation does not list, unless it is refused (OPT-001). Expect 201, then the run.
    """
    body = context.submit_body()
    plain = submit(context, body)
    with_query = context.call("submit_run", json=body, params={"of": "kit/1"})
    expect.ok(plain, 201)
    for answer in (plain, with_query)[: 1 + (with_query.status == 201)]:
        run = context.adopt(answer.json)
        location = answer.headers.get("location", "")
        expect.true(location, "a Location header", "none")
        url = urljoin(f"{context.http_client.base_url}/v1/runs", location)
        shown = expect.ok(context.http_client.request("GET", url))
        expect.equal(shown["run_id"], run.id, "run_id")


@requirement("RUN-002")
def test_run_002_begins_queued_or_ready(context: CheckContext) -> None:
    """Runs are submitted with and without time in the queue. Expect queued or ready."""
    for options in ({}, {"queue_s": 10}) if context.offers("control") else ({},):
        run = expect.ok(submit(context, context.submit_body(options=options)), 201)
        is_new = run["state"] in {"queued", "ready"}
        expect.true(is_new, "queued or ready", run["state"])


@requirement("RUN-006")
def test_run_006_cannot_submit_for_an_unknown_benchmark(context: CheckContext) -> None:
    """An unknown benchmark. Expect `invalid_request` at `/benchmark_id`."""
    answer = submit(context, context.submit_body(benchmark_id="no_such_benchmark"))
    expect.refused(answer, "invalid_request", pointer="/benchmark_id")
    expect.ok(submit(context, context.submit_body()), 201)


@requirement("RUN-007")
def test_run_007_cannot_set_options_of_another_benchmark(context: CheckContext) -> None:
    """Options are sent for a benchmark with a fixed manifest. Expect `invalid_request`
    at `/options`, and a run without them."""
    read = partial(context.call, "list_benchmarks")
    listed = context.require(read, 200, "list_benchmarks")
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
    """A run waits in the queue, another one again, with an episode scored, after a
    resume, and others are in later states. Expect a number from 1, then null."""
    began_at = time.monotonic()
    queued = context.submit(wait_ready=False, queue_s=_LONG_QUEUE_S)
    require_queued(queued.body["state"], began_at, _LONG_QUEUE_S)
    queue_s = context.choose_queue_s(_QUEUE_S)
    worker = submit_and_attach(context, "score", "score", queue_s=queue_s)
    again = worker.run
    worker.play()
    again.stop()
    resumed_at = time.monotonic()
    resumed = expect.ok(again.call("resume_run"))
    require_queued(resumed["state"], resumed_at, queue_s)
    read = expect.ok(queued.call("get_run"))
    require_queued(read["state"], began_at, _LONG_QUEUE_S)
    for body in (queued.body, read, resumed):
        position = body["queue_position"]
        is_from_1 = isinstance(position, int) and position >= 1
        expect.true(is_from_1, "a queue_position from 1", position)
    run = context.submit("score")
    for step in (run.get, run.worker().attach, run.get, run.stop, queued.stop):
        step()


def expect_last_run_on_a_page(context: CheckContext, account: HttpClient) -> None:
    """Expect a page that leaves one run of an account to name the next page, and one
    without a run to name none."""

    def read(params: dict[str, Any]) -> Any:
        return expect.ok(context.call("list_runs", params=params, http_client=account))

    pages = islice(read_pages(read, limit=_LONGEST_PAGE), 1 + _LONGEST_PAGES_READ)
    whole = next(pages)
    for page in pages:
        if not page["runs"]:
            expect.equal(page["next_cursor"], None, "`next_cursor` of an empty page")
    limit = len(whole["runs"]) - 1
    if whole["next_cursor"] is not None or limit < 1:
        return
    pages = islice(read_pages(read, limit=limit), 2)
    shown = [run for page in pages for run in page["runs"]]
    # One page may show all of them: other checks delete runs meanwhile.
    last = whole["runs"][-1]["run_id"]
    if context.call("get_run", run_id=last, http_client=account).status != 404:
        expect.true(last in [run["run_id"] for run in shown], "the last run", shown)


def _read_while_adding(context: CheckContext, ids: set[str]) -> list[dict[str, Any]]:
    """Read pages of five until all the ids were there, or the end; a run is submitted
    and stopped before each page but the first."""
    seen: list[dict[str, Any]] = []

    def read(params: dict[str, Any]) -> Any:
        if "cursor" in params:
            context.submit(wait_ready=False).stop()
        return expect.ok(context.call("list_runs", params=params))

    for page in islice(read_pages(read, limit=5), _PAGES_READ):
        seen += page["runs"]
        if ids <= {run["run_id"] for run in seen} or len(seen) > _RUNS_READ:
            break
    return seen


@requirement("RUN-009")
def test_run_009_pages_show_each_run_once_newest_first(context: CheckContext) -> None:
    """Twelve runs are submitted, between the first six others by another account if
    there is a token of one, and some of them stopped; pages of five are read while more
    runs are submitted and stopped. Then there are many, and two long pages are read.
    Expect the twelve in reverse order, no run twice or left out, and the newest first
    everywhere."""
    is_given = context.shared.settings.token_2 is not None
    second_account = context.second_account if is_given else None
    ids = []
    for number in range(12):
        ids.append(context.submit(wait_ready=False).id)
        if second_account is not None and number < 6:
            submit(context, context.submit_body(), http_client=second_account)
    for number in (0, 6):
        context.require(
            partial(context.call, "stop_run", run_id=ids[number], json={}), 200, "stop"
        )
    listed = _read_while_adding(context, set(ids))
    listed_ids = [run["run_id"] for run in listed]
    shown = [id_ for id_ in listed_ids if id_ in ids]
    expect.equal(shown, ids[::-1], "the twelve runs")
    expect.equal(len(set(listed_ids)), len(listed_ids), "runs that are listed once")
    page = expect.ok(context.call("list_runs", params={"limit": _RUNS_READ}))
    for runs in (listed, page["runs"]):
        times = [datetime.fromisoformat(run["created_at"]) for run in runs]
        for newer, older in itertools.pairwise(times):
            # Runs that are submitted at the same time may come in either order.
            is_sorted = older - newer <= _SAME_TIME
            expect.true(is_sorted, f"a run not newer than {newer}", f"{older}")
    expect_last_run_on_a_page(context, second_account or context.http_client)
    if not context.shared.settings.quick:
        expect_long_pages_without_a_gap(context)


def expect_long_pages_without_a_gap(context: CheckContext) -> None:
    """Expect two long pages to show all runs between their first and their last."""
    for _ in range(_LONG_PAGE + 2):
        context.submit(wait_ready=False).stop()
    params: dict[str, Any] = {"limit": _LONG_PAGE}
    page = expect.ok(context.call("list_runs", params=params))
    shown = [run["run_id"] for run in page["runs"]]
    expect.true(page["next_cursor"], "another page behind a long one", page)
    params["cursor"] = page["next_cursor"]
    following = expect.ok(context.call("list_runs", params=params))
    shown += [run["run_id"] for run in following["runs"]]
    # Others may submit runs meanwhile, before these, and delete some of them.
    whole = expect.ok(context.call("list_runs", params={"limit": _LONGEST_PAGE}))
    listed = [run["run_id"] for run in whole["runs"]]
    places = [listed.index(id_) for id_ in shown if id_ in listed]
    between = listed[places[0] : places[-1] + 1]
    missing = [id_ for id_ in between if id_ not in shown]
    expect.equal(missing, [], f"runs that pages of {_LONG_PAGE} leave out")


@on_long_run
@requirement("RUN-025")
def test_run_025_page_is_no_longer_than_its_limit(context: CheckContext) -> None:
    """The runs, and the episodes of a run with a hundred and eighty, are listed without
    a limit, and with limits from one to the largest. Expect no page that is longer than
    its limit, or than a hundred."""
    run = long_run(context).run
    calls = {
        "episodes": partial(run.call, "list_episodes"),
        "runs": partial(context.call, "list_runs"),
    }
    for limit in (None, 1, 2, 11, 99, 100, 101, 1000):
        params = {} if limit is None else {"limit": limit}
        for name, call in calls.items():
            if name == "runs" and (limit or 0) > _RUNS_READ:
                continue  # many, and no shorter list proves anything
            expect.ok(call(params=params))


@requirement("RUN-010")
def test_run_010_cannot_use_an_unknown_run(context: CheckContext) -> None:
    """An unknown id in the path of every operation, also with conditions, then the id
    of a run. Expect `not_found` at once, then the run."""
    run = context.submit(wait_ready=False)
    unknown = uuid.uuid4().hex
    conditions: list[dict[str, str]] = [{}, {"If-None-Match": "*"}]
    conditions.append({"If-None-Match": "*", "Prefer": "wait=9999"})
    for headers in conditions:
        answer = context.call("get_run", run_id=unknown, headers=headers)
        expect.refused(answer, "not_found")
    worker = run.worker()
    worker.session_id = worker.attach_key = "none"
    for operation_id, how in unknown_run_samples(worker):
        expect.refused(run.call(operation_id, **how), "not_found")
    expect.equal(expect.ok(run.call("get_run"))["run_id"], run.id, "run_id")


@requirement("RUN-014")
def test_run_014_progress_adds_up(context: CheckContext) -> None:
    """Three episodes are played, started, returned and aborted. Expect scored + in
    progress + pending = 3 at every point."""
    run = context.submit("score", "score", "score")
    worker = run.worker()
    steps: list[Callable[[], Any]] = [run.get, worker.attach, worker.play]
    if context.offers("sessions"):
        steps += [worker.detach, worker.attach]
    for step in (*steps, run.stop):
        step()
        run.get()


@requirement("RUN-015")
def test_run_015_cannot_ask_for_too_many_workers(context: CheckContext) -> None:
    """One worker more than the limit, then the limit. Expect `invalid_request` at
    `/max_workers`, then a run."""
    limit = context.limits["max_workers"]
    beyond = submit(context, context.submit_body(max_workers=limit + 1))
    expect.refused(beyond, "invalid_request", pointer="/max_workers")
    run = expect.ok(submit(context, context.submit_body(max_workers=limit)), 201)
    expect.equal(run["max_workers"], limit, "max_workers")


@requirement("RUN-016")
def test_run_016_endpoint_serves_the_data_plane(context: CheckContext) -> None:
    """A worker uses only the endpoint of its run. Expect every data-plane operation
    under it."""
    run = context.submit("count")
    parts = urlsplit(run.body["endpoint"])
    is_url = bool(parts.scheme) and bool(parts.netloc)
    expect.true(is_url, "a URL that a path extends", run.body["endpoint"])
    worker = run.worker()
    worker.session_id = expect.ok(worker.try_attach())["session_id"]
    expect.ok(worker.try_predict(context.action()))
    if context.offers("sessions"):
        expect.ok(worker.try_heartbeat())
        expect.ok(worker.try_detach(), 204)


@requirement("RUN-033")
def test_run_033_paths_can_be_appended_to_the_endpoint(context: CheckContext) -> None:
    """A run is submitted and read. Expect an absolute URL as `endpoint`, without a
    final slash."""
    run = context.submit("score")
    for shown in (run.body, expect.ok(run.call("get_run"))):
        endpoint = shown["endpoint"]
        parts = urlsplit(endpoint)
        is_absolute = parts.scheme in {"http", "https"} and bool(parts.netloc)
        expect.true(is_absolute, "an absolute http or https URL", endpoint)
        can_be_extended = not (endpoint.endswith("/") or set(endpoint) & set("?#"))
        expect.true(can_be_extended, "no final slash, query or fragment", endpoint)


@requirement("RUN-017")
def test_run_017_cannot_choose_other_images(context: CheckContext) -> None:
    """Sizes that are not offered, the width of one with the height of another among
    them, every codec that is not, then offered ones. Expect `invalid_request` pointing
    into `/images`, then a run that records it."""
    sizes, codecs = context.benchmark["image_sizes"], context.benchmark["image_codecs"]
    offered = {"codec": codecs[0], **sizes[-1]}
    wrong = [offered | {"width": offered["width"] + 1}]
    wrong += [offered | {"height": offered["height"] + 1}]
    for first, second in itertools.permutations(sizes, 2):
        mixed = {"width": first["width"], "height": second["height"]}
        if mixed not in sizes:
            wrong.append(offered | mixed)
    codec_names = context.spec.schema("ImageCodec")["x-extensible-enum"]
    wrong += [
        offered | {"codec": codec} for codec in codec_names if codec not in codecs
    ]
    for images in wrong:
        answer = submit(context, context.submit_body(images=images))
        expect_pointer(expect.refused(answer, "invalid_request"), "/images")
    run = expect.ok(submit(context, context.submit_body(images=offered)), 201)
    expect.equal(run["images"], offered, "images")


@requirement("LEASE-007")
def test_lease_007_cannot_ask_for_a_lease_out_of_range(context: CheckContext) -> None:
    """Leases outside both ends of the announced range, then the ends themselves. Expect
    `invalid_request` at `/idle_timeout_s`, then runs."""
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


@requirement("RUN-032")
def test_run_032_cannot_push_where_it_is_not_offered(context: CheckContext) -> None:
    """Mode `push`, a policy server, and both, where the profile is not announced.
    Expect `invalid_request`; without them a run."""
    if context.offers("push"):
        raise NotApplicable("server offers the profile push")
    server = {"url": "http://policy.example/v1", "protocol": "proctor"}
    members: list[dict[str, Any]] = [{"mode": "push"}, {"policy_server": server}]
    for wrong in [*members, members[0] | members[1]]:
        expect.refused(submit(context, context.submit_body(**wrong)), "invalid_request")
    expect.ok(submit(context, context.submit_body()), 201)
