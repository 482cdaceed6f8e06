"""This process as a node: its lease, the other nodes, and runs without an owner.

A node renews its lease in the database several times before it ends. While the lease
runs, no other node claims its runs. When it has ended, this node acts for no run until
it is renewed; if others removed it meanwhile, it forgets its runs and joins again under
another id. Time here is only for that: that a lease of another node has ended is said
by the database's clock. It knows no HTTP, and no SQL.
"""

from __future__ import annotations

import asyncio
import contextvars
import hmac
import logging
import secrets
import time
from collections import OrderedDict
from collections.abc import Awaitable, Callable
from typing import Any

from reference_server.cluster.settings_comparison import SettingsComparison
from reference_server.process.background_work import shielded
from reference_server.rules.run_owner import (
    RENEWALS_PER_LEASE,
    OwnedElsewhere,
    StoredOwner,
    is_dead,
    looks_silent,
    place_of,
)
from reference_server.rules.runs.lifecycle import (
    OPEN_STATES,
    RESTART_REASON,
    STATES_AFTER_RESTART,
    STATES_WITH_CAPACITY,
)
from reference_server.storage.node_store import ListedNode, Node, NodeStore, Renewed
from reference_server.storage.runs.run_store import StoreFailed
from reference_server.telemetry.repeated_failures import RepeatedFailures

log = logging.getLogger("proctor.cluster")

# Claimed at a time by one node, so that the others get their part of them.
CLAIMS_AT_ONCE = 50
# How long a request waits for a lease that is late; another node may have one.
LATE_LEASE_S = 5.0
# Longest pause between two searches for runs without an owner.
SWEEP_S = 1.0
# How often a node shows the others that it has what they share.
SHOW_S = 0.5
# A node that was not reached is looked for so often until its lease is over.
LOOKS_PER_LEASE = 20
# A run is claimed by one node: who loses finds its owner then.
TRIES = 5
KNOWN_OWNERS_MAX = 10_000
# A clock that runs while the machine sleeps, where the system has one.
_CLOCK = getattr(time, "CLOCK_BOOTTIME", time.CLOCK_MONOTONIC)


