"""Refusals: problems, statuses and headers (ERR)."""

import json
import uuid
from collections.abc import Iterator
from typing import Any

import msgspec

from conformance.checks.support.bodies.invalid_bodies import (
    MALFORMED,
    pad_body,
    unrepresentable_json,
)
from conformance.checks.support.generated.schema_requests import (
    expect_wrong_values_refused,
    send_random_requests,
)
from conformance.checks.support.generated.spelled_requests import (
    ACCEPTED,
    CONTENT_TYPES,
)
from conformance.checks.support.given_states import count
from conformance.checks.support.operation_samples import (
    READ_OPERATIONS,
    attach_live_worker,
    operation_samples,
    predict_sample,
    samples_with_body,
    send,
    send_body,
)
from conformance.checks.support.submissions import NAMES_OF_LANGUAGES, submit
from conformance.client.check_context import CheckContext
from conformance.client.connections.raw_connection import open_raw_connection
from conformance.client.run_client import WorkerClient
from conformance.runner.requirement import from_schema, more_with_minutes, requirement
from conformance.verdicts import expect
from conformance.verdicts.expect import SetUpFailed

MSGPACK = "application/msgpack"
UNLISTED_MEDIA_TYPES = (
    *("text/plain", "application/xml", "application/x-pickle", "application/jsonx"),
    *("application/merge-patch+json", "json"),
)
# Each accepts nothing that an operation answers with.
UNACCEPTABLE = (
    *("text/html, image/png;q=0.5", "application/json;q=0", "application/jso"),
    *("image/*, */*;q=0", "application/json;q=0.000, application/*;q=0.0"),
)
MEGABYTE = 10**6
# Percent signs without digits, and bytes that are not UTF-8.
UNDECODABLE_PATHS = (
    *("/v1/runs/%zz", "/v1/runs/%", "/v1/runs/%ff%fe", "/v1/runs/%c3%28"),
    *("/v1/benchmarks/%e0", "/v1/runs?cursor=%ff", "/v1/runs?limit=%zz"),
)
DEEP = 10**6
_QUICK_LENGTHS = 40
MANY_UNKNOWN = (10, 40)
# Profile → where a submission has a field of it, and such a submission.
_FIELDS_OF_PROFILES: dict[str, tuple[str, dict[str, Any]]] = {
    "attribution": ("/any_policy", {"any_policy": True}),
    "sealed_seeds": ("/options/sealed", {"options": {"sealed": True}}),
    "subsets": ("/select", {"select": {"tasks": ["score"]}}),
}


def expect_nothing_executed(worker: WorkerClient) -> None:
    """Expect that no action was executed since the first one."""
    turn = expect.ok(worker.try_predict(worker.run.context.action()))
    expect.equal(count(turn), [2], "count after the refusals")


@requirement("ERR-001")
def test_err_001_refusals_are_problems(context: CheckContext) -> None:
    """Refusals of many kinds. Expect problems of `x-problems`. The same is expected of
    every refusal in all other checks."""
    worker = attach_live_worker(context)
    text = {"Content-Type": "text/plain"}
    context.call("list_benchmarks", http_client=context.client_with_token(None))
    context.call("get_run", run_id="no-such-run")
    context.http_client.request("GET", "/v1/no-such-path")
    context.http_client.request("PATCH", "/v1/runs")
    context.call("list_benchmarks", headers={"Accept": "text/html"})
    context.call("submit_run", content=b"{}", headers=text)
    context.call("submit_run", content=b"{")
    context.call("submit_run", json={})
    for headers in ({}, {"Accept": MSGPACK} if context.speaks_msgpack else {}):
        if context.serves("predict"):
            worker.try_predict(seq=99, headers=headers)
            worker.try_attach(headers=headers)


