"""Push mode: the server calls the policy. Scores, limits, faults, crash (PUSH)."""

import secrets
import threading
import time
from collections import Counter
from collections.abc import Mapping, Sequence
from functools import partial
from typing import Any

from conformance.client.check_context import CheckContext
from conformance.client.run_client import RunClient
from conformance.policy.push_run import (
    expect_end,
    expect_policy_fault,
    policy_server,
    push_body,
    submit_push_run,
)
from conformance.policy.scripted_policy import (
    PolicyCall,
    PolicyReply,
    ReplyFunction,
    ScriptedPolicy,
    busy_reply,
)
from conformance.runner.private_server import open_server_of_its_own
from conformance.runner.requirement import background, requirement
from conformance.specification.document import PROBLEM_JSON
from conformance.verdicts import expect

_HOLD_TIMEOUT_S = 20.0
_MARGIN_S = 3.0
_SETTLE_S = 0.3
_REPEAT_S = 1.5


def _hold_predicts(
    policy: ScriptedPolicy, reply: ReplyFunction | None = None
) -> threading.Event:
    """Hold every predict until an event is set; the reply ends the episode if None."""
    released = threading.Event()

    def wait(call: PolicyCall) -> PolicyReply:
        released.wait(_HOLD_TIMEOUT_S)
        return (reply or policy.final_action_reply)(call)

    policy.on("predict", wait)
    return released


def _reply_with(
    policy: ScriptedPolicy, actions: Sequence[Mapping[str, Any]], call: PolicyCall
) -> PolicyReply:
    """Answer every turn with the same actions."""
    return policy.actions_reply(call, *actions)


def _expect_drained(context: CheckContext, policy: ScriptedPolicy) -> None:
    """Expect the episode in play to be scored after a stop with mode `drain`.

    The stop comes during the first predict; the second one ends the episode.
    """

    def play(call: PolicyCall) -> PolicyReply:
        end = float(call.body["episode"]["step"] == 1)
        return policy.actions_reply(call, context.action(score=0.5, end=end))

    released = _hold_predicts(policy, play)
    before = len(policy.calls_of("predict"))
    run = submit_push_run(context, policy, "score", "score", max_concurrent=1)
    policy.wait_for("predict", before + 1)
    run.stop("drain")
    released.set()
    expect_end(run, "stopped")
    results = [episode.get("result", {}) for episode in run.episodes()]
    scores = [(result.get("score"), result.get("steps")) for result in results]
    expect.equal(scores, [(0.5, 2), (None, None)], "score and steps after a drain")


@requirement("PUSH-001")
def test_push_001_server_plays_the_run(context: CheckContext) -> None:
    """A policy plays three episodes with different scores. Expect a completed run with
    these scores, each after the returned actions. Another run is stopped with mode
    `drain` in its first episode: expect this to be scored."""
    with policy_server(context) as policy:

        def play(call: PolicyCall) -> PolicyReply:
            score = (call.body["episode"]["index"] + 1) / 4
            if call.body["episode"]["step"] == 0:
                return policy.actions_reply(call, *[context.action(score=score)] * 2)
            return policy.actions_reply(call, context.action(score=score, end=1))

        policy.on("predict", play)
        run = submit_push_run(context, policy, "score", "score", "score")
        expect.equal(expect_end(run, "completed").get("mode"), "push", "mode")
        results = [episode["result"] for episode in run.episodes()]
        scores = [result["score"] for result in results]
        expect.equal(scores, [0.25, 0.5, 0.75], "scores")
        expect.equal([result["steps"] for result in results], [3, 3, 3], "steps")
        _expect_drained(context, policy)


@requirement("PUSH-002")
def test_push_002_mode_and_policy_server_belong_together(context: CheckContext) -> None:
    """A submission has only one of the two. Expect a refusal; both are accepted."""
    with policy_server(context) as policy:
        submit_push_run(context, policy)
        body = push_body(policy.url)
        for without in ("mode", "policy_server"):
            half = {name: value for name, value in body.items() if name != without}
            answer = context.call("submit_run", json=half)
            expect.refused(answer, "invalid_request", pointer="/policy_server")
        answer = context.call("submit_run", json=body | {"mode": "pull"})
        expect.refused(answer, "invalid_request", pointer="/policy_server")


