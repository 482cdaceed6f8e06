"""The push runs of submissions, at the public API of the reference server."""

from __future__ import annotations

import asyncio
import re
import threading
from collections.abc import Callable
from typing import Any, TypeVar

from proctor_client import Run, Score, StopMode, SubmitRun

from reference_client.protocol.connection import TIMEOUTS_S, Connection
from reference_client.protocol.control_client import ControlClient
from reference_record.texts.counted_text import counted
from reference_record.texts.figures import figure

# How long a server that restarts is waited for.
_RETRY_S = 120.0
_HOSTED = re.compile(r"http://([0-9a-f]{32})\.sandbox\.invalid")
_Answer = TypeVar("_Answer")


class ServerRun:
    """The run of one submission; every method raises ProctorError.

    url: of the server. token: of the account that the run belongs to.
    """

    def __init__(self, url: str, token: str) -> None:
        self._stop = threading.Event()
        self._connection = Connection(url, token, requests=2)
        self._retry_policy = self._connection.retry_policy(
            self._stop, lambda _why: None, _RETRY_S
        )
        self._client = ControlClient(self._connection.control, self._retry_policy)

    def close(self) -> None:
        """Ends every wait."""
        self._stop.set()
        self._connection.close()

    async def submit(self, submission: dict[str, Any], key: str) -> Run:
        """Once for each key, also when the platform is killed meanwhile."""
        body = SubmitRun.from_dict(submission)
        assert body is not None

        def send() -> Run:
            return self._connection.control.submit_run(
                body, idempotency_key=key, _request_timeout=TIMEOUTS_S
            )

        return await self._call(lambda: self._retry_policy.call(send))

    async def read(self, run_id: str) -> Run:
        return await self._call(lambda: self._client.read(run_id))

    async def resume(self, run_id: str) -> Run:
        return await self._call(lambda: self._client.resume_if_needed(run_id))

    async def stop(self, run_id: str) -> None:
        await self._call(lambda: self._client.stop(run_id, StopMode.ABORT))

    async def score(self, run_id: str) -> Score:
        return await self._call(lambda: self._client.score(run_id))

    async def _call(self, function: Callable[[], _Answer]) -> _Answer:
        return await asyncio.to_thread(function)


def hosted_url(name: str) -> str:
    """The address of a hosted policy, for the server alone."""
    return f"http://{name}.sandbox.invalid"


def hosted_name(run: Run) -> str:
    """The name of the policy that a run calls. Raises ValueError."""
    address = "" if run.policy_server is None else run.policy_server.url
    match = _HOSTED.fullmatch(address)
    if match is None:
        raise ValueError(f"run {run.run_id} calls no hosted policy")
    return match[1]


def score_text(score: Score) -> str:
    """The score in a line of the log."""
    mean = "unknown" if score.score is None else figure(score.score, 3)
    text = f"The score is {mean} over {counted(score.counts.total, 'episode')}"
    if abandoned := score.counts.abandoned:
        text += f", {abandoned} of them abandoned with score 0: their attempts are "
        text += "used up"
    return f"{text}."
