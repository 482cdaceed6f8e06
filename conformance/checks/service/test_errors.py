"""What is refused, and how: ERR."""

import json
import time
import uuid
from typing import Any

import msgspec

from conformance.checks.runs.test_runs import submit
from conformance.checks.support.fuzz import fuzz_operations
from conformance.checks.support.given_states import count
from conformance.checks.support.invalid_bodies import (
    WRONG_TYPES,
    beyond_json,
    padded,
    replaced,
    with_surprises,
)
from conformance.checks.support.operation_samples import (
    READING,
    all_operations,
    live_worker,
    send,
)
from conformance.client.check_context import Story, Worker
from conformance.client.http_client import Answer
from conformance.runner.requirement import requirement
from conformance.verdicts import expect
from conformance.verdicts.expect import NotApplicable, SetUpFailed

MSGPACK = "application/msgpack"
MEGABYTE = 10**6
DEEP = 10**6
Bodies = list[tuple[str, dict[str, Any]]]


def with_bodies(worker: Worker) -> Bodies:
    """Give one valid request of every operation that has a body."""
    return [stop for stop in all_operations(worker) if "json" in stop[1]]


def send_body(worker: Worker, stop: tuple[str, dict[str, Any]], body: Any) -> Answer:
    """Send a request with another body: bytes as they are, anything else as JSON."""
    operation_id, how = stop
    how = {key: value for key, value in how.items() if key != "json"}
    if not isinstance(body, bytes):
        body = json.dumps(body).encode()
    how["headers"] = {"Content-Type": "application/json"} | how.get("headers", {})
    return send(worker.run, (operation_id, how | {"content": body}))


def nothing_happened(worker: Worker, executed: int = 1) -> None:
    """Expect the next action of the worker to be the one after those executed."""
    turn = expect.ok(worker.try_predict(worker.run.story.action()))
    expect.equal(count(turn), [executed + 1], "count after the refusals")


@requirement("ERR-001")
def test_err_001_refusals_are_problems(story: Story) -> None:
    """Refusals of many kinds. Expect problems of the catalogue.

    The same is expected of every refusal in all other checks.
    """
    worker = live_worker(story)
    text = {"Content-Type": "text/plain"}
    story.call("list_runs", wire=story.wire_of(None))
    story.call("get_run", run_id="no-such-run")
    story.wire.request("GET", "/v1/no-such-path")
    story.wire.request("PATCH", "/v1/runs")
    story.call("list_runs", headers={"Accept": "text/html"})
    story.call("submit_run", content=b"{}", headers=text)
    story.call("submit_run", content=b"{")
    story.call("submit_run", json={})
    worker.try_predict(seq=99)
    worker.try_attach()


@requirement("ERR-002")
def test_err_002_cannot_send_what_is_not_well_formed(story: Story) -> None:
    """Bodies that are cut off, spoiled or empty, and what JSON can write but not mean.

    Expect `malformed_body` and nothing executed.
    """
    worker = live_worker(story)
    spoilt = [b"", b"{", b"{'a': 1}", b'{"a": 1,}', b'{"a": 1} {}', b'"\xff\xfe"', b"a"]
    for stop in with_bodies(worker):
        whole = json.dumps(stop[1]["json"]).encode()
        cut = [whole[: story.random.randrange(1, len(whole))] for _ in range(3)]
        for body in spoilt + (cut if len(whole) > 2 else []):
            expect.refused(send_body(worker, stop, body), "malformed_body")
        for body in beyond_json(*stop):
            expect.refused(send_body(worker, stop, body), "malformed_body")
    if story.speaks_msgpack:
        stops = {stop[0]: stop[1] for stop in all_operations(worker)}
        packed = msgspec.msgpack.encode(stops["predict"]["json"])
        for wrong in (packed[:-1], packed + b"\xc0", b"\xc1", b""):
            answer = worker.run.call(
                "predict",
                worker_id=worker.id,
                content=wrong,
                headers={"Content-Type": MSGPACK},
            )
            expect.refused(answer, "malformed_body")
    nothing_happened(worker)


@requirement("ERR-003")
def test_err_003_cannot_send_an_unknown_member(story: Story) -> None:
    """A member that nobody knows, at the top of every body and inside of it.

    Expect `invalid_request` pointing at it, and nothing executed.
    """
    worker = live_worker(story)
    for stop in with_bodies(worker):
        for path, body in with_surprises(stop[1]["json"], ""):
            answer = send_body(worker, stop, body)
            expect.refused(answer, "invalid_request", pointer=f"{path}/surprise")
    body = story.submit_body(options={"surprise": 1})
    answer = submit(story, body)
    expect.refused(answer, "invalid_request", pointer="/options/surprise")
    nothing_happened(worker)


