"""Who owns a run, row by row: claims, fences, and leases by the database's clock."""

from __future__ import annotations

import asyncio
import time
from collections.abc import AsyncIterator, Callable
from contextlib import AbstractAsyncContextManager, asynccontextmanager
from pathlib import Path
from typing import Any

import pytest
import sqlalchemy as sa
from sqlalchemy.ext.asyncio import AsyncConnection

from reference_server.cluster import membership as membership_module
from reference_server.cluster.membership import Membership
from reference_server.cluster.server_node import ServerNode
from reference_server.cluster.settings_comparison import SettingsComparison
from reference_server.rules.capacity import Quota
from reference_server.rules.refusal import Refused
from reference_server.rules.run_owner import NodeRefused, OwnedElsewhere
from reference_server.rules.runs.lifecycle import (
    RESTART_REASON,
    STATES_AFTER_RESTART,
    STATES_WITH_CAPACITY,
)
from reference_server.rules.runs.run import Run, State
from reference_server.runs.admission.account_usage import AccountUsage
from reference_server.storage.connection import postgresql as database_postgresql
from reference_server.storage.connection import server_lock
from reference_server.storage.connection.server_lock import lock_of
from reference_server.storage.node_store import ListedNode, Node, NodeStore, Renewed
from reference_server.storage.runs.run_store import OwnershipLost, Store, StoreFailed
from reference_server.storage.tables.database_tables import nodes as node_rows
from reference_server.telemetry.log_output import REQUEST_ID
from tests.support.server.databases import UsedDatabase
from tests.support.server.postgresql_server import PostgresqlServer
from tests.support.server.server_parts import calibration_run

LEASE_S = 60.0
FIRST, SECOND, THIRD = (
    Node(name, f"http://{name}", "secret") for name in ("first", "second", "third")
)


def transaction_of(store: Store) -> AbstractAsyncContextManager[AsyncConnection]:
    """One of PostgreSQL that a test keeps open."""
    database = store.transactions._database
    return database.transaction_of(database._engine)


async def live(nodes: NodeStore) -> list[str]:
    """Ids of those whose lease is not over."""
    listed = await nodes.listed()
    return sorted(one for one in listed if listed[one].silent_s <= LEASE_S)


class Nodes:
    """Two connections to one database, as two nodes have them."""

    def __init__(self, url: str) -> None:
        self.stores = [Store(url, is_shared=True) for _ in range(2)]
        self.nodes = [NodeStore(store, LEASE_S) for store in self.stores]

    async def add_run(self, owner: Node, state: State = "ready", **changes: Any) -> Run:
        run = calibration_run(**changes)
        run.owner, run.fence, run.state = owner.node_id, 1, state
        if "run_id" not in changes:
            run.run_id = f"run_{state}"
        assert await self.stores[0].insert(run, None, "")
        return run

    async def let_lease_end(self, node: Node) -> None:
        """As if the node had not renewed it for long."""
        await self.let_it_be_silent(node, LEASE_S + 39)

    async def let_it_be_silent(self, node: Node, more_s: float) -> None:
        """As if the last renewal of the node had been so much earlier."""
        change = sa.text("UPDATE nodes SET renewed_at = renewed_at - :s WHERE url = :u")
        given = {"u": node.url, "s": more_s}
        await self.stores[0].transactions.write_in_turn(
            lambda c: c.execute(change, given)
        )

    async def claim(self, run: Run, node: Node, store: int = 1) -> bool:
        nodes = self.nodes[store]
        seen = await nodes.owner_of(run.run_id)
        assert seen is not None
        return await nodes.claim(
            run.run_id, node.node_id, seen, STATES_AFTER_RESTART, RESTART_REASON
        )


@asynccontextmanager
async def opened(used: UsedDatabase) -> AsyncIterator[Nodes]:
    database = Nodes(used.url)
    for store in database.stores:
        await store.open()
    await database.nodes[0].join(FIRST)
    await database.nodes[1].join(SECOND)
    try:
        yield database
    finally:
        for store in database.stores:
            await store.close()


