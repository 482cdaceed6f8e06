"""Who is served when there is less capacity than runs and sessions. Pure.

Two things are shared: places among the runs that may be played, and simulators. A place
goes to the account that has the fewest, and of its runs to the oldest. An account that
has more than another one that waits gives back what it does not use (LIM-004, LIM-005):
the place of a run that no worker plays, the simulator of a session that plays no turn.
A limit that holds whether others wait or not is a quota (LIM-007, LIM-009, LIM-010).
"""

from __future__ import annotations

import heapq
from collections import Counter
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import NamedTuple

from reference_server.rules.runs.lifecycle import Refuse
from reference_server.rules.runs.run import RunHead, Session

_NAMED_RUNS_MAX = 3
# An account gives back until it has one more than the one that waits: then what is
# taken would only go to and fro.
DIFFERENCE_MIN = 2


@dataclass(frozen=True, slots=True)
class WaitingRun:
    """All that is read of a run in the queue: thousands may wait, none in memory.

    number: 0 for one that is not stored yet. updated_at_wall: of no account in who is
    admitted.
    """

    run_id: str
    number: int
    account: str
    queue_until_wall: float
    updated_at_wall: float = field(default=0.0, compare=False)

    @classmethod
    def of(cls, run: RunHead) -> WaitingRun:
        return cls(
            run.run_id,
            run.number,
            run.account,
            run.queue_until_wall,
            run.updated_at_wall,
        )


class Shares(NamedTuple):
    """admitted: what gets a place, in this order. given_back: an account per place."""

    admitted: list[WaitingRun]
    given_back: list[str]


def share_places(
    waiting: Iterable[WaitingRun],
    places: Mapping[str, int],
    unplayed: Mapping[str, int],
    free: int,
    now_wall: float,
) -> Shares:
    """LIFE-801: which runs get the free places, and those that others give back.

    places: how many each account has; unplayed: how many of them no worker plays.
    LIFE-810: no run gets one before its time. A run without a number is not stored yet:
    it is the youngest.
    """
    queues: dict[str, list[WaitingRun]] = {}
    youngest_first = sorted(waiting, key=_age, reverse=True)
    for run in youngest_first:
        if run.queue_until_wall <= now_wall:
            queues.setdefault(run.account, []).append(run)
    has, may_give = Counter(places), Counter(unplayed)
    shares = Shares([], [])
    heap = [
        (has[account], _age(queue[-1]), account) for account, queue in queues.items()
    ]
    heapq.heapify(heap)
    while heap:
        _, _, account = heap[0]
        if free <= 0:
            giver = _giver(has, may_give, account)
            if giver is None:
                break
            has[giver] -= 1
            may_give[giver] -= 1
            shares.given_back.append(giver)
            free += 1
        heapq.heappop(heap)
        shares.admitted.append(queues[account].pop())
        has[account] += 1
        free -= 1
        if queues[account]:
            heapq.heappush(heap, (has[account], _age(queues[account][-1]), account))
    return shares


def _age(run: WaitingRun) -> tuple[bool, int]:
    return run.number == 0, run.number


def _giver(has: Counter[str], may_give: Counter[str], waiting: str) -> str | None:
    """The account that has the most and gives one of its unplayed places back."""
    givers = [
        account
        for account, unplayed in may_give.items()
        if unplayed > 0 and gives_back(has, account, waiting)
    ]
    return max(givers, key=lambda account: has[account], default=None)


def gives_back(shares: Mapping[str, int], account: str, waiting: str) -> bool:
    """Whether the account has more than its share while another one waits."""
    return shares.get(account, 0) - shares.get(waiting, 0) >= DIFFERENCE_MIN


class LentSimulator(NamedTuple):
    """A session that has a simulator, or is about to, and its account."""

    account: str
    session: Session


def session_to_end(
    lent: Iterable[LentSimulator], waiting: str, now: float, unused_s: float
) -> Session | None:
    """LIM-005: the session that gives its simulator back to an account that waits.

    Among the accounts that have more than their share it is the session that has gone
    longest without a turn, and for more than `unused_s`; None if there is none. A
    heartbeat does not count as a turn.
    """
    lent = list(lent)
    simulators = Counter(account for account, _ in lent)
    unused = (
        session
        for account, session in lent
        if gives_back(simulators, account, waiting)
        and _is_unused(session, now, unused_s)
    )
    return min(unused, key=lambda session: session.answered_at, default=None)


def _is_unused(session: Session, now: float, unused_s: float) -> bool:
    return not session.busy and now - session.answered_at > unused_s


def held_unused(
    held: Iterable[tuple[str, Session]], now: float, unused_s: float
) -> str:
    """How many simulators an account holds without a use, and in which runs.

    held: its sessions that have one, and their runs. Empty if it uses them all.
    """
    runs = [run_id for run_id, one in held if _is_unused(one, now, unused_s)]
    if not runs:
        return ""
    names = list(dict.fromkeys(runs))
    text = ", ".join(names[:_NAMED_RUNS_MAX])
    if len(names) > _NAMED_RUNS_MAX:
        text += f" and {len(names) - _NAMED_RUNS_MAX} more"
    return (
        f", {len(runs)} of them by sessions of this account without a turn for "
        f"{unused_s:g} s, of the runs: {text}. Each is free when the lease of its "
        "session ends, or its run is stopped"
    )


class Quota(NamedTuple):
    """Numbers that one account has, or may have at most."""

    open_runs: int = 10_000
    keys: int = 1_000_000
    stored_bytes: int = 2**34


def below_quota(open_runs: int, open_runs_max: int) -> Refuse | None:
    """LIM-007: one more run of an account may be open."""
    if open_runs < open_runs_max:
        return None
    text = f"The account has {open_runs} open runs, which is its maximum."
    act = "Wait until a run ends, or stop one."
    return Refuse("quota_exceeded", text, "LIM-007", act=act)


def below_storage_quota(has: Quota, most: Quota, *, has_key: bool) -> Refuse | None:
    """One more run or leaf of an account may be stored; a run may have a key."""
    if has_key and has.keys >= most.keys:  # LIM-009
        text = (
            f"The account has used {has.keys} Idempotency-Keys, which is its maximum."
        )
        act = "Waiting does not help. Submit without an Idempotency-Key, or ask the "
        act += "operator."
        more = {"limit": "keys"}
        return Refuse("quota_exceeded", text, "LIM-009", members=more, act=act)
    if has.stored_bytes >= most.stored_bytes:  # LIM-010
        text = (
            f"The runs of the account, with what is kept of its entries, take "
            f"{has.stored_bytes} bytes, and may take {most.stored_bytes}."
        )
        act = "Waiting does not help. Delete runs, or ask the operator."
        more = {"limit": "stored_bytes"}
        return Refuse("quota_exceeded", text, "LIM-010", members=more, act=act)
    return None
