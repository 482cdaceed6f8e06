/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */


using System;
using System.Collections.Generic;
using System.Collections.ObjectModel;
using System.Linq;
using System.Net;
using System.Net.Http;
using System.Net.Mime;
using Proctor.Client.Client;
using Proctor.Client.Model;

namespace Proctor.Client.Api
{

    /// <summary>
    /// Represents a collection of functions to interact with the API endpoints
    /// </summary>
    public interface IControlApiSync : IApiAccessor
    {
        #region Synchronous Operations
        /// <summary>
        /// Runs beside a baseline, episode by episode
        /// </summary>
        /// <remarks>
        /// Pairs the episodes of runs of one manifest. Offered with the profile &#x60;compare&#x60;; scoring.md has the arithmetic.
        /// </remarks>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="baseline">The run that the others are compared with.</param>
        /// <param name="runs">Ids of one to sixteen runs, with commas between them; the baseline may be one of them.</param>
        /// <param name="tolerance">The largest difference that &#x60;release&#x60; lets pass; 0.05 when absent. (optional)</param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <returns>Comparison</returns>
        Comparison CompareRuns(string baseline, string runs, double? tolerance = default, string? proctorVersion = default);

        /// <summary>
        /// Runs beside a baseline, episode by episode
        /// </summary>
        /// <remarks>
        /// Pairs the episodes of runs of one manifest. Offered with the profile &#x60;compare&#x60;; scoring.md has the arithmetic.
        /// </remarks>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="baseline">The run that the others are compared with.</param>
        /// <param name="runs">Ids of one to sixteen runs, with commas between them; the baseline may be one of them.</param>
        /// <param name="tolerance">The largest difference that &#x60;release&#x60; lets pass; 0.05 when absent. (optional)</param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <returns>ApiResponse of Comparison</returns>
        ApiResponse<Comparison> CompareRunsWithHttpInfo(string baseline, string runs, double? tolerance = default, string? proctorVersion = default);
        /// <summary>
        /// What this server is, speaks and allows
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <returns>Service</returns>
        Service DescribeService(string? proctorVersion = default);

        /// <summary>
        /// What this server is, speaks and allows
        /// </summary>
        /// <remarks>
        ///
        /// </remarks>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <returns>ApiResponse of Service</returns>
        ApiResponse<Service> DescribeServiceWithHttpInfo(string? proctorVersion = default);
        /// <summary>
        /// One benchmark with its spaces, conventions and rules
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="benchmarkId"></param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <returns>Benchmark</returns>
        Benchmark GetBenchmark(string benchmarkId, string? proctorVersion = default);

        /// <summary>
        /// One benchmark with its spaces, conventions and rules
        /// </summary>
        /// <remarks>
        ///
        /// </remarks>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="benchmarkId"></param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <returns>ApiResponse of Benchmark</returns>
        ApiResponse<Benchmark> GetBenchmarkWithHttpInfo(string benchmarkId, string? proctorVersion = default);
        /// <summary>
        /// State, progress and the reason for both; can wait for a change
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="ifNoneMatch">The ETag of the last answer, a list of some, or &#x60;*&#x60;; while one of them holds, the answer is 304. A text that is no ETag names none. (optional)</param>
        /// <param name="prefer">&#x60;wait&#x3D;N&#x60; holds the answer back for up to N seconds until the ETag in If-None-Match no longer holds. Longer than &#x60;limits.wait_s_max&#x60; is granted as that; without If-None-Match nothing is waited for. Any other value is refused with &#x60;invalid_request&#x60;. (optional)</param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <returns>Run</returns>
        Run GetRun(string runId, string? ifNoneMatch = default, string? prefer = default, string? proctorVersion = default);

        /// <summary>
        /// State, progress and the reason for both; can wait for a change
        /// </summary>
        /// <remarks>
        ///
        /// </remarks>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="ifNoneMatch">The ETag of the last answer, a list of some, or &#x60;*&#x60;; while one of them holds, the answer is 304. A text that is no ETag names none. (optional)</param>
        /// <param name="prefer">&#x60;wait&#x3D;N&#x60; holds the answer back for up to N seconds until the ETag in If-None-Match no longer holds. Longer than &#x60;limits.wait_s_max&#x60; is granted as that; without If-None-Match nothing is waited for. Any other value is refused with &#x60;invalid_request&#x60;. (optional)</param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <returns>ApiResponse of Run</returns>
        ApiResponse<Run> GetRunWithHttpInfo(string runId, string? ifNoneMatch = default, string? prefer = default, string? proctorVersion = default);
        /// <summary>
        /// The score, or its bounds while episodes are missing
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <returns>Score</returns>
        Score GetScore(string runId, string? proctorVersion = default);

        /// <summary>
        /// The score, or its bounds while episodes are missing
        /// </summary>
        /// <remarks>
        ///
        /// </remarks>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <returns>ApiResponse of Score</returns>
        ApiResponse<Score> GetScoreWithHttpInfo(string runId, string? proctorVersion = default);
        /// <summary>
        /// The benchmarks offered here
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <returns>BenchmarkList</returns>
        BenchmarkList ListBenchmarks(string? proctorVersion = default);

        /// <summary>
        /// The benchmarks offered here
        /// </summary>
        /// <remarks>
        ///
        /// </remarks>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <returns>ApiResponse of BenchmarkList</returns>
        ApiResponse<BenchmarkList> ListBenchmarksWithHttpInfo(string? proctorVersion = default);
        /// <summary>
        /// Every episode with its result so far, in manifest order
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="cursor">&#x60;next_cursor&#x60; of the page before; opaque to the caller. (optional)</param>
        /// <param name="limit">Most items wanted on a page; 100 when absent. (optional)</param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <returns>EpisodeList</returns>
        EpisodeList ListEpisodes(string runId, string? cursor = default, int? limit = default, string? proctorVersion = default);

        /// <summary>
        /// Every episode with its result so far, in manifest order
        /// </summary>
        /// <remarks>
        ///
        /// </remarks>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="cursor">&#x60;next_cursor&#x60; of the page before; opaque to the caller. (optional)</param>
        /// <param name="limit">Most items wanted on a page; 100 when absent. (optional)</param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <returns>ApiResponse of EpisodeList</returns>
        ApiResponse<EpisodeList> ListEpisodesWithHttpInfo(string runId, string? cursor = default, int? limit = default, string? proctorVersion = default);
        /// <summary>
        /// The caller&#39;s runs, newest first
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="cursor">&#x60;next_cursor&#x60; of the page before; opaque to the caller. (optional)</param>
        /// <param name="limit">Most items wanted on a page; 100 when absent. (optional)</param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <returns>RunList</returns>
        RunList ListRuns(string? cursor = default, int? limit = default, string? proctorVersion = default);

        /// <summary>
        /// The caller&#39;s runs, newest first
        /// </summary>
        /// <remarks>
        ///
        /// </remarks>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="cursor">&#x60;next_cursor&#x60; of the page before; opaque to the caller. (optional)</param>
        /// <param name="limit">Most items wanted on a page; 100 when absent. (optional)</param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <returns>ApiResponse of RunList</returns>
        ApiResponse<RunList> ListRunsWithHttpInfo(string? cursor = default, int? limit = default, string? proctorVersion = default);
        /// <summary>
        /// Go on with the episodes that have no score yet
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <returns>Run</returns>
        Run ResumeRun(string runId, string? proctorVersion = default);

        /// <summary>
        /// Go on with the episodes that have no score yet
        /// </summary>
        /// <remarks>
        ///
        /// </remarks>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <returns>ApiResponse of Run</returns>
        ApiResponse<Run> ResumeRunWithHttpInfo(string runId, string? proctorVersion = default);
        /// <summary>
        /// Stop now (abort) or after the episodes in play (drain)
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="stopRun"></param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <returns>Run</returns>
        Run StopRun(string runId, StopRun stopRun, string? proctorVersion = default);

        /// <summary>
        /// Stop now (abort) or after the episodes in play (drain)
        /// </summary>
        /// <remarks>
        ///
        /// </remarks>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="stopRun"></param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <returns>ApiResponse of Run</returns>
        ApiResponse<Run> StopRunWithHttpInfo(string runId, StopRun stopRun, string? proctorVersion = default);
        /// <summary>
        /// Ask for one evaluation of one policy on one benchmark
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="submitRun"></param>
        /// <param name="idempotencyKey">Makes a repeated submit return the first run instead of making another. One that breaks the pattern is refused with &#x60;invalid_request&#x60;. (optional)</param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <returns>Run</returns>
        Run SubmitRun(SubmitRun submitRun, string? idempotencyKey = default, string? proctorVersion = default);

        /// <summary>
        /// Ask for one evaluation of one policy on one benchmark
        /// </summary>
        /// <remarks>
        ///
        /// </remarks>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="submitRun"></param>
        /// <param name="idempotencyKey">Makes a repeated submit return the first run instead of making another. One that breaks the pattern is refused with &#x60;invalid_request&#x60;. (optional)</param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <returns>ApiResponse of Run</returns>
        ApiResponse<Run> SubmitRunWithHttpInfo(SubmitRun submitRun, string? idempotencyKey = default, string? proctorVersion = default);
        #endregion Synchronous Operations
    }

    /// <summary>
    /// Represents a collection of functions to interact with the API endpoints
    /// </summary>
    public interface IControlApiAsync : IApiAccessor
    {
        #region Asynchronous Operations
        /// <summary>
        /// Runs beside a baseline, episode by episode
        /// </summary>
        /// <remarks>
        /// Pairs the episodes of runs of one manifest. Offered with the profile &#x60;compare&#x60;; scoring.md has the arithmetic.
        /// </remarks>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="baseline">The run that the others are compared with.</param>
        /// <param name="runs">Ids of one to sixteen runs, with commas between them; the baseline may be one of them.</param>
        /// <param name="tolerance">The largest difference that &#x60;release&#x60; lets pass; 0.05 when absent. (optional)</param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <param name="cancellationToken">Cancellation Token to cancel the request.</param>
        /// <returns>Task of Comparison</returns>
        System.Threading.Tasks.Task<Comparison> CompareRunsAsync(string baseline, string runs, double? tolerance = default, string? proctorVersion = default, System.Threading.CancellationToken cancellationToken = default);

        /// <summary>
        /// Runs beside a baseline, episode by episode
        /// </summary>
        /// <remarks>
        /// Pairs the episodes of runs of one manifest. Offered with the profile &#x60;compare&#x60;; scoring.md has the arithmetic.
        /// </remarks>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="baseline">The run that the others are compared with.</param>
        /// <param name="runs">Ids of one to sixteen runs, with commas between them; the baseline may be one of them.</param>
        /// <param name="tolerance">The largest difference that &#x60;release&#x60; lets pass; 0.05 when absent. (optional)</param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <param name="cancellationToken">Cancellation Token to cancel the request.</param>
        /// <returns>Task of ApiResponse (Comparison)</returns>
        System.Threading.Tasks.Task<ApiResponse<Comparison>> CompareRunsWithHttpInfoAsync(string baseline, string runs, double? tolerance = default, string? proctorVersion = default, System.Threading.CancellationToken cancellationToken = default);
        /// <summary>
        /// What this server is, speaks and allows
        /// </summary>
        /// <remarks>
        ///
        /// </remarks>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <param name="cancellationToken">Cancellation Token to cancel the request.</param>
        /// <returns>Task of Service</returns>
        System.Threading.Tasks.Task<Service> DescribeServiceAsync(string? proctorVersion = default, System.Threading.CancellationToken cancellationToken = default);

        /// <summary>
        /// What this server is, speaks and allows
        /// </summary>
        /// <remarks>
        ///
        /// </remarks>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <param name="cancellationToken">Cancellation Token to cancel the request.</param>
        /// <returns>Task of ApiResponse (Service)</returns>
        System.Threading.Tasks.Task<ApiResponse<Service>> DescribeServiceWithHttpInfoAsync(string? proctorVersion = default, System.Threading.CancellationToken cancellationToken = default);
        /// <summary>
        /// One benchmark with its spaces, conventions and rules
        /// </summary>
        /// <remarks>
        ///
        /// </remarks>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="benchmarkId"></param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <param name="cancellationToken">Cancellation Token to cancel the request.</param>
        /// <returns>Task of Benchmark</returns>
        System.Threading.Tasks.Task<Benchmark> GetBenchmarkAsync(string benchmarkId, string? proctorVersion = default, System.Threading.CancellationToken cancellationToken = default);