@requirement("ERR-004")
def test_err_004_cannot_send_a_member_of_the_wrong_type(story: Story) -> None:
    """Strings for numbers, null for what cannot be null, numbers for lists, and so on.

    Expect `invalid_request` pointing at the member, and nothing executed.
    """
    worker = live_worker(story)
    stops = {stop[0]: stop for stop in with_bodies(worker)}
    for (operation_id, pointer), wrongs in WRONG_TYPES.items():
        stop = stops[operation_id]
        for wrong in wrongs:
            body = replaced(stop[1]["json"], pointer, wrong)
            answer = send_body(worker, stop, body)
            expect.refused(answer, "invalid_request", pointer=pointer)
    nothing_happened(worker)


@requirement("ERR-005")
def test_err_005_cannot_send_too_large_a_body(story: Story) -> None:
    """Bodies of 100 MB streamed, of one byte more than the limit, and of the limit.

    Expect `body_too_large` for the first two, with and without a declared length.
    """
    limit = story.limits["max_body_bytes"]
    as_json = {"Content-Type": "application/json"}
    for size in (limit + 1, max(100 * MEGABYTE, limit + 1)):
        for headers in (as_json, as_json | {"Content-Length": str(size)}):
            stream = padded(story.submit_body(), size)
            answer = story.call("submit_run", content=stream, headers=headers)
            expect.refused(answer, "body_too_large")
    just_right = b"".join(padded(story.submit_body(), limit))
    answer = story.call("submit_run", content=just_right, headers=as_json)
    story.adopt(expect.ok(answer, 201))


