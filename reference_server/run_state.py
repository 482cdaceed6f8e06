"""A run as the rules see it: plain data, no behaviour beyond what follows from it.

Times are monotonic seconds unless their name ends in `_at_wall` (seconds since 1970).
Nothing here knows of databases, simulators or requests.
"""

from __future__ import annotations

import heapq
from collections import OrderedDict
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Literal, TypeAlias

State: TypeAlias = Literal[
    "queued", "ready", "running", "stopping", "stopped", "failed", "completed"
]
Outcome: TypeAlias = Literal["success", "failure", "abandoned"]
SessionEnd: TypeAlias = Literal[
    "lease_ended", "detached", "run_stopped", "run_failed", "unknown"
]
Observe: TypeAlias = Literal["last", "all"]
Busy: TypeAlias = Literal["opening", "playing", "turning"]

# How many ended sessions a run remembers, to say why they ended.
ENDED_KEPT = 256


@dataclass(frozen=True, slots=True)
class Result:
    """What one episode came to; written once and never changed."""

    outcome: Outcome
    score: float
    attempt: int
    steps: int
    terminated: bool
    truncated: bool
    think_s: float
    finished_at_wall: float


@dataclass(slots=True)
class Episode:
    """One trial of the manifest.

    attempt: the attempt in play, or the next one; from 1.
    faults: simulator faults so far; `faults_forgiven` of them before the last resume.
    policy_fault: what the policy did that ended the last attempt, where we call it.
    """

    index: int
    task: str
    split: str
    seed: int
    attempt: int = 1
    faults: int = 0
    faults_forgiven: int = 0
    in_progress: bool = False
    policy_fault: str | None = None
    result: Result | None = None

    @property
    def episode_id(self) -> str:
        return f"e{self.index:04d}"


@dataclass(slots=True, eq=False)
class Session:
    """One attachment of a worker.

    steps: actions executed in the attempt in play.
    busy: what the server is executing for it; its lease stands still meanwhile.
    request, turn: the last predict and its answer, kept to be repeated.
    unheard: of a client that counts no turns, the seq it was given last and a digest of
    what it asked for, until the answer is known to have left.
    """

    session_id: str
    worker_id: str
    attach_key: str
    idle_timeout_s: float
    max_steps: int
    expires_at: float
    episode: Episode | None = None
    instruction: str = ""
    steps: int = 0
    think_s: float = 0.0
    answered_at: float = 0.0
    seq: int = 0
    request: tuple[Sequence[Mapping[str, Sequence[float]]], Observe] | None = None
    turn: dict[str, Any] | None = None
    unheard: tuple[int, str] | None = None
    busy: Busy | None = None
    done: bool = False
    ended_by: SessionEnd | None = None


@dataclass(slots=True, eq=False, weakref_slot=True)
class RunHead:
    """A run without its episodes: all there is to show of one that nobody plays.

    manifest: the benchmark with the run's options applied; what was hashed.
    number: grows with every submit; newest first is largest first.
    total, scored: how many episodes it has, and how many of them a result.
    """

    run_id: str
    number: int
    account: str
    state: State
    reason: str | None
    retryable: bool | None
    manifest: Mapping[str, Any]
    manifest_sha256: str
    submission: Mapping[str, Any]
    max_workers: int
    idle_timeout_s: float
    images: Mapping[str, Any]
    created_at_wall: float
    updated_at_wall: float
    queue_until_wall: float
    total: int = field(default=0, kw_only=True)
    scored: int = field(default=0, kw_only=True)

    @property
    def is_push(self) -> bool:
        """Whether this server calls the policy, and nobody else may attach."""
        return self.submission.get("mode") == "push"

    @property
    def live(self) -> list[Session]:
        """Sessions that hold a slot: those not yet told that they are done."""
        return []


@dataclass(slots=True, eq=False)
class Run(RunHead):
    """One evaluation of one policy on one benchmark.

    changed: indices of episodes that differ from what is stored.
    lost: a write of it failed; the store has the truth, and this object none.
    """

    episodes: list[Episode]
    workers: dict[str, Session] = field(default_factory=dict)
    ended: OrderedDict[str, SessionEnd] = field(default_factory=OrderedDict)
    pending: list[int] = field(default_factory=list)
    changed: set[int] = field(default_factory=set)
    lost: bool = False

    def __post_init__(self) -> None:
        self.total = len(self.episodes)
        self.scored = sum(1 for e in self.episodes if e.result is not None)
        self.pending = [e.index for e in self.episodes if e.result is None]

    @property
    def live(self) -> list[Session]:
        return [s for s in self.workers.values() if not s.done]

    def take_pending(self) -> Episode | None:
        """EPI-001: the first unscored episode in manifest order, now in progress."""
        if not self.pending:
            return None
        episode = self.episodes[heapq.heappop(self.pending)]
        episode.in_progress = True
        return episode

    def give_back(self, episode: Episode) -> None:
        """The episode waits again, at its place in manifest order."""
        episode.in_progress = False
        heapq.heappush(self.pending, episode.index)

    def remember_end(self, session: Session, ended_by: SessionEnd) -> None:
        session.ended_by = ended_by
        self.ended[session.session_id] = ended_by
        if len(self.ended) > ENDED_KEPT:
            self.ended.popitem(last=False)
