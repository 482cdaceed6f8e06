"""Plays the runs with mode `push`: workers of this server that call a policy server.

PUSH-001: a worker attaches, gets actions from the policy and sends them as `predict`,
through the same use cases as any other client; what is scored, counted or stopped
follows from the same rules. One decision is made here: how long a policy may fail. A
fault ends the attempt; a policy server that does not answer `describe` after a fault,
or has faulted `max_faults` times without an executed turn in between, fails the run,
which can be resumed (PUSH-012). It must not know HTTP or a policy protocol: those are
in `calls_with_retries` and behind `PolicyAdapter`.
"""

from __future__ import annotations

import asyncio
import contextlib
import logging
import secrets
from collections.abc import Callable
from dataclasses import dataclass

from reference_record.generated.answers import Turn
from reference_server.process.backoff import Backoff
from reference_server.push.calls_with_retries import CallLimits, HttpCalls, PolicyFault
from reference_server.push.chat_calls import ChatPolicy, CompletionPolicy
from reference_server.push.egress import EgressPolicy
from reference_server.push.key_encryption import DecryptionFailed, KeyEncryption
from reference_server.push.policy_calls import (
    Description,
    PolicyAdapter,
    ProctorPolicy,
    answer_fault,
)
from reference_server.rules.policy_server import PolicyServerConfig
from reference_server.rules.refusal import Refused
from reference_server.rules.run_owner import OwnedElsewhere
from reference_server.rules.runs.lifecycle import (
    ACTIVE_STATES,
    PLAYABLE_STATES,
    Attach,
    Predict,
)
from reference_server.rules.runs.run import Run, RunFault, State
from reference_server.runs.memory.run_events import RunFollower
from reference_server.runs.service import RunService
from reference_server.storage.runs.run_store import StoreFailed
from reference_server.telemetry.repeated_failures import RepeatedFailures
from reference_server.telemetry.spans import root_span

log = logging.getLogger("proctor.push")

# The policy protocols, each a name of schema PolicyProtocol.
PROTOCOLS: dict[str, Callable[[Run, PolicyServerConfig, HttpCalls], PolicyAdapter]] = {
    "proctor": ProctorPolicy,
    "openai_chat": ChatPolicy,
    "openai_completions": CompletionPolicy,
}
# How often in a row this server may refuse its own worker before that is taken for a
# defect. Refusals for lack of capacity do not count: a simulator becomes free in time.
# Nor does a session that was ended while its policy thought, for others that waited.
REFUSALS_MAX = 50
_CAPACITY_CODES = ("no_capacity", "worker_limit", "session_ended")


class _RunCannotContinue(Exception):
    """The run cannot continue now; the message is its reason.

    permanent: nor can it after a resume.
    """

    def __init__(
        self, reason: str, *, by: RunFault = "server", permanent: bool = False
    ) -> None:
        super().__init__(reason)
        self.by = by
        self.permanent = permanent


@dataclass(slots=True)
class _Drive:
    """One run being played. faults: of the policy since the last executed turn."""

    run_id: str
    policy: PolicyAdapter
    description: Description
    calls: HttpCalls
    faults: int = 0


@dataclass(slots=True)
class _Worker:
    """backoff: restarted by every executed turn."""

    worker_id: str
    drive: _Drive
    backoff: Backoff


