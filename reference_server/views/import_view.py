"""Records that were handed in, in the specification's schemas."""

from __future__ import annotations

from reference_record.generated import answers
from reference_record.texts.timestamps import timestamp
from reference_server.rules.imported_record import ImportReplay, RecordImport, Trust


def import_view(
    record_import: RecordImport, trust: Trust, episodes_replayed: int
) -> answers.RecordImport:
    """A record that was handed in."""
    done_at = record_import.finished_at_wall
    view: answers.RecordImport = {
        "import_id": record_import.import_id,
        "state": record_import.state,
        "level": trust.level,
        "level_text": trust.text,
        "signer": trust.signer,
        "keyid": record_import.keyid,
        "archive_sha256": record_import.archive_sha256,
        "statement_sha256": record_import.statement_sha256,
        "size_bytes": record_import.size_bytes,
        "run_id": record_import.run_id,
        "benchmark_id": record_import.benchmark_id,
        "benchmark_version": record_import.benchmark_version,
        "manifest_sha256": record_import.manifest_sha256,
        "policy": {
            "name": record_import.policy_name,
            "version": record_import.policy_version,
        },
        "score": record_import.score,
        "episodes": record_import.episodes,
        "episodes_replayed": episodes_replayed,
        "reason": record_import.reason,
        "imported_at": timestamp(record_import.imported_at_wall),
        "finished_at": None if done_at is None else timestamp(done_at),
    }
    if record_import.replay is not None:
        view["replay"] = _replay_view(record_import.replay)
    return view


def _replay_view(replay: ImportReplay) -> answers.RecordReplay:
    view: answers.RecordReplay = {
        "result": replay.result,
        "episodes": replay.episodes,
        "exact": replay.exact,
        "outcome": replay.outcome,
        "diverged": replay.diverged,
    }
    if where := replay.first_divergence:
        view["first_divergence"] = {
            "episode_index": where.episode_index,
            "attempt": where.attempt,
            "step": where.step,
        }
    return view
