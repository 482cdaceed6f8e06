/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

/* The messages of the protocol. A member that a later version of it added is kept in the object. */

export interface Action {
    /** Name → vector, exactly the entries of the benchmark's action space. */
    values: Record<string, number[]>;
}

/** About a vector. All members but `size` and `parts` are about each of its parts (CONV-004). */
export interface Assumption {
    size?: number;
    /** A name of registry/quantities.yaml, or an extension. */
    quantity?: string;
    unit?: string;
    scale?: number;
    frame?: string;
    /** A name of registry/rotations.yaml, or an extension. */
    rotation?: string;
    /** A name of registry/relative_modes.yaml, or an extension. */
    relative_to?: string;
    gripper_open?: number;
    gripper_closed?: number;
    parts?: Record<string, PartAssumption>;
}

/** What the policy takes for granted; refused when the benchmark says otherwise (ATT-010). For the profile `conventions`. */
export interface Assumptions {
    control_rate_hz?: number;
    action?: Record<string, Assumption>;
    state?: Record<string, Assumption>;
}

export interface AttachWorker {
    /** New for every attachment; repeated only to repeat a lost request. */
    attach_key: string;
    /** Fence out a live session; false when absent. For the profile `sessions`. */
    takeover?: boolean;
    assumes?: Assumptions;
    player?: Player;
    /** How many of the first episodes of the run are wanted; the session begins none behind them (SUB-005). All when absent. For the profile `subsets`. */
    first_episodes?: number;
}

/** Everything about a benchmark that can change a score. */
export interface Benchmark {
    benchmark_id: string;
    version: string;
    title: string;
    description: string;
    /** The digest of a [manifest](benchmarks.md#the-manifest), which is all of a benchmark that can change a score. It is the same on every server (BEN-006). */
    manifest_sha256: string;
    episodes_total: number;
    tasks: string[];
    /** Task → when its goal holds, in a sentence for people; absent where nothing is said. */
    task_goals?: Record<string, string>;
    splits: string[];
    /** Splits whose seeds the host draws in secret; none when absent. */
    sealed_splits?: string[];
    /** What the host commits itself to without showing it, the SHA-256 of a secret salt and the sealed seeds. With both disclosed later, anyone can prove which seeds were played. */
    seeds_sha256?: string;
    /** Actions per simulated second. */
    control_rate_hz: number;
    /** Steps after which an episode is truncated. */
    max_steps: number;
    max_chunk: number;
    max_attempts: number;
    max_faults: number;
    /** A `SuccessRule`, or one of a later version. */
    success_rule: string;
    /** Name of an action value → what it means. */
    action_space: Record<string, VectorSpace>;
    observation_space: ObservationSpace;
    /** Sizes that may be chosen at submit; the first is the default. */
    image_sizes: ImageSize[];
    /** Codecs that may be chosen at submit; the first is the default. */
    image_codecs: string[];
    simulator: SimulatorInfo;
    /** Why a run cannot be submitted here now, and the cure; null when it can. */
    unavailable_reason: string | null;
}

export interface BenchmarkList {
    benchmarks: BenchmarkSummary[];
}

export interface BenchmarkSummary {
    benchmark_id: string;
    version: string;
    title: string;
    /** The digest of a [manifest](benchmarks.md#the-manifest), which is all of a benchmark that can change a score. It is the same on every server (BEN-006). */
    manifest_sha256: string;
    episodes_total: number;
}

export interface BoardEntry {
    /** Names the entry in every path. */
    entry_id: string;
    run_id: string;
    /** Name of the account that submitted the run. */
    submitter: string;
    benchmark_id: string;
    benchmark_version: string;
    /** The digest of a [manifest](benchmarks.md#the-manifest), which is all of a benchmark that can change a score. It is the same on every server (BEN-006). */
    manifest_sha256: string;
    select?: SelectionView;
    policy: RunPolicy;
    model_name: string;
    is_public: boolean;
    model_type?: string;
    organisation?: string;
    homepage?: string;
    code_url?: string;
    notes?: string;
    state: string;
    flag?: EntryFlag;
    /** What is known of the score: `reported` by the server alone; `signed`, for the run has a record that this host signs; `sealed`, for its seeds were drawn after the host was committed to the policy. */
    level: string;
    /** How many runs of the benchmark the account has submitted until now, published or not. */
    attempts: number;
    score: EntryScore;
    /** When the entry was made. */
    published_at: Date;
    /** When the description, the state or the flag changed for the last time. */
    changed_at: Date;
}