@requirement("PUSH-003")
def test_push_003_cannot_attach_to_a_push_run(context: CheckContext) -> None:
    """A worker attaches to a push run, also by takeover. It then uses the session of
    the policy for predict, heartbeat and detach. Expect `illegal_transition`, and the
    run completed by the policy."""
    with policy_server(context) as policy:
        released = _hold_predicts(policy)
        run = submit_push_run(context, policy, "score", "score", max_concurrent=1)
        policy.wait_for("predict")
        for takeover in (False, True):
            refused = run.worker().try_attach(takeover=takeover)
            expect.refused(refused, "illegal_transition")
        turn = policy.calls_of("predict")[0].body
        named = {"session_id": turn["session_id"]}
        play = {"seq": turn["seq"] + 1, "actions": [context.action(score=1, end=1)]}
        how = {"worker_id": run.worker().id}
        for answer in (
            run.call("predict", json=named | play, **how),
            run.call("heartbeat", json=named, **how),
            run.call("detach_worker", params=named, **how),
        ):
            expect.refused(answer, "illegal_transition")
        released.set()
        expect_end(run, "completed")
        scores = [episode["result"]["score"] for episode in run.episodes()]
        expect.equal(scores, [policy.score] * 2, "scores")


@requirement("PUSH-004")
def test_push_004_every_call_carries_the_key(context: CheckContext) -> None:
    """A run has an API key. Expect it in the Authorization of every call."""
    key = secrets.token_hex(16)
    with policy_server(context) as policy:
        run = submit_push_run(context, policy, "score", "score", api_key=key)
        expect_end(run, "completed")
        for call in policy.calls:
            sent = call.headers.get("authorization") == f"Bearer {key}"
            expect.true(sent, f"the key in the call of {call.operation}")


@requirement("PUSH-005")
def test_push_005_key_is_in_no_response(context: CheckContext) -> None:
    """The policy answers with the key: in its problem, as media type, as a name. Expect
    the key in no response: run, episodes, list of runs."""
    key = secrets.token_hex(16)
    with policy_server(context) as policy:
        problem = dict(busy_reply().body) | {"detail": f"{key} is not my key"}
        action: dict[str, Any] = {"values": {key: [0.0]}}
        replies: list[ReplyFunction] = [
            lambda _: PolicyReply(problem, 400, {"Content-Type": PROBLEM_JSON}),
            lambda _: PolicyReply(b"", 200, {"Content-Type": key}),
            lambda call: policy.actions_reply(call, action),
        ]
        for reply in replies:
            policy.on("predict", reply)
            options = {"max_faults": 1}
            run = submit_push_run(context, policy, api_key=key, options=options)
            expect_end(run, "failed")
            answers = [run.call(name).body for name in ("get_run", "list_episodes")]
            answers.append(context.call("list_runs").body)
            answers += [e.answer_body for e in context.exchange_log.exchanges]
            leaks = sum(key.encode() in body for body in answers)
            expect.equal(leaks, 0, "answers that have the key")


@requirement("PUSH-006")
def test_push_006_attempts_begin_with_a_reset(context: CheckContext) -> None:
    """Resets are slow; the first is acknowledged with another attempt. Expect no
    predict of an attempt before a correct acknowledgement."""
    ready: set[tuple[str, str, int]] = set()
    early: list[str] = []

    def attempt(call: PolicyCall) -> tuple[str, str, int]:
        episode = call.body["episode"]
        return call.body["session_id"], episode["episode_id"], episode["attempt"]

    with policy_server(context) as policy:

        def reset(call: PolicyCall) -> PolicyReply:
            reply = policy.reset_reply(call)
            if len(policy.calls_of("reset")) == 1:
                return PolicyReply(dict(reply.body) | {"attempt": 99})
            time.sleep(0.1)
            ready.add(attempt(call))
            return reply

        def predict(call: PolicyCall) -> PolicyReply:
            if attempt(call) not in ready:
                early.append(call.body["episode"]["episode_id"])
            return policy.final_action_reply(call)

        policy.on("reset", reset)
        policy.on("predict", predict)
        run = submit_push_run(context, policy, "score", "score", max_concurrent=1)
        expect_end(run, "completed")
        expect.equal(early, [], "episodes with a predict before their reset")


