"""Who may do what: AUTH."""

from conformance.checks.support.operation_samples import (
    READING,
    all_operations,
    live_worker,
    send,
)
from conformance.client.check_context import Story
from conformance.runner.requirement import requirement
from conformance.verdicts import expect


@requirement("AUTH-001")
def test_auth_001_cannot_do_anything_without_a_valid_token(story: Story) -> None:
    """Every operation is tried without a token, with a wrong one, and in another way.

    Expect `unauthenticated` each time, and the run to stand as it did.
    """
    worker = live_worker(story)
    before = worker.run.snapshot()
    nobody, somebody = story.wire_of(None), story.wire_of("no-such-token")
    for stop in all_operations(worker):
        for wire in (nobody, somebody):
            expect.refused(send(worker.run, stop, wire), "unauthenticated")
    basic = {"Authorization": "Basic bm86Ym9keQ=="}
    expect.refused(
        story.call("list_runs", wire=nobody, headers=basic), "unauthenticated"
    )
    expect.equal(worker.run.snapshot(), before, "the run")


@requirement("AUTH-002")
def test_auth_002_refusal_names_the_scheme(story: Story) -> None:
    """Requests without a token and with a wrong one. Expect `WWW-Authenticate: Bearer`.

    The header tells a client how to authenticate.
    """
    for token in (None, "no-such-token"):
        answer = story.call("list_runs", wire=story.wire_of(token))
        expect.refused(answer, "unauthenticated")
        header = answer.headers.get("www-authenticate", "")
        schemes = [
            part.split()[0].lower() for part in header.split(",") if part.strip()
        ]
        expect.true(
            "bearer" in schemes, "a WWW-Authenticate header with Bearer", header
        )


@requirement("AUTH-003")
def test_auth_003_cannot_see_or_touch_a_run_of_another_account(story: Story) -> None:
    """Another account knows the ids of a run, of its worker, and of its session.

    Expect `not_found` from every operation, and the run to stand as it did.
    """
    other = story.wire_2
    worker = live_worker(story)
    before = worker.run.snapshot()
    for stop in all_operations(worker):
        if "{run_id}" in story.spec.operations[stop[0]].path:
            expect.refused(send(worker.run, stop, other), "not_found")
    expect.equal(worker.run.snapshot(), before, "the run")


@requirement("AUTH-004")
def test_auth_004_cannot_list_runs_of_another_account(story: Story) -> None:
    """Two accounts submit a run each and list. Expect each to see its own."""
    wires = (story.wire, story.wire_2)
    ours, theirs = (story.submit(wire=wire, wait_ready=False) for wire in wires)
    params = {"limit": 1000}
    for wire, shown, hidden in zip(wires, (ours, theirs), (theirs, ours), strict=True):
        page = expect.ok(story.call("list_runs", wire=wire, params=params))
        seen = {run["run_id"] for run in page["runs"]}
        if shown.id not in seen:
            raise expect.SetUpFailed("`list_runs` does not show a run to its owner")
        expect.true(hidden.id not in seen, "no run of another account", hidden.id)


@requirement("AUTH-005")
def test_auth_005_can_only_read_with_the_scope_read(story: Story) -> None:
    """A token with the scope `read` is used for every operation.

    Expect every GET to be served, everything else `forbidden`, and nothing changed.
    """
    reader = story.wire_read
    worker = live_worker(story)
    before = worker.run.snapshot()
    for stop in all_operations(worker):
        answer = send(worker.run, stop, reader)
        if stop[0] in READING:
            expect.ok(answer)
        else:
            expect.refused(answer, "forbidden")
    expect.equal(worker.run.snapshot(), before, "the run")
