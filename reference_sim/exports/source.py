"""The record that is exported, verified, as the exports read it."""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import msgspec

from reference_record.broken import UnusableRecord
from reference_record.contents.statement import EpisodeLine, Evaluation, read_lines
from reference_record.formats.bundle import Bundle, open_bundle
from reference_record.formats.names import EPISODES, MANIFEST
from reference_record.formats.video_origin import VideoOrigin
from reference_record.recordings.mcap_reader import read_messages
from reference_record.recordings.recording import AttemptEvent, Turn
from reference_record.verification import verify
from reference_sim.replay.episode_replay import EpisodeReplay

_ATTEMPT = msgspec.json.Decoder(AttemptEvent)
_TURN = msgspec.json.Decoder(Turn)


class SeededEpisode(msgspec.Struct):
    """seed: absent while it is the secret of the host."""

    task: str
    split: str
    seed: int | None = None


class ExportedManifest(msgspec.Struct):
    """The members of manifest.json that exports use.

    action_space: name → schema VectorSpace.
    """

    episodes: list[SeededEpisode]
    action_space: dict[str, dict[str, Any]] | None = None


@dataclass(frozen=True, slots=True)
class Source:
    """A record that was verified. statement_sha256: the digest that names it."""

    path: Path
    bundle: Bundle
    evaluation: Evaluation
    manifest: ExportedManifest
    statement_sha256: str

    def lines(self) -> Iterator[EpisodeLine]:
        """Every episode of the run, one after another."""
        return read_lines(self.bundle.blocks(EPISODES))

    def turns(self, line: EpisodeLine) -> Iterator[tuple[int, Turn]]:
        """The executed turns of all attempts at an episode, each with the number of the
        start before it: a fault starts an attempt again.
        """
        if line.recording is None:
            return
        start = 0
        for topic, data in read_messages(self.bundle, line.recording.path):
            if topic == "/attempt":
                start += _ATTEMPT.decode(data).event == "started"
            elif topic == "/turn":
                yield start, _TURN.decode(data)

    def starts(self, line: EpisodeLine) -> int:
        """How often the episode was begun at step 0."""
        assert line.recording is not None
        messages = read_messages(self.bundle, line.recording.path)
        return sum(
            _ATTEMPT.decode(data).event == "started"
            for topic, data in messages
            if topic == "/attempt"
        )

    @property
    def provenance(self) -> Mapping[str, str]:
        """Texts that say in an export which record it is of."""
        said = self.evaluation
        return {
            "run_id": said.run.run_id,
            "benchmark_id": said.benchmark.benchmark_id,
            "benchmark_version": said.benchmark.version,
            "manifest_sha256": said.manifest_sha256,
            "statement_sha256": self.statement_sha256,
            "policy_name": said.policy.name,
            "policy_version": said.policy.version or "",
            "note": "an export of a record, without a signature; the record is "
            "what can be verified and replayed",
        }


def video_origin(
    source: Source, line: EpisodeLine, replay: EpisodeReplay, camera: str
) -> VideoOrigin:
    """The origin that is written into a video of this episode, which was recorded."""
    assert line.recording is not None
    return VideoOrigin(
        run_id=source.evaluation.run.run_id,
        statement_sha256=source.statement_sha256,
        episode_index=line.index,
        recording_sha256=line.recording.sha256,
        camera=camera,
        replay=replay.result,
        turn=None if replay.where is None else replay.seq,
    )


def open_source(path: Path) -> Source:
    """Verify a record. Raises BrokenRecord, UnusableRecord, OSError."""
    bundle = open_bundle(path)
    report = verify(bundle)
    try:
        manifest = msgspec.json.decode(bundle.read(MANIFEST), type=ExportedManifest)
    except msgspec.ValidationError as error:
        raise UnusableRecord(f"{MANIFEST} is none of this protocol: {error}") from error
    return Source(path, bundle, report.evaluation, manifest, report.statement_sha256)


@contextmanager
def new_folder(target: Path) -> Iterator[Path]:
    """A directory of files that are in `target` in the end, or gone after a fault.

    A target that is there is filled, and not replaced: it may be a link, a mounted
    folder, or one with an owner and a mode. Raises UnusableRecord where it has files.
    """
    is_there = target.exists()
    if is_there and (not target.is_dir() or any(target.iterdir())):
        raise UnusableRecord(
            f"{target} exists and is not empty: remove it, or name another with -o"
        )
    parent = target if is_there else target.parent
    unfinished = parent / f".{target.name}-{os.getpid()}"
    unfinished.mkdir(parents=True)
    try:
        yield unfinished
        if not is_there:
            unfinished.rename(target)
            return
        for path in list(unfinished.iterdir()):
            path.rename(target / path.name)
        unfinished.rmdir()
    except BaseException:
        shutil.rmtree(unfinished, ignore_errors=True)
        raise