@pytest.fixture
async def nodes(database: UsedDatabase) -> AsyncIterator[Nodes]:
    """Two of one database, which have joined."""
    async with opened(database) as nodes:
        yield nodes


async def member_of(
    nodes: Nodes,
    adopt: Callable[[str], None] = lambda _run_id: None,
    on_lost: Callable[[], None] = lambda: None,
    *,
    store: NodeStore | None = None,
    lease_s: float = LEASE_S,
    url: str = "http://member",
    **callbacks: Any,
) -> Membership:
    """One that knows the two of the list. lease_s: 0 is a lease that is always over."""
    store = store or nodes.nodes[1]
    member = Membership(store, url, lease_s, on_lost, adopt, **callbacks)
    await member.open()
    return member


async def without_lease(nodes: Nodes, **callbacks: Any) -> Membership:
    store = NodeStore(nodes.stores[0], 0.0)
    return await member_of(nodes, store=store, lease_s=0.0, **callbacks)


def lose_answers(patch: pytest.MonkeyPatch, node: NodeStore, name: str) -> None:
    """What is claimed or taken is stored, and its caller learns nothing of it."""
    right = getattr(node, name)

    async def store_without_answer(*given: Any) -> bool:
        await right(*given)
        raise StoreFailed("the connection was lost")

    patch.setattr(node, name, store_without_answer)


async def test_what_an_earlier_owner_writes_is_not_stored(nodes: Nodes) -> None:
    run = await nodes.add_run(FIRST)
    assert await nodes.claim(run, SECOND)
    run.reason = "stored too late"
    with pytest.raises(OwnershipLost):
        await nodes.stores[0].save(run)
    with pytest.raises(OwnershipLost):
        await nodes.stores[0].delete(run, time.time())
    stored = await nodes.stores[1].load(run.run_id)
    assert stored is not None
    assert (stored.owner, stored.fence, stored.reason) == ("second", 2, None)
    await nodes.stores[1].save(stored)


async def test_a_run_is_claimed_by_one_node(nodes: Nodes) -> None:
    run = await nodes.add_run(THIRD)
    seen = await nodes.nodes[0].owner_of(run.run_id)
    assert seen is not None
    claims = [
        store.claim(run.run_id, one.node_id, seen, STATES_AFTER_RESTART, "")
        for store, one in zip(nodes.nodes, (FIRST, SECOND), strict=True)
    ]
    assert sorted(await asyncio.gather(*claims)) == [False, True]


async def test_what_a_restart_does_to_a_run_is_done_when_it_is_claimed(
    nodes: Nodes,
) -> None:
    for state, after in STATES_AFTER_RESTART.items():
        run = await nodes.add_run(THIRD, state)
        assert await nodes.claim(run, SECOND)
        stored = await nodes.stores[1].load(run.run_id)
        assert stored is not None
        assert (stored.state, stored.reason) == (after, RESTART_REASON)


async def test_a_node_that_is_not_in_the_list_claims_nothing(nodes: Nodes) -> None:
    run = await nodes.add_run(FIRST)
    assert not await nodes.claim(run, THIRD)


async def test_a_lease_that_runs_keeps_its_node(nodes: Nodes) -> None:
    first, second = nodes.nodes
    assert not await second.remove_silent("first")
    await nodes.let_lease_end(FIRST)
    assert await live(second) == ["second"]
    assert await first.renew("first")  # late, and in time
    assert not await second.remove_silent("first")
    await nodes.let_lease_end(FIRST)
    assert await second.remove_silent("first")
    assert not await first.renew("first")  # for good


