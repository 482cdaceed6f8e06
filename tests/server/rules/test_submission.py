"""What a submit decides: limits, defaults, keys, and which account sees a run."""

from typing import Any, cast

import pytest

from reference_server.rules.manifest import Manifest
from reference_server.rules.runs.lifecycle import Refuse
from reference_server.rules.submission import (
    GrantedLimits,
    KeyUse,
    SubmissionLimits,
    grant_limits,
    key_conflict,
    may_see_run,
    queue_until,
    select_episodes,
)

LIMITS = SubmissionLimits(4, 60.0)


def submission(**members: Any) -> Any:
    return {"benchmark_id": "calibration", "policy": {"name": "p"}} | members


@pytest.mark.parametrize(
    ("members", "granted"),
    [
        ({}, GrantedLimits(4, 60.0)),
        ({"max_workers": 1}, GrantedLimits(1, 60.0)),
        ({"idle_timeout_s": 5.0}, GrantedLimits(4, 5.0)),
        ({"max_workers": 4, "idle_timeout_s": 60.0}, GrantedLimits(4, 60.0)),
    ],
)
def test_limits_up_to_the_maximum_are_granted(
    members: dict[str, Any], granted: GrantedLimits
) -> None:
    assert grant_limits(submission(**members), LIMITS) == granted


@pytest.mark.parametrize(
    ("members", "pointers"),
    [
        ({"max_workers": 5}, ["/max_workers"]),
        ({"idle_timeout_s": 60.5}, ["/idle_timeout_s"]),
        (
            {"max_workers": 9, "idle_timeout_s": 99.0},
            ["/max_workers", "/idle_timeout_s"],
        ),
    ],
)
def test_larger_limits_are_refused(
    members: dict[str, Any], pointers: list[str]
) -> None:
    refuse = grant_limits(submission(**members), LIMITS)
    assert isinstance(refuse, Refuse)
    assert refuse.code == "invalid_request"
    assert [pointer for pointer, _ in refuse.errors] == pointers


def test_a_used_key_is_for_one_body() -> None:
    use = KeyUse("digest", "run_1")
    assert key_conflict(use, "digest") is None
    refuse = key_conflict(use, "other")
    assert refuse is not None
    assert (refuse.code, refuse.requirement) == ("idempotency_conflict", "RUN-004")


def test_an_account_sees_its_own_runs() -> None:
    assert may_see_run("alice", "alice")
    assert not may_see_run("alice", "bob")


@pytest.mark.parametrize(
    ("stored_wall", "until"), [(1001.5, 1001.5), (999.0, 999.0), (1e11, 1002.0)]
)
def test_a_restart_holds_a_run_no_longer_than_its_submitter(
    stored_wall: float, until: float
) -> None:
    held = submission(options={"queue_s": 2})
    assert queue_until(held, stored_wall, 1000.0) == until


# --- a part of a benchmark ---

EPISODES = [
    {"task": "lift", "split": "train", "seed": 7},
    {"task": "lift", "split": "test", "seed": 8},
    {"task": "push", "split": "train", "seed": 9},
]
MANIFEST = cast(
    Manifest,
    {
        "tasks": ["lift", "push", "stack"],
        "splits": ["train", "test"],
        "episodes": EPISODES,
        "episodes_total": 3,
    },
)


@pytest.mark.parametrize(
    ("select", "seeds"),
    [
        (None, [7, 8, 9]),
        ({}, [7, 8, 9]),
        ({"tasks": ["lift", "push"]}, [7, 8, 9]),
        ({"tasks": ["push", "stack"]}, [9]),
        ({"splits": ["train"]}, [7, 9]),
        ({"tasks": ["lift"], "splits": ["train"]}, [7]),
    ],
)
def test_episodes_are_selected_in_their_order(select: Any, seeds: list[int]) -> None:
    found = select_episodes(MANIFEST, select)
    assert not isinstance(found, Refuse)
    assert [episode["seed"] for episode in found["episodes"]] == seeds
    assert found["episodes_total"] == len(seeds)
    assert (found is MANIFEST) == (len(seeds) == 3)


@pytest.mark.parametrize(
    ("select", "pointers"),
    [
        ({"tasks": ["train"]}, ["/select/tasks"]),
        (
            {"tasks": ["lift", "x"], "splits": ["y", "z"]},
            ["/select/tasks", "/select/splits", "/select/splits"],
        ),
        ({"tasks": ["stack"]}, ["/select"]),
        ({"tasks": ["push"], "splits": ["test"]}, ["/select"]),
    ],
)
def test_cannot_select_what_is_not_there(select: Any, pointers: list[str]) -> None:
    refused = select_episodes(MANIFEST, select)
    assert isinstance(refused, Refuse)
    assert (refused.code, refused.requirement) == ("invalid_request", "SUB-002")
    assert [at for at, _ in refused.errors] == pointers
