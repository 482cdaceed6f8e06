"""What a node knows of runs that other nodes have, or offer."""

from __future__ import annotations

import pytest

from reference_server.rules.capacity import WaitingRun
from reference_server.runs.memory.runs_elsewhere import RunsElsewhere, has_newer_owner
from reference_server.storage.node_store import OwnedRun
from tests.support.server.runs import make_run


def test_only_an_offered_run_has_to_be_taken() -> None:
    elsewhere = RunsElsewhere()
    elsewhere.offer(["offered", "loaded", "later"])
    elsewhere.note_here("loaded")
    for run_id in ("offered", "loaded", "of this node"):
        elsewhere.want(run_id)
    taken = ["offered", "offered", "loaded", "of this node"]
    begun = [elsewhere.begin_to_take(run_id) for run_id in taken]
    assert begun == [True, False, False, False]
    elsewhere.offer(["another"])
    elsewhere.want("later")
    assert not elsewhere.begin_to_take("later")


def test_a_node_without_a_lease_may_take_nothing() -> None:
    elsewhere = RunsElsewhere()
    elsewhere.offer(["wanted", "offered"])
    elsewhere.want("wanted")
    elsewhere.forget_offers()
    elsewhere.want("offered")
    assert not elsewhere.begin_to_take("wanted")
    assert not elsewhere.begin_to_take("offered")


def test_a_lost_run_is_complete_if_all_of_it_was_stored() -> None:
    elsewhere = RunsElsewhere()
    here, lost, complete = make_run(), make_run(), make_run()
    elsewhere.note_lost(lost)
    elsewhere.note_lost(complete, is_complete=True)
    runs = (here, lost, complete)
    assert [elsewhere.is_lost(run) for run in runs] == [False, True, True]
    assert [elsewhere.is_complete(run) for run in runs] == [False, False, True]


def test_a_change_of_the_queue_is_announced_once() -> None:
    elsewhere = RunsElsewhere()
    assert not elsewhere.begin_to_announce()
    elsewhere.note_queue_change()
    elsewhere.note_queue_change()
    assert [elsewhere.begin_to_announce() for _ in range(2)] == [True, False]


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
