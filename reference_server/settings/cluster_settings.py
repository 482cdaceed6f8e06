"""The server as one of several nodes."""

from __future__ import annotations

from typing import Literal

from pydantic import BaseModel, Field

# Settings that nodes need not have equal: of their machines and addresses, files whose
# content counts, and what is compared before a node starts.
OF_EACH_NODE = {
    *("host", "port", "public_url", "trusted_proxies", "account_service"),
    *("node_url", "node_lease_s", "cluster", "database", "tokens", "tokens_file"),
    *("sealing_key", "seed_secret", "signing_key", "opened_seeds"),
    *("records_dir", "records_storage", "policy_sockets"),
    *("simulator", "simulators", "ray_resources"),
    *("max_simulators", "spare_simulators", "max_active_runs", "max_disk_bytes"),
    *("max_connections", "max_connections_per_address"),
    *("metrics", "metrics_host", "metrics_port"),
    *("traces", "traces_ratio", "traces_parent", "drain_s", "drain_notice_s"),
    *("log_level", "log_format", "access_log"),
}


class ClusterSettings(BaseModel):
    """The server as one of several nodes."""

    cluster: Literal["off", "on"] = Field(
        "off",
        description="Whether several servers share the database: each is a node that "
        "plays runs of its own, and passes requests for those of the others on. Needs "
        "equal settings on all nodes and, without an SQLite file, tokens, "
        "sealing_key and seed_secret; with recordings, signing_key and a folder "
        "records_dir that all nodes share, too.",
    )
    node_url: str = Field(
        "",
        pattern=r"^(http://[^\s/]{1,380})?$",
        description="Cluster: base URL at which the other nodes reach this one; it "
        "begins with http://, as nodes do not speak TLS. If empty, host and port.",
    )
    node_lease_s: float = Field(
        2.0,
        ge=0.5,
        le=600,
        description="Cluster: time after which the runs of a node that does not reach "
        "the database are taken over by the others.",
    )
