"""Authentication, accounts and scopes (AUTH)."""

from collections.abc import Iterator
from functools import partial
from typing import Any

from conformance.checks.support.operation_samples import (
    READ_OPERATIONS,
    attach_live_worker,
    needs_token,
    operation_samples,
    send,
)
from conformance.checks.support.submissions import runs_of, submit, uniquely_named_body
from conformance.client.check_context import CheckContext
from conformance.client.run_client import RunClient
from conformance.exchanges.answer import Answer
from conformance.runner.requirement import requirement
from conformance.verdicts import expect

# Headers that say nothing of the run.
OF_THE_CONNECTION = frozenset({"date", "connection", "keep-alive", "transfer-encoding"})


def nearly_right_credentials(token: str) -> Iterator[str]:
    """Give Authorization headers that name a token wrongly."""
    for scheme in ("Basic", "Token", "Bearerx", "Digest"):
        yield f"{scheme} {token}"
    yield from (token, "Bearer", f"Bearer{token}", f"Bearer x{token}")
    yield f"Basic :{token}"
    if token.swapcase() != token:
        yield f"Bearer {token.swapcase()}"
    if len(token) > 1:
        yield from (f"Bearer {token[1:]}", f"Bearer {token[0]}")


@requirement("AUTH-001")
def test_auth_001_cannot_do_anything_without_a_token(context: CheckContext) -> None:
    """Every operation is sent without a token and with wrong ones, also nearly right.
    Expect `unauthenticated` each time, and the run unchanged."""
    worker = attach_live_worker(context)
    before = worker.run.snapshot()
    token = context.http_client.token or ""
    without_token = context.client_with_token(None)
    wrong_tokens = (None, "no-such-token", f"{token}x", token[:-1] or "x")
    for sample in operation_samples(worker):
        for wrong in wrong_tokens if needs_token(context, sample) else wrong_tokens[1:]:
            http_client = context.client_with_token(wrong)
            expect.refused(send(worker.run, sample, http_client), "unauthenticated")
    for header in nearly_right_credentials(token):
        headers = {"Authorization": header}
        send_it = partial(context.call, "list_benchmarks", headers=headers)
        expect.refused(send_it(http_client=without_token), "unauthenticated")
    expect.equal(worker.run.snapshot(), before, "the run")


@requirement("AUTH-002")
def test_auth_002_refusal_names_the_scheme(context: CheckContext) -> None:
    """Every operation without a token, and one with a wrong token. Expect
    `WWW-Authenticate: Bearer`; the header names the authentication scheme."""
    worker = attach_live_worker(context)
    without_token, with_wrong_token = map(
        context.client_with_token, (None, "no-such-token")
    )
    answers = [
        send(worker.run, sample, without_token)
        for sample in operation_samples(worker)
        if needs_token(context, sample)
    ]
    answers.append(context.call("list_benchmarks", http_client=with_wrong_token))
    for answer in answers:
        expect.refused(answer, "unauthenticated")
        header = answer.headers.get("www-authenticate", "")
        schemes = [p.split()[0].lower() for p in header.split(",") if p.strip()]
        expect.true("bearer" in schemes, "a WWW-Authenticate with Bearer", header)


def unknown_ids(run: RunClient) -> list[str]:
    """Find two ids of no run that look like the id of a run, if there are such."""
    names: list[str] = []
    for last in "0123456789abcdefghijklmnopqrstuvwxyz":
        name = run.id[:-1] + last
        if run.context.call("get_run", run_id=name).code == "not_found":
            names.append(name)
        if len(names) == 2:
            break
    return names


def without_id(value: Any, run_id: str) -> Any:
    """Replace the id of a run in every text."""
    if isinstance(value, dict):
        return {name: without_id(inner, run_id) for name, inner in value.items()}
    if isinstance(value, list):
        return [without_id(inner, run_id) for inner in value]
    return value.replace(run_id, "RUN") if isinstance(value, str) else value


def appearance(answer: Answer, run_id: str) -> dict[str, Any]:
    """Give the parts of a refusal, with the id of the run left out."""
    body: dict[str, Any] = without_id(answer.json, run_id)
    headers = {name.lower(): text for name, text in answer.headers.items()}
    parts = {f"header {k}": headers[k] for k in headers if k not in OF_THE_CONNECTION}
    return parts | body | {"names": sorted([*parts, *body])}


@requirement("AUTH-003")
def test_auth_003_cannot_use_a_run_of_another_account(context: CheckContext) -> None:
    """Another account uses the ids of a run, of its worker, and of its session. Expect
    `not_found` from every operation, equal in every part to the answer for a run that
    does not exist, and the run unchanged."""
    second_account = context.second_account
    worker = attach_live_worker(context)
    run_id, before = worker.run.id, worker.run.snapshot()
    unknown = unknown_ids(worker.run)
    for operation_id, how in operation_samples(worker):
        if "{run_id}" not in context.spec.operations[operation_id].path:
            continue
        appearances = []
        for name in (*unknown[:1], run_id, *unknown[1:]):
            sample = (operation_id, how | {"run_id": name})
            answer = send(worker.run, sample, second_account)
            expect.refused(answer, "not_found")
            appearances.append(appearance(answer, name))
        # Parts that differ between two unknown runs differ at random, such as times:
        # they cannot show that the run in between exists.
        before_it, after_it = appearances[0], appearances[-1]
        foreign = appearances[len(appearances) // 2]
        steady = [p for p in before_it if after_it.get(p) == before_it[p]]
        expect.equal(
            {part: foreign.get(part) for part in steady},
            {part: before_it[part] for part in steady},
            f"the answer of {operation_id} for a run of another account",
        )
    expect.equal(worker.run.snapshot(), before, "the run")


@requirement("AUTH-004")
def test_auth_004_cannot_list_runs_of_another_account(context: CheckContext) -> None:
    """Two accounts submit runs and list them, each with a cursor of the other, too.
    Expect each to see only its own runs; the other's cursor may be refused."""
    accounts = (context.http_client, context.second_account)
    for client in accounts * 2:  # two runs each, so that there are cursors
        context.submit(http_client=client, wait_ready=False)
    list_runs = partial(context.call, "list_runs")
    for client, other in zip(accounts, accounts[::-1], strict=True):
        list_runs(http_client=client, params={"limit": 1000})
        page = expect.ok(list_runs(http_client=other, params={"limit": 1}))
        params = {"limit": 1000, "cursor": page["next_cursor"]}
        list_runs(http_client=client, params=params)


@requirement("AUTH-005")
def test_auth_005_can_only_read_with_the_scope_read(context: CheckContext) -> None:
    """A token with the scope `read` is used for every operation. Expect success of
    every GET, `forbidden` otherwise, and no run made or changed."""
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
    submission = uniquely_named_body(context)
    answer = submit(context, submission, http_client=read_only_client)
    expect.refused(answer, "forbidden")
    expect.equal(runs_of(context, submission), [], "the runs of a refused submit")
