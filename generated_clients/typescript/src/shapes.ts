/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

/* The members of each message, and the reader that checks an answer against them. */

/** A success that is not the message expected. What was sent may have had its effect. */
export class InvalidAnswer extends Error {
    override name = 'InvalidAnswer';
    /** The method of the request, and the answer to it, whose body was read. */
    method?: string;
    response?: Response;
}

/* The shape of a value: a type of JSON, 'Date' for a time, the name of a message, or the shape of what a container holds. */
type Shape = string | { list: Shape } | { map: Shape };
interface Choice {
    shape: Shape;
    absent: boolean; // whether the member may be missing; then null is the same
}

const optional = (shape: Shape): Choice => ({ shape, absent: true });
const nullable = (shape: Shape): Choice => ({ shape, absent: false });

const MESSAGES: Record<string, Record<string, Shape | Choice>> = {
    Action: {
        values: { map: { list: 'number' } },
    },
    Assumption: {
        size: optional('number'),
        quantity: optional('string'),
        unit: optional('string'),
        scale: optional('number'),
        frame: optional('string'),
        rotation: optional('string'),
        relative_to: optional('string'),
        gripper_open: optional('number'),
        gripper_closed: optional('number'),
        parts: optional({ map: 'PartAssumption' }),
    },
    Assumptions: {
        control_rate_hz: optional('number'),
        action: optional({ map: 'Assumption' }),
        state: optional({ map: 'Assumption' }),
    },
    AttachWorker: {
        attach_key: 'string',
        takeover: optional('boolean'),
        assumes: optional('Assumptions'),
        player: optional('Player'),
        first_episodes: optional('number'),
    },
    Benchmark: {
        benchmark_id: 'string',
        version: 'string',
        title: 'string',
        description: 'string',
        manifest_sha256: 'string',
        episodes_total: 'number',
        tasks: { list: 'string' },
        task_goals: optional({ map: 'string' }),
        splits: { list: 'string' },
        sealed_splits: optional({ list: 'string' }),
        seeds_sha256: optional('string'),
        control_rate_hz: 'number',
        max_steps: 'number',
        max_chunk: 'number',
        max_attempts: 'number',
        max_faults: 'number',
        success_rule: 'string',
        action_space: { map: 'VectorSpace' },
        observation_space: 'ObservationSpace',
        image_sizes: { list: 'ImageSize' },
        image_codecs: { list: 'string' },
        simulator: 'SimulatorInfo',
        unavailable_reason: nullable('string'),
    },
    BenchmarkList: {
        benchmarks: { list: 'BenchmarkSummary' },
    },
    BenchmarkSummary: {
        benchmark_id: 'string',
        version: 'string',
        title: 'string',
        manifest_sha256: 'string',
        episodes_total: 'number',
    },
    BoardEntry: {
        entry_id: 'string',
        run_id: 'string',
        submitter: 'string',
        benchmark_id: 'string',
        benchmark_version: 'string',
        manifest_sha256: 'string',
        select: optional('SelectionView'),
        policy: 'RunPolicy',
        model_name: 'string',
        is_public: 'boolean',
        model_type: optional('string'),
        organisation: optional('string'),
        homepage: optional('string'),
        code_url: optional('string'),
        notes: optional('string'),
        state: 'string',
        flag: optional('EntryFlag'),
        level: 'string',
        attempts: 'number',
        score: 'EntryScore',
        published_at: 'Date',
        changed_at: 'Date',
    },
    BoardEntryList: {
        entries: { list: 'BoardEntry' },
        next_cursor: nullable('string'),
    },
    CalibrationOptions: {
        tasks: optional({ list: 'string' }),
        max_steps: optional('number'),
        success_rule: optional('string'),
        max_attempts: optional('number'),
        max_faults: optional('number'),
        sealed: optional('boolean'),
        queue_s: optional('number'),
    },
    Checkpoint: {
        tree_size: 'number',
        root_sha256: 'string',
        note: 'string',
        keyid: 'string',
    },
    ComparedRun: {
        run_id: 'string',
        complete: 'boolean',
        release: 'boolean',
        paired: 'number',
        baseline_mean: nullable('number'),
        mean: nullable('number'),
        difference: nullable('number'),
        wins: 'number',
        losses: 'number',
        ties: 'number',
        p_value: 'number',
        by_task: { map: 'ComparedTask' },
    },
    ComparedTask: {
        paired: 'number',
        baseline_mean: nullable('number'),
        mean: nullable('number'),
        difference: nullable('number'),
    },
    Comparison: {
        baseline: 'string',
        benchmark_id: 'string',
        manifest_sha256: 'string',
        tolerance: 'number',
        runs: { list: 'ComparedRun' },
    },
    ConsistencyProof: {
        old_size: 'number',
        new_size: 'number',
        hashes: { list: 'string' },
    },
    EntryFlag: {
        reason: 'string',
        flagged_at: 'Date',
    },
    EntryScore: {
        score: 'number',
        success_rate: 'number',
        success_interval: 'Interval',
        mean_interval: 'Interval',
        counts: 'OutcomeCounts',
        judged_by: optional('string'),
        second_judge: optional('SecondJudgements'),
        by_task: optional({ map: 'GroupScore' }),
        by_split: optional({ map: 'GroupScore' }),
    },
    Episode: {
        episode_id: 'string',
        index: 'number',
        task: 'string',
        split: 'string',
        status: 'string',
        attempt: 'number',
        faults: 'number',
        policy_fault: optional('string'),
        result: optional('EpisodeResult'),
    },
    EpisodeList: {
        episodes: { list: 'Episode' },
        next_cursor: nullable('string'),
    },
    EpisodeResult: {
        episode_id: 'string',
        index: 'number',
        task: 'string',
        split: 'string',
        seed: optional('number'),
        attempt: 'number',
        faults: 'number',
        outcome: 'string',
        score: 'number',
        steps: 'number',
        terminated: 'boolean',
        truncated: 'boolean',
        think_s: 'number',
        finished_at: 'Date',
        player: optional('PlayerView'),
        clipped_actions: optional('number'),
        total_reward: optional('number'),
    },
    EpisodeSelection: {
        tasks: optional({ list: 'string' }),
        splits: optional({ list: 'string' }),
    },
    EpisodeView: {
        episode_id: 'string',
        index: 'number',
        task: 'string',
        instruction: 'string',
        attempt: 'number',
        step: 'number',
        max_steps: 'number',
    },
    Fault: {
        episode_id: 'string',
        faults: 'number',
        detail: 'string',
        is_void: optional('boolean'),
    },
    FlagEntry: {
        flagged: 'boolean',
        reason: 'string',
    },
    GroupScore: {
        counts: 'OutcomeCounts',
        mean: nullable('number'),
        success_rate: nullable('number'),
    },
    Heartbeat: {
        session_id: 'string',
    },
    HistoryLeaf: {
        index: 'number',
        leaf: 'string',
    },
    HistoryPage: {
        leaves: { list: 'HistoryLeaf' },
        next_cursor: nullable('string'),
    },
    Image: {
        codec: 'string',
        width: 'number',
        height: 'number',
        channels: 'number',
        data: 'string',
    },
    ImageChoice: {
        codec: 'string',
        width: 'number',
        height: 'number',
    },
    ImageSize: {
        width: 'number',
        height: 'number',
    },
    ImageSpace: {
        channels: 'number',
        description: 'string',
        tasks: optional({ list: 'string' }),
    },
    ImportedPolicy: {
        name: 'string',
        version: nullable('string'),
    },
    InclusionProof: {
        leaf_index: 'number',
        tree_size: 'number',
        hashes: { list: 'string' },
    },
    Interval: {
        low: 'number',
        high: 'number',
    },
    JudgedRun: {
        judges: { list: 'string' },
        judgements: 'number',
        blind: 'boolean',
        voids: { map: 'number' },
        notes: { map: 'string' },
        cells: optional({ map: 'string' }),
        second: optional('SecondJudgements'),
    },
    KeyList: {
        keys: { list: 'PublicKey' },
    },
    Lease: {
        expires_at: 'Date',
        idle_timeout_s: 'number',
    },
    Limits: {
        max_body_bytes: 'number',
        max_workers: 'number',
        max_chunk: 'number',
        idle_timeout_s_min: 'number',
        idle_timeout_s_max: 'number',
        wait_s_max: 'number',
        max_header_bytes: optional('number'),
        header_timeout_s: optional('number'),
        body_timeout_s: optional('number'),
        heartbeat_s_max: optional('number'),
        unused_s_max: optional('number'),
        max_control_body_bytes: optional('number'),
        max_open_runs: optional('number'),
        max_idempotency_keys: optional('number'),
        max_stored_bytes: optional('number'),
        max_record_bytes: optional('number'),
        max_waiting_imports: optional('number'),
        max_imported_bytes: optional('number'),
        run_keep_days: optional('number'),
    },
    Observation: {
        state: { map: { list: 'number' } },
        images: { map: 'Image' },
        tensors: { map: 'Tensor' },
    },
    ObservationSpace: {
        state: { map: 'VectorSpace' },
        images: { map: 'ImageSpace' },
        tensors: { map: 'TensorSpace' },
    },
    OutcomeCounts: {
        total: 'number',
        success: 'number',
        failure: 'number',
        abandoned: 'number',
        unscored: 'number',
    },
    PartAssumption: {
        start: optional('number'),
        size: optional('number'),
        quantity: optional('string'),
        unit: optional('string'),
        scale: optional('number'),
        frame: optional('string'),
        rotation: optional('string'),
        relative_to: optional('string'),
        gripper_open: optional('number'),
        gripper_closed: optional('number'),
    },
    Player: {
        name: 'string',
        version: optional('string'),
        client: optional('string'),
    },
    PlayerView: {
        name: 'string',
        version: optional('string'),
        client: optional('string'),
    },
    PolicyDescription: {
        name: 'string',
        version: optional('string'),
        protocol: 'ProtocolRange',
        max_sessions: 'number',
        assumes: optional('Assumptions'),
    },
    PolicyInfo: {
        name: 'string',
        version: optional('string'),
        submitter: optional('string'),
        homepage: optional('string'),
    },
    PolicyReset: {
        session_id: 'string',
        episode_id: 'string',
        attempt: 'number',
    },
    PolicyServer: {
        url: 'string',
        protocol: 'string',
        api_key: optional('string'),
        model: optional('string'),
        call_timeout_s: optional('number'),
        max_concurrent: optional('number'),
        max_retries: optional('number'),
        generation: optional({ map: 'number' }),
    },
    PolicyServerView: {
        url: 'string',
        protocol: 'string',
        has_api_key: 'boolean',
        model: optional('string'),
        call_timeout_s: 'number',
        max_concurrent: 'number',
        max_retries: 'number',
        generation: optional({ map: 'number' }),
    },
    Predict: {
        session_id: 'string',
        seq: 'number',
        actions: { list: 'Action' },
        observe: optional('string'),
    },
    Problem: {
        type: 'string',
        title: 'string',
        status: 'number',
        detail: 'string',
        code: 'string',
        retryable: 'boolean',
        side_effects: 'string',
        errors: optional({ list: 'ProblemItem' }),
        requirement: optional('string'),
        state: optional('string'),
        expected_seq: optional('number'),
        ended_by: optional('string'),
        entry_id: optional('string'),
        limit: optional('string'),
    },
    ProblemItem: {
        pointer: 'string',
        detail: 'string',
    },
    Progress: {
        episodes_total: 'number',
        episodes_scored: 'number',
        episodes_in_progress: 'number',
        episodes_pending: 'number',
    },
    ProtocolRange: {
        min: 'string',
        max: 'string',
    },
    PublicKey: {
        keyid: 'string',
        algorithm: 'string',
        public_key: 'string',
        created_at: 'Date',
        retired_at: nullable('Date'),
    },
    PublishEntry: {
        model_name: 'string',
        is_public: 'boolean',
        model_type: optional('string'),
        organisation: optional('string'),
        homepage: optional('string'),
        code_url: optional('string'),
        notes: optional('string'),
    },
    RankInterval: {
        low: 'number',
        high: 'number',
    },
    RankedEntry: {
        entry: 'BoardEntry',
        rank: optional('RankInterval'),
        better: 'number',
        worse: 'number',
        letters: { list: 'string' },
    },
    Ranking: {
        benchmark_id: 'string',
        manifest_sha256: 'string',
        episodes_total: nullable('number'),
        ranked: 'number',
        comparisons: 'number',
        alpha: 'number',
        differing_min: nullable('number'),
        differing_enough: nullable('number'),
        rows: { list: 'RankedEntry' },
        next_cursor: nullable('string'),
    },
    RecordImport: {
        import_id: 'string',
        state: 'string',
        level: 'string',
        level_text: 'string',
        signer: nullable('string'),
        keyid: 'string',
        archive_sha256: 'string',
        statement_sha256: 'string',
        size_bytes: 'number',
        run_id: 'string',
        benchmark_id: 'string',
        benchmark_version: 'string',
        manifest_sha256: 'string',
        policy: 'ImportedPolicy',
        score: nullable('number'),
        episodes: 'number',
        episodes_replayed: 'number',
        replay: optional('RecordReplay'),
        reason: nullable('string'),
        imported_at: 'Date',
        finished_at: nullable('Date'),
    },
    RecordImportList: {
        imports: { list: 'RecordImport' },
        next_cursor: nullable('string'),
    },
    RecordReplay: {
        result: 'string',
        episodes: 'number',
        exact: 'number',
        outcome: 'number',
        diverged: 'number',
        first_divergence: optional('ReplayDivergence'),
    },
    ReplayDivergence: {
        episode_index: 'number',
        attempt: 'number',
        step: 'number',
    },
    ResetPolicy: {
        session_id: 'string',
        run_id: optional('string'),
        benchmark: 'Benchmark',
        episode: 'EpisodeView',
    },
    Run: {
        run_id: 'string',
        state: 'string',
        reason: nullable('string'),
        retryable: nullable('boolean'),
        benchmark_id: 'string',
        benchmark_version: 'string',
        manifest_sha256: 'string',
        policy: 'RunPolicy',
        mode: optional('string'),
        policy_server: optional('PolicyServerView'),
        any_policy: optional('boolean'),
        select: optional('SelectionView'),
        max_workers: 'number',
        idle_timeout_s: 'number',
        images: 'ImageChoice',
        endpoint: 'string',
        queue_position: nullable('number'),
        live_workers: 'number',
        progress: 'Progress',
        created_at: 'Date',
        updated_at: 'Date',
        runs_played_before: optional('number'),
        judged: optional('JudgedRun'),
        attempts_by_submitter: optional('number'),
    },
    RunList: {
        runs: { list: 'Run' },
        next_cursor: nullable('string'),
    },
    RunPolicy: {
        name: 'string',
        version: optional('string'),
        submitter: optional('string'),
        homepage: optional('string'),
    },
    Score: {
        run_id: 'string',
        benchmark_id: 'string',
        manifest_sha256: 'string',
        select: optional('SelectionView'),
        state: 'string',
        complete: 'boolean',
        score: nullable('number'),
        score_low: 'number',
        score_high: 'number',
        counts: 'OutcomeCounts',
        success_rate: nullable('number'),
        success_interval: 'Interval',
        mean: nullable('number'),
        mean_interval: 'Interval',
        by_task: { map: 'GroupScore' },
        by_split: { map: 'GroupScore' },
    },
    SecondJudgements: {
        drawn: 'number',
        judgements: 'number',
        judges: { list: 'string' },
        both: 'number',
        first_alone: 'number',
        second_alone: 'number',
        neither: 'number',
        kappa: nullable('number'),
    },
    SelectionView: {
        tasks: optional({ list: 'string' }),
        splits: optional({ list: 'string' }),
    },
    Service: {
        name: 'string',
        version: 'string',
        protocol: 'ProtocolRange',
        profiles: { list: 'string' },
        limits: 'Limits',
        encodings: { list: 'string' },
        image_codecs: { list: 'string' },
        server_time: 'Date',
    },
    SimulatorInfo: {
        name: 'string',
        version: 'string',
        quality: optional('string'),
        sources: optional({ map: 'string' }),
    },
    StopRun: {
        mode: optional('string'),
    },
    SubmitRun: {
        benchmark_id: 'string',
        policy: 'PolicyInfo',
        max_workers: optional('number'),
        idle_timeout_s: optional('number'),
        images: optional('ImageChoice'),
        options: optional('CalibrationOptions'),
        mode: optional('string'),
        policy_server: optional('PolicyServer'),
        any_policy: optional('boolean'),
        select: optional('EpisodeSelection'),
    },
    Tensor: {
        dtype: 'string',
        shape: { list: 'number' },
        data: 'string',
    },
    TensorSpace: {
        dtype: 'string',
        shape: { list: 'number' },
        description: 'string',
        tasks: optional({ list: 'string' }),
    },
    Timing: {
        total_s: 'number',
        queue_s: 'number',
        simulate_s: 'number',
        render_s: 'number',
        encode_s: 'number',
    },
    Turn: {
        session_id: 'string',
        seq: 'number',
        episode: optional('EpisodeView'),
        observation: optional('Observation'),
        observations: optional({ list: 'Observation' }),
        executed_steps: 'number',
        stopped_early: 'boolean',
        rewards: { list: 'number' },
        terminated: 'boolean',
        truncated: 'boolean',
        episode_result: optional('EpisodeResult'),
        fault: optional('Fault'),
        done: 'boolean',
        lease: 'Lease',
        timing: 'Timing',
    },
    VectorPart: {
        start: 'number',
        size: 'number',
        quantity: 'string',
        unit: 'string',
        scale: optional('number'),
        frame: 'string',
        rotation: 'string',
        relative_to: 'string',
        gripper_open: optional('number'),
        gripper_closed: optional('number'),
        description: optional('string'),
    },
    VectorSpace: {
        size: 'number',
        parts: optional({ map: 'VectorPart' }),
        minimum: optional({ list: 'number' }),
        maximum: optional({ list: 'number' }),
        out_of_range: 'string',
        description: optional('string'),
        tasks: optional({ list: 'string' }),
    },
};

