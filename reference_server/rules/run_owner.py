"""Which node of a cluster acts for a run. Pure.

Nodes are server processes that share a database. A run has at most one owner among
them. An owner stays it until the lease of its node is over: then another node removes
it from the list of nodes, for good, and claims its runs, each with a larger fence.
"""

from __future__ import annotations

from typing import Literal, NamedTuple, TypeAlias

from reference_server.rules.refusal import Refused
from reference_server.rules.runs.run import State

# here: this node has the run, or its answer needs no owner. claim: the run has no owner
# that lives. forward: another node has it.
Place: TypeAlias = Literal["here", "claim", "forward"]

# How often a node renews its lease: one that is late by less keeps its runs.
RENEWALS_PER_LEASE = 5
# No session, no request and no event changes such a run; a deletion is stored at once.
_FINAL_STATES = frozenset({"completed"})


class StoredOwner(NamedTuple):
    """The owner of a run, as the database has it.

    node_id: None without an owner. silent_s: since its node renewed its lease, by the
    clock of the database; None if the node is not, or no more, in the list.
    """

    node_id: str | None
    fence: int
    state: State
    silent_s: float | None


class NodeRefused(Exception):
    """Why a server must not be a node of its cluster; the text says what to do."""


class OwnedElsewhere(Refused):
    """Another node has the run; the same request finds it there."""

    def __init__(self, run_id: str) -> None:
        super().__init__("unavailable", f"Another node has taken over {run_id}.")


def lease_is_over(silent_s: float | None, lease_s: float) -> bool:
    """Whether a node's runs may be claimed, by the clock of the database alone."""
    return silent_s is None or silent_s > lease_s


def looks_silent(silent_s: float, lease_s: float) -> bool:
    """Whether a node that lives would have renewed its lease again."""
    return silent_s > 1.5 * lease_s / RENEWALS_PER_LEASE


def is_dead(silent_s: float, seen_silent_for_s: float, lease_s: float) -> bool:
    """Whether a node in the list is removed from it.

    Its lease is over, and it was seen silent for half of it: a database that was away,
    or whose clock jumped, makes every node look silent until it renews its lease again.
    """
    return lease_is_over(silent_s, lease_s) and seen_silent_for_s >= lease_s / 2


def place_of(
    owner: StoredOwner, node_id: str, lease_s: float, *, only_reads: bool
) -> Place:
    """The place where a request for the run is carried out."""
    if owner.node_id == node_id:
        return "here"
    if only_reads and owner.state in _FINAL_STATES:
        return "here"
    return "claim" if lease_is_over(owner.silent_s, lease_s) else "forward"
