"""The responses to EBench's client: envelopes, workers' observations, a status.

Views of runs and turns as plain data, and the ASGI responses that carry them. Must not
read requests beyond whether their client is still connected.
"""

from __future__ import annotations

import secrets
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal, TypeAlias, TypedDict

import msgspec
from starlette.responses import Response
from starlette.types import Receive, Scope, Send

from reference_record.generated.answers import EpisodeResult
from reference_server.generated.problem_codes import PROBLEMS
from reference_server.http.codec import JSON
from reference_server.http.dispatch import OperationCall
from reference_server.profiles.ebench import message_conversion, pickle_writer
from reference_server.rules.refusal import Refused
from reference_server.rules.runs.run import Episode, Run, RunHead
from reference_server.views import run_views

PICKLE = "application/octet-stream"


def envelope(data: Any, code: int = 0, msg: str = "success") -> Response:
    """EBE-002: always status 200; `code` 0 is success, `msg` says what went wrong."""
    trace_id = secrets.token_hex(16)
    body = {"code": code, "msg": msg, "trace_id": trace_id, "data": data}
    return Response(msgspec.json.encode(body), media_type=JSON)


def refusal_response(refused: Refused) -> Response:
    """EBE-002: a refusal in an envelope; `code` is the HTTP status of its problem."""
    entry = PROBLEMS[refused.code]
    faults = "; ".join(f"{at or 'the body'} {text}" for at, text in refused.errors)
    parts = [refused.detail, faults and f"{faults}.", refused.act]
    return envelope(None, entry["status"], " ".join(filter(None, parts)))


class ConfirmedResponse(Response):
    """A response that reports whether it was sent to a client that was connected.

    EBE-013, EBE-014, EBE-031: `on_sent` is called once, with False when it was lost.
    """

    def __init__(
        self, value: Any, call: OperationCall, on_sent: Callable[[bool], None]
    ) -> None:
        super().__init__(pickle_writer.write(value), media_type=PICKLE)
        self._request = call.request
        self._on_sent = on_sent

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """ASGI: checks the connection before the last byte.

        Not after it: many clients disconnect as soon as they have the last byte.
        """
        is_connected = False
        start = {"status": self.status_code, "headers": self.raw_headers}
        whole = memoryview(self.body)
        rest, last = whole[:-1], whole[-1:]
        try:
            await send({"type": "http.response.start", **start})
            await send({"type": "http.response.body", "body": rest, "more_body": True})
            is_connected = not await self._request.is_disconnected()
            await send({"type": "http.response.body", "body": last, "more_body": False})
        finally:
            self._on_sent(is_connected)


@dataclass(frozen=True, slots=True)
class TaskScore:
    """The scored episodes of one task of a run: how many, and their means."""

    scored: int
    total: int
    score: float
    sr: float

    def label(self, task: str) -> str:
        """EBE-025: the task with its progress; `*` hides it until it is complete."""
        mark = "" if self.scored == self.total else "*"
        return f"{mark}({self.scored}/{self.total}){task}"


TaskScores: TypeAlias = Mapping[str, TaskScore]
# By task; with the success rate for the current generation of the client.
Metric: TypeAlias = Mapping[str, float | Mapping[str, float]]


class WorkerView(TypedDict):
    """The answer of `reset` and `step` for one worker."""

    obs: Mapping[str, object] | None
    metric: Metric | None
    episode_result: message_conversion.EndedEpisode | None


class TaskStatus(TypedDict):
    """How far a run is (EBE-019). results: the score of each task."""

    status: Literal["idle", "complete", "running", "incomplete"]
    benchmark_id: str
    run_id: str
    total_episodes: int
    completed_episodes: int
    in_progress_episodes: int
    active_workers: list[str]
    repeated_attempts: int
    results: dict[str, float]


def worker_view(
    run: Run, turn: Mapping[str, Any], scores: TaskScores, *, current: bool
) -> WorkerView:
    """The answer of `reset` and `step` for one worker (EBE-009, EBE-010).

    current: for the current generation of EBench's client (EBE-025); the older one
    reads numbers.
    """
    of = run.run_id, run.manifest["benchmark_id"]
    ended = turn.get("episode_result")
    metric: Metric | None = None
    if turn["done"]:
        metric = run_metric(scores, current=current)
    elif ended and "owed" not in turn:
        metric = episode_metric(scores, ended, current=current)
    return {
        "obs": None if turn["done"] else message_conversion.observation_view(turn, *of),
        "metric": metric,
        "episode_result": ended
        and message_conversion.episode_result_view(ended, *of, current=current),
    }


def episode_metric(
    scores: TaskScores, ended: EpisodeResult, *, current: bool
) -> Metric:
    """The score of an ended episode, by its task (EBE-009, EBE-025)."""
    task, score = ended["task"], ended["score"]
    if not current:
        return {task: score}
    sr = message_conversion.success_rate(score)
    return {scores[task].label(task): {"score": score, "sr": sr}}


def run_metric(scores: TaskScores, *, current: bool) -> Metric:
    """The mean scores of a run whose end a worker has reached (EBE-010, EBE-025)."""
    if not current:
        return {task: score.score for task, score in scores.items()}
    return {
        score.label(task): {"score": score.score, "sr": score.sr}
        for task, score in scores.items()
    }


def task_scores(run: RunHead, episodes: Sequence[Episode]) -> dict[str, TaskScore]:
    """Each task that has a scored episode. episodes: all of the run."""
    by_task = run_views.score_view(run, episodes)["by_task"]
    full: Counter[str] = Counter()
    for episode in episodes:
        if episode.result is not None:
            full[episode.task] += int(
                message_conversion.success_rate(episode.result.score)
            )
    scores = {}
    for task, group in by_task.items():
        total = group["counts"]["total"]
        scored = total - group["counts"]["unscored"]
        if group["mean"] is not None:
            scores[task] = TaskScore(scored, total, group["mean"], full[task] / scored)
    return scores


def status_of(run: RunHead, episodes: Sequence[Episode]) -> TaskStatus:
    """EBE-019. episodes: all of the run."""
    live_sessions = [session.worker_id for session in run.live_sessions]
    status: Literal["idle", "complete", "running", "incomplete"] = "idle"
    if run.state == "completed":
        status = "complete"
    elif live_sessions:
        status = "running"
    elif run.scored or run.state in ("stopped", "failed"):
        status = "incomplete"
    return {
        "status": status,
        "benchmark_id": run.manifest["benchmark_id"],
        "run_id": run.run_id,
        "total_episodes": len(episodes),
        "completed_episodes": run.scored,
        "in_progress_episodes": sum(s.episode is not None for s in run.live_sessions),
        "active_workers": sorted(live_sessions),
        "repeated_attempts": sum(e.attempt - 1 for e in episodes),  # EBE-030
        "results": {t: s.score for t, s in task_scores(run, episodes).items()},
    }
