"""Runs that the server plays by calling a policy: defaults, restarts, a lost key.

Workers that attach, stops and unreachable policies are judged by the kit
(tests/kit/test_reference_server.py).
"""

import json
import re
import signal
import threading
from collections.abc import Iterator
from pathlib import Path

import httpx
import pytest

from conformance.policy.scripted_policy import PolicyCall, PolicyReply, ScriptedPolicy
from reference_server.generated import models
from reference_server.http.codec import validate
from tests.support.paths import ROOT
from tests.support.push_runs import (
    ALLOW_LOOPBACK,
    episodes,
    push_submission,
    submit_push_run,
    wait_for_state,
)
from tests.support.servers import TIMEOUT_S, ReferenceServer

pytestmark = pytest.mark.slow("starts servers or kits")


@pytest.fixture
def policy() -> Iterator[ScriptedPolicy]:
    with ScriptedPolicy(score=0.25) as server:
        yield server


def test_omitted_policy_server_settings_get_defaults(
    client: httpx.Client, policy: ScriptedPolicy
) -> None:
    body = push_submission(policy.url + "/", max_workers=5)
    for name in ("call_timeout_s", "max_retries"):
        del body["policy_server"][name]
    run = client.post("/v1/runs", json=body).json()
    shown = run["policy_server"]
    assert shown["call_timeout_s"] == 30.0
    assert (shown["max_concurrent"], shown["max_retries"]) == (5, 3)
    assert wait_for_state(client, run["run_id"])["state"] == "completed"


def test_the_example_request_of_the_page_is_valid() -> None:
    page = (ROOT / "docs" / "evaluate" / "policies" / "push.md").read_text()
    (example,) = re.findall(r"```json\n(.*?)```", page, re.DOTALL)
    asked = json.loads(example)
    asked["policy_server"]["api_key"] = "sesame"
    validate(models.SubmitRun, asked)
    left_out = models.PolicyServer.model_fields.keys() - asked["policy_server"].keys()
    assert left_out == {"model", "generation"}  # of the other protocol


def hold_predict(policy: ScriptedPolicy) -> threading.Event:
    """Let predict wait for the event that is returned."""
    may_continue = threading.Event()

    def wait(call: PolicyCall) -> PolicyReply:
        may_continue.wait(TIMEOUT_S)
        return policy.final_action_reply(call)

    policy.on("predict", wait)
    return may_continue


@pytest.mark.parametrize("number", [signal.SIGKILL, signal.SIGTERM])
def test_a_restarted_server_continues_with_the_stored_key(
    tmp_path: Path, policy: ScriptedPolicy, number: signal.Signals
) -> None:
    server = ReferenceServer(tmp_path, **ALLOW_LOOPBACK)
    may_continue = hold_predict(policy)
    with server.client() as client:
        order = {"api_key": "sesame", "max_concurrent": 1}
        run_id = submit_push_run(client, policy.url, "score", "score", **order)
    assert policy.wait_for("predict")
    server.end(number)
    may_continue.set()
    server.start()
    with server.client() as client:
        run = wait_for_state(client, run_id)
        assert (run["state"], run["reason"]) == ("completed", None)
        results = [e["result"] for e in episodes(client, run_id)]
        assert [r["attempt"] for r in results] == [1, 1]
    assert {c.headers["authorization"] for c in policy.calls} == {"Bearer sesame"}
    server.end(signal.SIGKILL)
    assert server.log() == ""
    files = [path for path in tmp_path.rglob("*") if path.is_file()]
    kept = b"".join(path.read_bytes() for path in files)
    assert policy.url.encode() in kept
    assert b"sesame" not in kept
    assert (tmp_path / "proctor.sqlite.key").stat().st_mode & 0o777 == 0o600


def test_a_lost_encryption_key_fails_the_run(
    tmp_path: Path, policy: ScriptedPolicy
) -> None:
    server = ReferenceServer(tmp_path, **ALLOW_LOOPBACK)
    hold_predict(policy)
    with server.client() as client:
        run_id = submit_push_run(client, policy.url, api_key="sesame")
    assert policy.wait_for("predict")
    server.end(signal.SIGKILL)
    (tmp_path / "proctor.sqlite.key").unlink()
    server.start()
    with server.client() as client:
        run = wait_for_state(client, run_id)
        resumed = client.post(f"/v1/runs/{run_id}/resume")
    assert (run["state"], run["retryable"]) == ("failed", False)
    assert run["failed_by"] == "server"
    assert "Submit the run again" in run["reason"]
    assert resumed.json()["code"] == "illegal_transition"
    server.end(signal.SIGKILL)
