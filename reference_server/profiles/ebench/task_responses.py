"""The responses to EBench's client: envelopes, workers' observations, a status.

Views of runs and turns as plain data, and the ASGI responses that carry them. Must not
read requests beyond whether their client is still connected.
"""

from __future__ import annotations

import secrets
from collections.abc import Callable, Mapping
from typing import Any

import msgspec
from starlette.responses import Response
from starlette.types import Receive, Scope, Send

from reference_server.generated.problem_codes import PROBLEMS
from reference_server.http.codec import JSON
from reference_server.http.dispatch import OperationCall
from reference_server.profiles.ebench import message_conversion, pickle_writer
from reference_server.rules.refusal import Refused
from reference_server.rules.run import Run
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
    parts = [refused.detail, faults and f"{faults}.", entry["act"]]
    return envelope(None, entry["status"], " ".join(filter(None, parts)))


class ConfirmedResponse(Response):
    """A response that reports when it was sent to a client that was connected.

    EBE-013, EBE-014: an answer counts as lost unless `on_delivered` is called.
    """

    def __init__(
        self, value: Any, call: OperationCall, on_delivered: Callable[[], None]
    ) -> None:
        super().__init__(pickle_writer.write(value), media_type=PICKLE)
        self._request = call.request
        self._on_delivered = on_delivered

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """ASGI: checks the connection before the last byte.

        Not after it: many clients disconnect as soon as they have the last byte.
        """
        start = {"status": self.status_code, "headers": self.raw_headers}
        await send({"type": "http.response.start", **start})
        whole = memoryview(self.body)
        rest, last = whole[:-1], whole[-1:]
        await send({"type": "http.response.body", "body": rest, "more_body": True})
        is_connected = not await self._request.is_disconnected()
        await send({"type": "http.response.body", "body": last, "more_body": False})
        if is_connected:
            self._on_delivered()


def worker_view(
    run: Run, turn: Mapping[str, Any], results: Mapping[str, float]
) -> dict[str, Any]:
    """The answer of `reset` and `step` for one worker (EBE-009, EBE-010)."""
    of = run.run_id, run.manifest["benchmark_id"]
    ended = turn.get("episode_result")
    metric = {ended["task"]: ended["score"]} if ended else None
    return {
        "obs": None if turn["done"] else message_conversion.observation_view(turn, *of),
        "metric": results if turn["done"] else metric,
        "episode_result": ended and message_conversion.episode_result_view(ended, *of),
    }


def results_of(run: Run) -> dict[str, float]:
    """Mean score of each task that has a scored episode (EBE-010, EBE-019)."""
    by_task = run_views.score_view(run, run.episodes)["by_task"]
    means = {task: group["mean"] for task, group in by_task.items()}
    return {task: mean for task, mean in means.items() if mean is not None}


def status_of(run: Run) -> dict[str, Any]:
    """EBE-019."""
    live_sessions = [session.worker_id for session in run.live_sessions]
    status = "idle"
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
        "total_episodes": len(run.episodes),
        "completed_episodes": run.scored,
        "in_progress_episodes": sum(s.episode is not None for s in run.live_sessions),
        "active_workers": sorted(live_sessions),
        "results": results_of(run),
    }
