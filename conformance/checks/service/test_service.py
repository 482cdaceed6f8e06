"""The description of the service, and rules for every response (SVC, VER)."""

from conformance.checks.support.operation_samples import (
    attach_live_worker,
    operation_samples,
    send,
)
from conformance.client.check_context import CheckContext
from conformance.runner.requirement import requirement
from conformance.verdicts import expect


def number(version: str) -> tuple[int, ...]:
    """Convert a version to comparable numbers."""
    return tuple(int(part) for part in version.split("."))


@requirement("SVC-001")
def test_svc_001_can_be_described_without_a_token(context: CheckContext) -> None:
    """A request without a token, and one with a wrong token. Expect the description."""
    for anonymous in (
        context.client_with_token(None),
        context.client_with_token("no-such-token"),
    ):
        described = expect.ok(context.call("describe_service", http_client=anonymous))
        expect.true(described["protocol"], "a protocol range")


@requirement("SVC-002")
def test_svc_002_own_version_lies_in_the_announced_range(context: CheckContext) -> None:
    """The range and the header of one response are read. Expect them to agree."""
    answer = context.call("describe_service")
    protocol = expect.ok(answer)["protocol"]
    version = answer.headers.get("proctor-version", "")
    expect.true(version, "a Proctor-Version header", "no such header")
    expect.true(
        number(protocol["min"]) <= number(version) <= number(protocol["max"]),
        f"a version from {protocol['min']} to {protocol['max']}",
        version,
    )


@requirement("SVC-003")
def test_svc_003_answers_are_as_described(context: CheckContext) -> None:
    """Every operation is sent once, in JSON and where offered in MessagePack. Expect
    every response, here and in all other checks, to match openapi.yaml."""
    worker = attach_live_worker(context)
    context.call("describe_service")
    for sample in operation_samples(worker):
        send(worker.run, sample)
    if context.speaks_msgpack:
        worker = context.submit("echo").worker()
        worker.attach(headers={"Accept": "application/msgpack"})
        worker.predict(context.action(end=1), msgpack=True)


@requirement("VER-001")
def test_ver_001_every_answer_carries_the_version(context: CheckContext) -> None:
    """Responses of many kinds: success, refusal, without a body, on an unknown path.
    Expect a Proctor-Version header on each, here and in all other checks."""
    worker = attach_live_worker(context)
    answers = [send(worker.run, sample) for sample in operation_samples(worker)]
    answers += [
        context.call("describe_service"),
        context.call("list_benchmarks", http_client=context.client_with_token(None)),
        context.call("get_run", run_id="no-such-run"),
        context.call(
            "submit_run", content=b"{", headers={"Content-Type": "text/plain"}
        ),
        context.http_client.request("GET", "/v1/no-such-path"),
        context.http_client.request("PATCH", "/v1/runs"),
    ]
    for answer in answers:
        expect.true(
            answer.headers.get("proctor-version"),
            "a Proctor-Version header",
            f"none on a {answer.status}",
        )


def versions_outside(protocol: dict[str, str]) -> list[str]:
    """Give versions before and after a range, the nearest first."""
    (major, minor), first = number(protocol["max"]), number(protocol["min"])
    beyond = [(major, minor + 1), (major + 1, 0), (0, 0), (first[0] - 1, 99)]
    beyond += [(first[0], first[1] - 1), (major, 10 * minor + 10), (10 * major, 0)]
    beyond += [(9999, 9999), (first[0] - 1, minor), (0, major)]
    return [
        f"{one}.{two}"
        for one, two in dict.fromkeys(beyond)
        if one >= 0 and two >= 0 and not first <= (one, two) <= (major, minor)
    ]


@requirement("VER-002")
def test_ver_002_cannot_use_a_version_out_of_range(context: CheckContext) -> None:
    """Requests with versions outside the range, as near as can be, then with its ends,
    which also begin with zeros. Expect `unsupported_version` for the first, and success
    for the others."""
    worker = attach_live_worker(context)
    protocol = context.service["protocol"]
    for operation_id, how in [("describe_service", {}), *operation_samples(worker)]:
        for beyond in versions_outside(protocol)[:3]:
            answer = worker.run.call(
                operation_id, headers={"Proctor-Version": beyond}, **how
            )
            expect.refused(answer, "unsupported_version")
    for beyond in versions_outside(protocol):
        answer = context.call("list_benchmarks", headers={"Proctor-Version": beyond})
        expect.refused(answer, "unsupported_version")
    ends = [protocol["min"], protocol["max"]]
    ends += ["{:02}.{:03}".format(*number(end)) for end in ends]
    for version in ends:
        headers = {"Proctor-Version": version}
        expect.ok(context.call("list_benchmarks", headers=headers))
        if context.serves("predict"):
            expect.ok(worker.try_predict(context.action(), headers=headers))
