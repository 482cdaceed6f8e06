"""Parameters of paths and queries, and headers (ERR)."""

import math
import uuid
from collections.abc import Iterator
from typing import Any

from conformance.checks.support.generated.schema_requests import (
    expect_wrong_values_refused,
)
from conformance.checks.support.given_states import count
from conformance.checks.support.operation_samples import (
    OperationSample,
    attach_live_worker,
    operation_samples,
)
from conformance.checks.support.submissions import (
    adopt_answer,
    runs_of,
    submit,
    uniquely_named_body,
)
from conformance.client.check_context import CheckContext
from conformance.client.run_client import RunClient, WorkerClient
from conformance.runner.requirement import from_schema, requirement
from conformance.verdicts import expect
from conformance.verdicts.expect import SetUpFailed

SUCCESSES = {"submit_run": 201, "import_record": 202}
SUCCESSES |= dict.fromkeys(("detach_worker", "delete_run", "delete_import"), 204)
# Header → a value that an operation which lists the header would refuse or obey.
LISTED_SOMEWHERE = {
    "Prefer": "respond-async",
    "If-None-Match": "*",
    "Idempotency-Key": "x" * 200,
    "Last-Event-ID": "no id!",
}


def expect_pages_in_range(run: RunClient) -> None:
    """Expect lists to refuse limits and cursors that some readers accept."""
    for operation_id in ("list_runs", "list_episodes"):
        for limit in ("9" * 20, "", " 5", "1_0", "\uff15"):
            answer = run.call(operation_id, params={"limit": limit})
            expect.refused(answer, "invalid_request")
        for cursor in ("no cursor!", "x" * 129):
            answer = run.call(operation_id, params={"cursor": cursor})
            expect.refused(answer, "invalid_request")
        # The text leaves the answer to this one free, but not its form.
        run.call(operation_id, params={"cursor": "from-no-page"})
        for limit in ("1", "1000"):
            expect.ok(run.call(operation_id, params={"limit": limit}))


def expect_waits_in_range(run: RunClient) -> None:
    """Expect `get_run` to refuse waits that some readers accept."""
    for wrong in ("wait=-1", "wait=", "wait=1.5", "wait=12345", "wait=1, x"):
        answer = run.call("get_run", headers={"Prefer": wrong})
        expect.refused(answer, "invalid_request")
    tags = ", ".join([f'"{"x" * 30}"'] * 10)[:200]
    expect.ok(run.call("get_run", headers={"If-None-Match": tags}))
    for right in ("wait=0", "wait=9999"):
        expect.ok(run.call("get_run", headers={"Prefer": right}))


@from_schema
@requirement("ERR-014")
def test_err_014_cannot_send_invalid_parameters(context: CheckContext) -> None:
    """Every parameter and header of every operation breaks its schema in every way, or
    is left out; numbers and preferences are written as some readers allow. Expect
    `invalid_request`; the ends of the ranges succeed."""
    expect_wrong_values_refused(context)
    run = context.submit()
    expect_pages_in_range(run)
    if context.offers("waiting"):
        expect_waits_in_range(run)
    for version in ("1", "1.0.0", "v1.0", "1.0-draft", "1.00000", "00001.0"):
        answer = context.call("list_runs", headers={"Proctor-Version": version})
        is_known = answer.code == "unsupported_version"
        code = "unsupported_version" if is_known else "invalid_request"
        expect.refused(answer, code)
    if context.offers("compare"):
        params = {"baseline": run.id, "runs": run.id}
        beyond = params | {"tolerance": repr(math.nextafter(1, 2))}
        answer = run.call("compare_runs", params=beyond)
        expect.refused(answer, "invalid_request")
        for tolerance in ("0", "1"):
            params |= {"tolerance": tolerance}
            expect.ok(run.call("compare_runs", params=params))
    if not context.offers("submit_once"):
        return
    longest = uuid.uuid4().hex * 4
    for key in (f"{longest}x", "two words"):
        wrong_key = {"Idempotency-Key": key}
        answer = submit(context, context.submit_body(), headers=wrong_key)
        expect.refused(answer, "invalid_request")
    at_limit = {"Idempotency-Key": longest}
    expect.ok(submit(context, context.submit_body(), headers=at_limit), 201)


def expect_unconditional(worker: WorkerClient, samples: list[OperationSample]) -> None:
    """Expect `get_run` alone to answer that nothing has changed."""
    etag = worker.run.call("get_run").headers.get("etag", "")
    for operation_id, how in samples:
        operation = worker.run.context.spec.operations[operation_id]
        if operation_id == "get_run" or operation.method != "GET":
            continue
        for etag_sent in (etag, "*"):
            headers = {"If-None-Match": etag_sent}
            answer = worker.run.call(operation_id, headers=headers, **how)
            expect.ok(answer, SUCCESSES.get(operation_id, 200))


