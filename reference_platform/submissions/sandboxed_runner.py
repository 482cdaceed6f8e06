"""Plays a submission: its policy in a sandbox, and a push run of the server on it.

A verification and an evaluation take the same way; a verification stops its run after
some episodes, and belongs to the platform, so that it uses no quota and has no entry.
The rules of runs decide what is counted, scored, stopped and resumed.
"""

from __future__ import annotations

import asyncio
import contextlib
import hashlib
import hmac
import logging
import secrets
import time
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager
from dataclasses import dataclass, field, replace
from functools import partial
from pathlib import Path

from proctor_client import Run

from reference_client.errors import ProctorError
from reference_client.protocol.retry_policy import Interrupted
from reference_platform.images.bounded_archives import InvalidArchive
from reference_platform.images.unpacked_roots import UnpackingFailed
from reference_platform.sandbox.sandbox_interface import (
    SOCKET_PATH,
    NotListening,
    Sandbox,
    SandboxEnd,
    SandboxMaker,
    SandboxSpec,
    SandboxUnavailable,
    Source,
    WriteLine,
)
from reference_platform.submissions.interfaces import (
    AccountTokens,
    Outcome,
    Purpose,
    SubmissionLogs,
    Track,
    beginning_of,
)
from reference_platform.submissions.lifecycle import LISTEN_S, Cause, Submission
from reference_platform.submissions.policy_specs import PolicySpecs
from reference_platform.submissions.server_runs import (
    ServerRun,
    hosted_name,
    hosted_url,
    score_text,
)
from reference_platform.submissions.socket_bridge import bridge
from reference_record.texts.counted_text import counted

log = logging.getLogger("proctor.hosting")

_NO_SANDBOX = "The host cannot start the sandbox; its own log says why."
# The account of verifications.
PLATFORM_ACCOUNT = "platform"
_LOOK_S = 0.2
# A call that the server gave up after this part of its limit was late: the server's
# clock begins before the bridge sees the call.
_OF_LIMIT = 0.9
_END_S = 1.0
_END_ON_BUSY_HOST_S = 30.0
_SECRET_BYTES = 32
_TOKEN_MARGIN_S = 3600.0
_PUSHED = "submission"  # begins the keys under which runs are submitted once
# How long the end of a sandbox waits for a disk that refuses the last lines of its log.
_DURABLE_S = 60.0


@dataclass(frozen=True, slots=True)
class PolicyTimes:
    """How long a policy may take until it listens, for a call, and to be verified.

    retries: of a call without an answer.
    """

    listen_s: float = LISTEN_S
    call_s: float = 30.0
    retries: int = 2
    verification_s: float = 900.0


@dataclass(slots=True)
class _Play:
    """One verification or evaluation. stopped: set by `stop`."""

    submission: Submission
    track: Track
    purpose: Purpose
    on_run: Callable[[str], None]
    stopped: asyncio.Event = field(default_factory=asyncio.Event)
    run_id: str = ""
    late_calls: int = 0
    seconds: float = 0.0
    cpu_s: float | None = None