@requirement("PUSH-018")
def test_push_018_policies_are_reset_after_a_fault(context: CheckContext) -> None:
    """The policy breaks the simulator once in each of two episodes. Expect a reset
    between the actions that broke it and the next predict."""
    with policy_server(context) as policy:
        order: list[str] = []

        def reset(call: PolicyCall) -> PolicyReply:
            order.append("reset")
            return policy.reset_reply(call)

        def predict(call: PolicyCall) -> PolicyReply:
            order.append("predict")
            if order.count("predict") % 2:
                return policy.actions_reply(call, context.action(fault=1))
            return policy.final_action_reply(call)

        policy.on("reset", reset)
        policy.on("predict", predict)
        run = submit_push_run(context, policy, "fault", "fault", max_concurrent=1)
        expect_end(run, "completed")
        expect.equal(order, ["reset", "predict"] * 4, "calls of the policy server")


@requirement("PUSH-007")
def test_push_007_calls_are_bounded(context: CheckContext) -> None:
    """Six episodes, `max_concurrent` 2. Expect no third concurrent call."""
    with policy_server(context) as policy:

        def slow_reply(call: PolicyCall) -> PolicyReply:
            time.sleep(0.1)
            return policy.final_action_reply(call)

        policy.on("predict", slow_reply)
        run = submit_push_run(context, policy, *["score"] * 6, max_concurrent=2)
        expect_end(run, "completed")
        most = policy.max_in_flight
        expect.true(most <= 2, "at most 2 calls in flight", most)


@requirement("PUSH-008")
def test_push_008_repeated_call_is_the_same_call(context: CheckContext) -> None:
    """The predict of an episode with one step is refused once with `unavailable`.
    Expect the same body again."""
    asked, _ = play_with_a_busy_policy(context, steps=1)
    expect.equal(sorted(asked.values()), [2], "calls with the same body")


@requirement("PUSH-020")
def test_push_020_executes_one_response(context: CheckContext) -> None:
    """Each of two predicts is refused once with `unavailable`. Expect the actions of
    each response executed once."""
    _, run = play_with_a_busy_policy(context, steps=2)
    (episode,) = run.episodes()
    expect.equal(episode["result"]["steps"], 2, "steps")


def play_with_a_busy_policy(
    context: CheckContext, steps: int
) -> tuple[Counter[bytes], RunClient]:
    """Play an episode in which each predict is refused once and then has one action.

    Gives how often each body was sent, and the completed run.
    """
    with policy_server(context) as policy:
        asked = Counter[bytes]()

        def busy_at_first(call: PolicyCall) -> PolicyReply:
            asked[call.raw] += 1
            if asked[call.raw] == 1:
                return busy_reply()
            last = call.body["episode"]["step"] >= steps - 1
            return policy.actions_reply(call, context.action(score=1, end=float(last)))

        policy.on("predict", busy_at_first)
        run = submit_push_run(context, policy, max_concurrent=1, max_retries=2)
        expect_end(run, "completed")
        return asked, run


@requirement("PUSH-009")
def test_push_009_slow_response_times_out(context: CheckContext) -> None:
    """A response starts at once, continues byte by byte, and never ends. Expect the
    attempt to end at the timeout, and not before."""
    with policy_server(context) as policy:
        policy.on("predict", lambda _: PolicyReply(never_ends=True))
        options = {"max_faults": 1}
        run = submit_push_run(context, policy, call_timeout_s=1.0, options=options)
        policy.wait_for("predict")
        # The server has answers to earlier calls before it sends this one, and the kit
        # may see it late.
        began = policy.calls_of("reset")[0].started_at
        expect_policy_fault(run, 1.0 + _MARGIN_S)
        waited_s = time.monotonic() - began
        expect.true(waited_s > 0.9, "no end before its time", waited_s)


