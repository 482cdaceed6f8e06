/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

import * as runtime from '../runtime';
import {
    type Benchmark,
    BenchmarkFromJSON,
    BenchmarkToJSON,
} from '../models/Benchmark';
import {
    type BenchmarkList,
    BenchmarkListFromJSON,
    BenchmarkListToJSON,
} from '../models/BenchmarkList';
import {
    type BoardEntry,
    BoardEntryFromJSON,
    BoardEntryToJSON,
} from '../models/BoardEntry';
import {
    type BoardEntryList,
    BoardEntryListFromJSON,
    BoardEntryListToJSON,
} from '../models/BoardEntryList';
import {
    type Checkpoint,
    CheckpointFromJSON,
    CheckpointToJSON,
} from '../models/Checkpoint';
import {
    type Comparison,
    ComparisonFromJSON,
    ComparisonToJSON,
} from '../models/Comparison';
import {
    type ConsistencyProof,
    ConsistencyProofFromJSON,
    ConsistencyProofToJSON,
} from '../models/ConsistencyProof';
import {
    type EpisodeList,
    EpisodeListFromJSON,
    EpisodeListToJSON,
} from '../models/EpisodeList';
import {
    type FlagEntry,
    FlagEntryFromJSON,
    FlagEntryToJSON,
} from '../models/FlagEntry';
import {
    type HistoryPage,
    HistoryPageFromJSON,
    HistoryPageToJSON,
} from '../models/HistoryPage';
import {
    type InclusionProof,
    InclusionProofFromJSON,
    InclusionProofToJSON,
} from '../models/InclusionProof';
import {
    type KeyList,
    KeyListFromJSON,
    KeyListToJSON,
} from '../models/KeyList';
import {
    type Problem,
    ProblemFromJSON,
    ProblemToJSON,
} from '../models/Problem';
import {
    type PublishEntry,
    PublishEntryFromJSON,
    PublishEntryToJSON,
} from '../models/PublishEntry';
import {
    type Ranking,
    RankingFromJSON,
    RankingToJSON,
} from '../models/Ranking';
import {
    type RecordImport,
    RecordImportFromJSON,
    RecordImportToJSON,
} from '../models/RecordImport';
import {
    type RecordImportList,
    RecordImportListFromJSON,
    RecordImportListToJSON,
} from '../models/RecordImportList';
import {
    type Run,
    RunFromJSON,
    RunToJSON,
} from '../models/Run';
import {
    type RunList,
    RunListFromJSON,
    RunListToJSON,
} from '../models/RunList';
import {
    type Score,
    ScoreFromJSON,
    ScoreToJSON,
} from '../models/Score';
import {
    type Service,
    ServiceFromJSON,
    ServiceToJSON,
} from '../models/Service';
import {
    type StopRun,
    StopRunFromJSON,
    StopRunToJSON,
} from '../models/StopRun';
import {
    type SubmitRun,
    SubmitRunFromJSON,
    SubmitRunToJSON,
} from '../models/SubmitRun';

export interface CompareRunsRequest {
    /**
     * The run that the others are compared with.
     */
    baseline: string;
    /**
     * Ids of one to sixteen runs, with commas between them; the baseline may be one of them.
     */
    runs: string;
    /**
     * The largest difference that `release` lets pass; 0.05 when absent.
     */
    tolerance?: number;
    /**
     * The protocol version the caller was written for.
     */
    proctorVersion?: string;
}

export interface DeleteImportRequest {
    /**
     *
     */
    importId: string;
    /**
     * The protocol version the caller was written for.
     */
    proctorVersion?: string;
}

export interface DeleteRunRequest {
    /**
     *
     */
    runId: string;
    /**
     * The protocol version the caller was written for.
     */
    proctorVersion?: string;
}

export interface DescribeServiceRequest {
    /**
     * The protocol version the caller was written for.
     */
    proctorVersion?: string;
}

export interface FlagEntryRequest {
    /**
     *
     */
    entryId: string;
    /**
     *
     */
    flagEntry: FlagEntry;
    /**
     * The protocol version the caller was written for.
     */
    proctorVersion?: string;
}

export interface GetBenchmarkRequest {
    /**
     *
     */
    benchmarkId: string;
    /**
     * The protocol version the caller was written for.
     */
    proctorVersion?: string;
}

export interface GetCheckpointRequest {
    /**
     * The protocol version the caller was written for.
     */
    proctorVersion?: string;
}

export interface GetEntryRequest {
    /**
     *
     */
    entryId: string;
    /**
     * The protocol version the caller was written for.
     */
    proctorVersion?: string;
}

export interface GetImportRequest {
    /**
     *
     */
    importId: string;
    /**
     * The protocol version the caller was written for.
     */
    proctorVersion?: string;
}

export interface GetRankingRequest {
    /**
     *
     */
    benchmarkId: string;
    /**
     * Which manifest; that of `get_benchmark` when absent.
     */
    manifestSha256?: string;
    /**
     * `next_cursor` of the page before; opaque to the caller.
     */
    cursor?: string;
    /**
     * Most items wanted on a page; 100 when absent.
     */
    limit?: number;
    /**
     * The protocol version the caller was written for.
     */
    proctorVersion?: string;
}

export interface GetRunRequest {
    /**
     *
     */
    runId: string;
    /**
     * The ETag of the last answer, a list of some, or `*`; while one of them holds, the answer is 304. A text that is no ETag names none. A tag with `W/` before it may name the same as without.
     */
    ifNoneMatch?: string;
    /**
     * `wait=N` holds the answer back for up to N seconds until the ETag in If-None-Match no longer holds. Longer than `limits.wait_s_max` is granted as that; without If-None-Match nothing is waited for. Any other value is refused with `invalid_request` (ERR-014).
     */
    prefer?: string;
    /**
     * The protocol version the caller was written for.
     */
    proctorVersion?: string;
}

export interface GetScoreRequest {
    /**
     *
     */
    runId: string;
    /**
     * The protocol version the caller was written for.
     */
    proctorVersion?: string;
}

export interface ImportRecordRequest {
    /**
     *
     */
    body: string;
    /**
     * The protocol version the caller was written for.
     */
    proctorVersion?: string;
}

export interface ListBenchmarksRequest {
    /**
     * The protocol version the caller was written for.
     */
    proctorVersion?: string;
}

export interface ListEntriesRequest {
    /**
     * Only entries of this benchmark.
     */
    benchmarkId?: string;
    /**
     * `next_cursor` of the page before; opaque to the caller.
     */
    cursor?: string;
    /**
     * Most items wanted on a page; 100 when absent.
     */
    limit?: number;
    /**
     * The protocol version the caller was written for.
     */
    proctorVersion?: string;
}

export interface ListEpisodesRequest {
    /**
     *
     */
    runId: string;
    /**
     * `next_cursor` of the page before; opaque to the caller.
     */
    cursor?: string;
    /**
     * Most items wanted on a page; 100 when absent.
     */
    limit?: number;
    /**
     * The protocol version the caller was written for.
     */
    proctorVersion?: string;
}

export interface ListHistoryRequest {
    /**
     * `next_cursor` of the page before; opaque to the caller.
     */
    cursor?: string;
    /**
     * Most items wanted on a page; 100 when absent.
     */
    limit?: number;
    /**
     * The protocol version the caller was written for.
     */
    proctorVersion?: string;
}

export interface ListImportsRequest {
    /**
     * `next_cursor` of the page before; opaque to the caller.
     */
    cursor?: string;
    /**
     * Most items wanted on a page; 100 when absent.
     */
    limit?: number;
    /**
     * The protocol version the caller was written for.
     */
    proctorVersion?: string;
}

export interface ListKeysRequest {
    /**
     * The protocol version the caller was written for.
     */
    proctorVersion?: string;
}

export interface ListRunsRequest {
    /**
     * `next_cursor` of the page before; opaque to the caller.
     */
    cursor?: string;
    /**
     * Most items wanted on a page; 100 when absent.
     */
    limit?: number;
    /**
     * The protocol version the caller was written for.
     */
    proctorVersion?: string;
}

export interface ProveConsistencyRequest {
    /**
     * Size of the older history.
     */
    oldSize: string;
    /**
     * Size of the newer history.
     */
    newSize: string;
    /**
     * The protocol version the caller was written for.
     */
    proctorVersion?: string;
}

