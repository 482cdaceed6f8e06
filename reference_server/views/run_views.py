"""Runs, episodes and scores in the spec's schemas, as plain data.

It shows what is so and decides nothing; which run an account may see is decided before.
"""

from __future__ import annotations

from collections.abc import Sequence

from reference_record.generated import answers
from reference_record.texts.timestamps import timestamp
from reference_server.rules.policy_server import PolicyServerConfig
from reference_server.rules.runs.run import Episode, PublicKey, RunHead
from reference_server.rules.scoring import ScoredEpisode, score_of


def run_view(run: RunHead, endpoint: str, queue_position: int | None) -> answers.Run:
    """Schema Run, for every operation that shows one (RUN-018, RUN-019)."""
    in_progress = sum(1 for s in run.live_sessions if s.episode is not None)
    view: answers.Run = {
        "run_id": run.run_id,
        "account": run.account,
        "state": run.state,
        "reason": run.reason,
        "retryable": run.retryable,  # RUN-023
        "benchmark_id": run.manifest["benchmark_id"],
        "benchmark_version": run.manifest["version"],
        "manifest_sha256": run.manifest_sha256,
        "policy": run.submission["policy"],
        "mode": "push" if run.is_push else "pull",
        "any_policy": run.any_policy,  # ATR-005
        "max_workers": run.max_workers,
        "idle_timeout_s": run.idle_timeout_s,
        "images": run.images,
        "endpoint": endpoint,
        "queue_position": queue_position,
        "live_workers": len(run.live_sessions),
        "progress": {  # RUN-014, RUN-022
            "episodes_total": run.total,
            "episodes_scored": run.scored,
            "episodes_in_progress": in_progress,
            "episodes_pending": run.total - run.scored - in_progress,
        },
        "created_at": timestamp(run.created_at_wall),
        "updated_at": timestamp(run.updated_at_wall),
    }
    if run.failed_by is not None:
        view["failed_by"] = run.failed_by
    if run.is_push:
        view["policy_server"] = PolicyServerConfig.from_run(run).view()
    if (select := run.submission.get("select")) is not None:  # SUB-003
        view["select"] = select
    if run.played_number is not None:  # DEL-006
        view["runs_played_before"] = run.played_number - 1
    if run.attempts_by_submitter is not None:
        view["attempts_by_submitter"] = run.attempts_by_submitter
    return view


def result_view(episode: Episode) -> answers.EpisodeResult:
    """The result of a scored episode."""
    result = episode.result
    assert result is not None
    view: answers.EpisodeResult = {
        "episode_id": episode.episode_id,
        "index": episode.index,
        "task": episode.task,
        "split": episode.split,
        "attempt": result.attempt,
        "faults": episode.faults,
        "outcome": result.outcome,
        "score": result.score,
        "steps": result.steps,
        "terminated": result.terminated,
        "truncated": result.truncated,
        "think_s": result.think_s,
        "finished_at": timestamp(result.finished_at_wall),
    }
    if not episode.is_sealed:  # SEAL-001, SEAL-002
        view["seed"] = episode.seed
    if result.player is not None:  # ATR-003
        view["player"] = result.player
    if result.clipped_actions is not None:  # ATR-004
        view["clipped_actions"] = result.clipped_actions
    if result.total_reward is not None:  # ATR-006
        view["total_reward"] = result.total_reward
    return view


def episode_view(episode: Episode) -> answers.Episode:
    """An episode, with its result if it has one."""
    status: answers.EpisodeStatus = "pending"
    if episode.result is not None:
        status = "scored"
    elif episode.in_progress:
        status = "in_progress"
    view: answers.Episode = {
        "episode_id": episode.episode_id,
        "index": episode.index,
        "task": episode.task,
        "split": episode.split,
        "status": status,
        "attempt": episode.attempt,
        "faults": episode.faults,
    }
    if episode.policy_fault is not None:
        view["policy_fault"] = episode.policy_fault
    if (left := episode.last_left) is not None:  # RSN-001
        view["last_left"] = {"attempt": left.attempt, "reason": left.reason}
    if episode.result is not None:
        view["result"] = result_view(episode)
    return view


def key_view(key: PublicKey) -> answers.PublicKey:
    """A key that signs records, or did."""
    retired = key.retired_at_wall
    return {
        "keyid": key.keyid,
        "algorithm": "ed25519",
        "public_key": key.public_key,
        "created_at": timestamp(key.created_at_wall),
        "retired_at": None if retired is None else timestamp(retired),
    }


def comparison_view(
    baseline: RunHead, tolerance: float, entries: Sequence[answers.ComparedRun]
) -> answers.Comparison:
    """Runs beside their baseline, in order (CMP-001, CMP-012)."""
    return {
        "baseline": baseline.run_id,
        "benchmark_id": baseline.manifest["benchmark_id"],
        "manifest_sha256": baseline.manifest_sha256,
        "tolerance": tolerance,
        "runs": entries,
    }


def scored_episodes(episodes: Sequence[Episode]) -> list[ScoredEpisode]:
    """The members of a run's episodes that scoring reads, in manifest order."""
    return [
        ScoredEpisode(e.task, e.split, e.result.outcome, e.result.score)
        if e.result
        else ScoredEpisode(e.task, e.split, None)
        for e in episodes
    ]


def score_view(run: RunHead, episodes: Sequence[Episode]) -> answers.Score:
    """The score of all episodes of the run (SCORE-014)."""
    view: answers.Score = {
        "run_id": run.run_id,
        "benchmark_id": run.manifest["benchmark_id"],
        "manifest_sha256": run.manifest_sha256,
        "state": run.state,
        **score_of(scored_episodes(episodes)),
    }
    if (select := run.submission.get("select")) is not None:  # SUB-003
        view["select"] = select
    return view
