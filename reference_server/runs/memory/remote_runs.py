"""Knowledge of a node in a cluster about the runs that other nodes own or offer.

It decides nothing, and without other nodes it is empty.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Protocol
from weakref import WeakSet

from reference_server.rules.runs.run import Run, RunHead
from reference_server.storage.node_store import OwnedRun


class Ownership(Protocol):
    """This server as one of several that share the database."""

    @property
    def node_id(self) -> str:
        """Whose runs are in memory; another one after they were lost."""

    async def claim(self, run_id: str) -> bool:
        """Become the owner, unless another node is it; whether this one is it now."""

    async def confirm(self) -> None:
        """Return when what was read before is stored for good. Raises StoreFailed."""


class OtherQueues(Protocol):
    """The queues of the other nodes of a cluster."""

    async def refresh(self) -> None:
        """Call `RunAdmission.note_queue` with the runs that wait at all nodes."""

    async def take(self, run_id: str) -> bool:
        """Let in a run that waits there, as its owner; whether it worked."""

    def announce(self) -> None:
        """Let the others know that what waits here has changed."""

    def look(self) -> None:
        """Call `RunAdmission.note_waiting_elsewhere` soon: a place is free here."""


class OfferedRuns:
    """Runs that wait at other nodes, and that this one may take.

    offered: each look at the queues replaces all of them (`offer`); one that was loaded
    here is none any more (`note_here`).

    wanted: an offered run that got a place here (`want`), until the attempt to take it
    begins (`begin_to_take`).

    changed: what waits here is not what the other nodes know (`note_queue_change`),
    until they are informed (`begin_to_announce`).
    """

    def __init__(self) -> None:
        self._offered: set[str] = set()
        self._wanted: set[str] = set()
        self._has_changed = False

    def offer(self, run_ids: Iterable[str]) -> None:
        """This node may take these runs now, and no others."""
        self._offered = set(run_ids)

    def note_here(self, run_id: str) -> None:
        """The run is this node's."""
        self._offered.discard(run_id)

    def want(self, run_id: str) -> None:
        """The run got a place here; one that is not offered need not be taken."""
        if run_id in self._offered:
            self._wanted.add(run_id)

    def begin_to_take(self, run_id: str) -> bool:
        """Whether the run has to be taken before it is loaded; True once."""
        is_wanted = run_id in self._wanted
        self._wanted.discard(run_id)
        return is_wanted

    def forget_offers(self) -> None:
        """This node has lost its lease: it may take nothing."""
        self._offered.clear()
        self._wanted.clear()

    def note_queue_change(self) -> None:
        """A run waits here, or waits here no more."""
        self._has_changed = True

    def begin_to_announce(self) -> bool:
        """Whether the other nodes have to be informed; True once for each change."""
        has_changed, self._has_changed = self._has_changed, False
        return has_changed


class MovedRuns:
    """Runs of this node's memory for which another node acts by now.

    Nothing more of them is stored here. complete: all of the run was stored before
    that, so that what memory showed of it was right.
    """

    def __init__(self) -> None:
        self._moved: WeakSet[Run] = WeakSet()
        self._complete: WeakSet[Run] = WeakSet()

    def note(self, run: Run, *, is_complete: bool) -> None:
        """Another node acts for the run."""
        self._moved.add(run)
        if is_complete:
            self._complete.add(run)

    def has(self, run: Run) -> bool:
        return run in self._moved

    def is_complete(self, run: Run) -> bool:
        """Whether the run has moved, and all that memory has of it is stored."""
        return run in self._complete


def has_newer_owner(run: RunHead, stored: OwnedRun) -> bool:
    """Whether a run of this node, as it was just seen, has another owner since then.

    A row that was read before this node became the owner has an older fence, and is
    not a newer owner.
    """
    return run.fence < stored.fence and run.owner != stored.owner
