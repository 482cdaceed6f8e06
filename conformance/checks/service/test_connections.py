"""Connections that carry requests, and the framing of bodies (SVC)."""

import contextlib
import json
import time
from collections.abc import Iterator, Sequence
from typing import Any

from conformance.checks.support.bodies.invalid_bodies import pad_body
from conformance.checks.support.operation_samples import (
    attach_live_worker,
    operation_samples,
    predict_sample,
    send,
)
from conformance.client.check_context import CheckContext
from conformance.client.http_client import HttpClient, NoAnswer
from conformance.client.run_client import RunClient
from conformance.exchanges.answer import Answer
from conformance.runner.requirement import requirement
from conformance.verdicts import expect
from conformance.verdicts.expect import SetUpFailed

# A body that is a request itself: who leaves it unread answers it next.
INNER_REQUEST = b"GET /v1/no-such-path HTTP/1.1\r\nHost: localhost\r\n\r\n"
JSON_BODY = {"Content-Type": "application/json"}
PIECE_BYTES, PAUSE_S = 7, 0.01
LONGEST_WAIT_S = 5.0
LONG_LETTERS = "é漢😀"


@requirement("SVC-006")
def test_svc_006_kept_connection_holds_no_other(context: CheckContext) -> None:
    """A connection is kept open after its answer; a request comes on another one.
    Expect an answer to it while the first stays open."""
    wait_s = LONGEST_WAIT_S + context.tolerance_s
    with context.own_connection() as kept, context.own_connection() as new:
        for http_client in (kept, new):
            try:
                answer = http_client.request("GET", "/v1", timeout_s=wait_s)
            except NoAnswer as error:
                raise expect.missed(
                    "an answer of `describe_service` on a new connection while the kit "
                    "keeps another one open, without a request",
                    f"{error.observed}; has the server one thread for all connections?",
                ) from error
            expect.ok(answer)


def read_next(run: RunClient, http_client: HttpClient) -> Answer:
    """Read a run; once more if the server has closed the connection meanwhile."""
    try:
        return run.call("get_run", http_client=http_client)
    except NoAnswer:
        return run.call("get_run", http_client=http_client)


@requirement("SVC-004")
def test_svc_004_refusal_leaves_its_connection_in_order(context: CheckContext) -> None:
    """Requests with bodies are refused early; each is followed by a right request.
    Expect the run each time, over the same connection or, if it was closed, another."""
    run = context.submit()
    wrong_token = {"Authorization": "Bearer no-such-token"}
    large = b"".join(pad_body({}, context.limits["max_body_bytes"] + 1))
    refused: list[tuple[str, str, bytes, dict[str, str]]] = [
        ("POST", "/v1/runs", INNER_REQUEST, wrong_token),
        ("POST", f"/v1/runs/{run.id}/resume", INNER_REQUEST, wrong_token),
        ("POST", "/v1/no-such-path", INNER_REQUEST, {}),
        ("PATCH", "/v1/runs", INNER_REQUEST, {}),
        ("POST", "/v1/runs", INNER_REQUEST, {"Content-Type": "text/plain"}),
        ("POST", "/v1/runs", INNER_REQUEST, {"Accept": "text/html"}),
        ("POST", "/v1/runs", INNER_REQUEST, {}),
        ("POST", f"/v1/runs/{run.id}x/stop", INNER_REQUEST, {}),
        ("POST", "/v1/runs", large, {}),
    ]
    with context.own_connection() as http_client:
        for method, path, body, headers in refused:
            with contextlib.suppress(NoAnswer):
                answer = http_client.request(
                    method, path, content=body, headers=JSON_BODY | headers
                )
                if answer.status < 400:
                    raise SetUpFailed(f"a wrong {method} of {path} was accepted")
            answer = read_next(run, http_client)
            expect.equal(expect.ok(answer)["run_id"], run.id, "run_id")


def _with_pauses(pieces: Sequence[bytes]) -> Iterator[bytes]:
    """Give the pieces, with a pause after one that ends inside of a letter.

    Servers read together what arrives together.
    """
    for piece in pieces:
        yield piece
        if piece[-1] >= 0x80:
            time.sleep(PAUSE_S)


@requirement("SVC-005")
def test_svc_005_body_may_come_in_chunks(context: CheckContext) -> None:
    """Every operation with a body gets it in small chunks, without a Content-Length,
    and `predict` one that is as large as it may be. Expect the success that there is
    with one, and the values that were sent."""
    worker = attach_live_worker(context)
    operation_id, how = predict_sample(worker)
    largest = list(pad_body(how["json"], context.limits["max_body_bytes"]))
    how = {name: how[name] for name in how if name != "json"}
    how |= {"content": largest, "headers": JSON_BODY}
    expect.ok(send(worker.run, (operation_id, how)))
    worker.seq += 1
    for operation_id, how in operation_samples(worker):
        if "json" not in how:
            continue
        if operation_id == "submit_run":
            # Letters of several bytes, so that pieces end inside of one.
            how["json"]["policy"]["name"] = LONG_LETTERS * PIECE_BYTES
        text = json.dumps(how["json"], indent=1, ensure_ascii=False).encode()
        pieces = [text[i : i + PIECE_BYTES] for i in range(0, len(text), PIECE_BYTES)]
        chunked: dict[str, Any] = {k: how[k] for k in how if k != "json"}
        chunked |= {"content": _with_pauses(pieces), "headers": JSON_BODY}
        answer = send(worker.run, (operation_id, chunked))
        body = expect.ok(answer, 201 if operation_id == "submit_run" else 200)
        if operation_id == "submit_run":
            expect.equal(body["policy"], how["json"]["policy"], "policy")
        if operation_id == "predict":
            expect.equal(body["executed_steps"], 1, "executed_steps")
