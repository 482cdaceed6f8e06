"""This server as a node: its lease, and its way to the other nodes.

It is there before any run is: what other nodes ask this one, which needs the runs, is
answered by `node_routes.py`.
"""

from __future__ import annotations

import logging
from collections.abc import Awaitable, Callable
from typing import Protocol

from starlette.types import Scope

from reference_server.cluster.membership import Membership
from reference_server.cluster.node_connections import NodeConnections
from reference_server.cluster.node_headers import has_secret_of
from reference_server.cluster.requests.owner_commands import OwnerCommands
from reference_server.cluster.requests.views_elsewhere import ViewsElsewhere
from reference_server.cluster.settings_comparison import SettingsComparison
from reference_server.rules.run_owner import NodeRefused
from reference_server.storage.node_store import NodeStore
from reference_server.storage.runs.run_store import StoreFailed

log = logging.getLogger("proctor.cluster")


class OwnedRuns(Protocol):
    """The runs of this node, as far as their ownership changes."""

    def drop_all(self) -> None:
        """This node lost its runs; awaits nothing."""

    def adopt(self, run_id: str) -> None:
        """This node has claimed an open run, with which nothing else goes on."""


class ServerNode:
    """From `open` to `close` a node, which claims runs without an owner.

    url: where other nodes reach it. announce: as of Membership. on_joined: is called
    when the others see this node, and before it acts for a run; it may raise
    StoreFailed, and NodeRefused. If it refuses a node that has joined again, end_server
    is called. settings: are shown to the others.
    """

    def __init__(
        self,
        nodes: NodeStore,
        url: str,
        lease_s: float,
        *,
        announce: Callable[[str], None],
        on_joined: Callable[[], Awaitable[None]],
        settings: SettingsComparison,
        end_server: Callable[[], None],
    ) -> None:
        self.nodes = nodes
        self._on_joined, self._end_server = on_joined, end_server
        self._refused: str | None = None
        self._runs: list[OwnedRuns] = []
        self.membership = Membership(
            nodes,
            url,
            lease_s,
            on_lost=self._drop_all,
            adopt=self._adopt,
            announce=announce,
            on_joined_again=self._check_again,
            settings=settings,
        )
        self.connections = NodeConnections(self.membership)
        self.views = ViewsElsewhere(self.connections)
        self.commands = OwnerCommands(self.connections)

    def act_for(self, runs: OwnedRuns) -> None:
        """Inform these runs of what becomes of their ownership, from now on."""
        self._runs.append(runs)

    def is_passed_on(self, scope: Scope) -> bool:
        """Whether another node passed the request on to this one."""
        return has_secret_of(self.membership, scope)

    def node_id(self) -> str:
        """The id that this node has now."""
        return self.membership.node_id

    def _drop_all(self) -> None:
        for runs in self._runs:
            runs.drop_all()

    def _adopt(self, run_id: str) -> None:
        for runs in self._runs:
            runs.adopt(run_id)

    async def _check_again(self) -> None:
        """Nodes that started meanwhile may have agreed on something else."""
        if self._refused is None:
            try:
                await self._on_joined()
            except NodeRefused as refused:
                self._refused = str(refused)
                log.error("the server ends: %s", refused)  # noqa: TRY400 - no defect
                self._end_server()  # once: a second signal would end it at once
        if self._refused is not None:
            raise StoreFailed(self._refused)

    async def open(self) -> None:
        """Join the nodes, when all other parts are open.

        Raises StoreFailed and NodeRefused.
        """
        await self.membership.open()
        try:
            await self._on_joined()
        except BaseException:
            await self.membership.close()
            raise
        self.membership.start()

    async def close(self) -> None:
        """After the last write: others may claim the runs at once."""
        await self.connections.close()
        await self.membership.close()
