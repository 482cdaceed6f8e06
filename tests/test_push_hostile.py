"""Policy servers that are down, slow, wrong or hostile: each ends its attempt with a
reason that the submitter can read, nothing of it is executed, and nothing hangs.
"""

import itertools
import re
import socket
import threading
import time
from collections.abc import Callable, Iterator
from typing import Any

import pytest

from conformance.client.check_context import CheckContext
from conformance.policy.scripted import (
    PolicyCall,
    PolicyReply,
    ScriptedPolicy,
    busy_reply,
)
from tests import push_parts
from tests.conftest import House
from tests.push_parts import bare_server, calling, played

TIMEOUT_S = 0.5
# Of a fault: so often it may happen in a row before the run fails, and once more.
LONGEST_S = 10.0


@pytest.fixture(scope="module")
def pushing(tmp_path_factory: pytest.TempPathFactory) -> Iterator[House]:
    path = tmp_path_factory.mktemp("pushing")
    yield from calling(path, PROCTOR_MAX_BODY_BYTES="65536")


@pytest.fixture
def policy() -> Iterator[ScriptedPolicy]:
    with ScriptedPolicy() as server:
        yield server


BARE = {
    "endless_body": "answered more than 65536 bytes",
    "endless_chunks": "answered more than 65536 bytes",
    "endless_headers": "broke off, or does not speak HTTP",
    "drip": r"gave no whole answer within 0\.5 s",
    "silence": r"gave no whole answer within 0\.5 s",
    "no_http": "broke off, or does not speak HTTP",
    "hang_up": "broke off|not reached",
    "broken_off": "broke off",
}


@pytest.mark.parametrize("name", BARE)
def test_a_server_that_is_none_fails_the_run(pushing: House, name: str) -> None:
    began = time.monotonic()
    with bare_server(getattr(push_parts, name)) as url:
        run = played(pushing, url, call_timeout_s=TIMEOUT_S)
    assert (run["state"], run["retryable"]) == ("failed", True)
    assert url in run["reason"]
    assert re.search(BARE[name], run["reason"])
    assert run["episodes"][0]["attempt"] == 1
    assert time.monotonic() - began < LONGEST_S


def test_nobody_there_fails_the_run(pushing: House) -> None:
    with socket.create_server(("127.0.0.1", 0)) as listener:
        port = listener.getsockname()[1]
    run = played(pushing, f"http://127.0.0.1:{port}", max_retries=1)
    assert (run["state"], run["retryable"]) == ("failed", True)
    assert "is not reached (policy, 2 times)" in run["reason"]


def test_a_name_without_address_fails_the_run(pushing: House) -> None:
    run = played(pushing, "http://nobody.invalid/")
    assert (run["state"], run["retryable"]) == ("failed", True)
    assert "nobody.invalid has no address" in run["reason"]


Wrong = Callable[[PolicyCall], PolicyReply]


def body(text: bytes, media_type: str = "application/json") -> Wrong:
    return lambda _: PolicyReply(text, 200, {"Content-Type": media_type})


def status(number: int, **headers: str) -> Wrong:
    named = {name.replace("_", "-"): value for name, value in headers.items()}
    return lambda _: PolicyReply(b"{}", number, named)


def described(**lies: Any) -> Wrong:
    truth = {"name": "x", "protocol": {"min": "1.0", "max": "1.0"}, "max_sessions": 1}
    return lambda _: PolicyReply(truth | lies)


DESCRIPTIONS: dict[str, tuple[Wrong, str]] = {
    "error": (status(500), "status 500"),
    "refusal": (status(404), "status 404"),
    "created": (status(201), "status 201"),
    "redirect": (status(302, Location="http://127.0.0.1:1/"), "redirects"),
    "permanent": (status(308, Location="/v1/policy/"), "redirects"),
    "gzip": (status(200, Content_Encoding="gzip"), "compressed"),
    "html": (body(b"<html>", "text/html"), "answered with text/html"),
    "no_type": (body(b"{}", ""), "no media type"),
    "no_json": (body(b"{'name': 1}"), "no JSON"),
    "nothing": (body(b""), "no JSON"),
    "deep": (body(b"[" * 60000), "no JSON"),
    "list": (body(b"[]"), "not as policy.yaml says"),
    "null": (body(b"null"), "not as policy.yaml says"),
    "future": (described(protocol={"min": "9.0", "max": "9.1"}), "speaks 9.0 to 9.1"),
    "digits": (described(protocol={"min": "9" * 9999 + ".0", "max": "1.0"}), "speaks"),
    "no_room": (described(max_sessions=0), "/max_sessions"),
    "huge_room": (described(max_sessions=10**9), "/max_sessions"),
    "text_room": (described(max_sessions="8"), "/max_sessions"),
    "assumes_nonsense": (described(assumes={"action": 7}), "/assumes/action"),
    "assumes_else": (
        described(assumes={"action": {"score": {"size": 7}}}),
        "assumes conventions.*score",
    ),
}