class Membership:
    """This node, from `open` to `close`.

    url: where other nodes reach this one. on_lost: forgets all runs of this node; it
    may await nothing. adopt: begins to load an open run that was claimed: nothing else
    goes on with it, and no other node looks for it any more. announce: is called with
    the id of this node before it joins with it, and then again and again, in a thread;
    raises StoreFailed. on_joined_again: is
    called when it has joined after others removed it; raises StoreFailed while it must
    not act for a run. settings: are shown to the other nodes.
    """

    def __init__(
        self,
        nodes: NodeStore,
        url: str,
        lease_s: float,
        on_lost: Callable[[], None],
        adopt: Callable[[str], None],
        *,
        announce: Callable[[str], None] = lambda _: None,
        on_joined_again: Callable[[], Awaitable[None]] | None = None,
        settings: SettingsComparison | None = None,
    ) -> None:
        self._nodes, self.lease_s = nodes, lease_s
        self._on_lost, self._adopt, self._announce = on_lost, adopt, announce
        self._on_joined_again = on_joined_again
        self._settings = settings or SettingsComparison(dict)
        self._node = _new_node(url, secrets.token_hex(32))
        self._claims = True
        self._has_joined = False  # with its id: until then it tries again with it
        self._valid_until = 0.0
        self._timeline = ""  # of the database, see Renewed
        self._renewing: asyncio.Task[None] | None = None
        self._tasks: list[asyncio.Task[Any]] = []
        self._others: dict[str, Node] = {}
        self._gone: dict[str, asyncio.Event] = {}
        self._ending: dict[str, asyncio.Task[bool]] = {}  # nodes that were not reached
        self._silent_since: dict[str, float] = {}  # node → as it was first seen so
        self._looked_at = 0.0
        self._owners: OrderedDict[str, str] = OrderedDict()  # run → node
        self._unsure: set[str] = set()  # runs whose claim may have been stored
        self._failures = RepeatedFailures(log)

    @property
    def node_id(self) -> str:
        """The id of this node; it gets another one after it was removed."""
        return self._node.node_id

    @property
    def secret(self) -> str:
        """The secret by which the other nodes prove to this one that they are nodes."""
        return self._node.secret

    def is_secret_of_other(self, secret: bytes) -> bool:
        """Whether it is what is sent to another node that this one knows."""
        secrets_of_nodes = [node.secret.encode() for node in self._others.values()]
        return any(
            hmac.compare_digest(secret, node_secret) for node_secret in secrets_of_nodes
        )

    async def open(self) -> None:
        """Join the nodes. Raises StoreFailed."""
        began = _now()
        await asyncio.to_thread(self._announce, self.node_id)
        settings = self._settings.text()
        renewed = await self._nodes.join(self._node, settings, is_new=True)
        self._take_lease(began, renewed)
        await self._look_for_others()

    def start(self) -> None:
        """Renew the lease, and claim runs that have no owner, until `close`."""
        renewal = self._repeat(self.lease_s / RENEWALS_PER_LEASE, self._keep_lease)
        sweep = self._repeat(min(SWEEP_S, self.lease_s / 2), self._claim_abandoned)
        show = self._repeat(SHOW_S, self._show, "a node does not show that it lives")
        self._tasks = [asyncio.create_task(work) for work in (renewal, sweep, show)]

    @property
    def claims(self) -> bool:
        """Whether it acts for more runs than it has."""
        return self._claims

    def stop_claiming(self) -> None:
        """The server will end: what it claimed now would be left again at once."""
        self._claims = False

    async def close(self) -> None:
        """Leave the nodes: others may claim the runs at once."""
        self._tasks += self._ending.values()
        for task in self._tasks:
            task.cancel()
        if self._renewing is not None:  # it might join again behind the end
            self._tasks.append(self._renewing)
        if self._tasks:
            await asyncio.wait(self._tasks)
        try:
            await self._nodes.leave(self.node_id)
        except StoreFailed as error:  # its lease ends
            log.warning("the node could not leave: %s", error)

    # --- the lease ---

    @property
    def has_lease(self) -> bool:
        """Whether this node may act for its runs now."""
        return _now() < self._valid_until

    async def ensure_lease(self) -> None:
        """Return while this node may act for its runs. Raises StoreFailed."""
        if self.has_lease:
            return
        try:
            async with asyncio.timeout(LATE_LEASE_S):
                await self._renew()
        except TimeoutError as error:
            raise StoreFailed("the lease of this node could not be renewed") from error

    async def _renew(self) -> None:
        """One renewal for all that wait for it."""
        if self._renewing is None or self._renewing.done():
            # Nothing that it logs belongs to the request that began it.
            self._renewing = asyncio.get_running_loop().create_task(
                self._renew_once(), context=contextvars.Context()
            )
        await shielded(self._renewing)

    async def confirm(self) -> None:
        """Return when what was read before is stored for good. Raises StoreFailed.

        A commit that waits for a standby can be seen by others as soon as it waits no
        more, and is lost if the standby is promoted then. A renewal that begins after
        the read waits behind such a commit.
        """
        node_id = self.node_id
        if self._renewing is not None and not self._renewing.done():
            await asyncio.wait([self._renewing])  # it began before
        await self._renew()
        if self.node_id != node_id:
            raise StoreFailed("this node has lost its runs meanwhile")

    async def _renew_once(self) -> None:
        began = _now()
        settings = self._settings.text()
        renewed = await self._nodes.renew(self.node_id, settings)
        if renewed is not None and renewed.timeline != self._timeline:
            log.warning(
                "the database has another history than before (a standby was promoted, "
                "or a backup restored): this node reads its runs again"
            )
            await self._nodes.leave(self.node_id)
            renewed = None
        elif renewed is None and self._has_joined:
            log.warning("other nodes have taken over the runs of this one")
        if renewed is None:
            if self._has_joined:
                self._node = _new_node(self._node.url, self._node.secret)
                self._owners.clear()
                self._on_lost()
                self._has_joined = False  # last: it is not tried again after that
            await asyncio.to_thread(self._announce, self.node_id)
            began = _now()
            renewed = await self._nodes.join(self._node, settings)
        if not self._has_joined and self._on_joined_again is not None:
            await self._on_joined_again()
        self._take_lease(began, renewed)

    def _take_lease(self, began: float, renewed: Renewed) -> None:
        self._has_joined = True
        self._timeline = renewed.timeline
        self._valid_until = began + self.lease_s

    async def _show(self) -> None:
        await asyncio.to_thread(self._announce, self.node_id)

    async def _keep_lease(self) -> None:
        await self._renew()
        await self._look_for_others()

    async def _look_for_others(self) -> dict[str, ListedNode]:
        asked_at = time.time()
        listed = await self._nodes.listed()
        if (me := listed.get(self.node_id)) is not None:
            self._settings.compare_clock(asked_at, me.read_at, time.time())
        now = _now()
        if self._is_blind(now):
            self._silent_since.clear()
        self._looked_at = now
        self._silent_since = {
            node_id: self._silent_since.get(node_id, now)
            for node_id, listed_node in listed.items()
            if looks_silent(listed_node.silent_s, self.lease_s)
        }
        others = {
            node_id: listed_node.node
            for node_id, listed_node in listed.items()
            if not self._is_dead(node_id, listed_node.silent_s)
        }
        for node_id in self._others.keys() - others.keys():
            if (gone := self._gone.pop(node_id, None)) is not None:
                gone.set()
        self._others = others
        self._settings.compare(listed[node_id] for node_id in others)
        return listed

    async def has_ended(self, node: Node) -> bool:
        """Whether the lease of a node that was not reached ends, as soon as it is over.

        False as soon as the node has renewed it. Raises StoreFailed.
        """
        watching = self._ending.get(node.node_id)
        if watching is None:
            # Nothing that it logs belongs to the request that began it.
            watching = self._ending[node.node_id] = (
                asyncio.get_running_loop().create_task(
                    self._watch_end(node), context=contextvars.Context()
                )
            )
            watching.add_done_callback(lambda _: self._ending.pop(node.node_id))
        return await shielded(watching)

    async def _watch_end(self, node: Node) -> bool:
        silent_s = 0.0
        while True:
            listed = (await self._look_for_others()).get(node.node_id)
            if listed is None or node.node_id not in self._others:
                return True
            if listed.silent_s < silent_s:
                return False
            silent_s = listed.silent_s
            await asyncio.sleep(self.lease_s / LOOKS_PER_LEASE)

    def _is_blind(self, now: float) -> bool:
        """Whether the database said nothing for so long that no node could renew."""
        return now - self._looked_at > self.lease_s

    def _is_dead(self, node_id: str, silent_s: float) -> bool:
        """Whether its runs may be claimed: it was seen silent more than once."""
        now = _now()
        since = self._silent_since.get(node_id)
        if since is None or self._is_blind(now):
            return False
        return is_dead(silent_s, now - since, self.lease_s)

    async def _repeat(
        self,
        every_s: float,
        work: Callable[[], Awaitable[None]],
        failure: str = "a node cannot use the database",
    ) -> None:
        while True:
            try:
                await work()
            except StoreFailed as error:
                self._failures.report(failure, str(error))
            except Exception:
                log.exception("a node failed in what it repeats")
            await asyncio.sleep(every_s)

    # --- owners of runs ---

    async def find_other(self, run_id: str, *, only_reads: bool) -> Node | None:
        """The node that acts for the run; None if it is this one, or there is no run.

        A run whose owner does not live any more is claimed first. Raises StoreFailed,
        and OwnedElsewhere if its owner cannot be found now.
        """
        last_owner = self._others.get(self._owners.get(run_id, ""))
        if last_owner is not None and not only_reads:
            return last_owner
        for _ in range(TRIES):
            owner = await self._nodes.owner_of(run_id)
            self._owners.pop(run_id, None)  # this is newer
            if owner is None:
                return None
            me = self.node_id
            place = place_of(owner, me, self.lease_s, only_reads=only_reads)
            if place == "here":
                return None
            if place == "forward":
                if (node := await self.find_node(owner.node_id or "")) is not None:
                    self._note_owner(run_id, node.node_id)
                    return node
            elif not self._may_claim(owner):
                break
            elif owner.silent_s is not None and owner.node_id is not None:
                await self._nodes.remove_silent(owner.node_id)
                await self._look_for_others()  # who waits for it waits no more
            elif await self._claim(run_id, me, owner):
                return None
        raise OwnedElsewhere(run_id)

    def _may_claim(self, owner: StoredOwner) -> bool:
        """Whether the owner of a run is silent for too long or no longer listed."""
        if not self._claims:
            return False
        if owner.node_id is None or owner.silent_s is None:
            return True
        return self._is_dead(owner.node_id, owner.silent_s)

    async def _claim(self, run_id: str, me: str, stored_owner: StoredOwner) -> bool:
        """Whether this node is the owner now, and no other one came first."""
        after = STATES_AFTER_RESTART
        try:
            if not await self._nodes.claim(
                run_id, me, stored_owner, after, RESTART_REASON
            ):
                return False
        except StoreFailed:
            self._unsure.add(run_id)
            raise
        log.info("node %s claimed run %s", me, run_id)
        if stored_owner.state in OPEN_STATES:
            self._adopt(run_id)
        return True

    async def take(self, run_id: str, fence: int) -> bool:
        """Let in a run that waits, at whichever node, as its owner; whether it worked.

        fence: of the run as it was seen. Raises StoreFailed.
        """
        if not self._claims:
            return False
        await self.ensure_lease()
        me = self.node_id
        try:
            after = STATES_WITH_CAPACITY
            is_taken = await self._nodes.take(run_id, me, fence, after)
        except StoreFailed:
            self._unsure.add(run_id)
            raise
        if is_taken:
            self._owners.pop(run_id, None)
            log.info("node %s took run %s, which waited", me, run_id)
        return is_taken

    @property
    def is_first(self) -> bool:
        """Whether this node does what one node has to do; two may, for a moment."""
        is_node = self._claims and self._has_joined
        return is_node and self.node_id <= min(self._others, default=self.node_id)

    def others(self) -> list[Node]:
        """The other nodes, as they were last seen."""
        return list(self._others.values())

    async def claim(self, run_id: str) -> bool:
        """Whether this node is the owner of the run now, or there is no run."""
        return await self.find_other(run_id, only_reads=False) is None

    def note_moved(self, run_id: str) -> None:
        """Another node has the run: the next look-up reads the database again."""
        self._owners.pop(run_id, None)

    async def forget_owner(self, run_id: str) -> None:
        """Forget the node that has the run, which was not reached; look for others."""
        self._owners.pop(run_id, None)
        await self._look_for_others()

    def gone(self, node: Node) -> asyncio.Event:
        """Is set when the lease of that node has ended."""
        if node.node_id in self._others:
            return self._gone.setdefault(node.node_id, asyncio.Event())
        event = asyncio.Event()
        event.set()
        return event

    async def find_node(self, node_id: str) -> Node | None:
        """The node, if its lease has not ended."""
        if node_id not in self._others:
            await self._look_for_others()
        return self._others.get(node_id)

    def _note_owner(self, run_id: str, node_id: str) -> None:
        self._owners[run_id] = node_id
        self._owners.move_to_end(run_id)
        if len(self._owners) > KNOWN_OWNERS_MAX:
            self._owners.popitem(last=False)

    async def _claim_abandoned(self) -> None:
        """Runs that a dead node leaves go on without a request for them."""
        if not self._claims:
            return
        await self.ensure_lease()
        await self._adopt_unsure()
        run_ids = await self._nodes.without_owner(sorted(OPEN_STATES), CLAIMS_AT_ONCE)
        for run_id in run_ids:
            # Otherwise an owner from before the dead node could be taken for the owner.
            self.note_moved(run_id)
            try:
                await self.claim(run_id)
            except OwnedElsewhere:
                log.debug("run %s was claimed by another node", run_id)

    async def _adopt_unsure(self) -> None:
        """No other node looks for a run that this one has claimed without knowing."""
        for run_id in list(self._unsure):
            owner = await self._nodes.owner_of(run_id)
            self._unsure.discard(run_id)
            if owner is None or owner.node_id != self.node_id:
                continue
            self._owners.pop(run_id, None)
            if owner.state in OPEN_STATES:
                self._adopt(run_id)


def _now() -> float:
    return time.clock_gettime(_CLOCK)


def _new_node(url: str, secret: str) -> Node:
    return Node(secrets.token_hex(8), url, secret)
