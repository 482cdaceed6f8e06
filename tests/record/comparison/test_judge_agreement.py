"""The sample of a second judge, Cohen's kappa, and what is said of few attempts."""

import pytest

from reference_record.comparison.judge_agreement import (
    Agreement,
    agreement_document,
    agreement_text,
    second_sample,
)

YES, NO = True, False
PAIRS = [(YES, YES), (YES, NO), (NO, YES), (NO, NO)]


def pairs(*counts: int) -> list[tuple[bool, bool]]:
    return [pair for pair, n in zip(PAIRS, counts, strict=True) for _ in range(n)]


@pytest.mark.parametrize(
    ("counts", "kappa", "others"),
    [
        ((20, 5, 10, 15), 0.4, (0.3548, 0.4444)),  # of many textbooks
        ((45, 15, 25, 15), 0.1304, (0.1009, 0.1570)),
        ((25, 35, 5, 35), 0.2593, (0.2351, 0.2817)),
        ((2, 0, 0, 2), 1.0, (0.5, 0.5)),
        ((0, 2, 2, 0), -1.0, (-0.5, -0.5)),
        ((3, 0, 0, 0), None, (0.0, 0.0)),
        ((1, 0, 0, 0), None, (0.0, 0.0)),
        ((0, 0, 0, 0), None, None),
    ],
)
def test_kappa_is_cohens(
    counts: tuple[int, ...], kappa: float | None, others: tuple[float, float] | None
) -> None:
    agreement = Agreement.of(pairs(*counts))
    assert agreement.kappa == (kappa and pytest.approx(kappa, abs=5e-5))
    assert agreement.kappa_range == (others and pytest.approx(others, abs=5e-3))
    assert (agreement.n, agreement.agreed) == (sum(counts), counts[0] + counts[3])


@pytest.mark.parametrize(
    ("drawn", "counts", "parts"),
    [
        (2, (0, 0, 0, 0), ["none of 2 drawn has a second judgement yet"]),
        (5, (3, 0, 0, 0), ["agreed on 3 of 3; 2 of 5 drawn wait", "is not defined"]),
        (
            4,
            (2, 0, 0, 2),
            ["kappa 1.00, n = 4: too few", "other way would make it 0.50."],
        ),
        (29, (9, 5, 5, 10), ["n = 29: too few", "would make it 0.24 to 0.38."]),
        (50, (20, 5, 10, 15), ["agreed on 35 of 50. Cohen's kappa 0.40, n = 50."]),
    ],
)
def test_the_text_says_what_few_attempts_cannot_show(
    drawn: int, counts: tuple[int, ...], parts: list[str]
) -> None:
    text = agreement_text(agreement_document(drawn, ["judge_a"], pairs(*counts)))
    for part in parts:
        assert part in text


@pytest.mark.parametrize(
    ("share", "episodes", "drawn"),
    [(0.0, 10, 0), (0.01, 10, 1), (0.25, 10, 3), (0.07, 100, 7), (1.0, 4, 4)],
)
def test_samples_are_shares_rounded_up(share: float, episodes: int, drawn: int) -> None:
    names = [f"e{index:04d}" for index in range(episodes)]
    physical = {"order_seed": 7, "second_judge_share": share}
    assert len(second_sample(physical, "run_1", names)) == drawn


def test_each_run_has_a_sample_of_its_own() -> None:
    names = [f"e{index:04d}" for index in range(20)]
    physical = {"order_seed": 7, "second_judge_share": 0.2}
    samples = {second_sample(physical, f"run_{n}", names) for n in range(20)}
    assert len(samples) > 10
    assert set().union(*samples) == set(names)
    assert second_sample({"order_seed": 7}, "run_1", names) == frozenset()