export interface BoardEntryList {
    entries: BoardEntry[];
    next_cursor: string | null;
}

/** Only for the benchmark `calibration`, which the submitter shapes. */
export interface CalibrationOptions {
    /** One entry per episode, in order; one `score` episode when absent. */
    tasks?: CalibrationTask[];
    /** 10 when absent. */
    max_steps?: number;
    success_rule?: SuccessRule;
    /** 3 when absent. For the profile `sessions`. */
    max_attempts?: number;
    /** 3 when absent. For the profile `faults`. */
    max_faults?: number;
    /** Whether the seeds of the split `odd` are sealed; false when absent. Only for servers that announce the profile `sealed_seeds`. */
    sealed?: boolean;
    /** Seconds for which the run stays queued after submit and after resume; 0 when absent. For the profile `control`. */
    queue_s?: number;
}

/** `echo` is for the profile `observations`, `fault` for `faults`. */
export const CalibrationTask = {
    Score: 'score',
    Count: 'count',
    Echo: 'echo',
    Delay: 'delay',
    Fault: 'fault',
} as const;
export type CalibrationTask = (typeof CalibrationTask)[keyof typeof CalibrationTask];

export interface Checkpoint {
    tree_size: number;
    /** The digest of a [manifest](benchmarks.md#the-manifest), which is all of a benchmark that can change a score. It is the same on every server (BEN-006). */
    root_sha256: string;
    /** The signed note, which says both as well. */
    note: string;
    /** Of the key of `list_keys` that signed it. */
    keyid: string;
}

/** One run beside the baseline. A pair is an episode that both have scored. */
export interface ComparedRun {
    run_id: string;
    /** Both runs have scored every episode. */
    complete: boolean;
    /** Complete, and no difference, over all episodes or over those of a task, is beyond the tolerance. */
    release: boolean;
    /** Number of pairs. */
    paired: number;
    /** Mean score of the baseline over the pairs. */
    baseline_mean: number | null;
    /** Mean score of the run over the pairs. */
    mean: number | null;
    /** Baseline minus run: positive when the run is worse. */
    difference: number | null;
    /** Pairs in which the run alone succeeds. */
    wins: number;
    /** Pairs in which the baseline alone succeeds. */
    losses: number;
    /** Pairs in which both succeed or neither does. */
    ties: number;
    /** McNemar's exact test, two-sided. */
    p_value: number;
    /** Task → the pairs of its episodes. */
    by_task: Record<string, ComparedTask>;
}

export interface ComparedTask {
    paired: number;
    baseline_mean: number | null;
    mean: number | null;
    difference: number | null;
}

/** See scoring.md for every number here. */
export interface Comparison {
    /** Id of the run that the others are compared with. */
    baseline: string;
    benchmark_id: string;
    /** The digest of a [manifest](benchmarks.md#the-manifest), which is all of a benchmark that can change a score. It is the same on every server (BEN-006). */
    manifest_sha256: string;
    tolerance: number;
    /** One entry per run that was named, in that order. */
    runs: ComparedRun[];
}

export interface ConsistencyProof {
    old_size: number;
    new_size: number;
    hashes: string[];
}

export interface EntryFlag {
    reason: string;
    flagged_at: Date;
}

/** Of the `get_score` of the run. */
export interface EntryScore {
    score: number;
    success_rate: number;
    success_interval: Interval;
    mean_interval: Interval;
    counts: OutcomeCounts;
    /** With the profile `physical`: `people` of the host. */
    judged_by?: string;
    second_judge?: SecondJudgements;
    /** Absent where the server does not show it, such as for many tasks. */
    by_task?: Record<string, GroupScore>;
    /** Absent where the server does not show it, such as for many splits. */
    by_split?: Record<string, GroupScore>;
}

export interface Episode {
    episode_id: string;
    /** Position in the manifest. */
    index: number;
    task: string;
    split: string;
    status: EpisodeStatus;
    /** The current or next attempt. */
    attempt: number;
    /** How often the simulator broke, or a trial was void (FAULT-009). */
    faults: number;
    /** In a run with mode `push`: what the policy did wrong when it last ended an attempt of this episode. */
    policy_fault?: string;
    last_left?: Leaving;
    result?: EpisodeResult;
}

export interface EpisodeList {
    episodes: Episode[];
    next_cursor: string | null;
}

