"""A run as the rules see it: plain data and what follows from it.

Times are monotonic seconds unless their name ends in `_at_wall` (seconds since 1970).
Nothing here knows of databases, simulators or requests.
"""

from __future__ import annotations

import heapq
import re
from collections import OrderedDict
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Literal, TypeAlias

from reference_record.generated.answers import (
    ImageChoice,
    Observe,
    Outcome,
    PlayerView,
    RunState,
    Turn,
)
from reference_server.rules.manifest import Manifest, Submission, is_sealed

State: TypeAlias = RunState
SessionEnd: TypeAlias = Literal[
    "lease_ended", "detached", "run_stopped", "run_failed", "unknown"
]
RunFault: TypeAlias = Literal["policy", "simulator", "server"]
Busy: TypeAlias = Literal["opening", "playing", "turning"]
Player: TypeAlias = PlayerView

# How many ended sessions a run remembers, to say why they ended.
ENDED_SESSIONS_MAX = 256


@dataclass(frozen=True, slots=True)
class Result:
    """The result of one episode; written once and never changed.

    player: as declared, or None (ATR-003). clipped_actions, total_reward: None in
    results that were stored without them.
    """

    outcome: Outcome
    score: float
    attempt: int
    steps: int
    terminated: bool
    truncated: bool
    think_s: float
    finished_at_wall: float
    player: Player | None = None
    clipped_actions: int | None = None
    total_reward: float | None = None


@dataclass(frozen=True, slots=True)
class Recording:
    """The finished recording of an episode, as its file is.

    first_digest, last_digest: of the simulator's state; None if nothing was played.
    latency: quantiles in milliseconds, by name. fence: of the owner that wrote it; its
    file is named after it.
    """

    sha256: str
    bytes: int
    turns: int
    first_digest: str | None
    last_digest: str | None
    latency: Mapping[str, float]
    fence: int = 0


@dataclass(frozen=True, slots=True)
class PublicKey:
    """A key that signs records, or did. retired_at_wall: None for the key in use."""

    keyid: str
    public_key: bytes
    created_at_wall: float
    retired_at_wall: float | None


@dataclass(frozen=True, slots=True)
class Leaving:
    """Why a worker has left an episode, and in which attempt (RSN-001)."""

    attempt: int
    reason: str


@dataclass(slots=True)
class Episode:
    """One trial of the manifest.

    attempt: the attempt in play, or the next one; from 1.
    faults: simulator faults so far; `faults_forgiven` of them before the last resume.
    policy_fault: what the policy did that ended the last attempt, in mode push.
    last_left: why a worker has left it last, as the worker said.
    place: of its result among those of the run, the first one 1; None without a result,
    or with one that is older than this column.
    recording: with its result; None if it was not recorded.
    is_sealed: the seed is secret.
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
    last_left: Leaving | None = None
    place: int | None = None
    result: Result | None = None
    recording: Recording | None = None
    is_sealed: bool = False

    @classmethod
    def of(cls, manifest: Manifest, index: int) -> Episode:
        """The episode at its place in the manifest, before it is played."""
        plan = manifest["episodes"][index]
        sealed = is_sealed(manifest, plan["split"])
        return cls(index, plan["task"], plan["split"], plan["seed"], is_sealed=sealed)

    @property
    def episode_id(self) -> str:
        return f"e{self.index:04d}"  # RUN-024

    def without_sealed_seed(self, text: str) -> str:
        """The text of a simulator; the seed of a sealed split is taken out (SEAL-002).

        As a whole number alone: any 1 that is gone would show that the seed is 1.
        """
        if not self.is_sealed:
            return text
        seed = self.seed
        decimal = f"({seed}|{seed:,}|{seed:_})(?![0-9])"
        pattern = rf"(?<![0-9])({decimal}|0x0*{seed:x}(?![0-9a-f]))"
        return re.sub(pattern, "(sealed seed)", text, flags=re.IGNORECASE)


@dataclass(slots=True, eq=False, weakref_slot=True)
class Session:
    """One attachment of a worker.

    steps, clipped, reward: actions executed in the attempt in play, those of them in
    which a number was clipped, and the sum of their rewards.
    player: as this session declared it; attempt_player: of the attempt in play, None
    when its sessions differ.
    busy: what the server is executing for it; its lease stands still meanwhile.
    held: a person judges its attempt; its lease stands still, too.
    max_attempts: of an episode whose attempt ends in it; None for the manifest's.
    first_episodes: how many of the run's first ones it may begin; None for all.
    request, turn: the last predict and its answer, kept to be repeated.
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
    clipped: int = 0
    reward: float = 0.0
    player: Player | None = None
    attempt_player: Player | None = None
    think_s: float = 0.0
    answered_at: float = 0.0
    seq: int = 0
    request: tuple[Sequence[Mapping[str, Sequence[float]]], Observe] | None = None
    turn: Turn | None = None
    busy: Busy | None = None
    held: bool = False
    done: bool = False
    ended_by: SessionEnd | None = None
    max_attempts: int | None = None
    first_episodes: int | None = None


