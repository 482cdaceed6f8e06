"""The server as one of several nodes."""

from __future__ import annotations

from typing import Literal

from pydantic import BaseModel, Field


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
        description="Cluster: base URL at which the other nodes reach this one. If "
        "empty, host and port.",
    )
    node_lease_s: float = Field(
        2.0,
        ge=0.5,
        le=600,
        description="Cluster: time after which the runs of a node that does not reach "
        "the database are taken over by the others.",
    )
