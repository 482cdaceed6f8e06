/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

import { BaseApi, type Answer } from '../runtime';
import type {
    Benchmark,
    BenchmarkList,
    BoardEntry,
    BoardEntryList,
    Checkpoint,
    Comparison,
    ConsistencyProof,
    EpisodeList,
    FlagEntry,
    HistoryPage,
    InclusionProof,
    KeyList,
    PublishEntry,
    Ranking,
    RecordImport,
    RecordImportList,
    Run,
    RunList,
    Score,
    Service,
    StopRun,
    SubmitRun,
} from '../models';

export interface CompareRunsRequest {
    /** The run that the others are compared with. */
    baseline: string;
    /** Ids of one to sixteen runs, with commas between them; the baseline may be one of them. */
    runs: string;
    /** The largest difference that `release` lets pass; 0.05 when absent. */
    tolerance?: number;
    /** The protocol version the caller was written for. */
    proctorVersion?: string;
}

export interface DeleteImportRequest {
    importId: string;
    /** The protocol version the caller was written for. */
    proctorVersion?: string;
}

export interface DeleteRunRequest {
    runId: string;
    /** The protocol version the caller was written for. */
    proctorVersion?: string;
}

export interface DescribeServiceRequest {
    /** The protocol version the caller was written for. */
    proctorVersion?: string;
}

export interface FlagEntryRequest {
    entryId: string;
    flagEntry: FlagEntry;
    /** The protocol version the caller was written for. */
    proctorVersion?: string;
}

export interface GetBenchmarkRequest {
    benchmarkId: string;
    /** The protocol version the caller was written for. */
    proctorVersion?: string;
}

export interface GetCheckpointRequest {
    /** The protocol version the caller was written for. */
    proctorVersion?: string;
}

export interface GetEntryRequest {
    entryId: string;
    /** The protocol version the caller was written for. */
    proctorVersion?: string;
}

export interface GetImportRequest {
    importId: string;
    /** The protocol version the caller was written for. */
    proctorVersion?: string;
}

export interface GetRankingRequest {
    benchmarkId: string;
    /** Which manifest; that of `get_benchmark` when absent. */
    manifestSha256?: string;
    /** `next_cursor` of the page before; opaque to the caller. */
    cursor?: string;
    /** Most items wanted on a page; 100 when absent. */
    limit?: number;
    /** The protocol version the caller was written for. */
    proctorVersion?: string;
}

export interface GetRunRequest {
    runId: string;
    /** The ETag of the last answer, a list of some, or `*` for the one that the run has when the request arrives; while one of them holds, the answer is 304. A text that is no ETag names none. A tag with `W/` before it may name the same as without. For the profile `waiting`. */
    ifNoneMatch?: string;
    /** `wait=N` holds the answer back for up to N seconds until the run changes. Longer than `limits.wait_s_max` is granted as that; without If-None-Match nothing is waited for. Any other value is refused with `invalid_request` (ERR-014). */
    prefer?: string;
    /** The protocol version the caller was written for. */
    proctorVersion?: string;
}

export interface GetScoreRequest {
    runId: string;
    /** The protocol version the caller was written for. */
    proctorVersion?: string;
}

export interface ImportRecordRequest {
    body: BodyInit;
    /** The protocol version the caller was written for. */
    proctorVersion?: string;
}

export interface ListBenchmarksRequest {
    /** The protocol version the caller was written for. */
    proctorVersion?: string;
}

export interface ListEntriesRequest {
    /** Only entries of this benchmark. */
    benchmarkId?: string;
    /** `next_cursor` of the page before; opaque to the caller. */
    cursor?: string;
    /** Most items wanted on a page; 100 when absent. */
    limit?: number;
    /** The protocol version the caller was written for. */
    proctorVersion?: string;
}

export interface ListEpisodesRequest {
    runId: string;
    /** `next_cursor` of the page before; opaque to the caller. */
    cursor?: string;
    /** Most items wanted on a page; 100 when absent. */
    limit?: number;
    /** The protocol version the caller was written for. */
    proctorVersion?: string;
}

