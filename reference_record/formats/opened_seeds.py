"""Seeds of sealed splits that a host has opened: their file, proven by the manifest.

The manifest of a record commits its host to the seeds. Nothing else says that a file of
seeds is true: it needs no signature.
"""

from __future__ import annotations

import codecs
import hashlib
import json
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Annotated, Any, Final

import msgspec
from msgspec import Meta

from reference_record.broken import BrokenRecord, UnusableRecord
from reference_record.formats.strict_json import read_json

FILE_BYTES_MAX: Final = 2**26
Text = Annotated[str, Meta(max_length=1024)]


class OpenedEpisode(msgspec.Struct, frozen=True):
    task: Text
    split: Text
    seed: Annotated[int, Meta(ge=0, le=2**53 - 1)]


class OpenedSeeds(msgspec.Struct, frozen=True):
    """REC-015: of one choice of options. episodes: all of sealed splits, in order."""

    seeds_sha256: Annotated[str, Meta(pattern="^[0-9a-f]{64}$")]
    salt: Annotated[str, Meta(pattern="^([0-9a-f]{2}){16,64}$")]
    episodes: list[OpenedEpisode]

    @property
    def commitment(self) -> str:
        """REC-015: the value that `seeds_sha256` must have."""
        seeds = json.dumps([episode.seed for episode in self.episodes])
        return hashlib.sha256(bytes.fromhex(self.salt) + seeds.encode()).hexdigest()


class OpenedBenchmark(msgspec.Struct, frozen=True):
    """The content of a file."""

    benchmark_id: Text
    opened: list[OpenedSeeds]


def load_opened_seeds(path: Path) -> OpenedBenchmark:
    """Read the file. Raises UnusableRecord."""
    try:
        with path.open("rb") as file:  # REC-030
            data = file.read(FILE_BYTES_MAX + 1)
    except OSError as error:
        raise UnusableRecord(f"{path}: {error.strerror or error}") from error
    if len(data) > FILE_BYTES_MAX:
        raise UnusableRecord(f"{path} has more than {FILE_BYTES_MAX} bytes [REC-030]")
    try:
        # People hand it on, and an editor may add a byte order mark.
        text = data.removeprefix(codecs.BOM_UTF8)
        return read_json(str(path), text, OpenedBenchmark)
    except BrokenRecord as broken:
        raise UnusableRecord(
            f"{path} is no file of opened seeds: {broken.detail} [REC-015]"
        ) from broken


def seeds_for(opened: OpenedBenchmark, manifest: Mapping[str, Any]) -> dict[int, int]:
    """REC-032: index → seed of every episode of the manifest in a sealed split.

    Raises UnusableRecord where the manifest does not commit its host to these seeds.
    """
    commitment, sealed = manifest.get("seeds_sha256"), _sealed_episodes(manifest)
    if commitment is None or not sealed:
        raise UnusableRecord(
            "no seeds of the record are sealed: leave out the file [REC-032]"
        )
    fitting = [seeds for seeds in opened.opened if seeds.seeds_sha256 == commitment]
    if not fitting:
        raise UnusableRecord(
            f"the file of seeds has none for {commitment}, to which the record commits "
            "its host: they are of another benchmark, host or choice of options "
            "[REC-032]"
        )
    if fitting[0].commitment != commitment:
        raise UnusableRecord(
            "the seeds in the file are not those to which the record commits its host: "
            f"their SHA-256 is {fitting[0].commitment}, not {commitment} [REC-015]"
        )
    # A run may be of some tasks and splits alone; the host is committed to all seeds.
    tasks, splits = (
        {episode[member] for episode in manifest["episodes"]}
        for member in ("task", "split")
    )
    episodes = [
        episode
        for episode in fitting[0].episodes
        if episode.task in tasks and episode.split in splits
    ]
    if [(e.task, e.split) for e in episodes] != list(sealed.values()):
        raise UnusableRecord(
            "the file of seeds has other episodes than the record [REC-032]"
        )
    return dict(zip(sealed, (episode.seed for episode in episodes), strict=True))


def _sealed_episodes(manifest: Mapping[str, Any]) -> dict[int, tuple[str, str]]:
    """Index → task and split."""
    sealed = frozenset(manifest.get("sealed_splits", ()))
    return {
        index: (episode["task"], episode["split"])
        for index, episode in enumerate(manifest["episodes"])
        if episode["split"] in sealed
    }


def write_opened_seeds(benchmark_id: str, opened: Iterable[OpenedSeeds]) -> bytes:
    """REC-015: the content of the file."""
    return msgspec.json.encode(OpenedBenchmark(benchmark_id, list(opened))) + b"\n"
