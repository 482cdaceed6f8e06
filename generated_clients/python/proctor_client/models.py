"""The messages of the protocol.

Generated from spec/openapi.yaml by `make generate`; never edited by hand.
"""

from __future__ import annotations

from datetime import datetime
from enum import StrEnum
from typing import Annotated

from pydantic import Field, StrictBool, StrictFloat, StrictInt, StrictStr

from .message import Message


class Action(Message):
    values: Annotated[
        dict[str, Annotated[list[StrictFloat], Field(max_length=4096)]],
        Field(max_length=64),
    ]
    """Name → vector, exactly the entries of the benchmark's action space."""


class Assumption(Message):
    """About a vector. All members but `size` and `parts` are about each of its parts (CONV-004)."""

    size: Annotated[int, Field(strict=True, ge=1)] | None = None
    quantity: (
        Annotated[str, Field(strict=True, pattern=r"^[a-z][a-z0-9_]{0,63}$")] | None
    ) = None
    """A name of registry/quantities.yaml, or an extension."""
    unit: Annotated[str, Field(strict=True, max_length=64)] | None = None
    scale: StrictFloat | None = None
    frame: Annotated[str, Field(strict=True, max_length=64)] | None = None
    rotation: (
        Annotated[str, Field(strict=True, pattern=r"^[a-z][a-z0-9_]{0,63}$")] | None
    ) = None
    """A name of registry/rotations.yaml, or an extension."""
    relative_to: (
        Annotated[str, Field(strict=True, pattern=r"^[a-z][a-z0-9_]{0,63}$")] | None
    ) = None
    """A name of registry/relative_modes.yaml, or an extension."""
    gripper_open: StrictFloat | None = None
    gripper_closed: StrictFloat | None = None
    parts: Annotated[dict[str, PartAssumption], Field(max_length=256)] | None = None


class Assumptions(Message):
    """What the policy takes for granted; refused when the benchmark says otherwise (ATT-010). For the profile `conventions`."""

    control_rate_hz: Annotated[float, Field(strict=True, ge=0)] | None = None
    action: Annotated[dict[str, Assumption], Field(max_length=64)] | None = None
    state: Annotated[dict[str, Assumption], Field(max_length=64)] | None = None


class AttachWorker(Message):
    attach_key: Annotated[str, Field(strict=True, min_length=1, max_length=128)]
    """New for every attachment; repeated only to repeat a lost request."""
    takeover: StrictBool | None = None
    """Fence out a live session; false when absent. For the profile `sessions`."""
    assumes: Assumptions | None = None
    player: Player | None = None
    first_episodes: Annotated[int, Field(strict=True, ge=1, le=1000000000)] | None = (
        None
    )
    """How many of the first episodes of the run are wanted; the session begins none behind them (SUB-005). All when absent. For the profile `subsets`."""


class Benchmark(Message):
    """Everything about a benchmark that can change a score."""

    benchmark_id: StrictStr
    version: StrictStr
    title: StrictStr
    description: StrictStr
    manifest_sha256: Annotated[str, Field(strict=True, pattern=r"^[0-9a-f]{64}$")]
    """The digest of a [manifest](benchmarks.md#the-manifest), which is all of a benchmark that can change a score. It is the same on every server (BEN-006)."""
    episodes_total: Annotated[int, Field(strict=True, ge=1)]
    tasks: Annotated[list[StrictStr], Field(max_length=100000)]
    task_goals: Annotated[dict[str, StrictStr], Field(max_length=100000)] | None = None
    """Task → when its goal holds, in a sentence for people; absent where nothing is said."""
    splits: Annotated[list[StrictStr], Field(max_length=100000)]
    sealed_splits: Annotated[list[StrictStr], Field(max_length=100000)] | None = None
    """Splits whose seeds the host draws in secret; none when absent."""
    seeds_sha256: (
        Annotated[str, Field(strict=True, pattern=r"^[0-9a-f]{64}$")] | None
    ) = None
    """What the host commits itself to without showing it, the SHA-256 of a secret salt and the sealed seeds. With both disclosed later, anyone can prove which seeds were played."""
    control_rate_hz: StrictFloat
    """Actions per simulated second."""
    max_steps: Annotated[int, Field(strict=True, ge=1)]
    """Steps after which an episode is truncated."""
    max_chunk: Annotated[int, Field(strict=True, ge=1)]
    max_attempts: Annotated[int, Field(strict=True, ge=1)]
    max_faults: Annotated[int, Field(strict=True, ge=1)]
    success_rule: Annotated[str, Field(strict=True, pattern=r"^[a-z][a-z0-9_]{0,63}$")]
    """A `SuccessRule`, or one of a later version."""
    action_space: Annotated[dict[str, VectorSpace], Field(max_length=64)]
    """Name of an action value → what it means."""
    observation_space: ObservationSpace
    image_sizes: Annotated[list[ImageSize], Field(min_length=1, max_length=1024)]
    """Sizes that may be chosen at submit; the first is the default."""
    image_codecs: Annotated[
        list[Annotated[str, Field(strict=True, pattern=r"^[a-z][a-z0-9_]{0,63}$")]],
        Field(min_length=1, max_length=256),
    ]
    """Codecs that may be chosen at submit; the first is the default."""
    simulator: SimulatorInfo
    unavailable_reason: StrictStr | None
    """Why a run cannot be submitted here now, and the cure; null when it can."""


class BenchmarkList(Message):
    benchmarks: Annotated[list[BenchmarkSummary], Field(max_length=10000)]


class BenchmarkSummary(Message):
    benchmark_id: StrictStr
    version: StrictStr
    title: StrictStr
    manifest_sha256: Annotated[str, Field(strict=True, pattern=r"^[0-9a-f]{64}$")]
    """The digest of a [manifest](benchmarks.md#the-manifest), which is all of a benchmark that can change a score. It is the same on every server (BEN-006)."""
    episodes_total: Annotated[int, Field(strict=True, ge=1)]


class BoardEntry(Message):
    entry_id: StrictStr
    """Names the entry in every path."""
    run_id: StrictStr
    submitter: StrictStr
    """Name of the account that submitted the run."""
    benchmark_id: StrictStr
    benchmark_version: StrictStr
    manifest_sha256: Annotated[str, Field(strict=True, pattern=r"^[0-9a-f]{64}$")]
    """The digest of a [manifest](benchmarks.md#the-manifest), which is all of a benchmark that can change a score. It is the same on every server (BEN-006)."""
    select: SelectionView | None = None
    policy: RunPolicy
    model_name: StrictStr
    is_public: StrictBool
    model_type: StrictStr | None = None
    organisation: StrictStr | None = None
    homepage: StrictStr | None = None
    code_url: StrictStr | None = None
    notes: StrictStr | None = None
    state: Annotated[str, Field(strict=True, pattern=r"^[a-z][a-z0-9_]{0,63}$")]
    flag: EntryFlag | None = None
    level: Annotated[str, Field(strict=True, pattern=r"^[a-z][a-z0-9_]{0,63}$")]
    """What is known of the score: `reported` by the server alone; `signed`, for the run has a record that this host signs; `sealed`, for its seeds were drawn after the host was committed to the policy."""
    attempts: Annotated[int, Field(strict=True, ge=1)]
    """How many runs of the benchmark the account has submitted until now, published or not."""
    score: EntryScore
    published_at: datetime
    """When the entry was made."""
    changed_at: datetime
    """When the description, the state or the flag changed for the last time."""


