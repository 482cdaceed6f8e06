"""Mutants of push runs, in which the server calls the policy."""

from __future__ import annotations

import asyncio
from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import httpcore

from reference_server.push import policy_calls, policy_server_validator
from reference_server.push.driver import Driver
from reference_server.push.http_calls import Call, HttpCalls, PolicyFault
from reference_server.push.policy_calls import ProctorPolicy
from reference_server.rules import effects, lifecycle
from reference_server.rules.action_space import action_errors
from reference_server.rules.policy_server import PolicyServerConfig
from reference_server.rules.run import Run, Session
from tests.mutants import mutant, put
from tests.mutants.turns.predict import no_guard, replace_guard


@mutant("PUSH-001", "PUSH-010")
def plays_only_the_first_action_of_a_chunk() -> None:
    """A policy that answers chunks is scored for actions it did not choose."""
    right = ProctorPolicy.predict

    async def wrong(self: ProctorPolicy, turn: Any) -> Any:
        answer = await right(self, turn)
        answer.actions = answer.actions[:1]
        return answer

    put(ProctorPolicy, "predict", wrong)


@mutant("PUSH-001")
def cancels_the_calls_of_a_draining_run() -> None:
    """An orderly stop loses the episodes in play, and the run stays stopping."""
    right = Driver.on_run_changed

    def wrong(self: Driver, run: Run) -> None:
        right(self, run)
        if run.state == "stopping" and run.run_id in self._drives:
            self._drives[run.run_id].cancel()

    put(Driver, "on_run_changed", wrong)