export interface ProveInclusionRequest {
    /**
     * Index of the leaf, from 0.
     */
    leafIndex: string;
    /**
     * Size of the history.
     */
    treeSize: string;
    /**
     * The protocol version the caller was written for.
     */
    proctorVersion?: string;
}

export interface PublishEntryRequest {
    /**
     *
     */
    runId: string;
    /**
     *
     */
    publishEntry: PublishEntry;
    /**
     * The protocol version the caller was written for.
     */
    proctorVersion?: string;
}

export interface ResumeRunRequest {
    /**
     *
     */
    runId: string;
    /**
     * The protocol version the caller was written for.
     */
    proctorVersion?: string;
}

export interface StopRunRequest {
    /**
     *
     */
    runId: string;
    /**
     *
     */
    stopRun: StopRun;
    /**
     * The protocol version the caller was written for.
     */
    proctorVersion?: string;
}

export interface SubmitRunRequest {
    /**
     *
     */
    submitRun: SubmitRun;
    /**
     * Makes a repeated submit return the first run instead of making another. One that breaks the pattern is refused with `invalid_request` (ERR-014).
     */
    idempotencyKey?: string;
    /**
     * The protocol version the caller was written for.
     */
    proctorVersion?: string;
}

export interface WithdrawEntryRequest {
    /**
     *
     */
    runId: string;
    /**
     * The protocol version the caller was written for.
     */
    proctorVersion?: string;
}

/**
 *
 */
export class ControlApi extends runtime.BaseAPI {

    /**
     * Creates request options for compareRuns without sending the request
     */
    async compareRunsRequestOpts(requestParameters: CompareRunsRequest): Promise<runtime.RequestOpts> {
        if (requestParameters['baseline'] == null) {
            throw new runtime.RequiredError(
                'baseline',
                'Required parameter "baseline" was null or undefined when calling compareRuns().'
            );
        }

        if (requestParameters['runs'] == null) {
            throw new runtime.RequiredError(
                'runs',
                'Required parameter "runs" was null or undefined when calling compareRuns().'
            );
        }

        const queryParameters: any = {};

        if (requestParameters['baseline'] != null) {
            queryParameters['baseline'] = requestParameters['baseline'];
        }

        if (requestParameters['runs'] != null) {
            queryParameters['runs'] = requestParameters['runs'];
        }

        if (requestParameters['tolerance'] != null) {
            queryParameters['tolerance'] = requestParameters['tolerance'];
        }

        const headerParameters: runtime.HTTPHeaders = {};

        if (requestParameters['proctorVersion'] != null) {
            headerParameters['Proctor-Version'] = String(requestParameters['proctorVersion']);
        }

        if (this.configuration && this.configuration.accessToken) {
            const token = this.configuration.accessToken;
            const tokenString = await token("bearer", []);

            if (tokenString) {
                headerParameters["Authorization"] = `Bearer ${tokenString}`;
            }
        }

        let urlPath = `/v1/comparisons`;

        return {
            path: urlPath,
            method: 'GET',
            headers: headerParameters,
            query: queryParameters,
        };
    }

    /**
     * Pairs the episodes of runs of one manifest. Offered with the profile `compare`; scoring.md has the arithmetic.
     * Runs beside a baseline, episode by episode
     */
    async compareRunsRaw(requestParameters: CompareRunsRequest, initOverrides?: RequestInit | runtime.InitOverrideFunction): Promise<runtime.ApiResponse<Comparison>> {
        const requestOptions = await this.compareRunsRequestOpts(requestParameters);
        const response = await this.request(requestOptions, initOverrides);

        return new runtime.JSONApiResponse(response, (jsonValue) => ComparisonFromJSON(jsonValue));
    }

    /**
     * Pairs the episodes of runs of one manifest. Offered with the profile `compare`; scoring.md has the arithmetic.
     * Runs beside a baseline, episode by episode
     */
    async compareRuns(requestParameters: CompareRunsRequest, initOverrides?: RequestInit | runtime.InitOverrideFunction): Promise<Comparison> {
        const response = await this.compareRunsRaw(requestParameters, initOverrides);
        return await response.value();
    }

    /**
     * Creates request options for deleteImport without sending the request
     */
    async deleteImportRequestOpts(requestParameters: DeleteImportRequest): Promise<runtime.RequestOpts> {
        if (requestParameters['importId'] == null) {
            throw new runtime.RequiredError(
                'importId',
                'Required parameter "importId" was null or undefined when calling deleteImport().'
            );
        }

        const queryParameters: any = {};

        const headerParameters: runtime.HTTPHeaders = {};

        if (requestParameters['proctorVersion'] != null) {
            headerParameters['Proctor-Version'] = String(requestParameters['proctorVersion']);
        }

        if (this.configuration && this.configuration.accessToken) {
            const token = this.configuration.accessToken;
            const tokenString = await token("bearer", []);

            if (tokenString) {
                headerParameters["Authorization"] = `Bearer ${tokenString}`;
            }
        }

        let urlPath = `/v1/records/{import_id}`;
        urlPath = urlPath.replace('{import_id}', encodeURIComponent(String(requestParameters['importId'])));

        return {
            path: urlPath,
            method: 'DELETE',
            headers: headerParameters,
            query: queryParameters,
        };
    }

    /**
     * What was read of it and its replay are forgotten. Offered with the profile `record_import`.
     * Remove a record that was handed in
     */
    async deleteImportRaw(requestParameters: DeleteImportRequest, initOverrides?: RequestInit | runtime.InitOverrideFunction): Promise<runtime.ApiResponse<void>> {
        const requestOptions = await this.deleteImportRequestOpts(requestParameters);
        const response = await this.request(requestOptions, initOverrides);

        return new runtime.VoidApiResponse(response);
    }

    /**
     * What was read of it and its replay are forgotten. Offered with the profile `record_import`.
     * Remove a record that was handed in
     */
    async deleteImport(requestParameters: DeleteImportRequest, initOverrides?: RequestInit | runtime.InitOverrideFunction): Promise<void> {
        await this.deleteImportRaw(requestParameters, initOverrides);
    }

    /**
     * Creates request options for deleteRun without sending the request
     */
    async deleteRunRequestOpts(requestParameters: DeleteRunRequest): Promise<runtime.RequestOpts> {
        if (requestParameters['runId'] == null) {
            throw new runtime.RequiredError(
                'runId',
                'Required parameter "runId" was null or undefined when calling deleteRun().'
            );
        }

        const queryParameters: any = {};

        const headerParameters: runtime.HTTPHeaders = {};

        if (requestParameters['proctorVersion'] != null) {
            headerParameters['Proctor-Version'] = String(requestParameters['proctorVersion']);
        }

        if (this.configuration && this.configuration.accessToken) {
            const token = this.configuration.accessToken;
            const tokenString = await token("bearer", []);

            if (tokenString) {
                headerParameters["Authorization"] = `Bearer ${tokenString}`;
            }
        }

        let urlPath = `/v1/runs/{run_id}`;
        urlPath = urlPath.replace('{run_id}', encodeURIComponent(String(requestParameters['runId'])));

        return {
            path: urlPath,
            method: 'DELETE',
            headers: headerParameters,
            query: queryParameters,
        };
    }

    /**
     * Delete a run that is not in play, with all that is stored of it
     */
    async deleteRunRaw(requestParameters: DeleteRunRequest, initOverrides?: RequestInit | runtime.InitOverrideFunction): Promise<runtime.ApiResponse<void>> {
        const requestOptions = await this.deleteRunRequestOpts(requestParameters);
        const response = await this.request(requestOptions, initOverrides);

        return new runtime.VoidApiResponse(response);
    }

    /**
     * Delete a run that is not in play, with all that is stored of it
     */
    async deleteRun(requestParameters: DeleteRunRequest, initOverrides?: RequestInit | runtime.InitOverrideFunction): Promise<void> {
        await this.deleteRunRaw(requestParameters, initOverrides);
    }

    /**
     * Creates request options for describeService without sending the request
     */
    async describeServiceRequestOpts(requestParameters: DescribeServiceRequest): Promise<runtime.RequestOpts> {
        const queryParameters: any = {};

        const headerParameters: runtime.HTTPHeaders = {};

        if (requestParameters['proctorVersion'] != null) {
            headerParameters['Proctor-Version'] = String(requestParameters['proctorVersion']);
        }


        let urlPath = `/v1`;

        return {
            path: urlPath,
            method: 'GET',
            headers: headerParameters,
            query: queryParameters,
        };
    }

