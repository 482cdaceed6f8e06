"""How the runs of other nodes are shown in lists: as their owners show them.

The database does not contain the sessions of a run that is played. So a node that lists
runs asks each owner once for all of its runs on the page.
"""

from __future__ import annotations

import asyncio
from collections import defaultdict
from collections.abc import Awaitable, Callable, Mapping, Sequence
from functools import partial

import msgspec
from starlette.types import ASGIApp

from reference_record.generated.answers import Run
from reference_server.cluster.node_connections import NodeConnections
from reference_server.cluster.requests.node_requests import NodeRequests
from reference_server.rules.refusal import Refused
from reference_server.rules.runs.run import RunHead
from reference_server.storage.runs.run_store import StoreFailed

PATH = "/node/views"
# A page has a thousand at most; what is not shown in time is shown as it is stored.
TIMEOUT_S = 1.0

# (run id, endpoint) → schema Run.
ViewRun = Callable[[str, str], Awaitable[Run]]


class _Page(msgspec.Struct):
    """A request of one node to another for views: of these runs, at that endpoint."""

    endpoint: str
    run_ids: list[str]


class ViewsElsewhere:
    """Gets the views of runs of other nodes, and shows this node's runs to them."""

    def __init__(self, connections: NodeConnections) -> None:
        self._membership = connections.membership
        self._requests = NodeRequests(
            connections,
            PATH,
            question_type=_Page,
            answer_type=dict[str, Run],
            timeout_s=TIMEOUT_S,
        )

    async def fetch(self, runs: Sequence[RunHead], endpoint: str) -> Mapping[str, Run]:
        """Schema Run by id, of those runs that their owners show now."""
        by_owner: dict[str, list[str]] = defaultdict(list)
        for run in runs:
            by_owner[run.owner or ""].append(run.run_id)
        views_by_id: dict[str, Run] = {}
        asked = [
            self._fetch_of(*owner_and_ids, endpoint)
            for owner_and_ids in by_owner.items()
        ]
        for views in await asyncio.gather(*asked):
            views_by_id |= views
        return views_by_id

    async def _fetch_of(
        self, node_id: str, run_ids: list[str], endpoint: str
    ) -> dict[str, Run]:
        node = await self._membership.find_node(node_id)
        if node is None:
            return {}
        return await self._requests.ask(node, _Page(endpoint, run_ids)) or {}

    def answered_by(self, view_run: ViewRun) -> ASGIApp:
        """The endpoint for other nodes.

        view_run: of a run of this node; raises Refused and StoreFailed.
        """
        return self._requests.answered_by(partial(_view_page, view_run))


async def _view_page(view_run: ViewRun, page: _Page) -> dict[str, Run]:
    """The answer to another node."""
    views = {}
    for run_id in page.run_ids:
        try:
            views[run_id] = await view_run(run_id, page.endpoint)
        except (Refused, StoreFailed):
            continue  # deleted, or lost meanwhile
        await asyncio.sleep(0)  # others are served between two runs
    return views
