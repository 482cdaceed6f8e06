"""Answers about a run, as the kit's model of a run is given them."""

from __future__ import annotations

from typing import Any

from conformance.oracle.run_model import AnswerSummary


def refused(code: str, **members: Any) -> AnswerSummary:
    status = 429 if code == "worker_limit" else 409
    return AnswerSummary(status, code, {"code": code, **members})


def run(
    state: str, live: int, scored: int, playing: int, pending: int
) -> AnswerSummary:
    progress = {
        "episodes_scored": scored,
        "episodes_in_progress": playing,
        "episodes_pending": pending,
    }
    body = {"state": state, "live_workers": live, "progress": progress}
    return AnswerSummary(200, None, body)
