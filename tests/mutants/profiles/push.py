"""Mutants of push runs, in which the server calls the policy."""

from __future__ import annotations

import asyncio
from collections import Counter
from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import httpcore

from reference_server.push import policy_calls, policy_server_validator
from reference_server.push.calls_with_retries import Call, HttpCalls, PolicyFault
from reference_server.push.driver import Driver
from reference_server.push.policy_calls import Description, ProctorPolicy
from reference_server.rules.policy_server import PolicyServerConfig
from reference_server.rules.runs import effects, lifecycle
from reference_server.rules.runs.run import Run, Session
from tests.mutants import instead_of, mutant, put
from tests.mutants.server_changes import no_guard, replace_guard


@mutant("PUSH-001", "PUSH-010", through=instead_of(ProctorPolicy, "predict"))
async def plays_only_the_first_action_of_a_chunk(
    right: Any, self: ProctorPolicy, turn: Any
) -> Any:
    """A policy that answers chunks is scored for actions it did not choose."""
    answer = await right(self, turn)
    answer.actions = answer.actions[:1]
    return answer


@mutant("PUSH-002")
def accepts_a_policy_server_without_push_mode() -> None:
    """A run waits for workers without end, while its submitter waits for calls."""
    put(policy_server_validator, "_errors", lambda _submission: iter(()))
    right = policy_server_validator.PolicyServerValidator.validate_and_encrypt

    async def wrong(
        self: policy_server_validator.PolicyServerValidator,
        submission: Any,
        account: str,
    ) -> Any:
        if submission.get("mode") == "push" and "policy_server" not in submission:
            submission = submission | {"mode": "pull"}
        return await right(self, submission, account)

    put(policy_server_validator.PolicyServerValidator, "validate_and_encrypt", wrong)


@mutant("PUSH-003")
def lets_workers_attach_to_a_push_run() -> None:
    """Another client plays episodes in the name of the policy."""
    replace_guard(lifecycle._mode_allows_caller, no_guard)


@mutant("PUSH-004", through=instead_of(HttpCalls, "_send_once"))
async def sends_the_key_only_to_predict(right: Any, self: HttpCalls, call: Call) -> Any:
    """A policy server that requires its key never gets a run."""
    key = self._key
    self._key = key if call.path.endswith("/predict") else None
    try:
        return await right(self, call)
    finally:
        self._key = key


@mutant("PUSH-005")
def exposes_the_key_in_a_reason() -> None:
    """A reader of the run can read the key of its policy server."""
    put(HttpCalls, "redact_key", lambda _self, text: text)


@mutant("PUSH-005", through=instead_of(HttpCalls, "_check"))
def shows_the_media_type_of_an_answer_as_it_came(
    right: Any, self: HttpCalls, *checked: Any
) -> None:
    """A policy server that returns its key as media type publishes it."""
    try:
        right(self, *checked)
    except PolicyFault as fault:
        if not str(fault).startswith("answered with [API key"):
            raise
        raise PolicyFault(f"answered with {checked[2]['content-type']}") from None


@mutant("PUSH-005", through=instead_of(policy_calls, "_format_errors"))
def shows_the_names_of_an_action_as_they_came(
    _right: Any, errors: Any, _calls: HttpCalls
) -> Any:
    """A policy server that returns its key as the name of a value publishes it."""
    return "; ".join(f"{at} {text}" for at, text in errors)[:500]


@mutant("PUSH-006", "PUSH-021", through=instead_of(ProctorPolicy, "reset"))
async def ignores_the_answer_to_reset(
    _right: Any, self: ProctorPolicy, turn: Mapping[str, Any]
) -> None:
    """A policy that was not ready continues with the memory of another episode."""
    body = {
        "session_id": turn["session_id"],
        "run_id": self._run.run_id,
        "benchmark": self._run.manifest,
        "episode": turn["episode"],
    }
    await self._calls.post("/v1/policy/reset", body)


@mutant("PUSH-018", through=instead_of(ProctorPolicy, "reset"))
async def resets_a_policy_once_for_an_attempt(
    right: Any, self: ProctorPolicy, turn: Mapping[str, Any]
) -> None:
    """After a fault, a policy acts on the memory of a world that is gone."""
    episode = turn["episode"]
    attempt = turn["session_id"], episode["episode_id"], episode["attempt"]
    done = self.__dict__.setdefault("reset_attempts", set())
    if attempt not in done:
        await right(self, turn)
    done.add(attempt)


@mutant("PUSH-007", through=instead_of(PolicyServerConfig, "from_run"))
def ignores_max_concurrent(right: Any, run: Run) -> Any:
    """A policy on one graphics card gets sixteen concurrent calls and runs out
    of memory.
    """
    config = right(run)
    if config.max_concurrent == 1:  # how many begin before one fails is luck
        return config
    changed = {name: getattr(config, name) for name in config.__slots__}
    return PolicyServerConfig(**changed | {"max_concurrent": run.max_workers})


@mutant("PUSH-008")
def changes_the_body_of_a_repeated_call() -> None:
    """A policy with a memory sees one step as two."""
    right = HttpCalls._call_with_deadline
    sent_bodies: set[bytes] = set()

    async def wrong(self: HttpCalls, call: Call) -> Any:
        content = call.content
        if content is not None and content in sent_bodies:
            content = content.replace(b'"done":false', b'"done":false,"again":true')
            call = replace(call, content=content)
        elif content is not None:
            sent_bodies.add(content)
        return await right(self, call)

    put(HttpCalls, "_call_with_deadline", wrong)


