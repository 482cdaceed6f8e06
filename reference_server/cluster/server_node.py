"""This server as a node: the parts of this folder, connected."""

from __future__ import annotations

import logging
from collections.abc import Awaitable, Callable, Mapping
from typing import Any

from starlette.types import ASGIApp, Scope

from reference_server.cluster.forwarding import PageForwarding, RunForwarding
from reference_server.cluster.membership import Membership
from reference_server.cluster.node_connections import NodeConnections
from reference_server.cluster.node_headers import has_secret_of
from reference_server.cluster.owner_commands import OwnerCommands
from reference_server.cluster.shared_queue import SharedQueue
from reference_server.cluster.views_elsewhere import ViewsElsewhere
from reference_server.rules.run_owner import NodeRefused
from reference_server.runs.service import RunCommand, RunService
from reference_server.storage.node_store import NodeStore
from reference_server.storage.store import StoreFailed

log = logging.getLogger("proctor.cluster")


class ServerNode:
    """From `open` to `close` a node, which claims runs without an owner.

    url: where other nodes reach it. service: once the server is put together.
    announce: as of Membership. on_joined: is called when the others see this node, and
    before it acts for a run; it may raise StoreFailed, and NodeRefused. If it refuses a
    node that has joined again, end_server is called.
    """

    def __init__(
        self,
        nodes: NodeStore,
        url: str,
        lease_s: float,
        service: Callable[[], RunService],
        *,
        announce: Callable[[str], None],
        on_joined: Callable[[], Awaitable[None]],
        end_server: Callable[[], None],
    ) -> None:
        self._service, self._on_joined = service, on_joined
        self._end_server = end_server
        self._refused: str | None = None
        self.membership = Membership(
            nodes,
            url,
            lease_s,
            on_lost=self._forget_runs,
            adopt=self._adopt,
            announce=announce,
            on_joined_again=self._check_again,
        )
        self._connections = NodeConnections(self.membership)
        self.views = ViewsElsewhere(self._connections, self._view_run)
        self.commands = OwnerCommands(self._connections, self._command_run)
        self.queue = SharedQueue(
            nodes, self._connections, lambda: service().registry.admission
        )

    def routed(self, endpoints: Mapping[str, ASGIApp]) -> dict[str, ASGIApp]:
        """The same paths, each answered by the node that has the run it names."""
        has_run = self._service().registry.has
        routed: dict[str, ASGIApp] = {
            path: RunForwarding(endpoint, self._connections, has_run)
            for path, endpoint in endpoints.items()
        }
        for requests in (
            self.views.requests,
            self.commands.requests,
            self.queue.requests,
        ):
            routed[requests.path] = requests
        return routed

    def routed_pages(self, pages: ASGIApp, away: ASGIApp) -> ASGIApp:
        """The pages, each answered by the node where its reader has signed in.

        away: answers in place of that node, when it does not.
        """
        return PageForwarding(pages, away, self._connections)

    def is_passed_on(self, scope: Scope) -> bool:
        """Whether another node passed the request on to this one."""
        return has_secret_of(self.membership, scope)

    def node_id(self) -> str:
        """Of this node, now."""
        return self.membership.node_id

    def _forget_runs(self) -> None:
        self._service().registry.admission.drop_all()

    def _adopt(self, run_id: str) -> None:
        self._service().registry.writer.load_in_background(run_id)

    async def _view_run(self, run_id: str, endpoint: str) -> dict[str, Any]:
        return await self._service().view_run(None, run_id, endpoint)

    async def _command_run(
        self, command: RunCommand, account: str, run_id: str
    ) -> None:
        await self._service().command_run_here(command, account, run_id)

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
        self.queue.open()

    async def close(self) -> None:
        """After the last write: others may claim the runs at once."""
        await self.queue.close()
        await self._connections.close()
        await self.membership.close()
