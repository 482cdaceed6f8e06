"""Policy servers that are down, slow, wrong or hostile: each fault ends its attempt
with a reason for the submitter, nothing of the answer is executed, and nothing hangs.
"""

import re
import threading
import time
from collections.abc import Callable, Iterator
from typing import Any

import pytest

from conformance.client.check_context import CheckContext
from conformance.policy.scripted_policy import (
    PolicyCall,
    PolicyReply,
    ScriptedPolicy,
)
from tests.support.kit.endless_answers import ENDLESS, OK, Parts, serve_parts
from tests.support.push_runs import play_push_run, start_push_server
from tests.support.servers import ReferenceServer

pytestmark = pytest.mark.slow("starts servers or kits")

TIMEOUT_S = 0.5
# Of a fault: so often it may happen in a row before the run fails, and once more.
LONGEST_S = 25.0


@pytest.fixture(scope="module")
def push_server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[ReferenceServer]:
    path = tmp_path_factory.mktemp("push_server")
    yield from start_push_server(path, PROCTOR_MAX_BODY_BYTES="65536")


@pytest.fixture
def policy() -> Iterator[ScriptedPolicy]:
    with ScriptedPolicy() as server:
        yield server


BROKEN_OFF: dict[str, Parts] = {
    "another protocol": lambda: iter([b"220 mail.example ESMTP\r\n"]),
    "nothing": lambda: iter([]),
    "a part of a body": lambda: iter([OK + b'Content-Length: 100\r\n\r\n{"name":']),
}
BARE = {
    "body": "answered more than 65536 bytes",
    "body until closed": "answered more than 65536 bytes",
    "headers": "closed the connection or did not answer with HTTP",
    "slow body": r"did not answer completely within 0\.5 s",
    "silence": r"did not answer completely within 0\.5 s",
    "another protocol": "closed the connection or did not answer with HTTP",
    "nothing": "closed the connection|is unreachable",
    "a part of a body": "closed the connection",
}


@pytest.mark.parametrize("name", BARE)
def test_an_invalid_http_server_fails_the_run(
    push_server: ReferenceServer, name: str
) -> None:
    began = time.monotonic()
    with serve_parts((ENDLESS | BROKEN_OFF)[name]) as url:
        is_too_slow = "0\\.5 s" in BARE[name]
        limit_s = TIMEOUT_S if is_too_slow else 20.0
        run = play_push_run(push_server, url, call_timeout_s=limit_s)
    assert (run["state"], run["retryable"]) == ("failed", True)
    assert run["failed_by"] == "policy"
    assert url in run["reason"]
    assert re.search(BARE[name], run["reason"])
    assert run["episodes"][0]["attempt"] == 1
    assert time.monotonic() - began < LONGEST_S


Wrong = Callable[[PolicyCall], PolicyReply]


def body(text: bytes, media_type: str = "application/json") -> Wrong:
    return lambda _: PolicyReply(text, 200, {"Content-Type": media_type})


def status(number: int, **headers: str) -> Wrong:
    named = {name.replace("_", "-"): value for name, value in headers.items()}
    return lambda _: PolicyReply(b"{}", number, named)


def description_with(**changes: Any) -> Wrong:
    valid = {"name": "x", "protocol": {"min": "1.0", "max": "1.0"}, "max_sessions": 1}
    return lambda _: PolicyReply(valid | changes)


