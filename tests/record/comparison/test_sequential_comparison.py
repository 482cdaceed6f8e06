"""The comparison that may be watched: numbers by hand, and errors in the long run."""

import math
from fractions import Fraction

import numpy as np
import pytest

from reference_record.comparison.sequential_comparison import (
    ALPHA,
    THRESHOLD,
    compare_sequentially,
    describe,
    log_e_value,
)

WIN, LOSS, TIE, OPEN = (False, True), (True, False), (True, True), (True, None)


@pytest.mark.parametrize(
    ("wins", "losses", "e_value"),
    [
        (0, 0, Fraction(1)),
        (1, 0, Fraction(1)),
        # 2^2 · B(5/2, 1/2) / B(1/2, 1/2) = 4 · (3/8 π) / π
        (2, 0, Fraction(3, 2)),
        # 2^2 · B(3/2, 3/2) / B(1/2, 1/2) = 4 · (1/8 π) / π
        (1, 1, Fraction(1, 2)),
        (6, 0, Fraction(231, 16)),
        (7, 0, Fraction(429, 16)),
    ],
)
def test_the_e_value_is_as_by_hand(wins: int, losses: int, e_value: Fraction) -> None:
    """Expect it of the closed form, and of the episodes one after another."""
    found = compare_sequentially([WIN] * wins + [TIE] + [LOSS] * losses)
    assert math.exp(log_e_value(wins, losses)) == pytest.approx(float(e_value))
    assert found.e_value == pytest.approx(float(e_value))
    assert (found.wins, found.losses, found.left) == (wins, losses, 0)


def test_the_mean_after_one_more_episode_is_the_value_before() -> None:
    """It is valid at any time, because under the hypothesis it is a fair game."""
    for wins in range(12):
        for losses in range(12):
            nexts = (log_e_value(wins + 1, losses), log_e_value(wins, losses + 1))
            mean = sum(map(math.exp, nexts)) / 2
            assert mean == pytest.approx(math.exp(log_e_value(wins, losses)))


def test_seven_wins_decide_and_six_do_not() -> None:
    six = compare_sequentially([WIN] * 6 + [OPEN] * 10)
    assert (six.better, six.decided_after, six.may_decide) == (None, None, True)
    said = "not decided: e = 14.4 after 6 episodes, decided at e ≥ 20; 10 left"
    assert describe(six) == said
    seven = compare_sequentially([TIE, *[WIN] * 7, *[OPEN] * 10])
    assert (seven.better, seven.decided_after, seven.left) == ("run", 8, 10)
    assert describe(seven) == (
        "decided at e ≥ 20 (e = 26.8): on the first 8 of 18 episodes the run succeeds "
        "more often; the 10 left need not be played"
    )
    assert compare_sequentially([LOSS] * 7).better == "baseline"


def test_a_decision_is_not_taken_back() -> None:
    """Later episodes may lower the e-value; the decision was allowed when it fell."""
    found = compare_sequentially([WIN] * 7 + [LOSS] * 7)
    assert (found.better, found.decided_after) == ("run", 7)
    assert found.e_value < 1 < THRESHOLD < found.largest_e_value


@pytest.mark.parametrize(
    ("first", "winner", "since"),
    [(WIN, "run", "0 wins, 50 losses"), (LOSS, "baseline", "50 wins, 0 losses")],
)
def test_after_a_reversal_the_evidence_is_that_of_the_decision(
    first: tuple[bool, bool], winner: str, since: str
) -> None:
    """Seven decide, fifty of the other kind follow, and some are open."""
    other = LOSS if first == WIN else WIN
    text = describe(compare_sequentially([first] * 7 + [other] * 50 + [OPEN] * 3))
    assert text == (
        f"decided at e ≥ 20 (e = 26.8): on the first 7 of 60 episodes the {winner} "
        f"succeeds more often; since then {since}"
    )