        /// <summary>
        /// One benchmark with its spaces, conventions and rules
        /// </summary>
        /// <remarks>
        ///
        /// </remarks>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="benchmarkId"></param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <param name="cancellationToken">Cancellation Token to cancel the request.</param>
        /// <returns>Task of ApiResponse (Benchmark)</returns>
        System.Threading.Tasks.Task<ApiResponse<Benchmark>> GetBenchmarkWithHttpInfoAsync(string benchmarkId, string? proctorVersion = default, System.Threading.CancellationToken cancellationToken = default);
        /// <summary>
        /// State, progress and the reason for both; can wait for a change
        /// </summary>
        /// <remarks>
        ///
        /// </remarks>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="ifNoneMatch">The ETag of the last answer, a list of some, or &#x60;*&#x60;; while one of them holds, the answer is 304. A text that is no ETag names none. (optional)</param>
        /// <param name="prefer">&#x60;wait&#x3D;N&#x60; holds the answer back for up to N seconds until the ETag in If-None-Match no longer holds. Longer than &#x60;limits.wait_s_max&#x60; is granted as that; without If-None-Match nothing is waited for. Any other value is refused with &#x60;invalid_request&#x60;. (optional)</param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <param name="cancellationToken">Cancellation Token to cancel the request.</param>
        /// <returns>Task of Run</returns>
        System.Threading.Tasks.Task<Run> GetRunAsync(string runId, string? ifNoneMatch = default, string? prefer = default, string? proctorVersion = default, System.Threading.CancellationToken cancellationToken = default);

        /// <summary>
        /// State, progress and the reason for both; can wait for a change
        /// </summary>
        /// <remarks>
        ///
        /// </remarks>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="ifNoneMatch">The ETag of the last answer, a list of some, or &#x60;*&#x60;; while one of them holds, the answer is 304. A text that is no ETag names none. (optional)</param>
        /// <param name="prefer">&#x60;wait&#x3D;N&#x60; holds the answer back for up to N seconds until the ETag in If-None-Match no longer holds. Longer than &#x60;limits.wait_s_max&#x60; is granted as that; without If-None-Match nothing is waited for. Any other value is refused with &#x60;invalid_request&#x60;. (optional)</param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <param name="cancellationToken">Cancellation Token to cancel the request.</param>
        /// <returns>Task of ApiResponse (Run)</returns>
        System.Threading.Tasks.Task<ApiResponse<Run>> GetRunWithHttpInfoAsync(string runId, string? ifNoneMatch = default, string? prefer = default, string? proctorVersion = default, System.Threading.CancellationToken cancellationToken = default);
        /// <summary>
        /// The score, or its bounds while episodes are missing
        /// </summary>
        /// <remarks>
        ///
        /// </remarks>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <param name="cancellationToken">Cancellation Token to cancel the request.</param>
        /// <returns>Task of Score</returns>
        System.Threading.Tasks.Task<Score> GetScoreAsync(string runId, string? proctorVersion = default, System.Threading.CancellationToken cancellationToken = default);

        /// <summary>
        /// The score, or its bounds while episodes are missing
        /// </summary>
        /// <remarks>
        ///
        /// </remarks>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <param name="cancellationToken">Cancellation Token to cancel the request.</param>
        /// <returns>Task of ApiResponse (Score)</returns>
        System.Threading.Tasks.Task<ApiResponse<Score>> GetScoreWithHttpInfoAsync(string runId, string? proctorVersion = default, System.Threading.CancellationToken cancellationToken = default);
        /// <summary>
        /// The benchmarks offered here
        /// </summary>
        /// <remarks>
        ///
        /// </remarks>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <param name="cancellationToken">Cancellation Token to cancel the request.</param>
        /// <returns>Task of BenchmarkList</returns>
        System.Threading.Tasks.Task<BenchmarkList> ListBenchmarksAsync(string? proctorVersion = default, System.Threading.CancellationToken cancellationToken = default);

        /// <summary>
        /// The benchmarks offered here
        /// </summary>
        /// <remarks>
        ///
        /// </remarks>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <param name="cancellationToken">Cancellation Token to cancel the request.</param>
        /// <returns>Task of ApiResponse (BenchmarkList)</returns>
        System.Threading.Tasks.Task<ApiResponse<BenchmarkList>> ListBenchmarksWithHttpInfoAsync(string? proctorVersion = default, System.Threading.CancellationToken cancellationToken = default);
        /// <summary>
        /// Every episode with its result so far, in manifest order
        /// </summary>
        /// <remarks>
        ///
        /// </remarks>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="cursor">&#x60;next_cursor&#x60; of the page before; opaque to the caller. (optional)</param>
        /// <param name="limit">Most items wanted on a page; 100 when absent. (optional)</param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <param name="cancellationToken">Cancellation Token to cancel the request.</param>
        /// <returns>Task of EpisodeList</returns>
        System.Threading.Tasks.Task<EpisodeList> ListEpisodesAsync(string runId, string? cursor = default, int? limit = default, string? proctorVersion = default, System.Threading.CancellationToken cancellationToken = default);

        /// <summary>
        /// Every episode with its result so far, in manifest order
        /// </summary>
        /// <remarks>
        ///
        /// </remarks>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="cursor">&#x60;next_cursor&#x60; of the page before; opaque to the caller. (optional)</param>
        /// <param name="limit">Most items wanted on a page; 100 when absent. (optional)</param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <param name="cancellationToken">Cancellation Token to cancel the request.</param>
        /// <returns>Task of ApiResponse (EpisodeList)</returns>
        System.Threading.Tasks.Task<ApiResponse<EpisodeList>> ListEpisodesWithHttpInfoAsync(string runId, string? cursor = default, int? limit = default, string? proctorVersion = default, System.Threading.CancellationToken cancellationToken = default);
        /// <summary>
        /// The caller&#39;s runs, newest first
        /// </summary>
        /// <remarks>
        ///
        /// </remarks>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="cursor">&#x60;next_cursor&#x60; of the page before; opaque to the caller. (optional)</param>
        /// <param name="limit">Most items wanted on a page; 100 when absent. (optional)</param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <param name="cancellationToken">Cancellation Token to cancel the request.</param>
        /// <returns>Task of RunList</returns>
        System.Threading.Tasks.Task<RunList> ListRunsAsync(string? cursor = default, int? limit = default, string? proctorVersion = default, System.Threading.CancellationToken cancellationToken = default);

        /// <summary>
        /// The caller&#39;s runs, newest first
        /// </summary>
        /// <remarks>
        ///
        /// </remarks>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="cursor">&#x60;next_cursor&#x60; of the page before; opaque to the caller. (optional)</param>
        /// <param name="limit">Most items wanted on a page; 100 when absent. (optional)</param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <param name="cancellationToken">Cancellation Token to cancel the request.</param>
        /// <returns>Task of ApiResponse (RunList)</returns>
        System.Threading.Tasks.Task<ApiResponse<RunList>> ListRunsWithHttpInfoAsync(string? cursor = default, int? limit = default, string? proctorVersion = default, System.Threading.CancellationToken cancellationToken = default);
        /// <summary>
        /// Go on with the episodes that have no score yet
        /// </summary>
        /// <remarks>
        ///
        /// </remarks>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <param name="cancellationToken">Cancellation Token to cancel the request.</param>
        /// <returns>Task of Run</returns>
        System.Threading.Tasks.Task<Run> ResumeRunAsync(string runId, string? proctorVersion = default, System.Threading.CancellationToken cancellationToken = default);

        /// <summary>
        /// Go on with the episodes that have no score yet
        /// </summary>
        /// <remarks>
        ///
        /// </remarks>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <param name="cancellationToken">Cancellation Token to cancel the request.</param>
        /// <returns>Task of ApiResponse (Run)</returns>
        System.Threading.Tasks.Task<ApiResponse<Run>> ResumeRunWithHttpInfoAsync(string runId, string? proctorVersion = default, System.Threading.CancellationToken cancellationToken = default);
        /// <summary>
        /// Stop now (abort) or after the episodes in play (drain)
        /// </summary>
        /// <remarks>
        ///
        /// </remarks>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="stopRun"></param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <param name="cancellationToken">Cancellation Token to cancel the request.</param>
        /// <returns>Task of Run</returns>
        System.Threading.Tasks.Task<Run> StopRunAsync(string runId, StopRun stopRun, string? proctorVersion = default, System.Threading.CancellationToken cancellationToken = default);

        /// <summary>
        /// Stop now (abort) or after the episodes in play (drain)
        /// </summary>
        /// <remarks>
        ///
        /// </remarks>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="stopRun"></param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <param name="cancellationToken">Cancellation Token to cancel the request.</param>
        /// <returns>Task of ApiResponse (Run)</returns>
        System.Threading.Tasks.Task<ApiResponse<Run>> StopRunWithHttpInfoAsync(string runId, StopRun stopRun, string? proctorVersion = default, System.Threading.CancellationToken cancellationToken = default);
        /// <summary>
        /// Ask for one evaluation of one policy on one benchmark
        /// </summary>
        /// <remarks>
        ///
        /// </remarks>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="submitRun"></param>
        /// <param name="idempotencyKey">Makes a repeated submit return the first run instead of making another. One that breaks the pattern is refused with &#x60;invalid_request&#x60;. (optional)</param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <param name="cancellationToken">Cancellation Token to cancel the request.</param>
        /// <returns>Task of Run</returns>
        System.Threading.Tasks.Task<Run> SubmitRunAsync(SubmitRun submitRun, string? idempotencyKey = default, string? proctorVersion = default, System.Threading.CancellationToken cancellationToken = default);

        /// <summary>
        /// Ask for one evaluation of one policy on one benchmark
        /// </summary>
        /// <remarks>
        ///
        /// </remarks>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="submitRun"></param>
        /// <param name="idempotencyKey">Makes a repeated submit return the first run instead of making another. One that breaks the pattern is refused with &#x60;invalid_request&#x60;. (optional)</param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <param name="cancellationToken">Cancellation Token to cancel the request.</param>
        /// <returns>Task of ApiResponse (Run)</returns>
        System.Threading.Tasks.Task<ApiResponse<Run>> SubmitRunWithHttpInfoAsync(SubmitRun submitRun, string? idempotencyKey = default, string? proctorVersion = default, System.Threading.CancellationToken cancellationToken = default);
        #endregion Asynchronous Operations
    }

    /// <summary>
    /// Represents a collection of functions to interact with the API endpoints
    /// </summary>
    public interface IControlApi : IControlApiSync, IControlApiAsync
    {

    }

    /// <summary>
    /// Represents a collection of functions to interact with the API endpoints
    /// </summary>
    public partial class ControlApi : IDisposable, IControlApi
    {
        private Proctor.Client.Client.ExceptionFactory _exceptionFactory = (name, response) => null;

        /// <summary>
        /// Initializes a new instance of the <see cref="ControlApi"/> class.
        /// **IMPORTANT** This will also create an instance of HttpClient, which is less than ideal.
        /// It's better to reuse the <see href="https://docs.microsoft.com/en-us/dotnet/architecture/microservices/implement-resilient-applications/use-httpclientfactory-to-implement-resilient-http-requests#issues-with-the-original-httpclient-class-available-in-net">HttpClient and HttpClientHandler</see>.
        /// </summary>
        /// <returns></returns>
        public ControlApi() : this((string)null)
        {
        }

        /// <summary>
        /// Initializes a new instance of the <see cref="ControlApi"/> class.
        /// **IMPORTANT** This will also create an instance of HttpClient, which is less than ideal.
        /// It's better to reuse the <see href="https://docs.microsoft.com/en-us/dotnet/architecture/microservices/implement-resilient-applications/use-httpclientfactory-to-implement-resilient-http-requests#issues-with-the-original-httpclient-class-available-in-net">HttpClient and HttpClientHandler</see>.
        /// </summary>
        /// <param name="basePath">The target service's base path in URL format.</param>
        /// <exception cref="ArgumentException"></exception>
        /// <returns></returns>
        public ControlApi(string basePath)
        {
            this.Configuration = Proctor.Client.Client.Configuration.MergeConfigurations(
                Proctor.Client.Client.GlobalConfiguration.Instance,
                new Proctor.Client.Client.Configuration { BasePath = basePath }
            );
            this.ApiClient = new Proctor.Client.Client.ApiClient(this.Configuration.BasePath);
            this.Client =  this.ApiClient;
            this.AsynchronousClient = this.ApiClient;
            this.ExceptionFactory = Proctor.Client.Client.Configuration.DefaultExceptionFactory;
        }

        /// <summary>
        /// Initializes a new instance of the <see cref="ControlApi"/> class using Configuration object.
        /// **IMPORTANT** This will also create an instance of HttpClient, which is less than ideal.
        /// It's better to reuse the <see href="https://docs.microsoft.com/en-us/dotnet/architecture/microservices/implement-resilient-applications/use-httpclientfactory-to-implement-resilient-http-requests#issues-with-the-original-httpclient-class-available-in-net">HttpClient and HttpClientHandler</see>.
        /// </summary>
        /// <param name="configuration">An instance of Configuration.</param>
        /// <exception cref="ArgumentNullException"></exception>
        /// <returns></returns>
        public ControlApi(Proctor.Client.Client.Configuration configuration)
        {
            if (configuration == null) throw new ArgumentNullException("configuration");

            this.Configuration = Proctor.Client.Client.Configuration.MergeConfigurations(
                Proctor.Client.Client.GlobalConfiguration.Instance,
                configuration
            );
            this.ApiClient = new Proctor.Client.Client.ApiClient(this.Configuration.BasePath);
            this.Client = this.ApiClient;
            this.AsynchronousClient = this.ApiClient;
            ExceptionFactory = Proctor.Client.Client.Configuration.DefaultExceptionFactory;
        }