    /**
     * What this server is, speaks and allows
     */
    async describeServiceRaw(requestParameters: DescribeServiceRequest, initOverrides?: RequestInit | runtime.InitOverrideFunction): Promise<runtime.ApiResponse<Service>> {
        const requestOptions = await this.describeServiceRequestOpts(requestParameters);
        const response = await this.request(requestOptions, initOverrides);

        return new runtime.JSONApiResponse(response, (jsonValue) => ServiceFromJSON(jsonValue));
    }

    /**
     * What this server is, speaks and allows
     */
    async describeService(requestParameters: DescribeServiceRequest = {}, initOverrides?: RequestInit | runtime.InitOverrideFunction): Promise<Service> {
        const response = await this.describeServiceRaw(requestParameters, initOverrides);
        return await response.value();
    }

    /**
     * Creates request options for flagEntry without sending the request
     */
    async flagEntryRequestOpts(requestParameters: FlagEntryRequest): Promise<runtime.RequestOpts> {
        if (requestParameters['entryId'] == null) {
            throw new runtime.RequiredError(
                'entryId',
                'Required parameter "entryId" was null or undefined when calling flagEntry().'
            );
        }

        if (requestParameters['flagEntry'] == null) {
            throw new runtime.RequiredError(
                'flagEntry',
                'Required parameter "flagEntry" was null or undefined when calling flagEntry().'
            );
        }

        const queryParameters: any = {};

        const headerParameters: runtime.HTTPHeaders = {};

        headerParameters['Content-Type'] = 'application/json';

        if (requestParameters['proctorVersion'] != null) {
            headerParameters['Proctor-Version'] = String(requestParameters['proctorVersion']);
        }

        if (this.configuration && this.configuration.accessToken) {
            const token = this.configuration.accessToken;
            const tokenString = await token("bearer", []);

            if (tokenString) {
                headerParameters["Authorization"] = `Bearer ${tokenString}`;
            }
        }

        let urlPath = `/v1/entries/{entry_id}/flag`;
        urlPath = urlPath.replace('{entry_id}', encodeURIComponent(String(requestParameters['entryId'])));

        return {
            path: urlPath,
            method: 'PUT',
            headers: headerParameters,
            query: queryParameters,
            body: FlagEntryToJSON(requestParameters['flagEntry']),
        };
    }

    /**
     * For the host: the token needs the scope `host`, besides `run`. A flagged entry is shown with the reason, and has no rank.
     * Say of a public entry that something is wrong with it, or take that back
     */
    async flagEntryRaw(requestParameters: FlagEntryRequest, initOverrides?: RequestInit | runtime.InitOverrideFunction): Promise<runtime.ApiResponse<BoardEntry>> {
        const requestOptions = await this.flagEntryRequestOpts(requestParameters);
        const response = await this.request(requestOptions, initOverrides);

        return new runtime.JSONApiResponse(response, (jsonValue) => BoardEntryFromJSON(jsonValue));
    }

    /**
     * For the host: the token needs the scope `host`, besides `run`. A flagged entry is shown with the reason, and has no rank.
     * Say of a public entry that something is wrong with it, or take that back
     */
    async flagEntry(requestParameters: FlagEntryRequest, initOverrides?: RequestInit | runtime.InitOverrideFunction): Promise<BoardEntry> {
        const response = await this.flagEntryRaw(requestParameters, initOverrides);
        return await response.value();
    }

    /**
     * Creates request options for getBenchmark without sending the request
     */
    async getBenchmarkRequestOpts(requestParameters: GetBenchmarkRequest): Promise<runtime.RequestOpts> {
        if (requestParameters['benchmarkId'] == null) {
            throw new runtime.RequiredError(
                'benchmarkId',
                'Required parameter "benchmarkId" was null or undefined when calling getBenchmark().'
            );
        }

        const queryParameters: any = {};

        const headerParameters: runtime.HTTPHeaders = {};

        if (requestParameters['proctorVersion'] != null) {
            headerParameters['Proctor-Version'] = String(requestParameters['proctorVersion']);
        }

        if (this.configuration && this.configuration.accessToken) {
            const token = this.configuration.accessToken;
            const tokenString = await token("bearer", []);

            if (tokenString) {
                headerParameters["Authorization"] = `Bearer ${tokenString}`;
            }
        }

        let urlPath = `/v1/benchmarks/{benchmark_id}`;
        urlPath = urlPath.replace('{benchmark_id}', encodeURIComponent(String(requestParameters['benchmarkId'])));

        return {
            path: urlPath,
            method: 'GET',
            headers: headerParameters,
            query: queryParameters,
        };
    }

    /**
     * One benchmark with its spaces, conventions and rules
     */
    async getBenchmarkRaw(requestParameters: GetBenchmarkRequest, initOverrides?: RequestInit | runtime.InitOverrideFunction): Promise<runtime.ApiResponse<Benchmark>> {
        const requestOptions = await this.getBenchmarkRequestOpts(requestParameters);
        const response = await this.request(requestOptions, initOverrides);

        return new runtime.JSONApiResponse(response, (jsonValue) => BenchmarkFromJSON(jsonValue));
    }

    /**
     * One benchmark with its spaces, conventions and rules
     */
    async getBenchmark(requestParameters: GetBenchmarkRequest, initOverrides?: RequestInit | runtime.InitOverrideFunction): Promise<Benchmark> {
        const response = await this.getBenchmarkRaw(requestParameters, initOverrides);
        return await response.value();
    }

    /**
     * Creates request options for getCheckpoint without sending the request
     */
    async getCheckpointRequestOpts(requestParameters: GetCheckpointRequest): Promise<runtime.RequestOpts> {
        const queryParameters: any = {};

        const headerParameters: runtime.HTTPHeaders = {};

        if (requestParameters['proctorVersion'] != null) {
            headerParameters['Proctor-Version'] = String(requestParameters['proctorVersion']);
        }

        if (this.configuration && this.configuration.accessToken) {
            const token = this.configuration.accessToken;
            const tokenString = await token("bearer", []);

            if (tokenString) {
                headerParameters["Authorization"] = `Bearer ${tokenString}`;
            }
        }

        let urlPath = `/v1/history/checkpoint`;

        return {
            path: urlPath,
            method: 'GET',
            headers: headerParameters,
            query: queryParameters,
        };
    }

    /**
     * A signed note, as board.md has it, by the key of `list_keys` that is in use.
     * The size and the root of the history, signed
     */
    async getCheckpointRaw(requestParameters: GetCheckpointRequest, initOverrides?: RequestInit | runtime.InitOverrideFunction): Promise<runtime.ApiResponse<Checkpoint>> {
        const requestOptions = await this.getCheckpointRequestOpts(requestParameters);
        const response = await this.request(requestOptions, initOverrides);

        return new runtime.JSONApiResponse(response, (jsonValue) => CheckpointFromJSON(jsonValue));
    }

    /**
     * A signed note, as board.md has it, by the key of `list_keys` that is in use.
     * The size and the root of the history, signed
     */
    async getCheckpoint(requestParameters: GetCheckpointRequest = {}, initOverrides?: RequestInit | runtime.InitOverrideFunction): Promise<Checkpoint> {
        const response = await this.getCheckpointRaw(requestParameters, initOverrides);
        return await response.value();
    }

    /**
     * Creates request options for getEntry without sending the request
     */
    async getEntryRequestOpts(requestParameters: GetEntryRequest): Promise<runtime.RequestOpts> {
        if (requestParameters['entryId'] == null) {
            throw new runtime.RequiredError(
                'entryId',
                'Required parameter "entryId" was null or undefined when calling getEntry().'
            );
        }

        const queryParameters: any = {};

        const headerParameters: runtime.HTTPHeaders = {};

        if (requestParameters['proctorVersion'] != null) {
            headerParameters['Proctor-Version'] = String(requestParameters['proctorVersion']);
        }

        if (this.configuration && this.configuration.accessToken) {
            const token = this.configuration.accessToken;
            const tokenString = await token("bearer", []);

            if (tokenString) {
                headerParameters["Authorization"] = `Bearer ${tokenString}`;
            }
        }

        let urlPath = `/v1/entries/{entry_id}`;
        urlPath = urlPath.replace('{entry_id}', encodeURIComponent(String(requestParameters['entryId'])));

        return {
            path: urlPath,
            method: 'GET',
            headers: headerParameters,
            query: queryParameters,
        };
    }