@mutant("PUSH-002")
def accepts_a_policy_server_without_push_mode() -> None:
    """A run waits for workers without end, while its submitter waits for calls."""
    put(policy_server_validator, "_errors", lambda _submission: iter(()))
    right = policy_server_validator.PolicyServerValidator.validate_and_encrypt

    async def wrong(
        self: policy_server_validator.PolicyServerValidator,
        submission: dict[str, Any],
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


@mutant("PUSH-004")
def sends_the_key_only_to_predict() -> None:
    """A policy server that requires its key never gets a run."""
    right = HttpCalls._send_once

    async def wrong(self: HttpCalls, call: Call) -> Any:
        key = self._key
        self._key = key if call.path.endswith("/predict") else None
        try:
            return await right(self, call)
        finally:
            self._key = key

    put(HttpCalls, "_send_once", wrong)


@mutant("PUSH-005")
def exposes_the_key_in_a_reason() -> None:
    """A reader of the run can read the key of its policy server."""
    put(HttpCalls, "redact_key", lambda _self, text: text)


@mutant("PUSH-005")
def shows_the_media_type_of_an_answer_as_it_came() -> None:
    """A policy server that returns its key as media type publishes it."""
    right = HttpCalls._check

    def wrong(
        self: HttpCalls, status: int, headers: Mapping[str, str], body: bytes
    ) -> None:
        try:
            right(self, status, headers, body)
        except PolicyFault as fault:
            if not str(fault).startswith("answered with [API key"):
                raise
            raise PolicyFault(f"answered with {headers['content-type']}") from None

    put(HttpCalls, "_check", wrong)


@mutant("PUSH-005")
def shows_the_names_of_an_action_as_they_came() -> None:
    """A policy server that returns its key as the name of a value publishes it."""

    def wrong(errors: Any, _calls: HttpCalls) -> str:
        return "; ".join(f"{at} {text}" for at, text in errors)[:500]

    put(policy_calls, "_format_errors", wrong)


@mutant("PUSH-006")
def ignores_the_answer_to_reset() -> None:
    """A policy that was not ready continues with the memory of another episode."""

    async def wrong(self: ProctorPolicy, turn: Mapping[str, Any]) -> None:
        body = {
            "session_id": turn["session_id"],
            "run_id": self._run.run_id,
            "benchmark": self._run.manifest,
            "episode": turn["episode"],
        }
        await self._calls.post("/v1/policy/reset", body)

    put(ProctorPolicy, "reset", wrong)


@mutant("PUSH-007")
def ignores_max_concurrent() -> None:
    """A policy on one graphics card gets sixteen concurrent calls and runs out
    of memory.
    """
    right = PolicyServerConfig.from_run

    def wrong(run: Run) -> Any:
        config = right(run)
        if config.max_concurrent == 1:  # how many begin before one fails is luck
            return config
        changed = {name: getattr(config, name) for name in config.__slots__}
        return PolicyServerConfig(**changed | {"max_concurrent": run.max_workers})

    put(PolicyServerConfig, "from_run", wrong)


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


@mutant("PUSH-009")
def has_no_total_call_timeout() -> None:
    """One byte per second holds a worker and its simulator for days."""

    async def wrong(self: HttpCalls, call: Call) -> Any:
        try:
            return await self._send_once(call)
        except (httpcore.NetworkError, httpcore.RemoteProtocolError, OSError) as error:
            raise PolicyFault("is unreachable", retryable=True) from error

    put(HttpCalls, "_call_with_deadline", wrong)


@mutant("PUSH-010")
def omits_policy_fault_for_invalid_actions() -> None:
    """A run fails, and its episodes do not say that the policy was at fault."""
    right = effects.end_by_policy

    def wrong(run: Run, session: Session, fault: str, now_wall: float) -> None:
        episode = session.episode
        right(run, session, fault, now_wall)
        if episode is not None and "was refused" in fault:
            episode.policy_fault = None

    put(effects, "end_by_policy", wrong)


@mutant("PUSH-010")
def executes_the_beginning_of_a_chunk_that_is_too_long() -> None:
    """A policy is scored for a part of an answer, and its author is not warned."""
    right = ProctorPolicy.predict

    async def wrong(self: ProctorPolicy, turn: Any) -> Any:
        answer = await right(self, turn)
        del answer.actions[self._run.manifest["max_chunk"] :]
        return answer

    put(ProctorPolicy, "predict", wrong)


@mutant("PUSH-010")
def executes_what_stands_before_an_invalid_action() -> None:
    """A policy is scored for half an answer, and its author looks for the fault."""
    right = ProctorPolicy.predict

    async def wrong(self: ProctorPolicy, turn: Any) -> Any:
        answer = await right(self, turn)
        values, manifest = [a.values for a in answer.actions], self._run.manifest
        for at in range(1, len(values)):
            if action_errors(values[at : at + 1], manifest):
                del answer.actions[at:]
                break
        return answer

    put(ProctorPolicy, "predict", wrong)


@mutant("PUSH-011")
def follows_redirects() -> None:
    """The policy server decides where this server connects next."""
    right = HttpCalls._send_once

    async def wrong(self: HttpCalls, call: Call) -> Any:
        try:
            return await right(self, call)
        except PolicyFault as fault:
            if not str(fault).startswith("redirects"):
                raise
        own = [] if self._key is None else [("Authorization", f"Bearer {self._key}")]
        async with self._pool.stream(
            call.method, self._url + call.path, headers=own, content=call.content
        ) as answer:
            found = dict(answer.headers)
        async with self._pool.stream(call.method, found[b"Location"]) as answer:
            raise PolicyFault(f"redirects (status {answer.status})")

    put(HttpCalls, "_send_once", wrong)


@mutant("PUSH-011")
def repeats_a_call_that_was_redirected() -> None:
    """A policy behind a wrong address seems to be well, and no fault says so."""
    right = HttpCalls._send_once

    async def wrong(self: HttpCalls, call: Call) -> Any:
        try:
            return await right(self, call)
        except PolicyFault as fault:
            fault.retryable |= str(fault).startswith("redirects")
            raise

    put(HttpCalls, "_send_once", wrong)


@mutant("PUSH-012")
def fails_finally_when_the_policy_is_unreachable() -> None:
    """A restart of the policy server costs the results of its run."""
    right = effects.fail_run

    def wrong(run: Run, reason: str, now_wall: float, **more: bool) -> Any:
        sessions = right(run, reason, now_wall, **more)
        if run.state == "failed" and "is unreachable" in reason:
            run.retryable = False
        return sessions

    put(effects, "fail_run", wrong)


@mutant("PUSH-013")
def never_plays_a_resumed_run() -> None:
    """A resumed run stays ready for ever."""
    right = Driver.on_run_changed
    played: set[str] = set()

    def wrong(self: Driver, run: Run) -> None:
        if run.state == "failed":
            played.add(run.run_id)
        if run.run_id not in played or run.state == "failed":
            right(self, run)

    put(Driver, "on_run_changed", wrong)


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

    def wrong(run: Run, reason: str, now_wall: float, **more: bool) -> Any:
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


@mutant("PUSH-014")
def continues_calling_after_a_stop() -> None:
    """A policy that is paid by the call is called for a stopped run."""
    right = Driver._drive

    async def wrong(self: Driver, run: Run) -> None:
        try:
            await right(self, run)
        except asyncio.CancelledError:
            if run.state == "stopped":
                await asyncio.sleep(0.1)
                config = PolicyServerConfig.from_run(run)
                async with self._calls(config, None, run.account) as again:
                    await policy_calls.ProctorPolicy(run, config, again).describe()
            raise

    put(Driver, "_drive", wrong)


@mutant("PUSH-014")
def repeats_the_calls_of_a_stopped_run() -> None:
    """A policy that is overloaded is called for runs that were stopped long ago."""
    right = Driver.on_run_changed

    def wrong(self: Driver, run: Run) -> None:
        if run.state == "stopped":
            asyncio.get_running_loop().call_later(5, right, self, run)
        else:
            right(self, run)

    put(Driver, "on_run_changed", wrong)