@requirement("ERR-002")
def test_err_002_cannot_send_malformed_json(context: CheckContext) -> None:
    """Bodies that are truncated, corrupted or empty, and unrepresentable JSON values; a
    body of MessagePack is truncated at every byte, with `--quick` at some of them.
    Expect `malformed_body` and nothing executed."""
    worker = attach_live_worker(context)
    malformed = [
        *(b"", b"{", b"{'a': 1}", b'{"a": 1,}', b'{"a": 1} {}', b"a"),
        *(b'{"a": 1', b"[1,]", b"{1: 1}", b'{"a" 1}', b'{"a": 1 /* one */}'),
    ]
    for sample in samples_with_body(worker):
        whole = json.dumps(sample[1]["json"]).encode()
        cut = [whole[: context.random.randrange(1, len(whole))] for _ in range(3)]
        for body in malformed + (cut if len(whole) > 2 else []):
            expect.refused(send_body(worker, sample, body), "malformed_body")
        for body, codes in unrepresentable_json(*sample):
            expect.refused_for_one(send_body(worker, sample, body), *codes)
    if context.speaks_msgpack:
        packed = msgspec.msgpack.encode(predict_sample(worker)[1]["json"])
        no_text = packed.replace(worker.session_id.encode()[:2], b"\xc3\x28", 1)
        # Some readers take the first byte of a value for the whole value.
        lengths = list(range(len(packed)))
        if context.shared.settings.quick:
            lengths = context.random.sample(lengths, _QUICK_LENGTHS)
        cut = [packed[:length] for length in lengths]
        for wrong in (*cut, packed + b"\xc0", b"\xc1", no_text):
            how = {"content": wrong, "headers": {"Content-Type": MSGPACK}}
            answer = worker.run.call("predict", worker_id=worker.id, **how)
            is_unknown = wrong is no_text  # the session, too (OPT-041)
            codes = (MALFORMED, "session_ended") if is_unknown else (MALFORMED,)
            expect.refused_for_one(answer, *codes)
    expect_nothing_executed(worker)


@from_schema
@requirement("ERR-003")
def test_err_003_cannot_send_an_unknown_member(context: CheckContext) -> None:
    """An unknown member, at the top of every body and inside it; many of them; members
    of profiles that are not announced. Expect `invalid_request` pointing at it, and
    nothing executed."""
    worker = attach_live_worker(context)
    expect_wrong_values_refused(context)
    for sample in samples_with_body(worker):
        for name in NAMES_OF_LANGUAGES:
            answer = send_body(worker, sample, sample[1]["json"] | {name: 1})
            expect.refused(answer, "invalid_request", pointer=f"/{name}")
        for number in MANY_UNKNOWN:
            many = {f"surprise_{n}": n for n in range(number)}
            answer = send_body(worker, sample, sample[1]["json"] | many)
            expect.refused(answer, "invalid_request")
        # RFC 6901 writes these two signs otherwise.
        answer = send_body(worker, sample, sample[1]["json"] | {"a/b~c/d~": 1})
        expect.refused(answer, "invalid_request", pointer="/a~1b~0c~1d~0")
    assumptions = ({"surprise": 1}, {"action": {"score": {"surprise": 1}}})
    for nested in assumptions if context.offers("conventions") else ():
        pointer = "/assumes" + ("/action/score" if "action" in nested else "")
        answer = worker.run.worker("another").try_attach(assumes=nested)
        expect.refused(answer, "invalid_request", pointer=f"{pointer}/surprise")
    body = context.submit_body(options={"surprise": 1})
    answer = submit(context, body)
    expect.refused(answer, "invalid_request", pointer="/options/surprise")
    for profile, (pointer, members) in _FIELDS_OF_PROFILES.items():
        if not context.offers(profile):
            answer = submit(context, context.submit_body() | members)
            expect.refused(answer, "invalid_request", pointer=pointer)
    another = worker.run.worker("another")
    if not context.offers("attribution"):
        player = {"name": context.submit_body()["policy"]["name"]}
        answer = another.try_attach(player=player)
        expect.refused(answer, "invalid_request", pointer="/player")
    if not context.offers("subsets"):
        answer = another.try_attach(first_episodes=1)
        expect.refused(answer, "invalid_request", pointer="/first_episodes")
    if not context.offers("reasons"):
        expect_reasons_refused(worker)
    expect_nothing_executed(worker)


def expect_reasons_refused(worker: WorkerClient) -> None:
    """Send the members of the profile `reasons`, which is not announced."""
    answers = [worker.run.call("stop_run", json={"reason": "a reason"})]
    if worker.run.context.serves("heartbeat"):
        answers.append(worker.try_heartbeat(reason="a reason"))
    for answer in answers:
        expect.refused(answer, "invalid_request", pointer="/reason")


@requirement("ERR-021")
def test_err_021_ids_differ_in_capital_letters(context: CheckContext) -> None:
    """Ids of runs, benchmarks and workers in the other letters. Expect refusals of what
    there is not, and two workers with two sessions."""
    run = context.submit("count", "count", max_workers=context.worker_count(2))
    for operation_id, name, value in (
        ("get_run", "run_id", run.id),
        ("get_benchmark", "benchmark_id", "calibration"),
    ):
        right: dict[str, Any] = {name: value}
        if value.swapcase() != value:
            wrong: dict[str, Any] = {name: value.swapcase()}
            answer = context.call(operation_id, **wrong)
            is_unknown = answer.code in ("not_found", "invalid_request")
            expect.true(is_unknown, f"a refusal of another {name}", answer.status)
        expect.ok(context.call(operation_id, **right))
    lower, upper = run.worker("worker-a"), run.worker("WORKER-A")
    lower.attach()
    if context.worker_count(2) > 1:
        answer = upper.try_attach()
        is_other = answer.code != "worker_busy"
        expect.true(is_other, "another worker", answer.code)
        session_id = expect.require(answer, 200, "attach_worker")["session_id"]
        expect.true(session_id != lower.session_id, "two sessions", session_id)