    /**
     * Of another account only if it is public, or was when it was withdrawn.
     * One entry, withdrawn or not
     */
    async getEntryRaw(requestParameters: GetEntryRequest, initOverrides?: RequestInit | runtime.InitOverrideFunction): Promise<runtime.ApiResponse<BoardEntry>> {
        const requestOptions = await this.getEntryRequestOpts(requestParameters);
        const response = await this.request(requestOptions, initOverrides);

        return new runtime.JSONApiResponse(response, (jsonValue) => BoardEntryFromJSON(jsonValue));
    }

    /**
     * Of another account only if it is public, or was when it was withdrawn.
     * One entry, withdrawn or not
     */
    async getEntry(requestParameters: GetEntryRequest, initOverrides?: RequestInit | runtime.InitOverrideFunction): Promise<BoardEntry> {
        const response = await this.getEntryRaw(requestParameters, initOverrides);
        return await response.value();
    }

    /**
     * Creates request options for getImport without sending the request
     */
    async getImportRequestOpts(requestParameters: GetImportRequest): Promise<runtime.RequestOpts> {
        if (requestParameters['importId'] == null) {
            throw new runtime.RequiredError(
                'importId',
                'Required parameter "importId" was null or undefined when calling getImport().'
            );
        }

        const queryParameters: any = {};

        const headerParameters: runtime.HTTPHeaders = {};

        if (requestParameters['proctorVersion'] != null) {
            headerParameters['Proctor-Version'] = String(requestParameters['proctorVersion']);
        }

        if (this.configuration && this.configuration.accessToken) {
            const token = this.configuration.accessToken;
            const tokenString = await token("bearer", []);

            if (tokenString) {
                headerParameters["Authorization"] = `Bearer ${tokenString}`;
            }
        }

        let urlPath = `/v1/records/{import_id}`;
        urlPath = urlPath.replace('{import_id}', encodeURIComponent(String(requestParameters['importId'])));

        return {
            path: urlPath,
            method: 'GET',
            headers: headerParameters,
            query: queryParameters,
        };
    }

    /**
     * Offered with the profile `record_import`.
     * What is known here of a record that was handed in
     */
    async getImportRaw(requestParameters: GetImportRequest, initOverrides?: RequestInit | runtime.InitOverrideFunction): Promise<runtime.ApiResponse<RecordImport>> {
        const requestOptions = await this.getImportRequestOpts(requestParameters);
        const response = await this.request(requestOptions, initOverrides);

        return new runtime.JSONApiResponse(response, (jsonValue) => RecordImportFromJSON(jsonValue));
    }

    /**
     * Offered with the profile `record_import`.
     * What is known here of a record that was handed in
     */
    async getImport(requestParameters: GetImportRequest, initOverrides?: RequestInit | runtime.InitOverrideFunction): Promise<RecordImport> {
        const response = await this.getImportRaw(requestParameters, initOverrides);
        return await response.value();
    }

    /**
     * Creates request options for getRanking without sending the request
     */
    async getRankingRequestOpts(requestParameters: GetRankingRequest): Promise<runtime.RequestOpts> {
        if (requestParameters['benchmarkId'] == null) {
            throw new runtime.RequiredError(
                'benchmarkId',
                'Required parameter "benchmarkId" was null or undefined when calling getRanking().'
            );
        }

        const queryParameters: any = {};

        if (requestParameters['manifestSha256'] != null) {
            queryParameters['manifest_sha256'] = requestParameters['manifestSha256'];
        }

        if (requestParameters['cursor'] != null) {
            queryParameters['cursor'] = requestParameters['cursor'];
        }

        if (requestParameters['limit'] != null) {
            queryParameters['limit'] = requestParameters['limit'];
        }

        const headerParameters: runtime.HTTPHeaders = {};

        if (requestParameters['proctorVersion'] != null) {
            headerParameters['Proctor-Version'] = String(requestParameters['proctorVersion']);
        }

        if (this.configuration && this.configuration.accessToken) {
            const token = this.configuration.accessToken;
            const tokenString = await token("bearer", []);

            if (tokenString) {
                headerParameters["Authorization"] = `Bearer ${tokenString}`;
            }
        }

        let urlPath = `/v1/benchmarks/{benchmark_id}/ranking`;
        urlPath = urlPath.replace('{benchmark_id}', encodeURIComponent(String(requestParameters['benchmarkId'])));

        return {
            path: urlPath,
            method: 'GET',
            headers: headerParameters,
            query: queryParameters,
        };
    }

    /**
     * One ranking for every caller; private entries do not enter. board.md has the arithmetic.
     * The public entries of one manifest, ranked
     */
    async getRankingRaw(requestParameters: GetRankingRequest, initOverrides?: RequestInit | runtime.InitOverrideFunction): Promise<runtime.ApiResponse<Ranking>> {
        const requestOptions = await this.getRankingRequestOpts(requestParameters);
        const response = await this.request(requestOptions, initOverrides);

        return new runtime.JSONApiResponse(response, (jsonValue) => RankingFromJSON(jsonValue));
    }

    /**
     * One ranking for every caller; private entries do not enter. board.md has the arithmetic.
     * The public entries of one manifest, ranked
     */
    async getRanking(requestParameters: GetRankingRequest, initOverrides?: RequestInit | runtime.InitOverrideFunction): Promise<Ranking> {
        const response = await this.getRankingRaw(requestParameters, initOverrides);
        return await response.value();
    }

    /**
     * Creates request options for getRun without sending the request
     */
    async getRunRequestOpts(requestParameters: GetRunRequest): Promise<runtime.RequestOpts> {
        if (requestParameters['runId'] == null) {
            throw new runtime.RequiredError(
                'runId',
                'Required parameter "runId" was null or undefined when calling getRun().'
            );
        }

        const queryParameters: any = {};

        const headerParameters: runtime.HTTPHeaders = {};

        if (requestParameters['ifNoneMatch'] != null) {
            headerParameters['If-None-Match'] = String(requestParameters['ifNoneMatch']);
        }

        if (requestParameters['prefer'] != null) {
            headerParameters['Prefer'] = String(requestParameters['prefer']);
        }

        if (requestParameters['proctorVersion'] != null) {
            headerParameters['Proctor-Version'] = String(requestParameters['proctorVersion']);
        }

        if (this.configuration && this.configuration.accessToken) {
            const token = this.configuration.accessToken;
            const tokenString = await token("bearer", []);

            if (tokenString) {
                headerParameters["Authorization"] = `Bearer ${tokenString}`;
            }
        }

        let urlPath = `/v1/runs/{run_id}`;
        urlPath = urlPath.replace('{run_id}', encodeURIComponent(String(requestParameters['runId'])));

        return {
            path: urlPath,
            method: 'GET',
            headers: headerParameters,
            query: queryParameters,
        };
    }

    /**
     * State, progress and the reason for both; can wait for a change
     */
    async getRunRaw(requestParameters: GetRunRequest, initOverrides?: RequestInit | runtime.InitOverrideFunction): Promise<runtime.ApiResponse<Run>> {
        const requestOptions = await this.getRunRequestOpts(requestParameters);
        const response = await this.request(requestOptions, initOverrides);

        return new runtime.JSONApiResponse(response, (jsonValue) => RunFromJSON(jsonValue));
    }

    /**
     * State, progress and the reason for both; can wait for a change
     */
    async getRun(requestParameters: GetRunRequest, initOverrides?: RequestInit | runtime.InitOverrideFunction): Promise<Run> {
        const response = await this.getRunRaw(requestParameters, initOverrides);
        return await response.value();
    }

    /**
     * Creates request options for getScore without sending the request
     */
    async getScoreRequestOpts(requestParameters: GetScoreRequest): Promise<runtime.RequestOpts> {
        if (requestParameters['runId'] == null) {
            throw new runtime.RequiredError(
                'runId',
                'Required parameter "runId" was null or undefined when calling getScore().'
            );
        }

        const queryParameters: any = {};

        const headerParameters: runtime.HTTPHeaders = {};

        if (requestParameters['proctorVersion'] != null) {
            headerParameters['Proctor-Version'] = String(requestParameters['proctorVersion']);
        }

        if (this.configuration && this.configuration.accessToken) {
            const token = this.configuration.accessToken;
            const tokenString = await token("bearer", []);

            if (tokenString) {
                headerParameters["Authorization"] = `Bearer ${tokenString}`;
            }
        }

        let urlPath = `/v1/runs/{run_id}/score`;
        urlPath = urlPath.replace('{run_id}', encodeURIComponent(String(requestParameters['runId'])));

        return {
            path: urlPath,
            method: 'GET',
            headers: headerParameters,
            query: queryParameters,
        };
    }

