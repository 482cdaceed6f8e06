"""The one interface of all attacks: name, what is sent, its bound, a function.

An attack knows a `Target` and returns a `Report`; it judges nothing but what only it
can see. Most attacks run in a process of their own, at a lower priority than the
server, as if they came from another machine; those that need the server's process
(`is_beside`) run in this one.
"""

from __future__ import annotations

import random
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from tests.campaigns.players.raw_client import RawClient
from tests.campaigns.players.run_history import Report

if TYPE_CHECKING:
    from tests.campaigns.campaign_server import CampaignServer
    from tests.campaigns.players.watcher import Watcher


@dataclass
class Target:
    """What is attacked, with how much. size: 1 in the short form; scales the attack.

    token: of the attacking account. others: tokens of accounts that are not watched,
    for attacks by several accounts.
    """

    url: str
    token: str
    others: list[str]
    seed: int
    size: float
    seconds: float
    server: CampaignServer | None = None
    watchers: list[Watcher] = field(default_factory=list)

    def client(self, timeout_s: float = 10.0, token: str | None = None) -> RawClient:
        return RawClient(self.url, token or self.token, timeout_s=timeout_s)

    def random(self, *names: object) -> random.Random:
        return random.Random(repr((self.seed, *names)))

    def deadline(self) -> float:
        """Monotonic time at which the attack stops by itself."""
        return time.monotonic() + self.seconds

    def count(self, short: int) -> int:
        return max(1, round(short * self.size))


@dataclass(frozen=True)
class Attack:
    """sends, bound: for the table. settings: of the server that it needs.

    prefix: a command that starts the server's command, to limit its resources.
    long_size: how many times more than in the short form. is_timed: whether the bounds
    on latency hold meanwhile; they do not for a server that is killed or as busy as
    its own account can make it.
    is_alone: whether no other attack may run beside it, as with is_timed.
    is_fault_expected: whether the attack breaks simulators.
    """

    name: str
    sends: str
    bound: str
    run: Callable[[Target], Report]
    settings: Mapping[str, str] = field(default_factory=dict)
    prefix: tuple[str, ...] = ()
    long_size: float = 10.0
    seconds: float = 2.0
    is_beside: bool = False
    is_timed: bool = True
    is_alone: bool = False
    is_fault_expected: bool = False
    watchers: int = 1
