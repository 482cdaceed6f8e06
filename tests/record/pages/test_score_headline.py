"""The score of a run in one line, in a cell, and whether it is a mix of splits."""

from typing import Any

import pytest

from reference_record.texts.score_headline import mix_of, score_cell, score_headline

HALVES = {"train": {"mean": 1.0}, "test": {"mean": 0.5}}


@pytest.mark.parametrize(
    ("members", "headline", "cell", "mix"),
    [
        ({"by_split": {"test": {"mean": 0.75}}}, "0.7500", "0.750", ""),
        (
            {"by_split": HALVES},
            "train 1.0000, test 0.5000; all splits mixed 0.7500",
            "mix 0.750",
            "mix of 2 splits",
        ),
        ({}, "0.7500, mix of all splits", "mix 0.750", "mix of all splits"),
        (
            {"by_split": {"test": {"mean": 0.75}}, "select": {"splits": ["test"]}},
            "0.7500 of a part of the benchmark",
            "0.750",
            "",
        ),
    ],
    ids=["one-split", "two-splits", "splits-not-named", "part"],
)
def test_a_score_of_several_splits_is_called_a_mix(
    members: dict[str, Any], headline: str, cell: str, mix: str
) -> None:
    """Of an entry with very many splits, the score names none."""
    counts = {"total": 4, "unscored": 0}
    score = {"score": 0.75, "mean": 0.75, "counts": counts} | members
    assert score_headline(score) == headline
    assert score_cell(score) == cell
    assert mix_of(score) == mix


def test_no_score_is_no_mix() -> None:
    assert (mix_of(None), score_cell(None)) == ("", "–")
