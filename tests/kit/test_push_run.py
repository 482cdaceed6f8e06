"""The kit and servers that call policies.

Where calls are not allowed, the report has the reason and no violation; the kit's own
policy server obeys the rules of policy servers.
"""

import json
from pathlib import Path
from typing import Any

import jsonschema_rs
import pytest

from conformance.policy import push_run, turn_builder
from conformance.policy.scripted_policy import PolicyCall, ScriptedPolicy, busy_reply
from conformance.specification.document import load_policy_spec, load_spec
from conformance.verdicts.expect import SetUpFailed, Violation
from tests.support.kit.run_kit import run_kit
from tests.support.servers import TOKENS, ReferenceServer

pytestmark = pytest.mark.slow("starts servers and kits")


def test_push_rules_are_not_verified_where_calls_are_not_allowed(
    server: ReferenceServer, tmp_path: Path
) -> None:
    """Its operator has allowed no network: that is right of it."""
    options = ("--url", server.url, "--only", "PUSH,CHAT,SVC-001")
    kit = run_kit(tmp_path, *options, PROCTOR_TOKEN=TOKENS["alice"])
    assert kit.rules_with("passed") == {"SVC-001"}
    assert kit.rules_with("not_verified") == kit.rows.keys() - {"SVC-001"}
    for name in ("PUSH-001", "CHAT-001"):
        assert "refuses policy servers at 127.0.0.1" in kit.rows[name]["reason"]
    assert kit.code == 0, kit.output


class FakeRun:
    """A run in one state for ever."""

    def __init__(self, state: str, **episode: Any) -> None:
        self.body = {"state": state, "reason": "because"}
        self.episode = {"episode_id": "e0000"} | episode

    def get(self) -> dict[str, Any]:
        return self.body

    def episodes(self) -> list[dict[str, Any]]:
        return [self.episode]


def test_a_run_that_never_ends_is_a_violation(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(push_run, "END_TIMEOUT_S", 0.05)
    run: Any = FakeRun("running")
    with pytest.raises(Violation, match="`running` after"):
        push_run.expect_end(run, "completed")
    run = FakeRun("failed")
    with pytest.raises(Violation, match="because"):
        push_run.expect_end(run, "completed")
    assert push_run.expect_end(run, "failed")["state"] == "failed"


def test_a_missing_policy_fault_is_a_violation() -> None:
    silent: Any = FakeRun("running")
    with pytest.raises(Violation, match="policy_fault"):
        push_run.expect_policy_fault(silent, 0.05)
    empty: Any = FakeRun("running", policy_fault="")
    with pytest.raises(Violation, match="a text"):
        push_run.expect_policy_fault(empty)
    reported: Any = FakeRun("running", policy_fault="It said nonsense.")
    assert push_run.expect_policy_fault(reported)["policy_fault"] == "It said nonsense."


@pytest.mark.parametrize(
    ("url", "address"),
    [("http://127.0.0.1:8460", "127.0.0.1"), ("http://localhost", "127.0.0.1")],
)
def test_on_this_machine_the_kit_serves_on_loopback(url: str, address: str) -> None:
    assert push_run.own_address(url) == address


def test_an_unknown_own_address_leaves_the_rules_unverified() -> None:
    with pytest.raises(SetUpFailed, match="no address of this machine") as caught:
        push_run.own_address("https://unknown.invalid")
    assert caught.value.allowed


def test_answers_of_the_kits_policy_fit_the_document() -> None:
    """What a judged server is given must be right, or its faults are ours."""
    benchmark = turn_builder.calibration()
    view = turn_builder.episode(benchmark)
    bodies = {
        "describe_policy": None,
        "reset": {"session_id": "s", "benchmark": benchmark, "episode": view},
        "predict": turn_builder.turn(benchmark, "s", 0, view),
    }
    spec = load_policy_spec()
    with ScriptedPolicy() as policy:
        for operation, body in bodies.items():
            described = spec.operations[operation].description
            if body is not None:
                content = described["requestBody"]["content"]["application/json"]
                jsonschema_rs.validate(content["schema"], body)
            reply = policy.answer(PolicyCall(operation, {}, body, b"", 0.0))
            content = described["responses"]["200"]["content"]["application/json"]
            jsonschema_rs.validate(content["schema"], json.loads(reply.encoded()))
    jsonschema_rs.validate(load_spec().schema("Problem"), busy_reply().body)
