/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

/** Each call waits for its answer, and throws [ProctorException]. Any number of threads may call. */
class ControlApi(private val connection: Connection) {
    /** Runs beside a baseline, episode by episode */
    fun compareRuns(baseline: String, runs: String, tolerance: Double? = null, proctorVersion: String? = null): Comparison {
        val request = Request("GET", "/v1/comparisons")
        request.query("baseline", baseline)
        request.query("runs", runs)
        request.query("tolerance", tolerance)
        request.header("Proctor-Version", proctorVersion)
        return connection.receive(request)
    }

    /** Remove a record that was handed in */
    fun deleteImport(importId: String, proctorVersion: String? = null) {
        val request = Request("DELETE", "/v1/records/{import_id}")
        request.path("import_id", importId)
        request.header("Proctor-Version", proctorVersion)
        connection.send(request)
    }

    /** Delete a run that is not in play, with all that is stored of it */
    fun deleteRun(runId: String, proctorVersion: String? = null) {
        val request = Request("DELETE", "/v1/runs/{run_id}")
        request.path("run_id", runId)
        request.header("Proctor-Version", proctorVersion)
        connection.send(request)
    }

    /** What this server is, speaks and allows */
    fun describeService(proctorVersion: String? = null): Service {
        val request = Request("GET", "/v1")
        request.header("Proctor-Version", proctorVersion)
        return connection.receive(request)
    }

    /** Say of a public entry that something is wrong with it, or take that back */
    fun flagEntry(entryId: String, flagEntry: FlagEntry, proctorVersion: String? = null): BoardEntry {
        val request = Request("PUT", "/v1/entries/{entry_id}/flag")
        request.path("entry_id", entryId)
        request.header("Proctor-Version", proctorVersion)
        request.body = json.encodeToString(flagEntry)
        return connection.receive(request)
    }

    /** One benchmark with its spaces, conventions and rules */
    fun getBenchmark(benchmarkId: String, proctorVersion: String? = null): Benchmark {
        val request = Request("GET", "/v1/benchmarks/{benchmark_id}")
        request.path("benchmark_id", benchmarkId)
        request.header("Proctor-Version", proctorVersion)
        return connection.receive(request)
    }

    /** The size and the root of the history, signed */
    fun getCheckpoint(proctorVersion: String? = null): Checkpoint {
        val request = Request("GET", "/v1/history/checkpoint")
        request.header("Proctor-Version", proctorVersion)
        return connection.receive(request)
    }

    /** One entry, withdrawn or not */
    fun getEntry(entryId: String, proctorVersion: String? = null): BoardEntry {
        val request = Request("GET", "/v1/entries/{entry_id}")
        request.path("entry_id", entryId)
        request.header("Proctor-Version", proctorVersion)
        return connection.receive(request)
    }

    /** What is known here of a record that was handed in */
    fun getImport(importId: String, proctorVersion: String? = null): RecordImport {
        val request = Request("GET", "/v1/records/{import_id}")
        request.path("import_id", importId)
        request.header("Proctor-Version", proctorVersion)
        return connection.receive(request)
    }

    /** The public entries of one manifest, ranked */
    fun getRanking(benchmarkId: String, manifestSha256: String? = null, cursor: String? = null, limit: Int? = null, proctorVersion: String? = null): Ranking {
        val request = Request("GET", "/v1/benchmarks/{benchmark_id}/ranking")
        request.path("benchmark_id", benchmarkId)
        request.query("manifest_sha256", manifestSha256)
        request.query("cursor", cursor)
        request.query("limit", limit)
        request.header("Proctor-Version", proctorVersion)
        return connection.receive(request)
    }

    /** State, progress and the reason for both; can wait for a change */
    fun getRun(runId: String, ifNoneMatch: String? = null, prefer: String? = null, proctorVersion: String? = null): Run {
        val request = Request("GET", "/v1/runs/{run_id}")
        request.path("run_id", runId)
        request.header("If-None-Match", ifNoneMatch)
        request.header("Prefer", prefer)
        request.header("Proctor-Version", proctorVersion)
        return connection.receive(request)
    }

    /** The score, or its bounds while episodes are missing */
    fun getScore(runId: String, proctorVersion: String? = null): Score {
        val request = Request("GET", "/v1/runs/{run_id}/score")
        request.path("run_id", runId)
        request.header("Proctor-Version", proctorVersion)
        return connection.receive(request)
    }

    /** Hand in a record of any host, to be verified and replayed here */
    fun importRecord(body: String, proctorVersion: String? = null): RecordImport {
        val request = Request("POST", "/v1/records")
        request.header("Proctor-Version", proctorVersion)
        request.body = json.encodeToString(body)
        return connection.receive(request)
    }

    /** The benchmarks offered here */
    fun listBenchmarks(proctorVersion: String? = null): BenchmarkList {
        val request = Request("GET", "/v1/benchmarks")
        request.header("Proctor-Version", proctorVersion)
        return connection.receive(request)
    }