export interface EpisodeResult {
    episode_id: string;
    /** Position in the manifest. */
    index: number;
    task: string;
    split: string;
    /** Absent where `sealed_splits` of the manifest of the run names the split. */
    seed?: number;
    /** The attempt that was scored. */
    attempt: number;
    /** How often the simulator broke, or a trial was void (FAULT-009). */
    faults: number;
    outcome: Outcome;
    /** From 0 to 1. */
    score: number;
    /** Actions executed in the attempt. */
    steps: number;
    /** The task ended by itself. */
    terminated: boolean;
    /** The step limit ended the episode. */
    truncated: boolean;
    /** Time between turns that the policy took. */
    think_s: number;
    finished_at: Date;
    player?: PlayerView;
    /** Actions of the attempt with a number outside of a range that is declared `clip`; for the profile `attribution`. */
    clipped_actions?: number;
    /** Sum of the rewards of the attempt, its return; for the profile `attribution`. */
    total_reward?: number;
}

/** The part of a benchmark that is played, all of it where a member is absent; for the profile `subsets`. */
export interface EpisodeSelection {
    tasks?: string[];
    splits?: string[];
}

export const EpisodeStatus = {
    Pending: 'pending',
    InProgress: 'in_progress',
    Scored: 'scored',
} as const;
export type EpisodeStatus = (typeof EpisodeStatus)[keyof typeof EpisodeStatus];

/** The episode that the observation belongs to. */
export interface EpisodeView {
    /** Names the episode within the run. */
    episode_id: string;
    /** Position in the manifest. */
    index: number;
    /** What kind of episode it is. */
    task: string;
    /** What the policy is to do, in words. */
    instruction: string;
    /** Number of this playing of it, from 1. */
    attempt: number;
    /** Actions executed in this attempt. */
    step: number;
    /** Steps after which it is truncated. */
    max_steps: number;
}

/** The simulator broke; the episode began again, at no cost to the policy. Nothing of the chunk counts as executed. A turn that ends an episode has its result instead, and `list_episodes` the faults of the next one. */
export interface Fault {
    /** Which episode began again. */
    episode_id: string;
    /** Faults of this episode so far. */
    faults: number;
    /** What happened, for people. */
    detail: string;
    /** True where no simulator broke: a person said that the trial does not count; with the profile `physical`. */
    is_void?: boolean;
}

export interface FlagEntry {
    /** False takes the flag back. */
    flagged: boolean;
    /** Shown with the entry. */
    reason: string;
}

export interface GroupScore {
    counts: OutcomeCounts;
    mean: number | null;
    success_rate: number | null;
}

export interface Heartbeat {
    /** Session of `attach_worker`. */
    session_id: string;
    /** Why the worker leaves the episode in play, for people (RSN-001). For the profile `reasons`. */
    reason?: string;
}

export interface HistoryLeaf {
    index: number;
    /** A JSON text, whose UTF-8 is what the tree has; board.md has its members. */
    leaf: string;
}

export interface HistoryPage {
    leaves: HistoryLeaf[];
    next_cursor: string | null;
}

/** Row 0 on top; raw is height × width × channels bytes. The order of [channels](play.md#numbers-and-pictures). */
export interface Image {
    codec: string;
    width: number;
    height: number;
    channels: number;
    /** Base64 with padding in JSON; `bin` in MessagePack. */
    data: string;
}

/** Recorded with the result, because it changes the score. */
export interface ImageChoice {
    codec: string;
    width: number;
    height: number;
}

export interface ImageSize {
    width: number;
    height: number;
}

export interface ImageSpace {
    channels: number;
    description: string;
    tasks?: string[];
}

export interface ImportedPolicy {
    name: string;
    version: string | null;
}

export interface InclusionProof {
    leaf_index: number;
    tree_size: number;
    hashes: string[];
}

/** 95 % interval. */
export interface Interval {
    low: number;
    high: number;
}

/** How people judged the run; with the profile `physical`. */
export interface JudgedRun {
    /** Names of the people that are not their accounts, as in records. */
    judges: string[];
    /** Episodes with a judgement. */
    judgements: number;
    /** Whether each judge knew nothing of the policy. */
    blind: boolean;
    /** How many trials were void, by reason. */
    voids: Record<string, number>;
    /** What judges wrote, by episode_id. */
    notes: Record<string, string>;
    /** The cell at which an episode was judged, by episode_id; absent where the benchmark has one cell. */
    cells?: Record<string, string>;
    second?: SecondJudgements;
}

export interface KeyList {
    keys: PublicKey[];
}

export interface Lease {
    /** When the session ends, unless a request extends it. */
    expires_at: Date;
    /** Length of the lease. */
    idle_timeout_s: number;
}