class BoardEntryList(Message):
    entries: Annotated[list[BoardEntry], Field(max_length=1000)]
    next_cursor: (
        Annotated[str, Field(strict=True, pattern=r"^[A-Za-z0-9_-]{1,128}$")] | None
    )


class CalibrationOptions(Message):
    """Only for the benchmark `calibration`, which the submitter shapes."""

    tasks: (
        Annotated[list[CalibrationTask], Field(min_length=1, max_length=1000)] | None
    ) = None
    """One entry per episode, in order; one `score` episode when absent."""
    max_steps: Annotated[int, Field(strict=True, ge=1, le=10000)] | None = None
    """10 when absent."""
    success_rule: SuccessRule | None = None
    max_attempts: Annotated[int, Field(strict=True, ge=1, le=10)] | None = None
    """3 when absent. For the profile `sessions`."""
    max_faults: Annotated[int, Field(strict=True, ge=1, le=10)] | None = None
    """3 when absent. For the profile `faults`."""
    sealed: StrictBool | None = None
    """Whether the seeds of the split `odd` are sealed; false when absent. Only for servers that announce the profile `sealed_seeds`."""
    queue_s: Annotated[float, Field(strict=True, ge=0, le=10)] | None = None
    """Seconds for which the run stays queued after submit and after resume; 0 when absent. For the profile `control`."""


class CalibrationTask(StrEnum):
    """`echo` is for the profile `observations`, `fault` for `faults`."""

    SCORE = "score"
    COUNT = "count"
    ECHO = "echo"
    DELAY = "delay"
    FAULT = "fault"


class Checkpoint(Message):
    tree_size: Annotated[int, Field(strict=True, ge=0)]
    root_sha256: Annotated[str, Field(strict=True, pattern=r"^[0-9a-f]{64}$")]
    """The digest of a [manifest](benchmarks.md#the-manifest), which is all of a benchmark that can change a score. It is the same on every server (BEN-006)."""
    note: StrictStr
    """The signed note, which says both as well."""
    keyid: StrictStr
    """Of the key of `list_keys` that signed it."""


class ComparedRun(Message):
    """One run beside the baseline. A pair is an episode that both have scored."""

    run_id: StrictStr
    complete: StrictBool
    """Both runs have scored every episode."""
    release: StrictBool
    """Complete, and no difference, over all episodes or over those of a task, is beyond the tolerance."""
    paired: Annotated[int, Field(strict=True, ge=0)]
    """Number of pairs."""
    baseline_mean: StrictFloat | None
    """Mean score of the baseline over the pairs."""
    mean: StrictFloat | None
    """Mean score of the run over the pairs."""
    difference: StrictFloat | None
    """Baseline minus run: positive when the run is worse."""
    wins: Annotated[int, Field(strict=True, ge=0)]
    """Pairs in which the run alone succeeds."""
    losses: Annotated[int, Field(strict=True, ge=0)]
    """Pairs in which the baseline alone succeeds."""
    ties: Annotated[int, Field(strict=True, ge=0)]
    """Pairs in which both succeed or neither does."""
    p_value: Annotated[float, Field(strict=True, ge=0, le=1)]
    """McNemar's exact test, two-sided."""
    by_task: Annotated[dict[str, ComparedTask], Field(max_length=100000)]
    """Task → the pairs of its episodes."""


class ComparedTask(Message):
    paired: Annotated[int, Field(strict=True, ge=0)]
    baseline_mean: StrictFloat | None
    mean: StrictFloat | None
    difference: StrictFloat | None


class Comparison(Message):
    """See scoring.md for every number here."""

    baseline: StrictStr
    """Id of the run that the others are compared with."""
    benchmark_id: StrictStr
    manifest_sha256: Annotated[str, Field(strict=True, pattern=r"^[0-9a-f]{64}$")]
    """The digest of a [manifest](benchmarks.md#the-manifest), which is all of a benchmark that can change a score. It is the same on every server (BEN-006)."""
    tolerance: Annotated[float, Field(strict=True, ge=0, le=1)]
    runs: Annotated[list[ComparedRun], Field(max_length=16)]
    """One entry per run that was named, in that order."""


class ConsistencyProof(Message):
    old_size: Annotated[int, Field(strict=True, ge=1)]
    new_size: Annotated[int, Field(strict=True, ge=1)]
    hashes: Annotated[
        list[Annotated[str, Field(strict=True, pattern=r"^[0-9a-f]{64}$")]],
        Field(max_length=128),
    ]


class EntryFlag(Message):
    reason: StrictStr
    flagged_at: datetime


class EntryScore(Message):
    """Of the `get_score` of the run."""

    score: StrictFloat
    success_rate: StrictFloat
    success_interval: Interval
    mean_interval: Interval
    counts: OutcomeCounts
    judged_by: StrictStr | None = None
    """With the profile `physical`: `people` of the host."""
    second_judge: SecondJudgements | None = None
    by_task: Annotated[dict[str, GroupScore], Field(max_length=100000)] | None = None
    """Absent where the server does not show it, such as for many tasks."""
    by_split: Annotated[dict[str, GroupScore], Field(max_length=100000)] | None = None
    """Absent where the server does not show it, such as for many splits."""


class Episode(Message):
    episode_id: StrictStr
    index: Annotated[int, Field(strict=True, ge=0)]
    """Position in the manifest."""
    task: StrictStr
    split: StrictStr
    status: EpisodeStatus
    attempt: Annotated[int, Field(strict=True, ge=1)]
    """The current or next attempt."""
    faults: Annotated[int, Field(strict=True, ge=0)]
    """How often the simulator broke, or a trial was void (FAULT-009)."""
    policy_fault: StrictStr | None = None
    """In a run with mode `push`: what the policy did wrong when it last ended an attempt of this episode."""
    last_left: Leaving | None = None
    result: EpisodeResult | None = None


class EpisodeList(Message):
    episodes: Annotated[list[Episode], Field(max_length=1000)]
    next_cursor: (
        Annotated[str, Field(strict=True, pattern=r"^[A-Za-z0-9_-]{1,128}$")] | None
    )


