"""Where a request for a run of a cluster is carried out."""

import pytest

from reference_server.rules.run_owner import (
    Place,
    StoredOwner,
    is_dead,
    lease_is_over,
    looks_silent,
    place_of,
)

LEASE_S = 5.0


@pytest.mark.parametrize(
    ("silent_s", "is_over"), [(None, True), (0.0, False), (5.0, False), (5.1, True)]
)
def test_a_lease_is_over_when_it_was_not_renewed(
    silent_s: float | None, is_over: bool
) -> None:
    assert lease_is_over(silent_s, LEASE_S) == is_over


@pytest.mark.parametrize(
    ("owner", "only_reads", "place"),
    [
        (StoredOwner("me", 1, "running", 9.0), False, "here"),
        (StoredOwner("other", 1, "running", 1.0), True, "forward"),
        (StoredOwner("other", 1, "running", 9.0), True, "claim"),
        (StoredOwner("gone", 1, "ready", None), False, "claim"),
        (StoredOwner(None, 0, "queued", None), True, "claim"),
        # What nothing changes any more is shown by every node, and deleted by its own.
        (StoredOwner("other", 1, "completed", 1.0), True, "here"),
        (StoredOwner(None, 0, "completed", None), True, "here"),
        (StoredOwner("other", 1, "completed", 1.0), False, "forward"),
        (StoredOwner("other", 1, "stopped", 1.0), True, "forward"),
    ],
)
def test_the_owner_answers_while_it_lives(
    owner: StoredOwner, only_reads: bool, place: Place
) -> None:
    assert place_of(owner, "me", LEASE_S, only_reads=only_reads) == place


@pytest.mark.parametrize(
    ("silent_s", "seen_silent_for_s", "is_removed"),
    [
        (5.1, 2.5, True),
        (5.1, 2.4, False),  # its next renewal may be under way
        (5.0, 4.0, False),
        (3600.0, 0.0, False),  # of a clock that jumped, or a database that was away
    ],
)
def test_a_node_is_removed_when_it_was_seen_silent_before(
    silent_s: float, seen_silent_for_s: float, *, is_removed: bool
) -> None:
    assert is_dead(silent_s, seen_silent_for_s, LEASE_S) == is_removed


@pytest.mark.parametrize(("silent_s", "is_late"), [(1.5, False), (1.6, True)])
def test_a_node_looks_silent_before_its_lease_is_over(
    silent_s: float, *, is_late: bool
) -> None:
    assert looks_silent(silent_s, LEASE_S) == is_late