@requirement("ERR-017")
def test_err_017_headers_of_other_operations_are_ignored(context: CheckContext) -> None:
    """Every operation gets the headers that it does not list, with wrong values; those
    that read get the ETag of the run, and any; a run is stopped, resumed and stopped
    with one Idempotency-Key. Expect the answers that there are without them."""
    worker = attach_live_worker(context)
    samples = [("describe_service", {}), *operation_samples(worker)]
    expect_unconditional(worker, samples)  # before some are deleted
    for operation_id, how in samples:
        described = context.spec.operations[operation_id].description
        listed = {part["name"] for part in described.get("parameters", ())}
        headers = {k: v for k, v in LISTED_SOMEWHERE.items() if k not in listed}
        answer = worker.run.call(operation_id, headers=headers, **how)
        if operation_id == "submit_run":
            adopt_answer(context, answer)
        expect.ok(answer, SUCCESSES.get(operation_id, 200))
    run, key = context.submit("score"), {"Idempotency-Key": uuid.uuid4().hex}
    for operation_id in ("stop_run", "resume_run", "stop_run"):
        body: Any = {} if operation_id == "stop_run" else None
        expect.ok(run.call(operation_id, headers=key, json=body))
    expect.equal(run.get()["state"], "stopped", "state after the second stop")
    conditional = worker.run.call("get_run", headers={"If-None-Match": "*"})
    if conditional.status != 304:
        raise SetUpFailed("`get_run` ignores If-None-Match; see RUN-011")


@requirement("ERR-018")
def test_err_018_ids_of_another_pattern_name_nothing(context: CheckContext) -> None:
    """Run ids and benchmark ids that are too long or have other characters. Expect
    `not_found` or `invalid_request`; the right ids are found."""
    worker = attach_live_worker(context)
    run_id, either = worker.run.id, ("not_found", "invalid_request")
    wrong_ids: list[dict[str, str]] = [
        {"run_id": run_id}
        for run_id in ("x" * 65, f"{run_id}.", f" {run_id}", "K\u00fc", "x" * 2000)
    ]
    benchmark_ids = ("Calibration", "calibration ", "x" * 65, "9", "calibration\n")
    for operation_id, how in operation_samples(worker):
        path = context.spec.operations[operation_id].path
        places = wrong_ids if "{run_id}" in path else []
        if "{benchmark_id}" in path:
            places = [{"benchmark_id": wrong} for wrong in benchmark_ids]
        for place in places:
            answer = worker.run.call(operation_id, **(how | place))
            code = answer.code if answer.code in either else either[0]
            expect.refused(answer, code)
    expect.ok(worker.run.call("get_run"))
    expect.ok(context.call("get_benchmark", benchmark_id="calibration"))


@requirement("ERR-019")
def test_err_019_media_types_may_have_capital_letters(context: CheckContext) -> None:
    """Content-Type and Accept are written in other ways. Expect success."""
    worker = attach_live_worker(context)
    content_types = ["Application/JSON", "APPLICATION/JSON; Charset=UTF-8"]
    content_types += ["application/json ;charset=utf-8"]
    accepts = ["Application/JSON", "text/html;q=0.1, APPLICATION/JSON;Q=0.5"]
    accepts += ["Application/*", "text/html,application/json"]
    for content_type in content_types:
        expect.ok(worker.try_heartbeat(headers={"Content-Type": content_type}))
        headers = {"Content-Type": content_type}
        expect.ok(submit(context, context.submit_body(), headers=headers), 201)
    for accept in accepts:
        expect.ok(worker.run.call("get_run", headers={"Accept": accept}))
        expect.ok(worker.try_heartbeat(headers={"Accept": accept}))
    if context.speaks_msgpack:
        media_type = "Application/MsgPack"
        headers = {"Content-Type": media_type, "Accept": media_type}
        turn = worker.try_predict(context.action(), msgpack=True, headers=headers)
        expect.ok(turn)
        expect.equal(turn.media_type, "application/msgpack", "the media type")


def refused_requests(
    worker: WorkerClient, submission: dict[str, Any]
) -> Iterator[tuple[str, dict[str, Any]]]:
    """Give requests that would change much, each refused for one reason."""
    context = worker.run.context
    session = {"session_id": worker.session_id}
    actions = [context.action(end=1)]
    bodies: dict[str, dict[str, Any]] = {
        "submit_run": submission,
        "attach_worker": {"attach_key": uuid.uuid4().hex},
        "predict": session | {"seq": worker.seq + 1, "actions": actions},
        "stop_run": {"mode": "abort"},
    }
    if context.offers("sessions"):
        bodies["attach_worker"]["takeover"] = True
    newest = int(context.service["protocol"]["max"].partition(".")[0])
    reasons = [{"Proctor-Version": f"{newest + 1}.0"}]
    reasons += [{"Authorization": "Bearer no-such-token"}]
    for headers in reasons if context.offers("sessions") else ():
        yield "detach_worker", {"params": session, "headers": headers}
    reasons.append({"Content-Type": "text/plain"})
    if context.offers("strict_http"):
        reasons.append({"Accept": "text/html"})
    for operation_id, body in bodies.items():
        for headers in reasons:
            yield operation_id, {"json": body, "headers": headers}
        yield operation_id, {"json": body | {"surprise": 1}}


@requirement("ERR-020")
def test_err_020_refused_requests_change_nothing(context: CheckContext) -> None:
    """Requests that would end a run, a session or an episode, refused for many reasons.
    Expect the run unchanged, its session alive, no action executed and no new run."""
    worker = attach_live_worker(context)
    before, submission = worker.run.snapshot(), uniquely_named_body(context)
    for operation_id, how in refused_requests(worker, submission):
        answer = worker.run.call(operation_id, worker_id=worker.id, **how)
        if answer.status < 400:
            raise SetUpFailed(f"a wrong `{operation_id}` was accepted: {how}")
    expect.equal(worker.run.snapshot(), before, "the run")
    turn = expect.ok(worker.try_predict(context.action()))
    expect.equal(count(turn), [2], "count after the refusals")
    if context.offers("lists"):
        expect.equal(runs_of(context, submission), [], "the runs of a refused submit")