/** That a worker has left an episode, by its own words; for the profile `reasons`. */
export interface Leaving {
    /** The attempt that was in play. */
    attempt: number;
    /** Why the worker has left it. */
    reason: string;
}

export interface Limits {
    /** Longest request body that is read, except by `import_record`. */
    max_body_bytes: number;
    /** Most live workers a run may ask for. */
    max_workers: number;
    /** Most actions in one predict; a benchmark may allow fewer. */
    max_chunk: number;
    /** Shortest lease of a session that a run may have. */
    idle_timeout_s_min: number;
    /** Longest lease of a session that a run may have. */
    idle_timeout_s_max: number;
    /** Longest wait that a long-poll is granted. */
    wait_s_max: number;
    /** Longest request line with its headers that is read; for the profile `limits`. */
    max_header_bytes?: number;
    /** Time in which the headers of a request are complete, from its first byte; for the profile `limits`. */
    header_timeout_s?: number;
    /** Time in which a part of a body arrives after the headers of its request; for the profile `limits`. */
    body_timeout_s?: number;
    /** Longest time that a session lives without a new turn, or its `idle_timeout_s` if that is longer; for the profile `limits`. */
    heartbeat_s_max?: number;
    /** When others wait: the time after which a run without a worker, or a session without a turn, may make room; for the profile `limits`. */
    unused_s_max?: number;
    /** Longest body that is read of a request other than `predict` and `import_record`, where it is less than `max_body_bytes`; for the profile `limits`. */
    max_control_body_bytes?: number;
    /** Most runs of one account that are queued, ready, running or stopping; for the profile `limits`. */
    max_open_runs?: number;
    /** Most Idempotency-Keys that one account may use; for the profile `limits`. */
    max_idempotency_keys?: number;
    /** Most bytes that one account may have stored, see [LIM-010](profiles/limits.md). For the profile `limits`. */
    max_stored_bytes?: number;
    /** Longest archive that `import_record` reads; for the profile `record_import`. */
    max_record_bytes?: number;
    /** Most imports of one account that are not `finished`; for the profile `record_import`. */
    max_waiting_imports?: number;
    /** Most bytes that the archives of one account may have together; for the profile `record_import`. */
    max_imported_bytes?: number;
    /** Days without a change after which a run that has completed, failed or been stopped may be deleted; when absent, none is. For the profile `deletion`. */
    run_keep_days?: number;
}

export interface Observation {
    state: Record<string, number[]>;
    images: Record<string, Image>;
    tensors: Record<string, Tensor>;
}

export interface ObservationSpace {
    state: Record<string, VectorSpace>;
    images: Record<string, ImageSpace>;
    tensors: Record<string, TensorSpace>;
}

/** `last` when absent; `all` adds the observation after every executed action. For the profile `observations`. */
export const Observe = {
    Last: 'last',
    All: 'all',
} as const;
export type Observe = (typeof Observe)[keyof typeof Observe];

export const Outcome = {
    Success: 'success',
    Failure: 'failure',
    Abandoned: 'abandoned',
} as const;
export type Outcome = (typeof Outcome)[keyof typeof Outcome];

export interface OutcomeCounts {
    /** All episodes. */
    total: number;
    success: number;
    failure: number;
    /** Scored 0, because the last attempt was closed. */
    abandoned: number;
    /** Without a result so far. */
    unscored: number;
}

/** About the part of this name. */
export interface PartAssumption {
    start?: number;
    size?: number;
    /** A name of registry/quantities.yaml, or an extension. */
    quantity?: string;
    unit?: string;
    scale?: number;
    frame?: string;
    /** A name of registry/rotations.yaml, or an extension. */
    rotation?: string;
    /** A name of registry/relative_modes.yaml, or an extension. */
    relative_to?: string;
    gripper_open?: number;
    gripper_closed?: number;
}

/** Who plays, by its own words; for the profile `attribution`. */
export interface Player {
    /** Of the policy, as in `policy` of the run. */
    name: string;
    /** Of the policy. */
    version?: string;
    /** The program that attaches and its version. */
    client?: string;
}

/** The `player` of an `attach_worker`. */
export interface PlayerView {
    name: string;
    version?: string;
    client?: string;
}

/** What a policy server says of itself. */
export interface PolicyDescription {
    name: string;
    version?: string;
    protocol: ProtocolRange;
    /** Most episodes that it plays at a time. */
    max_sessions: number;
    assumes?: Assumptions;
}

export interface PolicyInfo {
    /** What the policy is called in results. */
    name: string;
    /** Which state of it, for example a checkpoint. */
    version?: string;
    /** Who submits it. */
    submitter?: string;
    /** Where to read about it. */
    homepage?: string;
}

