"""The one interface of all attacks: name, what is sent, its bound, a function.

An attack knows a `Target` and returns a `Report`; it judges nothing but what only it
can see. Most attacks run in a process of their own, at a lower priority than the
server, as if they came from another machine; those that need the server's process
(`is_beside`) run in this one.
"""

from __future__ import annotations

import random
import time
from collections import Counter
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from tests.attack.raw_client import Answer, RawClient

if TYPE_CHECKING:
    from tests.attack.attacked_server import AttackedServer
    from tests.attack.watcher import Watcher

ALLOWED_5XX = ("unavailable", "no_capacity")


@dataclass
class Report:
    """What an attack saw. sent: requests, connections, kills or whatever it counts.

    answers: how many had each status, or of unexpected 5xx status and code. hangs:
    requests without any answer in time. violations: anything else that must not be.
    figures: measured values for the table, by name.
    """

    sent: int = 0
    answers: Counter[str] = field(default_factory=Counter)
    hangs: int = 0
    violations: list[str] = field(default_factory=list)
    figures: dict[str, float] = field(default_factory=dict)

    def add_answer(self, answer: Answer | None) -> None:
        """Count an answer, or None for a request that got none."""
        self.sent += 1
        if answer is None:
            self.answers["closed"] += 1
        elif answer.status < 500 or answer.code in ALLOWED_5XX:
            self.answers[str(answer.status)] += 1
        else:
            self.answers[f"{answer.status} {answer.code or 'without code'}"] += 1

    @property
    def wrong_5xx(self) -> int:
        return sum(n for name, n in self.answers.items() if " " in name)

    def merge(self, other: Report) -> None:
        self.sent += other.sent
        self.answers += other.answers
        self.hangs += other.hangs
        self.violations += other.violations
        self.figures |= other.figures


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
    server: AttackedServer | None = None
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