    /**
     * The score, or its bounds while episodes are missing
     */
    async getScoreRaw(requestParameters: GetScoreRequest, initOverrides?: RequestInit | runtime.InitOverrideFunction): Promise<runtime.ApiResponse<Score>> {
        const requestOptions = await this.getScoreRequestOpts(requestParameters);
        const response = await this.request(requestOptions, initOverrides);

        return new runtime.JSONApiResponse(response, (jsonValue) => ScoreFromJSON(jsonValue));
    }

    /**
     * The score, or its bounds while episodes are missing
     */
    async getScore(requestParameters: GetScoreRequest, initOverrides?: RequestInit | runtime.InitOverrideFunction): Promise<Score> {
        const response = await this.getScoreRaw(requestParameters, initOverrides);
        return await response.value();
    }

    /**
     * Creates request options for importRecord without sending the request
     */
    async importRecordRequestOpts(requestParameters: ImportRecordRequest): Promise<runtime.RequestOpts> {
        if (requestParameters['body'] == null) {
            throw new runtime.RequiredError(
                'body',
                'Required parameter "body" was null or undefined when calling importRecord().'
            );
        }

        const queryParameters: any = {};

        const headerParameters: runtime.HTTPHeaders = {};

        headerParameters['Content-Type'] = 'application/zip';

        if (requestParameters['proctorVersion'] != null) {
            headerParameters['Proctor-Version'] = String(requestParameters['proctorVersion']);
        }

        if (this.configuration && this.configuration.accessToken) {
            const token = this.configuration.accessToken;
            const tokenString = await token("bearer", []);

            if (tokenString) {
                headerParameters["Authorization"] = `Bearer ${tokenString}`;
            }
        }

        let urlPath = `/v1/records`;

        return {
            path: urlPath,
            method: 'POST',
            headers: headerParameters,
            query: queryParameters,
            body: requestParameters['body'] as any,
        };
    }

    /**
     * The body is the archive that record.md describes; it is verified before the answer, so what is broken is refused with the file and the rule (REC-113). Then it is replayed on this server, when its simulators are free: `get_import` shows how far that is, and the level of trust that the record has here. Offered with the profile `record_import`. The same bytes, sent again by the account, are the same import.
     * Hand in a record of any host, to be verified and replayed here
     */
    async importRecordRaw(requestParameters: ImportRecordRequest, initOverrides?: RequestInit | runtime.InitOverrideFunction): Promise<runtime.ApiResponse<RecordImport>> {
        const requestOptions = await this.importRecordRequestOpts(requestParameters);
        const response = await this.request(requestOptions, initOverrides);

        return new runtime.JSONApiResponse(response, (jsonValue) => RecordImportFromJSON(jsonValue));
    }

    /**
     * The body is the archive that record.md describes; it is verified before the answer, so what is broken is refused with the file and the rule (REC-113). Then it is replayed on this server, when its simulators are free: `get_import` shows how far that is, and the level of trust that the record has here. Offered with the profile `record_import`. The same bytes, sent again by the account, are the same import.
     * Hand in a record of any host, to be verified and replayed here
     */
    async importRecord(requestParameters: ImportRecordRequest, initOverrides?: RequestInit | runtime.InitOverrideFunction): Promise<RecordImport> {
        const response = await this.importRecordRaw(requestParameters, initOverrides);
        return await response.value();
    }

    /**
     * Creates request options for listBenchmarks without sending the request
     */
    async listBenchmarksRequestOpts(requestParameters: ListBenchmarksRequest): Promise<runtime.RequestOpts> {
        const queryParameters: any = {};

        const headerParameters: runtime.HTTPHeaders = {};

        if (requestParameters['proctorVersion'] != null) {
            headerParameters['Proctor-Version'] = String(requestParameters['proctorVersion']);
        }

        if (this.configuration && this.configuration.accessToken) {
            const token = this.configuration.accessToken;
            const tokenString = await token("bearer", []);

            if (tokenString) {
                headerParameters["Authorization"] = `Bearer ${tokenString}`;
            }
        }

        let urlPath = `/v1/benchmarks`;

        return {
            path: urlPath,
            method: 'GET',
            headers: headerParameters,
            query: queryParameters,
        };
    }

    /**
     * The benchmarks offered here
     */
    async listBenchmarksRaw(requestParameters: ListBenchmarksRequest, initOverrides?: RequestInit | runtime.InitOverrideFunction): Promise<runtime.ApiResponse<BenchmarkList>> {
        const requestOptions = await this.listBenchmarksRequestOpts(requestParameters);
        const response = await this.request(requestOptions, initOverrides);

        return new runtime.JSONApiResponse(response, (jsonValue) => BenchmarkListFromJSON(jsonValue));
    }

    /**
     * The benchmarks offered here
     */
    async listBenchmarks(requestParameters: ListBenchmarksRequest = {}, initOverrides?: RequestInit | runtime.InitOverrideFunction): Promise<BenchmarkList> {
        const response = await this.listBenchmarksRaw(requestParameters, initOverrides);
        return await response.value();
    }

    /**
     * Creates request options for listEntries without sending the request
     */
    async listEntriesRequestOpts(requestParameters: ListEntriesRequest): Promise<runtime.RequestOpts> {
        const queryParameters: any = {};

        if (requestParameters['benchmarkId'] != null) {
            queryParameters['benchmark_id'] = requestParameters['benchmarkId'];
        }

        if (requestParameters['cursor'] != null) {
            queryParameters['cursor'] = requestParameters['cursor'];
        }

        if (requestParameters['limit'] != null) {
            queryParameters['limit'] = requestParameters['limit'];
        }

        const headerParameters: runtime.HTTPHeaders = {};

        if (requestParameters['proctorVersion'] != null) {
            headerParameters['Proctor-Version'] = String(requestParameters['proctorVersion']);
        }

        if (this.configuration && this.configuration.accessToken) {
            const token = this.configuration.accessToken;
            const tokenString = await token("bearer", []);

            if (tokenString) {
                headerParameters["Authorization"] = `Bearer ${tokenString}`;
            }
        }

        let urlPath = `/v1/entries`;

        return {
            path: urlPath,
            method: 'GET',
            headers: headerParameters,
            query: queryParameters,
        };
    }

    /**
     * Public entries, and private ones of the account that asks; none that is withdrawn.
     * Entries of the leaderboard, newest first
     */
    async listEntriesRaw(requestParameters: ListEntriesRequest, initOverrides?: RequestInit | runtime.InitOverrideFunction): Promise<runtime.ApiResponse<BoardEntryList>> {
        const requestOptions = await this.listEntriesRequestOpts(requestParameters);
        const response = await this.request(requestOptions, initOverrides);

        return new runtime.JSONApiResponse(response, (jsonValue) => BoardEntryListFromJSON(jsonValue));
    }

    /**
     * Public entries, and private ones of the account that asks; none that is withdrawn.
     * Entries of the leaderboard, newest first
     */
    async listEntries(requestParameters: ListEntriesRequest = {}, initOverrides?: RequestInit | runtime.InitOverrideFunction): Promise<BoardEntryList> {
        const response = await this.listEntriesRaw(requestParameters, initOverrides);
        return await response.value();
    }

    /**
     * Creates request options for listEpisodes without sending the request
     */
    async listEpisodesRequestOpts(requestParameters: ListEpisodesRequest): Promise<runtime.RequestOpts> {
        if (requestParameters['runId'] == null) {
            throw new runtime.RequiredError(
                'runId',
                'Required parameter "runId" was null or undefined when calling listEpisodes().'
            );
        }

        const queryParameters: any = {};

        if (requestParameters['cursor'] != null) {
            queryParameters['cursor'] = requestParameters['cursor'];
        }

        if (requestParameters['limit'] != null) {
            queryParameters['limit'] = requestParameters['limit'];
        }

        const headerParameters: runtime.HTTPHeaders = {};

        if (requestParameters['proctorVersion'] != null) {
            headerParameters['Proctor-Version'] = String(requestParameters['proctorVersion']);
        }

        if (this.configuration && this.configuration.accessToken) {
            const token = this.configuration.accessToken;
            const tokenString = await token("bearer", []);

            if (tokenString) {
                headerParameters["Authorization"] = `Bearer ${tokenString}`;
            }
        }

        let urlPath = `/v1/runs/{run_id}/episodes`;
        urlPath = urlPath.replace('{run_id}', encodeURIComponent(String(requestParameters['runId'])));

        return {
            path: urlPath,
            method: 'GET',
            headers: headerParameters,
            query: queryParameters,
        };
    }

