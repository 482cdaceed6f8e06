"""The score of a run in one line, in a cell, and whether it is a mix of splits."""

from typing import Any

import pytest

from reference_record.texts.score_headline import (
    means_to_quote,
    mix_of,
    notes_on,
    score_cell,
    score_headline,
)

ALL = {"total": 4, "unscored": 0}
SO_FAR = {
    "counts": {"total": 4, "unscored": 1},
    "score_low": 0.5,
    "score_high": 0.75,
}
PARTS = "train 1.0000, test 0.5000, new –; all splits mixed 0.7500"
BOUNDS = "not complete: between 0.5000 and 0.7500"
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
        (
            {"by_split": HALVES | {"new": {"mean": None}}, "score": None, **SO_FAR},
            f"partial, 3 of 4 episodes with mean {PARTS}; {BOUNDS}",
            "(mix 0.750)",
            "mix of 3 splits",
        ),
        (
            {"by_split": {"test": {"mean": 0.75}}, "score": None, **SO_FAR},
            f"partial, 3 of 4 episodes with mean 0.7500; {BOUNDS}",
            "(0.750)",
            "",
        ),
        ({}, "0.7500, mix of all splits", "mix 0.750", "mix of all splits"),
        (
            {"by_split": {"test": {"mean": 0.75}}, "select": {"splits": ["test"]}},
            "0.7500 of a part of the benchmark",
            "0.750",
            "",
        ),
    ],
    ids=["one", "two", "so-far", "one-so-far", "splits-not-named", "part"],
)
def test_a_score_of_several_splits_is_called_a_mix(
    members: dict[str, Any], headline: str, cell: str, mix: str
) -> None:
    """The score of an entry with very many splits names none."""
    score = {"score": 0.75, "mean": 0.75, "counts": ALL} | members
    assert score_headline(score) == headline
    assert score_cell(score) == cell
    assert mix_of(score) == mix


@pytest.mark.parametrize(
    ("by_split", "means"),
    [
        ({"test": {"mean": 0.75}}, [("", 0.75)]),
        (HALVES, [("train", 1.0), ("test", 0.5)]),
        ({str(n): {"mean": 0.75} for n in range(9)}, [("mix of 9 splits", 0.75)]),
        (None, [("mix of all splits", 0.75)]),
    ],
)
def test_the_largest_numbers_are_those_that_may_be_quoted(
    by_split: Any, means: list[tuple[str, float]]
) -> None:
    assert means_to_quote({"score": 0.75, "mean": 0.75, "by_split": by_split}) == means


@pytest.mark.parametrize(
    ("cells", "notes"),
    [
        (["0.500", "–"], ""),
        (["(0.500)"], "A score in"),
        (["0.500", "mix 0.500"], "A mix is"),
        (["(mix 0.500)"], "A mix is the mean over several splits: quote that of each "),
    ],
)
def test_a_list_explains_its_marks(cells: list[str], notes: str) -> None:
    said = notes_on(cells)
    assert said.startswith(notes)
    assert ("A score in parentheses" in said) == any("(" in cell for cell in cells)
    assert bool(said) == bool(notes)


def test_no_score_is_no_mix() -> None:
    assert (mix_of(None), score_cell(None)) == ("", "–")
