"""Requests that are too large or too slow, and accounts that use too much (LIM).

A server that other accounts use gets what could disturb those only with `--stress`.
"""

import json
import time
import uuid
from functools import partial
from typing import Any

from conformance.checks.support.bodies.invalid_bodies import pad_body
from conformance.checks.support.given_states import submit_and_attach
from conformance.checks.support.operation_samples import (
    attach_live_worker,
    samples_with_body,
    send,
    send_body,
)
from conformance.client.check_context import CheckContext
from conformance.client.connections.raw_connection import Ending, open_raw_connection
from conformance.client.http_client import HttpClient
from conformance.client.run_client import RunClient, WorkerClient
from conformance.exchanges.answer import Answer
from conformance.runner.requirement import background, requirement
from conformance.verdicts import expect
from conformance.verdicts.expect import Inconclusive, NotApplicable, SetUpFailed

# A server may look at its connections now and then only.
MARGIN_S = 5.0
SMALL_HEADER_BYTES = 1000
# A server with longer times or more runs is not judged by these rows.
WAITED_S = 40.0
OPENED_RUNS = 50
STORED_BYTES = 100_000
TASKS_STORED = 300
AS_JSON = {"Content-Type": "application/json"}
PARTS = (b"", b"a")  # of a header that does not end: what is sent now and then


def provoked_limit(context: CheckContext, name: str) -> float:
    """Give a limit that the server announces, if it may be provoked."""
    if not context.shared.settings.stress:
        raise SetUpFailed("not provoked without --stress", allowed=True)
    return announced_limit(context, name)


def announced_limit(context: CheckContext, name: str) -> float:
    """Give a limit that the server announces."""
    limit = context.limits.get(name)
    if limit is None:
        raise NotApplicable(f"the server announces no `limits.{name}`")
    return float(limit)


def expect_ending(is_right: bool, what: str, ending: Ending) -> None:
    """Expect what came back to be right; what has not ended in time is tried again."""
    if not is_right and not ending.is_closed:
        raise expect.missed(what, str(ending))
    expect.true(is_right, what, str(ending))


