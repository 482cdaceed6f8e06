"""Settings of one run of the kit: the options, and what the preflight measured.

Passed from the command line to the process of the checks in one environment variable,
so that tokens never appear in a command line.
"""

import functools
import json
import os
import time
from dataclasses import asdict, dataclass, field
from typing import Any

from conformance.specification.ledger import (
    CLUSTER,
    CORE,
    CRASH,
    LEVELS,
    OF_OTHER_PROGRAMS,
    PROFILES,
    SERVICE,
    Requirement,
    load_ledger,
)
from conformance.specification.stages import LAST, stage_of, stage_of_operation

VARIABLE = "PROCTOR_KIT_SETTINGS"
# More than further rounds use up in a minute.
_KEYS_OF_ROUNDS, _BYTES_OF_ROUNDS = 20_000, 10**9


@dataclass
class Settings:
    """One run of the kit."""

    url: str = ""
    other_urls: list[str] = field(default_factory=list)  # of the same service
    token: str | None = None
    token_2: str | None = None
    token_read: str | None = None
    start_cmd: str | None = None
    nodes: int = 1  # how often start_cmd is started
    restart_cmd: str | None = None
    durable: bool = True  # whether runs outlive the server's process
    seed: int = 0
    quick: bool = False
    stage: int | None = None
    level: str | None = None  # judge its rules alone
    fail_fast: bool = False
    stress: bool = False
    exchanges: bool = False
    only: list[str] = field(default_factory=list)
    profiles: list[str] = field(default_factory=list)
    report: str = "report"
    summary: str | None = None
    attest: str | None = None
    attest_key: str | None = None
    attest_subject: str | None = None
    max_time_s: float | None = None
    minutes: float = 0.0  # of further generated histories and requests
    deadline: float | None = None  # of the monotonic clock, which processes share
    rounds_until: float = 0.0  # further rounds of generated histories, by that clock
    round_trip_s: float = 0.0
    tolerance_s: float = 0.25
    service: dict[str, Any] = field(default_factory=dict)
    benchmark: dict[str, Any] = field(default_factory=dict)
    # How an episode of a policy server under test begins (turn_builder.Beginning).
    beginning: dict[str, Any] = field(default_factory=dict)
    # A simulator under test: its command, its limits of time, what it says of itself.
    simulator: dict[str, Any] = field(default_factory=dict)

    @functools.cached_property
    def selected_rules(self) -> list[Requirement]:
        """The rules selected by --profile and --only, as ordered in the ledger."""
        return [
            row
            for row in load_ledger().values()
            if row.profile in self.profiles
            and (self.stage is None or stage_of(row, self.level) <= self.stage)
            and (not self.only or row.id.startswith(tuple(self.only)))
        ]

    @property
    def urls(self) -> list[str]:
        """All base URLs of the service."""
        return [self.url, *self.other_urls]

    def assume_all_offered(self) -> None:
        """List the checks of every selected profile; there is no server."""
        self.service = {"profiles": [*SERVICE, *self.profiles]}
        self.other_urls = ["http://another-base-url.invalid"]

    def is_offered(self, profile: str) -> bool:
        """Whether the server announces a profile, or is judged by it unannounced."""
        announced = self.service.get("profiles", [])
        if profile == CLUSTER:
            return bool(self.other_urls)
        if profile == CRASH:
            return {*SERVICE} <= {*announced}
        return profile == CORE or profile in announced

    def is_served(self, operation_id: str) -> bool:
        """Whether a server of the stage under test has an operation, if it may."""
        return self.stage is None or stage_of_operation(operation_id) <= self.stage

    @property
    def is_partial(self) -> bool:
        """Whether only a selection of the rules is checked."""
        whole = LEVELS[self.level] if self.level else PROFILES
        is_narrow = self.is_of_server and bool({*whole} - {*self.profiles})
        is_stage = self.stage not in (None, LAST)
        return bool(self.only or self.quick or is_narrow or is_stage)

    @property
    def is_of_server(self) -> bool:
        """Whether a server is judged, and no program of another kind."""
        return self.profiles not in [[name] for name in OF_OTHER_PROGRAMS]

    @property
    def is_time_up(self) -> bool:
        """Whether no further check may start."""
        return self.deadline is not None and time.monotonic() >= self.deadline

    @property
    def has_room_for_rounds(self) -> bool:
        """Whether an account may have many more runs than a whole run makes."""
        limits = self.service.get("limits", {})
        keys = limits.get("max_idempotency_keys", _KEYS_OF_ROUNDS)
        stored = limits.get("max_stored_bytes", _BYTES_OF_ROUNDS)
        return bool(keys >= _KEYS_OF_ROUNDS and stored >= _BYTES_OF_ROUNDS)

    def store_in_environment(self) -> None:
        """Pass the settings to the processes started from here."""
        os.environ[VARIABLE] = json.dumps(asdict(self))

    @classmethod
    def load_from_environment(cls) -> "Settings":
        """Read the settings that the command line passed."""
        return cls(**json.loads(os.environ[VARIABLE]))
