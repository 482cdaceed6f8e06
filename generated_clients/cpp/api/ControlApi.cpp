/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#include "ControlApi.h"

namespace proctor {

Comparison ControlApi::compareRuns(std::string const& baseline, std::string const& runs, std::optional<double> const& tolerance, std::optional<std::string> const& proctorVersion) {
    Request request{"GET", "/v1/comparisons"};
    request.query_parameter("baseline", baseline);
    request.query_parameter("runs", runs);
    request.query_parameter("tolerance", tolerance);
    request.header("Proctor-Version", proctorVersion);
    return m_connection->receive<Comparison>(request);
}

void ControlApi::deleteImport(std::string const& importId, std::optional<std::string> const& proctorVersion) {
    Request request{"DELETE", "/v1/records/{import_id}"};
    request.path_parameter("import_id", importId);
    request.header("Proctor-Version", proctorVersion);
    m_connection->send(request);
}

RecordImport ControlApi::getImport(std::string const& importId, std::optional<std::string> const& proctorVersion) {
    Request request{"GET", "/v1/records/{import_id}"};
    request.path_parameter("import_id", importId);
    request.header("Proctor-Version", proctorVersion);
    return m_connection->receive<RecordImport>(request);
}

void ControlApi::deleteRun(std::string const& runId, std::optional<std::string> const& proctorVersion) {
    Request request{"DELETE", "/v1/runs/{run_id}"};
    request.path_parameter("run_id", runId);
    request.header("Proctor-Version", proctorVersion);
    m_connection->send(request);
}

Run ControlApi::getRun(std::string const& runId, std::optional<std::string> const& ifNoneMatch, std::optional<std::string> const& prefer, std::optional<std::string> const& proctorVersion) {
    Request request{"GET", "/v1/runs/{run_id}"};
    request.path_parameter("run_id", runId);
    request.header("If-None-Match", ifNoneMatch);
    request.header("Prefer", prefer);
    request.header("Proctor-Version", proctorVersion);
    return m_connection->receive<Run>(request);
}

Service ControlApi::describeService(std::optional<std::string> const& proctorVersion) {
    Request request{"GET", "/v1"};
    request.header("Proctor-Version", proctorVersion);
    return m_connection->receive<Service>(request);
}

BoardEntry ControlApi::flagEntry(std::string const& entryId, FlagEntry const& flagEntry, std::optional<std::string> const& proctorVersion) {
    Request request{"PUT", "/v1/entries/{entry_id}/flag"};
    request.path_parameter("entry_id", entryId);
    request.header("Proctor-Version", proctorVersion);
    request.body = nlohmann::json(flagEntry).dump();
    return m_connection->receive<BoardEntry>(request);
}

Benchmark ControlApi::getBenchmark(std::string const& benchmarkId, std::optional<std::string> const& proctorVersion) {
    Request request{"GET", "/v1/benchmarks/{benchmark_id}"};
    request.path_parameter("benchmark_id", benchmarkId);
    request.header("Proctor-Version", proctorVersion);
    return m_connection->receive<Benchmark>(request);
}

Checkpoint ControlApi::getCheckpoint(std::optional<std::string> const& proctorVersion) {
    Request request{"GET", "/v1/history/checkpoint"};
    request.header("Proctor-Version", proctorVersion);
    return m_connection->receive<Checkpoint>(request);
}

BoardEntry ControlApi::getEntry(std::string const& entryId, std::optional<std::string> const& proctorVersion) {
    Request request{"GET", "/v1/entries/{entry_id}"};
    request.path_parameter("entry_id", entryId);
    request.header("Proctor-Version", proctorVersion);
    return m_connection->receive<BoardEntry>(request);
}

Ranking ControlApi::getRanking(std::string const& benchmarkId, std::optional<std::string> const& manifestSha256, std::optional<std::string> const& cursor, std::optional<std::int32_t> const& limit, std::optional<std::string> const& proctorVersion) {
    Request request{"GET", "/v1/benchmarks/{benchmark_id}/ranking"};
    request.path_parameter("benchmark_id", benchmarkId);
    request.query_parameter("manifest_sha256", manifestSha256);
    request.query_parameter("cursor", cursor);
    request.query_parameter("limit", limit);
    request.header("Proctor-Version", proctorVersion);
    return m_connection->receive<Ranking>(request);
}

Score ControlApi::getScore(std::string const& runId, std::optional<std::string> const& proctorVersion) {
    Request request{"GET", "/v1/runs/{run_id}/score"};
    request.path_parameter("run_id", runId);
    request.header("Proctor-Version", proctorVersion);
    return m_connection->receive<Score>(request);
}

RecordImport ControlApi::importRecord(std::string const& body, std::optional<std::string> const& proctorVersion) {
    Request request{"POST", "/v1/records"};
    request.header("Proctor-Version", proctorVersion);
    request.body = nlohmann::json(body).dump();
    return m_connection->receive<RecordImport>(request);
}

RecordImportList ControlApi::listImports(std::optional<std::string> const& cursor, std::optional<std::int32_t> const& limit, std::optional<std::string> const& proctorVersion) {
    Request request{"GET", "/v1/records"};
    request.query_parameter("cursor", cursor);
    request.query_parameter("limit", limit);
    request.header("Proctor-Version", proctorVersion);
    return m_connection->receive<RecordImportList>(request);
}

BenchmarkList ControlApi::listBenchmarks(std::optional<std::string> const& proctorVersion) {
    Request request{"GET", "/v1/benchmarks"};
    request.header("Proctor-Version", proctorVersion);
    return m_connection->receive<BenchmarkList>(request);
}

BoardEntryList ControlApi::listEntries(std::optional<std::string> const& benchmarkId, std::optional<std::string> const& cursor, std::optional<std::int32_t> const& limit, std::optional<std::string> const& proctorVersion) {
    Request request{"GET", "/v1/entries"};
    request.query_parameter("benchmark_id", benchmarkId);
    request.query_parameter("cursor", cursor);
    request.query_parameter("limit", limit);
    request.header("Proctor-Version", proctorVersion);
    return m_connection->receive<BoardEntryList>(request);
}

EpisodeList ControlApi::listEpisodes(std::string const& runId, std::optional<std::string> const& cursor, std::optional<std::int32_t> const& limit, std::optional<std::string> const& proctorVersion) {
    Request request{"GET", "/v1/runs/{run_id}/episodes"};
    request.path_parameter("run_id", runId);
    request.query_parameter("cursor", cursor);
    request.query_parameter("limit", limit);
    request.header("Proctor-Version", proctorVersion);
    return m_connection->receive<EpisodeList>(request);
}

HistoryPage ControlApi::listHistory(std::optional<std::string> const& cursor, std::optional<std::int32_t> const& limit, std::optional<std::string> const& proctorVersion) {
    Request request{"GET", "/v1/history"};
    request.query_parameter("cursor", cursor);
    request.query_parameter("limit", limit);
    request.header("Proctor-Version", proctorVersion);
    return m_connection->receive<HistoryPage>(request);
}

KeyList ControlApi::listKeys(std::optional<std::string> const& proctorVersion) {
    Request request{"GET", "/v1/keys"};
    request.header("Proctor-Version", proctorVersion);
    return m_connection->receive<KeyList>(request);
}

RunList ControlApi::listRuns(std::optional<std::string> const& cursor, std::optional<std::int32_t> const& limit, std::optional<std::string> const& proctorVersion) {
    Request request{"GET", "/v1/runs"};
    request.query_parameter("cursor", cursor);
    request.query_parameter("limit", limit);
    request.header("Proctor-Version", proctorVersion);
    return m_connection->receive<RunList>(request);
}

Run ControlApi::submitRun(SubmitRun const& submitRun, std::optional<std::string> const& idempotencyKey, std::optional<std::string> const& proctorVersion) {
    Request request{"POST", "/v1/runs"};
    request.header("Idempotency-Key", idempotencyKey);
    request.header("Proctor-Version", proctorVersion);
    request.body = nlohmann::json(submitRun).dump();
    return m_connection->receive<Run>(request);
}

ConsistencyProof ControlApi::proveConsistency(std::string const& oldSize, std::string const& newSize, std::optional<std::string> const& proctorVersion) {
    Request request{"GET", "/v1/history/consistency"};
    request.query_parameter("old_size", oldSize);
    request.query_parameter("new_size", newSize);
    request.header("Proctor-Version", proctorVersion);
    return m_connection->receive<ConsistencyProof>(request);
}

InclusionProof ControlApi::proveInclusion(std::string const& leafIndex, std::string const& treeSize, std::optional<std::string> const& proctorVersion) {
    Request request{"GET", "/v1/history/inclusion"};
    request.query_parameter("leaf_index", leafIndex);
    request.query_parameter("tree_size", treeSize);
    request.header("Proctor-Version", proctorVersion);
    return m_connection->receive<InclusionProof>(request);
}

BoardEntry ControlApi::publishEntry(std::string const& runId, PublishEntry const& publishEntry, std::optional<std::string> const& proctorVersion) {
    Request request{"PUT", "/v1/runs/{run_id}/entry"};
    request.path_parameter("run_id", runId);
    request.header("Proctor-Version", proctorVersion);
    request.body = nlohmann::json(publishEntry).dump();
    return m_connection->receive<BoardEntry>(request);
}

BoardEntry ControlApi::withdrawEntry(std::string const& runId, std::optional<std::string> const& proctorVersion) {
    Request request{"DELETE", "/v1/runs/{run_id}/entry"};
    request.path_parameter("run_id", runId);
    request.header("Proctor-Version", proctorVersion);
    return m_connection->receive<BoardEntry>(request);
}

Run ControlApi::resumeRun(std::string const& runId, std::optional<std::string> const& proctorVersion) {
    Request request{"POST", "/v1/runs/{run_id}/resume"};
    request.path_parameter("run_id", runId);
    request.header("Proctor-Version", proctorVersion);
    return m_connection->receive<Run>(request);
}

Run ControlApi::stopRun(std::string const& runId, StopRun const& stopRun, std::optional<std::string> const& proctorVersion) {
    Request request{"POST", "/v1/runs/{run_id}/stop"};
    request.path_parameter("run_id", runId);
    request.header("Proctor-Version", proctorVersion);
    request.body = nlohmann::json(stopRun).dump();
    return m_connection->receive<Run>(request);
}

} // namespace proctor