@requirement("ERR-006")
def test_err_006_cannot_send_a_body_a_million_deep(story: Story) -> None:
    """Lists in lists, a million deep, closed and cut off, alone and in a member.

    Expect `malformed_body`; three deep the same body is merely invalid.
    """
    if story.limits["max_body_bytes"] < 2 * DEEP + 100:
        raise NotApplicable("such a body is larger than the server allows")
    worker = live_worker(story)
    predict = next(stop for stop in with_bodies(worker) if stop[0] == "predict")
    for opening, closing in ((b"[", b"]"), (b"[", b""), (b'{"a":', b"")):
        depth = min(DEEP, (story.limits["max_body_bytes"] - 100) // len(opening))
        deep = opening * depth + (b"1" + closing * depth if closing else b"")
        for body in (deep, b'{"seq":' + deep + b"}" * bool(closing)):
            expect.refused(send_body(worker, predict, body), "malformed_body")
    if story.speaks_msgpack:
        answer = worker.run.call(
            "predict",
            worker_id=worker.id,
            content=b"\x91" * DEEP + b"\xc0",
            headers={"Content-Type": MSGPACK},
        )
        expect.refused(answer, "malformed_body")
    shallow = send_body(worker, predict, {"seq": [[[1]]]})
    if shallow.code != "invalid_request":
        raise SetUpFailed(f"three deep it should be invalid: {expect.told(shallow)}")
    nothing_happened(worker)


@requirement("ERR-007")
def test_err_007_cannot_send_another_media_type(story: Story) -> None:
    """Valid bodies under the name of media types that the operation does not list.

    Expect `unsupported_media_type` and nothing executed; JSON with a charset is read.
    """
    worker = live_worker(story)
    operations = story.spec.operations
    for operation_id, how in with_bodies(worker):
        listed = operations[operation_id].request_media_types()
        for media_type in ("text/plain", "application/xml", "application/x-pickle"):
            headers = {"Content-Type": media_type}
            answer = send_body(
                worker, (operation_id, how | {"headers": headers}), how["json"]
            )
            expect.refused(answer, "unsupported_media_type")
        if MSGPACK not in listed:
            packed = msgspec.msgpack.encode(how["json"])
            as_msgpack = how | {"headers": {"Content-Type": MSGPACK}}
            answer = send_body(worker, (operation_id, as_msgpack), packed)
            expect.refused(answer, "unsupported_media_type")
    charset = {"Content-Type": "application/json; charset=utf-8"}
    expect.ok(submit(story, story.submit_body(), headers=charset), 201)
    nothing_happened(worker)


@requirement("ERR-008")
def test_err_008_cannot_ask_for_another_media_type(story: Story) -> None:
    """Requests accept what the operation does not list; then what it lists as well.

    Expect `not_acceptable` and nothing executed, then service; a detach, which is
    answered without a body, is carried out.
    """
    worker = live_worker(story)
    text = "text/html, image/png;q=0.5"
    for operation_id, how in all_operations(worker):
        if operation_id == "detach_worker":
            continue
        answer = worker.run.call(operation_id, headers={"Accept": text}, **how)
        expect.refused(answer, "not_acceptable")
        if operation_id in READING:
            answer = worker.run.call(operation_id, headers={"Accept": MSGPACK}, **how)
            expect.refused(answer, "not_acceptable")
            listed = story.spec.operations[operation_id].answer_media_types()
            mixed = {"Accept": f"text/html, {listed[0]};q=0.1"}
            expect.ok(worker.run.call(operation_id, headers=mixed, **how))
    nothing_happened(worker)
    only_problems = {"Accept": "application/problem+json"}
    detached = worker.run.call(
        "detach_worker",
        worker_id=worker.id,
        params={"session_id": worker.session_id},
        headers=only_problems,
    )
    expect.ok(detached, 204)


@requirement("ERR-009")
def test_err_009_cannot_find_other_paths(story: Story) -> None:
    """Paths beside those of the specification. Expect `not_found`."""
    run = story.submit()
    paths = ["/v2", "/v1/nothing", f"/v1/{uuid.uuid4().hex}", "/v1/runs/nothing/at/all"]
    paths += [f"/v1/runs/{run.id}/{name}" for name in ("nothing", "workers")]
    for path in paths:
        for method in ("GET", "POST"):
            expect.refused(story.wire.request(method, path), "not_found")
    expect.ok(story.wire.request("GET", f"/v1/runs/{run.id}"))


@requirement("ERR-010")
def test_err_010_cannot_use_other_methods(story: Story) -> None:
    """Every path is used with every method that it does not have.

    Expect `method_not_allowed`, and an Allow header that names those it has.
    """
    worker = live_worker(story)
    names = {"run_id": worker.run.id, "worker_id": worker.id}
    names["benchmark_id"] = "calibration"
    methods_of: dict[str, set[str]] = {}
    base_of: dict[str, str] = {}
    for operation in story.spec.operations.values():
        if not story.offers(operation.profile):
            continue
        methods_of.setdefault(operation.path, set()).add(operation.method)
        base_of[operation.path] = worker.run.base_url_of(operation)
    for template, methods in methods_of.items():
        for method in {"GET", "PUT", "POST", "DELETE", "PATCH"} - methods:
            path = base_of[template] + template.format(**names)
            answer = story.wire.request(method, path)
            expect.refused(answer, "method_not_allowed")
            told = answer.headers.get("allow", "")
            allowed = {name.strip().upper() for name in told.split(",")} - {""}
            expect.equal(
                sorted(allowed - {"HEAD", "OPTIONS"}),
                sorted(methods),
                f"Allow of {template}",
            )
    nothing_happened(worker)


@requirement("ERR-011")
def test_err_011_answers_that_ask_to_wait_say_how_long(story: Story) -> None:
    """A second worker attaches where one is allowed. Expect Retry-After on the refusal.

    The same is expected of every 429 and 503 in all other checks.
    """
    run = story.submit("count", "count", max_workers=1)
    run.worker().attach()
    answer = run.worker().try_attach()
    if answer.status not in (429, 503):
        raise SetUpFailed(f"nothing asked us to wait: {expect.told(answer)}")


@requirement("ERR-012")
def test_err_012_nothing_makes_the_server_fail(story: Story) -> None:
    """Generated requests, valid and broken, to every operation.

    Expect no status of 500 or above except 503, here and in all other checks.
    """
    worker = live_worker(story)
    seconds = 1.0 if story.context.settings.quick else 2.0
    fuzz_operations(worker, until=time.monotonic() + seconds)
    alive = story.call("describe_service")
    expect.ok(alive)


@requirement("ERR-013")
def test_err_013_cannot_send_numbers_that_json_does_not_have(story: Story) -> None:
    """NaN and infinities in JSON; then a number that JSON has.

    Expect `malformed_body` and nothing executed.
    """
    worker = live_worker(story)
    for number in (float("nan"), float("inf"), float("-inf")):
        for name in ("score", "vector"):
            value = [number] * 8 if name == "vector" else [number]
            answer = worker.try_predict(story.action(**{name: value}))
            expect.refused(answer, "malformed_body")
        answer = submit(story, story.submit_body(idle_timeout_s=number))
        expect.refused(answer, "malformed_body")
    nothing_happened(worker)


@requirement("ERR-014")
def test_err_014_cannot_send_parameters_that_break_their_schema(story: Story) -> None:
    """Limits, cursors and headers of the wrong kind; a detach that names no session.

    Expect `invalid_request`; the ends of the range and a whole detach are served.
    """
    run = story.submit()
    worker = run.worker()
    worker.attach()
    nameless = run.call("detach_worker", worker_id=worker.id)
    expect.refused(nameless, "invalid_request")
    worker.detach()
    for operation_id in ("list_runs", "list_episodes"):
        for limit in ("0", "-1", "1001", "ten", "1.5", ""):
            answer = run.call(operation_id, params={"limit": limit})
            expect.refused(answer, "invalid_request")
        for cursor in ("no cursor!", "x" * 129, ""):
            answer = run.call(operation_id, params={"cursor": cursor})
            expect.refused(answer, "invalid_request")
        for limit in ("1", "1000"):
            expect.ok(run.call(operation_id, params={"limit": limit}))
    for wrong in ("wait=soon", "wait=-1", "respond-async"):
        answer = run.call("get_run", headers={"Prefer": wrong})
        expect.refused(answer, "invalid_request")
    expect.ok(run.call("get_run", headers={"Prefer": "wait=0"}))
    longest = uuid.uuid4().hex * 4
    too_long = {"Idempotency-Key": longest + "x"}
    expect.refused(
        submit(story, story.submit_body(), headers=too_long), "invalid_request"
    )
    just_right = {"Idempotency-Key": longest}
    expect.ok(submit(story, story.submit_body(), headers=just_right), 201)