@from_schema
@requirement("ERR-004")
def test_err_004_cannot_send_a_member_of_the_wrong_type(context: CheckContext) -> None:
    """Each value of each body is replaced by values of every other type; in
    MessagePack, bytes for a string. Expect `invalid_request` pointing at the member,
    and nothing executed."""
    worker = attach_live_worker(context)
    expect_wrong_values_refused(context)
    if context.speaks_msgpack:
        as_bin = worker.session_id.encode()
        answer = worker.try_predict(context.action(), session_id=as_bin, msgpack=True)
        expect.refused(answer, "invalid_request", pointer="/session_id")
    expect_nothing_executed(worker)


@requirement("ERR-005")
def test_err_005_cannot_send_too_large_a_body(context: CheckContext) -> None:
    """Bodies of 100 MB streamed, of one byte more than the limit, and of the limit.
    Expect `body_too_large` for the first two, with and without a declared length, and
    of every operation for the second; `predict` gets it both ways. The limit of
    operations other than `predict` may be lower."""
    limit = context.limits["max_body_bytes"]
    as_json = {"Content-Type": "application/json"}
    largest = limit + 1 if context.shared.settings.quick else 100 * MEGABYTE
    for size in sorted({limit + 1, max(largest, limit + 1)}):
        for headers in (as_json, as_json | {"Content-Length": str(size)}):
            stream = pad_body(context.submit_body(), size)
            answer = context.call("submit_run", content=stream, headers=headers)
            expect.refused(answer, "body_too_large")
    worker = attach_live_worker(context)
    declared = {"Content-Length": str(limit + 1)}
    for sample in samples_with_body(worker):
        large = b"".join(pad_body(sample[1]["json"], limit + 1))
        answer = send_body(
            worker, (sample[0], sample[1] | {"headers": declared}), large
        )
        expect.refused(answer, "body_too_large")
    operation_id, how = predict = predict_sample(worker)
    how = {key: value for key, value in how.items() if key != "json"}
    how |= {"content": pad_body(predict[1]["json"], limit + 1), "headers": as_json}
    expect.refused(send(worker.run, (operation_id, how)), "body_too_large")
    at_limit = b"".join(pad_body(predict[1]["json"], limit))
    expect.ok(send_body(worker, predict, at_limit))
    lower = min(limit, context.limits.get("max_control_body_bytes", limit))
    at_limit = b"".join(pad_body(context.submit_body(), lower))
    answer = context.call("submit_run", content=at_limit, headers=as_json)
    context.adopt(expect.ok(answer, 201))


@requirement("ERR-006")
def test_err_006_cannot_send_a_body_a_million_deep(context: CheckContext) -> None:
    """Lists in lists, a million deep, complete and truncated, alone and in a member.
    Expect `malformed_body`, or beyond the limit `body_too_large`; with a depth of three
    `invalid_request`."""
    worker = attach_live_worker(context)
    limit = context.limits["max_body_bytes"]
    predict = predict_sample(worker)
    for opening, closing in ((b"[", b"]"), (b"[", b""), (b'{"a":', b"")):
        deep = opening * DEEP + (b"1" + closing * DEEP if closing else b"")
        for body in (deep, b'{"seq":' + deep + b"}" * bool(closing)):
            answer = send_body(worker, predict, body)
            is_too_large = answer.code == "body_too_large" and len(body) > limit
            code = "body_too_large" if is_too_large else "malformed_body"
            expect.refused(answer, code)
    if context.speaks_msgpack:
        deep, packed = b"\x91" * DEEP + b"\xc0", {"Content-Type": MSGPACK}
        how = {"worker_id": worker.id, "content": deep, "headers": packed}
        answer = worker.run.call("predict", **how)
        is_too_large = answer.code == "body_too_large" and limit <= DEEP
        expect.refused(answer, "body_too_large" if is_too_large else "malformed_body")
    shallow = send_body(worker, predict, {"seq": [[[1]]]})
    if shallow.code != "invalid_request":
        observed = expect.describe_answer(shallow)
        raise SetUpFailed(f"a depth of three must be `invalid_request`: {observed}")
    expect_nothing_executed(worker)


