"""Who gets a place or a simulator, and who gives one back."""

from __future__ import annotations

import re
from collections.abc import Mapping

import pytest

from reference_server.rules.capacity import (
    LentSimulator,
    Quota,
    WaitingRun,
    below_quota,
    below_storage_quota,
    held_unused,
    session_to_end,
    share_places,
)
from reference_server.rules.runs.run import Session
from tests.support.server.runs import NOW, make_run

WALL = 5000.0


def waiting_runs(*numbers: int, account: str = "alice") -> list[WaitingRun]:
    return [WaitingRun(f"{account}_{n}", n, account, 0.0) for n in numbers]


def shared(
    waiting: list[WaitingRun],
    places: Mapping[str, int],
    free: int,
    unplayed: Mapping[str, int] | None = None,
) -> tuple[list[str], list[str]]:
    shares = share_places(waiting, places, unplayed or {}, free, WALL)
    return [run.run_id for run in shares.admitted], shares.given_back


# --- places ---


def test_the_oldest_are_admitted_first_while_there_is_room() -> None:
    runs = waiting_runs(3, 4, 2)
    runs.append(WaitingRun("early", 1, "alice", WALL + 1))
    assert shared(runs, {"alice": 1}, 2) == (["alice_2", "alice_3"], [])
    assert shared(runs, {"alice": 3}, 0) == ([], [])
    assert shared(runs[3:], {}, 1) == ([], [])
    late = share_places(runs[3:], {}, {}, 1, WALL + 1)
    assert late.admitted == runs[3:]


def test_a_run_without_a_number_is_admitted_last() -> None:
    runs = waiting_runs(0, 2, 1)
    assert shared(runs, {}, 2) == (["alice_1", "alice_2"], [])


def test_the_account_with_the_fewest_places_is_next() -> None:
    runs = waiting_runs(1, 2, 3) + waiting_runs(8, 9, account="bob")
    assert shared(runs, {"alice": 1}, 3)[0] == ["bob_8", "alice_1", "bob_9"]
    assert shared(runs, {"alice": 9, "bob": 9}, 1)[0] == ["alice_1"]


def test_an_account_gives_unplayed_places_back_until_both_have_their_share() -> None:
    runs = waiting_runs(*range(10, 20), account="bob")
    places, unplayed = {"alice": 6}, {"alice": 6}
    assert shared(runs, places, 0, unplayed) == (
        ["bob_10", "bob_11", "bob_12"],
        ["alice"] * 3,
    )
    assert shared(runs, places, 0, {"alice": 1}) == (["bob_10"], ["alice"])
    assert shared(runs, places, 0, {"bob": 1}) == ([], [])
    assert shared(runs, {"alice": 2, "bob": 1}, 0, {"alice": 2}) == ([], [])


def test_the_account_with_the_most_gives_first() -> None:
    places = {"alice": 4, "carol": 6}
    given = shared(waiting_runs(9, account="bob"), places, 0, places)[1]
    assert given == ["carol"]


def test_an_account_gives_nothing_back_to_itself() -> None:
    assert shared(waiting_runs(9), {"alice": 5}, 0, {"alice": 5}) == ([], [])


def test_what_admission_keeps_of_a_run() -> None:
    run = make_run(number=7, queue_until_wall=3.0)
    assert WaitingRun.of(run) == WaitingRun("run_1", 7, "alice", 3.0)


# --- simulators ---


def sessions(account: str, *answered_ago: float) -> list[LentSimulator]:
    found = []
    for ago in answered_ago:
        session = Session(f"{account}-{ago}", "w", "k", 10.0, 10, NOW + 10)
        session.answered_at = NOW - ago
        found.append(LentSimulator(account, session))
    return found


def ended(lent: list[LentSimulator], waiting: str = "bob") -> str | None:
    session = session_to_end(lent, waiting, NOW, 60.0)
    return None if session is None else session.session_id


def test_the_session_that_is_longest_without_a_turn_is_ended() -> None:
    assert ended(sessions("alice", 61, 90, 5)) == "alice-90"


@pytest.mark.parametrize(
    "lent",
    [
        [],
        sessions("alice", 60, 5),
        sessions("alice", 61),
        sessions("alice", 61, 62) + sessions("bob", 61),
        sessions("bob", 61, 62, 63),
    ],
    ids=["none", "used", "only one", "one more", "its own"],
)
def test_no_session_is_ended_within_its_share(lent: list[LentSimulator]) -> None:
    assert ended(lent) is None


@pytest.mark.parametrize(
    ("unused", "named"),
    [
        ((), ""),
        ((61,), ", 1 of them by sessions of this account without a turn for 60 s, of "),
        ((61, 62, 63, 64), "of the runs: run_61, run_62, run_63 and 1 more. "),
    ],
)
def test_the_runs_are_named_whose_simulators_an_account_does_not_use(
    unused: tuple[int, ...], named: str
) -> None:
    held = [(f"run_{s.session_id[6:]}", s) for _, s in sessions("alice", *unused, 5)]
    text = held_unused(held, NOW, 60.0)
    assert (named in text, "run_5" in text, bool(text)) == (True, False, bool(unused))


def test_no_session_is_ended_in_its_turn() -> None:
    lent = sessions("alice", 61, 90)
    lent[1].session.busy = "playing"
    assert ended(lent) == "alice-61"


# --- quotas ---


def test_a_quota_is_the_most_that_is_open() -> None:
    assert below_quota(2, 3) is None
    refused = below_quota(3, 3)
    assert refused is not None
    assert (refused.code, refused.requirement) == ("quota_exceeded", "LIM-007")
    assert (refused.act, refused.members) == ("Wait until a run ends, or stop one.", {})


@pytest.mark.parametrize(
    ("has", "has_key", "rule", "limit", "act"),
    [
        (Quota(keys=2, stored_bytes=8), True, None, None, ""),
        (Quota(keys=3, stored_bytes=8), False, None, None, ""),
        (Quota(keys=3, stored_bytes=8), True, "LIM-009", "keys", "Idempotency-Key"),
        (Quota(keys=2, stored_bytes=9), False, "LIM-010", "stored_bytes", "Delete"),
    ],
)
def test_a_quota_is_the_most_that_is_stored(
    has: Quota, has_key: bool, rule: str | None, limit: str | None, act: str
) -> None:
    """The advice is that of its limit, and says that waiting does not help."""
    refused = below_storage_quota(has, Quota(keys=3, stored_bytes=9), has_key=has_key)
    assert (refused and refused.requirement) == rule
    if refused is not None:
        assert (refused.code, refused.members["limit"]) == ("quota_exceeded", limit)
        assert refused.act is not None
        assert re.search(f"^Waiting does not help. .*{act}", refused.act)