        /// <summary>
        /// Initializes a new instance of the <see cref="ControlApi"/> class.
        /// </summary>
        /// <param name="client">An instance of HttpClient.</param>
        /// <param name="handler">An optional instance of HttpClientHandler that is used by HttpClient.</param>
        /// <exception cref="ArgumentNullException"></exception>
        /// <returns></returns>
        /// <remarks>
        /// Some configuration settings will not be applied without passing an HttpClientHandler.
        /// The features affected are: Setting and Retrieving Cookies, Client Certificates, Proxy settings.
        /// </remarks>
        public ControlApi(HttpClient client, HttpClientHandler handler = null) : this(client, (string)null, handler)
        {
        }

        /// <summary>
        /// Initializes a new instance of the <see cref="ControlApi"/> class.
        /// </summary>
        /// <param name="client">An instance of HttpClient.</param>
        /// <param name="basePath">The target service's base path in URL format.</param>
        /// <param name="handler">An optional instance of HttpClientHandler that is used by HttpClient.</param>
        /// <exception cref="ArgumentNullException"></exception>
        /// <exception cref="ArgumentException"></exception>
        /// <returns></returns>
        /// <remarks>
        /// Some configuration settings will not be applied without passing an HttpClientHandler.
        /// The features affected are: Setting and Retrieving Cookies, Client Certificates, Proxy settings.
        /// </remarks>
        public ControlApi(HttpClient client, string basePath, HttpClientHandler handler = null)
        {
            if (client == null) throw new ArgumentNullException("client");

            this.Configuration = Proctor.Client.Client.Configuration.MergeConfigurations(
                Proctor.Client.Client.GlobalConfiguration.Instance,
                new Proctor.Client.Client.Configuration { BasePath = basePath }
            );
            this.ApiClient = new Proctor.Client.Client.ApiClient(client, this.Configuration.BasePath, handler);
            this.Client =  this.ApiClient;
            this.AsynchronousClient = this.ApiClient;
            this.ExceptionFactory = Proctor.Client.Client.Configuration.DefaultExceptionFactory;
        }

        /// <summary>
        /// Initializes a new instance of the <see cref="ControlApi"/> class using Configuration object.
        /// </summary>
        /// <param name="client">An instance of HttpClient.</param>
        /// <param name="configuration">An instance of Configuration.</param>
        /// <param name="handler">An optional instance of HttpClientHandler that is used by HttpClient.</param>
        /// <exception cref="ArgumentNullException"></exception>
        /// <returns></returns>
        /// <remarks>
        /// Some configuration settings will not be applied without passing an HttpClientHandler.
        /// The features affected are: Setting and Retrieving Cookies, Client Certificates, Proxy settings.
        /// </remarks>
        public ControlApi(HttpClient client, Proctor.Client.Client.Configuration configuration, HttpClientHandler handler = null)
        {
            if (configuration == null) throw new ArgumentNullException("configuration");
            if (client == null) throw new ArgumentNullException("client");

            this.Configuration = Proctor.Client.Client.Configuration.MergeConfigurations(
                Proctor.Client.Client.GlobalConfiguration.Instance,
                configuration
            );
            this.ApiClient = new Proctor.Client.Client.ApiClient(client, this.Configuration.BasePath, handler);
            this.Client = this.ApiClient;
            this.AsynchronousClient = this.ApiClient;
            ExceptionFactory = Proctor.Client.Client.Configuration.DefaultExceptionFactory;
        }

        /// <summary>
        /// Initializes a new instance of the <see cref="ControlApi"/> class
        /// using a Configuration object and client instance.
        /// </summary>
        /// <param name="client">The client interface for synchronous API access.</param>
        /// <param name="asyncClient">The client interface for asynchronous API access.</param>
        /// <param name="configuration">The configuration object.</param>
        /// <exception cref="ArgumentNullException"></exception>
        public ControlApi(Proctor.Client.Client.ISynchronousClient client, Proctor.Client.Client.IAsynchronousClient asyncClient, Proctor.Client.Client.IReadableConfiguration configuration)
        {
            if (client == null) throw new ArgumentNullException("client");
            if (asyncClient == null) throw new ArgumentNullException("asyncClient");
            if (configuration == null) throw new ArgumentNullException("configuration");

            this.Client = client;
            this.AsynchronousClient = asyncClient;
            this.Configuration = configuration;
            this.ExceptionFactory = Proctor.Client.Client.Configuration.DefaultExceptionFactory;
        }

        /// <summary>
        /// Disposes resources if they were created by us
        /// </summary>
        public void Dispose()
        {
            this.ApiClient?.Dispose();
        }

        /// <summary>
        /// Holds the ApiClient if created
        /// </summary>
        public Proctor.Client.Client.ApiClient ApiClient { get; set; } = null;

        /// <summary>
        /// The client for accessing this underlying API asynchronously.
        /// </summary>
        public Proctor.Client.Client.IAsynchronousClient AsynchronousClient { get; set; }

        /// <summary>
        /// The client for accessing this underlying API synchronously.
        /// </summary>
        public Proctor.Client.Client.ISynchronousClient Client { get; set; }

        /// <summary>
        /// Gets the base path of the API client.
        /// </summary>
        /// <value>The base path</value>
        public string GetBasePath()
        {
            return this.Configuration.BasePath;
        }

        /// <summary>
        /// Gets or sets the configuration object
        /// </summary>
        /// <value>An instance of the Configuration</value>
        public Proctor.Client.Client.IReadableConfiguration Configuration { get; set; }

        /// <summary>
        /// Provides a factory method hook for the creation of exceptions.
        /// </summary>
        public Proctor.Client.Client.ExceptionFactory ExceptionFactory
        {
            get
            {
                if (_exceptionFactory != null && _exceptionFactory.GetInvocationList().Length > 1)
                {
                    throw new InvalidOperationException("Multicast delegate for ExceptionFactory is unsupported.");
                }
                return _exceptionFactory;
            }
            set { _exceptionFactory = value; }
        }

        /// <summary>
        /// Runs beside a baseline, episode by episode Pairs the episodes of runs of one manifest. Offered with the profile &#x60;compare&#x60;; scoring.md has the arithmetic.
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="baseline">The run that the others are compared with.</param>
        /// <param name="runs">Ids of one to sixteen runs, with commas between them; the baseline may be one of them.</param>
        /// <param name="tolerance">The largest difference that &#x60;release&#x60; lets pass; 0.05 when absent. (optional)</param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <returns>Comparison</returns>
        public Comparison CompareRuns(string baseline, string runs, double? tolerance = default, string? proctorVersion = default)
        {
            Proctor.Client.Client.ApiResponse<Comparison> localVarResponse = CompareRunsWithHttpInfo(baseline, runs, tolerance, proctorVersion);
            return localVarResponse.Data;
        }

        /// <summary>
        /// Runs beside a baseline, episode by episode Pairs the episodes of runs of one manifest. Offered with the profile &#x60;compare&#x60;; scoring.md has the arithmetic.
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="baseline">The run that the others are compared with.</param>
        /// <param name="runs">Ids of one to sixteen runs, with commas between them; the baseline may be one of them.</param>
        /// <param name="tolerance">The largest difference that &#x60;release&#x60; lets pass; 0.05 when absent. (optional)</param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <returns>ApiResponse of Comparison</returns>
        public Proctor.Client.Client.ApiResponse<Comparison> CompareRunsWithHttpInfo(string baseline, string runs, double? tolerance = default, string? proctorVersion = default)
        {
            // verify the required parameter 'baseline' is set
            if (baseline == null)
                throw new Proctor.Client.Client.ApiException(400, "Missing required parameter 'baseline' when calling ControlApi->CompareRuns");

            // verify the required parameter 'runs' is set
            if (runs == null)
                throw new Proctor.Client.Client.ApiException(400, "Missing required parameter 'runs' when calling ControlApi->CompareRuns");

            Proctor.Client.Client.RequestOptions localVarRequestOptions = new Proctor.Client.Client.RequestOptions();

            string[] _contentTypes = new string[] {
            };

            // to determine the Accept header
            string[] _accepts = new string[] {
                "application/json",
                "application/problem+json"
            };

            var localVarContentType = Proctor.Client.Client.ClientUtils.SelectHeaderContentType(_contentTypes);
            if (localVarContentType != null) localVarRequestOptions.HeaderParameters.Add("Content-Type", localVarContentType);

            var localVarAccept = Proctor.Client.Client.ClientUtils.SelectHeaderAccept(_accepts);
            if (localVarAccept != null) localVarRequestOptions.HeaderParameters.Add("Accept", localVarAccept);

            localVarRequestOptions.QueryParameters.Add(Proctor.Client.Client.ClientUtils.ParameterToMultiMap("", "baseline", baseline));
            localVarRequestOptions.QueryParameters.Add(Proctor.Client.Client.ClientUtils.ParameterToMultiMap("", "runs", runs));
            if (tolerance != null)
            {
                localVarRequestOptions.QueryParameters.Add(Proctor.Client.Client.ClientUtils.ParameterToMultiMap("", "tolerance", tolerance));
            }
            if (proctorVersion != null)
            {
                localVarRequestOptions.HeaderParameters.Add("Proctor-Version", Proctor.Client.Client.ClientUtils.ParameterToString(proctorVersion)); // header parameter
            }

            // authentication (bearer) required
            // bearer authentication required
            if (!string.IsNullOrEmpty(this.Configuration.AccessToken) && !localVarRequestOptions.HeaderParameters.ContainsKey("Authorization"))
            {
                localVarRequestOptions.HeaderParameters.Add("Authorization", "Bearer " + this.Configuration.AccessToken);
            }

            // make the HTTP request
            var localVarResponse = this.Client.Get<Comparison>("/v1/comparisons", localVarRequestOptions, this.Configuration);

            if (this.ExceptionFactory != null)
            {
                Exception _exception = this.ExceptionFactory("CompareRuns", localVarResponse);
                if (_exception != null) throw _exception;
            }

            return localVarResponse;
        }

        /// <summary>
        /// Runs beside a baseline, episode by episode Pairs the episodes of runs of one manifest. Offered with the profile &#x60;compare&#x60;; scoring.md has the arithmetic.
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="baseline">The run that the others are compared with.</param>
        /// <param name="runs">Ids of one to sixteen runs, with commas between them; the baseline may be one of them.</param>
        /// <param name="tolerance">The largest difference that &#x60;release&#x60; lets pass; 0.05 when absent. (optional)</param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <param name="cancellationToken">Cancellation Token to cancel the request.</param>
        /// <returns>Task of Comparison</returns>
        public async System.Threading.Tasks.Task<Comparison> CompareRunsAsync(string baseline, string runs, double? tolerance = default, string? proctorVersion = default, System.Threading.CancellationToken cancellationToken = default)
        {
            Proctor.Client.Client.ApiResponse<Comparison> localVarResponse = await CompareRunsWithHttpInfoAsync(baseline, runs, tolerance, proctorVersion, cancellationToken).ConfigureAwait(false);
            return localVarResponse.Data;
        }