class EpisodeResult(Message):
    episode_id: StrictStr
    index: Annotated[int, Field(strict=True, ge=0)]
    """Position in the manifest."""
    task: StrictStr
    split: StrictStr
    seed: Annotated[int, Field(strict=True, ge=0, le=9007199254740991)] | None = None
    """Absent where `sealed_splits` of the manifest of the run names the split."""
    attempt: Annotated[int, Field(strict=True, ge=1)]
    """The attempt that was scored."""
    faults: Annotated[int, Field(strict=True, ge=0)]
    """How often the simulator broke, or a trial was void (FAULT-009)."""
    outcome: Outcome
    score: Annotated[float, Field(strict=True, ge=0, le=1)]
    """From 0 to 1."""
    steps: Annotated[int, Field(strict=True, ge=0)]
    """Actions executed in the attempt."""
    terminated: StrictBool
    """The task ended by itself."""
    truncated: StrictBool
    """The step limit ended the episode."""
    think_s: Annotated[float, Field(strict=True, ge=0)]
    """Time between turns that the policy took."""
    finished_at: datetime
    player: PlayerView | None = None
    clipped_actions: Annotated[int, Field(strict=True, ge=0)] | None = None
    """Actions of the attempt with a number outside of a range that is declared `clip`; for the profile `attribution`."""
    total_reward: StrictFloat | None = None
    """Sum of the rewards of the attempt, its return; for the profile `attribution`."""


class EpisodeSelection(Message):
    """The part of a benchmark that is played, all of it where a member is absent; for the profile `subsets`."""

    tasks: (
        Annotated[
            list[Annotated[str, Field(strict=True, max_length=200)]],
            Field(min_length=1, max_length=1000),
        ]
        | None
    ) = None
    splits: (
        Annotated[
            list[Annotated[str, Field(strict=True, max_length=200)]],
            Field(min_length=1, max_length=1000),
        ]
        | None
    ) = None


class EpisodeStatus(StrEnum):
    PENDING = "pending"
    IN_PROGRESS = "in_progress"
    SCORED = "scored"


class EpisodeView(Message):
    """The episode that the observation belongs to."""

    episode_id: StrictStr
    """Names the episode within the run."""
    index: Annotated[int, Field(strict=True, ge=0)]
    """Position in the manifest."""
    task: StrictStr
    """What kind of episode it is."""
    instruction: StrictStr
    """What the policy is to do, in words."""
    attempt: Annotated[int, Field(strict=True, ge=1)]
    """Number of this playing of it, from 1."""
    step: Annotated[int, Field(strict=True, ge=0)]
    """Actions executed in this attempt."""
    max_steps: Annotated[int, Field(strict=True, ge=1)]
    """Steps after which it is truncated."""


class Fault(Message):
    """The simulator broke; the episode began again, at no cost to the policy. Nothing of the chunk counts as executed. A turn that ends an episode has its result instead, and `list_episodes` the faults of the next one."""

    episode_id: StrictStr
    """Which episode began again."""
    faults: Annotated[int, Field(strict=True, ge=1)]
    """Faults of this episode so far."""
    detail: StrictStr
    """What happened, for people."""
    is_void: StrictBool | None = None
    """True where no simulator broke: a person said that the trial does not count; with the profile `physical`."""


class FlagEntry(Message):
    flagged: StrictBool
    """False takes the flag back."""
    reason: Annotated[str, Field(strict=True, min_length=1, max_length=500)]
    """Shown with the entry."""


class GroupScore(Message):
    counts: OutcomeCounts
    mean: StrictFloat | None
    success_rate: StrictFloat | None


class Heartbeat(Message):
    session_id: Annotated[str, Field(strict=True, min_length=1, max_length=128)]
    """Session of `attach_worker`."""
    reason: Annotated[str, Field(strict=True, min_length=1, max_length=500)] | None = (
        None
    )
    """Why the worker leaves the episode in play, for people (RSN-001). For the profile `reasons`."""


class HistoryLeaf(Message):
    index: Annotated[int, Field(strict=True, ge=0)]
    leaf: StrictStr
    """A JSON text, whose UTF-8 is what the tree has; board.md has its members."""


class HistoryPage(Message):
    leaves: Annotated[list[HistoryLeaf], Field(max_length=1000)]
    next_cursor: (
        Annotated[str, Field(strict=True, pattern=r"^[A-Za-z0-9_-]{1,128}$")] | None
    )


class Image(Message):
    """Row 0 on top; raw is height × width × channels bytes. The order of [channels](play.md#numbers-and-pictures)."""

    codec: Annotated[str, Field(strict=True, pattern=r"^[a-z][a-z0-9_]{0,63}$")]
    width: Annotated[int, Field(strict=True, ge=1)]
    height: Annotated[int, Field(strict=True, ge=1)]
    channels: Annotated[int, Field(strict=True, ge=1, le=4)]
    data: StrictStr
    """Base64 with padding in JSON; `bin` in MessagePack."""


class ImageChoice(Message):
    """Recorded with the result, because it changes the score."""

    codec: Annotated[str, Field(strict=True, pattern=r"^[a-z][a-z0-9_]{0,63}$")]
    width: Annotated[int, Field(strict=True, ge=1, le=4096)]
    height: Annotated[int, Field(strict=True, ge=1, le=4096)]


class ImageSize(Message):
    width: Annotated[int, Field(strict=True, ge=1, le=4096)]
    height: Annotated[int, Field(strict=True, ge=1, le=4096)]


class ImageSpace(Message):
    channels: Annotated[int, Field(strict=True, ge=1, le=4)]
    description: StrictStr
    tasks: Annotated[list[StrictStr], Field(max_length=100000)] | None = None


class ImportedPolicy(Message):
    name: StrictStr
    version: StrictStr | None


class InclusionProof(Message):
    leaf_index: Annotated[int, Field(strict=True, ge=0)]
    tree_size: Annotated[int, Field(strict=True, ge=1)]
    hashes: Annotated[
        list[Annotated[str, Field(strict=True, pattern=r"^[0-9a-f]{64}$")]],
        Field(max_length=64),
    ]


class Interval(Message):
    """95 % interval."""

    low: StrictFloat
    high: StrictFloat


class JudgedRun(Message):
    """How people judged the run; with the profile `physical`."""

    judges: Annotated[list[StrictStr], Field(max_length=1000)]
    """Names of the people that are not their accounts, as in records."""
    judgements: Annotated[int, Field(strict=True, ge=0)]
    """Episodes with a judgement."""
    blind: StrictBool
    """Whether each judge knew nothing of the policy."""
    voids: Annotated[dict[str, StrictInt], Field(max_length=100000)]
    """How many trials were void, by reason."""
    notes: Annotated[dict[str, StrictStr], Field(max_length=100000)]
    """What judges wrote, by episode_id."""
    cells: Annotated[dict[str, StrictStr], Field(max_length=100000)] | None = None
    """The cell at which an episode was judged, by episode_id; absent where the benchmark has one cell."""
    second: SecondJudgements | None = None