@requirement("LIM-001")
def test_lim_001_cannot_send_headers_beyond_the_limit(context: CheckContext) -> None:
    """A long header, a long URL and many headers. Expect 400, 414, 431 or a close. A
    header of 1000 bytes is read."""
    size = int(provoked_limit(context, "max_header_bytes"))
    small = {"X-Padding": "a" * SMALL_HEADER_BYTES}
    expect.ok(context.call("describe_service", headers=small))
    for line in (
        ("/v1", f"X-Padding: {'a' * size}"),
        (f"/v1?{'a' * size}", "X-Padding: a"),
        ("/v1", "X-A: a\r\n" * (size // 8) + "X-A: a"),
    ):
        with open_raw_connection(context.http_client.base_url) as connection:
            path, padding = line
            request = connection.head("GET", path, "Connection: close", padding)
            ending = connection.send_until_end(request + b"\r\n")
        is_refused = ending.status in (400, 414, 431)
        is_only_closed = ending.status is None and ending.is_closed
        expect_ending(is_refused or is_only_closed, "400, 414, 431 or a close", ending)


@background
@requirement("LIM-002")
def test_lim_002_cannot_keep_headers_incomplete(context: CheckContext) -> None:
    """A request without the end of its headers, at once and byte by byte. Expect 408 or
    no answer, and a close."""
    limit_s = provoked_limit(context, "header_timeout_s")

    def send_headers(more: bytes) -> Ending:
        with open_raw_connection(context.http_client.base_url) as connection:
            request = connection.head("GET", "/v1") + b"X-Padding: "
            time_s, every_s = limit_s + MARGIN_S, limit_s / 8
            return connection.send_until_end(
                request, time_s, more=more, every_s=every_s
            )

    for ending in context.call_concurrently(*(partial(send_headers, m) for m in PARTS)):
        expect_ending(ending.is_closed, "a closed connection", ending)
        expect.true(ending.status in (408, None), "408 or no answer", str(ending))


@background
@requirement("LIM-003")
def test_lim_003_cannot_keep_a_body_back(context: CheckContext) -> None:
    """A `submit_run` whose body does not come. Expect 408 or a close. With its body,
    the request is answered."""
    limit_s = provoked_limit(context, "body_timeout_s")
    token = context.shared.settings.token
    lines = (
        f"Authorization: Bearer {token}",
        "Content-Type: application/json",
        "Content-Length: 2",
    )
    with open_raw_connection(context.http_client.base_url) as connection:
        request = connection.head("POST", "/v1/runs", *lines, "Connection: close")
        ending = connection.send_until_end(request + b"\r\n{}")
    expect.equal(ending.status, 422, "status of an empty submission")
    with open_raw_connection(context.http_client.base_url) as connection:
        request = connection.head("POST", "/v1/runs", *lines)
        ending = connection.send_until_end(request + b"\r\n", limit_s + MARGIN_S)
    is_only_closed = ending.status is None and ending.is_closed
    expect_ending(ending.status == 408 or is_only_closed, "408 or a close", ending)


def attach_with_short_lease(context: CheckContext) -> WorkerClient:
    lease_s = max(4.0, context.limits["idle_timeout_s_min"], context.least_lease_s)
    lease_s = min(lease_s, context.limits["idle_timeout_s_max"])
    return submit_and_attach(context, "count", idle_timeout_s=lease_s)


def too_late_for(context: CheckContext, lease_s: float) -> str:
    """Say that heartbeats came too late, and what helps if the server chose so."""
    text = f"the kit sent its heartbeats too late for a lease of {lease_s:g} s"
    if lease_s < context.limits["idle_timeout_s_max"]:
        return text
    return f"{text}: announce a longer `idle_timeout_s_max`"


def require_in_time(
    answer: Answer, since: float, lease_s: float, context: CheckContext
) -> None:
    """Require of a refusal that it came before a lease that began then could end."""
    if answer.status != 200 and answer.ended_at > since + lease_s:
        raise Inconclusive(too_late_for(context, lease_s))


@background
@requirement("LIM-006")
def test_lim_006_cannot_live_on_heartbeats_alone(context: CheckContext) -> None:
    """Two workers send heartbeats, of which one also plays a turn now and then; a third
    one repeats its turn. Expect the sessions of the others to end when
    `limits.heartbeat_s_max` has passed since their latest turn."""
    limit_s = announced_limit(context, "heartbeat_s_max")
    if limit_s > WAITED_S:
        raise SetUpFailed(f"`limits.heartbeat_s_max` > {WAITED_S:g} s", allowed=True)
    worker = attach_with_short_lease(context)
    attached_at = time.monotonic()
    repeating = attach_with_short_lease(context)  # may take long
    lease_s = repeating.turn["lease"]["idle_timeout_s"]
    turn_at = sent_at = time.monotonic()
    worker.try_heartbeat()
    played = repeating.try_next()
    if time.monotonic() > attached_at + lease_s:
        raise Inconclusive(too_late_for(context, lease_s))
    expect.require(played, 200, "predict")
    control = attach_with_short_lease(context)
    until = time.monotonic() + limit_s + lease_s + context.tolerance_s
    while sent_at < until:
        earlier, sent_at = sent_at, time.monotonic()
        worker.try_heartbeat()
        repeating.try_predict(context.action(), seq=1)
        control.try_heartbeat()
        if time.monotonic() > earlier + lease_s:
            raise Inconclusive(too_late_for(context, lease_s))
        if sent_at > turn_at + limit_s / 4:
            played = control.try_next()
            require_in_time(played, turn_at, max(limit_s, lease_s), context)
            expect.require(played, 200, "predict")
            turn_at = sent_at
        time.sleep(lease_s / 8)
    expect.refused(worker.try_heartbeat(), "session_ended")
    expect.refused(repeating.try_predict(context.action(), seq=1), "session_ended")
    heard = control.try_heartbeat()
    require_in_time(heard, sent_at, lease_s, context)
    expect.ok(heard)


@requirement("LIM-008")
def test_lim_008_cannot_send_long_control_bodies(context: CheckContext) -> None:
    """Every request with a body but `predict`, one byte longer than the limit, with and
    without a declared length. Expect `body_too_large`; success with a body of the
    limit, and with a `predict` that is longer."""
    limit = int(announced_limit(context, "max_control_body_bytes"))
    if limit >= context.limits["max_body_bytes"]:
        raise NotApplicable("`limits.max_body_bytes` is no higher")
    worker = attach_live_worker(context)
    for sample in samples_with_body(worker):
        at_limit, longer = (
            b"".join(pad_body(sample[1]["json"], size)) for size in (limit, limit + 1)
        )
        answer = send_body(worker, sample, longer)
        if sample[0] == "predict":
            expect.ok(answer)
        else:
            expect.refused(answer, "body_too_large")
            chunked = {"content": [longer[:limit], longer[limit:]], "headers": AS_JSON}
            how = {name: sample[1][name] for name in sample[1] if name != "json"}
            answer = send(worker.run, (sample[0], how | chunked))
            expect.refused(answer, "body_too_large")
            status = 201 if sample[0] == "submit_run" else 200
            expect.ok(send_body(worker, sample, at_limit), status)


@requirement("LIM-007")
def test_lim_007_cannot_open_more_runs_than_announced(context: CheckContext) -> None:
    """An account has as many open runs as it may have. Expect one more, and the resume
    of one that was stopped before, to be refused with `quota_exceeded`; success when
    one of them has been stopped."""
    limit = int(provoked_limit(context, "max_open_runs"))
    if limit > OPENED_RUNS:
        raise SetUpFailed(f"`limits.max_open_runs` exceeds {OPENED_RUNS}", allowed=True)
    account = context.second_account
    stopped = context.submit(wait_ready=False, http_client=account)
    stopped.stop()
    opened = fill_runs(context, account, limit)
    one_more = context.call(
        "submit_run", json=context.submit_body(), http_client=account
    )
    if one_more.status == 201:
        context.adopt(one_more.json, account)
    expect.refused(one_more, "quota_exceeded")
    expect.refused(stopped.call("resume_run"), "quota_exceeded")
    opened[-1].stop()
    expect.ok(stopped.call("resume_run"))


@requirement("LIM-009")
def test_lim_009_cannot_use_more_keys_than_announced(context: CheckContext) -> None:
    """An account has used as many Idempotency-Keys as it may, and stopped those runs.
    Expect a new key to be refused with `quota_exceeded` twice; the run of an old key,
    and a run without a key."""
    limit = int(provoked_limit(context, "max_idempotency_keys"))
    if limit > OPENED_RUNS:
        raise SetUpFailed(
            f"`limits.max_idempotency_keys` exceeds {OPENED_RUNS}", allowed=True
        )
    account, body = context.second_account, context.submit_body()
    used: dict[str, RunClient] = {}
    while len(used) < limit:
        key = uuid.uuid4().hex
        answer = submit_by_key(context, account, body, key)
        if not used:
            require_quota(answer)
        if answer.status != 201:
            break
        used[key] = context.adopt(answer.json, account)
        used[key].stop()
    key = uuid.uuid4().hex
    for _ in range(2):
        one_more = submit_by_key(context, account, body, key)
        if one_more.status == 201:
            context.adopt(one_more.json, account)
        expect.refused(one_more, "quota_exceeded")
    for key, run in used.items():
        again = expect.ok(submit_by_key(context, account, body, key), 201)
        expect.equal(again["run_id"], run.id, "run_id of a used key")
    answer = context.call("submit_run", json=body, http_client=account)
    context.adopt(expect.ok(answer, 201), account)


@requirement("LIM-010")
def test_lim_010_cannot_store_more_than_announced(context: CheckContext) -> None:
    """An account submits runs, and stops them, until their bodies reach the limit.
    Expect one more to be refused with `quota_exceeded`, or one before, for a server may
    count more; and the first run again for its key, if the account had one left."""
    limit = int(provoked_limit(context, "max_stored_bytes"))
    if limit > STORED_BYTES:
        raise SetUpFailed(f"`limits.max_stored_bytes` > {STORED_BYTES}", allowed=True)
    account, key = context.second_account, uuid.uuid4().hex
    body = context.submit_body(options={"tasks": ["score"] * TASKS_STORED})
    size = len(json.dumps(body, separators=(",", ":")))
    first = submit_by_key(context, account, body, key)
    has_key = first.code != "quota_exceeded"
    if not has_key:  # LIM-009 may have used all keys of the account
        first = context.call("submit_run", json=body, http_client=account)
    require_quota(first)
    run = context.adopt(first.json, account)
    for _ in range(limit // size + 1):
        answer = context.call("submit_run", json=body, http_client=account)
        if answer.status != 201:
            break
        context.adopt(answer.json, account).stop()
    expect.refused(answer, "quota_exceeded")
    if has_key:
        again = expect.ok(submit_by_key(context, account, body, key), 201)
        expect.equal(again["run_id"], run.id, "run_id of the first key")


def require_quota(first: Answer) -> None:
    """Fail the set-up if the account has used up its quota, as in an earlier check."""
    if first.code == "quota_exceeded":
        raise SetUpFailed(
            "the second account has used up what it may store: set PROCTOR_TOKEN_2 to "
            "the token of a new account",
            allowed=True,
        )
    if first.status != 201:
        raise SetUpFailed("no run could be submitted")


def submit_by_key(
    context: CheckContext, account: HttpClient, body: Any, key: str
) -> Answer:
    headers = {"Idempotency-Key": key}
    return context.call("submit_run", json=body, headers=headers, http_client=account)


def fill_runs(
    context: CheckContext, account: HttpClient, limit: int
) -> list[RunClient]:
    """Submit as many runs as the account may have beside those of other checks."""
    opened: list[RunClient] = []
    while len(opened) < limit:
        answer = context.call(
            "submit_run", json=context.submit_body(), http_client=account
        )
        if answer.status != 201:
            break
        opened.append(context.adopt(answer.json, account))
    if not opened:
        raise SetUpFailed("no run could be submitted")
    return opened