    /**
     * Every episode with its result so far, in manifest order
     */
    async listEpisodesRaw(requestParameters: ListEpisodesRequest, initOverrides?: RequestInit | runtime.InitOverrideFunction): Promise<runtime.ApiResponse<EpisodeList>> {
        const requestOptions = await this.listEpisodesRequestOpts(requestParameters);
        const response = await this.request(requestOptions, initOverrides);

        return new runtime.JSONApiResponse(response, (jsonValue) => EpisodeListFromJSON(jsonValue));
    }

    /**
     * Every episode with its result so far, in manifest order
     */
    async listEpisodes(requestParameters: ListEpisodesRequest, initOverrides?: RequestInit | runtime.InitOverrideFunction): Promise<EpisodeList> {
        const response = await this.listEpisodesRaw(requestParameters, initOverrides);
        return await response.value();
    }

    /**
     * Creates request options for listHistory without sending the request
     */
    async listHistoryRequestOpts(requestParameters: ListHistoryRequest): Promise<runtime.RequestOpts> {
        const queryParameters: any = {};

        if (requestParameters['cursor'] != null) {
            queryParameters['cursor'] = requestParameters['cursor'];
        }

        if (requestParameters['limit'] != null) {
            queryParameters['limit'] = requestParameters['limit'];
        }

        const headerParameters: runtime.HTTPHeaders = {};

        if (requestParameters['proctorVersion'] != null) {
            headerParameters['Proctor-Version'] = String(requestParameters['proctorVersion']);
        }

        if (this.configuration && this.configuration.accessToken) {
            const token = this.configuration.accessToken;
            const tokenString = await token("bearer", []);

            if (tokenString) {
                headerParameters["Authorization"] = `Bearer ${tokenString}`;
            }
        }

        let urlPath = `/v1/history`;

        return {
            path: urlPath,
            method: 'GET',
            headers: headerParameters,
            query: queryParameters,
        };
    }

    /**
     * The leaves of the tree of board.md. No leaf is ever changed or taken out.
     * What happened to public entries, oldest first
     */
    async listHistoryRaw(requestParameters: ListHistoryRequest, initOverrides?: RequestInit | runtime.InitOverrideFunction): Promise<runtime.ApiResponse<HistoryPage>> {
        const requestOptions = await this.listHistoryRequestOpts(requestParameters);
        const response = await this.request(requestOptions, initOverrides);

        return new runtime.JSONApiResponse(response, (jsonValue) => HistoryPageFromJSON(jsonValue));
    }

    /**
     * The leaves of the tree of board.md. No leaf is ever changed or taken out.
     * What happened to public entries, oldest first
     */
    async listHistory(requestParameters: ListHistoryRequest = {}, initOverrides?: RequestInit | runtime.InitOverrideFunction): Promise<HistoryPage> {
        const response = await this.listHistoryRaw(requestParameters, initOverrides);
        return await response.value();
    }

    /**
     * Creates request options for listImports without sending the request
     */
    async listImportsRequestOpts(requestParameters: ListImportsRequest): Promise<runtime.RequestOpts> {
        const queryParameters: any = {};

        if (requestParameters['cursor'] != null) {
            queryParameters['cursor'] = requestParameters['cursor'];
        }

        if (requestParameters['limit'] != null) {
            queryParameters['limit'] = requestParameters['limit'];
        }

        const headerParameters: runtime.HTTPHeaders = {};

        if (requestParameters['proctorVersion'] != null) {
            headerParameters['Proctor-Version'] = String(requestParameters['proctorVersion']);
        }

        if (this.configuration && this.configuration.accessToken) {
            const token = this.configuration.accessToken;
            const tokenString = await token("bearer", []);

            if (tokenString) {
                headerParameters["Authorization"] = `Bearer ${tokenString}`;
            }
        }

        let urlPath = `/v1/records`;

        return {
            path: urlPath,
            method: 'GET',
            headers: headerParameters,
            query: queryParameters,
        };
    }

    /**
     * Offered with the profile `record_import`.
     * The records that the account handed in, newest first
     */
    async listImportsRaw(requestParameters: ListImportsRequest, initOverrides?: RequestInit | runtime.InitOverrideFunction): Promise<runtime.ApiResponse<RecordImportList>> {
        const requestOptions = await this.listImportsRequestOpts(requestParameters);
        const response = await this.request(requestOptions, initOverrides);

        return new runtime.JSONApiResponse(response, (jsonValue) => RecordImportListFromJSON(jsonValue));
    }

    /**
     * Offered with the profile `record_import`.
     * The records that the account handed in, newest first
     */
    async listImports(requestParameters: ListImportsRequest = {}, initOverrides?: RequestInit | runtime.InitOverrideFunction): Promise<RecordImportList> {
        const response = await this.listImportsRaw(requestParameters, initOverrides);
        return await response.value();
    }

    /**
     * Creates request options for listKeys without sending the request
     */
    async listKeysRequestOpts(requestParameters: ListKeysRequest): Promise<runtime.RequestOpts> {
        const queryParameters: any = {};

        const headerParameters: runtime.HTTPHeaders = {};

        if (requestParameters['proctorVersion'] != null) {
            headerParameters['Proctor-Version'] = String(requestParameters['proctorVersion']);
        }


        let urlPath = `/v1/keys`;

        return {
            path: urlPath,
            method: 'GET',
            headers: headerParameters,
            query: queryParameters,
        };
    }

    /**
     * Offered with the profile `record`. Needs no token, as checking a record needs none.
     * The public keys with which this host signs records
     */
    async listKeysRaw(requestParameters: ListKeysRequest, initOverrides?: RequestInit | runtime.InitOverrideFunction): Promise<runtime.ApiResponse<KeyList>> {
        const requestOptions = await this.listKeysRequestOpts(requestParameters);
        const response = await this.request(requestOptions, initOverrides);

        return new runtime.JSONApiResponse(response, (jsonValue) => KeyListFromJSON(jsonValue));
    }

    /**
     * Offered with the profile `record`. Needs no token, as checking a record needs none.
     * The public keys with which this host signs records
     */
    async listKeys(requestParameters: ListKeysRequest = {}, initOverrides?: RequestInit | runtime.InitOverrideFunction): Promise<KeyList> {
        const response = await this.listKeysRaw(requestParameters, initOverrides);
        return await response.value();
    }

    /**
     * Creates request options for listRuns without sending the request
     */
    async listRunsRequestOpts(requestParameters: ListRunsRequest): Promise<runtime.RequestOpts> {
        const queryParameters: any = {};

        if (requestParameters['cursor'] != null) {
            queryParameters['cursor'] = requestParameters['cursor'];
        }

        if (requestParameters['limit'] != null) {
            queryParameters['limit'] = requestParameters['limit'];
        }

        const headerParameters: runtime.HTTPHeaders = {};

        if (requestParameters['proctorVersion'] != null) {
            headerParameters['Proctor-Version'] = String(requestParameters['proctorVersion']);
        }

        if (this.configuration && this.configuration.accessToken) {
            const token = this.configuration.accessToken;
            const tokenString = await token("bearer", []);

            if (tokenString) {
                headerParameters["Authorization"] = `Bearer ${tokenString}`;
            }
        }

        let urlPath = `/v1/runs`;

        return {
            path: urlPath,
            method: 'GET',
            headers: headerParameters,
            query: queryParameters,
        };
    }

    /**
     * The caller\'s runs, newest first
     */
    async listRunsRaw(requestParameters: ListRunsRequest, initOverrides?: RequestInit | runtime.InitOverrideFunction): Promise<runtime.ApiResponse<RunList>> {
        const requestOptions = await this.listRunsRequestOpts(requestParameters);
        const response = await this.request(requestOptions, initOverrides);

        return new runtime.JSONApiResponse(response, (jsonValue) => RunListFromJSON(jsonValue));
    }

