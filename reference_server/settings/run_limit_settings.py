"""Settings that limit runs: their resources, how long they stay, whom they call."""

from __future__ import annotations

from typing import Literal

from pydantic import BaseModel, Field, field_validator

from reference_server.settings.allowed_networks import AllowedNetworks


class RunSettings(BaseModel):
    """Settings that limit runs: their resources, how long they stay, whom they call."""

    max_workers: int = Field(
        16, ge=1, le=1024, description="Maximum live workers per run."
    )
    max_active_runs: int = Field(
        1000,
        ge=1,
        description="Maximum runs that are played or about to be; others are queued.",
    )
    max_open_runs: int = Field(
        10_000,
        ge=1,
        description="Maximum runs of one account that are queued, ready, running or "
        "stopping.",
    )
    max_idempotency_keys: int = Field(
        1_000_000,
        ge=1,
        description="Maximum Idempotency-Keys of one account; they are kept for good.",
    )
    max_stored_bytes: int = Field(
        16 * 2**30,
        ge=1,
        description="Maximum bytes that the runs of one account may take in the "
        "database: their submissions, 512 for each episode, and what the history of "
        "the leaderboard says of their entries. They are kept for good.",
    )
    max_chunk: int = Field(
        64, ge=4, le=4096, description="Maximum actions in one turn."
    )
    idle_timeout_s_max: float = Field(
        600.0,
        ge=1,
        allow_inf_nan=False,
        description="Maximum lease of a session, and the default.",
    )
    heartbeat_s_max: float = Field(
        3600.0,
        ge=1,
        allow_inf_nan=False,
        description="Maximum time that a session lives on heartbeats without a turn.",
    )
    unused_s_max: float = Field(
        10.0,
        ge=1,
        allow_inf_nan=False,
        description="When others wait: time after which a run without a worker may "
        "lose its place, and a session without a turn its simulator to an account that "
        "has at least two fewer; heartbeats do not count. Raise it where policies of "
        "several workers take longer for a turn and simulators are scarce.",
    )
    runs_keep_days: float = Field(
        0,
        ge=0,
        allow_inf_nan=False,
        description="Days after which a run that has completed, failed or been stopped "
        "is deleted with all that is stored of it, unless it was resumed or has a "
        "public entry on the leaderboard; 0 keeps runs for ever.",
    )
    delete_played_runs: Literal["off", "on"] = Field(
        "off",
        description="Whether an account may delete its runs in which an action was "
        "executed. Runs that were never played it always may. What is deleted stays "
        "counted in `runs_played_before` and `attempts_by_submitter`.",
    )
    allow_private_policies: str = Field(
        "",
        description="Non-public networks in which this server may call policy servers, "
        "comma-separated, for example 127.0.0.1 or 10.0.0.0/8; all allows every "
        "address.",
    )
    policy_sockets: str = Field(
        "",
        description="Folder of the Unix sockets of policies that the host itself runs: "
        "http://NAME.sandbox.invalid is called at NAME.sock. Set by proctor-host.",
    )

    @field_validator("allow_private_policies")
    @classmethod
    def _check_networks(cls, text: str) -> str:
        AllowedNetworks.parse(text)  # raises ValueError
        return text