/** `proctor` is policy.yaml. `openai_chat` asks for a chat completion at `chat/completions` below the URL, for benchmarks that are answered in words. `openai_completions` asks for the completion of a text at `completions` below the URL, for such benchmarks without images. */
export const PolicyProtocol = {
    Proctor: 'proctor',
    OpenaiChat: 'openai_chat',
    OpenaiCompletions: 'openai_completions',
} as const;
export type PolicyProtocol = (typeof PolicyProtocol)[keyof typeof PolicyProtocol];

/** The policy is ready for this attempt and no other. */
export interface PolicyReset {
    session_id: string;
    episode_id: string;
    attempt: number;
}

/** Where the server finds the policy of a run with mode `push`, and how it calls it. */
export interface PolicyServer {
    /** Base URL, without user, query or fragment; the path of an operation is appended to it. */
    url: string;
    protocol: PolicyProtocol;
    /** Sent as bearer token with every call, and never shown. */
    api_key?: string;
    /** Which model is asked, where a protocol knows several. */
    model?: string;
    /** Time for one call, from connecting to the last byte of its answer; 30 when absent. */
    call_timeout_s?: number;
    /** Most episodes played and calls made at a time; as many as the policy, the run and the server allow when absent. */
    max_concurrent?: number;
    /** How often a call that was not answered is repeated; 3 when absent. */
    max_retries?: number;
    /** Numbers that a chat completion is asked with, such as `temperature` and `max_tokens`; for `openai_chat` and `openai_completions` alone. */
    generation?: Record<string, number>;
}

/** The policy server of a run with mode `push`, with what was left open filled in, and without its key. */
export interface PolicyServerView {
    url: string;
    /** A `PolicyProtocol`, or one of a later version. */
    protocol: string;
    has_api_key: boolean;
    model?: string;
    call_timeout_s: number;
    max_concurrent: number;
    max_retries: number;
    generation?: Record<string, number>;
}

export interface Predict {
    /** Session of `attach_worker`. */
    session_id: string;
    /** Number of the turn, 1 for the first one; a repeat has the same number. */
    seq: number;
    actions: Action[];
    observe?: Observe;
}

/** RFC 9457, with what a client needs to decide on a retry. */
export interface Problem {
    /** `urn:proctor:problem:` and the code. */
    type: string;
    /** What the code means. */
    title: string;
    /** Status of the response. */
    status: number;
    /** What happened and what to do about it. */
    detail: string;
    /** One of x-problems, or one of a later version. */
    code: string;
    /** Whether the same request can succeed later. */
    retryable: boolean;
    side_effects: SideEffects;
    errors?: ProblemItem[];
    /** Id of the rule that was enforced. */
    requirement?: string;
    state?: RunState;
    /** Of `seq_out_of_order`: the next seq. */
    expected_seq?: number;
    /** What ended the session, as far as the server still knows; `unknown` after a restart, and for a session that was taken over and whose successor has ended. */
    ended_by?: string;
    /** Of `result_published`: the entry of that result. */
    entry_id?: string;
    /** Of `quota_exceeded` and `no_capacity`: the limit that was reached, where the server names it. */
    limit?: string;
}

export interface ProblemItem {
    /** JSON pointer into the body, to the faulty member or a part of it; or `query:name`, `header:name`, `path:name`; or `record:name`, with the name of a file in a record, or `archive`. */
    pointer: string;
    /** What is wrong there. */
    detail: string;
}

export interface Progress {
    /** How many episodes the run has. */
    episodes_total: number;
    /** Abandoned ones included. */
    episodes_scored: number;
    /** How many are played now. */
    episodes_in_progress: number;
    /** How many wait to be played. */
    episodes_pending: number;
}

export interface ProtocolRange {
    /** Lowest version that is spoken. */
    min: string;
    /** Highest version that is spoken. */
    max: string;
}

export interface PublicKey {
    /** `SHA256:` and the SHA-256 of the key in hexadecimal digits. */
    keyid: string;
    /** `ed25519`, or another one of a later version. */
    algorithm: string;
    /** Its 32 bytes. */
    public_key: string;
    created_at: Date;
    /** When it signed for the last time; null for the key in use. */
    retired_at: Date | null;
}

