"""Bodies that are well-formed and break the schema of their operation (ERR)."""

import json
import uuid
from typing import Any

from conformance.checks.support.bodies.schema_breaches import (
    at_bounds,
    broken_bounds,
    missing_members,
)
from conformance.checks.support.given_states import expect_pointer
from conformance.checks.support.operation_samples import (
    attach_live_worker,
    operation_samples,
    send,
)
from conformance.checks.support.submissions import submit, whole_submission
from conformance.client.check_context import CheckContext
from conformance.client.run_client import RunClient
from conformance.exchanges.answer import Answer
from conformance.runner.requirement import requirement
from conformance.verdicts import expect

ROOTS: list[Any] = [None, [], [{}], "text", "", 0, 1.5, True, False]


def schema_of(context: CheckContext, operation_id: str) -> dict[str, Any]:
    """Give the schema of the body of an operation."""
    operation = context.spec.operations[operation_id]
    content = operation.description["requestBody"]["content"]
    schema: dict[str, Any] = content["application/json"]["schema"]
    return schema


def send_json(run: RunClient, operation_id: str, body: Any, **how: Any) -> Answer:
    """Send any value as JSON, null too."""
    headers = {"Content-Type": "application/json"}
    content = json.dumps(body).encode()
    return run.call(operation_id, content=content, headers=headers, **how)


@requirement("ERR-015")
def test_err_015_cannot_send_a_root_that_is_no_object(context: CheckContext) -> None:
    """Null, lists, texts, numbers and booleans as the whole body of every operation.

    Expect `invalid_request` and the run unchanged; then the objects are accepted.
    """
    worker = attach_live_worker(context)
    before = worker.run.snapshot()
    samples = [s for s in operation_samples(worker) if "json" in s[1]]
    for operation_id, how in samples:
        others = {name: value for name, value in how.items() if name != "json"}
        for root in [*ROOTS, [how["json"]]]:
            answer = send_json(worker.run, operation_id, root, **others)
            expect.refused(answer, "invalid_request")
    expect.equal(worker.run.snapshot(), before, "the run")
    for sample in samples:
        status = 201 if sample[0] == "submit_run" else 200
        expect.ok(send(worker.run, sample), status)


@requirement("ERR-016")
def test_err_016_cannot_send_values_out_of_bounds(context: CheckContext) -> None:
    """Each bound of each body is broken alone, and each required member left out.

    Expect `invalid_request` pointing there; the bodies unbroken, and with everything at
    either end of its bounds, are accepted.
    """
    worker = attach_live_worker(context)
    samples = {o: how for o, how in operation_samples(worker) if "json" in how}
    submission = samples["submit_run"]["json"] = whole_submission(context)
    samples["attach_worker"]["json"] = {"attach_key": uuid.uuid4().hex}
    if context.offers("observations"):
        samples["predict"]["json"]["observe"] = "last"
    samples["stop_run"]["json"] = {"mode": "abort"}
    for operation_id, how in samples.items():
        schema = schema_of(context, operation_id)
        body, others = how["json"], {k: how[k] for k in how if k != "json"}
        for pointer, wrong in broken_bounds(schema, body):
            answer = send_json(worker.run, operation_id, wrong, **others)
            expect_pointer(expect.refused(answer, "invalid_request"), pointer)
        for pointer, parent, wrong in missing_members(schema, body):
            answer = send_json(worker.run, operation_id, wrong, **others)
            errors = expect.refused(answer, "invalid_request")["errors"]
            places = [error["pointer"] for error in errors]
            expect.true({pointer, parent} & {*places}, f"a pointer {pointer}", places)
    schema, whole = schema_of(context, "submit_run")["properties"], [submission]
    for end in ("min", "max"):
        parts = ("policy", "options")
        ends = {name: at_bounds(schema[name], submission[name], end) for name in parts}
        whole.append(submission | ends)
    for body in whole:
        expect.ok(submit(context, body), 201)
    longest = at_bounds(schema_of(context, "attach_worker"), {"attach_key": ""}, "max")
    free = context.submit().worker()
    expect.ok(free.try_attach(**longest))