DESCRIPTIONS: dict[str, tuple[Wrong, str]] = {
    "error": (status(500), "status 500"),
    "refusal": (status(404), "status 404"),
    "created": (status(201), "status 201"),
    "redirect": (status(302, Location="http://127.0.0.1:1/"), "redirects"),
    "permanent": (status(308, Location="/v1/policy/"), "redirects"),
    "gzip": (status(200, Content_Encoding="gzip"), "compressed"),
    "html": (body(b"<html>", "text/html"), "answered with text/html"),
    "no_type": (body(b"{}", ""), "no media type"),
    "no_json": (body(b"{'name': 1}"), "invalid JSON"),
    "nothing": (body(b""), "invalid JSON"),
    "deep": (body(b"[" * 60000), "invalid JSON"),
    "list": (body(b"[]"), "does not match policy.yaml"),
    "null": (body(b"null"), "does not match policy.yaml"),
    "future": (
        description_with(protocol={"min": "9.0", "max": "9.1"}),
        "versions 9.0 to 9.1",
    ),
    "digits": (
        description_with(protocol={"min": "9" * 9999 + ".0", "max": "1.0"}),
        "/protocol/min must be MAJOR.MINOR",
    ),
    "no_room": (description_with(max_sessions=0), "/max_sessions"),
    "huge_room": (description_with(max_sessions=10**9), "/max_sessions"),
    "null_room": (description_with(max_sessions=None), "/max_sessions is null. Input"),
    "text_room": (description_with(max_sessions="8"), "/max_sessions"),
    "assumes_nonsense": (description_with(assumes={"action": 7}), "/assumes/action"),
    "assumes_else": (
        description_with(assumes={"action": {"score": {"size": 7}}}),
        "assumed conventions.*score",
    ),
}


@pytest.mark.parametrize("name", DESCRIPTIONS)
def test_a_bad_description_fails_the_run(
    push_server: ReferenceServer, policy: ScriptedPolicy, name: str
) -> None:
    wrong, reason = DESCRIPTIONS[name]
    policy.on("describe_policy", wrong)
    run = play_push_run(push_server, policy.url)
    assert (run["state"], run["retryable"]) == ("failed", True)
    assert run["failed_by"] == "policy"
    assert re.search(reason, run["reason"])
    assert policy.calls_of("predict") == []


def answer_with(change: Callable[[dict[str, Any]], Any]) -> Wrong:
    """An answer to predict that was right before the change."""

    def wrong(call: PolicyCall) -> PolicyReply:
        action = CheckContext.action(score=1, end=1)
        answer = {
            "session_id": call.body["session_id"],
            "seq": call.body["seq"] + 1,
            "actions": [action],
        }
        change(answer)
        return PolicyReply(answer)

    return wrong


def encoded(find: bytes, replace: bytes) -> Wrong:
    right = answer_with(lambda _answer: None)
    return lambda call: PolicyReply(right(call).encoded().replace(find, replace))


def values(answer: dict[str, Any]) -> dict[str, Any]:
    found: dict[str, Any] = answer["actions"][0]["values"]
    return found


ANSWERS: dict[str, tuple[Wrong, str]] = {
    "nan": (encoded(b'"score": [1]', b'"score": [NaN]'), "invalid JSON"),
    "infinity": (encoded(b'"score": [1]', b'"score": [1e999]'), "invalid JSON"),
    "surrogate": (encoded(b'"score"', b'"\\ud800"'), "invalid JSON"),
    "text": (
        answer_with(lambda a: values(a).update(score="1")),
        "/actions/0/values/score",
    ),
    "boolean": (
        answer_with(lambda a: values(a).update(score=[True])),
        "/values/score/0",
    ),
    "length": (answer_with(lambda a: values(a).update(score=[1, 1])), "/values/score"),
    "range": (answer_with(lambda a: values(a).update(score=[2])), "/values/score"),
    "missing": (answer_with(lambda a: values(a).pop("score")), "/actions/0/values"),
    "unknown": (answer_with(lambda a: values(a).update(grip=[1])), "/values/grip"),
    "member": (answer_with(lambda a: a.update(extra=1)), "/extra"),
    "null": (answer_with(lambda a: a.update(actions=None)), "/actions is null"),
    "no_actions": (answer_with(lambda a: a.update(actions=[])), "/actions"),
    "too_many": (
        answer_with(lambda a: a.update(actions=a["actions"] * 65)),
        "/actions",
    ),
    "session": (answer_with(lambda a: a.update(session_id="x")), "a different turn"),
    "seq": (answer_with(lambda a: a.update(seq=7)), "a different turn"),
    "observe": (answer_with(lambda a: a.update(observe="some")), "/observe"),
    "list": (lambda _: PolicyReply([]), "refused"),
    "redirect": (status(307, Location="http://127.0.0.1:1/"), "redirects"),
    "refusal": (status(422), "status 422"),
    "error": (status(500), "status 500"),
}


