"""The control plane: benchmarks, submission, state, stop, resume and score of runs."""

from __future__ import annotations

import contextlib
import threading
import uuid
from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import partial
from urllib.parse import quote

from proctor_client import (
    ApiException,
    ApiResponse,
    Benchmark,
    BenchmarkSummary,
    Comparison,
    ControlApi,
    Episode,
    Run,
    Score,
    Service,
    StopMode,
    StopRun,
    SubmitRun,
    with_http_info,
)

from reference_client.errors import (
    ProctorError,
    RunFailed,
    RunStopped,
)
from reference_client.protocol.connection import TIMEOUTS_S
from reference_client.protocol.list_pages import read_pages
from reference_client.protocol.retry_policy import RetryPolicy
from reference_record.command_line.spelling import did_you_mean

LONG_POLL_S = 10  # below the read timeout of TIMEOUTS_S
WITHDRAW_S = 5.0  # for a run that nothing was played of
HAS_PAGES = (200, 303)  # a page, or the way to the sign-in
UNCHANGED_S = 0.2  # between polls, for servers without long polling


class ControlClient:
    """The operations on runs; every method raises ProctorError and Interrupted."""

    def __init__(self, control: ControlApi, retry_policy: RetryPolicy) -> None:
        self._control = control
        self._retry_policy = retry_policy

    def check_service(self, workers: int) -> Service:
        """The server's description of itself; raises if it allows fewer workers."""
        service = self._retry_policy.call(
            lambda: self._control.describe_service(_request_timeout=TIMEOUTS_S)
        )
        if workers > service.limits.max_workers:
            raise ProctorError(
                "invalid_request",
                f"{workers} workers requested; {self._retry_policy.url} allows "
                f"{service.limits.max_workers} per run.",
            )
        return service

    def benchmarks(self) -> list[BenchmarkSummary]:
        return self._retry_policy.call(
            lambda: self._control.list_benchmarks(_request_timeout=TIMEOUTS_S)
        ).benchmarks

    def benchmark(self, benchmark_id: str) -> Benchmark:
        """Raises `not_found` with a name that was probably meant."""
        try:
            return self._retry_policy.call(
                lambda: self._control.get_benchmark(
                    benchmark_id, _request_timeout=TIMEOUTS_S
                )
            )
        except ProctorError as error:
            if error.code != "not_found":
                raise
            names = [summary.benchmark_id for summary in self.benchmarks()]
            meant = did_you_mean(benchmark_id, names) or f"; it has {', '.join(names)}"
            raise ProctorError(
                error.code,
                f"{self._retry_policy.url} has no benchmark {benchmark_id!r}{meant}",
                problem=error.problem,
            ) from error

    def check(self, benchmark_id: str) -> Benchmark:
        """The benchmark. Raises `benchmark_unavailable` if it cannot be run."""
        benchmark = self.benchmark(benchmark_id)
        if benchmark.unavailable_reason is not None:
            raise ProctorError("benchmark_unavailable", benchmark.unavailable_reason)
        return benchmark

    def submit(self, submission: SubmitRun) -> Run:
        """Submit exactly one run: repeated requests carry the same Idempotency-Key."""
        key = uuid.uuid4().hex
        return self._retry_policy.call(
            lambda: self._control.submit_run(
                submission, idempotency_key=key, _request_timeout=TIMEOUTS_S
            )
        )

    def read(self, run_id: str) -> Run:
        return self._retry_policy.call(
            lambda: self._control.get_run(run_id, _request_timeout=TIMEOUTS_S)
        )

    def all_runs(self) -> Iterator[Run]:
        """The runs of the account, the newest first; pages are read when needed."""
        try:
            for page in read_pages(self._retry_policy, self._control.list_runs):
                yield from page.runs
        except ProctorError as error:
            if not self._lacks_lists(error):
                raise
            raise ProctorError(
                "not_found",
                f"{self._retry_policy.url} has no list of runs: it does not announce "
                "the profile `lists`. `proctor status RUN_ID` shows one run.",
            ) from error

    def stop(self, run_id: str, mode: StopMode, reason: str | None = None) -> Run:
        stop = StopRun(mode=mode, reason=reason)
        return self._retry_policy.call(
            lambda: self._control.stop_run(run_id, stop, _request_timeout=TIMEOUTS_S)
        )

    def resume(self, run_id: str) -> Run:
        return self._retry_policy.call(
            lambda: self._control.resume_run(run_id, _request_timeout=TIMEOUTS_S)
        )

    def delete(self, run_id: str) -> None:
        self._retry_policy.call(
            lambda: self._control.delete_run(run_id, _request_timeout=TIMEOUTS_S)
        )

    def withdraw_unplayed(self, run_id: str) -> bool:
        """Stop a run that no worker has played, and delete it where the server can.

        Returns whether it is gone or stopped; False where it was played, or where the
        server does not answer soon.
        """
        # An event of its own: that of the workers is set when one of them has failed.
        soon = replace(self._retry_policy, total_s=WITHDRAW_S, stop=threading.Event())
        client = ControlClient(self._control, soon)
        try:
            progress = client.read(run_id).progress
            if progress.episodes_pending < progress.episodes_total:
                return False
            client.stop(run_id, StopMode.ABORT)
        except ProctorError:
            return False
        with contextlib.suppress(ProctorError):  # not every server deletes runs
            client.delete(run_id)
        return True

    def resume_if_needed(self, run_id: str) -> Run:
        """Resume the run if it is stopped or failed; waits while it is stopping.

        Raises RunFailed if it cannot be resumed.
        """
        for run in self.changes(run_id):
            state = run.state.value
            if state == "stopping":
                self._retry_policy.report_waiting(
                    "the run is draining; it is resumed after that"
                )
                continue
            self._retry_policy.report_waiting(None)
            if state == "failed" and not run.retryable:
                raise RunFailed(run)
            if state in ("stopped", "failed"):
                return self.resume(run_id)
            return run
        raise AssertionError("changes never end")

    def wait_for_work(self, run_id: str, *, held: bool = False) -> bool:
        """Wait until episodes can be played (True) or the run is completed (False).

        held: episodes held by a session count, because it will be taken over. Raises
        RunFailed, RunStopped.
        """
        for run in self.changes(run_id):
            state = run.state.value
            if state == "queued":
                place = run.queue_position
                self._retry_policy.report_waiting(
                    f"the run is queued at position {place}"
                )
                continue
            self._retry_policy.report_waiting(None)
            if state == "completed":
                return False
            if state == "failed":
                raise RunFailed(run)
            if state == "stopped":
                raise RunStopped(run)
            playable = held or run.progress.episodes_pending > 0
            if playable and state != "stopping":
                return True
            # If one of these sessions ends early, its episode is played here.
            others = run.progress.episodes_in_progress
            self._retry_policy.report_waiting(
                f"the last {others} episodes are in progress in other sessions; "
                "takeover=True takes over those with the same worker ids"
            )
        raise AssertionError("changes never end")

    def score(self, run_id: str) -> Score:
        return self._retry_policy.call(
            lambda: self._control.get_score(run_id, _request_timeout=TIMEOUTS_S)
        )

    def compare(
        self, baseline: str, runs: Sequence[str], tolerance: float | None
    ) -> Comparison:
        """Compare runs with a baseline; tolerance None is the server's default."""
        return self._retry_policy.call(
            lambda: self._control.compare_runs(
                baseline, ",".join(runs), tolerance, _request_timeout=TIMEOUTS_S
            )
        )

    def episodes(self, run_id: str, first: int | None = None) -> list[Episode]:
        """The first episodes of the manifest, or all, from the pages of the list."""
        episodes: list[Episode] = []
        operation = self._control.list_episodes
        for page in read_pages(self._retry_policy, operation, run_id):
            episodes += page.episodes
            if first is not None and len(episodes) >= first:
                break
        return episodes[:first]

    def has_scored(self, run_id: str, first: int | None) -> bool:
        """Whether so many of the first episodes are wanted, and all are scored."""
        return first is not None and all(
            episode.status.value == "scored" for episode in self.episodes(run_id, first)
        )

    def episodes_if_listed(self, run_id: str) -> list[Episode]:
        """All episodes; none of a server without the profile `lists`."""
        try:
            return self.episodes(run_id)
        except ProctorError as error:
            if not self._lacks_lists(error):
                raise
            return []

    def _lacks_lists(self, error: ProctorError) -> bool:
        """Whether a list was refused by a server that has none."""
        is_unknown = error.code in ("not_found", "method_not_allowed")
        return is_unknown and "lists" not in self.check_service(1).profiles

    def try_score(self, run_id: str) -> Score:
        """The score, without retries and without a wait; also after an interruption."""
        return self._once().score(run_id)

    def status_of_pages(self) -> int:
        """The HTTP status of the first page for people, which not every server has."""
        pool = self._control.api_client.pool_manager
        response = self._retry_policy.call(
            lambda: pool.request(
                "GET",
                f"{self._retry_policy.url}/pages",
                redirect=False,
                retries=False,
                timeout=TIMEOUTS_S[1],
            )
        )
        return int(response.status)

    def page_of(self, path: str) -> str | None:
        """The address of a page, such as `runs/ID`; None if there are no pages."""
        try:
            has_pages = self._once().status_of_pages() in HAS_PAGES
        except ProctorError:
            return None
        return f"{self._retry_policy.url}/pages/{quote(path)}" if has_pages else None

    def _once(self) -> ControlClient:
        """The same without retries and without a wait, also after an interruption."""
        once = replace(
            self._retry_policy,
            total_s=0.0,
            stop=threading.Event(),
            report_waiting=lambda _why: None,
        )
        return ControlClient(self._control, once)

    def changes(self, run_id: str) -> Iterator[Run]:
        """The run now, and again after every change; endless."""
        etag: str | None = None
        while True:
            answer = self._retry_policy.call(partial(self._poll, run_id, etag))
            if answer is None:
                self._retry_policy.pause(UNCHANGED_S)
                continue
            etag = answer.headers.get("ETag")
            yield answer.data
            if etag is None:
                self._retry_policy.pause(UNCHANGED_S)

    def _poll(self, run_id: str, etag: str | None) -> ApiResponse[Run] | None:
        """The run, or None if it has not changed since the etag."""
        try:
            return with_http_info(
                self._control.get_run,
                run_id,
                if_none_match=etag,
                prefer=f"wait={LONG_POLL_S}" if etag else None,
                _request_timeout=TIMEOUTS_S,
            )
        except ApiException as error:
            if error.status == 304:
                return None
            raise
