"""The numbers of an evaluation, sent to experiment trackers while it is played.

A tracker that fails is reported once and left; the evaluation goes on.
"""

from __future__ import annotations

import tempfile
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any, Protocol, TypeAlias

from proctor_client import Episode, Run, Score

from reference_client.errors import class_and_text
from reference_client.evaluation.status_board import Progress
from reference_client.printable_text import printable

# Draws videos of that many episodes into a folder, and returns their files.
DrawVideos: TypeAlias = Callable[[int, Path], Sequence[Path]]
COLUMNS = ("episode_id", "task", "split", "outcome", "score", "steps", "attempt")


class Tracker(Protocol):
    """Receives one evaluation. Methods may raise any error; then no more is called."""

    def begin(self, run: Run, link: str, config: Mapping[str, Any]) -> None:
        """A run begins or goes on. link: its page. config: what is evaluated."""

    def log(self, step: int, numbers: Mapping[str, float]) -> None:
        """Numbers by name after `step` scored episodes."""

    def finish(
        self,
        numbers: Mapping[str, float],
        episodes: Sequence[Mapping[str, Any]],
        videos: Sequence[Path],
    ) -> None:
        """The score with its intervals, a row for each episode, and video files."""

    def fail(self, reason: str) -> None:
        """The evaluation has ended without a score."""


class Tracking:
    """Sends one evaluation to `trackers`.

    videos: of how many episodes, failures first; drawn from the record.
    """

    def __init__(
        self,
        trackers: Sequence[Tracker],
        say: Callable[[str], None],
        videos: int = 0,
    ) -> None:
        self._trackers = list(trackers)
        self._say = say
        self._videos = videos
        self._latest = -1

    @property
    def is_used(self) -> bool:
        return bool(self._trackers)

    def begin(self, run: Run, link: str, workers: int) -> None:
        config = {
            "run_id": run.run_id,
            "benchmark": run.benchmark_id,
            "benchmark_version": run.benchmark_version,
            "manifest_sha256": run.manifest_sha256,
            "policy": run.policy.name,
            "policy_version": run.policy.version,
            "workers": workers,
            "link": link,
        }
        self._send(lambda tracker: tracker.begin(run, link, config))

    def with_progress(
        self, progress: Callable[[Progress], None] | None
    ) -> Callable[[Progress], None]:
        """Calls `log` and `progress` at every change."""

        def on_progress(state: Progress) -> None:
            self.log(state)
            if progress is not None:
                progress(state)

        return on_progress

    def log(self, progress: Progress) -> None:
        """Send the numbers when another episode has a score."""
        if progress.episodes_scored <= self._latest or progress.mean is None:
            return
        self._latest = progress.episodes_scored
        numbers = {
            "episodes_scored": float(progress.episodes_scored),
            "episodes_abandoned": float(progress.episodes_abandoned),
            "mean": progress.mean,
        }
        self._send(lambda tracker: tracker.log(self._latest, numbers))

    def finish(
        self, score: Score, episodes: Sequence[Episode], draw_videos: DrawVideos
    ) -> None:
        numbers, rows = numbers_of(score), [_row(e) for e in episodes if e.result]
        with tempfile.TemporaryDirectory(prefix="proctor-videos-") as folder:
            videos: Sequence[Path] = []
            if self._videos and self._trackers:
                try:
                    videos = draw_videos(self._videos, Path(folder))
                except Exception as error:  # noqa: BLE001 - the score is worth more
                    self._say(printable(f"proctor: no videos: {error}"))
            self._send(lambda tracker: tracker.finish(numbers, rows, videos))
        self._trackers.clear()

    def fail(self, reason: str) -> None:
        """Does nothing after `finish`."""
        self._send(lambda tracker: tracker.fail(printable(reason)))
        self._trackers.clear()

    def _send(self, call: Callable[[Tracker], None]) -> None:
        for tracker in list(self._trackers):
            try:
                call(tracker)
            except Exception as error:  # noqa: BLE001 - libraries raise any class
                self._trackers.remove(tracker)
                name = type(tracker).__name__.removesuffix("Tracker")
                what = class_and_text(error)[:300]
                self._say(
                    printable(f"proctor: {name} failed and receives no more: {what}")
                )


def numbers_of(score: Score) -> dict[str, float]:
    """The final numbers by name, each with the bounds of its interval."""
    counts = score.counts
    success, mean = score.success_interval, score.mean_interval
    numbers: dict[str, float | None] = {
        "score": score.score,
        "score_low": score.score_low,
        "score_high": score.score_high,
        "mean": score.mean,
        "mean_ci95_low": mean.low,
        "mean_ci95_high": mean.high,
        "success_rate": score.success_rate,
        "success_ci95_low": success.low,
        "success_ci95_high": success.high,
        "episodes_total": float(counts.total),
        "episodes_unscored": float(counts.unscored),
        "episodes_abandoned": float(counts.abandoned),
    }
    for task, group in score.by_task.items():
        numbers[f"task/{task}/mean"] = group.mean
        numbers[f"task/{task}/success_rate"] = group.success_rate
    return {name: number for name, number in numbers.items() if number is not None}


def _row(episode: Episode) -> dict[str, Any]:
    result = episode.result
    assert result is not None
    return {name: _plain(getattr(result, name)) for name in COLUMNS}


def _plain(value: Any) -> Any:
    return getattr(value, "value", value)
