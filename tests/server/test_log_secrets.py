"""No secret of a request is logged, at any level and in either form."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path

import httpx
import pytest

from tests.support.kit.endless_answers import serve_parts
from tests.support.push_runs import ALLOW_LOOPBACK, submit_push_run, wait_for_state
from tests.support.server.http_runs import predict_body, submit, worker_path
from tests.support.servers import TOKENS, ReferenceServer
from tests.support.waiting import wait_until

API_KEY = "api-key-of-the-policy-server"
ATTACH_KEY = "attach-key-that-resumes-the-session"
OTHER_TOKEN = "token-of-another-server"
IN_QUERY = "token-in-a-query"
LAST_ID = "the-last-request"


def echoed_key() -> Iterator[bytes]:
    """The answer of a policy server that shows what it was sent, in a problem."""
    body = json.dumps({"code": "bad", "detail": f"Bearer {API_KEY}"}).encode()
    yield b"HTTP/1.1 403 Forbidden\r\nContent-Type: application/problem+json\r\n"
    yield b"Content-Length: %d\r\n\r\n%b" % (len(body), body)


def play_and_detach(client: httpx.Client) -> list[str]:
    """Every operation of a session; returns its secrets."""
    run_id = submit(client, "score")
    path = worker_path(run_id)
    turn = client.put(path, json={"attach_key": ATTACH_KEY}).json()
    session = {"session_id": turn["session_id"]}
    client.post(f"{path}/predict", json=predict_body(turn, score=0.5))
    client.post(f"{path}/heartbeat", json=session)
    client.delete(path, params=session)
    return [turn["session_id"], ATTACH_KEY]


@pytest.mark.slow("starts servers")
@pytest.mark.parametrize("form", ["text", "json"])
def test_no_secret_is_logged(tmp_path: Path, form: str) -> None:
    with (
        serve_parts(echoed_key) as policy,
        ReferenceServer(
            tmp_path,
            PROCTOR_LOG_LEVEL="trace",
            PROCTOR_LOG_FORMAT=form,
            PROCTOR_ACCESS_LOG="on",
            **ALLOW_LOOPBACK,
        ) as server,
        server.client() as client,
    ):
        secrets = play_and_detach(client)
        pushed = submit_push_run(client, policy, api_key=API_KEY)
        assert wait_for_state(client, pushed)["state"] == "failed"
        for account in ("bob", "reader"):
            with server.client(account) as other:
                other.get(f"/v1/runs/{pushed}")
        other_token = {"Authorization": f"Bearer {OTHER_TOKEN}"}
        assert client.get("/v1/runs", headers=other_token).status_code == 401
        assert client.get("/v1/runs", params={"token": IN_QUERY}).status_code == 422
        client.post("/pages/login", data={"token": TOKENS["alice"]})
        client.get("/v1", headers={"X-Request-Id": LAST_ID})
        wait_until(lambda: f"/v1/runs/{pushed}" in server.log(), "requests are logged")
        wait_until(lambda: LAST_ID in server.log(), "all are logged")
        log = server.log()
    secrets += [API_KEY, OTHER_TOKEN, IN_QUERY, *TOKENS.values()]
    assert [secret for secret in secrets if secret in log] == []
