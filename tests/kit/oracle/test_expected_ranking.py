"""The kit's own idea of a ranking: the vectors, which any implementation can run."""

from typing import Any

import pytest

from conformance.oracle.expected_ranking import RankedRun, expected_ranking
from tests.support.ranking_vectors import CASES, successes_in_order


@pytest.mark.parametrize("case", CASES, ids=lambda case: case["description"])
def test_the_kit_agrees_with_the_vectors(case: dict[str, Any]) -> None:
    runs = [
        RankedRun(
            entry["entry_id"],
            entry["score"],
            successes_in_order(case["manifest"], entry),
        )
        for entry in case["entries"]
    ]
    found = expected_ranking(runs, len(case["manifest"]) if runs else 0)
    assert found == case["ranking"]
