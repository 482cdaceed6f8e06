"""Settings of recordings, of the records that are signed, and of public access."""

from __future__ import annotations

from pathlib import Path
from typing import Literal

from pydantic import Field

from reference_server.settings.database_settings import DatabaseSettings


class RecordSettings(DatabaseSettings):
    """Settings of recordings, of the records that are signed, and of public access."""

    recordings: Literal["off", "actions", "pictures"] = Field(
        "actions",
        description="What is recorded of episodes. actions: what was executed, with "
        "rewards, digests of the simulator's state, faults and attempts. pictures: the "
        "images, too, as JPEG; without, they can be rendered again from the actions.",
    )
    failover: Literal["end", "replay"] = Field(
        "end",
        description="How a restart, or in a cluster another node, treats the "
        "sessions of a server that has ended. end: they have ended, and workers attach "
        "again. replay: the recorded actions of each attempt in play are executed "
        "again, states are compared, and the session goes on at the same turn; where "
        "they differ, or the benchmark is not deterministic, it has ended. Needs "
        "recordings.",
    )
    records_dir: str = Field(
        "",
        description="Folder of the recordings; created if missing. If empty, a folder "
        "next to the SQLite file; with PostgreSQL, var/records.",
    )
    records_storage: str = Field(
        "",
        pattern=r"^((s3|gs|az|file)://\S+)?$",
        description="Object storage in which finished recordings and records that were "
        "handed in are kept, such as s3://BUCKET/PREFIX; records_dir is then a folder "
        "of this machine alone. A result counts once its recording is stored there. "
        "Endpoint and credentials are those of the environment, such as "
        "AWS_ENDPOINT_URL and AWS_ACCESS_KEY_ID. Needs the extra `storage`.",
    )
    record_promise: Literal["exact", "outcome"] = Field(
        "outcome",
        description="What records promise of a replay with the same software on the "
        "same kind of machine: equal states after each turn, or equal results.",
    )
    signing_key: str = Field(
        "",
        description="File with the key that signs records; created if missing. If "
        "empty, a file next to the SQLite file; with PostgreSQL "
        "var/postgresql.signing-key.",
    )
    records_keep_days: float = Field(
        0,
        ge=0,
        allow_inf_nan=False,
        description="Days after which the recordings of a run that has ended are "
        "removed; 0 keeps them.",
    )
    public_board: Literal["off", "on"] = Field(
        "off",
        description="Whether the leaderboard can be read without a token: public "
        "entries, rankings and the history.",
    )

    @property
    def records_path(self) -> Path:
        """The folder of the recordings; `recordings` says whether there are any."""
        if self.records_dir:
            return Path(self.records_dir)
        return self.database_folder / self.records_name

    @property
    def records_name(self) -> str:
        """The name of that folder beside the database."""
        is_file = "://" not in self.database
        return f"{self.database_name}.records" if is_file else "records"

    @property
    def signing_key_path(self) -> Path:
        """The file of the key that signs records."""
        if self.signing_key:
            return Path(self.signing_key)
        return self._beside_database("signing-key")
