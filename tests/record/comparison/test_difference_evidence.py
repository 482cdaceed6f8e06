"""Differences that chance explains, and those that it does not."""

import random

import pytest
from hypothesis import given
from hypothesis import strategies as st

from reference_record.comparison.difference_evidence import sign_test, weigh_differences


@pytest.mark.parametrize(
    ("wins", "losses", "p"),
    [
        (0, 0, 1.0),
        (3, 3, 1.0),
        (1, 0, 1.0),
        (5, 0, 0.0625),
        (1, 10, 0.01171875),
        # Fagerland, Lydersen, Laake, BMC Medical Research Methodology 13:91 (2013).
        (7, 1, 0.0703125),
    ],
)
def test_known_p_values(wins: int, losses: int, p: float) -> None:
    assert sign_test(wins, losses) == sign_test(losses, wins) == p


def test_p_values_of_many_episodes_are_finite() -> None:
    assert sign_test(0, 5000) == 0.0
    assert sign_test(10_000, 10_000) == 1.0
    assert 0.0 < sign_test(10_300, 9_700) < 1e-4


@given(st.integers(0, 60), st.integers(0, 60))
def test_a_larger_gap_is_never_likelier(wins: int, losses: int) -> None:
    more = max(wins, losses) + 1
    assert sign_test(more, min(wins, losses)) <= sign_test(wins, losses) <= 1


def test_the_tasks_are_corrected_together() -> None:
    """Six losses of one task and none of two others: p is 1/32, of three tasks."""
    pairs = [("a", 1.0, 0.5)] * 6 + [("b", 1.0, 1.0), ("c", 0.0, 0.0)]
    found = weigh_differences(pairs)
    a = found.by_task["a"]
    assert list(found.by_task) == ["a", "b", "c"]
    assert (a.better, a.worse) == (0, 6)
    assert (a.p_value, found.overall.p_value) == (3 / 32, 1 / 32)
    assert (a.is_shown, found.overall.is_shown) == (False, True)
    assert weigh_differences(pairs * 2).by_task["a"].is_shown


def test_a_single_task_is_tested_once() -> None:
    """Six losses: p is 1/32, of one group."""
    found = weigh_differences([("a", 1.0, 0.5)] * 6)
    assert found.overall == found.by_task["a"]
    assert found.overall.p_value == 1 / 32


def test_a_task_may_be_called_overall() -> None:
    found = weigh_differences([("overall", 1.0, 0.5), ("a", 0.5, 1.0)])
    assert (found.overall.better, found.overall.worse) == (1, 1)
    of_task = found.by_task["overall"]
    assert (of_task.better, of_task.worse) == (0, 1)


def test_equally_good_policies_are_rarely_called_different() -> None:
    """Ten tasks of twenty episodes, in which both succeed by chance. Expect the whole,
    and one task or more, in at most 5 % of 400 comparisons, and some deviation."""
    chance = random.Random(1)
    whole = tasks = 0
    for _ in range(400):
        pairs = [
            (str(task), float(chance.random() < 0.5), float(chance.random() < 0.5))
            for task in range(10)
            for _ in range(20)
        ]
        found = weigh_differences(pairs)
        whole += found.overall.is_shown
        tasks += any(one.is_shown for one in found.by_task.values())
    assert max(whole, tasks) <= 0.05 * 400 + 2 * (400 * 0.05 * 0.95) ** 0.5