@pytest.mark.parametrize("name", DESCRIPTIONS)
def test_a_bad_description_fails_the_run(
    pushing: House, policy: ScriptedPolicy, name: str
) -> None:
    wrong, reason = DESCRIPTIONS[name]
    policy.on("describe_policy", wrong)
    run = played(pushing, policy.url)
    assert (run["state"], run["retryable"]) == ("failed", True)
    assert re.search(reason, run["reason"])
    assert policy.calls_of("predict") == []


def acted(change: Callable[[dict[str, Any]], Any]) -> Wrong:
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
    right = acted(lambda _answer: None)
    return lambda call: PolicyReply(right(call).encoded().replace(find, replace))


def values(answer: dict[str, Any]) -> dict[str, Any]:
    found: dict[str, Any] = answer["actions"][0]["values"]
    return found


ANSWERS: dict[str, tuple[Wrong, str]] = {
    "nan": (encoded(b'"score": [1]', b'"score": [NaN]'), "no JSON"),
    "infinity": (encoded(b'"score": [1]', b'"score": [1e999]'), "no JSON"),
    "surrogate": (encoded(b'"score"', b'"\\ud800"'), "no JSON"),
    "text": (acted(lambda a: values(a).update(score="1")), "/actions/0/values/score"),
    "boolean": (acted(lambda a: values(a).update(score=[True])), "/values/score/0"),
    "length": (acted(lambda a: values(a).update(score=[1, 1])), "/values/score"),
    "range": (acted(lambda a: values(a).update(score=[2])), "/values/score"),
    "missing": (acted(lambda a: values(a).pop("score")), "/actions/0/values"),
    "unknown": (acted(lambda a: values(a).update(grip=[1])), "/values/grip"),
    "member": (acted(lambda a: a.update(extra=1)), "/extra"),
    "no_actions": (acted(lambda a: a.update(actions=[])), "/actions"),
    "too_many": (acted(lambda a: a.update(actions=a["actions"] * 65)), "/actions"),
    "session": (acted(lambda a: a.update(session_id="x")), "another turn"),
    "seq": (acted(lambda a: a.update(seq=7)), "another turn"),
    "observe": (acted(lambda a: a.update(observe="some")), "/observe"),
    "list": (lambda _: PolicyReply([]), "refused"),
    "redirect": (status(307, Location="http://127.0.0.1:1/"), "redirects"),
    "refusal": (status(422), "status 422"),
    "error": (status(500), "status 500"),
}


@pytest.mark.parametrize("name", ANSWERS)
def test_a_bad_answer_ends_the_attempt_unexecuted(
    pushing: House, policy: ScriptedPolicy, name: str
) -> None:
    """Nothing was executed, so no attempt counts; three in a row fail the run."""
    wrong, reason = ANSWERS[name]
    policy.on("predict", wrong)
    run = played(pushing, policy.url)
    assert (run["state"], run["retryable"]) == ("failed", True)
    assert re.search(reason, run["reason"])
    (episode,) = run["episodes"]
    assert (episode["status"], episode["attempt"]) == ("pending", 1)
    assert episode["policy_fault"] == run["reason"]
    assert len(policy.calls_of("predict")) == 3


RESETS: dict[str, tuple[Callable[[dict[str, Any]], Any], str]] = {
    "session": (lambda a: a.update(session_id="x"), "another reset"),
    "episode": (lambda a: a.update(episode_id="e0099"), "another reset"),
    "attempt": (lambda a: a.update(attempt=2), "another reset"),
    "missing": (lambda a: a.pop("attempt"), "/attempt"),
}


