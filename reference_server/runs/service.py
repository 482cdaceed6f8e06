"""The use cases: what a caller can do with runs, whichever API the request came by.

The HTTP handlers and the profiles call it with an account and plain arguments. It asks
the rules what is allowed, and lets the registry and the session executor carry it out.
It knows no HTTP: no request, no header, no status. Views are plain data in the spec's
schemas. All methods raise Refused, and StoreFailed when the database fails.
"""

from __future__ import annotations

import asyncio
import contextlib
import hashlib
import secrets
import time
from collections.abc import Awaitable, Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import Any, Literal, Protocol

import msgspec

from reference_record.contents.statement import SecondJudgement
from reference_record.generated import answers
from reference_record.unsigned_record import Record
from reference_server.records.run_records import RecordUnavailable, RunRecords
from reference_server.rules import comparison
from reference_server.rules.manifest import Submission
from reference_server.rules.refusal import Refused, no_profile
from reference_server.rules.run_owner import OwnedElsewhere
from reference_server.rules.runs import effects
from reference_server.rules.runs.lifecycle import (
    OPEN_STATES,
    Attach,
    Availability,
    Delete,
    Detach,
    Heartbeat,
    Predict,
    Refuse,
    Resume,
    Stop,
    availability,
    changes_state,
    decide,
    refuse_record,
)
from reference_server.rules.runs.run import (
    Episode,
    PublicKey,
    Run,
    RunFault,
    RunHead,
    index_of,
)
from reference_server.rules.submission import (
    KeyUse,
    SubmissionLimits,
    grant_limits,
    key_conflict,
)
from reference_server.runs.benchmarks import Benchmarks
from reference_server.runs.memory.score_cache import ScoreCache
from reference_server.runs.registry import RunRegistry
from reference_server.runs.sessions.session_executor import SessionExecutor
from reference_server.storage.runs.run_store import RunIsKept
from reference_server.views import run_views, turn_view

# Completes a submission of an account; refuses a policy server that cannot be called.
SubmissionValidator = Callable[[Submission, str], Awaitable[Submission]]
# (runs, endpoint) → those that their owners show now, by id.
ViewsElsewhere = Callable[
    [Sequence[RunHead], str], Awaitable[Mapping[str, answers.Run]]
]

RunCommand = Literal["stop", "resume"]
# (command, account, run id): carries out a command at this node; raises Refused and
# StoreFailed.
CarryOut = Callable[[RunCommand, str, str], Awaitable[None]]
# Carries out a command at the node that has the run, with CarryOut if that is this one.
CommandElsewhere = Callable[[RunCommand, str, str, CarryOut], Awaitable[None]]

DAY_S = 86_400.0


async def no_views_elsewhere(
    _runs: Sequence[RunHead], _endpoint: str
) -> Mapping[str, answers.Run]:
    """The default of `views_elsewhere`: without a cluster every run is here."""
    return {}


async def no_command_elsewhere(
    _command: RunCommand, _account: str, _id: str, _carry_out: CarryOut
) -> None:
    """The default without a cluster, where no other node has a run."""
    raise AssertionError("every run is here")


def no_second_judgements(_run_id: str) -> Sequence[SecondJudgement]:
    """The default of `second_judgements`: no person judges."""
    return ()


class AccountAdmission(Protocol):
    """Decides whether an account may make a run, beside the limits of this server."""

    async def admit(self, run: Run) -> None:
        """Raises Refused."""

    async def withdraw(self, run: Run) -> None:
        """The run was admitted, and not made."""

    async def drawn_seeds(
        self, account: str, submission: Mapping[str, Any]
    ) -> Mapping[str, Any] | None:
        """`seeds_drawn` of the run that a submission makes. Raises Refused."""


