"""Routes of a node in a cluster, and the forwarding of operations to other nodes.

A request that names a run is answered by the node that has the run. Each node has paths
for the others, too: views of its runs, commands for them, and the queue of all.
"""

from __future__ import annotations

from collections.abc import Mapping

from starlette.types import ASGIApp

from reference_record.generated import answers
from reference_server.cluster import shared_queue
from reference_server.cluster.forwarding import (
    PageForwarding,
    RunForwarding,
    TurnForwarding,
)
from reference_server.cluster.requests import owner_commands, views_elsewhere
from reference_server.cluster.server_node import ServerNode
from reference_server.cluster.shared_queue import SharedQueue
from reference_server.http.application import Endpoint
from reference_server.runs.service import RunService


class NodeRoutes:
    """The paths of one node, over the use cases of its server."""

    def __init__(
        self, node: ServerNode, queue: SharedQueue, service: RunService
    ) -> None:
        self._node, self._queue, self._service = node, queue, service
        node.act_for(service.registry.admission)

    def routed(self, endpoints: Mapping[str, ASGIApp]) -> dict[str, ASGIApp]:
        """The same paths, each answered by the node that has the run it names."""
        node, service = self._node, self._service
        routed: dict[str, ASGIApp] = {
            path: self._forwarding(endpoint) for path, endpoint in endpoints.items()
        }
        return routed | {
            views_elsewhere.PATH: node.views.answered_by(self._view_run),
            owner_commands.PATH: node.commands.answered_by(service.command_run_here),
            shared_queue.PATH: self._queue.endpoint(),
        }

    def turns(self, endpoint: Endpoint) -> TurnForwarding:
        """The turns, without the router: those of runs of this node."""
        node, has_run = self._node, self._service.registry.has
        forwarding = self._forwarding(endpoint)
        return TurnForwarding(endpoint, forwarding, node.membership, has_run)

    def _forwarding(self, endpoint: ASGIApp) -> RunForwarding:
        has_run = self._service.registry.has
        return RunForwarding(endpoint, self._node.connections, has_run)

    def routed_pages(self, pages: ASGIApp, away: ASGIApp) -> ASGIApp:
        """The pages, each answered by the node where its reader has signed in.

        away: answers in place of that node, when it does not.
        """
        return PageForwarding(pages, away, self._node.connections)

    async def _view_run(self, run_id: str, endpoint: str) -> answers.Run:
        return await self._service.view_run(None, run_id, endpoint)