    /**
     * The caller\'s runs, newest first
     */
    async listRuns(requestParameters: ListRunsRequest = {}, initOverrides?: RequestInit | runtime.InitOverrideFunction): Promise<RunList> {
        const response = await this.listRunsRaw(requestParameters, initOverrides);
        return await response.value();
    }

    /**
     * Creates request options for proveConsistency without sending the request
     */
    async proveConsistencyRequestOpts(requestParameters: ProveConsistencyRequest): Promise<runtime.RequestOpts> {
        if (requestParameters['oldSize'] == null) {
            throw new runtime.RequiredError(
                'oldSize',
                'Required parameter "oldSize" was null or undefined when calling proveConsistency().'
            );
        }

        if (requestParameters['newSize'] == null) {
            throw new runtime.RequiredError(
                'newSize',
                'Required parameter "newSize" was null or undefined when calling proveConsistency().'
            );
        }

        const queryParameters: any = {};

        if (requestParameters['oldSize'] != null) {
            queryParameters['old_size'] = requestParameters['oldSize'];
        }

        if (requestParameters['newSize'] != null) {
            queryParameters['new_size'] = requestParameters['newSize'];
        }

        const headerParameters: runtime.HTTPHeaders = {};

        if (requestParameters['proctorVersion'] != null) {
            headerParameters['Proctor-Version'] = String(requestParameters['proctorVersion']);
        }

        if (this.configuration && this.configuration.accessToken) {
            const token = this.configuration.accessToken;
            const tokenString = await token("bearer", []);

            if (tokenString) {
                headerParameters["Authorization"] = `Bearer ${tokenString}`;
            }
        }

        let urlPath = `/v1/history/consistency`;

        return {
            path: urlPath,
            method: 'GET',
            headers: headerParameters,
            query: queryParameters,
        };
    }

    /**
     * For sizes up to that of the checkpoint, the old one at least 1 and at most the new one.
     * Proof that a history of one size begins with that of another
     */
    async proveConsistencyRaw(requestParameters: ProveConsistencyRequest, initOverrides?: RequestInit | runtime.InitOverrideFunction): Promise<runtime.ApiResponse<ConsistencyProof>> {
        const requestOptions = await this.proveConsistencyRequestOpts(requestParameters);
        const response = await this.request(requestOptions, initOverrides);

        return new runtime.JSONApiResponse(response, (jsonValue) => ConsistencyProofFromJSON(jsonValue));
    }

    /**
     * For sizes up to that of the checkpoint, the old one at least 1 and at most the new one.
     * Proof that a history of one size begins with that of another
     */
    async proveConsistency(requestParameters: ProveConsistencyRequest, initOverrides?: RequestInit | runtime.InitOverrideFunction): Promise<ConsistencyProof> {
        const response = await this.proveConsistencyRaw(requestParameters, initOverrides);
        return await response.value();
    }

    /**
     * Creates request options for proveInclusion without sending the request
     */
    async proveInclusionRequestOpts(requestParameters: ProveInclusionRequest): Promise<runtime.RequestOpts> {
        if (requestParameters['leafIndex'] == null) {
            throw new runtime.RequiredError(
                'leafIndex',
                'Required parameter "leafIndex" was null or undefined when calling proveInclusion().'
            );
        }

        if (requestParameters['treeSize'] == null) {
            throw new runtime.RequiredError(
                'treeSize',
                'Required parameter "treeSize" was null or undefined when calling proveInclusion().'
            );
        }

        const queryParameters: any = {};

        if (requestParameters['leafIndex'] != null) {
            queryParameters['leaf_index'] = requestParameters['leafIndex'];
        }

        if (requestParameters['treeSize'] != null) {
            queryParameters['tree_size'] = requestParameters['treeSize'];
        }

        const headerParameters: runtime.HTTPHeaders = {};

        if (requestParameters['proctorVersion'] != null) {
            headerParameters['Proctor-Version'] = String(requestParameters['proctorVersion']);
        }

        if (this.configuration && this.configuration.accessToken) {
            const token = this.configuration.accessToken;
            const tokenString = await token("bearer", []);

            if (tokenString) {
                headerParameters["Authorization"] = `Bearer ${tokenString}`;
            }
        }

        let urlPath = `/v1/history/inclusion`;

        return {
            path: urlPath,
            method: 'GET',
            headers: headerParameters,
            query: queryParameters,
        };
    }

    /**
     * For a size up to that of the checkpoint and a leaf below it.
     * Proof that a leaf stands in the history of a size
     */
    async proveInclusionRaw(requestParameters: ProveInclusionRequest, initOverrides?: RequestInit | runtime.InitOverrideFunction): Promise<runtime.ApiResponse<InclusionProof>> {
        const requestOptions = await this.proveInclusionRequestOpts(requestParameters);
        const response = await this.request(requestOptions, initOverrides);

        return new runtime.JSONApiResponse(response, (jsonValue) => InclusionProofFromJSON(jsonValue));
    }

    /**
     * For a size up to that of the checkpoint and a leaf below it.
     * Proof that a leaf stands in the history of a size
     */
    async proveInclusion(requestParameters: ProveInclusionRequest, initOverrides?: RequestInit | runtime.InitOverrideFunction): Promise<InclusionProof> {
        const response = await this.proveInclusionRaw(requestParameters, initOverrides);
        return await response.value();
    }

    /**
     * Creates request options for publishEntry without sending the request
     */
    async publishEntryRequestOpts(requestParameters: PublishEntryRequest): Promise<runtime.RequestOpts> {
        if (requestParameters['runId'] == null) {
            throw new runtime.RequiredError(
                'runId',
                'Required parameter "runId" was null or undefined when calling publishEntry().'
            );
        }

        if (requestParameters['publishEntry'] == null) {
            throw new runtime.RequiredError(
                'publishEntry',
                'Required parameter "publishEntry" was null or undefined when calling publishEntry().'
            );
        }

        const queryParameters: any = {};

        const headerParameters: runtime.HTTPHeaders = {};

        headerParameters['Content-Type'] = 'application/json';

        if (requestParameters['proctorVersion'] != null) {
            headerParameters['Proctor-Version'] = String(requestParameters['proctorVersion']);
        }

        if (this.configuration && this.configuration.accessToken) {
            const token = this.configuration.accessToken;
            const tokenString = await token("bearer", []);

            if (tokenString) {
                headerParameters["Authorization"] = `Bearer ${tokenString}`;
            }
        }

        let urlPath = `/v1/runs/{run_id}/entry`;
        urlPath = urlPath.replace('{run_id}', encodeURIComponent(String(requestParameters['runId'])));

        return {
            path: urlPath,
            method: 'PUT',
            headers: headerParameters,
            query: queryParameters,
            body: PublishEntryToJSON(requestParameters['publishEntry']),
        };
    }

    /**
     * A run has one entry. A repeat with the same body changes nothing; with another body it replaces the description, which has the defaults for what is left out. The score follows from the run and never changes. How often is bounded (BRD-001). Offered with the profile `board`, as are the operations on entries, rankings and history.
     * Publish a completed run on the leaderboard, or change what its entry says
     */
    async publishEntryRaw(requestParameters: PublishEntryRequest, initOverrides?: RequestInit | runtime.InitOverrideFunction): Promise<runtime.ApiResponse<BoardEntry>> {
        const requestOptions = await this.publishEntryRequestOpts(requestParameters);
        const response = await this.request(requestOptions, initOverrides);

        return new runtime.JSONApiResponse(response, (jsonValue) => BoardEntryFromJSON(jsonValue));
    }

    /**
     * A run has one entry. A repeat with the same body changes nothing; with another body it replaces the description, which has the defaults for what is left out. The score follows from the run and never changes. How often is bounded (BRD-001). Offered with the profile `board`, as are the operations on entries, rankings and history.
     * Publish a completed run on the leaderboard, or change what its entry says
     */
    async publishEntry(requestParameters: PublishEntryRequest, initOverrides?: RequestInit | runtime.InitOverrideFunction): Promise<BoardEntry> {
        const response = await this.publishEntryRaw(requestParameters, initOverrides);
        return await response.value();
    }

