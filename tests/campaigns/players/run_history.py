"""What clients have asked a server, and what it has answered.

`Report` counts the answers to one client and has its findings, `History` is what a
player knows of one run, `Sample` is the time of one operation.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, field
from typing import Any

from tests.campaigns.players.raw_client import Answer

ALLOWED_5XX = ("unavailable", "no_capacity")


@dataclass
class Report:
    """What a client saw. sent: requests, connections, kills or whatever it counts.

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


@dataclass(frozen=True)
class Sample:
    kind: str  # service, turn, start, progress
    began_at: float
    took_s: float


@dataclass
class History:
    """What is known of a run that players have submitted and play.

    acknowledged: result by index as the server sent it. expected: (score, steps) by
    index as commanded, also where no acknowledgement arrived.
    """

    run_id: str
    episodes: int
    acknowledged: dict[int, dict[str, Any]] = field(default_factory=dict)
    expected: dict[int, tuple[float, int]] = field(default_factory=dict)
    is_done: bool = False
