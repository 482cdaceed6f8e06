"""Two Parquet tables of a run: a row for each episode, and a row for each turn.

Written in row groups, so memory does not grow with the run. Units stand in the metadata
of a column, what the run was in that of the table.
"""

from __future__ import annotations

import datetime as dt
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any

import pyarrow as pa
import pyarrow.parquet as pq

from reference_record.broken import UnusableRecord
from reference_record.contents.declared_parts import declared_parts
from reference_record.contents.statement import EpisodeLine
from reference_record.recordings.recording import Turn
from reference_sim.exports.source import Source

EPISODES_FILE, TURNS_FILE = "episodes.parquet", "turns.parquet"
ROWS_IN_GROUP = 1024
CHANNELS_MAX = 1000  # of actions
LATENCY = "latency_"
ACTION = "action_"
TIME = pa.timestamp("ms", tz="UTC")

Row = Mapping[str, Any]


def _column(name: str, type_: pa.DataType, meaning: str, unit: str = "") -> pa.Field:
    said = {"meaning": meaning} | ({"unit": unit} if unit else {})
    return pa.field(name, type_, metadata=said)


_KEY = [
    _column("run_id", pa.string(), "id of the run"),
    _column("episode_index", pa.int32(), "place in the list of the benchmark, from 0"),
]
_EPISODE = [
    *_KEY,
    _column("episode_id", pa.string(), "id of the episode in the run"),
    _column("benchmark_id", pa.string(), "id of the benchmark"),
    _column("benchmark_version", pa.string(), "version of the benchmark"),
    _column("policy_name", pa.string(), "name of the policy, as submitted"),
    _column("policy_version", pa.string(), "version of the policy, as submitted"),
    _column("task", pa.string(), "what the robot had to do"),
    _column("split", pa.string(), "part of the benchmark"),
    _column("seed", pa.int64(), "fixes all chance; null: the secret of the host"),
    _column("outcome", pa.string(), "success, failure or abandoned; null: no result"),
    _column("success", pa.bool_(), "whether the outcome is success"),
    _column("score", pa.float64(), "from 0 to 1; null: no result", "1"),
    _column("steps", pa.int64(), "actions executed in the last attempt", "1"),
    _column("attempts", pa.int64(), "playings of the episode", "1"),
    _column("recording_sha256", pa.string(), "SHA-256 of its recording"),
]
_TURN = [
    *_KEY,
    _column("attempt", pa.int32(), "attempt at the episode, from 1"),
    _column(
        "start_number",
        pa.int32(),
        "start of the simulator, from 1: a fault begins "
        "the attempt again, and the last one counts",
    ),
    _column("turn_in_session", pa.int64(), "the `seq` of the turn"),
    _column("steps", pa.int32(), "actions executed in this turn", "1"),
    _column("rewards", pa.list_(pa.float64()), "one for each action", "1"),
    _column("score", pa.float64(), "of the episode after the turn", "1"),
    _column("success", pa.bool_(), "whether the episode is a success after the turn"),
    _column("ended", pa.bool_(), "whether the turn ended the episode"),
    _column("simulate_ms", pa.float64(), "time of the simulator", "ms"),
    _column("think_ms", pa.float64(), "from the answer before to this request", "ms"),
    _column("executed_at", TIME, "when the turn was over"),
    _column("state_digest", pa.string(), "of the simulator's state after the turn"),
]


def write_tables(source: Source, folder: Path) -> list[Path]:
    """episodes.parquet and turns.parquet. Raises UnusableRecord, OSError."""
    spaces = source.manifest.action_space
    if spaces is None or len(spaces) > CHANNELS_MAX:
        raise UnusableRecord("manifest.json has no action space that fits a table")
    latencies = _latency_names(source)
    episodes = pa.schema([*_EPISODE, *map(_latency_column, latencies)])
    turns = pa.schema([*_TURN, *_action_columns(spaces)])
    paths = [folder / EPISODES_FILE, folder / TURNS_FILE]
    rows = _episode_rows(source, latencies), _turn_rows(source, spaces)
    for path, schema, table_rows in zip(paths, (episodes, turns), rows, strict=True):
        said = {**source.provenance, "table": path.stem}
        _write(path, schema.with_metadata(said), table_rows)
    return paths