@pytest.mark.parametrize("name", ANSWERS)
def test_a_bad_answer_ends_the_attempt_unexecuted(
    push_server: ReferenceServer, policy: ScriptedPolicy, name: str
) -> None:
    """Nothing was executed, so no attempt counts; three in a row fail the run."""
    wrong, reason = ANSWERS[name]
    policy.on("predict", wrong)
    run = play_push_run(push_server, policy.url)
    assert (run["state"], run["retryable"]) == ("failed", True)
    assert run["failed_by"] == "policy"
    assert re.search(reason, run["reason"])
    (episode,) = run["episodes"]
    assert (episode["status"], episode["attempt"]) == ("pending", 1)
    assert episode["policy_fault"] == run["reason"]
    assert len(policy.calls_of("predict")) == 3


RESETS: dict[str, tuple[Callable[[dict[str, Any]], Any], str]] = {
    "session": (lambda a: a.update(session_id="x"), "a different reset"),
    "episode": (lambda a: a.update(episode_id="e0099"), "a different reset"),
    "attempt": (lambda a: a.update(attempt=2), "a different reset"),
    "missing": (lambda a: a.pop("attempt"), "/attempt"),
}


@pytest.mark.parametrize("name", RESETS)
def test_an_episode_does_not_begin_without_its_reset(
    push_server: ReferenceServer, policy: ScriptedPolicy, name: str
) -> None:
    change, reason = RESETS[name]

    def wrong(call: PolicyCall) -> PolicyReply:
        answer = dict(policy.reset_reply(call).body)
        change(answer)
        return PolicyReply(answer)

    policy.on("reset", wrong)
    run = play_push_run(push_server, policy.url)
    assert run["state"] == "failed"
    assert re.search(reason, run["reason"])
    assert policy.calls_of("predict") == []


def test_an_executed_action_makes_the_attempt_count(
    push_server: ReferenceServer, policy: ScriptedPolicy
) -> None:
    """A policy that always dies in the middle is abandoned, and the run completes."""

    def dies(call: PolicyCall) -> PolicyReply:
        if call.body["episode"]["step"] == 0:
            return policy.actions_reply(call, CheckContext.action(score=1))
        return PolicyReply(b"", 400)

    policy.on("predict", dies)
    run = play_push_run(push_server, policy.url, options={"max_attempts": 2})
    assert run["state"] == "completed"
    (episode,) = run["episodes"]
    assert episode["result"]["outcome"] == "abandoned"
    assert episode["result"]["attempt"] == 2
    assert "status 400" in episode["policy_fault"]


def test_a_policy_that_is_sometimes_slow_is_waited_for(
    push_server: ReferenceServer, policy: ScriptedPolicy
) -> None:
    """For longer than the lease of a run's workers: the server's own have none."""
    thought = threading.Event()

    def slow(call: PolicyCall) -> PolicyReply:
        thought.wait(1.4)
        return policy.final_action_reply(call)

    policy.on("predict", slow)
    run = play_push_run(push_server, policy.url, idle_timeout_s=1.0)
    assert run["state"] == "completed"
    assert run["episodes"][0]["result"]["attempt"] == 1
    assert run["episodes"][0]["result"]["think_s"] > 1.3


def test_max_sessions_of_the_policy_is_respected(
    push_server: ReferenceServer, policy: ScriptedPolicy
) -> None:
    policy.max_sessions = 1
    run = play_push_run(push_server, policy.url, *["score"] * 4)
    assert run["state"] == "completed"
    assert len({call.body["session_id"] for call in policy.calls_of("reset")}) == 1
