"""What holds for the service and for every answer: SVC, VER."""

from conformance.checks.support.operation_samples import (
    all_operations,
    live_worker,
    send,
)
from conformance.client.check_context import Story
from conformance.runner.requirement import requirement
from conformance.verdicts import expect


def number(version: str) -> tuple[int, ...]:
    """Make versions comparable."""
    return tuple(int(part) for part in version.split("."))


@requirement("SVC-001")
def test_svc_001_can_describe_the_service_without_a_token(story: Story) -> None:
    """A stranger asks, without a token and with a wrong one. Expect the description."""
    for stranger in (story.wire_of(None), story.wire_of("no-such-token")):
        described = expect.ok(story.call("describe_service", wire=stranger))
        expect.true(described["protocol"], "a protocol range")


@requirement("SVC-002")
def test_svc_002_own_version_lies_in_the_announced_range(story: Story) -> None:
    """We read the range and the header of the same answer. Expect them to agree."""
    answer = story.call("describe_service")
    protocol = expect.ok(answer)["protocol"]
    version = answer.headers.get("proctor-version", "")
    expect.true(version, "a Proctor-Version header", "no such header")
    expect.true(
        number(protocol["min"]) <= number(version) <= number(protocol["max"]),
        f"a version from {protocol['min']} to {protocol['max']}",
        version,
    )


@requirement("SVC-003")
def test_svc_003_answers_are_as_described(story: Story) -> None:
    """Every operation is used once, in JSON and where offered in MessagePack.

    Expect every answer, here and in all other checks, to fit openapi.yaml.
    """
    worker = live_worker(story)
    story.call("describe_service")
    for stop in all_operations(worker):
        send(worker.run, stop)
    if story.speaks_msgpack:
        worker = story.submit("echo").worker()
        worker.attach(headers={"Accept": "application/msgpack"})
        worker.predict(story.action(end=1), msgpack=True)


@requirement("VER-001")
def test_ver_001_every_answer_carries_the_version(story: Story) -> None:
    """Answers of many kinds: granted, refused, without a body, on no path at all.

    Expect a Proctor-Version header on each, here and in all other checks.
    """
    worker = live_worker(story)
    answers = [send(worker.run, stop) for stop in all_operations(worker)]
    answers += [
        story.call("describe_service"),
        story.call("list_runs", wire=story.wire_of(None)),
        story.call("get_run", run_id="no-such-run"),
        story.call("submit_run", content=b"{", headers={"Content-Type": "text/plain"}),
        story.wire.request("GET", "/v1/no-such-path"),
        story.wire.request("PATCH", "/v1/runs"),
    ]
    for answer in answers:
        expect.true(
            answer.headers.get("proctor-version"),
            "a Proctor-Version header",
            f"none on a {answer.status}",
        )


@requirement("VER-002")
def test_ver_002_cannot_use_a_version_out_of_range(story: Story) -> None:
    """Requests name a version beyond the range, then the ends of the range.

    Expect `unsupported_version` for the first, and service for the others.
    """
    worker = live_worker(story)
    protocol = story.service["protocol"]
    beyond = f"{number(protocol['max'])[0] + 1}.0"
    for operation_id, how in all_operations(worker):
        answer = worker.run.call(
            operation_id, headers={"Proctor-Version": beyond}, **how
        )
        expect.refused(answer, "unsupported_version")
    for version in (protocol["min"], protocol["max"]):
        expect.ok(story.call("list_runs", headers={"Proctor-Version": version}))
        expect.ok(worker.try_heartbeat(headers={"Proctor-Version": version}))