        /// <summary>
        /// Runs beside a baseline, episode by episode Pairs the episodes of runs of one manifest. Offered with the profile &#x60;compare&#x60;; scoring.md has the arithmetic.
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="baseline">The run that the others are compared with.</param>
        /// <param name="runs">Ids of one to sixteen runs, with commas between them; the baseline may be one of them.</param>
        /// <param name="tolerance">The largest difference that &#x60;release&#x60; lets pass; 0.05 when absent. (optional)</param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <param name="cancellationToken">Cancellation Token to cancel the request.</param>
        /// <returns>Task of ApiResponse (Comparison)</returns>
        public async System.Threading.Tasks.Task<Proctor.Client.Client.ApiResponse<Comparison>> CompareRunsWithHttpInfoAsync(string baseline, string runs, double? tolerance = default, string? proctorVersion = default, System.Threading.CancellationToken cancellationToken = default)
        {
            // verify the required parameter 'baseline' is set
            if (baseline == null)
                throw new Proctor.Client.Client.ApiException(400, "Missing required parameter 'baseline' when calling ControlApi->CompareRuns");

            // verify the required parameter 'runs' is set
            if (runs == null)
                throw new Proctor.Client.Client.ApiException(400, "Missing required parameter 'runs' when calling ControlApi->CompareRuns");


            Proctor.Client.Client.RequestOptions localVarRequestOptions = new Proctor.Client.Client.RequestOptions();

            string[] _contentTypes = new string[] {
            };

            // to determine the Accept header
            string[] _accepts = new string[] {
                "application/json",
                "application/problem+json"
            };


            var localVarContentType = Proctor.Client.Client.ClientUtils.SelectHeaderContentType(_contentTypes);
            if (localVarContentType != null) localVarRequestOptions.HeaderParameters.Add("Content-Type", localVarContentType);

            var localVarAccept = Proctor.Client.Client.ClientUtils.SelectHeaderAccept(_accepts);
            if (localVarAccept != null) localVarRequestOptions.HeaderParameters.Add("Accept", localVarAccept);

            localVarRequestOptions.QueryParameters.Add(Proctor.Client.Client.ClientUtils.ParameterToMultiMap("", "baseline", baseline));
            localVarRequestOptions.QueryParameters.Add(Proctor.Client.Client.ClientUtils.ParameterToMultiMap("", "runs", runs));
            if (tolerance != null)
            {
                localVarRequestOptions.QueryParameters.Add(Proctor.Client.Client.ClientUtils.ParameterToMultiMap("", "tolerance", tolerance));
            }
            if (proctorVersion != null)
            {
                localVarRequestOptions.HeaderParameters.Add("Proctor-Version", Proctor.Client.Client.ClientUtils.ParameterToString(proctorVersion)); // header parameter
            }

            // authentication (bearer) required
            // bearer authentication required
            if (!string.IsNullOrEmpty(this.Configuration.AccessToken) && !localVarRequestOptions.HeaderParameters.ContainsKey("Authorization"))
            {
                localVarRequestOptions.HeaderParameters.Add("Authorization", "Bearer " + this.Configuration.AccessToken);
            }

            // make the HTTP request

            var localVarResponse = await this.AsynchronousClient.GetAsync<Comparison>("/v1/comparisons", localVarRequestOptions, this.Configuration, cancellationToken).ConfigureAwait(false);

            if (this.ExceptionFactory != null)
            {
                Exception _exception = this.ExceptionFactory("CompareRuns", localVarResponse);
                if (_exception != null) throw _exception;
            }

            return localVarResponse;
        }

        /// <summary>
        /// What this server is, speaks and allows
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <returns>Service</returns>
        public Service DescribeService(string? proctorVersion = default)
        {
            Proctor.Client.Client.ApiResponse<Service> localVarResponse = DescribeServiceWithHttpInfo(proctorVersion);
            return localVarResponse.Data;
        }

        /// <summary>
        /// What this server is, speaks and allows
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <returns>ApiResponse of Service</returns>
        public Proctor.Client.Client.ApiResponse<Service> DescribeServiceWithHttpInfo(string? proctorVersion = default)
        {
            Proctor.Client.Client.RequestOptions localVarRequestOptions = new Proctor.Client.Client.RequestOptions();

            string[] _contentTypes = new string[] {
            };

            // to determine the Accept header
            string[] _accepts = new string[] {
                "application/json",
                "application/problem+json"
            };

            var localVarContentType = Proctor.Client.Client.ClientUtils.SelectHeaderContentType(_contentTypes);
            if (localVarContentType != null) localVarRequestOptions.HeaderParameters.Add("Content-Type", localVarContentType);

            var localVarAccept = Proctor.Client.Client.ClientUtils.SelectHeaderAccept(_accepts);
            if (localVarAccept != null) localVarRequestOptions.HeaderParameters.Add("Accept", localVarAccept);

            if (proctorVersion != null)
            {
                localVarRequestOptions.HeaderParameters.Add("Proctor-Version", Proctor.Client.Client.ClientUtils.ParameterToString(proctorVersion)); // header parameter
            }


            // make the HTTP request
            var localVarResponse = this.Client.Get<Service>("/v1", localVarRequestOptions, this.Configuration);

            if (this.ExceptionFactory != null)
            {
                Exception _exception = this.ExceptionFactory("DescribeService", localVarResponse);
                if (_exception != null) throw _exception;
            }

            return localVarResponse;
        }

        /// <summary>
        /// What this server is, speaks and allows
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <param name="cancellationToken">Cancellation Token to cancel the request.</param>
        /// <returns>Task of Service</returns>
        public async System.Threading.Tasks.Task<Service> DescribeServiceAsync(string? proctorVersion = default, System.Threading.CancellationToken cancellationToken = default)
        {
            Proctor.Client.Client.ApiResponse<Service> localVarResponse = await DescribeServiceWithHttpInfoAsync(proctorVersion, cancellationToken).ConfigureAwait(false);
            return localVarResponse.Data;
        }

        /// <summary>
        /// What this server is, speaks and allows
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <param name="cancellationToken">Cancellation Token to cancel the request.</param>
        /// <returns>Task of ApiResponse (Service)</returns>
        public async System.Threading.Tasks.Task<Proctor.Client.Client.ApiResponse<Service>> DescribeServiceWithHttpInfoAsync(string? proctorVersion = default, System.Threading.CancellationToken cancellationToken = default)
        {

            Proctor.Client.Client.RequestOptions localVarRequestOptions = new Proctor.Client.Client.RequestOptions();

            string[] _contentTypes = new string[] {
            };

            // to determine the Accept header
            string[] _accepts = new string[] {
                "application/json",
                "application/problem+json"
            };


            var localVarContentType = Proctor.Client.Client.ClientUtils.SelectHeaderContentType(_contentTypes);
            if (localVarContentType != null) localVarRequestOptions.HeaderParameters.Add("Content-Type", localVarContentType);

            var localVarAccept = Proctor.Client.Client.ClientUtils.SelectHeaderAccept(_accepts);
            if (localVarAccept != null) localVarRequestOptions.HeaderParameters.Add("Accept", localVarAccept);

            if (proctorVersion != null)
            {
                localVarRequestOptions.HeaderParameters.Add("Proctor-Version", Proctor.Client.Client.ClientUtils.ParameterToString(proctorVersion)); // header parameter
            }


            // make the HTTP request

            var localVarResponse = await this.AsynchronousClient.GetAsync<Service>("/v1", localVarRequestOptions, this.Configuration, cancellationToken).ConfigureAwait(false);

            if (this.ExceptionFactory != null)
            {
                Exception _exception = this.ExceptionFactory("DescribeService", localVarResponse);
                if (_exception != null) throw _exception;
            }

            return localVarResponse;
        }

        /// <summary>
        /// One benchmark with its spaces, conventions and rules
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="benchmarkId"></param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <returns>Benchmark</returns>
        public Benchmark GetBenchmark(string benchmarkId, string? proctorVersion = default)
        {
            Proctor.Client.Client.ApiResponse<Benchmark> localVarResponse = GetBenchmarkWithHttpInfo(benchmarkId, proctorVersion);
            return localVarResponse.Data;
        }

        /// <summary>
        /// One benchmark with its spaces, conventions and rules
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="benchmarkId"></param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <returns>ApiResponse of Benchmark</returns>
        public Proctor.Client.Client.ApiResponse<Benchmark> GetBenchmarkWithHttpInfo(string benchmarkId, string? proctorVersion = default)
        {
            // verify the required parameter 'benchmarkId' is set
            if (benchmarkId == null)
                throw new Proctor.Client.Client.ApiException(400, "Missing required parameter 'benchmarkId' when calling ControlApi->GetBenchmark");

            Proctor.Client.Client.RequestOptions localVarRequestOptions = new Proctor.Client.Client.RequestOptions();

            string[] _contentTypes = new string[] {
            };

            // to determine the Accept header
            string[] _accepts = new string[] {
                "application/json",
                "application/problem+json"
            };

            var localVarContentType = Proctor.Client.Client.ClientUtils.SelectHeaderContentType(_contentTypes);
            if (localVarContentType != null) localVarRequestOptions.HeaderParameters.Add("Content-Type", localVarContentType);

            var localVarAccept = Proctor.Client.Client.ClientUtils.SelectHeaderAccept(_accepts);
            if (localVarAccept != null) localVarRequestOptions.HeaderParameters.Add("Accept", localVarAccept);

            localVarRequestOptions.PathParameters.Add("benchmark_id", Proctor.Client.Client.ClientUtils.ParameterToString(benchmarkId)); // path parameter
            if (proctorVersion != null)
            {
                localVarRequestOptions.HeaderParameters.Add("Proctor-Version", Proctor.Client.Client.ClientUtils.ParameterToString(proctorVersion)); // header parameter
            }

            // authentication (bearer) required
            // bearer authentication required
            if (!string.IsNullOrEmpty(this.Configuration.AccessToken) && !localVarRequestOptions.HeaderParameters.ContainsKey("Authorization"))
            {
                localVarRequestOptions.HeaderParameters.Add("Authorization", "Bearer " + this.Configuration.AccessToken);
            }

            // make the HTTP request
            var localVarResponse = this.Client.Get<Benchmark>("/v1/benchmarks/{benchmark_id}", localVarRequestOptions, this.Configuration);

            if (this.ExceptionFactory != null)
            {
                Exception _exception = this.ExceptionFactory("GetBenchmark", localVarResponse);
                if (_exception != null) throw _exception;
            }

            return localVarResponse;
        }

        /// <summary>
        /// One benchmark with its spaces, conventions and rules
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="benchmarkId"></param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <param name="cancellationToken">Cancellation Token to cancel the request.</param>
        /// <returns>Task of Benchmark</returns>
        public async System.Threading.Tasks.Task<Benchmark> GetBenchmarkAsync(string benchmarkId, string? proctorVersion = default, System.Threading.CancellationToken cancellationToken = default)
        {
            Proctor.Client.Client.ApiResponse<Benchmark> localVarResponse = await GetBenchmarkWithHttpInfoAsync(benchmarkId, proctorVersion, cancellationToken).ConfigureAwait(false);
            return localVarResponse.Data;
        }

        /// <summary>
        /// One benchmark with its spaces, conventions and rules
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="benchmarkId"></param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <param name="cancellationToken">Cancellation Token to cancel the request.</param>
        /// <returns>Task of ApiResponse (Benchmark)</returns>
        public async System.Threading.Tasks.Task<Proctor.Client.Client.ApiResponse<Benchmark>> GetBenchmarkWithHttpInfoAsync(string benchmarkId, string? proctorVersion = default, System.Threading.CancellationToken cancellationToken = default)
        {
            // verify the required parameter 'benchmarkId' is set
            if (benchmarkId == null)
                throw new Proctor.Client.Client.ApiException(400, "Missing required parameter 'benchmarkId' when calling ControlApi->GetBenchmark");


            Proctor.Client.Client.RequestOptions localVarRequestOptions = new Proctor.Client.Client.RequestOptions();

            string[] _contentTypes = new string[] {
            };

            // to determine the Accept header
            string[] _accepts = new string[] {
                "application/json",
                "application/problem+json"
            };


            var localVarContentType = Proctor.Client.Client.ClientUtils.SelectHeaderContentType(_contentTypes);
            if (localVarContentType != null) localVarRequestOptions.HeaderParameters.Add("Content-Type", localVarContentType);

            var localVarAccept = Proctor.Client.Client.ClientUtils.SelectHeaderAccept(_accepts);
            if (localVarAccept != null) localVarRequestOptions.HeaderParameters.Add("Accept", localVarAccept);

            localVarRequestOptions.PathParameters.Add("benchmark_id", Proctor.Client.Client.ClientUtils.ParameterToString(benchmarkId)); // path parameter
            if (proctorVersion != null)
            {
                localVarRequestOptions.HeaderParameters.Add("Proctor-Version", Proctor.Client.Client.ClientUtils.ParameterToString(proctorVersion)); // header parameter
            }

            // authentication (bearer) required
            // bearer authentication required
            if (!string.IsNullOrEmpty(this.Configuration.AccessToken) && !localVarRequestOptions.HeaderParameters.ContainsKey("Authorization"))
            {
                localVarRequestOptions.HeaderParameters.Add("Authorization", "Bearer " + this.Configuration.AccessToken);
            }

            // make the HTTP request

            var localVarResponse = await this.AsynchronousClient.GetAsync<Benchmark>("/v1/benchmarks/{benchmark_id}", localVarRequestOptions, this.Configuration, cancellationToken).ConfigureAwait(false);

            if (this.ExceptionFactory != null)
            {
                Exception _exception = this.ExceptionFactory("GetBenchmark", localVarResponse);
                if (_exception != null) throw _exception;
            }

            return localVarResponse;
        }

        /// <summary>
        /// State, progress and the reason for both; can wait for a change
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="ifNoneMatch">The ETag of the last answer, a list of some, or &#x60;*&#x60;; while one of them holds, the answer is 304. A text that is no ETag names none. (optional)</param>
        /// <param name="prefer">&#x60;wait&#x3D;N&#x60; holds the answer back for up to N seconds until the ETag in If-None-Match no longer holds. Longer than &#x60;limits.wait_s_max&#x60; is granted as that; without If-None-Match nothing is waited for. Any other value is refused with &#x60;invalid_request&#x60;. (optional)</param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <returns>Run</returns>
        public Run GetRun(string runId, string? ifNoneMatch = default, string? prefer = default, string? proctorVersion = default)
        {
            Proctor.Client.Client.ApiResponse<Run> localVarResponse = GetRunWithHttpInfo(runId, ifNoneMatch, prefer, proctorVersion);
            return localVarResponse.Data;
        }

