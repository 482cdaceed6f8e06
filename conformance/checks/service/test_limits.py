"""Requests that are too large or too slow, and accounts that use too much (LIM).

A server that other accounts use gets what could disturb those only with `--stress`.
"""

import time

from conformance.client.check_context import CheckContext
from conformance.client.http_client import HttpClient
from conformance.client.raw_connection import open_raw_connection
from conformance.client.run_client import RunClient, WorkerClient
from conformance.runner.requirement import background, requirement
from conformance.verdicts import expect
from conformance.verdicts.expect import Inconclusive, NotApplicable, SetUpFailed

# A server may look at its connections now and then only.
MARGIN_S = 5.0
READ_TIMEOUT_S = 10.0
SMALL_HEADER_BYTES = 1000
# A server with longer times or more runs is not judged by these rows.
WAITED_S = 40.0
OPENED_RUNS = 50


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


@requirement("LIM-001")
def test_lim_001_cannot_send_headers_beyond_the_limit(context: CheckContext) -> None:
    """A long header, a long URL and many headers. Expect 400, 414, 431 or a close.

    A header of 1000 bytes is read.
    """
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
            ending = connection.send_until_end(request + b"\r\n", READ_TIMEOUT_S)
        is_refused = ending.status in (400, 414, 431)
        is_only_closed = ending.status is None and ending.is_closed
        expect.true(
            is_refused or is_only_closed, "400, 414, 431 or a close", str(ending)
        )


@background
@requirement("LIM-002")
def test_lim_002_cannot_keep_headers_incomplete(context: CheckContext) -> None:
    """A request without the end of its headers. Expect 408 or none, and a close."""
    limit_s = provoked_limit(context, "header_timeout_s")
    with open_raw_connection(context.http_client.base_url) as connection:
        request = connection.head("GET", "/v1")
        ending = connection.send_until_end(request, limit_s + MARGIN_S)
    expect.true(ending.is_closed, "a closed connection", str(ending))
    expect.true(ending.status in (408, None), "408 or no answer", str(ending))


@background
@requirement("LIM-003")
def test_lim_003_cannot_keep_a_body_back(context: CheckContext) -> None:
    """A `submit_run` whose body does not come. Expect 408 or a close.

    With its body, the request is answered.
    """
    limit_s = provoked_limit(context, "body_timeout_s")
    token = context.shared.settings.token
    lines = (
        f"Authorization: Bearer {token}",
        "Content-Type: application/json",
        "Content-Length: 2",
    )
    with open_raw_connection(context.http_client.base_url) as connection:
        request = connection.head("POST", "/v1/runs", *lines, "Connection: close")
        ending = connection.send_until_end(request + b"\r\n{}", READ_TIMEOUT_S)
    expect.equal(ending.status, 422, "status of an empty submission")
    with open_raw_connection(context.http_client.base_url) as connection:
        request = connection.head("POST", "/v1/runs", *lines)
        ending = connection.send_until_end(request + b"\r\n", limit_s + MARGIN_S)
    is_only_closed = ending.status is None and ending.is_closed
    expect.true(ending.status == 408 or is_only_closed, "408 or a close", str(ending))


def attach_with_short_lease(context: CheckContext) -> WorkerClient:
    lease_s = max(4.0, context.limits["idle_timeout_s_min"], 8 * context.tolerance_s)
    worker = context.submit("count", idle_timeout_s=lease_s).worker()
    worker.attach()
    return worker


@background
@requirement("LIM-006")
def test_lim_006_cannot_live_on_heartbeats_alone(context: CheckContext) -> None:
    """Two workers send heartbeats, of which one also plays a turn now and then.

    Expect the session of the other one to end when `limits.heartbeat_s_max` has passed
    since its turn 0.
    """
    limit_s = announced_limit(context, "heartbeat_s_max")
    if limit_s > WAITED_S:
        raise SetUpFailed(
            f"`limits.heartbeat_s_max` is longer than {WAITED_S:g} s", allowed=True
        )
    control = attach_with_short_lease(context)
    worker = attach_with_short_lease(context)
    lease_s = worker.turn["lease"]["idle_timeout_s"]
    sent_at = turn_at = time.monotonic()
    until = sent_at + limit_s + lease_s + context.tolerance_s
    while sent_at < until:
        control.try_heartbeat()
        worker.try_heartbeat()
        if time.monotonic() > turn_at + limit_s / 4:
            control.predict(context.action())
            turn_at = time.monotonic()
        if time.monotonic() > sent_at + lease_s / 2:
            raise Inconclusive("the kit sent its heartbeats too late")
        time.sleep(lease_s / 8)
        sent_at = time.monotonic()
    expect.refused(worker.try_heartbeat(), "session_ended")
    expect.ok(control.try_heartbeat())


@requirement("LIM-007")
def test_lim_007_cannot_open_more_runs_than_announced(context: CheckContext) -> None:
    """An account has as many open runs as it may have.

    Expect one more, and the resume of one that was stopped before, to be refused with
    `quota_exceeded`; success when one of them has been stopped.
    """
    limit = int(provoked_limit(context, "max_open_runs"))
    if limit > OPENED_RUNS:
        raise SetUpFailed(
            f"`limits.max_open_runs` is more than {OPENED_RUNS}", allowed=True
        )
    account = context.second_account
    stopped = context.submit(wait_ready=False, http_client=account)
    stopped.stop()
    opened = open_runs(context, account, limit)
    one_more = context.call(
        "submit_run", json=context.submit_body(), http_client=account
    )
    if one_more.status == 201:
        context.adopt(one_more.json, account)
    expect.refused(one_more, "quota_exceeded")
    expect.refused(stopped.call("resume_run"), "quota_exceeded")
    opened[-1].stop()
    expect.ok(stopped.call("resume_run"))


def open_runs(
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
