"""A server as one of several nodes that share a database and a folder of recordings."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from reference_server.cluster.server_node import ServerNode
from reference_server.process.lifespan import end_server
from reference_server.records.run_records import RunRecords
from reference_server.records.shared_folder import check_shared, show_node
from reference_server.settings import Settings
from reference_server.storage.node_store import NodeStore
from reference_server.storage.runs.run_store import Store, StoreFailed


@dataclass(frozen=True, slots=True)
class _SharedRecords:
    """The folder of recordings and the key of records, which all nodes share."""

    nodes: NodeStore
    url: str
    folder: Path
    records: RunRecords
    host_name: str
    storage: str

    def announce(self, node_id: str) -> None:
        """Show in the folder that this node uses it."""
        if not self.storage:
            show_node(self.folder, node_id)

    async def check(self) -> None:
        """Compare once more: nodes that started at one moment did not see each other.

        Raises StoreFailed and NodeRefused.
        """
        keyid = self.records.key.keyid
        try:
            await check_shared(
                self.nodes,
                self.url,
                self.folder,
                keyid,
                self.host_name,
                storage=self.storage,
            )
        except OSError as error:
            raise StoreFailed(f"the folder of recordings: {error}") from error
        await self.records.use_key()


class _NothingShared:
    """Without recordings the nodes share the database alone."""

    def announce(self, node_id: str) -> None:
        """There is no folder to show that in."""

    async def check(self) -> None:
        """There is nothing to compare."""


def make_node(
    settings: Settings, store: Store, records: RunRecords | None
) -> ServerNode | None:
    """The node of this server; None if the server has the database for itself."""
    if settings.cluster == "off":
        return None
    nodes = NodeStore(store, settings.node_lease_s)
    url = settings.node_url or f"http://{settings.host}:{settings.port}"
    shared: _SharedRecords | _NothingShared = _NothingShared()
    if records is not None and settings.records_path is not None:
        folder, host_name = settings.records_path, settings.host_name
        shared = _SharedRecords(
            nodes, url, folder, records, host_name, settings.records_storage
        )
    return ServerNode(
        nodes,
        url,
        settings.node_lease_s,
        announce=shared.announce,
        on_joined=shared.check,
        end_server=end_server,
    )