export interface ListHistoryRequest {
    /** `next_cursor` of the page before; opaque to the caller. */
    cursor?: string;
    /** Most items wanted on a page; 100 when absent. */
    limit?: number;
    /** The protocol version the caller was written for. */
    proctorVersion?: string;
}

export interface ListImportsRequest {
    /** `next_cursor` of the page before; opaque to the caller. */
    cursor?: string;
    /** Most items wanted on a page; 100 when absent. */
    limit?: number;
    /** The protocol version the caller was written for. */
    proctorVersion?: string;
}

export interface ListKeysRequest {
    /** The protocol version the caller was written for. */
    proctorVersion?: string;
}

export interface ListRunsRequest {
    /** `next_cursor` of the page before; opaque to the caller. */
    cursor?: string;
    /** Most items wanted on a page; 100 when absent. */
    limit?: number;
    /** The protocol version the caller was written for. */
    proctorVersion?: string;
}

export interface ProveConsistencyRequest {
    /** Size of the older history, from 1. */
    oldSize: string;
    /** Size of the newer history, from 1. */
    newSize: string;
    /** The protocol version the caller was written for. */
    proctorVersion?: string;
}

export interface ProveInclusionRequest {
    /** Index of the leaf, from 0. */
    leafIndex: string;
    /** Size of the history, from 1. */
    treeSize: string;
    /** The protocol version the caller was written for. */
    proctorVersion?: string;
}

export interface PublishEntryRequest {
    runId: string;
    publishEntry: PublishEntry;
    /** The protocol version the caller was written for. */
    proctorVersion?: string;
}

export interface ResumeRunRequest {
    runId: string;
    /** The protocol version the caller was written for. */
    proctorVersion?: string;
}

export interface StopRunRequest {
    runId: string;
    stopRun: StopRun;
    /** The protocol version the caller was written for. */
    proctorVersion?: string;
}

export interface SubmitRunRequest {
    submitRun: SubmitRun;
    /** Makes a repeated submit return the first run instead of making another. One that breaks the pattern is refused with `invalid_request` (ERR-014). For the profile `submit_once`. */
    idempotencyKey?: string;
    /** The protocol version the caller was written for. */
    proctorVersion?: string;
}

export interface WithdrawEntryRequest {
    runId: string;
    /** The protocol version the caller was written for. */
    proctorVersion?: string;
}

/**
 * Each call throws ResponseError for a refusal, FetchError if no answer comes, InvalidAnswer for a success that is not
 * the message expected. `init` is added to what `fetch` is given: a signal, further headers.
 */
export class ControlApi extends BaseApi {
    /** Compare runs with a baseline. */
    compareRuns(request: CompareRunsRequest, init?: RequestInit): Answer<Comparison> {
        return this.call('Comparison', 'GET', '/v1/comparisons', {
            query: { baseline: request.baseline, runs: request.runs, tolerance: request.tolerance },
            headers: { 'Proctor-Version': request.proctorVersion },
        }, init);
    }

    /** Delete an imported record. */
    deleteImport(request: DeleteImportRequest, init?: RequestInit): Answer<void> {
        return this.call(null, 'DELETE', '/v1/records/{import_id}', {
            path: { import_id: request.importId },
            headers: { 'Proctor-Version': request.proctorVersion },
        }, init);
    }

    /** Delete a run. */
    deleteRun(request: DeleteRunRequest, init?: RequestInit): Answer<void> {
        return this.call(null, 'DELETE', '/v1/runs/{run_id}', {
            path: { run_id: request.runId },
            headers: { 'Proctor-Version': request.proctorVersion },
        }, init);
    }

    /** Describe the service. */
    describeService(request: DescribeServiceRequest = {}, init?: RequestInit): Answer<Service> {
        return this.call('Service', 'GET', '/v1', {
            headers: { 'Proctor-Version': request.proctorVersion },
        }, init);
    }