class KeyList(Message):
    keys: Annotated[list[PublicKey], Field(max_length=10000)]


class Lease(Message):
    expires_at: datetime
    """When the session ends, unless a request extends it."""
    idle_timeout_s: StrictFloat
    """Length of the lease."""


class Leaving(Message):
    """That a worker has left an episode, by its own words; for the profile `reasons`."""

    attempt: Annotated[int, Field(strict=True, ge=1)]
    """The attempt that was in play."""
    reason: StrictStr
    """Why the worker has left it."""


class Limits(Message):
    max_body_bytes: Annotated[int, Field(strict=True, ge=65536)]
    """Longest request body that is read, except by `import_record`."""
    max_workers: Annotated[int, Field(strict=True, ge=1)]
    """Most live workers a run may ask for."""
    max_chunk: Annotated[int, Field(strict=True, ge=4)]
    """Most actions in one predict; a benchmark may allow fewer."""
    idle_timeout_s_min: StrictFloat
    """Shortest lease of a session that a run may have."""
    idle_timeout_s_max: StrictFloat
    """Longest lease of a session that a run may have."""
    wait_s_max: StrictInt
    """Longest wait that a long-poll is granted."""
    max_header_bytes: Annotated[int, Field(strict=True, ge=8192)] | None = None
    """Longest request line with its headers that is read; for the profile `limits`."""
    header_timeout_s: Annotated[float, Field(strict=True, ge=0)] | None = None
    """Time in which the headers of a request are complete, from its first byte; for the profile `limits`."""
    body_timeout_s: Annotated[float, Field(strict=True, ge=0)] | None = None
    """Time in which a part of a body arrives after the headers of its request; for the profile `limits`."""
    heartbeat_s_max: Annotated[float, Field(strict=True, ge=1)] | None = None
    """Longest time that a session lives without a new turn, or its `idle_timeout_s` if that is longer; for the profile `limits`."""
    unused_s_max: Annotated[float, Field(strict=True, ge=0)] | None = None
    """When others wait: the time after which a run without a worker, or a session without a turn, may make room; for the profile `limits`."""
    max_control_body_bytes: Annotated[int, Field(strict=True, ge=65536)] | None = None
    """Longest body that is read of a request other than `predict` and `import_record`, where it is less than `max_body_bytes`; for the profile `limits`."""
    max_open_runs: Annotated[int, Field(strict=True, ge=1)] | None = None
    """Most runs of one account that are queued, ready, running or stopping; for the profile `limits`."""
    max_idempotency_keys: Annotated[int, Field(strict=True, ge=1)] | None = None
    """Most Idempotency-Keys that one account may use; for the profile `limits`."""
    max_stored_bytes: Annotated[int, Field(strict=True, ge=1)] | None = None
    """Most bytes that one account may have stored, see [LIM-010](profiles/limits.md). For the profile `limits`."""
    max_record_bytes: Annotated[int, Field(strict=True, ge=65536)] | None = None
    """Longest archive that `import_record` reads; for the profile `record_import`."""
    max_waiting_imports: Annotated[int, Field(strict=True, ge=1)] | None = None
    """Most imports of one account that are not `finished`; for the profile `record_import`."""
    max_imported_bytes: Annotated[int, Field(strict=True, ge=65536)] | None = None
    """Most bytes that the archives of one account may have together; for the profile `record_import`."""
    run_keep_days: Annotated[float, Field(strict=True, ge=0)] | None = None
    """Days without a change after which a run that has completed, failed or been stopped may be deleted; when absent, none is. For the profile `deletion`."""


class Observation(Message):
    state: Annotated[
        dict[str, Annotated[list[StrictFloat], Field(max_length=1000000)]],
        Field(max_length=1024),
    ]
    images: Annotated[dict[str, Image], Field(max_length=256)]
    tensors: Annotated[dict[str, Tensor], Field(max_length=1024)]


class ObservationSpace(Message):
    state: Annotated[dict[str, VectorSpace], Field(max_length=1024)]
    images: Annotated[dict[str, ImageSpace], Field(max_length=256)]
    tensors: Annotated[dict[str, TensorSpace], Field(max_length=1024)]


class Observe(StrEnum):
    """`last` when absent; `all` adds the observation after every executed action. For the profile `observations`."""

    LAST = "last"
    ALL = "all"


class Outcome(StrEnum):
    SUCCESS = "success"
    FAILURE = "failure"
    ABANDONED = "abandoned"


class OutcomeCounts(Message):
    total: StrictInt
    """All episodes."""
    success: StrictInt
    failure: StrictInt
    abandoned: StrictInt
    """Scored 0, because the last attempt was closed."""
    unscored: StrictInt
    """Without a result so far."""


class PartAssumption(Message):
    """About the part of this name."""

    start: Annotated[int, Field(strict=True, ge=0)] | None = None
    size: Annotated[int, Field(strict=True, ge=1)] | None = None
    quantity: (
        Annotated[str, Field(strict=True, pattern=r"^[a-z][a-z0-9_]{0,63}$")] | None
    ) = None
    """A name of registry/quantities.yaml, or an extension."""
    unit: Annotated[str, Field(strict=True, max_length=64)] | None = None
    scale: StrictFloat | None = None
    frame: Annotated[str, Field(strict=True, max_length=64)] | None = None
    rotation: (
        Annotated[str, Field(strict=True, pattern=r"^[a-z][a-z0-9_]{0,63}$")] | None
    ) = None
    """A name of registry/rotations.yaml, or an extension."""
    relative_to: (
        Annotated[str, Field(strict=True, pattern=r"^[a-z][a-z0-9_]{0,63}$")] | None
    ) = None
    """A name of registry/relative_modes.yaml, or an extension."""
    gripper_open: StrictFloat | None = None
    gripper_closed: StrictFloat | None = None


class Player(Message):
    """Who plays, by its own words; for the profile `attribution`."""

    name: Annotated[str, Field(strict=True, min_length=1, max_length=200)]
    """Of the policy, as in `policy` of the run."""
    version: Annotated[str, Field(strict=True, max_length=200)] | None = None
    """Of the policy."""
    client: Annotated[str, Field(strict=True, max_length=200)] | None = None
    """The program that attaches and its version."""


class PlayerView(Message):
    """The `player` of an `attach_worker`."""

    name: StrictStr
    version: StrictStr | None = None
    client: StrictStr | None = None


