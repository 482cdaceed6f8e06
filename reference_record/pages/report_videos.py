"""Adds videos to a report, each beside the episode that it shows.

A video is shown where the recording that it was drawn from is shown, and nowhere else,
whatever its file and its folder are called. The report lists the videos left out.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterable, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from reference_record.broken import UnusableRecord
from reference_record.formats.video_origin import VideoOrigin, read_origin


@dataclass(frozen=True, slots=True)
class ReportVideo:
    """A video whose file names the episode that it shows."""

    path: Path
    origin: VideoOrigin

    @property
    def note(self) -> str:
        """Where it leaves the recording; empty if it does not."""
        turn = self.origin.turn
        if turn is None:
            return ""
        since = f"turn {turn}" if turn else "its start"
        return f"a similar episode, whose states differ from {since} on"


@dataclass(slots=True)
class ReportVideos:
    """Videos by the SHA-256 of the recording that they were drawn from.

    nameless: files that do not say it, by their folder. placed: which are shown.
    """

    videos: Sequence[ReportVideo] = ()
    nameless: Counter[Path] = field(default_factory=Counter)
    _placed: set[Path] = field(default_factory=set)

    @classmethod
    def of_folders(
        cls, folders: Iterable[Path], run_ids: Collection[str]
    ) -> ReportVideos:
        """The files of some folders. Raises OSError.

        Raises UnusableRecord for a folder without a video of any of the runs: it was
        meant for another report.
        """
        videos: list[ReportVideo] = []
        nameless: Counter[Path] = Counter()
        for folder in dict.fromkeys(folders):
            origins = {path: read_origin(path) for path in sorted(folder.glob("*.mp4"))}
            named = [ReportVideo(p, o) for p, o in origins.items() if o is not None]
            _check_folder(folder, len(origins), named, run_ids)
            videos += named
            if len(named) < len(origins):
                nameless[folder] += len(origins) - len(named)
        return cls(videos, nameless)

    def of_recording(self, sha256: str) -> list[ReportVideo]:
        """Those of an episode, one for each camera; they count as shown."""
        by_camera: dict[str, ReportVideo] = {}
        for video in self.videos:
            origin = video.origin
            if origin.recording_sha256 == sha256 and origin.replay != "diverged":
                by_camera.setdefault(origin.camera, video)
        self._placed |= {video.path for video in by_camera.values()}
        return list(by_camera.values())

    @property
    def placed(self) -> int:
        return len(self._placed)

    def left_out(self, run_ids: Collection[str]) -> list[str]:
        """A line for each reason why files are not shown, for people."""
        reasons: Counter[tuple[Path, str]] = Counter()
        for video in self.videos:
            if video.path not in self._placed:
                reasons[video.path.parent, self._why_left_out(video, run_ids)] += 1
        for folder, number in self.nameless.items():
            why = "without a word of which episode; `proctor video` draws it again"
            reasons[folder, why] = number
        return [
            f"not shown from {folder}: {number} {why}"
            for (folder, why), number in reasons.items()
        ]

    def _why_left_out(self, video: ReportVideo, run_ids: Collection[str]) -> str:
        origin = video.origin
        if origin.run_id not in run_ids:
            return f"of the run {origin.run_id}, which is not in this report"
        if origin.replay == "diverged":
            return "that came to another result than the recorded episode"
        shown = (placed.origin for placed in self.videos if placed.path in self._placed)
        if (origin.recording_sha256, origin.camera) in {
            (placed.recording_sha256, placed.camera) for placed in shown
        }:
            return "of an episode and a camera that another file shows"
        return "drawn from a recording that is not in this report"


def _check_folder(
    folder: Path, files: int, named: Sequence[ReportVideo], run_ids: Collection[str]
) -> None:
    if not files:
        raise UnusableRecord(f"{folder} has no videos: there is no file *.mp4 in it")
    if not named:
        raise UnusableRecord(
            f"no video in {folder} says which episode it shows: `proctor video` draws "
            "them again, and writes it into each"
        )
    theirs = sorted({video.origin.run_id for video in named})
    if not set(theirs) & set(run_ids):
        shown = ", ".join(theirs[:3]) + (", …" if len(theirs) > 3 else "")
        raise UnusableRecord(
            f"{folder} has no video of a run in this report: its videos are of {shown}"
        )