        /// <summary>
        /// State, progress and the reason for both; can wait for a change
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="ifNoneMatch">The ETag of the last answer, a list of some, or &#x60;*&#x60;; while one of them holds, the answer is 304. A text that is no ETag names none. (optional)</param>
        /// <param name="prefer">&#x60;wait&#x3D;N&#x60; holds the answer back for up to N seconds until the ETag in If-None-Match no longer holds. Longer than &#x60;limits.wait_s_max&#x60; is granted as that; without If-None-Match nothing is waited for. Any other value is refused with &#x60;invalid_request&#x60;. (optional)</param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <returns>ApiResponse of Run</returns>
        public Proctor.Client.Client.ApiResponse<Run> GetRunWithHttpInfo(string runId, string? ifNoneMatch = default, string? prefer = default, string? proctorVersion = default)
        {
            // verify the required parameter 'runId' is set
            if (runId == null)
                throw new Proctor.Client.Client.ApiException(400, "Missing required parameter 'runId' when calling ControlApi->GetRun");

            Proctor.Client.Client.RequestOptions localVarRequestOptions = new Proctor.Client.Client.RequestOptions();

            string[] _contentTypes = new string[] {
            };

            // to determine the Accept header
            string[] _accepts = new string[] {
                "application/json",
                "application/problem+json"
            };

            var localVarContentType = Proctor.Client.Client.ClientUtils.SelectHeaderContentType(_contentTypes);
            if (localVarContentType != null) localVarRequestOptions.HeaderParameters.Add("Content-Type", localVarContentType);

            var localVarAccept = Proctor.Client.Client.ClientUtils.SelectHeaderAccept(_accepts);
            if (localVarAccept != null) localVarRequestOptions.HeaderParameters.Add("Accept", localVarAccept);

            localVarRequestOptions.PathParameters.Add("run_id", Proctor.Client.Client.ClientUtils.ParameterToString(runId)); // path parameter
            if (ifNoneMatch != null)
            {
                localVarRequestOptions.HeaderParameters.Add("If-None-Match", Proctor.Client.Client.ClientUtils.ParameterToString(ifNoneMatch)); // header parameter
            }
            if (prefer != null)
            {
                localVarRequestOptions.HeaderParameters.Add("Prefer", Proctor.Client.Client.ClientUtils.ParameterToString(prefer)); // header parameter
            }
            if (proctorVersion != null)
            {
                localVarRequestOptions.HeaderParameters.Add("Proctor-Version", Proctor.Client.Client.ClientUtils.ParameterToString(proctorVersion)); // header parameter
            }

            // authentication (bearer) required
            // bearer authentication required
            if (!string.IsNullOrEmpty(this.Configuration.AccessToken) && !localVarRequestOptions.HeaderParameters.ContainsKey("Authorization"))
            {
                localVarRequestOptions.HeaderParameters.Add("Authorization", "Bearer " + this.Configuration.AccessToken);
            }

            // make the HTTP request
            var localVarResponse = this.Client.Get<Run>("/v1/runs/{run_id}", localVarRequestOptions, this.Configuration);

            if (this.ExceptionFactory != null)
            {
                Exception _exception = this.ExceptionFactory("GetRun", localVarResponse);
                if (_exception != null) throw _exception;
            }

            return localVarResponse;
        }

        /// <summary>
        /// State, progress and the reason for both; can wait for a change
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="ifNoneMatch">The ETag of the last answer, a list of some, or &#x60;*&#x60;; while one of them holds, the answer is 304. A text that is no ETag names none. (optional)</param>
        /// <param name="prefer">&#x60;wait&#x3D;N&#x60; holds the answer back for up to N seconds until the ETag in If-None-Match no longer holds. Longer than &#x60;limits.wait_s_max&#x60; is granted as that; without If-None-Match nothing is waited for. Any other value is refused with &#x60;invalid_request&#x60;. (optional)</param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <param name="cancellationToken">Cancellation Token to cancel the request.</param>
        /// <returns>Task of Run</returns>
        public async System.Threading.Tasks.Task<Run> GetRunAsync(string runId, string? ifNoneMatch = default, string? prefer = default, string? proctorVersion = default, System.Threading.CancellationToken cancellationToken = default)
        {
            Proctor.Client.Client.ApiResponse<Run> localVarResponse = await GetRunWithHttpInfoAsync(runId, ifNoneMatch, prefer, proctorVersion, cancellationToken).ConfigureAwait(false);
            return localVarResponse.Data;
        }

        /// <summary>
        /// State, progress and the reason for both; can wait for a change
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="ifNoneMatch">The ETag of the last answer, a list of some, or &#x60;*&#x60;; while one of them holds, the answer is 304. A text that is no ETag names none. (optional)</param>
        /// <param name="prefer">&#x60;wait&#x3D;N&#x60; holds the answer back for up to N seconds until the ETag in If-None-Match no longer holds. Longer than &#x60;limits.wait_s_max&#x60; is granted as that; without If-None-Match nothing is waited for. Any other value is refused with &#x60;invalid_request&#x60;. (optional)</param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <param name="cancellationToken">Cancellation Token to cancel the request.</param>
        /// <returns>Task of ApiResponse (Run)</returns>
        public async System.Threading.Tasks.Task<Proctor.Client.Client.ApiResponse<Run>> GetRunWithHttpInfoAsync(string runId, string? ifNoneMatch = default, string? prefer = default, string? proctorVersion = default, System.Threading.CancellationToken cancellationToken = default)
        {
            // verify the required parameter 'runId' is set
            if (runId == null)
                throw new Proctor.Client.Client.ApiException(400, "Missing required parameter 'runId' when calling ControlApi->GetRun");


            Proctor.Client.Client.RequestOptions localVarRequestOptions = new Proctor.Client.Client.RequestOptions();

            string[] _contentTypes = new string[] {
            };

            // to determine the Accept header
            string[] _accepts = new string[] {
                "application/json",
                "application/problem+json"
            };


            var localVarContentType = Proctor.Client.Client.ClientUtils.SelectHeaderContentType(_contentTypes);
            if (localVarContentType != null) localVarRequestOptions.HeaderParameters.Add("Content-Type", localVarContentType);

            var localVarAccept = Proctor.Client.Client.ClientUtils.SelectHeaderAccept(_accepts);
            if (localVarAccept != null) localVarRequestOptions.HeaderParameters.Add("Accept", localVarAccept);

            localVarRequestOptions.PathParameters.Add("run_id", Proctor.Client.Client.ClientUtils.ParameterToString(runId)); // path parameter
            if (ifNoneMatch != null)
            {
                localVarRequestOptions.HeaderParameters.Add("If-None-Match", Proctor.Client.Client.ClientUtils.ParameterToString(ifNoneMatch)); // header parameter
            }
            if (prefer != null)
            {
                localVarRequestOptions.HeaderParameters.Add("Prefer", Proctor.Client.Client.ClientUtils.ParameterToString(prefer)); // header parameter
            }
            if (proctorVersion != null)
            {
                localVarRequestOptions.HeaderParameters.Add("Proctor-Version", Proctor.Client.Client.ClientUtils.ParameterToString(proctorVersion)); // header parameter
            }

            // authentication (bearer) required
            // bearer authentication required
            if (!string.IsNullOrEmpty(this.Configuration.AccessToken) && !localVarRequestOptions.HeaderParameters.ContainsKey("Authorization"))
            {
                localVarRequestOptions.HeaderParameters.Add("Authorization", "Bearer " + this.Configuration.AccessToken);
            }

            // make the HTTP request

            var localVarResponse = await this.AsynchronousClient.GetAsync<Run>("/v1/runs/{run_id}", localVarRequestOptions, this.Configuration, cancellationToken).ConfigureAwait(false);

            if (this.ExceptionFactory != null)
            {
                Exception _exception = this.ExceptionFactory("GetRun", localVarResponse);
                if (_exception != null) throw _exception;
            }

            return localVarResponse;
        }

        /// <summary>
        /// The score, or its bounds while episodes are missing
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <returns>Score</returns>
        public Score GetScore(string runId, string? proctorVersion = default)
        {
            Proctor.Client.Client.ApiResponse<Score> localVarResponse = GetScoreWithHttpInfo(runId, proctorVersion);
            return localVarResponse.Data;
        }

        /// <summary>
        /// The score, or its bounds while episodes are missing
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <returns>ApiResponse of Score</returns>
        public Proctor.Client.Client.ApiResponse<Score> GetScoreWithHttpInfo(string runId, string? proctorVersion = default)
        {
            // verify the required parameter 'runId' is set
            if (runId == null)
                throw new Proctor.Client.Client.ApiException(400, "Missing required parameter 'runId' when calling ControlApi->GetScore");

            Proctor.Client.Client.RequestOptions localVarRequestOptions = new Proctor.Client.Client.RequestOptions();

            string[] _contentTypes = new string[] {
            };

            // to determine the Accept header
            string[] _accepts = new string[] {
                "application/json",
                "application/problem+json"
            };

            var localVarContentType = Proctor.Client.Client.ClientUtils.SelectHeaderContentType(_contentTypes);
            if (localVarContentType != null) localVarRequestOptions.HeaderParameters.Add("Content-Type", localVarContentType);

            var localVarAccept = Proctor.Client.Client.ClientUtils.SelectHeaderAccept(_accepts);
            if (localVarAccept != null) localVarRequestOptions.HeaderParameters.Add("Accept", localVarAccept);

            localVarRequestOptions.PathParameters.Add("run_id", Proctor.Client.Client.ClientUtils.ParameterToString(runId)); // path parameter
            if (proctorVersion != null)
            {
                localVarRequestOptions.HeaderParameters.Add("Proctor-Version", Proctor.Client.Client.ClientUtils.ParameterToString(proctorVersion)); // header parameter
            }

            // authentication (bearer) required
            // bearer authentication required
            if (!string.IsNullOrEmpty(this.Configuration.AccessToken) && !localVarRequestOptions.HeaderParameters.ContainsKey("Authorization"))
            {
                localVarRequestOptions.HeaderParameters.Add("Authorization", "Bearer " + this.Configuration.AccessToken);
            }

            // make the HTTP request
            var localVarResponse = this.Client.Get<Score>("/v1/runs/{run_id}/score", localVarRequestOptions, this.Configuration);

            if (this.ExceptionFactory != null)
            {
                Exception _exception = this.ExceptionFactory("GetScore", localVarResponse);
                if (_exception != null) throw _exception;
            }

            return localVarResponse;
        }

        /// <summary>
        /// The score, or its bounds while episodes are missing
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <param name="cancellationToken">Cancellation Token to cancel the request.</param>
        /// <returns>Task of Score</returns>
        public async System.Threading.Tasks.Task<Score> GetScoreAsync(string runId, string? proctorVersion = default, System.Threading.CancellationToken cancellationToken = default)
        {
            Proctor.Client.Client.ApiResponse<Score> localVarResponse = await GetScoreWithHttpInfoAsync(runId, proctorVersion, cancellationToken).ConfigureAwait(false);
            return localVarResponse.Data;
        }

        /// <summary>
        /// The score, or its bounds while episodes are missing
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <param name="cancellationToken">Cancellation Token to cancel the request.</param>
        /// <returns>Task of ApiResponse (Score)</returns>
        public async System.Threading.Tasks.Task<Proctor.Client.Client.ApiResponse<Score>> GetScoreWithHttpInfoAsync(string runId, string? proctorVersion = default, System.Threading.CancellationToken cancellationToken = default)
        {
            // verify the required parameter 'runId' is set
            if (runId == null)
                throw new Proctor.Client.Client.ApiException(400, "Missing required parameter 'runId' when calling ControlApi->GetScore");


            Proctor.Client.Client.RequestOptions localVarRequestOptions = new Proctor.Client.Client.RequestOptions();

            string[] _contentTypes = new string[] {
            };

            // to determine the Accept header
            string[] _accepts = new string[] {
                "application/json",
                "application/problem+json"
            };


            var localVarContentType = Proctor.Client.Client.ClientUtils.SelectHeaderContentType(_contentTypes);
            if (localVarContentType != null) localVarRequestOptions.HeaderParameters.Add("Content-Type", localVarContentType);

            var localVarAccept = Proctor.Client.Client.ClientUtils.SelectHeaderAccept(_accepts);
            if (localVarAccept != null) localVarRequestOptions.HeaderParameters.Add("Accept", localVarAccept);

            localVarRequestOptions.PathParameters.Add("run_id", Proctor.Client.Client.ClientUtils.ParameterToString(runId)); // path parameter
            if (proctorVersion != null)
            {
                localVarRequestOptions.HeaderParameters.Add("Proctor-Version", Proctor.Client.Client.ClientUtils.ParameterToString(proctorVersion)); // header parameter
            }

            // authentication (bearer) required
            // bearer authentication required
            if (!string.IsNullOrEmpty(this.Configuration.AccessToken) && !localVarRequestOptions.HeaderParameters.ContainsKey("Authorization"))
            {
                localVarRequestOptions.HeaderParameters.Add("Authorization", "Bearer " + this.Configuration.AccessToken);
            }

            // make the HTTP request

            var localVarResponse = await this.AsynchronousClient.GetAsync<Score>("/v1/runs/{run_id}/score", localVarRequestOptions, this.Configuration, cancellationToken).ConfigureAwait(false);

            if (this.ExceptionFactory != null)
            {
                Exception _exception = this.ExceptionFactory("GetScore", localVarResponse);
                if (_exception != null) throw _exception;
            }

            return localVarResponse;
        }