class PolicyDescription(Message):
    """What a policy server says of itself."""

    name: Annotated[str, Field(strict=True, min_length=1, max_length=200)]
    version: Annotated[str, Field(strict=True, max_length=200)] | None = None
    protocol: ProtocolRange
    max_sessions: Annotated[int, Field(strict=True, ge=1, le=1024)]
    """Most episodes that it plays at a time."""
    assumes: Assumptions | None = None


class PolicyInfo(Message):
    name: Annotated[str, Field(strict=True, min_length=1, max_length=200)]
    """What the policy is called in results."""
    version: Annotated[str, Field(strict=True, max_length=200)] | None = None
    """Which state of it, for example a checkpoint."""
    submitter: Annotated[str, Field(strict=True, max_length=200)] | None = None
    """Who submits it."""
    homepage: (
        Annotated[
            str, Field(strict=True, max_length=500, pattern=r"^https?:\/\/[!-~]+$")
        ]
        | None
    ) = None
    """Where to read about it."""


class PolicyProtocol(StrEnum):
    """`proctor` is policy.yaml. `openai_chat` asks for a chat completion at `chat/completions` below the URL, for benchmarks that are answered in words. `openai_completions` asks for the completion of a text at `completions` below the URL, for such benchmarks without images."""

    PROCTOR = "proctor"
    OPENAI_CHAT = "openai_chat"
    OPENAI_COMPLETIONS = "openai_completions"


class PolicyReset(Message):
    """The policy is ready for this attempt and no other."""

    session_id: StrictStr
    episode_id: StrictStr
    attempt: Annotated[int, Field(strict=True, ge=1)]


class PolicyServer(Message):
    """Where the server finds the policy of a run with mode `push`, and how it calls it."""

    url: Annotated[
        str,
        Field(
            strict=True,
            max_length=500,
            pattern=r"^https?:\/\/[A-Za-z0-9.:_\[\]-]+(\/[A-Za-z0-9._~%\/-]*)?$",
        ),
    ]
    """Base URL, without user, query or fragment; the path of an operation is appended to it."""
    protocol: PolicyProtocol
    api_key: (
        Annotated[
            str, Field(strict=True, min_length=1, max_length=4096, pattern=r"^[!-~]+$")
        ]
        | None
    ) = None
    """Sent as bearer token with every call, and never shown."""
    model: Annotated[str, Field(strict=True, min_length=1, max_length=200)] | None = (
        None
    )
    """Which model is asked, where a protocol knows several."""
    call_timeout_s: Annotated[float, Field(strict=True, ge=0.1, le=600)] | None = None
    """Time for one call, from connecting to the last byte of its answer; 30 when absent."""
    max_concurrent: Annotated[int, Field(strict=True, ge=1, le=1024)] | None = None
    """Most episodes played and calls made at a time; as many as the policy, the run and the server allow when absent."""
    max_retries: Annotated[int, Field(strict=True, ge=0, le=10)] | None = None
    """How often a call that was not answered is repeated; 3 when absent."""
    generation: Annotated[dict[str, StrictFloat], Field(max_length=32)] | None = None
    """Numbers that a chat completion is asked with, such as `temperature` and `max_tokens`; for `openai_chat` and `openai_completions` alone."""


class PolicyServerView(Message):
    """The policy server of a run with mode `push`, with what was left open filled in, and without its key."""

    url: StrictStr
    protocol: Annotated[str, Field(strict=True, pattern=r"^[a-z][a-z0-9_]{0,63}$")]
    """A `PolicyProtocol`, or one of a later version."""
    has_api_key: StrictBool
    model: StrictStr | None = None
    call_timeout_s: StrictFloat
    max_concurrent: StrictInt
    max_retries: StrictInt
    generation: Annotated[dict[str, StrictFloat], Field(max_length=32)] | None = None


class Predict(Message):
    session_id: Annotated[str, Field(strict=True, min_length=1, max_length=128)]
    """Session of `attach_worker`."""
    seq: Annotated[int, Field(strict=True, ge=1, le=9007199254740991)]
    """Number of the turn, 1 for the first one; a repeat has the same number."""
    actions: Annotated[list[Action], Field(min_length=1, max_length=65536)]
    observe: Observe | None = None


class Problem(Message):
    """RFC 9457, with what a client needs to decide on a retry."""

    type: StrictStr
    """`urn:proctor:problem:` and the code."""
    title: StrictStr
    """What the code means."""
    status: Annotated[int, Field(strict=True, ge=400, le=599)]
    """Status of the response."""
    detail: StrictStr
    """What happened and what to do about it."""
    code: StrictStr
    """One of x-problems, or one of a later version."""
    retryable: StrictBool
    """Whether the same request can succeed later."""
    side_effects: SideEffects
    errors: Annotated[list[ProblemItem], Field(max_length=1000000)] | None = None
    requirement: (
        Annotated[str, Field(strict=True, pattern=r"^[A-Z]{2,6}-[0-9]{3}$")] | None
    ) = None
    """Id of the rule that was enforced."""
    state: RunState | None = None
    expected_seq: Annotated[int, Field(strict=True, ge=1)] | None = None
    """Of `seq_out_of_order`: the next seq."""
    ended_by: (
        Annotated[str, Field(strict=True, pattern=r"^[a-z][a-z0-9_]{0,63}$")] | None
    ) = None
    """What ended the session, as far as the server still knows; `unknown` after a restart, and for a session that was taken over and whose successor has ended."""
    entry_id: StrictStr | None = None
    """Of `result_published`: the entry of that result."""
    limit: StrictStr | None = None
    """Of `quota_exceeded` and `no_capacity`: the limit that was reached, where the server names it."""


class ProblemItem(Message):
    pointer: StrictStr
    """JSON pointer into the body, to the faulty member or a part of it; or `query:name`, `header:name`, `path:name`; or `record:name`, with the name of a file in a record, or `archive`."""
    detail: StrictStr
    """What is wrong there."""


class Progress(Message):
    episodes_total: StrictInt
    """How many episodes the run has."""
    episodes_scored: StrictInt
    """Abandoned ones included."""
    episodes_in_progress: StrictInt
    """How many are played now."""
    episodes_pending: StrictInt
    """How many wait to be played."""


class ProtocolRange(Message):
    min: Annotated[str, Field(strict=True, pattern=r"^[0-9]{1,4}\.[0-9]{1,4}$")]
    """Lowest version that is spoken."""
    max: Annotated[str, Field(strict=True, pattern=r"^[0-9]{1,4}\.[0-9]{1,4}$")]
    """Highest version that is spoken."""


class PublicKey(Message):
    keyid: StrictStr
    """`SHA256:` and the SHA-256 of the key in hexadecimal digits."""
    algorithm: StrictStr
    """`ed25519`, or another one of a later version."""
    public_key: StrictStr
    """Its 32 bytes."""
    created_at: datetime
    retired_at: datetime | None
    """When it signed for the last time; null for the key in use."""


