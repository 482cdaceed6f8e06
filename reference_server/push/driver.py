"""Plays the runs with mode `push`: workers of this server that ask a policy server.

A client of the stage like any other: it attaches, asks the policy, predicts, and what
was scored, counted or stopped follows from the same rules. It holds no rule but how
long a policy may fail: an attempt ends with its fault; a policy server that does not
describe itself after a fault, or has faulted `max_faults` times without a turn in
between, fails the run, which can be resumed.
"""

from __future__ import annotations

import asyncio
import contextlib
import logging
import secrets
import time
from dataclasses import dataclass
from typing import Any

from reference_server.push.egress import EgressPolicy
from reference_server.push.http_calls import Backoff, CallLimits, HttpCalls, PolicyFault
from reference_server.push.key_encryption import DecryptionFailed, KeyEncryption
from reference_server.push.policy_calls import Description, PolicyAdapter, answer_fault
from reference_server.push.policy_protocols import PROTOCOLS
from reference_server.rules import effects
from reference_server.rules.lifecycle import (
    ACTIVE_STATES,
    PLAYABLE_STATES,
    Attach,
    Predict,
)
from reference_server.rules.policy_server import PolicyServerConfig
from reference_server.rules.refusal import Refused
from reference_server.rules.run import Run
from reference_server.runs.registry import RELOAD_S, RunRegistry
from reference_server.runs.session_executor import SessionExecutor
from reference_server.storage.store import StoreFailed

log = logging.getLogger("proctor.push")

# How long a worker pauses, at first and at most, that the server itself turned away or
# whose policy went wrong; and how often it may be turned away before that is taken for
# a defect. A server without a free simulator frees one in time.
PAUSE_S = 0.2
PAUSE_MOST_S = 5.0
REFUSALS_MOST = 50
_CAPACITY_CODES = ("no_capacity", "worker_limit")


class _RunCannotContinue(Exception):
    """The run cannot go on now; the message is its reason.

    for_good: nor will it after a resume.
    """

    def __init__(self, reason: str, *, permanent: bool = False) -> None:
        super().__init__(reason)
        self.permanent = permanent


@dataclass(slots=True)
class _Drive:
    """One run in play. faults: of the policy since a turn was last executed."""

    run_id: str
    policy: PolicyAdapter
    description: Description
    calls: HttpCalls
    faults: int = 0


@dataclass(slots=True)
class _Worker:
    """pauses: since it last had a turn executed."""

    worker_id: str
    drive: _Drive
    backoff: Backoff


