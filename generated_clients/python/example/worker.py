"""A worker loop on the generated client: the least that a policy needs to be evaluated.

    PROCTOR_TOKEN=… PYTHONPATH=generated_clients/python python .../example/worker.py URL [RUN_ID]

It plays the benchmark `calibration` with a scripted policy, or goes on with a run. The
same loop stands in every language of generated_clients/; see docs/implement/clients.md.
"""

from __future__ import annotations

import os
import sys
import time
import uuid
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from typing import TypeVar

import urllib3
from calibration import act
from proctor_client import (
    Action, ApiClient, ApiException, AttachWorker, CalibrationOptions, Configuration, ControlApi,
    DataApi, EpisodeResult, PolicyInfo, Predict, Problem, Run, SubmitRun, Turn,
)

T = TypeVar("T")
RETRY_TIMEOUT_S = 60.0


class Refused(Exception):
    """The server said no: `problem` says why and what to do."""

    def __init__(self, status: int, problem: Problem, retry_after_s: float | None) -> None:
        super().__init__(f"{problem.detail} [{problem.code}]")
        self.status, self.problem, self.retry_after_s = status, problem, retry_after_s


class Server:
    """The control plane of one server, and the data planes that its runs name."""

    def __init__(self, url: str, token: str) -> None:
        self.token, self.has_answered = token, False
        self.control = ControlApi(self._client(url))

    def data(self, run: Run) -> DataApi:
        return DataApi(self._client(run.endpoint))

    def _client(self, host: str) -> ApiClient:
        return ApiClient(Configuration(host=host, access_token=self.token, retries=False))

    def once(self, request: Callable[[], T]) -> T:
        """Send a request; a refusal becomes Refused."""
        try:
            message = request()
        except ApiException as error:
            if error.data is None:
                raise
            raise Refused(error.status, error.data, error.retry_after_s) from error
        self.has_answered = True
        return message

    def may_repeat(self, error: Exception) -> bool:
        if isinstance(error, Refused):
            return error.problem.retryable
        return not isinstance(error, ApiException) or error.may_repeat(has_answered=self.has_answered)

    def ask(self, request: Callable[[], T]) -> T:
        """Send a request until it is answered: a repeat executes nothing twice."""
        start, pause = time.monotonic(), 0.1
        next_report = start + 2.0  # and then every 10 s
        while True:
            try:
                return self.once(request)
            except (Refused, ApiException, urllib3.exceptions.HTTPError) as error:
                now = time.monotonic()
                wait = (error.retry_after_s if isinstance(error, Refused) else None) or pause
                if not self.may_repeat(error) or now + wait > start + RETRY_TIMEOUT_S:
                    raise
                if now + wait >= next_report:
                    print(f"waiting: {error}", file=sys.stderr, flush=True)
                    next_report = now + 10.0
            time.sleep(wait)
            pause = min(2 * pause, 2.0)

    def play(self, run_id: str, worker_id: str, policy: Callable[[Turn], list[Action]],
             report: Callable[[EpisodeResult], None]) -> None:
        """Play until no episode is left; a lost session is replaced by a new one."""
        while True:
            data = self.data(self.until_open(run_id))
            attach = AttachWorker(attach_key=uuid.uuid4().hex)
            try:
                turn = self.ask(lambda: data.attach_worker(run_id, worker_id, attach))
                while not turn.done:
                    chunk = Predict(session_id=turn.session_id, seq=turn.seq + 1,
                                    actions=policy(turn))
                    turn = self.ask(lambda: data.predict(run_id, worker_id, chunk))
                    if turn.episode_result is not None:
                        report(turn.episode_result)
                return
            except Refused as error:
                why = error.problem
                if why.code == "illegal_transition" and why.state == "completed":
                    return  # the other workers have played the rest
                if why.code != "session_ended" or why.ended_by in ("run_stopped", "run_failed"):
                    raise

    def until_open(self, run_id: str) -> Run:
        """The run, as soon as workers may attach."""
        while (run := self.ask(lambda: self.control.get_run(run_id))).state.value == "queued":
            time.sleep(0.1)
        return run


def main(url: str, token: str, run_id: str | None = None) -> None:
    server = Server(url, token)
    if run_id is None:
        key, options = uuid.uuid4().hex, CalibrationOptions(tasks=["score"] * 8, max_steps=20)
        submit = SubmitRun(benchmark_id="calibration", policy=PolicyInfo(name="scripted"), options=options)
        run = server.ask(lambda: server.control.submit_run(submit, idempotency_key=key))
    else:
        run = server.ask(lambda: server.control.resume_run(run_id))
    print(f"run {run.run_id}: {run.progress.episodes_total} episodes; its id, as RUN_ID, goes on with it")

    def report(result: EpisodeResult) -> None:
        print(f"  episode {result.index} ({result.task}): {result.outcome.value}, score {result.score}")

    def policy(turn: Turn) -> list[Action]:
        return [act((turn.episode.index % 5) / 4)] * 5

    with ThreadPoolExecutor(2) as pool:
        list(pool.map(lambda i: server.play(run.run_id, f"worker-{i}", policy, report), range(2)))
    score = server.ask(lambda: server.control.get_score(run.run_id))
    print(f"score {score.score}")


if __name__ == "__main__":
    url, *run_id = sys.argv[1:] or [""]
    token = os.environ.get("PROCTOR_TOKEN")
    if not url or not token or len(run_id) > 1:
        sys.exit(f"usage: {sys.argv[0]} URL [RUN_ID]; the token is PROCTOR_TOKEN")
    try:
        main(url, token, *run_id)
    except (Refused, ApiException, ValueError) as error:
        ends_with_v1 = isinstance(error, Refused) and url.rstrip("/").endswith("/v1")
        hint = "The base URL ends with /v1, which every request adds. " if ends_with_v1 else ""
        sys.exit(f"{hint}{error}")
