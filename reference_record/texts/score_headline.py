"""The score of a run in one line, or in a cell of a list, the same everywhere.

A mean over several splits mixes what a policy was trained on with what it was not. It
must not be quoted, so it stands behind those of the splits, or is called a mix.
Parentheses mean that the score is not complete.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any, Final

from reference_record.texts.counted_text import counted
from reference_record.texts.figures import figure

SPLITS_MAX: Final = 8  # side by side in the largest type
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
        mean = "" if score.get("mean") is None else f" with mean {_means(score)}"
        return (
            f"partial, {scored} of {counted(total, 'episode')}{mean}; not complete: "
            f"between {figure(score['score_low'], 4)} and "
            f"{figure(score['score_high'], 4)}"
        )
    if any((score.get("select") or {}).values()):
        part = " of a part of the benchmark"
    return _means(score, part)


def _means(score: Mapping[str, Any], part: str = "") -> str:
    """`0.8500`; over several splits the mean of each, and their mix behind them."""
    whole = figure(score.get("mean", score.get("score")), 4)
    by_split = score.get("by_split")
    if not by_split or not mix_of(score):
        return f"{whole}{part}{', ' * bool(mix_of(score))}{mix_of(score)}"
    means = (f"{name} {_number(one.get('mean'))}" for name, one in by_split.items())
    return f"{', '.join(means)}{part}; all splits mixed {whole}"


def _number(value: float | None) -> str:
    return "–" if value is None else figure(value, 4)


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


def means_to_quote(score: Mapping[str, Any]) -> list[tuple[str, float | None]]:
    """The mean of each split by its name; that of a single one without a name.

    Very many splits, or unknown ones, have one mean with the words for a mix.
    """
    by_split = score.get("by_split") or {}
    if mix_of(score) and 1 < len(by_split) <= SPLITS_MAX:
        return [(name, one.get("mean")) for name, one in by_split.items()]
    return [(mix_of(score), score.get("mean", score.get("score")))]


def score_cell(score: Mapping[str, Any] | None) -> str:
    """`0.850`, `mix 0.850` over several splits, or `–`; `(0.667)` of a part so far."""
    mean = None if score is None else score.get("mean", score.get("score"))
    if score is None or mean is None:
        return "–"
    cell = f"{_MIX if mix_of(score) else ''}{figure(mean, 3)}"
    return f"({cell})" if score.get("score") is None else cell


def notes_on(cells: Iterable[str]) -> str:
    """Sentences on what these cells mean, if some need any."""
    shown = list(cells)
    notes = (
        note for mark, note in _NOTES.items() if any(mark in cell for cell in shown)
    )
    return " ".join(notes)