/** The message that a JSON text holds. Throws InvalidAnswer, with the place of what is wrong. */
export function read<Message>(name: string, text: string): Message {
    let value: unknown;
    try {
        value = JSON.parse(text);
    } catch {
        throw new InvalidAnswer('the answer is not JSON');
    }
    return valueOf(value, name, '', name) as Message;
}

function messageOf(value: unknown, name: string, at: string, message: string): object {
    const given = contentOf(value, 'object', at, message);
    const members: Record<string, unknown> = { ...given }; // those of a later version, too
    for (const [member, choice] of Object.entries(MESSAGES[name])) {
        const { shape, absent } = typeof choice === 'object' && 'shape' in choice ? choice : { shape: choice, absent: null };
        if (given[member] === undefined && absent !== true) throw invalid(message, `${at}/${member} is missing`);
        if (given[member] != null || absent === null) members[member] = valueOf(given[member], shape, `${at}/${member}`, message);
        else if (absent) delete members[member];
    }
    return members;
}

function valueOf(value: unknown, shape: Shape, at: string, message: string): unknown {
    if (typeof shape === 'object' && 'list' in shape) {
        const items: unknown[] = contentOf(value, 'array', at, message);
        return items.map((item, i) => valueOf(item, shape.list, `${at}/${i}`, message));
    }
    if (typeof shape === 'object') {
        const entries = Object.entries(contentOf(value, 'object', at, message));
        return Object.fromEntries(entries.map(([key, item]) => [key, valueOf(item, shape.map, `${at}/${key}`, message)]));
    }
    if (shape in MESSAGES) return messageOf(value, shape, at, message);
    if (shape === 'Date') return new Date(contentOf(value, 'string', at, message));
    return contentOf(value, shape, at, message);
}

/** The value, which must be of this type of JSON. */
function contentOf(value: unknown, kind: string, at: string, message: string): any {
    const own = value === null ? 'null' : Array.isArray(value) ? 'array' : typeof value;
    if (own !== kind) throw invalid(message, `${at || 'it'} is not of the type ${kind}`);
    return value;
}

function invalid(message: string, fault: string): InvalidAnswer {
    return new InvalidAnswer(`the answer is not the message ${message}: ${fault}`);
}
