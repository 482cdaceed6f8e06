"""Bodies that are well-formed and break the schema of their operation (ERR)."""

from typing import Any

from conformance.checks.support.bodies.value_bounds import at_bounds
from conformance.checks.support.generated.schema_requests import (
    expect_wrong_values_refused,
)
from conformance.checks.support.operation_samples import (
    attach_live_worker,
    samples_with_body,
    send,
    send_body,
)
from conformance.checks.support.submissions import submit, whole_submission
from conformance.client.check_context import CheckContext
from conformance.runner.requirement import from_schema, requirement
from conformance.verdicts import expect


def schema_of(context: CheckContext, operation_id: str) -> dict[str, Any]:
    operation = context.spec.operations[operation_id]
    content = operation.description["requestBody"]["content"]
    schema: dict[str, Any] = content["application/json"]["schema"]
    return schema


@from_schema
@requirement("ERR-015")
def test_err_015_cannot_send_a_root_that_is_no_object(context: CheckContext) -> None:
    """Null, lists, texts, numbers and booleans as the whole body of every operation.
    Expect `invalid_request` and the run unchanged; then the objects are accepted."""
    expect_wrong_values_refused(context)
    worker = attach_live_worker(context)
    samples = samples_with_body(worker)
    for operation_id, how in samples:
        root: Any
        for root in ([], [{}], [how["json"]], "", 1.5):
            answer = send_body(worker, (operation_id, how), root)
            expect.refused(answer, "invalid_request")
    for sample in samples:
        status = 201 if sample[0] == "submit_run" else 200
        expect.ok(send(worker.run, sample), status)


@from_schema
@requirement("ERR-016")
def test_err_016_cannot_send_values_out_of_bounds(context: CheckContext) -> None:
    """Each bound of each body is broken alone, and each required member left out.
    Expect `invalid_request` pointing there; the bodies unbroken, and with everything at
    either end of its bounds, are accepted."""
    expect_wrong_values_refused(context)
    submission = whole_submission(context)
    schema, whole = schema_of(context, "submit_run")["properties"], [submission]
    for end in ("min", "max"):
        parts = ("policy", "options")
        ends = {name: at_bounds(schema[name], submission[name], end) for name in parts}
        whole.append(submission | ends)
    for body in whole:
        expect.ok(submit(context, body), 201)
    longest = at_bounds(schema_of(context, "attach_worker"), {"attach_key": ""}, "max")
    expect.ok(context.submit().worker().try_attach(**longest))
