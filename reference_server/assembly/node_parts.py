"""A server as one of several nodes that share a database and a folder of recordings."""

from __future__ import annotations

import hmac
from dataclasses import dataclass
from pathlib import Path

from reference_server.assembly.run_parts import Secrets
from reference_server.cluster.server_node import ServerNode
from reference_server.cluster.settings_comparison import TOKENS, SettingsComparison
from reference_server.http.auth import Tokens
from reference_server.http.handlers import SOFTWARE_VERSION
from reference_server.process.lifespan import end_server
from reference_server.records.run_records import RunRecords
from reference_server.records.shared_folder import (
    ACCOUNTS,
    HOST,
    KEY,
    RECORDINGS,
    SEALING,
    SEEDS,
    VERSION,
    check_shared,
    show_node,
)
from reference_server.settings import Settings
from reference_server.settings.cluster_settings import OF_EACH_NODE
from reference_server.storage.node_store import NodeStore
from reference_server.storage.runs.run_store import Store, StoreFailed
from reference_server.storage.tables.database_tables import LEASE
from reference_sim import benchmark_registry


@dataclass(frozen=True, slots=True)
class _Shared:
    """All that this node must have in common with the others.

    records: None without recordings; the nodes share their database and secrets then.
    """

    nodes: NodeStore
    url: str
    settings: Settings
    secrets: Secrets
    records: RunRecords | None

    def announce(self, node_id: str) -> None:
        """Show in the folder of recordings that this node uses it."""
        folder = shared_folder(self.settings)
        if folder is not None:
            show_node(folder, node_id)

    async def check(self) -> None:
        """Compare once more: nodes that started at one moment did not see each other.

        Raises StoreFailed and NodeRefused.
        """
        keyid = None if self.records is None else self.records.key.keyid
        try:
            await compare_node(self.nodes, self.url, self.settings, self.secrets, keyid)
        except OSError as error:
            raise StoreFailed(f"the folder of recordings: {error}") from error
        if self.records is not None:
            await self.records.use_key()


def shared_folder(settings: Settings) -> Path | None:
    """The folder of recordings that all nodes share, if they share one."""
    is_shared = settings.recordings != "off" and not settings.records_storage
    return settings.records_path if is_shared else None


async def compare_node(
    nodes: NodeStore, url: str, settings: Settings, secrets: Secrets, keyid: str | None
) -> None:
    """Compare what must be equal on all nodes.

    url: of this node. secrets: opened. keyid: of the key that signs; None without
    recordings. Raises NotShared, StoreFailed and OSError.
    """
    seeds, sealing = secrets.seeds.value, secrets.policy_keys
    facts = {
        SEEDS: hmac.digest(seeds, SEEDS.encode(), "sha256").hex(),
        SEALING: sealing.digest(SEALING),
        LEASE: str(settings.node_lease_s),
        RECORDINGS: "off" if keyid is None else "on",
        VERSION: SOFTWARE_VERSION,
        ACCOUNTS: "accepted" if settings.account_service else "not accepted",
    }
    folder = None
    if keyid is not None:
        facts |= {KEY: keyid, HOST: settings.host_name}
        folder = settings.records_path
    storage = settings.records_storage
    await check_shared(nodes, url, facts, folder, storage=storage)


def make_node(
    settings: Settings,
    store: Store,
    secrets: Secrets,
    tokens: Tokens,
    records: RunRecords | None,
) -> ServerNode | None:
    """The node of this server; None if the server has the database for itself."""
    if settings.cluster == "off":
        return None
    nodes = NodeStore(store, settings.node_lease_s)
    url = settings.node_url or f"http://{settings.host}:{settings.port}"
    shared = _Shared(nodes, url, settings, secrets, records)
    return ServerNode(
        nodes,
        url,
        settings.node_lease_s,
        announce=shared.announce,
        on_joined=shared.check,
        settings=_comparison_of(settings, secrets, tokens),
        end_server=end_server,
    )


def _comparison_of(
    settings: Settings, secrets: Secrets, tokens: Tokens
) -> SettingsComparison:
    values = {
        name: str(getattr(settings, name))
        for name in Settings.model_fields
        if name not in OF_EACH_NODE
    }
    values["benchmarks"] = ", ".join(sorted(benchmark_registry.own_references()))

    def read() -> dict[str, str]:
        return {**values, TOKENS: secrets.policy_keys.digest(tokens.digest)}

    return SettingsComparison(read)
