"""Episodes of a run that failed and can be drawn again, and how."""

from __future__ import annotations

from collections.abc import Sequence

from proctor_client import Episode, Run, Score

from reference_client.errors import ProctorError
from reference_client.protocol.control_client import ControlClient
from reference_client.protocol.credentials import token_file
from reference_record.contents.drawable import has_camera

_CALIBRATION = "calibration"  # it has nothing to draw


def count_drawable_failures(
    control_client: ControlClient,
    score: Score,
    run: Run,
    episodes: Sequence[Episode],
    url: str,
) -> int:
    """How many failures of a run at `url` a film shows; 0 where none shows anything."""
    failures = _count_failures(episodes, url)
    return failures if failures and _can_be_drawn(control_client, score, run) else 0


def _count_failures(episodes: Sequence[Episode], url: str) -> int:
    """Failures whose seeds are shown, or are sealed by a server of this user."""
    is_host = token_file(url) is not None
    results = [episode.result for episode in episodes if episode.result is not None]
    return sum(
        result.outcome.value == "failure" and (is_host or result.seed is not None)
        for result in results
    )


def _can_be_drawn(control_client: ControlClient, score: Score, run: Run) -> bool:
    """Whether a film shows something: not of a robot, nor of what has no camera."""
    if not score.complete or run.judged or score.benchmark_id == _CALIBRATION:
        return False
    try:
        described = control_client.benchmark(run.benchmark_id).to_dict()
    except ProctorError:  # it was taken out of service
        return False
    return has_camera(run.benchmark_id, described)


def sentence_on(failures: int, command: str) -> str:
    """command: it draws them."""
    what = "the episode" if failures == 1 else f"the {failures} episodes"
    return f"To draw {what} that failed:\n  {command}"
