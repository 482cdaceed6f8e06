"""A run as rows of a database, and back: plain values, and bytes that hold JSON.

It knows the names of the columns and nothing of the database (`run_store.py`).
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any, TypedDict

import msgspec

from reference_server.rules.manifest import Manifest
from reference_server.rules.runs.run import (
    Episode,
    Leaving,
    Recording,
    Result,
    Run,
    RunHead,
)

Row = Mapping[str, Any]
# The columns of an episode, and their types in the same order.
EPISODE_COLUMNS = (
    *("index", "attempt", "faults", "faults_forgiven"),
    *("policy_fault", "place", "last_left", "result", "recording"),
)
EpisodeRow = tuple[
    int, int, int, int, str | None, int | None, bytes | None, bytes | None, bytes | None
]

# Columns that are members of the object under the same name.
_COPIED_COLUMNS = (
    "run_id",
    "number",
    "account",
    "state",
    "reason",
    "retryable",
    "failed_by",
    "manifest_sha256",
    "max_workers",
    "idle_timeout_s",
    "created_at_wall",
    "updated_at_wall",
    "queue_until_wall",
    "attempts_by_submitter",
    "played_number",
    "owner",
)
# Stored of a run beside its submission, and of an episode: its plan and its result.
RUN_BYTES, EPISODE_BYTES = 1024, 512


class _ListedSubmission(TypedDict, total=False):
    """A submission without its options, which can be a thousand times the rest.

    Members that are not named here are skipped and cost next to nothing.
    """

    benchmark_id: Any
    policy: Any
    mode: Any
    images: Any
    labels: Any
    max_workers: Any
    idle_timeout_s: Any
    policy_server: Any
    any_policy: Any
    select: Any


_SUBMISSION = msgspec.json.Decoder()
_LISTED_SUBMISSION = msgspec.json.Decoder(_ListedSubmission)
_RESULT = msgspec.json.Decoder(Result)
_LAST_LEFT = msgspec.json.Decoder(Leaving)
_RECORDING = msgspec.json.Decoder(Recording)


def new_run_row(run: Run) -> dict[str, Any]:
    """All columns of a run but its number, which the database gives."""
    return run_row(run) | {
        "run_id": run.run_id,
        "account": run.account,
        "manifest_sha256": run.manifest_sha256,
        "submission": msgspec.json.encode(run.submission),
        "max_workers": run.max_workers,
        "idle_timeout_s": run.idle_timeout_s,
        "images": msgspec.json.encode(run.images),
        "created_at_wall": run.created_at_wall,
        "benchmark_id": run.manifest["benchmark_id"],
        "attempts_by_submitter": run.attempts_by_submitter,
        "owner": run.owner,
        "fence": run.fence,
        "stored_bytes": stored_bytes(run),
    }


def stored_bytes(run: RunHead) -> int:
    """LIM-010: what a run counts for its account; its submission is a part of it."""
    submission = msgspec.json.encode(run.submission)
    return RUN_BYTES + len(submission) + EPISODE_BYTES * run.total


def run_row(run: Run) -> dict[str, Any]:
    """The columns that change in a run's life."""
    return {
        "state": run.state,
        "reason": run.reason,
        "retryable": run.retryable,
        "failed_by": run.failed_by,
        "updated_at_wall": run.updated_at_wall,
        "queue_until_wall": run.queue_until_wall,
        "scored": run.scored,
        "played_number": run.played_number,
    }


def deleted_run_row(now_wall: float) -> dict[str, Any]:
    """The columns to overwrite when a run is deleted; DEL-006: it stays counted.

    Its ids, its account and benchmark, its numbers and the time of its submission stay.
    """
    return {
        "reason": None,
        "submission": b"{}",
        "images": b"{}",
        "stored_bytes": RUN_BYTES,
        "deleted_at_wall": now_wall,
    }


def episode_rows(run: Run, changed: set[int]) -> list[dict[str, Any]]:
    """The rows of those episodes, in manifest order."""
    rows = []
    for index in sorted(changed):
        episode = run.episodes[index]
        rows.append(
            {
                "number": run.number,
                "index": index,
                "attempt": episode.attempt,
                "faults": episode.faults,
                "faults_forgiven": episode.faults_forgiven,
                "policy_fault": episode.policy_fault,
                "place": episode.place,
                "last_left": _encode(episode.last_left),
                "result": _encode(episode.result),
                "recording": _encode(episode.recording),
            }
        )
    return rows


def _encode(value: Leaving | Result | Recording | None) -> bytes | None:
    return msgspec.json.encode(value) if value else None


def episodes_of(
    manifest: Manifest, places: range, stored: Iterable[EpisodeRow]
) -> list[Episode]:
    """The episodes at these places, by their plans and what has happened to them."""
    start = places.start
    episodes = [Episode.of(manifest, index) for index in places]
    for row in stored:
        _apply_row(episodes[row[0] - start], row)
    return episodes


def episode_of(manifest: Manifest, row: EpisodeRow) -> Episode:
    """One episode by its plan and what has happened to it."""
    episode = Episode.of(manifest, row[0])
    _apply_row(episode, row)
    return episode


def _apply_row(episode: Episode, row: EpisodeRow) -> None:
    _, episode.attempt, episode.faults, episode.faults_forgiven = row[:4]
    episode.policy_fault, episode.place = row[4:6]
    last_left, result, recording = row[6:]
    if last_left:
        episode.last_left = _LAST_LEFT.decode(last_left)
    if result:
        episode.result = _RESULT.decode(result)
    if recording:
        episode.recording = _RECORDING.decode(recording)


def _columns_of(
    row: Row, manifest: Manifest, submission: msgspec.json.Decoder[Any] = _SUBMISSION
) -> dict[str, Any]:
    """The members of a RunHead, but for its counts."""
    decoded = {
        "manifest": manifest,
        "submission": submission.decode(row["submission"]),
        "images": msgspec.json.decode(row["images"]),
        "fence": row["fence"] or 0,
    }
    return {name: row[name] for name in _COPIED_COLUMNS} | decoded


def head_of(row: Row, manifest: Manifest) -> RunHead:
    """`row` has every column of the run; `manifest` is shared and never changed."""
    return _head_of(row, manifest, _SUBMISSION)


def listed_head_of(row: Row, manifest: Manifest) -> RunHead:
    """The same without the options of its submission."""
    return _head_of(row, manifest, _LISTED_SUBMISSION)


def _head_of(
    row: Row, manifest: Manifest, submission: msgspec.json.Decoder[Any]
) -> RunHead:
    total = len(manifest["episodes"])
    columns = _columns_of(row, manifest, submission)
    return RunHead(**columns, total=total, scored=row["scored"])


def run_of(row: Row, manifest: Manifest, stored: Iterable[EpisodeRow]) -> Run:
    """The run with all its episodes, of which `stored` differ from their plans."""
    episodes = episodes_of(manifest, range(len(manifest["episodes"])), stored)
    return Run(**_columns_of(row, manifest), episodes=episodes)