    /** Flag an entry, or remove its flag. */
    flagEntry(request: FlagEntryRequest, init?: RequestInit): Answer<BoardEntry> {
        return this.call('BoardEntry', 'PUT', '/v1/entries/{entry_id}/flag', {
            path: { entry_id: request.entryId },
            headers: { 'Proctor-Version': request.proctorVersion },
            body: request.flagEntry,
        }, init);
    }

    /** Get a benchmark. */
    getBenchmark(request: GetBenchmarkRequest, init?: RequestInit): Answer<Benchmark> {
        return this.call('Benchmark', 'GET', '/v1/benchmarks/{benchmark_id}', {
            path: { benchmark_id: request.benchmarkId },
            headers: { 'Proctor-Version': request.proctorVersion },
        }, init);
    }

    /** Get the signed checkpoint of the history. */
    getCheckpoint(request: GetCheckpointRequest = {}, init?: RequestInit): Answer<Checkpoint> {
        return this.call('Checkpoint', 'GET', '/v1/history/checkpoint', {
            headers: { 'Proctor-Version': request.proctorVersion },
        }, init);
    }

    /** Get an entry. */
    getEntry(request: GetEntryRequest, init?: RequestInit): Answer<BoardEntry> {
        return this.call('BoardEntry', 'GET', '/v1/entries/{entry_id}', {
            path: { entry_id: request.entryId },
            headers: { 'Proctor-Version': request.proctorVersion },
        }, init);
    }

    /** Get an imported record. */
    getImport(request: GetImportRequest, init?: RequestInit): Answer<RecordImport> {
        return this.call('RecordImport', 'GET', '/v1/records/{import_id}', {
            path: { import_id: request.importId },
            headers: { 'Proctor-Version': request.proctorVersion },
        }, init);
    }

    /** Get the ranking of a benchmark. */
    getRanking(request: GetRankingRequest, init?: RequestInit): Answer<Ranking> {
        return this.call('Ranking', 'GET', '/v1/benchmarks/{benchmark_id}/ranking', {
            path: { benchmark_id: request.benchmarkId },
            query: { manifest_sha256: request.manifestSha256, cursor: request.cursor, limit: request.limit },
            headers: { 'Proctor-Version': request.proctorVersion },
        }, init);
    }

    /** Get a run, or wait for its next change. */
    getRun(request: GetRunRequest, init?: RequestInit): Answer<Run> {
        return this.call('Run', 'GET', '/v1/runs/{run_id}', {
            path: { run_id: request.runId },
            headers: { 'If-None-Match': request.ifNoneMatch, 'Prefer': request.prefer, 'Proctor-Version': request.proctorVersion },
        }, init);
    }

    /** Get the score of a run. */
    getScore(request: GetScoreRequest, init?: RequestInit): Answer<Score> {
        return this.call('Score', 'GET', '/v1/runs/{run_id}/score', {
            path: { run_id: request.runId },
            headers: { 'Proctor-Version': request.proctorVersion },
        }, init);
    }

    /** Import a record. */
    importRecord(request: ImportRecordRequest, init?: RequestInit): Answer<RecordImport> {
        return this.call('RecordImport', 'POST', '/v1/records', {
            headers: { 'Proctor-Version': request.proctorVersion },
            body: request.body,
            contentType: 'application/zip',
        }, init);
    }

    /** List the benchmarks. */
    listBenchmarks(request: ListBenchmarksRequest = {}, init?: RequestInit): Answer<BenchmarkList> {
        return this.call('BenchmarkList', 'GET', '/v1/benchmarks', {
            headers: { 'Proctor-Version': request.proctorVersion },
        }, init);
    }

    /** List entries of the leaderboard. */
    listEntries(request: ListEntriesRequest = {}, init?: RequestInit): Answer<BoardEntryList> {
        return this.call('BoardEntryList', 'GET', '/v1/entries', {
            query: { benchmark_id: request.benchmarkId, cursor: request.cursor, limit: request.limit },
            headers: { 'Proctor-Version': request.proctorVersion },
        }, init);
    }

    /** List the episodes of a run. */
    listEpisodes(request: ListEpisodesRequest, init?: RequestInit): Answer<EpisodeList> {
        return this.call('EpisodeList', 'GET', '/v1/runs/{run_id}/episodes', {
            path: { run_id: request.runId },
            query: { cursor: request.cursor, limit: request.limit },
            headers: { 'Proctor-Version': request.proctorVersion },
        }, init);
    }