@requirement("PUSH-010")
def test_push_010_invalid_actions_are_not_executed(context: CheckContext) -> None:
    """One of two actions has a vector that is too long; one action too many. The right
    one would end the episode. Expect `policy_fault`, no attempt counted, nothing
    scored."""
    with policy_server(context) as policy:
        good, bad = context.action(score=1, end=1), context.action(score=[1.0, 1.0])
        too_many = [good] * (context.benchmark["max_chunk"] + 1)
        for actions in ([bad, good], [good, bad], too_many):
            chunk = partial(_reply_with, policy, actions)
            policy.on("predict", chunk)
            run = submit_push_run(context, policy, options={"max_faults": 1})
            episode = expect_policy_fault(run)
            expect.equal(episode["attempt"], 1, "attempt")
            expect.true("result" not in episode, "no result", dict(episode))


@requirement("PUSH-011")
def test_push_011_redirect_is_not_followed(context: CheckContext) -> None:
    """The policy redirects the first predict to another server, and only this one. A
    call that is not answered may be repeated. Expect a fault, and no call there."""
    with policy_server(context) as policy, policy_server(context) as target:

        def redirect(call: PolicyCall) -> PolicyReply:
            if len(policy.calls_of("predict")) > 1:
                return policy.final_action_reply(call)
            return PolicyReply(
                b"", 307, {"Location": f"{target.url}/v1/policy/predict"}
            )

        policy.on("predict", redirect)
        expect_policy_fault(submit_push_run(context, policy, max_retries=2))
        expect.equal(len(target.calls), 0, "calls of the other server")


@requirement("PUSH-021")
def test_push_021_a_failed_call_is_not_repeated(context: CheckContext) -> None:
    """The policy answers the first call of an operation with status 500. A repeat would
    be answered correctly. Expect a fault each time."""
    for operation in ("reset", "predict"):
        with policy_server(context) as policy:

            def fail_first(call: PolicyCall, operation: str = operation) -> PolicyReply:
                if len(policy.calls_of(operation)) == 1:
                    return PolicyReply(b"", 500)
                if operation == "reset":
                    return policy.reset_reply(call)
                return policy.final_action_reply(call)

            policy.on(operation, fail_first)
            run = submit_push_run(context, policy, max_concurrent=1, max_retries=2)
            expect_policy_fault(run)


@requirement("PUSH-012")
def test_push_012_unreachable_policy_fails_the_run(context: CheckContext) -> None:
    """The policy server is closed before the next run. Expect the run to fail by the
    policy, retryable, with a reason that names the policy server."""
    with policy_server(context) as policy:
        expect_end(submit_push_run(context, policy), "completed")
    answer = context.call("submit_run", json=push_body(policy.url))
    run = context.adopt(expect.require(answer, 201, "`submit_run` with mode push"))
    failed = expect_end(run, "failed")
    expect.equal(failed["retryable"], True, "retryable")
    expect.equal(failed.get("failed_by", "policy"), "policy", "failed_by")
    place = policy.url.removeprefix("http://")
    expect.true(place in str(failed["reason"]), f"{place} in reason", failed["reason"])


@requirement("PUSH-019")
def test_push_019_policies_must_fit_the_server(context: CheckContext) -> None:
    """Policy servers of a later version, and with an assumption that is wrong; then one
    with the version and an assumption that is right. Expect runs that fail and can be
    resumed, without a predict, and one that completes."""
    later = {"protocol": {"min": "99.0", "max": "99.1"}}
    for members, state in (
        (later, "failed"),
        ({"assumes": {"control_rate_hz": 20}}, "failed"),
        ({"assumes": {"control_rate_hz": 10}}, "completed"),
    ):
        with policy_server(context) as policy:

            def describe(call: PolicyCall, members: Any = members) -> PolicyReply:
                return PolicyReply(dict(policy.description(call).body) | members)

            policy.on("describe_policy", describe)
            ended = expect_end(submit_push_run(context, policy), state)
            retryable = True if state == "failed" else None
            expect.equal(ended["retryable"], retryable, f"retryable with {members}")
            expect.equal(ended.get("failed_by", "policy"), "policy", "failed_by")
            played = bool(policy.calls_of("predict"))
            expect.equal(played, state == "completed", f"a predict with {members}")