/** What an entry says of itself; a member that is absent is not shown. */
export interface PublishEntry {
    /** What the entry is called. */
    model_name: string;
    /** Whether others see the entry, and whether it has a rank. */
    is_public: boolean;
    /** What kind of model it is, for example `VLA` or `diffusion policy`. */
    model_type?: string;
    organisation?: string;
    /** Where to read about the model. */
    homepage?: string;
    /** Where its code is. */
    code_url?: string;
    /** Anything else, for readers. */
    notes?: string;
}

/** The ranks that an entry may have; absent for an entry that is flagged. */
export interface RankInterval {
    /** The best one. */
    low: number;
    /** The worst one. */
    high: number;
}

export interface RankedEntry {
    entry: BoardEntry;
    rank?: RankInterval;
    /** How many entries are significantly better; 0 without a rank. */
    better: number;
    /** How many entries are significantly worse; 0 without a rank. */
    worse: number;
    /** Entries that cannot be distinguished have a letter in common, others have none in common; empty without a rank. */
    letters: string[];
}

/** See board.md for every number here. */
export interface Ranking {
    benchmark_id: string;
    /** The digest of a [manifest](benchmarks.md#the-manifest), which is all of a benchmark that can change a score. It is the same on every server (BEN-006). */
    manifest_sha256: string;
    /** How many episodes each entry has; null where the manifest has no entry. */
    episodes_total: number | null;
    /** How many entries have a rank. */
    ranked: number;
    /** How many pairs of them were tested. */
    comparisons: number;
    /** How likely it is at most that any two equally good policies are distinguished; 0.05. */
    alpha: number;
    /** Two entries that differ on fewer episodes can never be distinguished; null if the benchmark has fewer episodes. */
    differing_min: number | null;
    /** Two entries that differ on so many episodes, all to the advantage of one, are distinguished, however the others fared; null if the benchmark has fewer episodes. */
    differing_enough: number | null;
    rows: RankedEntry[];
    next_cursor: string | null;
}

/** A record that was handed in, and what is known of it here. */
export interface RecordImport {
    import_id: string;
    /** `waiting` for simulators, `replaying`, or `finished`. */
    state: string;
    /** `reported`: whole, by anyone; `signed` by a key that this server knows; `replayed` here with the same results; `diverged`: the replay came out otherwise. */
    level: string;
    /** The level with who says it, as REC-031 has it. */
    level_text: string;
    /** Whose key signed the record, as this server knows it; null for a key that it does not know. */
    signer: string | null;
    /** Of the key that signed the record. */
    keyid: string;
    archive_sha256: string;
    statement_sha256: string;
    size_bytes: number;
    /** In the statement, as are the members below it. */
    run_id: string;
    benchmark_id: string;
    benchmark_version: string;
    manifest_sha256: string;
    policy: ImportedPolicy;
    /** Null where an episode has no result. */
    score: number | null;
    episodes: number;
    /** How many of them were simulated so far. */
    episodes_replayed: number;
    replay?: RecordReplay;
    /** Why there is no replay. */
    reason: string | null;
    imported_at: Date;
    finished_at: Date | null;
}

export interface RecordImportList {
    imports: RecordImport[];
    next_cursor: string | null;
}

/** As in a verdict (record.md); absent before the end of the replay, and where there is none. */
export interface RecordReplay {
    /** `exact`, `outcome` or `diverged`. */
    result: string;
    episodes: number;
    exact: number;
    outcome: number;
    diverged: number;
    first_divergence?: ReplayDivergence;
}

/** The first state that was another one; absent where every state was met. */
export interface ReplayDivergence {
    episode_index: number;
    attempt: number;
    /** After how many steps of the attempt the state was another one. */
    step: number;
}

/** An attempt begins; whatever the policy remembers of this session is over. */
export interface ResetPolicy {
    session_id: string;
    run_id?: string;
    benchmark: Benchmark;
    episode: EpisodeView;
}

