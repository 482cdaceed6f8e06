"""The ranking: the vectors, its laws, exact tests, and how long a large one takes."""

import json
import time
from random import Random
from typing import Any

import jsonschema_rs
import pytest
from hypothesis import given
from hypothesis import strategies as st

from conformance.oracle.expected_ranking import RankedRun, expected_ranking
from reference_record.comparison.difference_evidence import sign_test
from reference_server.rules.board import ranking
from reference_server.rules.board.ranking import (
    ALPHA,
    Contender,
    mcnemar_p,
    rank,
)
from tests.support.paths import SPEC
from tests.support.ranking_vectors import CASES, successes_in_order

EPISODES = 12


def shown(found: ranking.Ranking) -> dict[str, Any]:
    """As the vectors have it."""
    head = ("ranked", "comparisons", "differing_min", "differing_enough")
    rows = [
        {
            "entry_id": row.entry_id,
            "rank": row.rank and {"low": row.rank[0], "high": row.rank[1]},
            "better": row.better,
            "worse": row.worse,
            "letters": list(row.letters),
        }
        for row in found.rows
    ]
    return {name: getattr(found, name) for name in head} | {"rows": rows}


def contenders_of(case: dict[str, Any]) -> list[Contender]:
    contenders = []
    for number, entry in enumerate(case["entries"], start=1):
        successes = successes_in_order(case["manifest"], entry)
        bits = None if successes is None else int(successes[::-1], 2)
        contenders.append(Contender(entry["entry_id"], number, entry["score"], bits))
    return contenders


@pytest.mark.parametrize("case", CASES, ids=lambda case: case["description"])
def test_the_vectors(case: dict[str, Any]) -> None:
    contenders = contenders_of(case)
    found = rank(contenders, len(case["manifest"]) if contenders else 0)
    assert shown(found) == case["ranking"]


def test_the_vectors_fit_their_schema() -> None:
    schema = json.loads((SPEC / "schema" / "ranking-vector.json").read_text())
    jsonschema_rs.meta.validate(schema)
    for path in (SPEC / "vectors" / "ranking").iterdir():
        jsonschema_rs.validate(schema, json.loads(path.read_text()))
    assert len(CASES) > 20


entries = st.lists(
    st.tuples(st.sampled_from([0.0, 0.25, 0.5, 1.0]), st.integers(0, 2**EPISODES - 1)),
    max_size=14,
)


@given(entries)
def test_the_oracle_says_the_same_of_any_entries(drawn: list[Any]) -> None:
    contenders = [Contender(f"e{i}", i, *one) for i, one in enumerate(drawn)]
    runs = [
        RankedRun(f"e{i}", score, f"{bits:0{EPISODES}b}"[::-1])
        for i, (score, bits) in enumerate(drawn)
    ]
    assert shown(rank(contenders, EPISODES)) == expected_ranking(runs, EPISODES)


def distinguished_one_by_one(successes: list[int]) -> tuple[list[int], list[int]]:
    """As the rule says it: every p, the smallest first."""
    found = []
    for i, one in enumerate(successes):
        for j, other in enumerate(successes[:i]):
            won, lost = (one & ~other).bit_count(), (other & ~one).bit_count()
            p = mcnemar_p(min(won, lost), won + lost)
            found.append((p, i, j) if won > lost else (p, j, i))
    better, worse = [0] * len(successes), [0] * len(successes)
    for place, (p, winner, loser) in enumerate(sorted(found)):
        if p * (len(found) - place) > ALPHA:
            break
        better[loser] |= 1 << winner
        worse[winner] |= 1 << loser
    return better, worse


@pytest.mark.slow("ranks for seconds")
@given(st.randoms(use_true_random=False), st.integers(2, 40), st.integers(1, 300))
def test_pairs_that_share_a_p_are_distinguished_as_if_each_had_its_own(
    random: Random, count: int, episodes: int
) -> None:
    """What is known of one pair is used for others that differ as much."""
    low, high = sorted((random.random(), random.random()))
    rates = [random.uniform(low, high) for _ in range(count)]
    drawn = [sum((random.random() < r) << k for k in range(episodes)) for r in rates]
    assert ranking._distinguish(drawn) == distinguished_one_by_one(drawn)


def test_the_test_has_twelve_right_digits() -> None:
    for n in (0, 1, 2, 5, 6, 30, 199, 1000, 2500):
        for fewer in {0, 1, n // 3, n // 2} & set(range(n // 2 + 1)):
            exact = sign_test(fewer, n - fewer)
            # A double has no number for 2^-2500; both say 0 there.
            assert mcnemar_p(fewer, n) == pytest.approx(exact, rel=1e-11, abs=1e-300)


def test_fewer_episodes_than_the_least_are_never_distinguished() -> None:
    """The resolution is what it says: 5 differing episodes never do, 20 always."""
    for differing, is_apart in ((5, False), (6, True)):
        pair = [Contender("a", 1, 1.0, 2**differing - 1), Contender("b", 2, 0.0, 0)]
        found = rank(pair, 1000)
        assert (found.rows[0].worse == 1) is is_apart
    equal = [Contender(f"e{i}", i, 0.0, 0) for i in range(199)]
    for differing in (19, 20):
        best = Contender("best", 200, 1.0, 2**differing - 1)
        found = rank([*equal, best], 1000)
        assert found.differing_enough == 20
        # All 199 pairs with the best have one p: the first of them decides.
        assert (found.rows[0].worse == 199) is (differing == 20)


def test_a_long_leaderboard_takes_no_time() -> None:
    """Far fewer p are computed than it has pairs: they took most of the time."""
    random, entries = Random(3), []
    for number in range(200):
        rate = 0.05 + 0.9 * number / 200
        bits = sum((random.random() < rate) << k for k in range(1000))
        entries.append(Contender(f"e{number}", number, bits.bit_count() / 1000, bits))
    mcnemar_p.cache_clear()
    start = time.process_time()
    found = rank(entries, 1000)
    assert time.process_time() - start < 2.0
    assert found.comparisons == 19_900
    assert mcnemar_p.cache_info().misses < found.comparisons / 3
    assert found.rows[0].rank == (1, 200 - found.rows[0].worse)


def test_letters_beyond_z() -> None:
    names = [ranking._letter(place) for place in (0, 25, 26, 51, 52, 701, 702)]
    assert names == ["a", "z", "aa", "az", "ba", "zz", "aaa"]
    assert ALPHA == 0.05
