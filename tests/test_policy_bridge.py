"""This client asks a policy server: the same turns, in the other direction."""

import json
import threading
from typing import Any

import pytest

from conformance.policy.scripted import (
    PolicyCall,
    PolicyReply,
    ScriptedPolicy,
    busy_reply,
)
from reference_client import ProctorError, evaluate
from reference_client.policies.policy_server import PolicyServerClient
from tests.conftest import TOKENS, House
from tests.policy_parts import an_app, free_port, house, its_key, proctor
from tests.policy_parts import serving as served
from tests.push_parts import submitted, until

__all__ = ["house", "its_key"]


def evaluated(house: House, url: str, *tasks: str, **members: Any) -> Any:
    return evaluate(
        PolicyServerClient(url, patience_s=2.0),
        url=house.url,
        token=TOKENS["alice"],
        benchmark="calibration",
        options={"tasks": list(tasks), **members},
        workers=2,
        progress=lambda _: None,
    )


def test_a_policy_server_is_evaluated_by_this_client(house: House) -> None:
    with served(an_app().app) as url:
        score = evaluated(house, url, *["score"] * 3)
    assert score.score == pytest.approx(0.3)


def test_the_same_turns_come_in_both_directions(house: House) -> None:
    """What a policy is asked by this client is what a server asks it."""
    asked: list[list[dict[str, Any]]] = []
    for direction in ("pull", "push"):
        with ScriptedPolicy() as policy, house.client() as client:
            if direction == "pull":
                evaluated(house, policy.url, "echo")
            else:
                until(client, submitted(client, policy.url, "echo"))
            bodies = [c.body for c in policy.calls if c.body is not None]
            asked.append([_timeless(body) for body in bodies])
    assert asked[0] == asked[1]
    assert len(asked[0]) == 2


def _timeless(body: dict[str, Any]) -> dict[str, Any]:
    volatile = ("session_id", "run_id", "timing", "lease", "benchmark")
    spaces = body.get("benchmark", {}).get("action_space")
    kept = {name: value for name, value in body.items() if name not in volatile}
    return kept | {"spaces": spaces}


def test_a_call_that_was_not_answered_is_made_again(house: House) -> None:
    turned_away = threading.Event()

    def once(call: PolicyCall) -> PolicyReply:
        if turned_away.is_set():
            return policy.final_action_reply(call)
        turned_away.set()
        return busy_reply()

    with ScriptedPolicy() as policy:
        policy.on("predict", once)
        assert evaluated(house, policy.url, "score").score == 0.5


@pytest.mark.parametrize(
    ("operation", "reply", "said"),
    [
        ("describe_policy", PolicyReply({}), "does not describe itself"),
        ("describe_policy", PolicyReply(b"no"), "no JSON"),
        ("describe_policy", PolicyReply([]), "no object"),
        ("describe_policy", PolicyReply(b"", 404), "status 404"),
        ("reset", PolicyReply({"session_id": "x"}), "another reset"),
        ("predict", PolicyReply({"session_id": "x", "seq": 1}), "another turn"),
        ("predict", PolicyReply(b"", 302, {"Location": "/"}), "status 302"),
        ("predict", PolicyReply({"detail": "Too\nhot."}, 400), "Too\nhot."),
    ],
)
def test_what_a_policy_server_does_wrong_is_told(
    house: House, operation: str, reply: PolicyReply, said: str
) -> None:
    with ScriptedPolicy() as policy:
        policy.on(operation, lambda _: reply)
        with pytest.raises(ProctorError, match=said) as caught:
            evaluated(house, policy.url, "score")
    assert caught.value.code == "policy_failed"


def test_actions_that_are_none_are_told(house: House) -> None:
    with ScriptedPolicy() as policy:

        def nothing(call: PolicyCall) -> PolicyReply:
            body = dict(policy.actions_reply(call).body)
            return PolicyReply(body | {"actions": [7]})

        policy.on("predict", nothing)
        with pytest.raises(ProctorError, match="answered without actions"):
            evaluated(house, policy.url, "score")


def test_a_policy_server_that_is_not_there_is_told_before_there_is_a_run(
    house: House,
) -> None:
    with pytest.raises(ProctorError, match="does not answer"):
        evaluated(house, f"http://127.0.0.1:{free_port()}", "score")


def test_the_command_asks_a_policy_server(house: House) -> None:
    with served(an_app().app) as url:
        done = proctor(house, "--policy-url", url, "--benchmark", "calibration")
    assert done.returncode == 0, done.stderr
    assert "0.3" in done.stdout


def test_the_command_has_a_server_play_the_run(house: House) -> None:
    with served(an_app().app) as url, house.client() as client:
        words = ["--benchmark", "calibration", "--push", url, "--json"]
        done = proctor(house, *words, command="submit")
        assert done.returncode == 0, done.stderr
        run = until(client, json.loads(done.stdout)["run_id"])
        assert (run["state"], run["mode"]) == ("completed", "push")
        assert run["policy_server"]["has_api_key"]


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["--policy", "proctor:host:1"], "takes a URL"),
        (["--policy-url", "http://h", "--policy", "a:b"], "both"),
        (["--policy-url", "http://h", "--processes"], "--processes"),
    ],
)
def test_the_command_refuses_what_cannot_be_meant(
    house: House, words: list[str], said: str
) -> None:
    done = proctor(house, "--benchmark", "calibration", *words)
    assert done.returncode == 2
    assert said in done.stderr