    /** Entries of the leaderboard, newest first */
    fun listEntries(benchmarkId: String? = null, cursor: String? = null, limit: Int? = null, proctorVersion: String? = null): BoardEntryList {
        val request = Request("GET", "/v1/entries")
        request.query("benchmark_id", benchmarkId)
        request.query("cursor", cursor)
        request.query("limit", limit)
        request.header("Proctor-Version", proctorVersion)
        return connection.receive(request)
    }

    /** Every episode with its result so far, in manifest order */
    fun listEpisodes(runId: String, cursor: String? = null, limit: Int? = null, proctorVersion: String? = null): EpisodeList {
        val request = Request("GET", "/v1/runs/{run_id}/episodes")
        request.path("run_id", runId)
        request.query("cursor", cursor)
        request.query("limit", limit)
        request.header("Proctor-Version", proctorVersion)
        return connection.receive(request)
    }

    /** What happened to public entries, oldest first */
    fun listHistory(cursor: String? = null, limit: Int? = null, proctorVersion: String? = null): HistoryPage {
        val request = Request("GET", "/v1/history")
        request.query("cursor", cursor)
        request.query("limit", limit)
        request.header("Proctor-Version", proctorVersion)
        return connection.receive(request)
    }

    /** The records that the account handed in, newest first */
    fun listImports(cursor: String? = null, limit: Int? = null, proctorVersion: String? = null): RecordImportList {
        val request = Request("GET", "/v1/records")
        request.query("cursor", cursor)
        request.query("limit", limit)
        request.header("Proctor-Version", proctorVersion)
        return connection.receive(request)
    }

    /** The public keys with which this host signs records */
    fun listKeys(proctorVersion: String? = null): KeyList {
        val request = Request("GET", "/v1/keys")
        request.header("Proctor-Version", proctorVersion)
        return connection.receive(request)
    }

    /** The caller's runs, newest first */
    fun listRuns(cursor: String? = null, limit: Int? = null, proctorVersion: String? = null): RunList {
        val request = Request("GET", "/v1/runs")
        request.query("cursor", cursor)
        request.query("limit", limit)
        request.header("Proctor-Version", proctorVersion)
        return connection.receive(request)
    }

    /** Proof that a history of one size begins with that of another */
    fun proveConsistency(oldSize: String, newSize: String, proctorVersion: String? = null): ConsistencyProof {
        val request = Request("GET", "/v1/history/consistency")
        request.query("old_size", oldSize)
        request.query("new_size", newSize)
        request.header("Proctor-Version", proctorVersion)
        return connection.receive(request)
    }

    /** Proof that a leaf stands in the history of a size */
    fun proveInclusion(leafIndex: String, treeSize: String, proctorVersion: String? = null): InclusionProof {
        val request = Request("GET", "/v1/history/inclusion")
        request.query("leaf_index", leafIndex)
        request.query("tree_size", treeSize)
        request.header("Proctor-Version", proctorVersion)
        return connection.receive(request)
    }

    /** Publish a completed run on the leaderboard, or change what its entry says */
    fun publishEntry(runId: String, publishEntry: PublishEntry, proctorVersion: String? = null): BoardEntry {
        val request = Request("PUT", "/v1/runs/{run_id}/entry")
        request.path("run_id", runId)
        request.header("Proctor-Version", proctorVersion)
        request.body = json.encodeToString(publishEntry)
        return connection.receive(request)
    }

    /** Go on with the episodes that have no score yet */
    fun resumeRun(runId: String, proctorVersion: String? = null): Run {
        val request = Request("POST", "/v1/runs/{run_id}/resume")
        request.path("run_id", runId)
        request.header("Proctor-Version", proctorVersion)
        return connection.receive(request)
    }

    /** Stop now (abort) or after the episodes in play (drain) */
    fun stopRun(runId: String, stopRun: StopRun, proctorVersion: String? = null): Run {
        val request = Request("POST", "/v1/runs/{run_id}/stop")
        request.path("run_id", runId)
        request.header("Proctor-Version", proctorVersion)
        request.body = json.encodeToString(stopRun)
        return connection.receive(request)
    }

    /** Ask for one evaluation of one policy on one benchmark */
    fun submitRun(submitRun: SubmitRun, idempotencyKey: String? = null, proctorVersion: String? = null): Run {
        val request = Request("POST", "/v1/runs")
        request.header("Idempotency-Key", idempotencyKey)
        request.header("Proctor-Version", proctorVersion)
        request.body = json.encodeToString(submitRun)
        return connection.receive(request)
    }

    /** Take the entry of a run off the leaderboard, for good */
    fun withdrawEntry(runId: String, proctorVersion: String? = null): BoardEntry {
        val request = Request("DELETE", "/v1/runs/{run_id}/entry")
        request.path("run_id", runId)
        request.header("Proctor-Version", proctorVersion)
        return connection.receive(request)
    }
}