@dataclass(frozen=True, slots=True)
class RunService:
    """The use cases over one server's parts."""

    limits: SubmissionLimits
    benchmarks: Benchmarks
    registry: RunRegistry
    executor: SessionExecutor
    validate_submission: SubmissionValidator
    # Leaves the parts of a submission by which two are compared, without secrets.
    comparable_submission: Callable[[Submission], Submission]
    # None where nothing is recorded.
    records: RunRecords | None = None
    # The second judgements of a run, as the statement of its record has them.
    second_judgements: Callable[[str], Sequence[SecondJudgement]] = no_second_judgements
    deletes_played: bool = False  # DEL-003
    # Whether a run has an entry for which it stays, by its id and whether the host
    # deletes it. None where there is no board.
    is_kept: Callable[[str, bool], Awaitable[bool]] | None = None
    scores: ScoreCache = field(default_factory=ScoreCache)
    # In a cluster: runs of other nodes by id, as these show them under an endpoint.
    views_elsewhere: ViewsElsewhere = no_views_elsewhere
    # And what carries out a command for a run of another node.
    command_elsewhere: CommandElsewhere = no_command_elsewhere
    # None where every account may make runs.
    admission: AccountAdmission | None = None

    # --- control plane ---

    async def submit_run(
        self, account: str, submission: Submission, idempotency_key: str | None = None
    ) -> Run:
        """A new run, or the one that the key made; submission: schema SubmitRun."""
        run = await self.prepare_run(account, submission)
        body_sha256 = body_digest(self.comparable_submission(submission))
        return await self.store_run(run, idempotency_key, body_sha256)

    async def prepare_run(self, account: str, submission: Submission) -> Run:
        """The run that a submission makes, checked and not stored yet."""
        checked = await self.validate_submission(submission, account)
        drawn = None
        if self.admission is not None:
            drawn = await self.admission.drawn_seeds(account, checked)
        resolved = await self.benchmarks.resolve(checked, drawn)
        granted = grant_limits(checked, self.limits)
        if isinstance(granted, Refuse):
            raise Refused.from_verdict(granted)
        now = time.time()
        return Run(
            run_id=f"run_{secrets.token_hex(12)}",
            number=0,
            account=account,
            state="queued",  # RUN-002; ready if there is capacity (LIFE-801)
            reason=None,
            retryable=None,
            manifest=resolved.manifest,
            manifest_sha256=resolved.manifest_sha256,
            submission=checked,
            max_workers=granted.max_workers,
            idle_timeout_s=granted.idle_timeout_s,
            images=resolved.images,
            created_at_wall=now,
            updated_at_wall=now,
            queue_until_wall=self.registry.admission.queue_until(checked),
            episodes=[
                Episode.of(resolved.manifest, index)
                for index in range(len(resolved.manifest["episodes"]))
            ],
        )

    async def store_run(
        self, run: Run, idempotency_key: str | None, body_sha256: str
    ) -> Run:
        """Store a prepared run; or return the one that the key made of this body."""
        if self.admission is None:
            return await self.registry.add(run, idempotency_key, body_sha256)
        if idempotency_key is not None:
            use = await self.find_by_key(run.account, idempotency_key)
            if use is not None:  # a repeat makes no run
                return await self.registry.add(run, idempotency_key, body_sha256)
        await self.admission.admit(run)
        stored: Run | None = None
        try:
            stored = await self.registry.add(run, idempotency_key, body_sha256)
        finally:
            if stored is not run:
                await self.admission.withdraw(run)
        return stored

    async def find_by_key(self, account: str, idempotency_key: str) -> KeyUse | None:
        """The run that an Idempotency-Key of the account made, if any."""
        return await self.registry.find_by_key(account, idempotency_key)

    async def check_key(
        self, account: str, idempotency_key: str, body_sha256: str
    ) -> None:
        """Refused when the key made a run of another body (RUN-004)."""
        use = await self.find_by_key(account, idempotency_key)
        conflict = None if use is None else key_conflict(use, body_sha256)
        if conflict is not None:
            raise Refused.from_verdict(conflict)

    async def stop_run(
        self,
        account: str,
        run_id: str,
        mode: Literal["abort", "drain"] = "abort",
        reason: str | None = None,
        *,
        of_all_accounts: bool = False,
    ) -> Run:
        """The run, stopped (abort) or stopping (drain).

        of_all_accounts: the host may stop the runs of others (AUTH-008), and each says
        that it did.
        """
        owner = None if of_all_accounts else account
        run = await self._run_accepting(owner, run_id, Stop(mode))
        by = "its submitter" if run.account == account else "the host of this server"
        ended = effects.stop(run, mode, time.time(), by, reason)
        self.executor.release_sessions(ended)
        await self.registry.writer.commit(run)
        return run

    async def resume_run(self, account: str, run_id: str) -> Run:
        """The run, in the queue again; unchanged when it goes on already."""
        run = await self._run_accepting(account, run_id, Resume())
        if changes_state(run, "resume_run"):
            await self.registry.check_open_elsewhere(run.account)
            run = await self._run_accepting(account, run_id, Resume())
        if changes_state(run, "resume_run"):
            self.executor.require_playable(run)
            self.registry.open_again(run)
            effects.resume(run, self.registry.admission.queue_until(run.submission))
            await self.registry.commit_opened(run)
        return run

    async def command_run(self, command: RunCommand, account: str, run_id: str) -> None:
        """Stop a run (abort) or resume it, whichever node of a cluster has it."""
        try:
            await self.command_run_here(command, account, run_id)
        except OwnedElsewhere:
            here = self.command_run_here
            await self.command_elsewhere(command, account, run_id, here)

    async def command_run_here(
        self, command: RunCommand, account: str, run_id: str
    ) -> None:
        """Stop a run (abort) or resume it. Raises OwnedElsewhere in a cluster."""
        commands = {"stop": self.stop_run, "resume": self.resume_run}
        await commands[command](account, run_id)

    async def delete_run(self, account: str, run_id: str) -> None:
        """Delete a run that is not in play, and all that was recorded of it."""
        command = Delete(may_be_played=self.deletes_played)
        await self._run_accepting(account, run_id, command)
        if await self._is_kept(run_id, by_host=False):
            raise _has_entry()
        await self._delete(run_id, command)

    async def delete_old(self, keep_days: float) -> int:
        """DEL-007: delete the runs that ended so long ago, and have no public entry.

        A private entry goes with its run. One after another, with other requests in
        between. Returns how many.
        """
        before_wall, last, deleted = time.time() - keep_days * DAY_S, 0, 0
        while page := await self.registry.ended_since(before_wall, last):
            for last, run_id in page:  # noqa: B007 - where the next page begins
                if not await self._is_kept(run_id, by_host=True):
                    # It may be deleted, resumed or published meanwhile.
                    with contextlib.suppress(Refused):
                        await self._delete(
                            run_id, Delete(ended_before_wall=before_wall)
                        )
                        deleted += 1
        return deleted

    async def _is_kept(self, run_id: str, *, by_host: bool) -> bool:
        return self.is_kept is not None and await self.is_kept(run_id, by_host)

    async def _delete(self, run_id: str, command: Delete) -> None:
        run = await self._run_accepting(None, run_id, command)
        # Nothing was awaited since it was accepted: no worker attaches from here on.
        self.executor.release_sessions(effects.stop(run, "abort", time.time()))
        try:
            by_host = command.ended_before_wall is not None
            await self.registry.writer.delete(run, by_host=by_host)
        except RunIsKept as error:  # published since that was looked at
            raise _has_entry() from error
        if self.records is not None:
            await self.records.remove_run(run_id)

    async def compare_runs(
        self,
        account: str | None,
        run_ids: Sequence[str],
        tolerance: float = comparison.TOLERANCE,
    ) -> answers.Comparison:
        """Compare runs; the first is the baseline.

        CMP-001: in the order named. CMP-010: of runs that the account may see. CMP-011:
        in every state.
        """
        runs, scored = [], []
        for run_id in run_ids:
            read = partial(self.registry.reader.read_view, run_id, account, end=None)
            run, episodes = await read(
                lambda run, all_: (run, run_views.scored_episodes(all_))
            )
            runs.append(run)
            scored.append(episodes)
            await asyncio.sleep(0)  # others are served between two runs
        mismatch = comparison.manifest_mismatch(
            [(run.run_id, run.manifest_sha256, run.manifest) for run in runs]
        )
        if mismatch is not None:
            raise Refused.from_verdict(mismatch)
        entries: list[answers.ComparedRun] = []
        for run_id, episodes in zip(run_ids[1:], scored[1:], strict=True):
            compared = comparison.compare(scored[0], episodes, tolerance)
            entries.append({"run_id": run_id, **compared})
            await asyncio.sleep(0)
        return run_views.comparison_view(runs[0], tolerance, entries)

    # --- views ---

    async def get_run(self, account: str, run_id: str) -> Run:
        """The run in memory, with every lease that is over ended.

        Show it only through `render_when_stored`: memory may be ahead of the database,
        and a crash would take back a change that a client has seen.
        """
        run = await self.registry.get(run_id, account)
        self.executor.sweep(run)
        return run

    async def options_of_run(self, run_id: str) -> Mapping[str, Any] | None:
        """The options of its benchmark, for a caller that may see the run."""
        options: Mapping[str, Any] | None = await self.registry.reader.read_view(
            run_id, None, lambda run, _episodes: run.submission.get("options")
        )
        return options

    async def find_run(self, account: str, run_id: str) -> RunHead:
        """As `get_run`; in a cluster that of another node as it is stored."""
        try:
            return await self.get_run(account, run_id)
        except OwnedElsewhere:
            return await self.registry.reader.read_view(
                run_id, account, lambda run, _episodes: run
            )

    async def check_readable(self, account: str | None, run_id: str) -> None:
        """Raise Refused unless the account may read the run, on whichever node."""
        await self.registry.reader.read_view(run_id, account, lambda run, _: run)

    async def get_availability(
        self, account: str, run_id: str
    ) -> tuple[RunHead, Availability]:
        """The run as it is stored, and whether workers may attach to it."""
        return await self.registry.reader.read_view(
            run_id, account, lambda run, _episodes: (run, availability(run))
        )

    async def view_run(
        self, account: str | None, run_id: str, endpoint: str
    ) -> answers.Run:
        """Schema Run, of what is stored."""
        view = partial(self.current_view, endpoint)
        return await self.registry.reader.read_view(run_id, account, view)

    async def view_stored(self, run: Run, endpoint: str) -> answers.Run:
        """Schema Run of a run that was just changed, once the change is stored."""
        view = partial(self._whole_view, endpoint)
        return await self.registry.reader.render_when_stored(run, view)

    async def list_runs(
        self, account: str | None, before: int | None, limit: int, endpoint: str
    ) -> list[tuple[int, answers.Run]]:
        """(number, schema Run) of the account's runs below a number, newest first."""

        elsewhere: list[RunHead] = []

        def view(run: RunHead) -> tuple[int, answers.Run]:
            if run.state in OPEN_STATES and self.registry.cache.is_elsewhere(run):
                elsewhere.append(run)
            return run.number, self._run_view(endpoint, run)

        views = await self.registry.reader.page(account, before, limit, view)
        if elsewhere:
            fresh = await self.views_elsewhere(elsewhere, endpoint)
            views = [(n, fresh.get(body["run_id"], body)) for n, body in views]
        return views

    async def list_episodes(
        self, account: str | None, run_id: str, start: int, end: int
    ) -> tuple[list[answers.Episode], int]:
        """Episodes from start to end (EPI-006), and how many there are."""

        def view(
            run: RunHead, page: Sequence[Episode]
        ) -> tuple[list[answers.Episode], int]:
            return [run_views.episode_view(episode) for episode in page], run.total

        return await self.registry.reader.read_view(run_id, account, view, start, end)

    async def get_score(self, account: str | None, run_id: str) -> answers.Score:
        """The score of a run, in every state."""
        return await self.scores.get(self.registry.reader, run_id, account)

    # --- records ---

    async def list_keys(self) -> list[PublicKey]:
        """Every key that signed a record, the newest first."""
        return await self._require_records().keys()

    async def fetch_record(self, account: str | None, run_id: str) -> Record:
        """The signed record of a completed run that the account may see (REC-108)."""
        records = self._require_records()
        run, episodes = await self.registry.reader.read_view(
            run_id, account, lambda run, all_: (run, all_), end=None
        )
        refused = refuse_record(run)
        if refused is not None:
            raise Refused.from_verdict(refused)
        score = await self.get_score(account, run_id)
        try:
            second = self.second_judgements(run_id)
            return await records.fetch(run, episodes, score, second)
        except RecordUnavailable as error:  # the id is right
            raise Refused("not_found", str(error), act="") from error

    async def find_recording(
        self, account: str | None, run_id: str, episode_id: str
    ) -> tuple[Path, int]:
        """The recording of an episode that has its result (REC-125): file and size."""
        records = self._require_records()
        index = index_of(episode_id)
        start = 0 if index is None else index
        _, episodes = await self.registry.reader.read_view(
            run_id, account, lambda run, some: (run, some), start, start + 1
        )
        if index is None or not episodes:
            raise Refused("not_found", f"The run has no episode {episode_id[:20]}.")
        size = await records.recording_size(run_id, episodes[0])
        if size is None:
            raise Refused("not_found", f"{episode_id} has no recording.")
        return records.recording_path(run_id, episodes[0]), size

    def _require_records(self) -> RunRecords:
        if self.records is None:
            raise no_profile("This server records nothing.")
        return self.records

    def current_view(self, endpoint: str, run: RunHead, *_: object) -> answers.Run:
        """The run with every lease that is over ended first."""
        if isinstance(run, Run):  # else no session of it is live
            self.executor.sweep(run)
        return self._whole_view(endpoint, run)

    def _whole_view(self, endpoint: str, run: RunHead) -> answers.Run:
        """With the reason why a run that waits for workers cannot be played."""
        view = self._run_view(endpoint, run)
        why = self.executor.why_unplayable(run) if run.state in OPEN_STATES else None
        if why is not None:
            view["reason"] = why
        return view

    def _run_view(self, endpoint: str, run: RunHead) -> answers.Run:
        position = self.registry.admission.queue_position(run)
        return run_views.run_view(run, endpoint, position)

    # --- data plane ---

    async def attach_worker(
        self, account: str, run_id: str, command: Attach
    ) -> answers.Turn:
        """Schema Turn: the session's latest; turn 0 for a new session."""
        run = await self.registry.get(run_id, account)
        return await self.executor.attach(run, command)

    async def predict(
        self, account: str, run_id: str, command: Predict
    ) -> answers.Turn:
        """Schema Turn; executed once, however often it is requested."""
        run = await self.registry.get(run_id, account)
        return await self.executor.predict(run, command)

    async def find_refused(
        self, account: str, run_id: str, commands: Sequence[Predict]
    ) -> tuple[Predict, Refuse] | None:
        """The first of several predicts that would be refused now; None if none is.

        For an API that sends them together and executes all or none.
        """
        run = await self.registry.get(run_id, account)
        now = self.executor.sweep(run)
        for command in commands:
            verdict = decide(run, command, now)
            if isinstance(verdict, Refuse):
                return command, verdict
        return None

    async def heartbeat(
        self, account: str, run_id: str, command: Heartbeat
    ) -> answers.Lease:
        """The lease, extended; RSN-003: a reason is stored before this is answered."""
        run = await self.registry.get(run_id, account)
        session = self.executor.heartbeat(run, command)
        if effects.note_reason(run, session, command.reason):
            await self.registry.writer.commit(run)
        return turn_view.lease_view(session)

    async def detach_worker(self, account: str, run_id: str, command: Detach) -> None:
        """End the session; what has ended already stays ended."""
        run = await self.registry.get(run_id, account)
        await self.executor.detach(run, command)

    # --- push runs: what the driver does besides attach and predict ---

    async def end_attempt_by_policy(
        self, run_id: str, worker_id: str, session_id: str, fault: str
    ) -> bool:
        """End a session by a fault of its policy (PUSH-010).

        False if the session has ended already: stopped, or lost.
        """
        run = await self.registry.get(run_id)
        session = run.workers.get(worker_id)
        if session is None or session.session_id != session_id:
            return False
        self.executor.record_policy_fault(session, fault)
        effects.end_by_policy(run, session, fault, time.time())
        self.executor.release_sessions([session])
        await self.registry.writer.commit(run)
        return True

    async def fail_run(
        self, run_id: str, reason: str, *, failed_by: RunFault, retryable: bool
    ) -> None:
        """End a push run whose policy cannot be called (PUSH-012)."""
        run = await self.registry.get(run_id)
        ended = effects.fail_run(
            run, reason, time.time(), failed_by=failed_by, retryable=retryable
        )
        self.executor.release_sessions(ended)
        await self.registry.writer.commit(run)

    async def _run_accepting(
        self, account: str | None, run_id: str, command: Stop | Resume | Delete
    ) -> Run:
        """The run, for which the rules accept the command now."""
        while True:
            run = await self.registry.get(run_id, account)
            verdict = decide(run, command, self.executor.sweep(run))
            if not isinstance(verdict, Refuse):
                return run
            # A refusal shows the state that forbids it: it may not be lost then.
            if await self.registry.writer.is_stored(run):
                raise Refused.from_verdict(verdict)


def _has_entry() -> Refused:
    detail = "The run has an entry on the leaderboard; withdraw it first."
    return Refused("not_deletable", detail, requirement="DEL-008")


def body_digest(submission: Mapping[str, Any]) -> str:
    """RUN-003, RUN-028: equal values are the same body, however they were written."""
    # Not in the form of RFC 8785: it is compared with digests of keys that were stored.
    text = msgspec.json.encode(submission, order="deterministic")
    return hashlib.sha256(text).hexdigest()
