"""Settings, from flags and from the environment (`PROCTOR_…`); flags win.

Every field is a flag and a variable; its description is its documentation, from which
`docs/settings.md` is written.
"""

from __future__ import annotations

from typing import Literal

from pydantic import Field
from pydantic_settings import BaseSettings, SettingsConfigDict


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
    def database_url(self) -> str:
        """`database` as a SQLAlchemy URL."""
        if "://" in self.database:
            return self.database
        return f"sqlite+aiosqlite:///{self.database}"
