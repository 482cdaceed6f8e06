"""Settings, from flags and from the environment (`PROCTOR_…`); flags win.

Every field is a flag and a variable; its description is its documentation, from which
`docs/settings.md` is written.
"""

from __future__ import annotations

from pathlib import Path
from typing import Literal

from pydantic import Field, field_validator
from pydantic_settings import BaseSettings, SettingsConfigDict

from reference_server.allowed_networks import AllowedNetworks


class Settings(BaseSettings):
    """Evaluate robot policies over HTTP: the Proctor reference server."""

    model_config = SettingsConfigDict(
        env_prefix="PROCTOR_",
        cli_prog_name="python -m reference_server",
        cli_kebab_case=True,
        cli_hide_none_type=True,
        cli_avoid_json=True,
        extra="ignore",
    )

    host: str = Field("127.0.0.1", description="Address to listen on.")
    port: int = Field(
        8460, ge=0, le=65535, description="Port to listen on; 0 takes a free one."
    )
    public_url: str = Field(
        "",
        pattern=r"^(https?://\S+)?$",
        description="Base URL under which clients reach this server, for run.endpoint; "
        "taken from each request when empty.",
    )
    database: str = Field(
        "var/proctor.sqlite",
        description="Path of the SQLite file, or a SQLAlchemy URL.",
    )
    benchmarks: str = Field(
        "",
        description="Benchmarks of your own beside ours, comma-separated: "
        "gymnasium:ID, a TOML file, a folder of them, FILE.py:CLASS, or "
        "metaworld_mt50; see benchmarks.md.",
    )
    tokens: str = Field(
        "",
        description="Comma-separated account:scopes:token, scopes being read, run or "
        "read+run, token being the secret or sha256=<hex of it>; without any, "
        "one token is made and printed.",
    )
    profiles: str = Field(
        "",
        pattern=r"^((ebench|flageval)(,(ebench|flageval))*)?$",
        description="Wires of other houses to offer beside our own, comma-separated: "
        "ebench (see ebench.md), flageval.",
    )
    allow_private_policies: str = Field(
        "",
        description="Networks in which policy servers of push runs are called although "
        "they are not public, comma-separated, such as 127.0.0.1 or 10.0.0.0/8; all "
        "for every address.",
    )
    sealing_key: str = Field(
        "",
        description="File with the key that seals the API keys of policy servers in "
        "the database, made when it is missing; beside an SQLite file when empty, and "
        "with another database until the server ends.",
    )
    max_workers: int = Field(
        16, ge=1, le=1024, description="Most live workers of one run."
    )
    max_active_runs: int = Field(
        1000, ge=1, description="Runs that are ready or running at once; others queue."
    )
    max_simulators: int = Field(
        64, ge=1, description="Simulator processes at once, over all runs."
    )
    spare_simulators: int = Field(
        2, ge=0, description="Idle simulator processes kept ready."
    )
    turn_timeout_s: float = Field(
        60.0,
        gt=0,
        allow_inf_nan=False,
        description="A simulator busy for longer in one turn is killed.",
    )
    idle_timeout_s_max: float = Field(
        600.0,
        ge=1,
        allow_inf_nan=False,
        description="Longest lease a run may ask for, and the default.",
    )
    wait_s_max: int = Field(
        30, ge=0, le=600, description="Longest wait that a long-poll is granted."
    )
    max_body_bytes: int = Field(
        8 * 2**20, ge=2**16, description="Larger request bodies are refused."
    )
    max_chunk: int = Field(64, ge=4, le=4096, description="Most actions in one turn.")
    log_level: Literal["critical", "error", "warning", "info", "debug", "trace"] = (
        Field("warning", description="uvicorn's log level.")
    )

    @property
    def enabled_profiles(self) -> list[Literal["ebench", "flageval"]]:
        """`profiles` one by one, none twice."""
        known: tuple[Literal["ebench", "flageval"], ...] = ("ebench", "flageval")
        chosen = self.profiles.split(",")
        return [name for name in known if name in chosen]

    @field_validator("allow_private_policies")
    @classmethod
    def _check_networks(cls, text: str) -> str:
        AllowedNetworks.parse(text)  # raises ValueError
        return text

    @property
    def sealing_key_path(self) -> Path | None:
        """Where the key is that seals secrets at rest; None for one of this process."""
        if self.sealing_key:
            return Path(self.sealing_key)
        if "://" in self.database or ":memory:" in self.database:
            return None
        return Path(f"{self.database}.key")

    @property
    def database_url(self) -> str:
        """`database` as a SQLAlchemy URL."""
        if "://" in self.database:
            return self.database
        return f"sqlite+aiosqlite:///{self.database}"
