"""A run as a LeRobotDataset: what was seen and done in its episodes, simulated again.

A record has no observations: the simulator plays the recorded actions, and what a
policy saw is written as states and videos. A frame is an observation with the action
that was executed on it. Each episode has a video file of its own for each camera.
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from operator import itemgetter
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from reference_record.broken import UnusableRecord
from reference_record.contents.statement import EpisodeLine
from reference_record.formats.video_origin import append_origin
from reference_sim.exports import lerobot_format as layout
from reference_sim.exports.job import Job
from reference_sim.exports.progress import ProgressBar
from reference_sim.exports.simulated_episodes import (
    SimulatedStep,
    Simulation,
    difference_text,
    left_out_facts,
    replay_facts,
    simulation,
)
from reference_sim.exports.source import Source, video_origin
from reference_sim.exports.video_file import VideoFile, encoded_size
from reference_sim.interface import Observation
from reference_sim.replay.episode_replay import EpisodeReplay

STATE, ACTION, IMAGES = "observation.state", "action", "observation.images."
REWARD, DONE, SUCCESS = "next.reward", "next.done", "next.success"
KEYFRAME_EVERY = 2  # as LeRobot writes it: training reads single pictures
PROVENANCE_PATH = "meta/proctor.json"

Json = dict[str, Any]


def write_dataset(source: Source, folder: Path, job: Job) -> Mapping[str, Any]:
    """Raises UnusableRecord, OSError. An episode that diverges is left out."""
    refused: list[Json] = []
    with ProgressBar("simulating") as bar, simulation(source, job, bar.say) as replayed:
        left_out = replayed.left_out(job)
        replayed.say_left_out(left_out, job)
        lines = []
        for line in replayed.lines(job):
            if line.outcome and line.steps:
                lines.append(line)
            else:
                left_out.append(left_out_facts(line, "no_action"))
        if not lines:
            raise UnusableRecord("none of these episodes has an executed action")
        dataset = _Dataset(source, folder, _Spaces.of(replayed, lines, job), bar)
        bar.begin(sum(line.steps for line in lines))
        for line in lines:
            frames = dataset.begin(line)
            try:
                replay = replayed.play(line, frames.see)
            finally:
                frames.close()
            if text := difference_text(line, replay):
                bar.say(text)
            if replay.result == "diverged" and not (job.anyway and frames.count):
                frames.remove()
                refused.append(replay_facts(line, replay))
            else:
                dataset.add(line, frames, replay, replayed.instruction)
        if refused:
            bar.say("what left the record is left out; --anyway keeps it")
        if not dataset.episodes:
            raise UnusableRecord("no episode is left")
        left_out = [
            *left_out,
            *({**facts, "reason": "left_record"} for facts in refused),
        ]
        dataset.close(sorted(left_out, key=itemgetter("episode")))
    counts = {"episodes": len(dataset.episodes), "frames": dataset.frames}
    return {**counts, "refused": refused, "left_out": left_out}


@dataclass(frozen=True, slots=True)
class _Spaces:
    """The parts of observations and actions that are written: names, in this order."""

    state: Mapping[str, int]
    action: Mapping[str, int]
    cameras: Sequence[str]
    fps: int

    @classmethod
    def of(
        cls, replayed: Simulation, lines: Sequence[EpisodeLine], job: Job
    ) -> _Spaces:
        manifest = replayed.manifest
        tasks = {line.task for line in lines}
        every = [
            name
            for name in manifest["observation_space"]["images"]
            if all(name in replayed.cameras(task) for task in tasks)
        ]
        for camera in job.cameras or ():
            if camera not in every:
                there = ", ".join(every) or "none"
                raise UnusableRecord(
                    f"not all of these episodes have a camera {camera}: {there}"
                )
        spaces = manifest["observation_space"]["state"], manifest["action_space"]
        state, action = ({k: v["size"] for k, v in space.items()} for space in spaces)
        cameras = [name for name in every if name in (job.cameras or every)]
        # LeRobot knows whole numbers of frames a second alone.
        fps = max(1, round(manifest["control_rate_hz"]))
        return cls(state, action, cameras, fps)


@dataclass(slots=True)
class _EpisodeFrames:
    """The frames of one episode while it is simulated, its videos already on disk."""

    spaces: _Spaces
    paths: Mapping[str, Path]
    bar: ProgressBar
    states: list[NDArray[np.float64]] = field(default_factory=list)
    actions: list[NDArray[np.float64]] = field(default_factory=list)
    steps: list[SimulatedStep] = field(default_factory=list)
    sampled: dict[str, list[NDArray[np.uint8]]] = field(default_factory=dict)
    videos: dict[str, VideoFile] = field(default_factory=dict)
    before: tuple[NDArray[np.float64], dict[str, NDArray[np.uint8]]] | None = None
    sample_every: int = 1

    @property
    def count(self) -> int:
        return len(self.steps)

    def see(self, after: Observation, step: SimulatedStep | None) -> None:
        before = self.before
        # A simulator may draw the next picture into the same memory.
        images = {name: after.images[name].copy() for name in self.spaces.cameras}
        self.before = _joined(after.state, self.spaces.state), images
        if step is None or before is None:
            return
        self.states.append(before[0])
        self.actions.append(_joined(step.action, self.spaces.action))
        for camera, picture in before[1].items():
            self._add_picture(camera, picture)
        self.steps.append(step)
        self.bar.advance()

    def _add_picture(self, camera: str, picture: NDArray[np.uint8]) -> None:
        if camera not in self.videos:
            height, width, _ = picture.shape
            self.paths[camera].parent.mkdir(parents=True, exist_ok=True)
            self.videos[camera] = VideoFile(
                self.paths[camera],
                Fraction(self.spaces.fps),
                (width, height),
                keyframe_every=KEYFRAME_EVERY,
                texts={},
            )
        self.videos[camera].add(picture)
        if self.count % self.sample_every == 0:
            self.sampled.setdefault(camera, []).append(layout.thinned(picture))

    def close(self) -> None:
        for video in self.videos.values():
            video.close()

    def remove(self) -> None:
        for path in self.paths.values():
            path.unlink(missing_ok=True)


class _Dataset:
    """The files of the data set, and what is known of the episodes so far."""

    def __init__(
        self, source: Source, folder: Path, spaces: _Spaces, bar: ProgressBar
    ) -> None:
        self._source, self._folder, self._spaces, self._bar = (
            source,
            folder,
            spaces,
            bar,
        )
        self._data: layout.DataFiles | None = None
        self._features: dict[str, Json] = {}
        self._tasks: dict[str, int] = {}
        self._statistics: dict[str, layout.Statistics] = {}
        self.episodes: list[Json] = []
        self.frames = 0

    def begin(self, line: EpisodeLine) -> _EpisodeFrames:
        place = layout.file_place(len(self.episodes))
        paths = {
            camera: self._folder
            / layout.VIDEO_PATH.format(video_key=IMAGES + camera, **place)
            for camera in self._spaces.cameras
        }
        frames = _EpisodeFrames(self._spaces, paths, self._bar)
        frames.sample_every = -(-line.steps // layout.IMAGES_FOR_STATISTICS)
        return frames

    def add(
        self,
        line: EpisodeLine,
        frames: _EpisodeFrames,
        replay: EpisodeReplay,
        instruction: str,
    ) -> None:
        for camera in frames.videos:
            origin = video_origin(self._source, line, replay, camera)
            append_origin(frames.paths[camera], origin)
        if self._data is None:
            self._features = self._describe(frames)
            self._data = layout.DataFiles(self._folder, self._features)
        columns = self._columns(frames, instruction)
        place = self._data.add(columns)
        columns_statistics = {
            name: layout.number_statistics(v) for name, v in columns.items()
        }
        for camera, images in frames.sampled.items():
            columns_statistics[IMAGES + camera] = layout.image_statistics(images)
        for name, column_statistics in columns_statistics.items():
            before = self._statistics.get(name)
            self._statistics[name] = (
                column_statistics
                if before is None
                else layout.merge_statistics(before, column_statistics)
            )
        self.episodes.append(
            self._row(line, frames, instruction, place, columns_statistics)
        )
        self.frames += frames.count

    def close(self, left_out: Sequence[Json]) -> None:
        assert self._data is not None
        self._data.close()
        info = {
            "robot_type": self._source.evaluation.benchmark.benchmark_id,
            "total_frames": self.frames,
            "fps": self._spaces.fps,
            "video_path": layout.VIDEO_PATH if self._spaces.cameras else None,
            "features": self._features,
        }
        layout.write_meta(
            self._folder,
            info=info,
            tasks=list(self._tasks),
            episodes=self.episodes,
            statistics=self._statistics,
        )
        said = {**self._source.provenance, "left_out": list(left_out)}
        (self._folder / PROVENANCE_PATH).write_text(json.dumps(said, indent=4) + "\n")

    def _describe(self, frames: _EpisodeFrames) -> dict[str, Json]:
        spaces = self._spaces
        features = {
            IMAGES + camera: layout.video_feature(encoded_size(video.size), spaces.fps)
            for camera, video in frames.videos.items()
        }
        for name, channels in ((STATE, spaces.state), (ACTION, spaces.action)):
            if channels:
                features[name] = layout.vector_feature(_element_names(channels))
        features[REWARD] = layout.number_feature("float32")
        features[DONE] = features[SUCCESS] = layout.number_feature("bool")
        return features | dict(layout.PLACES)

    def _columns(
        self, frames: _EpisodeFrames, instruction: str
    ) -> dict[str, NDArray[Any]]:
        """name → (frames, n) or (frames,)."""
        count, steps = frames.count, frames.steps
        vectors = {STATE: frames.states, ACTION: frames.actions}
        numbers = np.arange(count)
        task = self._tasks.setdefault(instruction, len(self._tasks))
        return {
            **{k: np.array(v) for k, v in vectors.items() if k in self._features},
            REWARD: np.array([step.reward for step in steps]),
            DONE: np.array([step.ended for step in steps]),
            SUCCESS: np.array([step.success for step in steps]),
            "timestamp": numbers / self._spaces.fps,
            "frame_index": numbers,
            "episode_index": np.full(count, len(self.episodes)),
            "index": numbers + self.frames,
            "task_index": np.full(count, task),
        }

    def _row(
        self,
        line: EpisodeLine,
        frames: _EpisodeFrames,
        instruction: str,
        place: Mapping[str, int],
        of_columns: Mapping[str, layout.Statistics],
    ) -> Json:
        number, count = len(self.episodes), frames.count
        row: Json = {
            "episode_index": number,
            "tasks": [instruction],
            "length": count,
            "dataset_from_index": self.frames,
            "dataset_to_index": self.frames + count,
            **{f"data/{name}": value for name, value in place.items()},
        }
        for camera in frames.videos:
            video = {**layout.file_place(number), "from_timestamp": 0.0}
            video["to_timestamp"] = count / self._spaces.fps
            row |= {f"videos/{IMAGES}{camera}/{k}": v for k, v in video.items()}
        for name, statistics in of_columns.items():
            lists = layout.as_lists(statistics)
            row |= {f"stats/{name}/{k}": v for k, v in lists.items()}
        assert line.recording is not None, "it was simulated from one"
        return row | {
            "proctor/episode_index": line.index,
            "proctor/recording_sha256": line.recording.sha256,
            "proctor/outcome": line.outcome,
            "proctor/score": line.score,
        }


def _joined(
    values: Mapping[str, Any], channels: Mapping[str, int]
) -> NDArray[np.float64]:
    """(n,): the values of all channels, one behind the other."""
    parts = [np.asarray(values[name], np.float64).reshape(-1) for name in channels]
    return np.concatenate(parts) if parts else np.empty(0)


def _element_names(channels: Mapping[str, int]) -> list[str]:
    return [
        name if size == 1 else f"{name}_{element}"
        for name, size in channels.items()
        for element in range(size)
    ]
