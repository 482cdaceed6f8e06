"""Makes of a record the documents of the API that the pages show.

A record has fewer facts than a server: what it does not say stays absent. Its author
chose its texts, so each is checked for its type before a template sees it.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Annotated, Any, TypeVar

import msgspec
from msgspec import Meta, Struct

from reference_record.comparison.judge_agreement import (
    agreement_document,
    second_sample,
)
from reference_record.contents.benchmark_manifest import merged
from reference_record.contents.statement import (
    EpisodeLine,
    Evaluation,
    SecondJudgement,
    read_lines,
)
from reference_record.formats.bundle import Bundle
from reference_record.formats.names import EPISODES, MANIFEST
from reference_record.generated.answers import (
    ImageChoice,
    ImageSize,
    ImageSpace,
    SecondJudgements,
    SimulatorInfo,
    TensorSpace,
    VectorPart,
)
from reference_record.pages.page_contents import signed_level
from reference_record.pages.recorded_episode import (
    TEXT_CHARS_MAX,
    RecordedEpisode,
    read_recorded_episode,
)
from reference_record.pages.run_page import Document
from reference_record.pages.static_pages import ReportedRun
from reference_record.verification import verify

T = TypeVar("T")
_VOID = "void: "


class _Space(Struct, omit_defaults=True):
    """The members behind `parts` are those of earlier drafts, which had no parts."""

    size: int
    out_of_range: str
    parts: dict[str, VectorPart] | None = None
    unit: str | None = None
    rotation: str | None = None
    frame: str | None = None
    relative: bool | None = None
    gripper_open: float | None = None
    minimum: list[float] | None = None
    maximum: list[float] | None = None
    description: str = ""


class _Observation(Struct):
    state: dict[str, _Space]
    images: dict[str, ImageSpace]
    tensors: dict[str, TensorSpace]


class _Manifest(Struct):
    """The members of a manifest that the page of a benchmark shows."""

    benchmark_id: str
    version: str
    title: str
    description: str
    episodes_total: int
    tasks: list[str]
    splits: list[str]
    control_rate_hz: float
    max_steps: int
    max_chunk: int
    max_attempts: int
    max_faults: int
    success_rule: str
    action_space: dict[str, _Space]
    observation_space: _Observation
    image_sizes: list[ImageSize]
    image_codecs: list[str]
    simulator: SimulatorInfo
    sealed_splits: list[str] | None = None
    seeds_sha256: str | None = None
    task_goals: dict[str, str] = {}


class _Physical(Struct):
    order_seed: int
    second_judge_share: Annotated[float, Meta(ge=0, le=1)] = 0.0


class _PhysicalManifest(Struct):
    physical: _Physical


class _Player(Struct):
    name: str
    version: str | None = None
    client: str | None = None


class _Seed(Struct):
    seed: int | None = None


class _Seeds(Struct):
    episodes: list[_Seed]


@dataclass(slots=True)
class _JudgedRun:
    """How people judged the episodes that were read so far."""

    judges: set[str] = field(default_factory=set)
    blind: bool = True
    voids: Counter[str] = field(default_factory=Counter)
    notes_by_episode: dict[str, str] = field(default_factory=dict)
    success_by_episode: dict[str, bool] = field(default_factory=dict)
    cells: dict[str, str] = field(default_factory=dict)
    second: Sequence[SecondJudgement] = ()
    sample: frozenset[str] = frozenset()
    benchmark_id: str = ""
    _read: set[str] = field(default_factory=set)

    def add(self, episode_id: str, recorded: RecordedEpisode) -> None:
        """Take in an episode; a second time changes nothing."""
        if episode_id in self._read:
            return
        self._read.add(episode_id)
        for _, what, why in recorded.events:
            if what == "ended" and why.startswith(_VOID):
                self.voids[why.removeprefix(_VOID)] += 1
        if (given := recorded.judgement) is not None:
            self.judges.add(given.judge[:TEXT_CHARS_MAX])
            self.blind = self.blind and given.blind
            self.notes_by_episode[episode_id] = given.note[:TEXT_CHARS_MAX]
            self.success_by_episode[episode_id] = given.success
            if given.cell != self.benchmark_id:
                self.cells[episode_id] = given.cell[:TEXT_CHARS_MAX]

    def document(self) -> dict[str, Any]:
        """Schema JudgedRun."""
        notes = {name: note for name, note in self.notes_by_episode.items() if note}
        judged = {
            "judges": sorted(self.judges),
            "judgements": len(self.notes_by_episode),
            "blind": self.blind,
            "voids": dict(self.voids),
            "notes": notes,
        }
        second = self._second()
        named = {name: cell for name, cell in self.cells.items() if cell}
        judged |= {"cells": named} if named else {}
        return judged | ({"second": second} if second else {})

    def _second(self) -> SecondJudgements | None:
        """The second judgements in the statement: others are not known."""
        first = self.success_by_episode
        drawn = self.sample & first.keys()
        if not drawn:
            return None
        judged = [given for given in self.second if given.episode_id in drawn]
        judges = {given.judge for given in judged}
        pairs = [(first[given.episode_id], given.success) for given in judged]
        return agreement_document(len(drawn), judges, pairs)


def read_reported_run(bundle: Bundle, trusted: Mapping[str, str]) -> ReportedRun:
    """A record that was verified, as a report shows it; raises BrokenRecord.

    trusted: keyid → whose key it is.
    """
    report = verify(bundle, trusted)
    said = report.evaluation
    manifest = bundle.read(MANIFEST)
    seeds = _convert(manifest, _Seeds)
    episodes = [
        _episode(line, None if seeds is None else seeds.episodes[line.index].seed)
        for line in read_lines(bundle.blocks(EPISODES))
    ]
    recordings = {
        line.index: line.recording
        for line in read_lines(bundle.blocks(EPISODES))
        if line.recording is not None
    }

    run, sample = _run(said, episodes), _sample(manifest, said, episodes)
    judged = _JudgedRun(
        second=said.second_judgements,
        sample=sample,
        benchmark_id=said.benchmark.benchmark_id,
    )

    def read(episode: Document) -> RecordedEpisode | None:
        recording = recordings.get(episode["index"])
        if recording is None:
            return None
        name = recording.path
        with bundle.open(name) as file:
            recorded = read_recorded_episode(file, bundle.sizes[name], name)
        recorded.sha256 = recording.sha256
        _complete(episode, recorded)
        judged.add(episode["episode_id"], recorded)
        if judged.notes_by_episode or judged.voids:
            run["judged"] = judged.document()
        return recorded

    benchmark = _benchmark(manifest, said)
    return ReportedRun(
        run=run,
        score=said.score,
        episodes=episodes,
        benchmark=None
        if benchmark is None
        else msgspec.to_builtins(benchmark)
        | {"manifest_sha256": said.manifest_sha256, "unavailable_reason": None},
        level=signed_level(report.levels),
        read=read,
    )


def _benchmark(manifest: bytes, said: Evaluation) -> _Manifest | None:
    """The benchmark as the host showed it; None where members are absent."""
    try:
        whole = merged(msgspec.json.decode(manifest), said.benchmark.shown)
        return msgspec.convert(whole, _Manifest)
    except (msgspec.MsgspecError, RecursionError):
        return None


def _sample(
    manifest: bytes, said: Evaluation, episodes: Sequence[Document]
) -> frozenset[str]:
    """The episodes that a second person judges."""
    known = _convert(manifest, _PhysicalManifest)
    if known is None:
        return frozenset()
    names = [episode["episode_id"] for episode in episodes]
    physical = msgspec.structs.asdict(known.physical)
    return second_sample(physical, said.run.run_id, names)


def _convert(data: bytes, kind: type[T]) -> T | None:
    try:
        return msgspec.json.decode(data, type=kind)
    except (msgspec.MsgspecError, RecursionError):
        return None


def _images(said: Mapping[str, Any] | None) -> ImageChoice | None:
    """The pictures that the policy was sent; None if it cannot be known."""
    try:
        return msgspec.convert(said, ImageChoice)
    except msgspec.ValidationError:
        return None


def _run(said: Evaluation, episodes: list[dict[str, Any]]) -> dict[str, Any]:
    scored = sum("result" in episode for episode in episodes)
    return {
        "run_id": said.run.run_id,
        "state": "completed",
        "reason": None,
        "benchmark_id": said.benchmark.benchmark_id,
        "benchmark_version": said.benchmark.version,
        "manifest_sha256": said.manifest_sha256,
        "policy": {"name": said.policy.name, "version": said.policy.version,
                   "homepage": None},
        "mode": said.run.mode,
        "images": _images(said.run.images),
        "options": said.run.options,
        "idle_timeout_s": None,
        "attempts_by_submitter": said.attempts_by_submitter,
        "queue_position": None,
        "live_workers": 0,
        "progress": {"episodes_total": len(episodes), "episodes_scored": scored},
        "created_at": said.started_at,
        "updated_at": said.finished_at,
    }  # fmt: skip


def _episode(line: EpisodeLine, seed: int | None) -> dict[str, Any]:
    episode: dict[str, Any] = {
        "episode_id": line.episode_id,
        "index": line.index,
        "task": line.task,
        "split": line.split,
        "status": "scored" if line.outcome else "pending",
        "attempt": line.attempts,
        "faults": 0,
    }
    if line.outcome is None:
        return episode
    result: dict[str, Any] = {
        "outcome": line.outcome,
        "score": line.score,
        "steps": line.steps,
        "attempt": line.attempts,
    }
    if seed is not None:
        result["seed"] = seed
    try:
        player = msgspec.convert(line.player, _Player)
        result["player"] = msgspec.to_builtins(player)
    except msgspec.ValidationError:
        pass  # none, or none that can be shown
    return episode | {"result": result}


def _complete(episode: Document, recorded: RecordedEpisode) -> None:
    """Add to the episode's document the facts that only its recording has."""
    assert isinstance(episode, dict)
    faults = [event for event in recorded.events if event[1] == "simulator fault"]
    episode["faults"] = len(faults)
    result = episode["result"]
    result["think_s"] = sum(turn.think_ms for turn in recorded.turns) / 1000
    result["total_reward"] = sum(sum(turn.rewards) for turn in recorded.turns)
    result["finished_at"] = recorded.result.at if recorded.result else None
