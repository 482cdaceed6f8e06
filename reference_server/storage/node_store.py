"""The nodes that share the database, and which of them owns a run.

All times are those of the database's clock. `rules/run_owner.py` decides what a row
means; this module makes it safe: a node that was removed never comes back under its
id, and each claim of a run increments its fence, which every write of the run names
(`store.py`).
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from typing import Any, NamedTuple

import sqlalchemy as sa

from reference_server.rules.capacity import WaitingRun
from reference_server.rules.run_owner import StoredOwner
from reference_server.rules.runs.lifecycle import WAITING_STATES
from reference_server.rules.runs.run import State
from reference_server.storage.runs.run_store import Store, StoreFailed
from reference_server.storage.tables.database_clock import Now, silent_s
from reference_server.storage.tables.database_tables import LEASE
from reference_server.storage.tables.database_tables import cluster_facts as _facts
from reference_server.storage.tables.database_tables import nodes as _nodes
from reference_server.storage.tables.database_tables import runs as _runs


class Node(NamedTuple):
    """One server process, as the others reach it.

    secret: what they send with a request, so that it knows them as nodes.
    """

    node_id: str
    url: str
    secret: str


class ListedNode(NamedTuple):
    """silent_s: since it renewed its lease, by the clock of the database.

    settings: as SettingsComparison writes them; empty if it shows none. read_at: by the
    same clock, seconds since 1970.
    """

    node: Node
    silent_s: float
    settings: str = ""
    read_at: float = 0.0


class Renewed(NamedTuple):
    """A lease that was renewed. timeline: of the history of the database.

    It is another one after a standby was promoted, or a backup restored: what was read
    before may never have happened. Empty where the database does not name it.
    """

    timeline: str


class OwnedRun(NamedTuple):
    """The columns of a waiting run that a node needs in order to take it.

    is_new: it waits since it was submitted. No other node takes a run that was resumed:
    its owner alone knows what ended its sessions (DET-002, DET-005).
    """

    run: WaitingRun
    owner: str | None
    fence: int
    is_new: bool = True


class StoredQueue(NamedTuple):
    """queued: the runs of all nodes that wait, oldest first.

    left: of those that were asked for, the ones that do not wait any more.
    """

    queued: list[OwnedRun]
    left: list[OwnedRun]


_fence = sa.func.coalesce(_runs.c.fence, 0)
_IS_THERE = _runs.c.deleted_at_wall.is_(None)
_IS_QUEUED = _runs.c.state.in_(sorted(WAITING_STATES))
# Nothing happened to it since it was submitted: no session of it was ever known. A run
# that comes back to the queue is stored with a later time, even if a clock was set
# back; a claim alone changes no time.
_IS_NEW = _runs.c.updated_at_wall == _runs.c.created_at_wall
_OWNED = sa.select(
    *(_runs.c[name] for name in WaitingRun.__dataclass_fields__),
    _runs.c.owner,
    _fence,
    _IS_NEW,
).where(_IS_THERE)
_QUEUED = _OWNED.where(_IS_QUEUED).order_by(_runs.c.number)
_LEFT = _OWNED.where(
    ~_IS_QUEUED, _runs.c.run_id.in_(sa.bindparam("run_ids", expanding=True))
)
# The run is held in the queue, until a time by the clock of its owner.
_IS_HELD = _runs.c.queue_until_wall > 0
# PostgreSQL writes the timeline that it is on into the names of its log files.
_TIMELINE = sa.select(
    sa.func.left(sa.func.pg_walfile_name(sa.func.pg_current_wal_lsn()), 8)
)
# A node asks for the state of at most this many runs in one query.
IDS_PER_QUERY = 500


class NodeStore:
    """The list of nodes, and the owners of runs."""

    def __init__(self, store: Store, lease_s: float) -> None:
        self._transactions, self.lease_s = store.transactions, lease_s
        self._lives = silent_s <= lease_s
        self._has_timeline = False

    async def facts(self) -> dict[str, str]:
        """The stored values that must be equal on all nodes, by name."""
        return await self._transactions.read(_read_facts)

    async def agree_on(
        self, facts: Mapping[str, str], url: str, lasting: Collection[str]
    ) -> dict[str, str]:
        """Store the values that the cluster does not have; return all of them, by name.

        facts: what must be equal on all nodes, as this node has it; the caller compares
        it with what is returned. While no other node lives, those of this node replace
        what is stored, but for the names in `lasting`, which never change; nodes that
        had agreed on something else are removed then, and compare again when they go on
        and join. url: of this node; a row with it is of this one, from before a
        restart, and of no other.
        """

        def store(connection: sa.Connection) -> dict[str, str]:
            self._transactions.lock_order(connection)
            agreed = _read_facts(connection)
            # With a longer lease than here, others live though they look silent.
            lives = silent_s <= max(self.lease_s, float(agreed.get(LEASE, 0.0)))
            others = sa.select(_nodes.c.node_id).where(_nodes.c.url != url, lives)
            is_alone = connection.execute(others).first() is None
            if is_alone and any(
                agreed.get(name, value) != value
                for name, value in facts.items()
                if name not in lasting
            ):
                connection.execute(_nodes.delete().where(~lives))
                if connection.execute(others).first() is not None:
                    raise StoreFailed("another node has just come back: start again")
            for name, value in facts.items():
                if name in agreed and (name in lasting or not is_alone):
                    continue
                connection.execute(_facts.delete().where(_facts.c.name == name))
                connection.execute(_facts.insert().values(name=name, value=value))
                agreed[name] = value
            return agreed

        return await self._transactions.write_in_turn(store)

    async def join(
        self, node: Node, settings: str = "", *, is_new: bool = False
    ) -> Renewed:
        """Add a node. Raises StoreFailed if another one at its address lives.

        is_new: it has just begun to listen there; an earlier one has ended.
        """
        row = node._asdict() | {"renewed_at": Now(), "settings": settings}
        earlier = _nodes.c.url == node.url
        is_removed = earlier if is_new else earlier & ~self._lives

        def store(connection: sa.Connection) -> Renewed:
            connection.execute(_nodes.delete().where(is_removed))
            if connection.execute(sa.select(_nodes).where(earlier)).first():
                raise StoreFailed(
                    f"another node has the URL {node.url}: end one of the two, and "
                    "start it with a node_url of its own"
                )
            connection.execute(_nodes.insert().values(row))
            self._has_timeline = _has_timeline(connection)
            return self._renewed(connection)

        return await self._transactions.write_of_node(store)

    async def renew(self, node_id: str, settings: str = "") -> Renewed | None:
        """Renew the lease of a node; None if it was removed."""
        values = {"renewed_at": Now(), "settings": settings}
        renewed = _nodes.update().where(_nodes.c.node_id == node_id)

        def store(connection: sa.Connection) -> Renewed | None:
            done = connection.execute(renewed.values(values))
            return self._renewed(connection) if done.rowcount == 1 else None

        return await self._transactions.write_of_node(store)

    def _renewed(self, connection: sa.Connection) -> Renewed:
        if not self._has_timeline:
            return Renewed("")
        return Renewed(str(connection.scalar(_TIMELINE)))

    async def leave(self, node_id: str) -> None:
        """Remove a node: others may claim its runs at once."""
        await self._change_one(_nodes.delete().where(_nodes.c.node_id == node_id))

    async def listed(self) -> dict[str, ListedNode]:
        """All nodes in the list, by id."""
        columns = (_nodes.c[name] for name in Node._fields)
        query = sa.select(*columns, silent_s, _nodes.c.settings, Now())

        def fetch(connection: sa.Connection) -> dict[str, ListedNode]:
            rows = connection.execute(query)
            return {row[0]: ListedNode(Node(*row[:-3]), *row[-3:]) for row in rows}

        return await self._transactions.read_of_node(fetch)

    async def owner_of(self, run_id: str) -> StoredOwner | None:
        """The stored owner of the run; None if there is no such run."""
        query = (
            sa.select(_runs.c.owner, _fence, _runs.c.state, silent_s)
            .select_from(_runs.outerjoin(_nodes, _nodes.c.node_id == _runs.c.owner))
            .where(_runs.c.run_id == run_id, _IS_THERE)
        )

        def fetch(connection: sa.Connection) -> StoredOwner | None:
            row = connection.execute(query).first()
            return None if row is None else StoredOwner(*row)

        return await self._transactions.read(fetch)

    async def remove_silent(self, node_id: str) -> bool:
        """Remove a node whose lease is over; False if it was renewed meanwhile.

        A renewal at the same time waits for this, or this for the renewal: both change
        the same row, and the second one sees what the first one did.
        """
        removed = _nodes.delete().where(_nodes.c.node_id == node_id, ~self._lives)
        return await self._change_one(removed)

    async def claim(
        self,
        run_id: str,
        node_id: str,
        stored_owner: StoredOwner,
        after_restart: Mapping[State, State],
        reason: str,
    ) -> bool:
        """Make a node in the list the owner of a run, unless another one came first.

        stored_owner: the owner that is no longer in the list. With its owner the run
        lost its sessions: its state becomes what a restart makes of it.
        """
        is_in_play = _runs.c.state.in_(after_restart)
        claimed = (
            _runs.update()
            .where(_runs.c.run_id == run_id, _fence == stored_owner.fence, _IS_THERE)
            .where(sa.exists().where(_nodes.c.node_id == node_id))
            .values(
                owner=node_id,
                fence=stored_owner.fence + 1,
                state=sa.case(
                    dict(after_restart), value=_runs.c.state, else_=_runs.c.state
                ),
                reason=sa.case((is_in_play, reason), else_=_runs.c.reason),
            )
        )
        return await self._change_one(claimed)

    async def queue(self, known_ids: Sequence[str]) -> StoredQueue:
        """The runs that wait at all nodes, and those of `known_ids` that left it."""

        def fetch(connection: sa.Connection) -> StoredQueue:
            queued = [_owned_run(*row) for row in connection.execute(_QUEUED)]
            waiting = {owned.run.run_id for owned in queued}
            gone = [run_id for run_id in known_ids if run_id not in waiting]
            left: list[OwnedRun] = []
            for start in range(0, len(gone), IDS_PER_QUERY):
                some = {"run_ids": gone[start : start + IDS_PER_QUERY]}
                left += [_owned_run(*row) for row in connection.execute(_LEFT, some)]
            return StoredQueue(queued, left)

        return await self._transactions.read(fetch)

    async def take(
        self,
        run_id: str,
        node_id: str,
        fence: int,
        states_with_capacity: Mapping[State, State],
    ) -> bool:
        """Let in a run that waits, with a node in the list as its owner.

        fence: as it was when the run was seen, at whichever node. False if another node
        came first, or the run waits no more, is held by its submitter or was resumed.
        Whether its owner lives is of no matter: it stores nothing more of the run.
        """
        now, before = Now(), _runs.c.updated_at_wall
        taken = (
            _runs.update()
            .where(_runs.c.run_id == run_id, _fence == fence, _IS_THERE)
            .where(_runs.c.state.in_(states_with_capacity), ~_IS_HELD, _IS_NEW)
            .where(sa.exists().where(_nodes.c.node_id == node_id))
            .values(
                owner=node_id,
                fence=fence + 1,
                state=sa.case(dict(states_with_capacity), value=_runs.c.state),
                reason=None,
                updated_at_wall=sa.case((before > now, before), else_=now),  # RUN-021
            )
        )
        return await self._change_one(taken)

    async def let_go(self, run_ids: Sequence[str], node_id: str) -> None:
        """Runs of a node that wait, and are held no more: others may take them."""
        of_node = _runs.c.run_id.in_(run_ids) & (_runs.c.owner == node_id)
        change = _runs.update().where(of_node, _IS_QUEUED, _IS_HELD)
        await self._change_one(change.values(queue_until_wall=0.0))

    async def _change_one(self, statement: sa.Executable) -> bool:
        """Whether the statement, which is carried out, has changed one row."""
        return await self._transactions.write_of_node(
            lambda connection: connection.execute(statement).rowcount == 1
        )

    async def without_owner(self, states: list[State], limit: int) -> list[str]:
        """Ids of runs in these states whose owner does not live, oldest first."""
        live = sa.select(_nodes.c.node_id).where(self._lives)
        query = (
            sa.select(_runs.c.run_id)
            .where(_runs.c.state.in_(states), _IS_THERE)
            .where(sa.or_(_runs.c.owner.is_(None), _runs.c.owner.not_in(live)))
            .order_by(_runs.c.number)
            .limit(limit)
        )
        return await self._transactions.read(lambda c: list(c.scalars(query)))


def _has_timeline(connection: sa.Connection) -> bool:
    """Whether this is PostgreSQL, and this user may ask for its timeline."""
    if connection.dialect.name != "postgresql":
        return False
    try:
        with connection.begin_nested():
            connection.execute(_TIMELINE)
    except sa.exc.DBAPIError:
        return False
    return True


def _owned_run(*row: Any) -> OwnedRun:
    *of_run, owner, fence, is_new = row
    return OwnedRun(WaitingRun(*of_run), owner, fence, bool(is_new))


def _read_facts(connection: sa.Connection) -> dict[str, str]:
    query = sa.select(_facts.c.name, _facts.c.value)
    return {row.name: row.value for row in connection.execute(query)}