    /**
     * Creates request options for resumeRun without sending the request
     */
    async resumeRunRequestOpts(requestParameters: ResumeRunRequest): Promise<runtime.RequestOpts> {
        if (requestParameters['runId'] == null) {
            throw new runtime.RequiredError(
                'runId',
                'Required parameter "runId" was null or undefined when calling resumeRun().'
            );
        }

        const queryParameters: any = {};

        const headerParameters: runtime.HTTPHeaders = {};

        if (requestParameters['proctorVersion'] != null) {
            headerParameters['Proctor-Version'] = String(requestParameters['proctorVersion']);
        }

        if (this.configuration && this.configuration.accessToken) {
            const token = this.configuration.accessToken;
            const tokenString = await token("bearer", []);

            if (tokenString) {
                headerParameters["Authorization"] = `Bearer ${tokenString}`;
            }
        }

        let urlPath = `/v1/runs/{run_id}/resume`;
        urlPath = urlPath.replace('{run_id}', encodeURIComponent(String(requestParameters['runId'])));

        return {
            path: urlPath,
            method: 'POST',
            headers: headerParameters,
            query: queryParameters,
        };
    }

    /**
     * Go on with the episodes that have no score yet
     */
    async resumeRunRaw(requestParameters: ResumeRunRequest, initOverrides?: RequestInit | runtime.InitOverrideFunction): Promise<runtime.ApiResponse<Run>> {
        const requestOptions = await this.resumeRunRequestOpts(requestParameters);
        const response = await this.request(requestOptions, initOverrides);

        return new runtime.JSONApiResponse(response, (jsonValue) => RunFromJSON(jsonValue));
    }

    /**
     * Go on with the episodes that have no score yet
     */
    async resumeRun(requestParameters: ResumeRunRequest, initOverrides?: RequestInit | runtime.InitOverrideFunction): Promise<Run> {
        const response = await this.resumeRunRaw(requestParameters, initOverrides);
        return await response.value();
    }

    /**
     * Creates request options for stopRun without sending the request
     */
    async stopRunRequestOpts(requestParameters: StopRunRequest): Promise<runtime.RequestOpts> {
        if (requestParameters['runId'] == null) {
            throw new runtime.RequiredError(
                'runId',
                'Required parameter "runId" was null or undefined when calling stopRun().'
            );
        }

        if (requestParameters['stopRun'] == null) {
            throw new runtime.RequiredError(
                'stopRun',
                'Required parameter "stopRun" was null or undefined when calling stopRun().'
            );
        }

        const queryParameters: any = {};

        const headerParameters: runtime.HTTPHeaders = {};

        headerParameters['Content-Type'] = 'application/json';

        if (requestParameters['proctorVersion'] != null) {
            headerParameters['Proctor-Version'] = String(requestParameters['proctorVersion']);
        }

        if (this.configuration && this.configuration.accessToken) {
            const token = this.configuration.accessToken;
            const tokenString = await token("bearer", []);

            if (tokenString) {
                headerParameters["Authorization"] = `Bearer ${tokenString}`;
            }
        }

        let urlPath = `/v1/runs/{run_id}/stop`;
        urlPath = urlPath.replace('{run_id}', encodeURIComponent(String(requestParameters['runId'])));

        return {
            path: urlPath,
            method: 'POST',
            headers: headerParameters,
            query: queryParameters,
            body: StopRunToJSON(requestParameters['stopRun']),
        };
    }

    /**
     * Stop now (abort) or after the episodes in play (drain)
     */
    async stopRunRaw(requestParameters: StopRunRequest, initOverrides?: RequestInit | runtime.InitOverrideFunction): Promise<runtime.ApiResponse<Run>> {
        const requestOptions = await this.stopRunRequestOpts(requestParameters);
        const response = await this.request(requestOptions, initOverrides);

        return new runtime.JSONApiResponse(response, (jsonValue) => RunFromJSON(jsonValue));
    }

    /**
     * Stop now (abort) or after the episodes in play (drain)
     */
    async stopRun(requestParameters: StopRunRequest, initOverrides?: RequestInit | runtime.InitOverrideFunction): Promise<Run> {
        const response = await this.stopRunRaw(requestParameters, initOverrides);
        return await response.value();
    }

    /**
     * Creates request options for submitRun without sending the request
     */
    async submitRunRequestOpts(requestParameters: SubmitRunRequest): Promise<runtime.RequestOpts> {
        if (requestParameters['submitRun'] == null) {
            throw new runtime.RequiredError(
                'submitRun',
                'Required parameter "submitRun" was null or undefined when calling submitRun().'
            );
        }

        const queryParameters: any = {};

        const headerParameters: runtime.HTTPHeaders = {};

        headerParameters['Content-Type'] = 'application/json';

        if (requestParameters['idempotencyKey'] != null) {
            headerParameters['Idempotency-Key'] = String(requestParameters['idempotencyKey']);
        }

        if (requestParameters['proctorVersion'] != null) {
            headerParameters['Proctor-Version'] = String(requestParameters['proctorVersion']);
        }

        if (this.configuration && this.configuration.accessToken) {
            const token = this.configuration.accessToken;
            const tokenString = await token("bearer", []);

            if (tokenString) {
                headerParameters["Authorization"] = `Bearer ${tokenString}`;
            }
        }

        let urlPath = `/v1/runs`;

        return {
            path: urlPath,
            method: 'POST',
            headers: headerParameters,
            query: queryParameters,
            body: SubmitRunToJSON(requestParameters['submitRun']),
        };
    }

    /**
     * Ask for one evaluation of one policy on one benchmark
     */
    async submitRunRaw(requestParameters: SubmitRunRequest, initOverrides?: RequestInit | runtime.InitOverrideFunction): Promise<runtime.ApiResponse<Run>> {
        const requestOptions = await this.submitRunRequestOpts(requestParameters);
        const response = await this.request(requestOptions, initOverrides);

        return new runtime.JSONApiResponse(response, (jsonValue) => RunFromJSON(jsonValue));
    }

    /**
     * Ask for one evaluation of one policy on one benchmark
     */
    async submitRun(requestParameters: SubmitRunRequest, initOverrides?: RequestInit | runtime.InitOverrideFunction): Promise<Run> {
        const response = await this.submitRunRaw(requestParameters, initOverrides);
        return await response.value();
    }

    /**
     * Creates request options for withdrawEntry without sending the request
     */
    async withdrawEntryRequestOpts(requestParameters: WithdrawEntryRequest): Promise<runtime.RequestOpts> {
        if (requestParameters['runId'] == null) {
            throw new runtime.RequiredError(
                'runId',
                'Required parameter "runId" was null or undefined when calling withdrawEntry().'
            );
        }

        const queryParameters: any = {};

        const headerParameters: runtime.HTTPHeaders = {};

        if (requestParameters['proctorVersion'] != null) {
            headerParameters['Proctor-Version'] = String(requestParameters['proctorVersion']);
        }

        if (this.configuration && this.configuration.accessToken) {
            const token = this.configuration.accessToken;
            const tokenString = await token("bearer", []);

            if (tokenString) {
                headerParameters["Authorization"] = `Bearer ${tokenString}`;
            }
        }

        let urlPath = `/v1/runs/{run_id}/entry`;
        urlPath = urlPath.replace('{run_id}', encodeURIComponent(String(requestParameters['runId'])));

        return {
            path: urlPath,
            method: 'DELETE',
            headers: headerParameters,
            query: queryParameters,
        };
    }

    /**
     * A withdrawn entry has no rank and is in no list; `get_entry` and the history go on to show it. A repeat changes nothing.
     * Take the entry of a run off the leaderboard, for good
     */
    async withdrawEntryRaw(requestParameters: WithdrawEntryRequest, initOverrides?: RequestInit | runtime.InitOverrideFunction): Promise<runtime.ApiResponse<BoardEntry>> {
        const requestOptions = await this.withdrawEntryRequestOpts(requestParameters);
        const response = await this.request(requestOptions, initOverrides);

        return new runtime.JSONApiResponse(response, (jsonValue) => BoardEntryFromJSON(jsonValue));
    }

    /**
     * A withdrawn entry has no rank and is in no list; `get_entry` and the history go on to show it. A repeat changes nothing.
     * Take the entry of a run off the leaderboard, for good
     */
    async withdrawEntry(requestParameters: WithdrawEntryRequest, initOverrides?: RequestInit | runtime.InitOverrideFunction): Promise<BoardEntry> {
        const response = await this.withdrawEntryRaw(requestParameters, initOverrides);
        return await response.value();
    }

}
