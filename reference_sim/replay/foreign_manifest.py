"""Reads the benchmark of a record from its manifest, which may be of unknown origin.

A manifest may be made to be slow and large. A server reads it in a process of its own,
whose small result is compared with the benchmarks that the machine itself offers.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

import msgspec

from reference_record.broken import BrokenRecord
from reference_record.contents.benchmark_manifest import (
    manifest_sha256,
    without_sealed_seeds,
)
from reference_record.contents.statement import Evaluation
from reference_record.formats.names import MANIFEST, STATEMENT
from reference_record.formats.strict_json import read_json
from reference_record.history.drawn_seeds import (
    BrokenDraw,
    SeedsDrawn,
    seeds_drawn_of,
)


class _PlannedEpisode(msgspec.Struct):
    split: str


class _ForeignManifest(msgspec.Struct):
    """The few members that are read; the rest of the manifest is only compared."""

    episodes: list[_PlannedEpisode]
    sealed_splits: list[str] = []


class Part(msgspec.Struct, frozen=True, omit_defaults=True):
    """The tasks and splits of a run that is of a part of its benchmark; None: all."""

    tasks: list[str] | None = None
    splits: list[str] | None = None


class BenchmarkChoice(msgspec.Struct, frozen=True):
    """The benchmark that a record names, with digests in place of its manifest.

    open_sha256: the digest of the manifest without the seeds that a host keeps secret,
        in the form of BEN-006, also where the record has an earlier form.
    seeds_sha256: the digest of these seeds, to which the host is committed.
    seeds_drawn: the draw that they follow from, if there was one.
    """

    benchmark_id: str
    options: dict[str, Any] | None
    images: dict[str, Any] | None
    open_sha256: str
    select: Part | None = None
    seeds_sha256: str | None = None
    seeds_drawn: SeedsDrawn | None = None

    @property
    def drawn(self) -> dict[str, Any] | None:
        """`seeds_drawn` as the manifest has it."""
        drawn = self.seeds_drawn
        return None if drawn is None else msgspec.structs.asdict(drawn)


def read_choice(evaluation: Evaluation, manifest: bytes) -> BenchmarkChoice:
    """Reads the whole manifest, which may be large. Raises BrokenRecord."""
    read_json(MANIFEST, manifest, _ForeignManifest)
    whole = msgspec.json.decode(manifest)
    commitment = whole.get("seeds_sha256")
    try:
        open_sha256 = manifest_sha256(open_part(whole))
        drawn = seeds_drawn_of(whole)
    except (ValueError, RecursionError, BrokenDraw) as error:
        detail = str(error) or "it nests too deeply"
        raise BrokenRecord(MANIFEST, "REC-008", detail) from error
    return BenchmarkChoice(
        evaluation.benchmark.benchmark_id,
        evaluation.run.options,
        evaluation.run.images,
        open_sha256,
        _part_of(evaluation.score.get("select")),
        commitment if _is_sha256(commitment) else None,
        drawn,
    )


def _part_of(select: object) -> Part | None:
    """SUB-003: as the score of the record says it. Raises BrokenRecord."""
    try:
        return msgspec.convert(select, Part | None)
    except msgspec.ValidationError as error:
        raise BrokenRecord(STATEMENT, "REC-007", f"select: {error}") from error


def selected(manifest: dict[str, Any], part: Part | None) -> dict[str, Any]:
    """The manifest with the episodes of a part alone (SUB-001)."""
    if part is None:
        return manifest
    episodes = [
        episode
        for episode in manifest["episodes"]
        if (part.tasks is None or episode["task"] in part.tasks)
        and (part.splits is None or episode["split"] in part.splits)
    ]
    return {**manifest, "episodes": episodes, "episodes_total": len(episodes)}


def differences(recorded: Any, here: Any, at: str = "") -> Iterator[str]:
    """The members in which two manifests differ, each in a few words."""
    if isinstance(recorded, dict) and isinstance(here, dict):
        for name in sorted(recorded.keys() | here.keys()):
            inner = f"{at}.{name}" if at else name
            yield from differences(recorded.get(name), here.get(name), inner)
    elif recorded != here:
        before, now = _in_few_words(recorded), _in_few_words(here)
        yield f"{at} is {now} here, {before} in the record"


def _in_few_words(value: Any) -> str:
    if value is None:
        return "absent"
    text = value if isinstance(value, str) else msgspec.json.encode(value).decode()
    return repr(text[:40])[1:-1] + "…" * (len(text) > 40)


def _is_sha256(text: object) -> bool:
    return isinstance(text, str) and re.fullmatch("[0-9a-f]{64}", text) is not None


def open_part(manifest: dict[str, Any]) -> dict[str, Any]:
    """The manifest without what the host of a sealed split keeps secret."""
    shown = without_sealed_seeds(manifest)
    return {k: v for k, v in shown.items() if k != "seeds_sha256"}