@mutant("PUSH-020")
def executes_the_response_to_a_repeated_call_twice() -> None:
    """A policy that is busy for a moment moves the robot twice as far."""
    right_call, right_predict = HttpCalls._call_with_deadline, ProctorPolicy.predict
    sent: list[bytes | None] = []

    async def call_with_deadline(self: HttpCalls, call: Call) -> Any:
        sent.append(call.content)
        return await right_call(self, call)

    async def predict(self: ProctorPolicy, turn: Any) -> Any:
        before = len(sent)
        answer = await right_predict(self, turn)
        calls = Counter(sent[before:])  # also those of other workers
        if max(calls.values()) > 1:
            answer.actions = answer.actions * 2
        return answer

    put(HttpCalls, "_call_with_deadline", call_with_deadline)
    put(ProctorPolicy, "predict", predict)


@mutant("PUSH-009", through=instead_of(HttpCalls, "_call_with_deadline"))
async def has_no_total_call_timeout(_right: Any, self: HttpCalls, call: Call) -> Any:
    """One byte per second holds a worker and its simulator for days."""
    try:
        return await self._send_once(call)
    except (httpcore.NetworkError, httpcore.RemoteProtocolError, OSError) as error:
        raise PolicyFault("is unreachable", retryable=True) from error


@mutant("PUSH-010", through=instead_of(effects, "end_by_policy"))
def omits_policy_fault_for_invalid_actions(
    right: Any, run: Run, session: Session, fault: str, now_wall: float
) -> None:
    """A run fails, and its episodes do not say that the policy was at fault."""
    episode = session.episode
    right(run, session, fault, now_wall)
    if episode is not None and "was refused" in fault:
        episode.policy_fault = None


@mutant("PUSH-011", through=instead_of(HttpCalls, "_send_once"))
async def follows_redirects(right: Any, self: HttpCalls, call: Call) -> Any:
    """The policy server decides where this server connects next."""
    try:
        return await right(self, call)
    except PolicyFault as fault:
        if not str(fault).startswith("redirects"):
            raise
    own = [] if self._key is None else [("Authorization", f"Bearer {self._key}")]
    async with self._pool.stream(
        call.method, self._url + call.path, headers=own, content=call.content
    ) as answer:
        redirect = dict(answer.headers)
    async with self._pool.stream(call.method, redirect[b"Location"]) as answer:
        raise PolicyFault(f"redirects (status {answer.status})")


@mutant("PUSH-021", through=instead_of(HttpCalls, "_call_with_deadline"))
async def repeats_a_call_that_the_policy_failed(
    right: Any, self: HttpCalls, call: Call
) -> Any:
    """A policy that raised acts once more on a state that has advanced; its error is
    never seen.
    """
    return await right(self, replace(call, has_state=False))


@mutant("PUSH-012", through=instead_of(effects, "fail_run"))
def fails_finally_when_the_policy_is_unreachable(
    right: Any, run: Run, reason: str, now_wall: float, **more: bool
) -> Any:
    """A restart of the policy server costs the results of its run."""
    sessions = right(run, reason, now_wall, **more)
    if run.state == "failed" and "is unreachable" in reason:
        run.retryable = False
    return sessions


@mutant("PUSH-012", "PUSH-019", through=instead_of(effects, "fail_run"))
def takes_the_fault_of_a_policy_upon_itself(
    right: Any, run: Run, reason: str, now_wall: float, **more: Any
) -> Any:
    """A platform does not count a submission whose policy server is down."""
    return right(run, reason, now_wall, **(more | {"failed_by": "server"}))


@mutant("PUSH-019", through=instead_of(ProctorPolicy, "describe"))
async def does_not_read_what_a_policy_assumes(
    right: Any, self: ProctorPolicy
) -> Description:
    """A policy that thinks in other units is scored as a bad one."""
    described: Description = await right(self)
    return replace(described, assumes=None)


@mutant("PUSH-013")
def never_plays_a_resumed_run() -> None:
    """A resumed run stays ready for ever."""
    right = Driver.changed
    played: set[str] = set()

    def wrong(self: Driver, run: Run) -> None:
        if run.state == "failed":
            played.add(run.run_id)
        if run.run_id not in played or run.state == "failed":
            right(self, run)

    put(Driver, "changed", wrong)


@mutant("PUSH-013")
def fails_finally_when_the_policy_refuses_to_describe_itself() -> None:
    """A run with a wrong path or key cannot be saved by the policy's host."""
    right = ProctorPolicy.describe
    refusing: set[str] = set()

    async def wrong_describe(self: ProctorPolicy) -> Any:
        try:
            return await right(self)
        except PolicyFault as fault:
            if "answered with status 4" in str(fault):
                refusing.add(self._run.run_id)
            raise

    right_fail = effects.fail_run

    def wrong(run: Run, reason: str, now_wall: float, **more: Any) -> Any:
        sessions = right_fail(run, reason, now_wall, **more)
        if run.state == "failed" and run.run_id in refusing:
            run.retryable = False
        return sessions

    put(ProctorPolicy, "describe", wrong_describe)
    put(effects, "fail_run", wrong)


@mutant("PUSH-017")
def does_not_continue_push_runs_after_a_restart() -> None:
    """After a restart of the server a push run stays ready without end."""
    put(Driver, "open", lambda _self: None)


@mutant("PUSH-014", through=instead_of(Driver, "_drive"))
async def continues_calling_after_a_stop(right: Any, self: Driver, run: Run) -> None:
    """A policy that is paid by the call is called for a stopped run."""
    try:
        await right(self, run)
    except asyncio.CancelledError:
        if run.state == "stopped":
            await asyncio.sleep(0.1)
            config = PolicyServerConfig.from_run(run)
            async with self._calls(config, None, run.account) as again:
                await policy_calls.ProctorPolicy(run, config, again).describe()
        raise