class SandboxedRunner:
    """Implements PolicyRunner.

    server_url: where the server listens. sockets: the folder that the server was given
    as `--policy-sockets`.
    """

    def __init__(
        self,
        *,
        maker: SandboxMaker,
        specs: PolicySpecs,
        tokens: AccountTokens,
        logs: SubmissionLogs,
        server_url: str,
        sockets: Path,
        times: PolicyTimes | None = None,
    ) -> None:
        sockets.mkdir(mode=0o700, parents=True, exist_ok=True)
        for left in sockets.glob("*.sock"):  # by a platform that was killed
            left.unlink()
        self._secret = _read_secret(sockets.with_name("sockets.secret"))
        self._maker = maker
        self._specs = specs
        self._tokens = tokens
        self._logs = logs
        self._server_url = server_url
        self._sockets = sockets
        self._times = times or PolicyTimes()
        self._plays: dict[str, _Play] = {}

    async def verify(
        self,
        submission: Submission,
        track: Track,
        on_run: Callable[[str], None] = lambda _run_id: None,
    ) -> Outcome:
        """Play a few episodes. on_run: is given the id of the run as soon as it is."""
        return await self._run(_Play(submission, track, "verification", on_run))

    async def evaluate(
        self,
        submission: Submission,
        track: Track,
        on_run: Callable[[str], None] = lambda _run_id: None,
    ) -> Outcome:
        """Play the whole benchmark; go on with `submission.run_id` if it has one."""
        play = _Play(submission, track, "evaluation", on_run)
        play.run_id = submission.run_id
        return await self._run(play)

    async def stop(self, submission_id: str) -> None:
        play = self._plays.get(submission_id)
        if play is not None:
            play.stopped.set()

    async def remove_files(self, submission: Submission, *, and_root: bool) -> None:
        await asyncio.to_thread(self._specs.remove, submission, and_root=and_root)

    async def _run(self, play: _Play) -> Outcome:
        name = play.submission.submission_id
        self._plays[name] = play
        self._say(play, beginning_of(play.purpose))
        try:
            outcome = await self._play(play)
        except InvalidArchive as error:
            outcome = Outcome(False, f"The upload is refused. {error}", "policy")
        except UnpackingFailed as error:
            outcome = Outcome(False, str(error), "platform")
        except SandboxUnavailable as error:
            log.warning("submission %s: %s", name, error)
            outcome = Outcome(False, _NO_SANDBOX, "platform")
        except (ProctorError, Interrupted) as error:
            outcome = Outcome(False, f"The server refuses: {error}", "platform")
        except OSError as error:
            log.warning("submission %s: %s", name, error)
            text = f"The host has a fault: {error.strerror or type(error).__name__}."
            outcome = Outcome(False, text, "platform")
        finally:
            del self._plays[name]
        may_retry = outcome.may_retry or outcome.cause == "platform"
        outcome = replace(
            outcome,
            run_id=play.run_id,
            may_retry=may_retry,
            seconds=play.seconds,
            cpu_s=play.cpu_s,
        )
        ended = "has passed" if outcome.passed else "has failed"
        self._say(play, f"The {play.purpose} {ended}. {outcome.reason}")
        return outcome

    async def _play(self, play: _Play) -> Outcome:
        spec, remarks = await self._specs.make(play.submission)
        for remark in remarks:
            self._say(play, remark)
        limit_s = self._limit_s(play)
        spec = replace(spec, limits=replace(spec.limits, wall_clock_s=limit_s))
        async with self._server_run(play, limit_s) as server_run:
            run = await server_run.read(play.run_id) if play.run_id else None
            socket_name = self._socket_name(play) if run is None else hosted_name(run)
            sandbox = await self._start(play, spec)
            if sandbox is None:
                return Outcome(False, "It was stopped.", "owner")
            began_at = time.monotonic()
            try:
                path = self._sockets / f"{socket_name}.sock"
                async with bridge(path, sandbox, partial(self._note_late, play)):
                    ended = await self._wait_until_listening(play, sandbox)
                    if ended is not None:
                        return ended
                    if play.stopped.is_set():
                        return Outcome(False, "It was stopped.", "owner")
                    await self._begin(play, server_run, run, socket_name)
                    return await self._watch(play, server_run, sandbox)
            finally:
                end = await sandbox.close(f"The {play.purpose} is over.")
                play.seconds, play.cpu_s = time.monotonic() - began_at, end.cpu_s

    async def _start(self, play: _Play, spec: SandboxSpec) -> Sandbox | None:
        """None if it was stopped before a cluster had a place for it."""
        starting = asyncio.ensure_future(self._maker.start(spec, self._writer_of(play)))
        stopping = asyncio.ensure_future(play.stopped.wait())
        sandbox = None
        try:
            ways = {starting, stopping}
            await asyncio.wait(ways, return_when=asyncio.FIRST_COMPLETED)
            if starting.done():
                sandbox = starting.result()
        finally:
            stopping.cancel()
            if sandbox is None:
                starting.cancel()
                (left,) = await asyncio.gather(starting, return_exceptions=True)
                if not isinstance(left, BaseException):
                    await left.close("It is not needed any more.")
        return sandbox

    @asynccontextmanager
    async def _server_run(
        self, play: _Play, limit_s: float
    ) -> AsyncIterator[ServerRun]:
        is_own = play.purpose == "verification"
        account = PLATFORM_ACCOUNT if is_own else play.submission.account
        token = self._tokens.make_token(account, limit_s + _TOKEN_MARGIN_S)
        server_run = ServerRun(self._server_url, token)
        try:
            yield server_run
        finally:
            server_run.close()
            self._tokens.revoke_token(token)

    async def _wait_until_listening(
        self, play: _Play, sandbox: Sandbox
    ) -> Outcome | None:
        """None once the policy listens; else how it ended before that."""
        loop = asyncio.get_running_loop()
        deadline = loop.time() + self._times.listen_s
        limit = f"{self._times.listen_s:g} s"
        self._say(play, f"It waits until the policy listens: {limit} at most.")
        while sandbox.end is None:
            try:
                (await asyncio.to_thread(sandbox.connect)).close()
            except NotListening:
                if play.stopped.is_set():
                    return Outcome(False, "It was stopped.", "owner")
                if loop.time() > deadline:
                    text = f"The policy does not listen at {SOCKET_PATH} after {limit}."
                    return Outcome(False, text, "policy")
                await asyncio.sleep(0.02)
            else:
                self._say(play, "The policy listens.")
                return None
        return _outcome_of(sandbox.end)

    def _socket_name(self, play: _Play) -> str:
        """A name that no participant can guess: with it a run can call the policy.

        An evaluation has the same one again when the platform was killed before it knew
        the run: then the run is submitted again as it was.
        """
        if play.purpose == "verification":
            return secrets.token_hex(16)
        subject = play.submission.submission_id.encode()
        return hmac.digest(self._secret, subject, hashlib.sha256).hex()[:32]

    def _writer_of(self, play: _Play) -> WriteLine:
        """Write lines of a sandbox, which wait for a disk that is full: in a thread."""
        name = play.submission.submission_id

        def write(source: Source, text: str, /) -> None:
            self._logs.write(name, source, text)
            deadline = time.monotonic() + _DURABLE_S
            while not self._logs.is_durable(name) and time.monotonic() < deadline:
                time.sleep(_LOOK_S)

        return write

    async def _begin(
        self, play: _Play, server_run: ServerRun, run: Run | None, socket_name: str
    ) -> None:
        """Submit the run, or go on with one that the platform left."""
        if run is not None:
            await server_run.resume(run.run_id)
            self._say(play, f"Run {run.run_id} goes on.")
            return
        submission = play.submission
        body = {
            "benchmark_id": play.track.benchmark_id,
            "policy": {
                "name": submission.policy_name or submission.submission_id,
                "version": submission.digest,  # what is committed to (HST-030)
            },
            "mode": "push",
            "policy_server": {
                "url": hosted_url(socket_name),
                "protocol": "proctor",
                "call_timeout_s": self._times.call_s,
                "max_retries": self._times.retries,
            },
        }
        if play.track.splits:
            body["select"] = {"splits": list(play.track.splits)}
        if play.track.options:
            body["options"] = dict(play.track.options)
        # A key of its own for each attempt of a verification: it may be repeated.
        suffix = socket_name if play.purpose == "verification" else play.purpose
        key = f"{_PUSHED}-{submission.submission_id}-{suffix}"
        run = await server_run.submit(body, key)
        play.run_id = run.run_id
        play.on_run(run.run_id)
        self._say(play, f"Run {run.run_id} begins.")

    async def _watch(
        self, play: _Play, server_run: ServerRun, sandbox: Sandbox
    ) -> Outcome:
        """Until the run ends, or there is a reason to stop it."""
        reported = -1
        while True:
            run = await server_run.read(play.run_id)
            scored = run.progress.episodes_scored
            if scored != reported:
                total = run.progress.episodes_total
                self._say(play, f"Episodes played: {scored} of {total}.")
                reported = scored
            outcome = await self._outcome(play, server_run, sandbox, run)
            if outcome is not None:
                if run.state.value not in ("completed", "failed", "stopped"):
                    with contextlib.suppress(ProctorError):
                        await server_run.stop(play.run_id)
                return outcome
            with contextlib.suppress(TimeoutError):
                async with asyncio.timeout(_LOOK_S):
                    await play.stopped.wait()

    async def _outcome(
        self, play: _Play, server_run: ServerRun, sandbox: Sandbox, run: Run
    ) -> Outcome | None:
        """None while the run is to be played on."""
        state = run.state.value
        if state == "completed":
            score = await server_run.score(run.run_id)
            return Outcome(True, score_text(score), score=score.to_dict())
        wanted = play.track.verification_episodes
        if play.purpose == "verification" and run.progress.episodes_scored >= wanted:
            return Outcome(True, f"Episodes played: {wanted}.")
        if play.stopped.is_set() or state == "stopped":
            return Outcome(False, run.reason or "It was stopped.", "owner")
        if state == "failed" and sandbox.end is None:
            await _wait_for_end(sandbox)
        if sandbox.end is not None:
            return _outcome_of(sandbox.end)
        if state == "failed":
            # A run of an older server does not say who: that costs the owner nothing.
            cause: Cause = "policy" if run.failed_by == "policy" else "platform"
            return Outcome(False, run.reason or "The run has failed.", cause)
        return None

    def _note_late(self, play: _Play, waited_s: float) -> None:
        """The server left a call unanswered: at the limit, or because its run ended."""
        times = self._times
        if waited_s < times.call_s * _OF_LIMIT:
            return
        play.late_calls += 1
        self._say(
            play,
            f"The policy did not answer a call within {times.call_s:g} s, and the "
            f"server gave the call up. It makes each call "
            f"{counted(times.retries + 1, 'time')} at most. Calls given up so far, "
            f"of all turns: {play.late_calls}. The {play.purpose} ends after "
            f"{self._limit_s(play) / 60:g} minutes at the latest.",
        )

    def _limit_s(self, play: _Play) -> float:
        is_short = play.purpose == "verification"
        return self._times.verification_s if is_short else play.track.time_limit_s

    def _say(self, play: _Play, text: str) -> None:
        self._logs.write(play.submission.submission_id, "platform", text)


async def _wait_for_end(sandbox: Sandbox) -> None:
    """A policy that has just ended is the reason, which is known a moment later.

    On a busy host that is a longer moment, in which the policy does not listen.
    """
    for limit_s in (_END_S, _END_ON_BUSY_HOST_S):
        with contextlib.suppress(TimeoutError):
            async with asyncio.timeout(limit_s):
                await sandbox.wait()
                return
        try:
            (await asyncio.to_thread(sandbox.connect)).close()
        except NotListening:
            continue
        return


def _outcome_of(end: SandboxEnd) -> Outcome:
    """The sandbox ended before its run. A kill may be one by the host."""
    if end.is_lost:
        return Outcome(False, end.reason, "platform")
    has_exited = not end.is_by_platform
    return Outcome(
        False, end.reason, "policy", may_retry=end.is_killed, has_exited=has_exited
    )


def _read_secret(path: Path) -> bytes:
    """The secret of a file, which is made if it is missing or was not finished."""
    if not path.exists() or path.stat().st_size < _SECRET_BYTES:
        path.touch(mode=0o600)
        path.write_bytes(secrets.token_bytes(_SECRET_BYTES))
    return path.read_bytes()
