"""Records of benchmarks, played and recorded as by the server."""

import hashlib
from collections.abc import Callable, Container, Iterable, Mapping, Sequence
from itertools import islice
from pathlib import Path
from typing import Any

import msgspec

from reference_record.contents.benchmark_manifest import (
    manifest_file,
    manifest_sha256,
    texts_of,
)
from reference_record.contents.score import compute_score
from reference_record.contents.statement import (
    BenchmarkFacts,
    EpisodeLine,
    Evaluation,
    PolicyFacts,
    RecordingFacts,
    RunFacts,
)
from reference_record.formats.names import recording_name
from reference_record.generated.answers import Outcome
from reference_record.recordings.recording import EpisodeResult, Message, Turn
from reference_record.recordings.recording_file import join_parts
from reference_record.recordings.recording_parts import (
    TurnCommand,
    append_part,
    json_of,
    parts_of,
    read_part,
)
from reference_record.unsigned_record import host_of, read_files, save_blocks
from reference_sim import benchmark_registry
from reference_sim.engine import engine_fingerprint
from reference_sim.episode import Episode
from reference_sim.interface import Simulator
from reference_sim.process.recorder import EpisodeRecorder, RecordingPlan
from tests.support.record.sample_records import HOST_KEY, at
from tests.support.sim.calibration_action import calibration_action

OPTIONS = {"tasks": ["score", "count", "echo"]}
Change = Callable[[int, int, Turn], Turn]
Chunk = Sequence[Mapping[str, Sequence[float]]]
# Episode, simulator → the chunks to execute, while the episode has not ended.
Player = Callable[[Episode, Simulator], Iterable[Chunk]]
# Two turns of two steps each; the last one ends with success.
CHUNKS: Sequence[Chunk] = (
    [calibration_action(), calibration_action(score=0.25)],
    [calibration_action(score=0.5), calibration_action(score=1, success=1, end=1)],
)


def keep(_index: int, _turn: int, turn: Turn) -> Turn:
    return turn


def play_chunks(_episode: Episode, _simulator: Simulator) -> Iterable[Chunk]:
    return CHUNKS


def save_calibration_record(path: Path, folder: Path, change: Change = keep) -> Path:
    """Every episode of `calibration` with CHUNKS. change: (index, number of the turn,
    turn) → the turn as it is recorded."""
    found = benchmark_registry.resolve("calibration", OPTIONS, None)
    return save_played_record(path, folder, found, play_chunks, change=change)


def save_played_record(
    path: Path,
    folder: Path,
    found: benchmark_registry.ResolvedBenchmark,
    player: Player,
    *,
    only: Container[int] = range(10**5),
    change: Change = keep,
    options: Mapping[str, Any] = OPTIONS,
    faults: int = 0,
    run_id: str = "r",
    sha256: str | None = None,
) -> Path:
    """Play episodes, sign the record, save it. only: indices; others have no result.
    sha256: that of the manifest, where it has an earlier form. options: those of
    `found`, if it is calibration. faults: how often each episode begins again after its
    first chunk."""
    sha256 = sha256 or manifest_sha256(found.manifest)
    manifest = manifest_file(found.manifest, sha256)
    lines, recordings = [], {}
    for index in range(len(found.episodes)):
        if index not in only:
            lines.append(_unplayed(found, index))
            continue
        name = recording_name(index)
        recordings[name] = folder / f"{index}.mcap"
        call = found, index, recordings[name], player, change
        lines.append(_play(*call, faults=faults))
    evaluation = _evaluation(found, manifest, lines, options, run_id)
    files = read_files(manifest=manifest, lines=lines, recordings=recordings)
    save_blocks(path, files.sign(evaluation, HOST_KEY).stream())
    return path


def _unplayed(found: benchmark_registry.ResolvedBenchmark, index: int) -> EpisodeLine:
    plan = found.episodes[index]
    line = f"e{index}", index, plan.task, plan.split
    return EpisodeLine(*line, None, False, None, 0, 0, None, None)


def _play(
    found: benchmark_registry.ResolvedBenchmark,
    index: int,
    path: Path,
    player: Player,
    change: Change,
    *,
    faults: int,
) -> EpisodeLine:
    simulator, plan = benchmark_registry.make(found.world), found.episodes[index]
    parts = path.with_suffix("")
    for chunks in (*[1] * faults, None):
        episode = Episode(
            simulator,
            plan.task,
            plan.seed,
            split=plan.split,
            max_steps=found.manifest["max_steps"],
            success_rule=found.manifest["success_rule"],
            score_is_success=plan.task in found.world.success_scored_tasks,
        )
        recorder = EpisodeRecorder(RecordingPlan(str(parts), 1), simulator, episode)
        played = islice(player(episode, simulator), chunks)
        for seq, chunk in enumerate(played, 1):
            command = msgspec.msgpack.encode(TurnCommand(chunk, seq, think_ms=1.0))
            recorder.add_turn(command, list(episode.play(chunk)), episode, 0.001)
        recorder.close()
    outcome: Outcome = "success" if episode.success else "failure"
    scored = episode.success, episode.score, episode.steps
    result = EpisodeResult(outcome, *scored, 1, at(9))
    _change_turns(parts, index, change)
    summary = join_parts(parts, path, [("/result", 0, result)])
    assert summary.first_digest is not None
    assert summary.last_digest is not None
    return EpisodeLine(
        f"e{index}",
        index,
        plan.task,
        plan.split,
        outcome,
        episode.success,
        episode.score,
        episode.steps,
        1,
        None,
        RecordingFacts(
            recording_name(index),
            summary.sha256,
            summary.bytes,
            summary.first_digest,
            summary.last_digest,
        ),
    )


def _change_turns(parts: Path, index: int, change: Change) -> None:
    messages: list[tuple[str, Message]] = []
    number = 0
    for part in parts_of(parts):
        for topic, _, read in read_part(part):
            type_ = Turn if topic == "/turn" else msgspec.Raw
            said: Any = msgspec.json.decode(json_of(read), type=type_)
            if isinstance(said, Turn):
                number += 1
                said = change(index, number, said)
            messages.append((topic, said))
        part.unlink()
    for message in messages:
        append_part(parts, *message)


def _evaluation(
    found: benchmark_registry.ResolvedBenchmark,
    manifest: bytes,
    lines: Sequence[EpisodeLine],
    options: Mapping[str, Any],
    run_id: str,
) -> Evaluation:
    sha256 = hashlib.sha256(manifest).hexdigest()
    benchmark_id = found.manifest["benchmark_id"]
    score: dict[str, Any] = {**compute_score([line.scored for line in lines])}
    score |= {"benchmark_id": benchmark_id, "manifest_sha256": sha256}
    score["run_id"] = run_id
    return Evaluation(
        run=RunFacts(
            run_id,
            "pull",
            dict(options) if benchmark_id == "calibration" else None,
            dict(found.images),
        ),
        benchmark=BenchmarkFacts(
            benchmark_id, found.manifest["version"], dict(texts_of(found.manifest))
        ),
        manifest_sha256=sha256,
        policy=PolicyFacts("p"),
        score=score,
        engine=engine_fingerprint(),
        protocol_version="1.0",
        host=host_of("a host", HOST_KEY),
        started_at=at(0),
        finished_at=at(9),
        attempts_by_submitter=1,
        previous_statement_sha256=None,
        promise="exact",
    )