class PublishEntry(Message):
    """What an entry says of itself; a member that is absent is not shown."""

    model_name: Annotated[str, Field(strict=True, min_length=1, max_length=200)]
    """What the entry is called."""
    is_public: StrictBool
    """Whether others see the entry, and whether it has a rank."""
    model_type: (
        Annotated[str, Field(strict=True, min_length=1, max_length=64)] | None
    ) = None
    """What kind of model it is, for example `VLA` or `diffusion policy`."""
    organisation: (
        Annotated[str, Field(strict=True, min_length=1, max_length=200)] | None
    ) = None
    homepage: (
        Annotated[
            str, Field(strict=True, max_length=500, pattern=r"^https?:\/\/[!-~]+$")
        ]
        | None
    ) = None
    """Where to read about the model."""
    code_url: (
        Annotated[
            str, Field(strict=True, max_length=500, pattern=r"^https?:\/\/[!-~]+$")
        ]
        | None
    ) = None
    """Where its code is."""
    notes: Annotated[str, Field(strict=True, max_length=2000)] | None = None
    """Anything else, for readers."""


class RankInterval(Message):
    """The ranks that an entry may have; absent for an entry that is flagged."""

    low: Annotated[int, Field(strict=True, ge=1)]
    """The best one."""
    high: Annotated[int, Field(strict=True, ge=1)]
    """The worst one."""


class RankedEntry(Message):
    entry: BoardEntry
    rank: RankInterval | None = None
    better: Annotated[int, Field(strict=True, ge=0)]
    """How many entries are significantly better; 0 without a rank."""
    worse: Annotated[int, Field(strict=True, ge=0)]
    """How many entries are significantly worse; 0 without a rank."""
    letters: Annotated[
        list[Annotated[str, Field(strict=True, pattern=r"^[a-z]{1,8}$")]],
        Field(max_length=100000),
    ]
    """Entries that cannot be distinguished have a letter in common, others have none in common; empty without a rank."""


class Ranking(Message):
    """See board.md for every number here."""

    benchmark_id: StrictStr
    manifest_sha256: Annotated[str, Field(strict=True, pattern=r"^[0-9a-f]{64}$")]
    """The digest of a [manifest](benchmarks.md#the-manifest), which is all of a benchmark that can change a score. It is the same on every server (BEN-006)."""
    episodes_total: StrictInt | None
    """How many episodes each entry has; null where the manifest has no entry."""
    ranked: Annotated[int, Field(strict=True, ge=0)]
    """How many entries have a rank."""
    comparisons: Annotated[int, Field(strict=True, ge=0)]
    """How many pairs of them were tested."""
    alpha: StrictFloat
    """How likely it is at most that any two equally good policies are distinguished; 0.05."""
    differing_min: StrictInt | None
    """Two entries that differ on fewer episodes can never be distinguished; null if the benchmark has fewer episodes."""
    differing_enough: StrictInt | None
    """Two entries that differ on so many episodes, all to the advantage of one, are distinguished, however the others fared; null if the benchmark has fewer episodes."""
    rows: Annotated[list[RankedEntry], Field(max_length=1000)]
    next_cursor: (
        Annotated[str, Field(strict=True, pattern=r"^[A-Za-z0-9_-]{1,128}$")] | None
    )


class RecordImport(Message):
    """A record that was handed in, and what is known of it here."""

    import_id: Annotated[str, Field(strict=True, pattern=r"^[A-Za-z0-9_-]{1,64}$")]
    state: Annotated[str, Field(strict=True, pattern=r"^[a-z][a-z0-9_]{0,63}$")]
    """`waiting` for simulators, `replaying`, or `finished`."""
    level: Annotated[str, Field(strict=True, pattern=r"^[a-z][a-z0-9_]{0,63}$")]
    """`reported`: whole, by anyone; `signed` by a key that this server knows; `replayed` here with the same results; `diverged`: the replay came out otherwise."""
    level_text: StrictStr
    """The level with who says it, as REC-031 has it."""
    signer: StrictStr | None
    """Whose key signed the record, as this server knows it; null for a key that it does not know."""
    keyid: StrictStr
    """Of the key that signed the record."""
    archive_sha256: Annotated[str, Field(strict=True, pattern=r"^[0-9a-f]{64}$")]
    statement_sha256: Annotated[str, Field(strict=True, pattern=r"^[0-9a-f]{64}$")]
    size_bytes: Annotated[int, Field(strict=True, ge=1)]
    run_id: StrictStr
    """In the statement, as are the members below it."""
    benchmark_id: StrictStr
    benchmark_version: StrictStr
    manifest_sha256: Annotated[str, Field(strict=True, pattern=r"^[0-9a-f]{64}$")]
    policy: ImportedPolicy
    score: StrictFloat | None
    """Null where an episode has no result."""
    episodes: Annotated[int, Field(strict=True, ge=1)]
    episodes_replayed: Annotated[int, Field(strict=True, ge=0)]
    """How many of them were simulated so far."""
    replay: RecordReplay | None = None
    reason: StrictStr | None
    """Why there is no replay."""
    imported_at: datetime
    finished_at: datetime | None


class RecordImportList(Message):
    imports: Annotated[list[RecordImport], Field(max_length=1000)]
    next_cursor: (
        Annotated[str, Field(strict=True, pattern=r"^[A-Za-z0-9_-]{1,128}$")] | None
    )


class RecordReplay(Message):
    """As in a verdict (record.md); absent before the end of the replay, and where there is none."""

    result: Annotated[str, Field(strict=True, pattern=r"^[a-z][a-z0-9_]{0,63}$")]
    """`exact`, `outcome` or `diverged`."""
    episodes: Annotated[int, Field(strict=True, ge=1)]
    exact: Annotated[int, Field(strict=True, ge=0)]
    outcome: Annotated[int, Field(strict=True, ge=0)]
    diverged: Annotated[int, Field(strict=True, ge=0)]
    first_divergence: ReplayDivergence | None = None


class ReplayDivergence(Message):
    """The first state that was another one; absent where every state was met."""

    episode_index: Annotated[int, Field(strict=True, ge=0)]
    attempt: Annotated[int, Field(strict=True, ge=0)]
    step: Annotated[int, Field(strict=True, ge=0)]
    """After how many steps of the attempt the state was another one."""


class ResetPolicy(Message):
    """An attempt begins; whatever the policy remembers of this session is over."""

    session_id: Annotated[str, Field(strict=True, min_length=1, max_length=128)]
    run_id: StrictStr | None = None
    benchmark: Benchmark
    episode: EpisodeView