def _write(path: Path, schema: pa.Schema, rows: Iterable[Row]) -> None:
    with pq.ParquetWriter(path, schema, compression="zstd") as writer:
        group: list[Row] = []
        for row in rows:
            group.append(row)
            if len(group) == ROWS_IN_GROUP:
                writer.write_table(_table(group, schema))
                group.clear()
        if group:
            writer.write_table(_table(group, schema))


def _table(rows: list[Row], schema: pa.Schema) -> pa.Table:
    try:
        return pa.Table.from_pylist(rows, schema)
    except (pa.ArrowException, OverflowError) as error:
        detail = " ".join(str(error).split())[:200]
        raise UnusableRecord(
            f"the recordings do not fit the spaces of the manifest: {detail}"
        ) from error


def _episode_rows(source: Source, latencies: Iterable[str]) -> Iterator[Row]:
    said = source.evaluation
    run = {
        "run_id": said.run.run_id,
        "benchmark_id": said.benchmark.benchmark_id,
        "benchmark_version": said.benchmark.version,
        "policy_name": said.policy.name,
        "policy_version": said.policy.version,
    }
    for line in source.lines():
        quantiles = line.latency or {}
        yield {
            **run,
            "episode_id": line.episode_id,
            "episode_index": line.index,
            "task": line.task,
            "split": line.split,
            "seed": source.manifest.episodes[line.index].seed,
            "outcome": line.outcome,
            "success": line.success,
            "score": line.score,
            "steps": line.steps,
            "attempts": line.attempts,
            "recording_sha256": line.recording and line.recording.sha256,
            **{LATENCY + name: quantiles.get(name) for name in latencies},
        }


def _turn_rows(source: Source, channels: Iterable[str]) -> Iterator[Row]:
    run_id = source.evaluation.run.run_id
    for line in source.lines():
        for start, turn in source.turns(line):
            yield _turn_row(run_id, line, turn, channels) | {"start_number": start}


def _turn_row(
    run_id: str, line: EpisodeLine, turn: Turn, channels: Iterable[str]
) -> dict[str, Any]:
    return {
        "run_id": run_id,
        "episode_index": line.index,
        "attempt": turn.attempt,
        "turn_in_session": turn.seq,
        "steps": turn.steps,
        "rewards": turn.rewards,
        "score": turn.score,
        "success": turn.success,
        "ended": turn.ended,
        "simulate_ms": turn.simulate_ms,
        "think_ms": turn.think_ms,
        "executed_at": _time(turn.at),
        "state_digest": turn.state_digest,
        **{
            ACTION + name: [action.get(name) for action in turn.actions]
            for name in channels
        },
    }


def _action_columns(spaces: Mapping[str, Mapping[str, Any]]) -> Iterator[pa.Field]:
    """A chunk of actions is a list of vectors."""
    vectors = pa.list_(pa.list_(pa.float64()))
    for name, space in spaces.items():
        meaning = f"actions executed in the turn: {space.get('description', name)}"
        parts = declared_parts(space).values()
        units = ",".join(dict.fromkeys(part.scaled_unit or "1" for part in parts))
        yield _column(ACTION + name, vectors, meaning, units)


def _latency_names(source: Source) -> list[str]:
    """Names of the quantiles that a host gives; all lines of a run have the same."""
    for line in source.lines():
        if line.latency:
            return sorted(line.latency)[:CHANNELS_MAX]
    return []


def _latency_column(name: str) -> pa.Field:
    unit = "ms" if "_ms" in name else ""
    meaning = f"quantile over the turns of the episode: {name}"
    return _column(LATENCY + name, pa.float64(), meaning, unit)


def _time(text: str) -> dt.datetime:
    try:
        return dt.datetime.fromisoformat(text).astimezone(dt.UTC)
    except (ValueError, OverflowError) as error:
        raise UnusableRecord(f"{text[:50]} is no time of RFC 3339") from error
