"""Requests that are too large or too slow for the HTTP layer (LIM).

A server that other accounts use gets them only with `--stress`.
"""

from conformance.client.check_context import CheckContext
from conformance.client.raw_connection import open_raw_connection
from conformance.runner.requirement import background, requirement
from conformance.verdicts import expect
from conformance.verdicts.expect import NotApplicable, SetUpFailed

# A server may look at its connections now and then only.
MARGIN_S = 5.0
READ_TIMEOUT_S = 10.0
SMALL_HEADER_BYTES = 1000


def announced_limit(context: CheckContext, name: str) -> float:
    """Give a limit that the server announces, if it may be provoked."""
    if not context.shared.settings.stress:
        raise SetUpFailed("not provoked without --stress", allowed=True)
    limit = context.limits.get(name)
    if limit is None:
        raise NotApplicable(f"the server announces no `limits.{name}`")
    return float(limit)


@requirement("LIM-001")
def test_lim_001_cannot_send_headers_beyond_the_limit(context: CheckContext) -> None:
    """A long header, a long URL and many headers. Expect 400, 414, 431 or a close.

    A header of 1000 bytes is read.
    """
    size = int(announced_limit(context, "max_header_bytes"))
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
    limit_s = announced_limit(context, "header_timeout_s")
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
    limit_s = announced_limit(context, "body_timeout_s")
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
