"""Authentication, accounts and scopes (AUTH)."""

from conformance.checks.support.operation_samples import (
    READ_OPERATIONS,
    attach_live_worker,
    operation_samples,
    send,
)
from conformance.client.check_context import CheckContext
from conformance.runner.requirement import requirement
from conformance.verdicts import expect


@requirement("AUTH-001")
def test_auth_001_cannot_do_anything_without_a_valid_token(
    context: CheckContext,
) -> None:
    """Every operation is sent without a token, with a wrong one, with another scheme.

    Expect `unauthenticated` each time, and the run unchanged.
    """
    worker = attach_live_worker(context)
    before = worker.run.snapshot()
    without_token, with_wrong_token = (
        context.client_with_token(None),
        context.client_with_token("no-such-token"),
    )
    for sample in operation_samples(worker):
        for http_client in (without_token, with_wrong_token):
            expect.refused(send(worker.run, sample, http_client), "unauthenticated")
    basic = {"Authorization": "Basic bm86Ym9keQ=="}
    expect.refused(
        context.call("list_runs", http_client=without_token, headers=basic),
        "unauthenticated",
    )
    expect.equal(worker.run.snapshot(), before, "the run")


@requirement("AUTH-002")
def test_auth_002_refusal_names_the_scheme(context: CheckContext) -> None:
    """Requests without a token and with a wrong one. Expect `WWW-Authenticate: Bearer`.

    The header names the authentication scheme.
    """
    for token in (None, "no-such-token"):
        answer = context.call("list_runs", http_client=context.client_with_token(token))
        expect.refused(answer, "unauthenticated")
        header = answer.headers.get("www-authenticate", "")
        schemes = [
            part.split()[0].lower() for part in header.split(",") if part.strip()
        ]
        expect.true(
            "bearer" in schemes, "a WWW-Authenticate header with Bearer", header
        )


@requirement("AUTH-003")
def test_auth_003_cannot_see_or_touch_a_run_of_another_account(
    context: CheckContext,
) -> None:
    """Another account uses the ids of a run, of its worker, and of its session.

    Expect `not_found` from every operation, and the run unchanged.
    """
    other = context.second_account
    worker = attach_live_worker(context)
    before = worker.run.snapshot()
    for sample in operation_samples(worker):
        if "{run_id}" in context.spec.operations[sample[0]].path:
            expect.refused(send(worker.run, sample, other), "not_found")
    expect.equal(worker.run.snapshot(), before, "the run")


@requirement("AUTH-004")
def test_auth_004_cannot_list_runs_of_another_account(context: CheckContext) -> None:
    """Two accounts submit a run each and list. Expect each to see only its own run."""
    wires = (context.http_client, context.second_account)
    ours, theirs = (
        context.submit(http_client=http_client, wait_ready=False)
        for http_client in wires
    )
    params = {"limit": 1000}
    for http_client, shown, hidden in zip(
        wires, (ours, theirs), (theirs, ours), strict=True
    ):
        page = expect.ok(
            context.call("list_runs", http_client=http_client, params=params)
        )
        seen = {run["run_id"] for run in page["runs"]}
        if shown.id not in seen:
            text = "`list_runs` does not show a run to its owner"
            raise expect.SetUpFailed(text, breaks="RUN-009")
        expect.true(hidden.id not in seen, "no run of another account", hidden.id)


@requirement("AUTH-005")
def test_auth_005_can_only_read_with_the_scope_read(context: CheckContext) -> None:
    """A token with the scope `read` is used for every operation.

    Expect success of every GET, `forbidden` otherwise, and the run unchanged.
    """
    read_only_client = context.read_only_account
    worker = attach_live_worker(context)
    before = worker.run.snapshot()
    for sample in operation_samples(worker):
        answer = send(worker.run, sample, read_only_client)
        if sample[0] in READ_OPERATIONS:
            expect.ok(answer)
        else:
            expect.refused(answer, "forbidden")
    expect.equal(worker.run.snapshot(), before, "the run")