@pytest.mark.parametrize("name", RESETS)
def test_an_episode_does_not_begin_without_its_reset(
    pushing: House, policy: ScriptedPolicy, name: str
) -> None:
    change, reason = RESETS[name]

    def wrong(call: PolicyCall) -> PolicyReply:
        answer = dict(policy.reset_reply(call).body)
        change(answer)
        return PolicyReply(answer)

    policy.on("reset", wrong)
    run = played(pushing, policy.url)
    assert run["state"] == "failed"
    assert re.search(reason, run["reason"])
    assert policy.calls_of("predict") == []


def test_an_executed_action_makes_the_attempt_count(
    pushing: House, policy: ScriptedPolicy
) -> None:
    """A policy that always dies in the middle is abandoned, and the run completes."""

    def dies(call: PolicyCall) -> PolicyReply:
        if call.body["episode"]["step"] == 0:
            return policy.actions_reply(call, CheckContext.action(score=1))
        return PolicyReply(b"", 400)

    policy.on("predict", dies)
    run = played(pushing, policy.url, options={"max_attempts": 2})
    assert run["state"] == "completed"
    (episode,) = run["episodes"]
    assert episode["result"]["outcome"] == "abandoned"
    assert episode["result"]["attempt"] == 2
    assert "status 400" in episode["policy_fault"]


def test_a_call_is_repeated_with_the_same_body_until_it_is_answered(
    pushing: House, policy: ScriptedPolicy
) -> None:
    turns = itertools.count()

    def busy_at_first(call: PolicyCall) -> PolicyReply:
        return busy_reply() if next(turns) % 3 < 2 else policy.final_action_reply(call)

    policy.on("predict", busy_at_first)
    run = played(pushing, policy.url, "score", "score", max_retries=2, max_concurrent=1)
    assert run["state"] == "completed"
    assert [e["result"]["steps"] for e in run["episodes"]] == [1, 1]
    asked = [call.raw for call in policy.calls_of("predict")]
    assert len(asked) == 6
    assert len(set(asked[:3])) == len(set(asked[3:])) == 1


def test_a_policy_that_is_sometimes_slow_is_waited_for(
    pushing: House, policy: ScriptedPolicy
) -> None:
    """For longer than the lease of a run's workers: the server's own have none."""
    thought = threading.Event()

    def slow(call: PolicyCall) -> PolicyReply:
        thought.wait(1.4)
        return policy.final_action_reply(call)

    policy.on("predict", slow)
    run = played(pushing, policy.url, idle_timeout_s=1.0)
    assert run["state"] == "completed"
    assert run["episodes"][0]["result"]["attempt"] == 1
    assert run["episodes"][0]["result"]["think_s"] > 1.3


def test_no_more_calls_are_in_flight_than_allowed(
    pushing: House, policy: ScriptedPolicy
) -> None:
    met = threading.Barrier(3)

    def together(call: PolicyCall) -> PolicyReply:
        met.wait(10)
        return policy.final_action_reply(call)

    policy.on("predict", together)
    run = played(pushing, policy.url, *["score"] * 9, max_concurrent=3)
    assert run["state"] == "completed"
    assert policy.max_in_flight == 3


def test_a_policy_with_little_room_is_not_overrun(
    pushing: House, policy: ScriptedPolicy
) -> None:
    policy.max_sessions = 1
    run = played(pushing, policy.url, *["score"] * 4)
    assert run["state"] == "completed"
    assert len({call.body["session_id"] for call in policy.calls_of("reset")}) == 1


def test_what_a_policy_says_of_itself_is_told(
    pushing: House, policy: ScriptedPolicy
) -> None:
    policy.on("describe_policy", lambda _: busy_reply())
    run = played(pushing, policy.url)
    assert "unavailable: The kit wants this call once more." in run["reason"]


def test_the_server_is_well_after_all_that(
    pushing: House, policy: ScriptedPolicy
) -> None:
    run = played(pushing, policy.url, api_key="sesame")
    assert run["state"] == "completed"
    assert run["policy_server"]["has_api_key"]
    headers = {call.headers["authorization"] for call in policy.calls}
    assert headers == {"Bearer sesame"}
    assert "sesame" not in str(run) + pushing.log()