export interface Run {
    /** Names the run in every path. */
    run_id: string;
    state: RunState;
    /** Why the run is in this state, for people; never null when failed. */
    reason: string | null;
    /** Whether a failed run may be resumed; null in other states. */
    retryable: boolean | null;
    /** Who made a run fail: the `policy`, the `simulator` or the `server`. In a failed run alone, where the server knows it. */
    failed_by?: string;
    benchmark_id: string;
    /** Version of the benchmark when the run was submitted. */
    benchmark_version: string;
    /** The digest of a [manifest](benchmarks.md#the-manifest), which is all of a benchmark that can change a score. It is the same on every server (BEN-006). */
    manifest_sha256: string;
    policy: RunPolicy;
    /** A `RunMode`, or one of a later version; `pull` when absent. */
    mode?: string;
    policy_server?: PolicyServerView;
    /** Whether workers may play for another policy than `policy`; for the profile `attribution`. */
    any_policy?: boolean;
    select?: SelectionView;
    /** Most live workers that it may have. */
    max_workers: number;
    /** Lease of its sessions. */
    idle_timeout_s: number;
    images: ImageChoice;
    /** Base URL of the data plane for this run; the path of an operation is appended to it. */
    endpoint: string;
    /** 1 is next; null unless queued. */
    queue_position: number | null;
    /** How many workers have a live session. */
    live_workers: number;
    progress: Progress;
    /** When it was submitted. */
    created_at: Date;
    /** When it changed for the last time; a change that was taken back before it was shown need not count. */
    updated_at: Date;
    /** How many runs of this benchmark its submitter had played before this run was played, deleted ones too; absent before this run is played (DEL-006). For the profile `deletion`. */
    runs_played_before?: number;
    judged?: JudgedRun;
    /** The account that owns the run. For the profile `accounts`. */
    account?: string;
    /** How many runs of this benchmark its submitter had submitted, this one included; for the profile `record`. */
    attempts_by_submitter?: number;
}

export interface RunList {
    runs: Run[];
    next_cursor: string | null;
}

/** `pull` when absent: workers attach and predict. `push`: the server calls the policy itself, and workers of the run are its own. */
export const RunMode = {
    Pull: 'pull',
    Push: 'push',
} as const;
export type RunMode = (typeof RunMode)[keyof typeof RunMode];

/** A `PolicyInfo` as it was submitted. A run of an earlier server may have a homepage of another form. */
export interface RunPolicy {
    name: string;
    version?: string;
    submitter?: string;
    homepage?: string;
}

export const RunState = {
    Queued: 'queued',
    Ready: 'ready',
    Running: 'running',
    Stopping: 'stopping',
    Stopped: 'stopped',
    Failed: 'failed',
    Completed: 'completed',
} as const;
export type RunState = (typeof RunState)[keyof typeof RunState];

/** See scoring.md for every number here. */
export interface Score {
    run_id: string;
    benchmark_id: string;
    /** The digest of a [manifest](benchmarks.md#the-manifest), which is all of a benchmark that can change a score. It is the same on every server (BEN-006). */
    manifest_sha256: string;
    select?: SelectionView;
    state: RunState;
    /** Every episode has a result. */
    complete: boolean;
    /** Null until complete. */
    score: number | null;
    /** The score if every missing episode got 0. */
    score_low: number;
    /** The score if every missing episode got 1. */
    score_high: number;
    counts: OutcomeCounts;
    /** Successes among the scored episodes. */
    success_rate: number | null;
    success_interval: Interval;
    /** Mean over the scored episodes. */
    mean: number | null;
    mean_interval: Interval;
    by_task: Record<string, GroupScore>;
    by_split: Record<string, GroupScore>;
}

/** How a second person judged a sample of the episodes of a run; see profiles/physical.md. */
export interface SecondJudgements {
    /** Episodes of the sample with a first judgement. */
    drawn: number;
    /** Those of them with a second one. */
    judgements: number;
    /** Names of the second judges that are not their accounts. */
    judges: string[];
    /** Episodes that both judges called a success. */
    both: number;
    /** Those that the first judge alone called one. */
    first_alone: number;
    /** Those that the second judge alone called one. */
    second_alone: number;
    /** Those that no judge called one. */
    neither: number;
    /** Cohen's kappa of these; null where chance alone would make them agree. */
    kappa: number | null;
}

/** The `select` of a run, as it was submitted. */
export interface SelectionView {
    tasks?: string[];
    splits?: string[];
}

/** What a server says of itself before anyone authenticates. */
export interface Service {
    /** Name of the server software. */
    name: string;
    /** Version of the server software. */
    version: string;
    protocol: ProtocolRange;
    /** Parts of the protocol offered, which [levels](levels.md) explains; `core` may be left out, for it always is. An operation with `x-profile` is there when its profile is announced. The rules of the profile `crash` are not announced. The kit judges them where it may kill and restart a server of the level Service; a server whose runs do not outlive its process is certified without them and without EVT-009, PUSH-017, REC-123 and REC-124, and its report says that they were not verified. Those of the profile `cluster` are not announced, either. They bind a service that is reached at several base URLs, and the kit judges them where it is given all of these. */
    profiles: string[];
    limits: Limits;
    /** Media types of the data plane. */
    encodings: string[];
    image_codecs: string[];
    /** The server's clock, UTC. */
    server_time: Date;
}