@requirement("PUSH-013")
def test_push_013_failed_run_can_be_resumed(context: CheckContext) -> None:
    """The policy refuses to describe itself, and is called properly after a resume. It
    fails in its third episode, and works again after another resume. Expect the first
    two results unchanged, and all episodes scored."""
    with policy_server(context) as policy:

        def fail_at_third_episode(call: PolicyCall) -> PolicyReply:
            if call.body["episode"]["index"] < 2:
                return policy.final_action_reply(call)
            policy.on("describe_policy", lambda _: PolicyReply(b"", 500))
            return PolicyReply(b"", 500)

        policy.on("describe_policy", lambda _: PolicyReply(b"", 404))
        policy.on("predict", fail_at_third_episode)
        options = {"max_faults": 1}
        run = submit_push_run(
            context, policy, *["score"] * 3, max_concurrent=1, options=options
        )
        run.until("failed", _HOLD_TIMEOUT_S)
        policy.on("describe_policy", policy.description)
        expect.ok(run.call("resume_run"))
        expect_end(run, "failed")
        before = run.episodes()
        policy.on("predict", policy.final_action_reply)
        policy.on("describe_policy", policy.description)
        expect.ok(run.call("resume_run"))
        expect_end(run, "completed")
        after = run.episodes()
        expect.equal(after[:2], before[:2], "the first two episodes")
        scores = [episode["result"]["score"] for episode in after]
        expect.equal(scores, [policy.score] * 3, "scores")


@background
@requirement("PUSH-014")
def test_push_014_stop_ends_the_calls(context: CheckContext) -> None:
    """A run is stopped during a call of its policy, which is answered afterwards. The
    answer is once an action and once `unavailable`, after which a call is repeated.
    Expect no further call."""
    replies: list[tuple[ReplyFunction | None, float]] = [
        (None, _SETTLE_S),
        (lambda _: busy_reply(), _REPEAT_S),
    ]
    for reply, settle_s in replies:
        with policy_server(context) as policy:
            released = _hold_predicts(policy, reply)
            run = submit_push_run(
                context, policy, *["score"] * 3, max_concurrent=1, max_retries=2
            )
            policy.wait_for("predict")
            run.stop()
            before = len(policy.calls)
            released.set()
            time.sleep(settle_s)
            expect.equal(len(policy.calls), before, "calls after the stop")
            expect.equal(run.get()["state"], "stopped", "state")


@background
@requirement("PUSH-017")
def test_push_017_continues_after_a_crash(context: CheckContext) -> None:
    """A private server is killed during a call of the policy in the third episode.
    Expect the run completed with the same key, and the earlier results unchanged."""
    released, key = threading.Event(), secrets.token_hex(16)
    with open_server_of_its_own(context) as server, policy_server(context) as policy:

        def slow_reply(call: PolicyCall) -> PolicyReply:
            if call.body["episode"]["index"] == 2:
                released.wait(_HOLD_TIMEOUT_S)
            return policy.final_action_reply(call)

        policy.on("predict", slow_reply)
        config = {"max_concurrent": 1, "api_key": key}
        run = submit_push_run(server.context, policy, *["score"] * 4, **config)
        policy.wait_for("predict", 3)
        before = [e for e in run.episodes() if e["status"] == "scored"]
        server.kill9()
        released.set()
        server.restart()
        expect_end(run, "completed")
        after = {episode["episode_id"]: episode for episode in run.episodes()}
        same = [after[episode["episode_id"]] for episode in before]
        expect.equal(same, before, "the episodes that were scored")
        kept = policy.calls[-1].headers.get("authorization") == f"Bearer {key}"
        expect.true(kept, "the key in the last call")
