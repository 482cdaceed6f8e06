"""Places of runs: who keeps one, and when another run gets it. No clock, no run."""

from __future__ import annotations

from reference_server.rules.capacity import WaitingRun
from reference_server.runs.admission.places import Places

NOW, WALL, UNUSED_S = 1000.0, 5000.0, 60.0


def places_of(size: int) -> Places:
    return Places(size, UNUSED_S)


def queue(places: Places, number: int, account: str = "alice", until: float = 0) -> str:
    run = WaitingRun(f"{account}_{number}", number, account, until)
    places.wait(run)
    return run.run_id


def share(places: Places, now: float = NOW) -> list[str]:
    if not places.can_change(now):
        return []
    return [run.run_id for run in places.share(now, WALL)]


def test_places_go_to_what_waits_until_they_are_taken() -> None:
    places = places_of(2)
    assert not places.can_change(NOW)
    for number in (1, 2, 3):
        queue(places, number)
    assert share(places) == ["alice_1", "alice_2"]
    assert "alice_1" in places
    assert "alice_3" not in places
    assert share(places) == []
    places.leave("alice_1")
    assert share(places) == ["alice_3"]


def test_a_look_that_comes_too_early_comes_again() -> None:
    """A timer fires a moment before the queue time is over. Expect another one."""
    places = places_of(1)
    queue(places, 1, until=WALL + 2)
    assert places.share(NOW, WALL) == []
    early = NOW + 1.9995
    assert not places.can_change(early)
    left_s = places.next_look(early)
    assert left_s is not None
    assert 0 < left_s < 0.001
    assert [run.number for run in places.share(NOW + 2, WALL + 2)] == [1]
    assert places.next_look(NOW + 2) is None


def test_an_unplayed_run_loses_its_place_after_a_time_if_one_waits() -> None:
    places = places_of(2)
    for number in (1, 2):
        queue(places, number)
    share(places)
    assert places.next_overdue(NOW) is None
    assert share(places, NOW + 10 * UNUSED_S) == []
    assert "alice_1" in places
    queue(places, 3)
    assert places.next_overdue(NOW + 1) == UNUSED_S - 1
    assert share(places, NOW + UNUSED_S - 1) == []
    assert share(places, NOW + UNUSED_S) == ["alice_3"]
    assert "alice_1" not in places
    assert "alice_2" in places


def test_a_played_run_keeps_its_place() -> None:
    places = places_of(1)
    queue(places, 1)
    share(places)
    places.play("alice_1", "alice")
    queue(places, 2)
    assert places.next_overdue(NOW) is None
    assert share(places, NOW + 10 * UNUSED_S) == []
    places.rest("alice_1", NOW + 5)
    assert share(places, NOW + UNUSED_S) == []
    assert share(places, NOW + UNUSED_S + 5) == ["alice_2"]


def test_another_account_gets_its_share_at_once() -> None:
    places = places_of(4)
    for number in range(1, 5):
        queue(places, number)
    share(places)
    places.play("alice_1", "alice")
    queue(places, 5)
    for number in (6, 7, 8):
        queue(places, number, "bob")
    assert share(places) == ["bob_6", "bob_7"]
    assert [f"alice_{n}" in places for n in (1, 2, 3, 4)] == [True, False, False, True]


def test_what_cannot_move_costs_nothing() -> None:
    places = places_of(1)
    places.play("alice_1", "alice")
    for number in range(2, 50):
        queue(places, number)
    assert not places.can_change(NOW)
    places.rest("alice_1", NOW)
    assert not places.can_change(NOW)
    assert places.can_change(NOW, WaitingRun("bob_1", 0, "bob", 0.0)) is False
    assert places.can_change(NOW + UNUSED_S)


def test_a_queue_time_is_waited_for() -> None:
    places = places_of(1)
    queue(places, 1, until=WALL + 7)
    assert share(places) == []
    assert places.next_due(WALL) == 7
    assert not places.can_change(NOW + 6.9)
    assert places.can_change(NOW + 7)
    places.stop_waiting("alice_1")
    assert places.next_due(WALL) is None


def test_an_overdue_place_is_not_looked_at_again_while_none_is_due() -> None:
    places = places_of(1)
    queue(places, 1)
    share(places)
    queue(places, 2, until=WALL + 2 * UNUSED_S)
    assert places.next_overdue(NOW) == UNUSED_S
    late = NOW + UNUSED_S + 1
    assert share(places, late) == []
    assert places.next_overdue(late) is None
    assert not places.can_change(late + 1)
    assert "alice_1" in places


def test_a_place_without_a_run_is_given_back_once() -> None:
    places = places_of(1)
    places.leave("unknown")
    places.rest("unknown", NOW)
    assert "unknown" not in places
    queue(places, 1)
    assert share(places) == ["alice_1"]


def elsewhere(*runs: tuple[int, str]) -> list[WaitingRun]:
    """Runs of other nodes that wait."""
    return [WaitingRun(f"{account}_{n}", n, account, 0) for n, account in runs]


def test_what_waits_at_other_nodes_gets_a_place_in_its_turn() -> None:
    places = places_of(2)
    queue(places, 2)
    places.note_elsewhere(elsewhere((1, "alice"), (3, "alice")), {})
    assert [run.run_id for run in places.waiting_here()] == ["alice_2"]
    assert share(places) == ["alice_1", "alice_2"]
    assert places.counts() == {"alice": 2}
    places.leave("alice_1")
    assert share(places) == ["alice_3"]


def test_what_waits_elsewhere_no_more_gets_no_place() -> None:
    places = places_of(1)
    places.note_elsewhere(elsewhere((1, "alice"), (2, "bob")), {})
    places.note_elsewhere(elsewhere((2, "bob")), {})
    assert share(places) == ["bob_2"]
    # It has a place already: another node said late that it waits.
    places.note_elsewhere(elsewhere((2, "bob")), {})
    places.leave("bob_2")
    assert share(places) == []


def test_a_run_that_came_from_another_node_waits_here() -> None:
    """What is said of other nodes later does not remove it."""
    places = places_of(1)
    queue(places, 1)
    share(places)
    places.note_elsewhere(elsewhere((2, "alice")), {})
    queue(places, 2)
    places.note_elsewhere(elsewhere((2, "alice")), {})
    places.note_elsewhere([], {})
    assert [run.run_id for run in places.waiting_here()] == ["alice_2"]


def test_places_at_other_nodes_count_for_who_is_next() -> None:
    places = places_of(1)
    queue(places, 1, "alice")
    queue(places, 2, "bob")
    places.note_elsewhere([], {"alice": 1})
    assert share(places) == ["bob_2"]
    places.leave("bob_2")
    places.note_elsewhere([], {})
    assert share(places) == ["alice_1"]


def test_an_account_with_places_at_other_nodes_gives_one_back() -> None:
    places = places_of(1)
    queue(places, 1, "alice")
    share(places)
    queue(places, 2, "bob")
    assert share(places) == []
    places.note_elsewhere([], {"alice": 1})
    assert share(places) == ["bob_2"]
