"""Episodes as they are shown: every form of them obeys the specification's schema."""

from __future__ import annotations

from dataclasses import replace
from datetime import UTC, datetime
from itertools import combinations
from typing import Any

import pytest

from reference_server.rules.run import Episode, Result
from reference_server.views.run_views import episode_view, result_view, timestamp
from tests.support.repository.answer_schemas import check_answer

REQUIRED = Result("success", 0.5, 2, 7, True, False, 0.25, 1.7e9)
ALL_OF_IT: dict[str, Any] = {
    "player": {"name": "n", "version": "1", "client": "c"},
    "clipped_actions": 3,
    "total_reward": -1.5,
}


def results() -> list[Result]:
    """With and without each member that a result may have."""
    chosen = [
        dict(some)
        for count in range(len(ALL_OF_IT) + 1)
        for some in combinations(ALL_OF_IT.items(), count)
    ]
    return [replace(REQUIRED, **members) for members in chosen]


@pytest.mark.parametrize("is_sealed", [False, True])
@pytest.mark.parametrize("result", results())
def test_a_result_is_what_its_schema_says(result: Result, is_sealed: bool) -> None:
    episode = Episode(4, "lift", "test", 9, result=result, is_sealed=is_sealed)
    shown = result_view(episode)
    check_answer("EpisodeResult", shown)
    assert ("seed" in shown) is not is_sealed
    names = [name for name in ALL_OF_IT if getattr(result, name) is not None]
    assert [name for name in ALL_OF_IT if name in shown] == names
    assert episode_view(episode)["result"] == shown


@pytest.mark.parametrize(
    ("members", "status"),
    [
        ({}, "pending"),
        ({"in_progress": True, "policy_fault": "it closed"}, "in_progress"),
        ({"result": REQUIRED, "attempt": 2, "faults": 1}, "scored"),
    ],
)
def test_an_episode_is_what_its_schema_says(
    members: dict[str, Any], status: str
) -> None:
    shown = episode_view(Episode(4, "lift", "test", 9, **members))
    check_answer("Episode", shown)
    assert shown["status"] == status
    assert shown.get("policy_fault") == members.get("policy_fault")


@pytest.mark.parametrize("at_wall", [0.0, 951_827_696.789, 1.7e9, 1_798_761_599.999])
def test_times_are_rfc_3339_to_the_millisecond(at_wall: float) -> None:
    """A leap day, and the last second of a year, among others."""
    expected = datetime.fromtimestamp(int(at_wall * 1000) / 1000, UTC)
    text = timestamp(at_wall)
    assert datetime.fromisoformat(text) == expected
    assert len(text) == len("2026-11-23T09:00:00.000Z")