export const SideEffects = {
    None: 'none',
    Possible: 'possible',
} as const;
export type SideEffects = (typeof SideEffects)[keyof typeof SideEffects];

export interface SimulatorInfo {
    name: string;
    version: string;
    /** Named rendering quality, where there is one. */
    quality?: string;
    /** File that the simulator [loads](simulator.md) → its SHA-256: an edit of it makes another manifest. Absent where none is announced. */
    sources?: Record<string, string>;
}

/** `abort` when absent. `drain` is for the profile `control`. */
export const StopMode = {
    Abort: 'abort',
    Drain: 'drain',
} as const;
export type StopMode = (typeof StopMode)[keyof typeof StopMode];

export interface StopRun {
    mode?: StopMode;
    /** Why the run is stopped, for people (RSN-004). For the profile `reasons`. */
    reason?: string;
}

export interface SubmitRun {
    /** One of `list_benchmarks`. */
    benchmark_id: string;
    policy: PolicyInfo;
    /** Most live workers wanted; the server's limit when absent. */
    max_workers?: number;
    /** Lease of a session; the server's maximum when absent. For the profile `sessions`. */
    idle_timeout_s?: number;
    images?: ImageChoice;
    options?: CalibrationOptions;
    mode?: RunMode;
    policy_server?: PolicyServer;
    /** Workers may play for another policy than `policy`; false when absent; for the profile `attribution`. */
    any_policy?: boolean;
    select?: EpisodeSelection;
}

export const SuccessRule = {
    AnyStep: 'any_step',
    LastStep: 'last_step',
} as const;
export type SuccessRule = (typeof SuccessRule)[keyof typeof SuccessRule];

/** C order, little-endian; a bool is one byte, 0 or 1. */
export interface Tensor {
    dtype: string;
    shape: number[];
    /** Base64 with padding in JSON; `bin` in MessagePack. */
    data: string;
}

export interface TensorSpace {
    dtype: string;
    shape: number[];
    description: string;
    tasks?: string[];
}

/** Server time of this turn, in seconds. */
export interface Timing {
    /** The whole turn on the server. */
    total_s: number;
    /** Waiting for the simulator. */
    queue_s: number;
    /** Executing actions. */
    simulate_s: number;
    /** Rendering images. */
    render_s: number;
    /** Encoding of images. */
    encode_s: number;
}

/** The answer to attach (turn 0, or in a repeat the latest turn) and to predict. */
export interface Turn {
    /** Names the session in every later request. */
    session_id: string;
    /** Number of the turn. */
    seq: number;
    episode?: EpisodeView;
    observation?: Observation;
    /** With `observe` all, one per executed action. */
    observations?: Observation[];
    /** How many actions of the chunk were executed. */
    executed_steps: number;
    /** The episode ended before the chunk did. */
    stopped_early: boolean;
    /** One per executed action. */
    rewards: number[];
    /** The task ended by itself in this turn. */
    terminated: boolean;
    /** The step limit ended the episode in this turn. */
    truncated: boolean;
    episode_result?: EpisodeResult;
    fault?: Fault;
    /** No episode is left for this session. It holds no slot any more; its last turn can be repeated until its lease ends. */
    done: boolean;
    lease: Lease;
    timing: Timing;
}

/** Adjacent numbers of a vector, with every convention a policy could get wrong. */
export interface VectorPart {
    /** Index of its first number in the vector. */
    start: number;
    size: number;
    /** A name of registry/quantities.yaml, or an extension. */
    quantity: string;
    /** A name of registry/units.yaml, or an extension. */
    unit: string;
    /** A number times `scale` is in `unit`; 1 when absent. */
    scale?: number;
    /** A name of registry/frames.yaml, or an extension. */
    frame: string;
    /** A name of registry/rotations.yaml, or an extension. */
    rotation: string;
    /** A name of registry/relative_modes.yaml, or an extension. */
    relative_to: string;
    /** The value that means fully open. */
    gripper_open?: number;
    /** The value that means fully closed. */
    gripper_closed?: number;
    description?: string;
}

/** One named vector of numbers, in parts: see [conventions](conventions.md#parts). */
export interface VectorSpace {
    size: number;
    /** Name → what these numbers are. Only descriptions of earlier drafts have none. */
    parts?: Record<string, VectorPart>;
    minimum?: number[];
    maximum?: number[];
    out_of_range: string;
    /** What the numbers are. */
    description?: string;
    /** The tasks that have this entry; all of them when absent. */
    tasks?: string[];
}