class Run(Message):
    run_id: StrictStr
    """Names the run in every path."""
    state: RunState
    reason: StrictStr | None
    """Why the run is in this state, for people; never null when failed."""
    retryable: StrictBool | None
    """Whether a failed run may be resumed; null in other states."""
    failed_by: (
        Annotated[str, Field(strict=True, pattern=r"^[a-z][a-z0-9_]{0,63}$")] | None
    ) = None
    """Who made a run fail: the `policy`, the `simulator` or the `server`. In a failed run alone, where the server knows it."""
    benchmark_id: StrictStr
    benchmark_version: StrictStr
    """Version of the benchmark when the run was submitted."""
    manifest_sha256: Annotated[str, Field(strict=True, pattern=r"^[0-9a-f]{64}$")]
    """The digest of a [manifest](benchmarks.md#the-manifest), which is all of a benchmark that can change a score. It is the same on every server (BEN-006)."""
    policy: RunPolicy
    mode: (
        Annotated[str, Field(strict=True, pattern=r"^[a-z][a-z0-9_]{0,63}$")] | None
    ) = None
    """A `RunMode`, or one of a later version; `pull` when absent."""
    policy_server: PolicyServerView | None = None
    any_policy: StrictBool | None = None
    """Whether workers may play for another policy than `policy`; for the profile `attribution`."""
    select: SelectionView | None = None
    max_workers: StrictInt
    """Most live workers that it may have."""
    idle_timeout_s: StrictFloat
    """Lease of its sessions."""
    images: ImageChoice
    endpoint: StrictStr
    """Base URL of the data plane for this run; the path of an operation is appended to it."""
    queue_position: StrictInt | None
    """1 is next; null unless queued."""
    live_workers: Annotated[int, Field(strict=True, ge=0)]
    """How many workers have a live session."""
    progress: Progress
    created_at: datetime
    """When it was submitted."""
    updated_at: datetime
    """When it changed for the last time; a change that was taken back before it was shown need not count."""
    runs_played_before: Annotated[int, Field(strict=True, ge=0)] | None = None
    """How many runs of this benchmark its submitter had played before this run was played, deleted ones too; absent before this run is played (DEL-006). For the profile `deletion`."""
    judged: JudgedRun | None = None
    account: StrictStr | None = None
    """The account that owns the run. For the profile `accounts`."""
    attempts_by_submitter: Annotated[int, Field(strict=True, ge=1)] | None = None
    """How many runs of this benchmark its submitter had submitted, this one included; for the profile `record`."""


class RunList(Message):
    runs: Annotated[list[Run], Field(max_length=1000)]
    next_cursor: (
        Annotated[str, Field(strict=True, pattern=r"^[A-Za-z0-9_-]{1,128}$")] | None
    )


class RunMode(StrEnum):
    """`pull` when absent: workers attach and predict. `push`: the server calls the policy itself, and workers of the run are its own."""

    PULL = "pull"
    PUSH = "push"


class RunPolicy(Message):
    """A `PolicyInfo` as it was submitted. A run of an earlier server may have a homepage of another form."""

    name: StrictStr
    version: StrictStr | None = None
    submitter: StrictStr | None = None
    homepage: StrictStr | None = None


class RunState(StrEnum):
    QUEUED = "queued"
    READY = "ready"
    RUNNING = "running"
    STOPPING = "stopping"
    STOPPED = "stopped"
    FAILED = "failed"
    COMPLETED = "completed"


class Score(Message):
    """See scoring.md for every number here."""

    run_id: StrictStr
    benchmark_id: StrictStr
    manifest_sha256: Annotated[str, Field(strict=True, pattern=r"^[0-9a-f]{64}$")]
    """The digest of a [manifest](benchmarks.md#the-manifest), which is all of a benchmark that can change a score. It is the same on every server (BEN-006)."""
    select: SelectionView | None = None
    state: RunState
    complete: StrictBool
    """Every episode has a result."""
    score: StrictFloat | None
    """Null until complete."""
    score_low: StrictFloat
    """The score if every missing episode got 0."""
    score_high: StrictFloat
    """The score if every missing episode got 1."""
    counts: OutcomeCounts
    success_rate: StrictFloat | None
    """Successes among the scored episodes."""
    success_interval: Interval
    mean: StrictFloat | None
    """Mean over the scored episodes."""
    mean_interval: Interval
    by_task: Annotated[dict[str, GroupScore], Field(max_length=100000)]
    by_split: Annotated[dict[str, GroupScore], Field(max_length=100000)]


class SecondJudgements(Message):
    """How a second person judged a sample of the episodes of a run; see profiles/physical.md."""

    drawn: Annotated[int, Field(strict=True, ge=0)]
    """Episodes of the sample with a first judgement."""
    judgements: Annotated[int, Field(strict=True, ge=0)]
    """Those of them with a second one."""
    judges: Annotated[list[StrictStr], Field(max_length=1000)]
    """Names of the second judges that are not their accounts."""
    both: Annotated[int, Field(strict=True, ge=0)]
    """Episodes that both judges called a success."""
    first_alone: Annotated[int, Field(strict=True, ge=0)]
    """Those that the first judge alone called one."""
    second_alone: Annotated[int, Field(strict=True, ge=0)]
    """Those that the second judge alone called one."""
    neither: Annotated[int, Field(strict=True, ge=0)]
    """Those that no judge called one."""
    kappa: Annotated[float, Field(strict=True, ge=-1, le=1)] | None
    """Cohen's kappa of these; null where chance alone would make them agree."""


class SelectionView(Message):
    """The `select` of a run, as it was submitted."""

    tasks: Annotated[list[StrictStr], Field(max_length=100000)] | None = None
    splits: Annotated[list[StrictStr], Field(max_length=100000)] | None = None


class Service(Message):
    """What a server says of itself before anyone authenticates."""

    name: StrictStr
    """Name of the server software."""
    version: StrictStr
    """Version of the server software."""
    protocol: ProtocolRange
    profiles: Annotated[
        list[Annotated[str, Field(strict=True, pattern=r"^[a-z][a-z0-9_]{0,63}$")]],
        Field(max_length=256),
    ]
    """Parts of the protocol offered, which [levels](levels.md) explains; `core` may be left out, for it always is. An operation with `x-profile` is there when its profile is announced. The rules of the profile `crash` are not announced. The kit judges them where it may kill and restart a server of the level Service; a server whose runs do not outlive its process is certified without them and without EVT-009, PUSH-017, REC-123 and REC-124, and its report says that they were not verified. Those of the profile `cluster` are not announced, either. They bind a service that is reached at several base URLs, and the kit judges them where it is given all of these."""
    limits: Limits
    encodings: Annotated[list[StrictStr], Field(max_length=64)]
    """Media types of the data plane."""
    image_codecs: Annotated[
        list[Annotated[str, Field(strict=True, pattern=r"^[a-z][a-z0-9_]{0,63}$")]],
        Field(max_length=256),
    ]
    server_time: datetime
    """The server's clock, UTC."""


