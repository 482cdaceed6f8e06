"""`proctor video`: episodes of a record, drawn again from their recorded actions.

No picture is stored in a record. The simulator plays the actions again, at any size,
and after every turn its state is compared with the recorded digest: a video whose
episode came to another result is refused unless it is wanted anyway, and its name says
so then. Each file says of which recording it is.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import Any

from reference_record.broken import UnusableRecord
from reference_record.contents.statement import EpisodeLine
from reference_record.formats.video_origin import append_origin
from reference_sim.exports.job import Job
from reference_sim.exports.progress import ProgressBar
from reference_sim.exports.simulated_episodes import (
    SimulatedStep,
    Simulation,
    difference_text,
    replay_facts,
    simulation,
)
from reference_sim.exports.source import Source, video_origin
from reference_sim.exports.video_file import VideoFile
from reference_sim.interface import Observation
from reference_sim.replay.episode_replay import EpisodeReplay

UNFINISHED = ".part"


@dataclass(frozen=True, slots=True)
class Wanted:
    """A video to write. path: what it is called if the replay keeps to the record."""

    camera: str
    path: Path

    @property
    def unfinished(self) -> Path:
        return self.path.with_name(self.path.name + UNFINISHED)

    @property
    def diverged(self) -> Path:
        return self.path.with_stem(self.path.stem + "-diverged")


def write_videos(source: Source, job: Job) -> Mapping[str, Any]:
    """A file for each episode and camera. Raises UnusableRecord, OSError.

    The answer has `files`, in `refused` the episodes that left the record, and in
    `left_out` those that cannot be simulated here.
    """
    files: list[dict[str, Any]] = []
    refused: list[dict[str, Any]] = []
    with (
        ProgressBar("drawing") as bar,
        simulation(source, job, bar.say, draws=True) as replayed,
    ):
        left_out = replayed.left_out(job)
        replayed.say_left_out(left_out, job)
        lines = replayed.lines(job)
        if not lines:
            failed = "failed episode can be simulated" if left_out else "episode failed"
            bar.say(f"no {failed}: there is nothing to draw")
        plan = [(line, _wanted(replayed, line, job)) for line in lines]
        bar.begin(sum(line.steps for line in lines))
        for line, wanted in plan:
            replay, drawn = _draw(source, replayed, line, wanted, bar)
            if text := difference_text(line, replay):
                bar.say(text)
            if replay.result == "diverged" and not (job.anyway and drawn):
                _remove(wanted)
                refused.append(replay_facts(line, replay))
                continue
            files += [_finish(source, video, line, replay, drawn) for video in wanted]
        if refused:
            bar.say("no video is kept of what left the record; --anyway keeps it")
    return {"files": files, "refused": refused, "left_out": left_out}


def _wanted(replayed: Simulation, line: EpisodeLine, job: Job) -> list[Wanted]:
    there = replayed.cameras(line.task)
    if not there:
        name = replayed.manifest["benchmark_id"]
        raise UnusableRecord(
            f"{name} has no camera in the task {line.task}: there is nothing to draw"
        )
    cameras = job.cameras or there
    for camera in cameras:
        if camera not in there:
            raise UnusableRecord(
                f"the task {line.task} has no camera {camera}; it has "
                f"{', '.join(there)}"
            )
    folder = Path(job.output or f"{job.stem}-videos")
    folder.mkdir(parents=True, exist_ok=True)
    wanted = []
    for camera in dict.fromkeys(cameras):
        name = "" if len(cameras) == 1 else "-" + re.sub(r"[^\w.-]", "_", camera)
        video = Wanted(camera, folder / f"{line.index:05d}{name}.mp4")
        for existing in (video.path, video.diverged):
            if existing.exists() and not job.force:
                raise UnusableRecord(f"{existing} exists; --force replaces it")
        wanted.append(video)
    return wanted


def _draw(
    source: Source,
    replayed: Simulation,
    line: EpisodeLine,
    wanted: Sequence[Wanted],
    bar: ProgressBar,
) -> tuple[EpisodeReplay, int]:
    """Writes the unfinished files, with so many pictures; removes them on an error."""
    rate = Fraction(replayed.manifest["control_rate_hz"]).limit_denominator(1000)
    texts = _texts(source, line)
    videos: dict[str, VideoFile] = {}
    pictures = 0

    def see(observation: Observation, step: SimulatedStep | None) -> None:
        nonlocal pictures
        for video in wanted:
            picture = observation.images[video.camera]
            if video.camera not in videos:
                height, width, _ = picture.shape
                videos[video.camera] = VideoFile(
                    video.unfinished,
                    rate,
                    (width, height),
                    keyframe_every=max(1, round(rate)),
                    texts=texts | {"title": f"{texts['title']}, {video.camera}"},
                )
            videos[video.camera].add(picture)
        pictures += 1
        if step is not None:
            bar.advance()

    try:
        replay = replayed.play(line, see)
        for video in videos.values():
            video.close()
    except BaseException:
        _remove(wanted)
        raise
    return replay, pictures


def _texts(source: Source, line: EpisodeLine) -> dict[str, str]:
    said = source.provenance
    what = f"{said['benchmark_id']}, {line.task}, episode {line.index}: {line.outcome}"
    comment = "; ".join(f"{name}: {text}" for name, text in said.items())
    return {"title": what, "comment": comment}


def _finish(
    source: Source,
    video: Wanted,
    line: EpisodeLine,
    replay: EpisodeReplay,
    pictures: int,
) -> dict[str, Any]:
    path = video.diverged if replay.result == "diverged" else video.path
    append_origin(video.unfinished, video_origin(source, line, replay, video.camera))
    video.unfinished.replace(path)
    return {
        "path": str(path),
        "bytes": path.stat().st_size,
        "camera": video.camera,
        "pictures": pictures,
        **replay_facts(line, replay),
    }


def _remove(wanted: Sequence[Wanted]) -> None:
    for video in wanted:
        video.unfinished.unlink(missing_ok=True)
