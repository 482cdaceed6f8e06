"""How the runs of other nodes are shown in lists: as their owners show them.

What is stored of a run in play says nothing of its sessions. So a node that lists runs
asks each owner once for all of its runs on the page. The path for that answers nodes
alone.
"""

from __future__ import annotations

import asyncio
from collections import defaultdict
from collections.abc import Awaitable, Callable, Mapping, Sequence
from typing import Any

import msgspec
from starlette.requests import Request
from starlette.responses import Response
from starlette.types import Receive, Scope, Send

from reference_server.cluster.forwarding import NodeConnections, is_from_node
from reference_server.http.problems import problem_response
from reference_server.rules.refusal import Refused
from reference_server.rules.run import RunHead
from reference_server.storage.node_store import Node
from reference_server.storage.store import StoreFailed

PATH = "/node/views"
# A page has a thousand at most; what is not shown in time is shown as it is stored.
TIMEOUT_S = 1.0

Json = dict[str, Any]
# (run id, endpoint) → schema Run.
ViewRun = Callable[[str, str], Awaitable[Json]]


class ViewsElsewhere:
    """Shows this node's runs to others, and gets the views of theirs.

    view_run: of a run of this node; raises Refused and StoreFailed.
    """

    def __init__(self, connections: NodeConnections, view_run: ViewRun) -> None:
        self._connections, self._view_run = connections, view_run

    async def fetch(self, runs: Sequence[RunHead], endpoint: str) -> Mapping[str, Json]:
        """Schema Run by id, of those runs that their owners show now."""
        by_owner: dict[str, list[str]] = defaultdict(list)
        for run in runs:
            by_owner[run.owner or ""].append(run.run_id)
        found: dict[str, Json] = {}
        asked = [self._fetch_of(*one, endpoint) for one in by_owner.items()]
        for views in await asyncio.gather(*asked):
            found |= views
        return found

    async def _fetch_of(
        self, node_id: str, run_ids: list[str], endpoint: str
    ) -> dict[str, Json]:
        node = await self._connections.membership.find_node(node_id)
        if node is None:
            return {}
        asked = {"endpoint": endpoint, "run_ids": run_ids}
        body = await self._post(node, msgspec.json.encode(asked))
        return {} if body is None else msgspec.json.decode(body, type=dict[str, Json])

    async def _post(self, node: Node, body: bytes) -> bytes | None:
        try:
            async with asyncio.timeout(TIMEOUT_S):
                return await self._connections.post(node, PATH, body)
        except TimeoutError:
            return None

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """The answer to another node."""
        try:
            response = await self._answer(scope, receive)
        except Refused as refused:
            response = problem_response(refused)
        await response(scope, receive, send)

    async def _answer(self, scope: Scope, receive: Receive) -> Response:
        membership = self._connections.membership
        if scope["method"] != "POST" or not is_from_node(scope, membership):
            raise Refused("not_found", "Unknown path.")
        asked = msgspec.json.decode(await Request(scope, receive).body())
        views = await self._views(asked["run_ids"], asked["endpoint"])
        return Response(msgspec.json.encode(views))

    async def _views(self, run_ids: Sequence[str], endpoint: str) -> dict[str, Json]:
        views = {}
        for run_id in run_ids:
            try:
                views[run_id] = await self._view_run(run_id, endpoint)
            except (Refused, StoreFailed):
                continue  # deleted, or lost meanwhile
            await asyncio.sleep(0)  # others are served between two runs
        return views