class SideEffects(StrEnum):
    NONE = "none"
    POSSIBLE = "possible"


class SimulatorInfo(Message):
    name: StrictStr
    version: StrictStr
    quality: StrictStr | None = None
    """Named rendering quality, where there is one."""
    sources: Annotated[dict[str, StrictStr], Field(max_length=100000)] | None = None
    """File that the simulator [loads](simulator.md) → its SHA-256: an edit of it makes another manifest. Absent where none is announced."""


class StopMode(StrEnum):
    """`abort` when absent. `drain` is for the profile `control`."""

    ABORT = "abort"
    DRAIN = "drain"


class StopRun(Message):
    mode: StopMode | None = None
    reason: Annotated[str, Field(strict=True, min_length=1, max_length=500)] | None = (
        None
    )
    """Why the run is stopped, for people (RSN-004). For the profile `reasons`."""


class SubmitRun(Message):
    benchmark_id: Annotated[str, Field(strict=True, pattern=r"^[a-z][a-z0-9_]{0,63}$")]
    """One of `list_benchmarks`."""
    policy: PolicyInfo
    max_workers: Annotated[int, Field(strict=True, ge=1, le=1024)] | None = None
    """Most live workers wanted; the server's limit when absent."""
    idle_timeout_s: Annotated[float, Field(strict=True, ge=1, le=86400)] | None = None
    """Lease of a session; the server's maximum when absent. For the profile `sessions`."""
    images: ImageChoice | None = None
    options: CalibrationOptions | None = None
    mode: RunMode | None = None
    policy_server: PolicyServer | None = None
    any_policy: StrictBool | None = None
    """Workers may play for another policy than `policy`; false when absent; for the profile `attribution`."""
    select: EpisodeSelection | None = None


class SuccessRule(StrEnum):
    ANY_STEP = "any_step"
    LAST_STEP = "last_step"


class Tensor(Message):
    """C order, little-endian; a bool is one byte, 0 or 1."""

    dtype: Annotated[str, Field(strict=True, pattern=r"^[a-z][a-z0-9_]{0,63}$")]
    shape: Annotated[
        list[Annotated[int, Field(strict=True, ge=0)]], Field(max_length=64)
    ]
    data: StrictStr
    """Base64 with padding in JSON; `bin` in MessagePack."""


class TensorSpace(Message):
    dtype: Annotated[str, Field(strict=True, pattern=r"^[a-z][a-z0-9_]{0,63}$")]
    shape: Annotated[
        list[Annotated[int, Field(strict=True, ge=0)]], Field(max_length=64)
    ]
    description: StrictStr
    tasks: Annotated[list[StrictStr], Field(max_length=100000)] | None = None


class Timing(Message):
    """Server time of this turn, in seconds."""

    total_s: Annotated[float, Field(strict=True, ge=0)]
    """The whole turn on the server."""
    queue_s: Annotated[float, Field(strict=True, ge=0)]
    """Waiting for the simulator."""
    simulate_s: Annotated[float, Field(strict=True, ge=0)]
    """Executing actions."""
    render_s: Annotated[float, Field(strict=True, ge=0)]
    """Rendering images."""
    encode_s: Annotated[float, Field(strict=True, ge=0)]
    """Encoding of images."""


class Turn(Message):
    """The answer to attach (turn 0, or in a repeat the latest turn) and to predict."""

    session_id: StrictStr
    """Names the session in every later request."""
    seq: Annotated[int, Field(strict=True, ge=0)]
    """Number of the turn."""
    episode: EpisodeView | None = None
    observation: Observation | None = None
    observations: Annotated[list[Observation], Field(max_length=65536)] | None = None
    """With `observe` all, one per executed action."""
    executed_steps: Annotated[int, Field(strict=True, ge=0)]
    """How many actions of the chunk were executed."""
    stopped_early: StrictBool
    """The episode ended before the chunk did."""
    rewards: Annotated[list[StrictFloat], Field(max_length=65536)]
    """One per executed action."""
    terminated: StrictBool
    """The task ended by itself in this turn."""
    truncated: StrictBool
    """The step limit ended the episode in this turn."""
    episode_result: EpisodeResult | None = None
    fault: Fault | None = None
    done: StrictBool
    """No episode is left for this session. It holds no slot any more; its last turn can be repeated until its lease ends."""
    lease: Lease
    timing: Timing


class VectorPart(Message):
    """Adjacent numbers of a vector, with every convention a policy could get wrong."""

    start: Annotated[int, Field(strict=True, ge=0)]
    """Index of its first number in the vector."""
    size: Annotated[int, Field(strict=True, ge=1)]
    quantity: Annotated[str, Field(strict=True, pattern=r"^[a-z][a-z0-9_]{0,63}$")]
    """A name of registry/quantities.yaml, or an extension."""
    unit: Annotated[
        str, Field(strict=True, pattern=r"^[A-Za-z0-9][A-Za-z0-9_*\/^]{0,63}$")
    ]
    """A name of registry/units.yaml, or an extension."""
    scale: StrictFloat | None = None
    """A number times `scale` is in `unit`; 1 when absent."""
    frame: Annotated[str, Field(strict=True, pattern=r"^[a-z][a-z0-9_]{0,63}$")]
    """A name of registry/frames.yaml, or an extension."""
    rotation: Annotated[str, Field(strict=True, pattern=r"^[a-z][a-z0-9_]{0,63}$")]
    """A name of registry/rotations.yaml, or an extension."""
    relative_to: Annotated[str, Field(strict=True, pattern=r"^[a-z][a-z0-9_]{0,63}$")]
    """A name of registry/relative_modes.yaml, or an extension."""
    gripper_open: StrictFloat | None = None
    """The value that means fully open."""
    gripper_closed: StrictFloat | None = None
    """The value that means fully closed."""
    description: StrictStr | None = None


class VectorSpace(Message):
    """One named vector of numbers, in parts: see [conventions](conventions.md#parts)."""

    size: Annotated[int, Field(strict=True, ge=1)]
    parts: (
        Annotated[dict[str, VectorPart], Field(min_length=1, max_length=256)] | None
    ) = None
    """Name → what these numbers are. Only descriptions of earlier drafts have none."""
    minimum: Annotated[list[StrictFloat], Field(max_length=1000000)] | None = None
    maximum: Annotated[list[StrictFloat], Field(max_length=1000000)] | None = None
    out_of_range: Annotated[str, Field(strict=True, pattern=r"^[a-z][a-z0-9_]{0,63}$")]
    description: StrictStr | None = None
    """What the numbers are."""
    tasks: Annotated[list[StrictStr], Field(max_length=100000)] | None = None
    """The tasks that have this entry; all of them when absent."""