class Driver(RunFollower):
    """Plays every push run of this server that is ready or running."""

    def __init__(
        self,
        service: RunService,
        egress: EgressPolicy,
        key_encryption: KeyEncryption,
        max_bytes: int,
    ) -> None:
        self._service = service
        self._registry = service.registry
        self._egress = egress
        self._key_encryption = key_encryption
        self._max_bytes = max_bytes
        self._drives: dict[str, asyncio.Task[None]] = {}
        self._closed = False
        self._failures = RepeatedFailures(log)
        self._database_backoff = Backoff.of_database()
        service.registry.subscribe(self)

    def open(self) -> None:
        """PUSH-017: continue the runs that the last process left unfinished."""
        self._registry.work.start(self._check_all_runs())

    async def _check_all_runs(self) -> None:
        try:
            for run_id in await self._registry.push_runs():
                self._schedule_check(run_id)
        except StoreFailed:
            log.exception("the push runs could not be found")
            self._try_later(self._reopen)

    def _reopen(self) -> None:
        if not self._closed:
            self.open()

    async def stop_playing(self) -> None:
        """Cancel every call; the runs are continued at the next start."""
        self._closed = True
        drives = list(self._drives.values())
        for drive in drives:
            drive.cancel()
        if drives:
            await asyncio.wait(drives)

    async def close(self) -> None:
        await self.stop_playing()
        self._egress.close()

    def loaded(self, run: Run, stored: State) -> None:
        self.changed(run)

    def changed(self, run: Run) -> None:
        """Start to play the run, or stop playing it, as its state requires now.

        PUSH-013: a resumed run becomes ready, which starts it again.
        """
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
        """Check again: the run may have been stopped and resumed meanwhile."""
        del self._drives[run_id]
        self._schedule_check(run_id)

    async def _check_run(self, run_id: str) -> None:
        """PUSH-017: now, or when it can be loaded; no request may ever load it."""
        try:
            self.changed(await self._registry.get(run_id))
        except Refused:
            log.debug("run %s was deleted", run_id)
        except StoreFailed as error:
            self._failures.report("a push run could not be loaded", str(error))
            self._try_later(self._schedule_check, run_id)
        else:
            self._database_backoff.reset()

    def _try_later(self, call: Callable[..., None], *arguments: str) -> None:
        pause_s = self._database_backoff.next_s()
        asyncio.get_running_loop().call_later(pause_s, call, *arguments)

    def _schedule_check(self, run_id: str) -> None:
        if not self._closed:
            self._registry.work.start(self._check_run(run_id))

    async def _drive(self, run: Run) -> None:
        config = PolicyServerConfig.from_run(run)
        try:
            key = self._decrypt_key(config)
            async with self._calls(config, key, run.account) as calls:
                policy = PROTOCOLS[config.protocol](run, config, calls)
                drive = _Drive(run.run_id, policy, await policy.describe(), calls)
                await self._play_all(drive, config, len(run.pending))
        except OwnedElsewhere:
            log.info("run %s is played by another node", run.run_id)
        except PolicyFault as error:
            await self._fail_run(run, _RunCannotContinue(str(error), by="policy"))
        except _RunCannotContinue as error:
            await self._fail_run(run, error)
        except Exception:
            log.exception("run %s could not be played", run.run_id)
            text = "Internal server error; see the server log."
            await self._fail_run(run, _RunCannotContinue(text))

    def _decrypt_key(self, config: PolicyServerConfig) -> str | None:
        if config.sealed_key is None:
            return None
        try:
            return self._key_encryption.decrypt(config.sealed_key)
        except DecryptionFailed as error:
            raise _RunCannotContinue(
                "The API key of the policy server cannot be decrypted: the encryption "
                "key is lost. Submit the run again.",
                permanent=True,
            ) from error

    def _calls(
        self, config: PolicyServerConfig, key: str | None, account: str
    ) -> HttpCalls:
        limits = CallLimits(
            config.call_timeout_s,
            config.max_concurrent,
            config.max_retries,
            self._max_bytes,
        )
        return HttpCalls(config.url, self._egress, limits, key, account)

    async def _play_all(
        self, drive: _Drive, config: PolicyServerConfig, left: int
    ) -> None:
        # PUSH-007: a worker has one call in flight.
        workers = min(config.max_concurrent, drive.description.max_sessions, left)
        try:
            async with asyncio.TaskGroup() as group:
                for number in range(1, workers + 1):
                    backoff = Backoff.between_sessions()
                    worker = _Worker(f"push-{number}", drive, backoff)
                    group.create_task(self._run_worker(worker))
        except ExceptionGroup as errors:
            # Not `except*`: Python 3.11.2 wraps errors that are raised inside of it.
            if errors.subgroup(OwnedElsewhere):
                raise OwnedElsewhere(drive.run_id) from None
            faults, defects = errors.split((PolicyFault, _RunCannotContinue))
            if faults is None or defects is not None:
                raise
            raise faults.exceptions[0] from errors

    async def _run_worker(self, worker: _Worker) -> None:
        """Play one session after another, until no episode is left for the worker."""
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
        """Handle a refusal of this server's worker; raises unless waiting can help."""
        if isinstance(refused, OwnedElsewhere):
            raise refused
        # PUSH-019: another policy server may assume what the benchmark declares.
        if refused.code in ("convention_mismatch", "benchmark_unavailable"):
            details = "; ".join(f"{at} {text}" for at, text in refused.errors)
            redacted = drive.calls.redact_key(details)
            text = f"{refused.detail} {redacted}".strip()
            is_mismatch = refused.code == "convention_mismatch"
            raise _RunCannotContinue(text, by="policy" if is_mismatch else "server")
        if refusals > REFUSALS_MAX:
            raise _RunCannotContinue(
                f"The server rejected its own worker: {refused.detail}"
            )

    async def _play_session(self, worker: _Worker, run: Run) -> bool:
        """Play until the session is done; False if the policy's fault ended it."""
        command = Attach(
            worker.worker_id,
            secrets.token_urlsafe(16),
            assumes=worker.drive.description.assumes,
            by_server=True,
        )
        with root_span("push attach") as spent:
            spent.set("proctor.run_id", run.run_id)
            turn = await self._service.attach_worker(run.account, run.run_id, command)
        session_id = turn["session_id"]
        try:
            await self._play(worker, run, turn)
        except PolicyFault as fault:
            await self._handle_policy_fault(worker, run, session_id, fault)
            return False
        return True

    async def _play(self, worker: _Worker, run: Run, turn: Turn) -> None:
        while not turn["done"]:
            with root_span("push turn") as spent:
                spent.set("proctor.run_id", run.run_id)
                turn = await self._play_turn(worker, run, turn)
            worker.drive.faults = 0
            worker.backoff.reset()

    async def _play_turn(self, worker: _Worker, run: Run, turn: Turn) -> Turn:
        """The turn after this one."""
        drive = worker.drive
        if turn["episode"]["step"] == 0:  # PUSH-006, PUSH-018
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
            return await self._service.predict(run.account, run.run_id, command)
        except Refused as refused:
            if refused.code == "invalid_request":
                raise answer_fault(refused, drive.calls) from refused
            raise

    async def _handle_policy_fault(
        self, worker: _Worker, run: Run, session_id: str, fault: PolicyFault
    ) -> None:
        """PUSH-010: end the attempt, then check that the policy server answers."""
        log.info("run %s, %s: %s", run.run_id, worker.worker_id, fault)
        ended = await self._service.end_attempt_by_policy(
            run.run_id, worker.worker_id, session_id, str(fault)
        )
        if not ended:
            return
        drive = worker.drive
        drive.faults += 1
        if drive.faults >= run.manifest["max_faults"]:
            raise fault
        await drive.policy.describe()

    async def _fail_run(self, run: Run, why: _RunCannotContinue) -> None:
        """PUSH-012: the run fails; retryable unless a resume cannot help."""
        # If it cannot be stored, the run is played again once it is loaded.
        with contextlib.suppress(Refused, StoreFailed):
            await self._service.fail_run(
                run.run_id, str(why), failed_by=why.by, retryable=not why.permanent
            )


def _as_refused(error: Refused | StoreFailed) -> Refused:
    if isinstance(error, Refused):
        return error
    return Refused("unavailable", "The database is not available.")