class Driver:
    """Every push run of this server that has capacity."""

    def __init__(
        self,
        registry: RunRegistry,
        executor: SessionExecutor,
        egress: EgressPolicy,
        key_encryption: KeyEncryption,
        max_bytes: int,
    ) -> None:
        self._registry = registry
        self._executor = executor
        self._egress = egress
        self._key_encryption = key_encryption
        self._max_bytes = max_bytes
        self._drives: dict[str, asyncio.Task[None]] = {}
        self._closed = False

    def open(self) -> None:
        """Go on with the runs that the last process left."""
        for run_id in self._registry.active():
            self._registry.run_in_background(self._check_run(run_id))

    async def close(self) -> None:
        """End every call and drive; their runs are found ready again."""
        self._closed = True
        drives = list(self._drives.values())
        for drive in drives:
            drive.cancel()
        if drives:
            await asyncio.wait(drives)
        self._egress.close()

    def on_run_changed(self, run: Run) -> None:
        """Something of the run has changed: begin to play it, or end that."""
        if not run.is_push or self._closed:
            return
        drive = self._drives.get(run.run_id)
        if drive is None and run.state in PLAYABLE_STATES:
            drive = asyncio.ensure_future(self._drive(run))
            self._drives[run.run_id] = drive
            drive.add_done_callback(lambda _: self._on_drive_done(run.run_id))
        elif drive is not None and run.state not in ACTIVE_STATES:
            drive.cancel()  # PUSH-014

    def _on_drive_done(self, run_id: str) -> None:
        """A run that was stopped and resumed meanwhile is played on."""
        del self._drives[run_id]
        self._schedule_check(run_id)

    async def _check_run(self, run_id: str) -> None:
        """Now or when it can be loaded: nobody else may ever do that (PUSH-017)."""
        try:
            self.on_run_changed(await self._registry.get(run_id))
        except StoreFailed:
            log.exception("run %s could not be loaded", run_id)
            loop = asyncio.get_running_loop()
            loop.call_later(RELOAD_S, self._schedule_check, run_id)

    def _schedule_check(self, run_id: str) -> None:
        if not self._closed:
            self._registry.run_in_background(self._check_run(run_id))

    async def _drive(self, run: Run) -> None:
        config = PolicyServerConfig.from_run(run)
        try:
            async with self._calls(config, self._decrypt_key(config)) as calls:
                policy = PROTOCOLS[config.protocol](run, config, calls)
                drive = _Drive(run.run_id, policy, await policy.describe(), calls)
                await self._play_all(drive, config, len(run.pending))
        except PolicyFault as error:
            await self._fail_run(run.run_id, str(error))
        except _RunCannotContinue as error:
            await self._fail_run(run.run_id, str(error), retryable=not error.permanent)
        except Exception:
            log.exception("run %s could not be played", run.run_id)
            await self._fail_run(run.run_id, "The server has a defect; see its log.")

    def _decrypt_key(self, config: PolicyServerConfig) -> str | None:
        if config.sealed_key is None:
            return None
        try:
            return self._key_encryption.decrypt(config.sealed_key)
        except DecryptionFailed as error:
            raise _RunCannotContinue(
                "The API key of the policy server cannot be read any more: this server "
                "has lost the key that sealed it. Submit the run anew.",
                permanent=True,
            ) from error

    def _calls(self, config: PolicyServerConfig, key: str | None) -> HttpCalls:
        limits = CallLimits(
            config.call_timeout_s,
            config.max_concurrent,
            config.max_retries,
            self._max_bytes,
        )
        return HttpCalls(config.url, self._egress, limits, key)

    async def _play_all(
        self, drive: _Drive, config: PolicyServerConfig, left: int
    ) -> None:
        workers = min(config.max_concurrent, drive.description.max_sessions, left)
        try:
            async with asyncio.TaskGroup() as group:
                for number in range(1, workers + 1):
                    backoff = Backoff(PAUSE_S, PAUSE_MOST_S)
                    worker = _Worker(f"push-{number}", drive, backoff)
                    group.create_task(self._run_worker(worker))
        except* (PolicyFault, _RunCannotContinue) as errors:
            reason = str(errors.exceptions[0])
            raise _RunCannotContinue(reason) from errors

    async def _run_worker(self, worker: _Worker) -> None:
        """Play one session after another, until there is nothing left for it."""
        refusals = 0
        while True:
            try:
                run = await self._registry.get(worker.drive.run_id)
                if run.state not in PLAYABLE_STATES or not run.pending:
                    return
                succeeded = await self._play_session(worker, run)
                refusals = 0
            except (Refused, StoreFailed) as error:
                refused, succeeded = _as_refused(error), False
                refusals += refused.code not in _CAPACITY_CODES
                self._handle_refusal(worker.drive, refused, refusals)
            if not succeeded:
                await asyncio.sleep(worker.backoff.next_s())

    def _handle_refusal(self, drive: _Drive, refused: Refused, refusals: int) -> None:
        """The server refused its own worker: raises unless that will pass."""
        if refused.code in ("convention_mismatch", "benchmark_unavailable"):
            details = "; ".join(f"{at} {text}" for at, text in refused.errors)
            redacted = drive.calls.redact_key(details)
            raise _RunCannotContinue(f"{refused.detail} {redacted}".strip())
        if refusals > REFUSALS_MOST:
            raise _RunCannotContinue(
                f"The server refused its own worker: {refused.detail}"
            )

    async def _play_session(self, worker: _Worker, run: Run) -> bool:
        """Whether it came to its end without a fault of the policy."""
        command = Attach(
            worker.worker_id,
            secrets.token_urlsafe(16),
            assumes=worker.drive.description.assumes,
            by_server=True,
        )
        turn = await self._executor.attach(run, command)
        session_id = turn["session_id"]
        try:
            await self._play(worker, run, turn)
        except PolicyFault as fault:
            await self._handle_policy_fault(worker, run, session_id, fault)
            return False
        return True

    async def _play(self, worker: _Worker, run: Run, turn: dict[str, Any]) -> None:
        drive = worker.drive
        while not turn["done"]:
            if turn["episode"]["step"] == 0:  # PUSH-006
                await drive.policy.reset(turn)
            answer = await drive.policy.predict(turn)
            command = Predict(
                worker.worker_id,
                answer.session_id,
                answer.seq,
                [action.values for action in answer.actions],
                "all" if answer.observe == "all" else "last",
                by_server=True,
            )
            try:
                turn = await self._executor.predict(run, command)
            except Refused as refused:
                if refused.code == "invalid_request":
                    raise answer_fault(refused, drive.calls) from refused
                raise
            drive.faults = 0
            worker.backoff.reset()

    async def _handle_policy_fault(
        self, worker: _Worker, run: Run, session_id: str, fault: PolicyFault
    ) -> None:
        """End the attempt; then see whether the policy is still there."""
        log.info("run %s, %s: %s", run.run_id, worker.worker_id, fault)
        drive, session = worker.drive, run.workers.get(worker.worker_id)
        if session is None or session.session_id != session_id:
            return  # stopped, or lost, meanwhile
        effects.end_by_policy(run, session, str(fault), time.time())
        self._executor.release_sessions([session])
        await self._registry.commit(run)
        drive.faults += 1
        if drive.faults >= run.manifest["max_faults"]:
            raise fault
        await drive.policy.describe()

    async def _fail_run(
        self, run_id: str, reason: str, *, retryable: bool = True
    ) -> None:
        """PUSH-012: the run fails, and can be resumed if that helps."""
        # What cannot be stored is forgotten; the run is played on when it is loaded.
        with contextlib.suppress(Refused, StoreFailed):
            run = await self._registry.get(run_id)
            ended = effects.fail_run(run, reason, time.time(), retryable=retryable)
            self._executor.release_sessions(ended)
            await self._registry.commit(run)


def _as_refused(error: Refused | StoreFailed) -> Refused:
    if isinstance(error, Refused):
        return error
    return Refused("unavailable", "The store does not answer.")