        /// <summary>
        /// The benchmarks offered here
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <returns>BenchmarkList</returns>
        public BenchmarkList ListBenchmarks(string? proctorVersion = default)
        {
            Proctor.Client.Client.ApiResponse<BenchmarkList> localVarResponse = ListBenchmarksWithHttpInfo(proctorVersion);
            return localVarResponse.Data;
        }

        /// <summary>
        /// The benchmarks offered here
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <returns>ApiResponse of BenchmarkList</returns>
        public Proctor.Client.Client.ApiResponse<BenchmarkList> ListBenchmarksWithHttpInfo(string? proctorVersion = default)
        {
            Proctor.Client.Client.RequestOptions localVarRequestOptions = new Proctor.Client.Client.RequestOptions();

            string[] _contentTypes = new string[] {
            };

            // to determine the Accept header
            string[] _accepts = new string[] {
                "application/json",
                "application/problem+json"
            };

            var localVarContentType = Proctor.Client.Client.ClientUtils.SelectHeaderContentType(_contentTypes);
            if (localVarContentType != null) localVarRequestOptions.HeaderParameters.Add("Content-Type", localVarContentType);

            var localVarAccept = Proctor.Client.Client.ClientUtils.SelectHeaderAccept(_accepts);
            if (localVarAccept != null) localVarRequestOptions.HeaderParameters.Add("Accept", localVarAccept);

            if (proctorVersion != null)
            {
                localVarRequestOptions.HeaderParameters.Add("Proctor-Version", Proctor.Client.Client.ClientUtils.ParameterToString(proctorVersion)); // header parameter
            }

            // authentication (bearer) required
            // bearer authentication required
            if (!string.IsNullOrEmpty(this.Configuration.AccessToken) && !localVarRequestOptions.HeaderParameters.ContainsKey("Authorization"))
            {
                localVarRequestOptions.HeaderParameters.Add("Authorization", "Bearer " + this.Configuration.AccessToken);
            }

            // make the HTTP request
            var localVarResponse = this.Client.Get<BenchmarkList>("/v1/benchmarks", localVarRequestOptions, this.Configuration);

            if (this.ExceptionFactory != null)
            {
                Exception _exception = this.ExceptionFactory("ListBenchmarks", localVarResponse);
                if (_exception != null) throw _exception;
            }

            return localVarResponse;
        }

        /// <summary>
        /// The benchmarks offered here
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <param name="cancellationToken">Cancellation Token to cancel the request.</param>
        /// <returns>Task of BenchmarkList</returns>
        public async System.Threading.Tasks.Task<BenchmarkList> ListBenchmarksAsync(string? proctorVersion = default, System.Threading.CancellationToken cancellationToken = default)
        {
            Proctor.Client.Client.ApiResponse<BenchmarkList> localVarResponse = await ListBenchmarksWithHttpInfoAsync(proctorVersion, cancellationToken).ConfigureAwait(false);
            return localVarResponse.Data;
        }

        /// <summary>
        /// The benchmarks offered here
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <param name="cancellationToken">Cancellation Token to cancel the request.</param>
        /// <returns>Task of ApiResponse (BenchmarkList)</returns>
        public async System.Threading.Tasks.Task<Proctor.Client.Client.ApiResponse<BenchmarkList>> ListBenchmarksWithHttpInfoAsync(string? proctorVersion = default, System.Threading.CancellationToken cancellationToken = default)
        {

            Proctor.Client.Client.RequestOptions localVarRequestOptions = new Proctor.Client.Client.RequestOptions();

            string[] _contentTypes = new string[] {
            };

            // to determine the Accept header
            string[] _accepts = new string[] {
                "application/json",
                "application/problem+json"
            };


            var localVarContentType = Proctor.Client.Client.ClientUtils.SelectHeaderContentType(_contentTypes);
            if (localVarContentType != null) localVarRequestOptions.HeaderParameters.Add("Content-Type", localVarContentType);

            var localVarAccept = Proctor.Client.Client.ClientUtils.SelectHeaderAccept(_accepts);
            if (localVarAccept != null) localVarRequestOptions.HeaderParameters.Add("Accept", localVarAccept);

            if (proctorVersion != null)
            {
                localVarRequestOptions.HeaderParameters.Add("Proctor-Version", Proctor.Client.Client.ClientUtils.ParameterToString(proctorVersion)); // header parameter
            }

            // authentication (bearer) required
            // bearer authentication required
            if (!string.IsNullOrEmpty(this.Configuration.AccessToken) && !localVarRequestOptions.HeaderParameters.ContainsKey("Authorization"))
            {
                localVarRequestOptions.HeaderParameters.Add("Authorization", "Bearer " + this.Configuration.AccessToken);
            }

            // make the HTTP request

            var localVarResponse = await this.AsynchronousClient.GetAsync<BenchmarkList>("/v1/benchmarks", localVarRequestOptions, this.Configuration, cancellationToken).ConfigureAwait(false);

            if (this.ExceptionFactory != null)
            {
                Exception _exception = this.ExceptionFactory("ListBenchmarks", localVarResponse);
                if (_exception != null) throw _exception;
            }

            return localVarResponse;
        }

        /// <summary>
        /// Every episode with its result so far, in manifest order
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="cursor">&#x60;next_cursor&#x60; of the page before; opaque to the caller. (optional)</param>
        /// <param name="limit">Most items wanted on a page; 100 when absent. (optional)</param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <returns>EpisodeList</returns>
        public EpisodeList ListEpisodes(string runId, string? cursor = default, int? limit = default, string? proctorVersion = default)
        {
            Proctor.Client.Client.ApiResponse<EpisodeList> localVarResponse = ListEpisodesWithHttpInfo(runId, cursor, limit, proctorVersion);
            return localVarResponse.Data;
        }

        /// <summary>
        /// Every episode with its result so far, in manifest order
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="cursor">&#x60;next_cursor&#x60; of the page before; opaque to the caller. (optional)</param>
        /// <param name="limit">Most items wanted on a page; 100 when absent. (optional)</param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <returns>ApiResponse of EpisodeList</returns>
        public Proctor.Client.Client.ApiResponse<EpisodeList> ListEpisodesWithHttpInfo(string runId, string? cursor = default, int? limit = default, string? proctorVersion = default)
        {
            // verify the required parameter 'runId' is set
            if (runId == null)
                throw new Proctor.Client.Client.ApiException(400, "Missing required parameter 'runId' when calling ControlApi->ListEpisodes");

            Proctor.Client.Client.RequestOptions localVarRequestOptions = new Proctor.Client.Client.RequestOptions();

            string[] _contentTypes = new string[] {
            };

            // to determine the Accept header
            string[] _accepts = new string[] {
                "application/json",
                "application/problem+json"
            };

            var localVarContentType = Proctor.Client.Client.ClientUtils.SelectHeaderContentType(_contentTypes);
            if (localVarContentType != null) localVarRequestOptions.HeaderParameters.Add("Content-Type", localVarContentType);

            var localVarAccept = Proctor.Client.Client.ClientUtils.SelectHeaderAccept(_accepts);
            if (localVarAccept != null) localVarRequestOptions.HeaderParameters.Add("Accept", localVarAccept);

            localVarRequestOptions.PathParameters.Add("run_id", Proctor.Client.Client.ClientUtils.ParameterToString(runId)); // path parameter
            if (cursor != null)
            {
                localVarRequestOptions.QueryParameters.Add(Proctor.Client.Client.ClientUtils.ParameterToMultiMap("", "cursor", cursor));
            }
            if (limit != null)
            {
                localVarRequestOptions.QueryParameters.Add(Proctor.Client.Client.ClientUtils.ParameterToMultiMap("", "limit", limit));
            }
            if (proctorVersion != null)
            {
                localVarRequestOptions.HeaderParameters.Add("Proctor-Version", Proctor.Client.Client.ClientUtils.ParameterToString(proctorVersion)); // header parameter
            }

            // authentication (bearer) required
            // bearer authentication required
            if (!string.IsNullOrEmpty(this.Configuration.AccessToken) && !localVarRequestOptions.HeaderParameters.ContainsKey("Authorization"))
            {
                localVarRequestOptions.HeaderParameters.Add("Authorization", "Bearer " + this.Configuration.AccessToken);
            }

            // make the HTTP request
            var localVarResponse = this.Client.Get<EpisodeList>("/v1/runs/{run_id}/episodes", localVarRequestOptions, this.Configuration);

            if (this.ExceptionFactory != null)
            {
                Exception _exception = this.ExceptionFactory("ListEpisodes", localVarResponse);
                if (_exception != null) throw _exception;
            }

            return localVarResponse;
        }

        /// <summary>
        /// Every episode with its result so far, in manifest order
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="cursor">&#x60;next_cursor&#x60; of the page before; opaque to the caller. (optional)</param>
        /// <param name="limit">Most items wanted on a page; 100 when absent. (optional)</param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <param name="cancellationToken">Cancellation Token to cancel the request.</param>
        /// <returns>Task of EpisodeList</returns>
        public async System.Threading.Tasks.Task<EpisodeList> ListEpisodesAsync(string runId, string? cursor = default, int? limit = default, string? proctorVersion = default, System.Threading.CancellationToken cancellationToken = default)
        {
            Proctor.Client.Client.ApiResponse<EpisodeList> localVarResponse = await ListEpisodesWithHttpInfoAsync(runId, cursor, limit, proctorVersion, cancellationToken).ConfigureAwait(false);
            return localVarResponse.Data;
        }

        /// <summary>
        /// Every episode with its result so far, in manifest order
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="cursor">&#x60;next_cursor&#x60; of the page before; opaque to the caller. (optional)</param>
        /// <param name="limit">Most items wanted on a page; 100 when absent. (optional)</param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <param name="cancellationToken">Cancellation Token to cancel the request.</param>
        /// <returns>Task of ApiResponse (EpisodeList)</returns>
        public async System.Threading.Tasks.Task<Proctor.Client.Client.ApiResponse<EpisodeList>> ListEpisodesWithHttpInfoAsync(string runId, string? cursor = default, int? limit = default, string? proctorVersion = default, System.Threading.CancellationToken cancellationToken = default)
        {
            // verify the required parameter 'runId' is set
            if (runId == null)
                throw new Proctor.Client.Client.ApiException(400, "Missing required parameter 'runId' when calling ControlApi->ListEpisodes");


            Proctor.Client.Client.RequestOptions localVarRequestOptions = new Proctor.Client.Client.RequestOptions();

            string[] _contentTypes = new string[] {
            };

            // to determine the Accept header
            string[] _accepts = new string[] {
                "application/json",
                "application/problem+json"
            };


            var localVarContentType = Proctor.Client.Client.ClientUtils.SelectHeaderContentType(_contentTypes);
            if (localVarContentType != null) localVarRequestOptions.HeaderParameters.Add("Content-Type", localVarContentType);

            var localVarAccept = Proctor.Client.Client.ClientUtils.SelectHeaderAccept(_accepts);
            if (localVarAccept != null) localVarRequestOptions.HeaderParameters.Add("Accept", localVarAccept);

            localVarRequestOptions.PathParameters.Add("run_id", Proctor.Client.Client.ClientUtils.ParameterToString(runId)); // path parameter
            if (cursor != null)
            {
                localVarRequestOptions.QueryParameters.Add(Proctor.Client.Client.ClientUtils.ParameterToMultiMap("", "cursor", cursor));
            }
            if (limit != null)
            {
                localVarRequestOptions.QueryParameters.Add(Proctor.Client.Client.ClientUtils.ParameterToMultiMap("", "limit", limit));
            }
            if (proctorVersion != null)
            {
                localVarRequestOptions.HeaderParameters.Add("Proctor-Version", Proctor.Client.Client.ClientUtils.ParameterToString(proctorVersion)); // header parameter
            }

            // authentication (bearer) required
            // bearer authentication required
            if (!string.IsNullOrEmpty(this.Configuration.AccessToken) && !localVarRequestOptions.HeaderParameters.ContainsKey("Authorization"))
            {
                localVarRequestOptions.HeaderParameters.Add("Authorization", "Bearer " + this.Configuration.AccessToken);
            }

            // make the HTTP request

            var localVarResponse = await this.AsynchronousClient.GetAsync<EpisodeList>("/v1/runs/{run_id}/episodes", localVarRequestOptions, this.Configuration, cancellationToken).ConfigureAwait(false);

            if (this.ExceptionFactory != null)
            {
                Exception _exception = this.ExceptionFactory("ListEpisodes", localVarResponse);
                if (_exception != null) throw _exception;
            }

            return localVarResponse;
        }

