"""Which runs hold a place among those that may be played, and which wait for one.

It holds ids, not runs: thousands may wait, and a run that is not played need not be in
memory. Who gets a place is decided in `rules/capacity.py`. A run without a worker keeps
its place while no other run waits; when one does, it gives it back after `unused_s`, or
at once if its account has more than its share. It stays `ready` and gets a place again
when a worker attaches.

In a cluster these are the places of one node. It knows what waits at other nodes, which
it may take, and how many places each account has there.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterable, Mapping

from reference_server.rules.capacity import WaitingRun, gives_back, share_places


class Places:
    """`size` places; monotonic times, but for those of WaitingRun."""

    def __init__(self, size: int, unused_s: float) -> None:
        self._size, self._unused_s = size, unused_s
        self._account_of: dict[str, str] = {}  # of each run that has a place
        self._places: Counter[str] = Counter()
        self._unplayed: dict[str, float] = {}  # since when; the longest first
        self._unplayed_of: Counter[str] = Counter()
        self._waiting: dict[str, WaitingRun] = {}
        self._waiting_of: Counter[str] = Counter()
        self._elsewhere: set[str] = set()  # ids of those of other nodes that wait
        self._places_elsewhere: Counter[str] = Counter()
        self._settled_until = -math.inf  # unless something changes before

    def __contains__(self, run_id: str) -> bool:
        """Whether the run has a place."""
        return run_id in self._account_of

    def run_ids(self) -> list[str]:
        """The ids of the runs that have a place or wait for one."""
        return [*self._account_of, *self._waiting]

    def waiting_here(self) -> list[WaitingRun]:
        """The runs that wait at this node."""
        here = self._waiting.items()
        return [run for run_id, run in here if run_id not in self._elsewhere]

    def is_due(self, run_id: str, now_wall: float) -> bool:
        """Whether the run waits for a place and for nothing else."""
        run = self._waiting.get(run_id)
        return run is not None and run.queue_until_wall <= now_wall

    def counts(self) -> dict[str, int]:
        """How many places each account has here."""
        return dict(self._places)

    def note_elsewhere(
        self, waiting: Iterable[WaitingRun], places: Mapping[str, int]
    ) -> None:
        """Replace the runs that wait at other nodes, and accounts' places there."""
        new = {run.run_id: run for run in waiting}
        for run_id in self._elsewhere - new.keys():
            self.stop_waiting(run_id)
        for run_id, run in new.items():
            is_here = run_id in self._waiting and run_id not in self._elsewhere
            if run_id not in self._account_of and not is_here:
                self.wait(run)
                self._elsewhere.add(run_id)
        if places != self._places_elsewhere:
            self._places_elsewhere = Counter(places)
            self._settled_until = -math.inf

    def play(self, run_id: str, account: str) -> None:
        """The run is played: it has a place until `rest` or `leave`."""
        self._take(run_id, account)
        self._no_longer_unplayed(run_id)

    def rest(self, run_id: str, now: float) -> None:
        """No worker plays the run any more; its place, if it has one, may be taken."""
        account = self._account_of.get(run_id)
        if account is not None and run_id not in self._unplayed:
            self._unplayed[run_id] = now
            self._unplayed_of[account] += 1
            self._settled_until = -math.inf

    def leave(self, run_id: str) -> None:
        """The run has no place and waits for none."""
        self._give_back(run_id)
        self.stop_waiting(run_id)

    def wait(self, run: WaitingRun) -> None:
        """The run waits for a place: it is queued, or a worker wants to attach."""
        self._elsewhere.discard(run.run_id)
        earlier = self._waiting.get(run.run_id)
        if earlier is None:
            self._waiting_of[run.account] += 1
        if earlier != run:
            self._waiting[run.run_id] = run
            self._settled_until = -math.inf

    def stop_waiting(self, run_id: str) -> None:
        run = self._waiting.pop(run_id, None)
        self._elsewhere.discard(run_id)
        if run is not None:
            _count_down(self._waiting_of, run.account)

    def can_change(self, now: float, new: WaitingRun | None = None) -> bool:
        """Whether `share` may find something; the length of the queue costs nothing.

        new: one that waits and is not stored yet.
        """
        if new is None and now < self._settled_until:
            return False
        waiting_of = {*self._waiting_of} | (set() if new is None else {new.account})
        if not waiting_of or self._free > 0:
            return bool(waiting_of)
        if not self._unplayed:
            return False
        places = self._places_of_all
        return now >= self._overdue_at() or any(
            gives_back(places, account, waiting)
            for account in self._unplayed_of
            for waiting in waiting_of
        )

    def share(
        self, now: float, now_wall: float, new: WaitingRun | None = None
    ) -> list[WaitingRun]:
        """Give places to runs that wait, and return these."""
        waiting = [*self._waiting.values()] + ([] if new is None else [new])
        due = sum(run.queue_until_wall <= now_wall for run in waiting)
        self._give_back_overdue(due, now)
        shares = share_places(
            waiting, self._places_of_all, self._unplayed_of, self._free, now_wall
        )
        for account in shares.given_back:
            self._give_back_longest_unplayed(account)
        for run in shares.admitted:
            self.stop_waiting(run.run_id)
            self._take(run.run_id, run.account)
            self.rest(run.run_id, now)
        self._settled_until = now + min(
            self.next_due(now_wall) or math.inf, self.next_overdue(now) or math.inf
        )
        return shares.admitted

    def next_due(self, now_wall: float) -> float | None:
        """Seconds until the next queue time is over; None for never."""
        holds = (run.queue_until_wall - now_wall for run in self._waiting.values())
        return min((hold for hold in holds if hold > 0), default=None)

    def next_look(self, now: float) -> float | None:
        """Seconds until time alone can change something; None for never.

        A timer may fire a moment before its time: what found nothing to do then has to
        come again.
        """
        left_s = self._settled_until - now
        return left_s if 0 < left_s < math.inf else None

    def next_overdue(self, now: float) -> float | None:
        """Seconds until a run that waits may get an unplayed place.

        None for never, and when that was so already: then none waits that is due.
        """
        if not self._waiting or not self._unplayed:
            return None
        left_s = self._overdue_at() - now
        return left_s if left_s > 0 else None

    @property
    def _places_of_all(self) -> Counter[str]:
        """How many places each account has, at all nodes."""
        if not self._places_elsewhere:
            return self._places
        return self._places + self._places_elsewhere

    @property
    def _free(self) -> int:
        return self._size - len(self._account_of)

    def _overdue_at(self) -> float:
        return next(iter(self._unplayed.values())) + self._unused_s

    def _give_back_overdue(self, wanted: int, now: float) -> None:
        while self._unplayed and self._free < wanted and now >= self._overdue_at():
            self._give_back(next(iter(self._unplayed)))

    def _give_back_longest_unplayed(self, account: str) -> None:
        run_ids = (
            run_id for run_id in self._unplayed if self._account_of[run_id] == account
        )
        self._give_back(next(run_ids))

    def _take(self, run_id: str, account: str) -> None:
        if run_id not in self._account_of:
            self._account_of[run_id] = account
            self._places[account] += 1

    def _give_back(self, run_id: str) -> None:
        self._no_longer_unplayed(run_id)
        account = self._account_of.pop(run_id, None)
        if account is not None:
            _count_down(self._places, account)
            self._settled_until = -math.inf

    def _no_longer_unplayed(self, run_id: str) -> None:
        if self._unplayed.pop(run_id, None) is not None:
            _count_down(self._unplayed_of, self._account_of[run_id])


def _count_down(counts: Counter[str], account: str) -> None:
    counts[account] -= 1
    if not counts[account]:
        del counts[account]
