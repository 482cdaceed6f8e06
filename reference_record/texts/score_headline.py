"""The score of a run in one line, or in a cell of a list, the same everywhere.

A mean over several splits mixes what a policy was trained on with what it was not. It
must not be quoted, so it stands behind those of the splits, or is called a mix.
Parentheses mean that the score is not complete.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any, Final

from reference_record.texts.counted_text import counted

_MIX: Final = "mix "
_NOTES: Final = {
    _MIX: "A mix is the mean over several splits: quote that of each split instead.",
    "(": "A score in parentheses is the mean of the episodes scored so far.",
}


def score_headline(score: Mapping[str, Any]) -> str:
    """The line. score: schema Score as JSON."""
    counts, part = score["counts"], ""
    if score.get("score") is None:
        scored, total = counts["total"] - counts["unscored"], counts["total"]
        mean = "" if score.get("mean") is None else f" with mean {score['mean']:.4f}"
        return (
            f"partial, {scored} of {counted(total, 'episode')}{mean}; not complete: "
            f"between {score['score_low']:.4f} and {score['score_high']:.4f}"
        )
    if any((score.get("select") or {}).values()):
        part = " of a part of the benchmark"
    by_split = score.get("by_split")
    if not by_split or not mix_of(score):
        mix = f", {mix_of(score)}" if mix_of(score) else ""
        return f"{score['score']:.4f}{part}{mix}"
    means = (f"{name} {one.get('mean') or 0.0:.4f}" for name, one in by_split.items())
    return f"{', '.join(means)}{part}; all splits mixed {score['score']:.4f}"


def mix_of(score: Mapping[str, Any] | None) -> str:
    """`mix of 2 splits`; empty of one split.

    The score of an entry with very many splits has the mean of none.
    """
    if not score:
        return ""
    by_split = score.get("by_split")
    if by_split is None:
        return "mix of all splits"
    return f"mix of {len(by_split)} splits" if len(by_split) > 1 else ""


def score_cell(score: Mapping[str, Any] | None) -> str:
    """`0.850`, `mix 0.850` over several splits, `(0.667)` of a part so far, or `–`."""
    if score is None or score.get("mean", score.get("score")) is None:
        return "–"
    if score.get("score") is None:
        return f"({score['mean']:.3f})"
    mix = _MIX if mix_of(score) else ""
    return f"{mix}{score['score']:.3f}"


def notes_on(cells: Iterable[str]) -> str:
    """Sentences on what these cells mean, if some need any."""
    shown = list(cells)
    notes = (
        note
        for mark, note in _NOTES.items()
        if any(cell.startswith(mark) for cell in shown)
    )
    return " ".join(notes)