@dataclass(slots=True, eq=False, weakref_slot=True)
class RunHead:
    """A run without its episodes: all there is to show of one that is not in play.

    manifest: the benchmark with the run's options applied; what was hashed.
    number: grows with every submit; newest first is largest first.
    attempts_by_submitter: how many runs of its benchmark its account had submitted,
    this one included; None if it is older than this member.
    played_number: its place among those of them in which an action was executed, the
    first one 1; None if none was executed, or this is not stored yet.
    failed_by: who made it fail; None in other states, and if it is older than this.
    owner, fence: in a cluster the node that acts for it, and how often that changed.
    total, scored: how many episodes it has, and how many of them a result.
    """

    run_id: str
    number: int
    account: str
    state: State
    reason: str | None
    retryable: bool | None
    manifest: Manifest
    manifest_sha256: str
    submission: Submission
    max_workers: int
    idle_timeout_s: float
    images: ImageChoice
    created_at_wall: float
    updated_at_wall: float
    queue_until_wall: float
    attempts_by_submitter: int | None = field(default=None, kw_only=True)
    played_number: int | None = field(default=None, kw_only=True)
    failed_by: RunFault | None = field(default=None, kw_only=True)
    owner: str | None = field(default=None, kw_only=True)
    fence: int = field(default=0, kw_only=True)
    total: int = field(default=0, kw_only=True)
    scored: int = field(default=0, kw_only=True)

    @property
    def is_push(self) -> bool:
        """PUSH-003: whether this server calls the policy; no worker may attach then."""
        return self.submission.get("mode") == "push"

    @property
    def any_policy(self) -> bool:
        """ATR-001: whether workers may play for another policy than the run's."""
        return self.submission.get("any_policy", False)

    @property
    def live_sessions(self) -> list[Session]:
        """Sessions that hold a slot: those that are not done."""
        return []


@dataclass(slots=True, eq=False)
class Run(RunHead):
    """One evaluation of one policy on one benchmark.

    scored_order: indices of the scored episodes, as they were scored one after another;
    results without a place are the oldest, in manifest order.
    changed: indices of episodes that differ from what is stored.
    is_played: an action was executed in it.
    lost: a write of it failed; the store has the truth, and this object none.
    """

    episodes: list[Episode]
    workers: dict[str, Session] = field(default_factory=dict)
    ended: OrderedDict[str, SessionEnd] = field(default_factory=OrderedDict)
    pending: list[int] = field(default_factory=list)
    scored_order: list[int] = field(default_factory=list)
    changed: set[int] = field(default_factory=set)
    is_played: bool = False
    lost: bool = False

    def __post_init__(self) -> None:
        self.total = len(self.episodes)
        self.is_played = self.played_number is not None
        scored = [e for e in self.episodes if e.result is not None]
        self.scored = len(scored)
        self.scored_order = [
            e.index for e in sorted(scored, key=lambda e: e.place or 0)
        ]
        self.pending = [e.index for e in self.episodes if e.result is None]

    @property
    def live_sessions(self) -> list[Session]:
        return [s for s in self.workers.values() if not s.done]

    def window(self, start: int, end: int | None, scored: bool) -> list[Episode]:
        """Episodes from start to end: of the manifest, or of `scored_order`."""
        if scored:
            return [self.episodes[i] for i in self.scored_order[start:end]]
        return self.episodes[start:end]

    def record_result(self, episode: Episode, result: Result) -> None:
        """EPI-005, CRASH-001: a result is written once and stored with the run."""
        assert episode.result is None, "an episode is scored once"
        episode.result = result
        self.scored += 1
        episode.place = self.scored
        self.scored_order.append(episode.index)
        self.changed.add(episode.index)

    def take_pending(self, first: int | None = None) -> Episode | None:
        """EPI-001: the first unscored episode in manifest order, now in progress.

        EPI-008: it is removed, so that no other session is handed it. SUB-005: `first`
        says how many of the first episodes may be handed out; None for all.
        """
        if not self.pending or (first is not None and self.pending[0] >= first):
            return None
        episode = self.episodes[heapq.heappop(self.pending)]
        episode.in_progress = True
        return episode

    def return_to_pending(self, episode: Episode) -> None:
        """The episode waits again, at its place in manifest order."""
        episode.in_progress = False
        heapq.heappush(self.pending, episode.index)

    def record_end(self, session: Session, ended_by: SessionEnd) -> None:
        session.ended_by = ended_by
        self.ended[session.session_id] = ended_by
        if len(self.ended) > ENDED_SESSIONS_MAX:
            self.ended.popitem(last=False)


def index_of(episode_id: str) -> int | None:
    """The index of the episode with this id (RUN-024); None for no episode's id."""
    digits = episode_id.removeprefix("e")
    if not (digits.isascii() and digits.isdigit()) or len(digits) > 9:
        return None
    index = int(digits)
    return index if episode_id == f"e{index:04d}" else None