BLOCKS = [
    (f"split {split}", f"task {task}")
    for split, number in (("train", 16), ("open", 16), ("test", 32))
    for task in ("lift", "stack") * (number // 2)
]


def test_what_is_left_is_needed_while_a_split_was_not_compared() -> None:
    """Splits stand one after another. Expect one episode of each before it may end."""
    first = compare_sequentially([WIN] * 7 + [OPEN] * 57, BLOCKS)
    assert first.not_compared == ("split open", "split test")
    assert describe(first).endswith(
        "on the first 7 of 64 episodes the run succeeds more often; nothing is "
        "compared yet of split open, split test"
    )
    later = describe(compare_sequentially([WIN] * 32 + [OPEN] * 32, BLOCKS))
    assert later.endswith("nothing is compared yet of split test")
    every = describe(compare_sequentially([WIN] * 33 + [OPEN] * 31, BLOCKS))
    assert every.endswith("the 31 left need not be played")
    many = [(f"task {number}",) for number in range(64)]
    assert describe(compare_sequentially([WIN] * 7 + [OPEN] * 57, many)).endswith(
        "of task 7, task 8, task 9, …"
    )


@pytest.mark.parametrize(
    ("baseline", "run", "most"),
    [((0.4, 0.6, 0.6), (0.4, 0.6, 0.6), ALPHA), ((0.4, 0.6, 0.6), (0.8, 0.6, 0.4), 1)],
    ids=["equal on each episode", "equal in total, splits reversed"],
)
def test_the_error_is_kept_if_both_are_equal_on_each_episode(
    baseline: tuple[float, ...], run: tuple[float, ...], most: float
) -> None:
    """Policies whose success differs by split, watched from 16 to 16 to 32 episodes.
    Equal in total is not the hypothesis: such policies are decided on far more often,
    and before all splits are seen the line never says that the rest is not needed."""
    random = np.random.default_rng(11)
    chances = np.repeat(np.transpose([baseline, run]), (16, 16, 32), axis=0)
    decided = 0
    for _ in range(500):
        drawn = [(bool(b), bool(r)) for b, r in random.random((64, 2)) < chances]
        for n in (16, 32):
            seen = compare_sequentially(drawn[:n] + [OPEN] * (64 - n), BLOCKS)
            assert "need not" not in describe(seen)
        decided += compare_sequentially(drawn, BLOCKS).better is not None
    assert decided / 500 <= most
    assert most == ALPHA or decided / 500 > 0.25


def test_episodes_behind_one_without_result_do_not_count() -> None:
    """Those that end early are no fair sample. Expect the order of the manifest."""
    found = compare_sequentially([WIN, OPEN, *[WIN] * 20])
    assert (found.compared, found.left, found.wins) == (1, 21, 1)


def test_what_is_left_may_be_too_little() -> None:
    found = compare_sequentially([TIE] * 58 + [OPEN] * 6)
    assert not found.may_decide
    assert "the 6 left can no longer show a difference" in describe(found)
    assert compare_sequentially([TIE] * 58 + [OPEN] * 7).may_decide
    whole = compare_sequentially([TIE] * 64)
    assert describe(whole).startswith("all episodes are compared, so that p decides")
    assert compare_sequentially([]).e_value == 1


def test_a_long_comparison_stays_a_number() -> None:
    found = compare_sequentially([WIN] * 5000)
    assert math.isfinite(found.e_value)
    assert found.decided_after == 7


def test_equal_policies_are_called_different_rarely_however_often_one_looks() -> None:
    """The exact probability that 2,000 episodes ever decide: the sum over all paths.
    Expect at most 5 %, and not much less: the test is to use what it is allowed."""
    alive, decided = {0: 1.0}, 0.0  # wins → probability that it is not decided yet
    for n in range(1, 2001):
        after: dict[int, float] = {}
        for wins, chance in alive.items():
            for more in (0, 1):
                after[wins + more] = after.get(wins + more, 0.0) + chance / 2
        crossed = [w for w in after if log_e_value(w, n - w) >= math.log(THRESHOLD)]
        decided += sum(after.pop(wins) for wins in crossed)
        alive = after
    assert 0.02 < decided <= ALPHA