        /// <summary>
        /// The caller&#39;s runs, newest first
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="cursor">&#x60;next_cursor&#x60; of the page before; opaque to the caller. (optional)</param>
        /// <param name="limit">Most items wanted on a page; 100 when absent. (optional)</param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <returns>RunList</returns>
        public RunList ListRuns(string? cursor = default, int? limit = default, string? proctorVersion = default)
        {
            Proctor.Client.Client.ApiResponse<RunList> localVarResponse = ListRunsWithHttpInfo(cursor, limit, proctorVersion);
            return localVarResponse.Data;
        }

        /// <summary>
        /// The caller&#39;s runs, newest first
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="cursor">&#x60;next_cursor&#x60; of the page before; opaque to the caller. (optional)</param>
        /// <param name="limit">Most items wanted on a page; 100 when absent. (optional)</param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <returns>ApiResponse of RunList</returns>
        public Proctor.Client.Client.ApiResponse<RunList> ListRunsWithHttpInfo(string? cursor = default, int? limit = default, string? proctorVersion = default)
        {
            Proctor.Client.Client.RequestOptions localVarRequestOptions = new Proctor.Client.Client.RequestOptions();

            string[] _contentTypes = new string[] {
            };

            // to determine the Accept header
            string[] _accepts = new string[] {
                "application/json",
                "application/problem+json"
            };

            var localVarContentType = Proctor.Client.Client.ClientUtils.SelectHeaderContentType(_contentTypes);
            if (localVarContentType != null) localVarRequestOptions.HeaderParameters.Add("Content-Type", localVarContentType);

            var localVarAccept = Proctor.Client.Client.ClientUtils.SelectHeaderAccept(_accepts);
            if (localVarAccept != null) localVarRequestOptions.HeaderParameters.Add("Accept", localVarAccept);

            if (cursor != null)
            {
                localVarRequestOptions.QueryParameters.Add(Proctor.Client.Client.ClientUtils.ParameterToMultiMap("", "cursor", cursor));
            }
            if (limit != null)
            {
                localVarRequestOptions.QueryParameters.Add(Proctor.Client.Client.ClientUtils.ParameterToMultiMap("", "limit", limit));
            }
            if (proctorVersion != null)
            {
                localVarRequestOptions.HeaderParameters.Add("Proctor-Version", Proctor.Client.Client.ClientUtils.ParameterToString(proctorVersion)); // header parameter
            }

            // authentication (bearer) required
            // bearer authentication required
            if (!string.IsNullOrEmpty(this.Configuration.AccessToken) && !localVarRequestOptions.HeaderParameters.ContainsKey("Authorization"))
            {
                localVarRequestOptions.HeaderParameters.Add("Authorization", "Bearer " + this.Configuration.AccessToken);
            }

            // make the HTTP request
            var localVarResponse = this.Client.Get<RunList>("/v1/runs", localVarRequestOptions, this.Configuration);

            if (this.ExceptionFactory != null)
            {
                Exception _exception = this.ExceptionFactory("ListRuns", localVarResponse);
                if (_exception != null) throw _exception;
            }

            return localVarResponse;
        }

        /// <summary>
        /// The caller&#39;s runs, newest first
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="cursor">&#x60;next_cursor&#x60; of the page before; opaque to the caller. (optional)</param>
        /// <param name="limit">Most items wanted on a page; 100 when absent. (optional)</param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <param name="cancellationToken">Cancellation Token to cancel the request.</param>
        /// <returns>Task of RunList</returns>
        public async System.Threading.Tasks.Task<RunList> ListRunsAsync(string? cursor = default, int? limit = default, string? proctorVersion = default, System.Threading.CancellationToken cancellationToken = default)
        {
            Proctor.Client.Client.ApiResponse<RunList> localVarResponse = await ListRunsWithHttpInfoAsync(cursor, limit, proctorVersion, cancellationToken).ConfigureAwait(false);
            return localVarResponse.Data;
        }

        /// <summary>
        /// The caller&#39;s runs, newest first
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="cursor">&#x60;next_cursor&#x60; of the page before; opaque to the caller. (optional)</param>
        /// <param name="limit">Most items wanted on a page; 100 when absent. (optional)</param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <param name="cancellationToken">Cancellation Token to cancel the request.</param>
        /// <returns>Task of ApiResponse (RunList)</returns>
        public async System.Threading.Tasks.Task<Proctor.Client.Client.ApiResponse<RunList>> ListRunsWithHttpInfoAsync(string? cursor = default, int? limit = default, string? proctorVersion = default, System.Threading.CancellationToken cancellationToken = default)
        {

            Proctor.Client.Client.RequestOptions localVarRequestOptions = new Proctor.Client.Client.RequestOptions();

            string[] _contentTypes = new string[] {
            };

            // to determine the Accept header
            string[] _accepts = new string[] {
                "application/json",
                "application/problem+json"
            };


            var localVarContentType = Proctor.Client.Client.ClientUtils.SelectHeaderContentType(_contentTypes);
            if (localVarContentType != null) localVarRequestOptions.HeaderParameters.Add("Content-Type", localVarContentType);

            var localVarAccept = Proctor.Client.Client.ClientUtils.SelectHeaderAccept(_accepts);
            if (localVarAccept != null) localVarRequestOptions.HeaderParameters.Add("Accept", localVarAccept);

            if (cursor != null)
            {
                localVarRequestOptions.QueryParameters.Add(Proctor.Client.Client.ClientUtils.ParameterToMultiMap("", "cursor", cursor));
            }
            if (limit != null)
            {
                localVarRequestOptions.QueryParameters.Add(Proctor.Client.Client.ClientUtils.ParameterToMultiMap("", "limit", limit));
            }
            if (proctorVersion != null)
            {
                localVarRequestOptions.HeaderParameters.Add("Proctor-Version", Proctor.Client.Client.ClientUtils.ParameterToString(proctorVersion)); // header parameter
            }

            // authentication (bearer) required
            // bearer authentication required
            if (!string.IsNullOrEmpty(this.Configuration.AccessToken) && !localVarRequestOptions.HeaderParameters.ContainsKey("Authorization"))
            {
                localVarRequestOptions.HeaderParameters.Add("Authorization", "Bearer " + this.Configuration.AccessToken);
            }

            // make the HTTP request

            var localVarResponse = await this.AsynchronousClient.GetAsync<RunList>("/v1/runs", localVarRequestOptions, this.Configuration, cancellationToken).ConfigureAwait(false);

            if (this.ExceptionFactory != null)
            {
                Exception _exception = this.ExceptionFactory("ListRuns", localVarResponse);
                if (_exception != null) throw _exception;
            }

            return localVarResponse;
        }

        /// <summary>
        /// Go on with the episodes that have no score yet
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <returns>Run</returns>
        public Run ResumeRun(string runId, string? proctorVersion = default)
        {
            Proctor.Client.Client.ApiResponse<Run> localVarResponse = ResumeRunWithHttpInfo(runId, proctorVersion);
            return localVarResponse.Data;
        }

        /// <summary>
        /// Go on with the episodes that have no score yet
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <returns>ApiResponse of Run</returns>
        public Proctor.Client.Client.ApiResponse<Run> ResumeRunWithHttpInfo(string runId, string? proctorVersion = default)
        {
            // verify the required parameter 'runId' is set
            if (runId == null)
                throw new Proctor.Client.Client.ApiException(400, "Missing required parameter 'runId' when calling ControlApi->ResumeRun");

            Proctor.Client.Client.RequestOptions localVarRequestOptions = new Proctor.Client.Client.RequestOptions();

            string[] _contentTypes = new string[] {
            };

            // to determine the Accept header
            string[] _accepts = new string[] {
                "application/json",
                "application/problem+json"
            };

            var localVarContentType = Proctor.Client.Client.ClientUtils.SelectHeaderContentType(_contentTypes);
            if (localVarContentType != null) localVarRequestOptions.HeaderParameters.Add("Content-Type", localVarContentType);

            var localVarAccept = Proctor.Client.Client.ClientUtils.SelectHeaderAccept(_accepts);
            if (localVarAccept != null) localVarRequestOptions.HeaderParameters.Add("Accept", localVarAccept);

            localVarRequestOptions.PathParameters.Add("run_id", Proctor.Client.Client.ClientUtils.ParameterToString(runId)); // path parameter
            if (proctorVersion != null)
            {
                localVarRequestOptions.HeaderParameters.Add("Proctor-Version", Proctor.Client.Client.ClientUtils.ParameterToString(proctorVersion)); // header parameter
            }

            // authentication (bearer) required
            // bearer authentication required
            if (!string.IsNullOrEmpty(this.Configuration.AccessToken) && !localVarRequestOptions.HeaderParameters.ContainsKey("Authorization"))
            {
                localVarRequestOptions.HeaderParameters.Add("Authorization", "Bearer " + this.Configuration.AccessToken);
            }

            // make the HTTP request
            var localVarResponse = this.Client.Post<Run>("/v1/runs/{run_id}/resume", localVarRequestOptions, this.Configuration);

            if (this.ExceptionFactory != null)
            {
                Exception _exception = this.ExceptionFactory("ResumeRun", localVarResponse);
                if (_exception != null) throw _exception;
            }

            return localVarResponse;
        }

        /// <summary>
        /// Go on with the episodes that have no score yet
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <param name="cancellationToken">Cancellation Token to cancel the request.</param>
        /// <returns>Task of Run</returns>
        public async System.Threading.Tasks.Task<Run> ResumeRunAsync(string runId, string? proctorVersion = default, System.Threading.CancellationToken cancellationToken = default)
        {
            Proctor.Client.Client.ApiResponse<Run> localVarResponse = await ResumeRunWithHttpInfoAsync(runId, proctorVersion, cancellationToken).ConfigureAwait(false);
            return localVarResponse.Data;
        }

        /// <summary>
        /// Go on with the episodes that have no score yet
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <param name="cancellationToken">Cancellation Token to cancel the request.</param>
        /// <returns>Task of ApiResponse (Run)</returns>
        public async System.Threading.Tasks.Task<Proctor.Client.Client.ApiResponse<Run>> ResumeRunWithHttpInfoAsync(string runId, string? proctorVersion = default, System.Threading.CancellationToken cancellationToken = default)
        {
            // verify the required parameter 'runId' is set
            if (runId == null)
                throw new Proctor.Client.Client.ApiException(400, "Missing required parameter 'runId' when calling ControlApi->ResumeRun");


            Proctor.Client.Client.RequestOptions localVarRequestOptions = new Proctor.Client.Client.RequestOptions();

            string[] _contentTypes = new string[] {
            };

            // to determine the Accept header
            string[] _accepts = new string[] {
                "application/json",
                "application/problem+json"
            };


            var localVarContentType = Proctor.Client.Client.ClientUtils.SelectHeaderContentType(_contentTypes);
            if (localVarContentType != null) localVarRequestOptions.HeaderParameters.Add("Content-Type", localVarContentType);

            var localVarAccept = Proctor.Client.Client.ClientUtils.SelectHeaderAccept(_accepts);
            if (localVarAccept != null) localVarRequestOptions.HeaderParameters.Add("Accept", localVarAccept);

            localVarRequestOptions.PathParameters.Add("run_id", Proctor.Client.Client.ClientUtils.ParameterToString(runId)); // path parameter
            if (proctorVersion != null)
            {
                localVarRequestOptions.HeaderParameters.Add("Proctor-Version", Proctor.Client.Client.ClientUtils.ParameterToString(proctorVersion)); // header parameter
            }

            // authentication (bearer) required
            // bearer authentication required
            if (!string.IsNullOrEmpty(this.Configuration.AccessToken) && !localVarRequestOptions.HeaderParameters.ContainsKey("Authorization"))
            {
                localVarRequestOptions.HeaderParameters.Add("Authorization", "Bearer " + this.Configuration.AccessToken);
            }

            // make the HTTP request

            var localVarResponse = await this.AsynchronousClient.PostAsync<Run>("/v1/runs/{run_id}/resume", localVarRequestOptions, this.Configuration, cancellationToken).ConfigureAwait(false);

            if (this.ExceptionFactory != null)
            {
                Exception _exception = this.ExceptionFactory("ResumeRun", localVarResponse);
                if (_exception != null) throw _exception;
            }

            return localVarResponse;
        }

        /// <summary>
        /// Stop now (abort) or after the episodes in play (drain)
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="stopRun"></param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <returns>Run</returns>
        public Run StopRun(string runId, StopRun stopRun, string? proctorVersion = default)
        {
            Proctor.Client.Client.ApiResponse<Run> localVarResponse = StopRunWithHttpInfo(runId, stopRun, proctorVersion);
            return localVarResponse.Data;
        }