@requirement("ERR-007")
def test_err_007_cannot_send_another_media_type(context: CheckContext) -> None:
    """Valid bodies with media types that the operation does not list. Expect
    `unsupported_media_type` and nothing executed; JSON works in every spelling."""
    worker = attach_live_worker(context)
    operations = context.spec.operations
    for operation_id, how in samples_with_body(worker):
        listed = operations[operation_id].request_media_types()
        for media_type in UNLISTED_MEDIA_TYPES:
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
    for content_type in CONTENT_TYPES:
        spelled = {"Content-Type": content_type}
        expect.ok(submit(context, context.submit_body(), headers=spelled), 201)
    expect_nothing_executed(worker)


@requirement("ERR-008")
def test_err_008_cannot_ask_for_another_media_type(context: CheckContext) -> None:
    """`Accept` with media types that an operation does not list, and with all but
    those that it lists; then a listed one, in every spelling; with `--quick` for half
    of the operations. Expect `not_acceptable` and nothing executed, then success; a
    detach, which has a response without a body, is executed, as a deletion would be."""
    worker = attach_live_worker(context)
    samples = list(operation_samples(worker))
    if context.shared.settings.quick:
        samples = context.random.sample(samples, -(-len(samples) // 2))
    for operation_id, how in samples:
        if operation_id in ("detach_worker", "delete_run", "delete_import"):
            continue
        for accept in UNACCEPTABLE:
            answer = worker.run.call(operation_id, headers={"Accept": accept}, **how)
            expect.refused(answer, "not_acceptable")
        if operation_id in READ_OPERATIONS:
            listed = context.spec.operations[operation_id].answer_media_types()
            excluded = ", ".join(f"{listed_type};q=0" for listed_type in listed)
            spelled = excluded.replace(";q=0", " ; Q=0.000")
            for accept in (
                *(MSGPACK, f"{excluded}, */*", f"*/*;q=0.5, {excluded}"),
                f"{spelled}, */*",
            ):
                how_read = how | {"headers": {"Accept": accept}}
                answer = worker.run.call(operation_id, **how_read)
                expect.refused(answer, "not_acceptable")
            mixed = {"Accept": f"text/html, {listed[0]};q=0.1"}
            expect.ok(worker.run.call(operation_id, headers=mixed, **how))
    expect_nothing_executed(worker)
    for accept in ACCEPTED:
        expect.ok(worker.run.call("get_run", headers={"Accept": accept}))
    expect_lines_of_accept_joined(worker)
    only_problems = {"Accept": "application/problem+json"}
    detached = worker.run.call(
        "detach_worker",
        worker_id=worker.id,
        params={"session_id": worker.session_id},
        headers=only_problems,
    )
    expect.ok(detached, 204)


def expect_lines_of_accept_joined(worker: WorkerClient) -> None:
    """Expect several lines of Accept to be one list, in whatever order they come."""
    context = worker.run.context
    authorization = f"Authorization: Bearer {context.shared.settings.token}"
    path = f"/v1/runs/{worker.run.id}"
    for types in (("text/html", "application/json"), ("application/json", "text/css")):
        lines = [f"Accept: {media_type}" for media_type in types]
        with open_raw_connection(context.http_client.base_url) as connection:
            request = connection.head(
                "GET", path, authorization, *lines, "Connection: close"
            )
            ending = connection.send_until_end(request + b"\r\n")
        expect.equal(ending.status, 200, f"status with the lines {lines}")


@requirement("ERR-009")
def test_err_009_unknown_paths_are_not_found(context: CheckContext) -> None:
    """Paths that are not in the specification, and the longer and larger ones. Expect
    `not_found`."""
    run = context.submit()
    run_path, many = f"/v1/runs/{run.id}", "/v1/benchmarks"
    # With a slash at the end, a segment at the end, or capital letters.
    near = [
        *("/v1/", f"{many}/", f"{many}/calibration/", f"{run_path}/"),
        f"{run_path}/score/",
    ]
    near += [
        *("/v1/runs/", f"{run_path}/score/x", f"{run_path}/Score", "/v1/Runs"),
        "/V1/runs",
    ]
    paths = [
        *near,
        "/v2",
        "/v1/nothing",
        f"/v1/{uuid.uuid4().hex}",
        "/v1/runs/nothing/at/all",
    ]
    paths += [f"{run_path}/{name}" for name in ("nothing", "workers")]
    for path in paths:
        for method in ("GET", "POST"):
            expect.refused(context.http_client.request(method, path), "not_found")
    expect.ok(context.http_client.request("GET", f"/v1/runs/{run.id}"))


def wrong_methods(
    worker: WorkerClient,
) -> Iterator[tuple[str, str, set[str], set[str]]]:
    """Give the template and URL of each path, its methods and those that it lacks."""
    context = worker.run.context
    names = {"run_id": worker.run.id, "worker_id": worker.id}
    names |= {"benchmark_id": "calibration", "episode_id": "e0000"}
    names |= {"import_id": "imp_none", "entry_id": "ent_none"}
    methods_of: dict[str, set[str]] = {}
    base_of: dict[str, str] = {}
    for operation in context.spec.operations.values():
        if not context.offers(operation.profile):
            continue
        methods_of.setdefault(operation.path, set()).add(operation.method)
        base_of[operation.path] = worker.run.base_url_of(operation)
    for template, methods in methods_of.items():
        lacking = {"GET", "PUT", "POST", "DELETE", "PATCH"} - methods
        yield template, base_of[template] + template.format(**names), methods, lacking


@requirement("ERR-010")
def test_err_010_cannot_use_other_methods(context: CheckContext) -> None:
    """Every path is requested with every method that it does not have. Expect
    `method_not_allowed`."""
    worker = attach_live_worker(context)
    for _, url, _, lacking in wrong_methods(worker):
        for method in lacking:
            answer = context.http_client.request(method, url)
            expect.refused(answer, "method_not_allowed")
    expect_nothing_executed(worker)


@requirement("ERR-022")
def test_err_022_refused_method_names_those_of_its_path(context: CheckContext) -> None:
    """Every path is requested with a method that it does not have. Expect an Allow
    header with its methods."""
    worker, http_client = attach_live_worker(context), context.http_client
    for template, url, methods, _ in wrong_methods(worker):
        answer = http_client.request("PATCH", url)
        if answer.status != 405:
            text = expect.describe_answer(answer)
            raise SetUpFailed(f"PATCH of {template} is no 405, see ERR-010: {text}")
        allow_header = answer.headers.get("allow", "")
        allowed = {name.strip().upper() for name in allow_header.split(",")} - {""}
        named = sorted(allowed - {"HEAD", "OPTIONS"})
        expect.equal(named, sorted(methods), f"Allow of {template}")


@requirement("ERR-011")
def test_err_011_refusals_to_wait_have_retry_after(context: CheckContext) -> None:
    """A second worker attaches with `max_workers` 1. Expect Retry-After on the refusal.
    The same is expected of every 429 and 503 in all other checks."""
    run = context.submit("count", "count", max_workers=1)
    run.worker().attach()
    answer = run.worker().try_attach()
    if answer.status not in (429, 503):
        raise SetUpFailed(f"no 429 or 503: {expect.describe_answer(answer)}")


@from_schema
@requirement("ERR-012")
@more_with_minutes
def test_err_012_no_request_causes_a_server_error(context: CheckContext) -> None:
    """Random requests, which keep their schema or break it, are sent to every
    operation, and paths and parameters that cannot be decoded as text. Expect no status
    of 500 or above except 503, here and in all other checks."""
    token = context.shared.settings.token
    lines = (f"Authorization: Bearer {token}", "Connection: close")
    for path in UNDECODABLE_PATHS:
        with open_raw_connection(context.http_client.base_url) as connection:
            request = connection.head("GET", path, *lines)
            ending = connection.send_until_end(request + b"\r\n")
        status = ending.status or 0
        is_right = status < 500 or status == 503
        expect.true(is_right, f"no server error for GET {path}", f"status {status}")
    send_random_requests(context, 12)
    expect.ok(context.call("describe_service"))


@requirement("ERR-013")
def test_err_013_cannot_send_numbers_unknown_to_json(context: CheckContext) -> None:
    """NaN and infinities in JSON; then a number that JSON has. Expect `malformed_body`
    and nothing executed."""
    worker = attach_live_worker(context)
    for number in (float("nan"), float("inf"), float("-inf")):
        answer = worker.try_predict(context.action(vector=[number] * 8))
        expect.refused(answer, MALFORMED)
        # These are outside their ranges, too (OPT-041).
        answer = worker.try_predict(context.action(score=number))
        expect.refused_for_one(answer, MALFORMED, "invalid_request")
        answer = submit(context, context.submit_body(max_workers=number))
        expect.refused_for_one(answer, MALFORMED, "invalid_request")
    expect_nothing_executed(worker)
