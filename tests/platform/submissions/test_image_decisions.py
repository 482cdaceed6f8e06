"""A decision on an image holds for submissions that have not begun (HST-023)."""

from __future__ import annotations

import asyncio
from collections.abc import Sequence
from pathlib import Path
from typing import Any, cast

import pytest

from reference_platform.accounts.organisations import Owner
from reference_platform.images.image_reviews import ImageDecision, ImageReviews
from reference_platform.parts import Parts
from reference_platform.submissions.lifecycle import Event, State
from reference_platform.submissions.submission_logs import FileLogs
from reference_platform.submissions.submission_supervisor import SubmissionSupervisor
from reference_platform.tracks.track_rules import Phase, Track

DIGEST = "sha256:" + "a" * 64
TO_QUEUED: tuple[Event, ...] = ("begin_verification", "pass_verification", "start")
DECISIONS: Sequence[tuple[tuple[ImageDecision, ...], tuple[State, State]]] = [
    ((), ("uploaded", "queued")),
    (("approve",), ("verifying", "running")),
    (("reject",), ("failed", "failed")),
    (("approve", "reject"), ("failed", "failed")),
    (("approve", "reject", "approve"), ("verifying", "running")),
]


class EndlessRunner:
    """Begins what it is given, and never comes to an end. Fits PolicyRunner."""

    async def verify(self, *_: Any) -> None:
        await asyncio.Event().wait()

    evaluate = verify

    async def remove_files(self, *_: Any, **__: Any) -> None:
        """There are none."""


@pytest.mark.parametrize(("decisions", "states"), DECISIONS)
async def test_only_an_approved_image_is_started(
    parts: Parts,
    ada: str,
    tmp_path: Path,
    decisions: tuple[ImageDecision, ...],
    states: tuple[State, State],
) -> None:
    """One submission waits for its verification, another one for its evaluation."""
    now, store = parts.clock(), parts.submissions
    phase = Phase("main", "calibration", now, now + 1e7)
    parts.tracks.put(Track("letters", "Letters", (phase,)), "a test")
    parts.tracks.enter("letters", Owner(ada))
    names = [
        store.create(ada, "letters", policy_name=policy).submission_id
        for policy in ("unverified", "verified")
    ]
    for name in names:
        store.move(name, "upload", digest=DIGEST)
    for event in TO_QUEUED:
        store.move(names[1], event)
    reviews = ImageReviews(parts.database, parts.clock)
    reviews.add(DIGEST, ada, 1, "")
    for decision in decisions:
        reviews.decide(DIGEST, decision, "for a reason", "an administrator")
    logs = FileLogs(tmp_path / "logs", lambda _name: True)
    runner = cast("Any", EndlessRunner())
    supervisor = SubmissionSupervisor(store, reviews, runner, logs, at_once=2)
    await supervisor._look()
    assert tuple(store.get(name).state for name in names) == states
