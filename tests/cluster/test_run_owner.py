"""Where a request for a run of a cluster is carried out."""

import pytest

from reference_server.rules.run_owner import (
    Place,
    StoredOwner,
    lease_is_over,
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
