"""Entries, rankings and the history in the spec's schemas, as plain data."""

from __future__ import annotations

from typing import cast

from reference_record.generated import answers
from reference_record.history.checkpoint import Checkpoint
from reference_record.texts.timestamps import timestamp
from reference_server.rules.board.entry_changes import BoardEntry
from reference_server.rules.board.ranking import ALPHA, Ranking, Row


def entry_view(
    entry: BoardEntry, attempts: int, judged: answers.JudgedRun | None = None
) -> answers.BoardEntry:
    """An entry (BRD-003, BRD-024); attempts: of its account until now.

    judged: how people judged its run, if they did.
    """
    score = entry.score
    if judged is not None and "second" in judged:
        score = score | {"second_judge": judged["second"]}
    view: answers.BoardEntry = {
        "entry_id": entry.entry_id,
        "run_id": entry.run_id,
        "submitter": entry.account,
        "benchmark_id": entry.benchmark_id,
        "benchmark_version": entry.benchmark_version,
        "manifest_sha256": entry.manifest_sha256,
        "policy": entry.policy,
        "model_name": entry.description["model_name"],
        "is_public": entry.is_public,
        "state": entry.state,
        "level": entry.level,
        "attempts": attempts,
        "score": score,
        "published_at": timestamp(entry.published_at_wall),
        "changed_at": timestamp(entry.changed_at_wall),
    }
    if entry.select is not None:
        view["select"] = entry.select
    if entry.flag is not None:
        at = timestamp(entry.flag.flagged_at_wall)
        view["flag"] = {"reason": entry.flag.reason, "flagged_at": at}
    return cast("answers.BoardEntry", {**entry.description, **view})


def ranking_view(
    benchmark_id: str, manifest_sha256: str, episodes_total: int | None, of: Ranking
) -> answers.Ranking:
    """A ranking, before its rows are added."""
    return {
        "benchmark_id": benchmark_id,
        "manifest_sha256": manifest_sha256,
        "episodes_total": episodes_total,
        "ranked": of.ranked,
        "comparisons": of.comparisons,
        "alpha": ALPHA,
        "differing_min": of.differing_min,
        "differing_enough": of.differing_enough,
        "rows": (),
        "next_cursor": None,
    }


def row_view(row: Row, entry: answers.BoardEntry) -> answers.RankedEntry:
    """A row of a ranking."""
    view: answers.RankedEntry = {
        "entry": entry,
        "better": row.better,
        "worse": row.worse,
        "letters": list(row.letters),
    }
    if row.rank is not None:
        low, high = row.rank
        view["rank"] = {"low": low, "high": high}
    return view


def checkpoint_view(signed: Checkpoint, note: str, keyid: str) -> answers.Checkpoint:
    """A signed state of the history."""
    return {
        "tree_size": signed.tree_size,
        "root_sha256": signed.root.hex(),
        "note": note,
        "keyid": keyid,
    }
