"""Events of runs: each change is published once, to all parts that follow runs.

The cache and the writer publish, and know none of the followers. Each of these does its
own part: what an account has open, the log, the queue, the requests that wait, the
sessions, the calls to policy servers.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

from reference_server.rules.runs.run import Episode, Run, State

# Why a run left memory. deleted: it is no more. moved: another node acts for it.
# unstored: a write of it failed, and the database has the valid state. refused: it may
# not be opened again, as the transaction that was to store that has found.
Departure = Literal["deleted", "moved", "unstored", "refused"]


class RunFollower:
    """Is informed of every change of a run of this server; only `prepare` may await.

    A follower overrides the events that concern it. Its reaction may change another
    run, whose events are then published before this one has reached all followers.
    """

    async def prepare(self, run: Run) -> None:
        """The run was read, and `loaded` follows; what it needs is read here."""

    def loaded(self, run: Run, stored: State) -> None:
        """The run was read from the database; `stored` is its state there.

        It may have another one by now: no session of a run that was read is live,
        before a follower lets one go on.
        """

    def changed(self, run: Run) -> None:
        """Something that get_run shows has changed, in memory or on disk."""

    def stored(self, run: Run, scored: Sequence[Episode]) -> None:
        """The database has the run, and with this write the results of `scored`."""
        if not run.lost:  # else it has left memory meanwhile, and they know that
            self.changed(run)

    def left(self, run: Run, why: Departure) -> None:
        """The run left memory: this object of it has no truth any more."""


class RunEvents(RunFollower):
    """Passes each event on to all followers, in the order in which they came."""

    def __init__(self, *followers: RunFollower) -> None:
        self._followers = list(followers)

    def subscribe(self, follower: RunFollower) -> None:
        """Add a follower, which may have been made of parts that publish."""
        self._followers.append(follower)

    async def prepare(self, run: Run) -> None:
        for follower in self._followers:
            await follower.prepare(run)

    def loaded(self, run: Run, stored: State) -> None:
        for follower in self._followers:
            follower.loaded(run, stored)

    def changed(self, run: Run) -> None:
        for follower in self._followers:
            follower.changed(run)

    def stored(self, run: Run, scored: Sequence[Episode]) -> None:
        for follower in self._followers:
            follower.stored(run, scored)

    def left(self, run: Run, why: Departure) -> None:
        for follower in self._followers:
            follower.left(run, why)