    /** List the history. */
    listHistory(request: ListHistoryRequest = {}, init?: RequestInit): Answer<HistoryPage> {
        return this.call('HistoryPage', 'GET', '/v1/history', {
            query: { cursor: request.cursor, limit: request.limit },
            headers: { 'Proctor-Version': request.proctorVersion },
        }, init);
    }

    /** List imported records. */
    listImports(request: ListImportsRequest = {}, init?: RequestInit): Answer<RecordImportList> {
        return this.call('RecordImportList', 'GET', '/v1/records', {
            query: { cursor: request.cursor, limit: request.limit },
            headers: { 'Proctor-Version': request.proctorVersion },
        }, init);
    }

    /** List the signing keys. */
    listKeys(request: ListKeysRequest = {}, init?: RequestInit): Answer<KeyList> {
        return this.call('KeyList', 'GET', '/v1/keys', {
            headers: { 'Proctor-Version': request.proctorVersion },
        }, init);
    }

    /** List runs. */
    listRuns(request: ListRunsRequest = {}, init?: RequestInit): Answer<RunList> {
        return this.call('RunList', 'GET', '/v1/runs', {
            query: { cursor: request.cursor, limit: request.limit },
            headers: { 'Proctor-Version': request.proctorVersion },
        }, init);
    }

    /** Prove that the history only grew. */
    proveConsistency(request: ProveConsistencyRequest, init?: RequestInit): Answer<ConsistencyProof> {
        return this.call('ConsistencyProof', 'GET', '/v1/history/consistency', {
            query: { old_size: request.oldSize, new_size: request.newSize },
            headers: { 'Proctor-Version': request.proctorVersion },
        }, init);
    }

    /** Prove that a leaf is in the history. */
    proveInclusion(request: ProveInclusionRequest, init?: RequestInit): Answer<InclusionProof> {
        return this.call('InclusionProof', 'GET', '/v1/history/inclusion', {
            query: { leaf_index: request.leafIndex, tree_size: request.treeSize },
            headers: { 'Proctor-Version': request.proctorVersion },
        }, init);
    }

    /** Publish a run on the leaderboard. */
    publishEntry(request: PublishEntryRequest, init?: RequestInit): Answer<BoardEntry> {
        return this.call('BoardEntry', 'PUT', '/v1/runs/{run_id}/entry', {
            path: { run_id: request.runId },
            headers: { 'Proctor-Version': request.proctorVersion },
            body: request.publishEntry,
        }, init);
    }

    /** Resume a run. */
    resumeRun(request: ResumeRunRequest, init?: RequestInit): Answer<Run> {
        return this.call('Run', 'POST', '/v1/runs/{run_id}/resume', {
            path: { run_id: request.runId },
            headers: { 'Proctor-Version': request.proctorVersion },
        }, init);
    }

    /** Stop a run. */
    stopRun(request: StopRunRequest, init?: RequestInit): Answer<Run> {
        return this.call('Run', 'POST', '/v1/runs/{run_id}/stop', {
            path: { run_id: request.runId },
            headers: { 'Proctor-Version': request.proctorVersion },
            body: request.stopRun,
        }, init);
    }

    /** Submit a run. */
    submitRun(request: SubmitRunRequest, init?: RequestInit): Answer<Run> {
        return this.call('Run', 'POST', '/v1/runs', {
            headers: { 'Idempotency-Key': request.idempotencyKey, 'Proctor-Version': request.proctorVersion },
            body: request.submitRun,
        }, init);
    }

    /** Withdraw the entry of a run. */
    withdrawEntry(request: WithdrawEntryRequest, init?: RequestInit): Answer<BoardEntry> {
        return this.call('BoardEntry', 'DELETE', '/v1/runs/{run_id}/entry', {
            path: { run_id: request.runId },
            headers: { 'Proctor-Version': request.proctorVersion },
        }, init);
    }
}