async def test_nodes_share_the_lock_of_the_database(
    database: UsedDatabase, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A server that is no node gets it when none of them has it any more."""
    monkeypatch.setattr(server_lock, "WAIT_S", 0.1)
    alone = lock_of(database.url, lambda: None)
    nodes = [lock_of(database.url, lambda: None, is_shared=True) for _ in range(2)]
    for node in nodes:
        await node.acquire()
    for node in nodes:
        with pytest.raises(StoreFailed, match="another server uses it"):
            await alone.acquire()
        await node.release()
    with monkeypatch.context() as patched:  # its predecessor may take a while
        patched.setattr(server_lock, "WAIT_S", 30.0)
        await alone.acquire()
    with pytest.raises(StoreFailed, match="another server uses it"):
        await nodes[0].acquire()
    await alone.release()


async def test_a_node_takes_the_place_of_an_earlier_one_at_its_address(
    nodes: Nodes,
) -> None:
    again = Node("again", FIRST.url, "secret")
    await nodes.nodes[0].join(again, is_new=True)
    assert await live(nodes.nodes[1]) == ["again", "second"]


async def test_a_node_without_a_lease_acts_for_no_run(nodes: Nodes) -> None:
    """It renews first, and forgets its runs when others removed it meanwhile."""
    lost: list[str] = []
    announced: list[str] = []

    member: Membership = await without_lease(
        nodes, on_lost=lambda: lost.append(member.node_id), announce=announced.append
    )
    first_id = member.node_id
    await member.ensure_lease()
    assert (lost, member.node_id) == ([], first_id)
    assert await NodeStore(nodes.stores[1], 0.0).remove_silent(first_id)
    await member.ensure_lease()
    assert lost == [member.node_id]
    assert member.node_id != first_id
    assert announced == [first_id, member.node_id]
    await member.close()
    assert await live(nodes.nodes[1]) == ["first", "second"]


@pytest.mark.parametrize(("state", "is_loaded"), [("ready", True), ("stopped", False)])
async def test_an_open_run_that_a_request_claims_is_loaded(
    state: State, nodes: Nodes, *, is_loaded: bool
) -> None:
    """Nothing else would go on with a push run: it has an owner now."""
    run = await nodes.add_run(THIRD, state)
    adopted: list[str] = []
    member = await member_of(nodes, adopted.append)
    assert await member.find_other(run.run_id, only_reads=True) is None
    assert adopted == [run.run_id] * is_loaded


async def test_a_claim_that_was_stored_without_an_answer_is_found(
    monkeypatch: pytest.MonkeyPatch, nodes: Nodes
) -> None:
    """The connection was lost while it was committed; a push run would stand still."""
    run = await nodes.add_run(THIRD)
    adopted: list[str] = []
    node = nodes.nodes[1]
    member = await member_of(nodes, adopted.append)
    with monkeypatch.context() as patch:
        lose_answers(patch, node, "claim")
        with pytest.raises(StoreFailed):
            await member._claim_abandoned()
    assert adopted == []
    for _ in range(2):
        await member._claim_abandoned()
        assert adopted == [run.run_id]


async def move_to_dead_node(nodes: Nodes, run: Run) -> None:
    """Another one than those of the list took the run, and died."""
    change = sa.text("UPDATE runs SET owner = 'third', fence = 7 WHERE run_id = :r")
    given = {"r": run.run_id}
    await nodes.stores[0].transactions.write_in_turn(lambda c: c.execute(change, given))


@pytest.mark.parametrize("is_answered", [True, False])
async def test_a_node_forgets_who_owned_the_run_that_it_claimed(
    monkeypatch: pytest.MonkeyPatch, nodes: Nodes, *, is_answered: bool
) -> None:
    """Requests would be passed on to that owner. Also if the claim got no answer."""
    run = await nodes.add_run(FIRST)
    node, member = nodes.nodes[1], await member_of(nodes)
    assert await member.find_other(run.run_id, only_reads=False) == FIRST
    await move_to_dead_node(nodes, run)
    if is_answered:
        assert await member.find_other(run.run_id, only_reads=True) is None
    else:
        claim = node.claim

        async def claim_without_answer(*given: Any) -> bool:
            await claim(*given)
            member._note_owner(run.run_id, "first")  # by a read that began earlier
            raise StoreFailed("the connection was lost")

        with monkeypatch.context() as patch:
            patch.setattr(node, "claim", claim_without_answer)
            with pytest.raises(StoreFailed):
                await member.find_other(run.run_id, only_reads=True)
        await member._claim_abandoned()
    assert await member.find_other(run.run_id, only_reads=False) is None


async def test_a_run_that_moved_on_to_a_node_that_died_is_claimed_without_a_request(
    nodes: Nodes,
) -> None:
    """Its owner of before lives, and this node still knows that one."""
    run = await nodes.add_run(FIRST)
    member = await member_of(nodes)
    assert await member.find_other(run.run_id, only_reads=False) == FIRST
    await move_to_dead_node(nodes, run)
    await member._claim_abandoned()
    owner = await nodes.nodes[0].owner_of(run.run_id)
    assert owner is not None
    assert owner.node_id == member.node_id


async def test_a_renewal_ends_before_its_node_leaves(
    monkeypatch: pytest.MonkeyPatch, nodes: Nodes
) -> None:
    """It would find that the node was removed, and join again."""
    node, member = nodes.nodes[1], await member_of(nodes)
    renew, began, may_go_on = node.renew, asyncio.Event(), asyncio.Event()

    async def renew_late(node_id: str, _settings: str) -> Renewed | None:
        began.set()
        await may_go_on.wait()
        return await renew(node_id)

    monkeypatch.setattr(node, "renew", renew_late)
    member.start()
    await began.wait()
    asyncio.get_running_loop().call_later(0.05, may_go_on.set)
    await member.close()
    assert may_go_on.is_set()
    assert await live(node) == ["first", "second"]


async def test_a_renewal_is_no_part_of_the_request_that_began_it(
    monkeypatch: pytest.MonkeyPatch, nodes: Nodes
) -> None:
    """What it logs would have the id of that request; others wait for it, too."""
    node, logged_with = nodes.nodes[1], list[str | None]()
    member, right = await member_of(nodes, lease_s=0.0), node.renew

    async def renew(node_id: str, _settings: str) -> Renewed | None:
        logged_with.append(REQUEST_ID.get())
        return await right(node_id)

    monkeypatch.setattr(node, "renew", renew)
    token = REQUEST_ID.set("of a request")
    await member.ensure_lease()
    REQUEST_ID.reset(token)
    assert logged_with == [None]


async def test_a_node_that_ends_claims_nothing_more(nodes: Nodes) -> None:
    run = await nodes.add_run(THIRD)
    member = await member_of(nodes)
    member.stop_claiming()
    with pytest.raises(OwnedElsewhere):
        await member.claim(run.run_id)
    assert await nodes.claim(run, FIRST, 0)


async def test_a_living_node_at_the_same_address_is_not_removed(nodes: Nodes) -> None:
    """Only a node that starts takes the place; who lost it would take it back."""
    announced: set[str] = set()
    member = await without_lease(nodes, url=FIRST.url, announce=announced.add)
    later = Node("later", FIRST.url, "secret")
    await nodes.nodes[1].join(later, is_new=True)
    member._nodes = nodes.nodes[0]
    for _again in range(2):
        with pytest.raises(StoreFailed, match="has the URL http://first"):
            await member.ensure_lease()
    assert len(announced) == 2  # a file each, in the folder that all share
    assert await live(nodes.nodes[1]) == ["later", "second"]
    await nodes.let_lease_end(later)
    await member.ensure_lease()
    assert await live(nodes.nodes[1]) == sorted([member.node_id, "second"])


async def test_a_node_that_was_removed_acts_for_no_run_before_it_may(
    nodes: Nodes,
) -> None:
    """Others that started meanwhile may have another key: it is asked until it may."""
    answers: list[StoreFailed | None] = [StoreFailed("wait"), None]
    asked: list[list[str]] = []

    async def check() -> None:
        asked.append(await live(nodes.nodes[1]))
        if (error := answers.pop(0)) is not None:
            raise error

    member = await without_lease(nodes, on_joined_again=check)
    assert asked == []
    await nodes.nodes[1].leave(member.node_id)
    with pytest.raises(StoreFailed, match="wait"):
        await member.ensure_lease()
    await member.ensure_lease()
    await member.ensure_lease()
    assert asked == [sorted([member.node_id, "first", "second"])] * 2


async def test_a_node_that_is_refused_when_it_joins_again_ends_the_server_once(
    nodes: Nodes,
) -> None:
    """A second signal would end it at once, with answers in progress."""
    ends: list[str] = []
    checks: list[str] = []

    async def refuse() -> None:
        checks.append("refused")
        raise NodeRefused("another key")

    server = ServerNode(
        NodeStore(nodes.stores[0], 0.0),
        "http://member",
        0.0,
        announce=lambda _node_id: None,
        on_joined=refuse,
        settings=SettingsComparison(dict),
        end_server=lambda: ends.append("end"),
    )
    member = server.membership
    await member.open()
    await nodes.nodes[1].leave(member.node_id)
    for _again in range(3):
        with pytest.raises(StoreFailed, match="another key"):
            await member.ensure_lease()
    assert (checks, ends) == (["refused"], ["end"])


async def test_who_agrees_on_something_else_removes_the_silent(nodes: Nodes) -> None:
    """They compare again when they join; by a renewal alone they would not."""
    store, lasting = nodes.nodes[1], {"folder"}
    facts = {"folder": "f", "key": "1"}
    assert await store.agree_on(facts, FIRST.url, lasting) == facts
    await nodes.let_lease_end(SECOND)
    assert await store.agree_on(facts, FIRST.url, lasting) == facts
    assert await store.renew("second")
    await nodes.let_lease_end(SECOND)
    facts["key"] = "2"
    assert await store.agree_on(facts, FIRST.url, lasting) == facts
    assert not await store.renew("second")
    assert await store.renew("first")


@pytest.mark.slow("PostgreSQL")
async def test_a_node_that_is_paused_in_a_transaction_locks_nothing_for_long(
    postgresql: PostgresqlServer, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Others would wait for its locks until it goes on."""
    monkeypatch.setattr(database_postgresql, "NODE_IDLE_TIMEOUT_S", 1.0)
    database = UsedDatabase(postgresql.create(), server=postgresql)
    async with opened(database) as nodes:
        renewed = node_rows.update().where(node_rows.c.node_id == "first")

        async def renew_and_pause() -> None:
            async with transaction_of(nodes.stores[0]) as connection:
                await connection.execute(renewed.values(renewed_at=0.0))
                async with asyncio.timeout(5):
                    assert await nodes.nodes[1].renew("first")
                await connection.execute(renewed.values(renewed_at=0.0))

        with pytest.raises(StoreFailed):
            await renew_and_pause()
        assert await live(nodes.nodes[1]) == ["first", "second"]


async def test_a_request_does_not_wait_long_for_a_lease(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A database that does not answer: another node may reach it."""
    async with opened(UsedDatabase.of_file(tmp_path / "d.sqlite")) as nodes:
        member = await member_of(nodes, store=nodes.nodes[0], lease_s=0.0)
        with monkeypatch.context() as patched:
            patched.setattr(membership_module, "LATE_LEASE_S", 0.05)
            async with nodes.stores[0].transactions.write_lock, asyncio.timeout(5):
                with pytest.raises(StoreFailed, match="could not be renewed"):
                    await member.ensure_lease()
        await member.ensure_lease()


class Clock:
    """What a node takes for the time."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self.now = 1000.0
        monkeypatch.setattr(membership_module, "_now", lambda: self.now)


async def test_a_node_that_is_silent_at_one_look_keeps_its_runs(
    monkeypatch: pytest.MonkeyPatch, nodes: Nodes
) -> None:
    """The clock of the database jumped, or it was away: all look silent until then."""
    clock = Clock(monkeypatch)
    run = await nodes.add_run(FIRST)
    member = await member_of(nodes)
    await nodes.let_lease_end(FIRST)
    await member._look_for_others()
    with pytest.raises(OwnedElsewhere):
        await member.claim(run.run_id)
    assert not member.gone(FIRST).is_set()
    assert await nodes.nodes[0].renew("first")
    clock.now += LEASE_S / 2
    await member._look_for_others()
    assert await member.find_other(run.run_id, only_reads=False) == FIRST


async def test_a_node_that_stays_silent_loses_its_runs(
    monkeypatch: pytest.MonkeyPatch, nodes: Nodes
) -> None:
    """Who waits for it is refused. Expect the same of a clock that was set back."""
    clock = Clock(monkeypatch)
    run = await nodes.add_run(FIRST)
    member = await member_of(nodes)
    waiting = member.gone(FIRST)
    set_back = sa.text("UPDATE nodes SET renewed_at = renewed_at + 9999")
    await nodes.stores[0].transactions.write_in_turn(lambda c: c.execute(set_back))
    await member._look_for_others()
    clock.now += LEASE_S / 2
    assert await member.claim(run.run_id)
    assert waiting.is_set()


async def test_a_node_that_saw_nothing_for_a_lease_begins_to_look_again(
    monkeypatch: pytest.MonkeyPatch, nodes: Nodes
) -> None:
    """It saw another one silent, and then the database was away for all."""
    clock = Clock(monkeypatch)
    run = await nodes.add_run(FIRST)
    member = await member_of(nodes)
    await nodes.let_lease_end(FIRST)
    await member._look_for_others()
    clock.now += LEASE_S + 1
    with pytest.raises(OwnedElsewhere):
        await member.claim(run.run_id)
    await member._look_for_others()
    with pytest.raises(OwnedElsewhere):
        await member.claim(run.run_id)
    clock.now += LEASE_S / 2
    assert await member.claim(run.run_id)


async def test_a_node_that_was_not_reached_is_watched_until_its_lease_is_over(
    monkeypatch: pytest.MonkeyPatch, nodes: Nodes
) -> None:
    """Who waits for it goes on at once when it has ended, or has renewed its lease."""
    monkeypatch.setattr(membership_module, "LOOKS_PER_LEASE", 1e6)
    clock, looks = Clock(monkeypatch), 0
    member = await member_of(nodes)
    look = member._look_for_others

    async def look_and_count() -> dict[str, ListedNode]:
        nonlocal looks
        looks += 1
        if looks == 3:
            assert await nodes.nodes[0].renew("first")
        if looks == 6:
            clock.now += LEASE_S / 2
        return await look()

    monkeypatch.setattr(member, "_look_for_others", look_and_count)
    await nodes.let_it_be_silent(FIRST, LEASE_S / 3)  # a renewal is seen by the change
    assert not await member.has_ended(FIRST)
    await nodes.let_lease_end(FIRST)
    both = await asyncio.gather(member.has_ended(FIRST), member.has_ended(FIRST))
    assert (list(both), looks) == ([True, True], 6)


@pytest.mark.slow("PostgreSQL")
async def test_a_write_that_takes_long_ends_no_lease(
    postgresql: PostgresqlServer,
) -> None:
    """A renewal behind it would be too late, and others would claim all runs."""
    database = UsedDatabase(postgresql.create(), server=postgresql)
    async with (
        opened(database) as nodes,
        transaction_of(nodes.stores[0]),
        asyncio.timeout(5),
    ):
        assert await nodes.nodes[0].renew("first")
        assert "second" in await nodes.nodes[0].listed()


@pytest.mark.slow("PostgreSQL")
async def test_a_claim_waits_for_no_node_that_is_paused_while_it_writes(
    postgresql: PostgresqlServer, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The claim is tried again; meanwhile this node renews its lease."""
    monkeypatch.setattr(database_postgresql, "CLAIM_LOCK_TIMEOUT_S", 0.1)
    database = UsedDatabase(postgresql.create(), server=postgresql)
    async with opened(database) as nodes:
        run = await nodes.add_run(THIRD)
        lock = sa.text("SELECT number FROM runs FOR UPDATE")
        async with (
            transaction_of(nodes.stores[0]) as connection,
            asyncio.timeout(5),
        ):
            await connection.execute(lock)
            with pytest.raises(StoreFailed, match="lock timeout"):
                await nodes.claim(run, SECOND)
        assert await nodes.claim(run, SECOND)


async def test_a_run_that_waits_is_taken_by_one_node(nodes: Nodes) -> None:
    """Many nodes that have room ask at the same moment; its owner lives."""
    run = await nodes.add_run(FIRST, "queued")
    takes = [
        nodes.nodes[number % 2].take(run.run_id, name, 1, STATES_WITH_CAPACITY)
        for number, name in enumerate(["first", "second"] * 8)
    ]
    assert sorted(await asyncio.gather(*takes)) == [False] * 15 + [True]
    (seen,) = (await nodes.nodes[0].queue([run.run_id])).left
    assert seen.fence == 2
    stored = await nodes.stores[0].load(run.run_id)
    assert stored is not None
    assert (stored.state, stored.owner) == ("ready", seen.owner)
    run.state = "ready"
    with pytest.raises(OwnershipLost):
        await nodes.stores[0].save(run)


@pytest.mark.parametrize("state", ["ready", "running", "stopped"])
async def test_a_run_that_does_not_wait_is_not_taken(
    state: State, nodes: Nodes
) -> None:
    run = await nodes.add_run(FIRST, state)
    assert not await nodes.nodes[1].take(run.run_id, "second", 1, STATES_WITH_CAPACITY)
    queue = await nodes.nodes[1].queue([run.run_id])
    assert queue.queued == []
    assert [(one.owner, one.fence) for one in queue.left] == [("first", 1)]


async def test_a_node_takes_nothing_that_changed_since_it_was_seen(
    nodes: Nodes,
) -> None:
    run = await nodes.add_run(FIRST, "queued")
    second = nodes.nodes[1]
    assert not await second.take(run.run_id, "second", 0, STATES_WITH_CAPACITY)
    assert not await second.take(
        run.run_id, "third", 1, STATES_WITH_CAPACITY
    )  # not in the list
    await nodes.stores[0].delete(run, time.time())
    assert not await second.take(run.run_id, "second", 1, STATES_WITH_CAPACITY)
    queue = await second.queue([run.run_id])
    assert (queue.queued, queue.left) == ([], [])


async def test_a_run_that_is_held_is_taken_when_its_owner_lets_it_go(
    nodes: Nodes,
) -> None:
    """Only the owner, whose clock began to count, knows when that is over."""
    run = await nodes.add_run(FIRST, "queued", queue_until_wall=1.0)
    second = nodes.nodes[1]
    assert not await second.take(run.run_id, "second", 1, STATES_WITH_CAPACITY)
    await second.let_go([run.run_id], "second")
    assert not await second.take(run.run_id, "second", 1, STATES_WITH_CAPACITY)
    await nodes.nodes[0].let_go([run.run_id], "first")
    assert await second.take(run.run_id, "second", 1, STATES_WITH_CAPACITY)


async def test_a_run_that_was_resumed_is_not_taken(nodes: Nodes) -> None:
    """Its owner knows the sessions that it had."""
    run = await nodes.add_run(FIRST, "queued")
    for state in ("stopped", "queued"):
        run.state = state
        run.updated_at_wall += 1.0
        await nodes.stores[0].save(run)
    second = nodes.nodes[1]
    assert [one.is_new for one in (await second.queue([])).queued] == [False]
    assert not await second.take(run.run_id, "second", 1, STATES_WITH_CAPACITY)


async def test_a_member_takes_only_while_it_claims(
    monkeypatch: pytest.MonkeyPatch, nodes: Nodes
) -> None:
    """If the answer is lost, the run is looked for, as after any claim."""
    adopted: list[str] = []
    node = nodes.nodes[1]
    member = await member_of(nodes, adopted.append)
    run = await nodes.add_run(FIRST, "queued")
    assert await member.find_other(run.run_id, only_reads=False) == FIRST
    with monkeypatch.context() as patch:
        lose_answers(patch, node, "take")
        with pytest.raises(StoreFailed):
            await member.take(run.run_id, 1)
    await member._claim_abandoned()
    assert adopted == [run.run_id]
    assert not await member.take(run.run_id, 2)  # it waits no more
    later = await nodes.add_run(FIRST, "queued", run_id="run_later")
    assert await member.find_other(later.run_id, only_reads=False) == FIRST
    assert await member.take(later.run_id, 1)
    assert await member.find_other(later.run_id, only_reads=False) is None
    member.stop_claiming()
    last = await nodes.add_run(FIRST, "queued", run_id="run_last")
    assert not await member.take(last.run_id, 1)


async def test_runs_are_opened_up_to_the_quota_at_all_nodes(nodes: Nodes) -> None:
    """Resumes of stopped runs are stored at the same moment; room is for three."""
    usage = AccountUsage(Quota(open_runs=3))
    runs = []
    for number in range(10):
        run = calibration_run(run_id=f"run_{number}", state="stopped")
        assert await nodes.stores[0].insert(run, None, "")
        run.state = "queued"
        runs.append(run)
    saves = [
        nodes.stores[number % 2].save(run, usage.check_opened)
        for number, run in enumerate(runs)
    ]
    done = await asyncio.gather(*saves, return_exceptions=True)
    refused = [one for one in done if isinstance(one, Refused)]
    assert [one.code for one in refused] == ["quota_exceeded"] * 7
    assert len((await nodes.nodes[0].queue([])).queued) == 3


@pytest.mark.parametrize(
    ("timelines", "is_kept"),
    [(["", ""], True), (["1", "1"], True), (["1", "2"], False)],
)
async def test_a_node_reads_its_runs_again_when_the_database_went_back(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, timelines: list[str], is_kept: bool
) -> None:
    """A standby was promoted: what its runs were in memory may never have happened."""
    async with opened(UsedDatabase.of_file(tmp_path / "d.sqlite")) as nodes:
        store, lost = nodes.nodes[0], []

        def renewed(_connection: Any) -> Renewed:
            return Renewed(timelines[0])

        monkeypatch.setattr(store, "_renewed", renewed)
        member = await member_of(
            nodes, on_lost=lambda: lost.append("lost"), store=store, lease_s=0.0
        )
        node_id = member.node_id
        await member.ensure_lease()
        assert not lost
        timelines.pop(0)
        await member.ensure_lease()
        assert (member.node_id == node_id, not lost) == (is_kept, is_kept)
        assert node_id in await live(store) or not is_kept
        await member.ensure_lease()  # once for each change
        assert len(lost) <= 1
        assert member.node_id in await live(store)


async def test_a_read_is_confirmed_by_a_renewal_that_begins_behind_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """One that has begun before may not wait for the commit of what was read."""
    async with opened(UsedDatabase.of_file(tmp_path / "d.sqlite")) as nodes:
        member = await member_of(nodes, store=nodes.nodes[0])
        began, gate, right = 0, asyncio.Event(), nodes.nodes[0].renew

        async def renew(node_id: str, settings: str) -> Renewed | None:
            nonlocal began
            began += 1
            await gate.wait()
            return await right(node_id, settings)

        monkeypatch.setattr(nodes.nodes[0], "renew", renew)
        first = asyncio.ensure_future(member._renew())
        await asyncio.sleep(0)
        both = asyncio.gather(member.confirm(), member.confirm())
        gate.set()
        await asyncio.gather(first, both)
        assert began == 2
        gate.clear()
        late = asyncio.ensure_future(member.confirm())
        removed = node_rows.delete()
        await nodes.stores[0].transactions.write_in_turn(lambda c: c.execute(removed))
        gate.set()
        with pytest.raises(StoreFailed, match="lost its runs"):
            await late


@pytest.mark.slow("PostgreSQL")
async def test_postgresql_names_its_timeline_to_who_may_ask(
    postgresql: PostgresqlServer,
) -> None:
    url = postgresql.create()
    used = UsedDatabase(url, server=postgresql)
    async with opened(used) as nodes:
        renewed = await nodes.nodes[0].renew("first")
        assert renewed is not None
        assert int(renewed.timeline, 16) == 1
    for statement in (
        "CREATE ROLE plain LOGIN PASSWORD 'plain'",
        "GRANT ALL ON ALL TABLES IN SCHEMA public TO plain",
        "REVOKE EXECUTE ON FUNCTION pg_current_wal_lsn() FROM PUBLIC",
    ):
        postgresql.execute(used.name, statement, "SELECT 1")
    plain = Store(url.replace("postgres:of-tests", "plain:plain"), is_shared=True)
    try:
        assert await NodeStore(plain, LEASE_S).join(THIRD) == Renewed("")
    finally:
        await plain.close()
