"""What a node knows of runs that other nodes have, or offer."""

from __future__ import annotations

import pytest

from reference_server.rules.capacity import WaitingRun
from reference_server.runs.memory.remote_runs import (
    MovedRuns,
    OfferedRuns,
    has_newer_owner,
)
from reference_server.storage.node_store import OwnedRun
from tests.support.server.runs import make_run


def test_only_an_offered_run_has_to_be_taken() -> None:
    offered = OfferedRuns()
    offered.offer(["offered", "loaded", "later"])
    offered.note_here("loaded")
    for run_id in ("offered", "loaded", "of this node"):
        offered.want(run_id)
    taken = ["offered", "offered", "loaded", "of this node"]
    begun = [offered.begin_to_take(run_id) for run_id in taken]
    assert begun == [True, False, False, False]
    offered.offer(["another"])
    offered.want("later")
    assert not offered.begin_to_take("later")


def test_a_node_without_a_lease_may_take_nothing() -> None:
    offered = OfferedRuns()
    offered.offer(["wanted", "offered"])
    offered.want("wanted")
    offered.forget_offers()
    offered.want("offered")
    assert not offered.begin_to_take("wanted")
    assert not offered.begin_to_take("offered")


def test_a_run_that_moved_is_complete_if_all_of_it_was_stored() -> None:
    moved = MovedRuns()
    here, lost, complete = make_run(), make_run(), make_run()
    moved.note(lost, is_complete=False)
    moved.note(complete, is_complete=True)
    runs = (here, lost, complete)
    assert [moved.has(run) for run in runs] == [False, True, True]
    assert [moved.is_complete(run) for run in runs] == [False, False, True]


def test_a_change_of_the_queue_is_announced_once() -> None:
    offered = OfferedRuns()
    assert not offered.begin_to_announce()
    offered.note_queue_change()
    offered.note_queue_change()
    assert [offered.begin_to_announce() for _ in range(2)] == [True, False]


@pytest.mark.parametrize(
    ("owner", "fence", "is_newer"),
    [("other", 3, True), ("other", 2, False), ("other", 1, False), ("me", 3, False)],
)
def test_what_was_read_before_a_claim_says_nothing(
    owner: str, fence: int, is_newer: bool
) -> None:
    run = make_run(owner="me", fence=2)
    seen = OwnedRun(WaitingRun("run_1", 1, "alice", 0.0), owner, fence)
    assert has_newer_owner(run, seen) is is_newer