        /// <summary>
        /// Stop now (abort) or after the episodes in play (drain)
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="stopRun"></param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <returns>ApiResponse of Run</returns>
        public Proctor.Client.Client.ApiResponse<Run> StopRunWithHttpInfo(string runId, StopRun stopRun, string? proctorVersion = default)
        {
            // verify the required parameter 'runId' is set
            if (runId == null)
                throw new Proctor.Client.Client.ApiException(400, "Missing required parameter 'runId' when calling ControlApi->StopRun");

            // verify the required parameter 'stopRun' is set
            if (stopRun == null)
                throw new Proctor.Client.Client.ApiException(400, "Missing required parameter 'stopRun' when calling ControlApi->StopRun");

            Proctor.Client.Client.RequestOptions localVarRequestOptions = new Proctor.Client.Client.RequestOptions();

            string[] _contentTypes = new string[] {
                "application/json"
            };

            // to determine the Accept header
            string[] _accepts = new string[] {
                "application/json",
                "application/problem+json"
            };

            var localVarContentType = Proctor.Client.Client.ClientUtils.SelectHeaderContentType(_contentTypes);
            if (localVarContentType != null) localVarRequestOptions.HeaderParameters.Add("Content-Type", localVarContentType);

            var localVarAccept = Proctor.Client.Client.ClientUtils.SelectHeaderAccept(_accepts);
            if (localVarAccept != null) localVarRequestOptions.HeaderParameters.Add("Accept", localVarAccept);

            localVarRequestOptions.PathParameters.Add("run_id", Proctor.Client.Client.ClientUtils.ParameterToString(runId)); // path parameter
            if (proctorVersion != null)
            {
                localVarRequestOptions.HeaderParameters.Add("Proctor-Version", Proctor.Client.Client.ClientUtils.ParameterToString(proctorVersion)); // header parameter
            }
            localVarRequestOptions.Data = stopRun;

            // authentication (bearer) required
            // bearer authentication required
            if (!string.IsNullOrEmpty(this.Configuration.AccessToken) && !localVarRequestOptions.HeaderParameters.ContainsKey("Authorization"))
            {
                localVarRequestOptions.HeaderParameters.Add("Authorization", "Bearer " + this.Configuration.AccessToken);
            }

            // make the HTTP request
            var localVarResponse = this.Client.Post<Run>("/v1/runs/{run_id}/stop", localVarRequestOptions, this.Configuration);

            if (this.ExceptionFactory != null)
            {
                Exception _exception = this.ExceptionFactory("StopRun", localVarResponse);
                if (_exception != null) throw _exception;
            }

            return localVarResponse;
        }

        /// <summary>
        /// Stop now (abort) or after the episodes in play (drain)
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="stopRun"></param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <param name="cancellationToken">Cancellation Token to cancel the request.</param>
        /// <returns>Task of Run</returns>
        public async System.Threading.Tasks.Task<Run> StopRunAsync(string runId, StopRun stopRun, string? proctorVersion = default, System.Threading.CancellationToken cancellationToken = default)
        {
            Proctor.Client.Client.ApiResponse<Run> localVarResponse = await StopRunWithHttpInfoAsync(runId, stopRun, proctorVersion, cancellationToken).ConfigureAwait(false);
            return localVarResponse.Data;
        }

        /// <summary>
        /// Stop now (abort) or after the episodes in play (drain)
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="stopRun"></param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <param name="cancellationToken">Cancellation Token to cancel the request.</param>
        /// <returns>Task of ApiResponse (Run)</returns>
        public async System.Threading.Tasks.Task<Proctor.Client.Client.ApiResponse<Run>> StopRunWithHttpInfoAsync(string runId, StopRun stopRun, string? proctorVersion = default, System.Threading.CancellationToken cancellationToken = default)
        {
            // verify the required parameter 'runId' is set
            if (runId == null)
                throw new Proctor.Client.Client.ApiException(400, "Missing required parameter 'runId' when calling ControlApi->StopRun");

            // verify the required parameter 'stopRun' is set
            if (stopRun == null)
                throw new Proctor.Client.Client.ApiException(400, "Missing required parameter 'stopRun' when calling ControlApi->StopRun");


            Proctor.Client.Client.RequestOptions localVarRequestOptions = new Proctor.Client.Client.RequestOptions();

            string[] _contentTypes = new string[] {
                "application/json"
            };

            // to determine the Accept header
            string[] _accepts = new string[] {
                "application/json",
                "application/problem+json"
            };


            var localVarContentType = Proctor.Client.Client.ClientUtils.SelectHeaderContentType(_contentTypes);
            if (localVarContentType != null) localVarRequestOptions.HeaderParameters.Add("Content-Type", localVarContentType);

            var localVarAccept = Proctor.Client.Client.ClientUtils.SelectHeaderAccept(_accepts);
            if (localVarAccept != null) localVarRequestOptions.HeaderParameters.Add("Accept", localVarAccept);

            localVarRequestOptions.PathParameters.Add("run_id", Proctor.Client.Client.ClientUtils.ParameterToString(runId)); // path parameter
            if (proctorVersion != null)
            {
                localVarRequestOptions.HeaderParameters.Add("Proctor-Version", Proctor.Client.Client.ClientUtils.ParameterToString(proctorVersion)); // header parameter
            }
            localVarRequestOptions.Data = stopRun;

            // authentication (bearer) required
            // bearer authentication required
            if (!string.IsNullOrEmpty(this.Configuration.AccessToken) && !localVarRequestOptions.HeaderParameters.ContainsKey("Authorization"))
            {
                localVarRequestOptions.HeaderParameters.Add("Authorization", "Bearer " + this.Configuration.AccessToken);
            }

            // make the HTTP request

            var localVarResponse = await this.AsynchronousClient.PostAsync<Run>("/v1/runs/{run_id}/stop", localVarRequestOptions, this.Configuration, cancellationToken).ConfigureAwait(false);

            if (this.ExceptionFactory != null)
            {
                Exception _exception = this.ExceptionFactory("StopRun", localVarResponse);
                if (_exception != null) throw _exception;
            }

            return localVarResponse;
        }

        /// <summary>
        /// Ask for one evaluation of one policy on one benchmark
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="submitRun"></param>
        /// <param name="idempotencyKey">Makes a repeated submit return the first run instead of making another. One that breaks the pattern is refused with &#x60;invalid_request&#x60;. (optional)</param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <returns>Run</returns>
        public Run SubmitRun(SubmitRun submitRun, string? idempotencyKey = default, string? proctorVersion = default)
        {
            Proctor.Client.Client.ApiResponse<Run> localVarResponse = SubmitRunWithHttpInfo(submitRun, idempotencyKey, proctorVersion);
            return localVarResponse.Data;
        }

        /// <summary>
        /// Ask for one evaluation of one policy on one benchmark
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="submitRun"></param>
        /// <param name="idempotencyKey">Makes a repeated submit return the first run instead of making another. One that breaks the pattern is refused with &#x60;invalid_request&#x60;. (optional)</param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <returns>ApiResponse of Run</returns>
        public Proctor.Client.Client.ApiResponse<Run> SubmitRunWithHttpInfo(SubmitRun submitRun, string? idempotencyKey = default, string? proctorVersion = default)
        {
            // verify the required parameter 'submitRun' is set
            if (submitRun == null)
                throw new Proctor.Client.Client.ApiException(400, "Missing required parameter 'submitRun' when calling ControlApi->SubmitRun");

            Proctor.Client.Client.RequestOptions localVarRequestOptions = new Proctor.Client.Client.RequestOptions();

            string[] _contentTypes = new string[] {
                "application/json"
            };

            // to determine the Accept header
            string[] _accepts = new string[] {
                "application/json",
                "application/problem+json"
            };

            var localVarContentType = Proctor.Client.Client.ClientUtils.SelectHeaderContentType(_contentTypes);
            if (localVarContentType != null) localVarRequestOptions.HeaderParameters.Add("Content-Type", localVarContentType);

            var localVarAccept = Proctor.Client.Client.ClientUtils.SelectHeaderAccept(_accepts);
            if (localVarAccept != null) localVarRequestOptions.HeaderParameters.Add("Accept", localVarAccept);

            if (idempotencyKey != null)
            {
                localVarRequestOptions.HeaderParameters.Add("Idempotency-Key", Proctor.Client.Client.ClientUtils.ParameterToString(idempotencyKey)); // header parameter
            }
            if (proctorVersion != null)
            {
                localVarRequestOptions.HeaderParameters.Add("Proctor-Version", Proctor.Client.Client.ClientUtils.ParameterToString(proctorVersion)); // header parameter
            }
            localVarRequestOptions.Data = submitRun;

            // authentication (bearer) required
            // bearer authentication required
            if (!string.IsNullOrEmpty(this.Configuration.AccessToken) && !localVarRequestOptions.HeaderParameters.ContainsKey("Authorization"))
            {
                localVarRequestOptions.HeaderParameters.Add("Authorization", "Bearer " + this.Configuration.AccessToken);
            }

            // make the HTTP request
            var localVarResponse = this.Client.Post<Run>("/v1/runs", localVarRequestOptions, this.Configuration);

            if (this.ExceptionFactory != null)
            {
                Exception _exception = this.ExceptionFactory("SubmitRun", localVarResponse);
                if (_exception != null) throw _exception;
            }

            return localVarResponse;
        }

        /// <summary>
        /// Ask for one evaluation of one policy on one benchmark
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="submitRun"></param>
        /// <param name="idempotencyKey">Makes a repeated submit return the first run instead of making another. One that breaks the pattern is refused with &#x60;invalid_request&#x60;. (optional)</param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <param name="cancellationToken">Cancellation Token to cancel the request.</param>
        /// <returns>Task of Run</returns>
        public async System.Threading.Tasks.Task<Run> SubmitRunAsync(SubmitRun submitRun, string? idempotencyKey = default, string? proctorVersion = default, System.Threading.CancellationToken cancellationToken = default)
        {
            Proctor.Client.Client.ApiResponse<Run> localVarResponse = await SubmitRunWithHttpInfoAsync(submitRun, idempotencyKey, proctorVersion, cancellationToken).ConfigureAwait(false);
            return localVarResponse.Data;
        }

        /// <summary>
        /// Ask for one evaluation of one policy on one benchmark
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="submitRun"></param>
        /// <param name="idempotencyKey">Makes a repeated submit return the first run instead of making another. One that breaks the pattern is refused with &#x60;invalid_request&#x60;. (optional)</param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <param name="cancellationToken">Cancellation Token to cancel the request.</param>
        /// <returns>Task of ApiResponse (Run)</returns>
        public async System.Threading.Tasks.Task<Proctor.Client.Client.ApiResponse<Run>> SubmitRunWithHttpInfoAsync(SubmitRun submitRun, string? idempotencyKey = default, string? proctorVersion = default, System.Threading.CancellationToken cancellationToken = default)
        {
            // verify the required parameter 'submitRun' is set
            if (submitRun == null)
                throw new Proctor.Client.Client.ApiException(400, "Missing required parameter 'submitRun' when calling ControlApi->SubmitRun");


            Proctor.Client.Client.RequestOptions localVarRequestOptions = new Proctor.Client.Client.RequestOptions();

            string[] _contentTypes = new string[] {
                "application/json"
            };

            // to determine the Accept header
            string[] _accepts = new string[] {
                "application/json",
                "application/problem+json"
            };


            var localVarContentType = Proctor.Client.Client.ClientUtils.SelectHeaderContentType(_contentTypes);
            if (localVarContentType != null) localVarRequestOptions.HeaderParameters.Add("Content-Type", localVarContentType);

            var localVarAccept = Proctor.Client.Client.ClientUtils.SelectHeaderAccept(_accepts);
            if (localVarAccept != null) localVarRequestOptions.HeaderParameters.Add("Accept", localVarAccept);

            if (idempotencyKey != null)
            {
                localVarRequestOptions.HeaderParameters.Add("Idempotency-Key", Proctor.Client.Client.ClientUtils.ParameterToString(idempotencyKey)); // header parameter
            }
            if (proctorVersion != null)
            {
                localVarRequestOptions.HeaderParameters.Add("Proctor-Version", Proctor.Client.Client.ClientUtils.ParameterToString(proctorVersion)); // header parameter
            }
            localVarRequestOptions.Data = submitRun;

            // authentication (bearer) required
            // bearer authentication required
            if (!string.IsNullOrEmpty(this.Configuration.AccessToken) && !localVarRequestOptions.HeaderParameters.ContainsKey("Authorization"))
            {
                localVarRequestOptions.HeaderParameters.Add("Authorization", "Bearer " + this.Configuration.AccessToken);
            }

            // make the HTTP request

            var localVarResponse = await this.AsynchronousClient.PostAsync<Run>("/v1/runs", localVarRequestOptions, this.Configuration, cancellationToken).ConfigureAwait(false);

            if (this.ExceptionFactory != null)
            {
                Exception _exception = this.ExceptionFactory("SubmitRun", localVarResponse);
                if (_exception != null) throw _exception;
            }

            return localVarResponse;
        }

    }
}
