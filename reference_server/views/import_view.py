"""Records that were handed in, in the specification's schemas."""

from __future__ import annotations

from typing import Any

from reference_server.generated import models
from reference_server.rules.imported_record import ImportReplay, RecordImport, Trust
from reference_server.views.run_views import timestamp


def import_view(
    one: RecordImport, trust: Trust, episodes_replayed: int
) -> dict[str, Any]:
    """Schema RecordImport."""
    done_at = one.finished_at_wall
    view = models.RecordImport(
        import_id=one.import_id,
        state=one.state,
        level=trust.level,
        level_text=trust.text,
        signer=trust.signer,
        keyid=one.keyid,
        archive_sha256=one.archive_sha256,
        statement_sha256=one.statement_sha256,
        size_bytes=one.size_bytes,
        run_id=one.run_id,
        benchmark_id=one.benchmark_id,
        benchmark_version=one.benchmark_version,
        manifest_sha256=one.manifest_sha256,
        policy=models.ImportedPolicy(name=one.policy_name, version=one.policy_version),
        score=one.score,
        episodes=one.episodes,
        episodes_replayed=episodes_replayed,
        reason=one.reason,
        imported_at=timestamp(one.imported_at_wall),
        finished_at=None if done_at is None else timestamp(done_at),
    )
    if one.replay is not None:
        view.replay = _replay_view(one.replay)
    return view.model_dump()


def _replay_view(replay: ImportReplay) -> models.RecordReplay:
    view = models.RecordReplay(
        result=replay.result,
        episodes=replay.episodes,
        exact=replay.exact,
        outcome=replay.outcome,
        diverged=replay.diverged,
    )
    if where := replay.first_divergence:
        view.first_divergence = models.ReplayDivergence(
            episode_index=where.episode_index, attempt=where.attempt, step=where.step
        )
    return view
