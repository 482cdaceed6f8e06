/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <memory>

#include "../connection.h"

namespace proctor {

/// Each call throws Refused when the server refuses it, ConnectionError when no answer came, InvalidAnswer
/// when what came is not the message expected.
class ControlApi {
public:
    explicit ControlApi(std::shared_ptr<Connection> connection) : m_connection(std::move(connection)) {}

    /// Compare runs with a baseline
    Comparison compareRuns(std::string const& baseline, std::string const& runs, std::optional<double> const& tolerance = {}, std::optional<std::string> const& proctorVersion = {});

    /// Delete an imported record
    void deleteImport(std::string const& importId, std::optional<std::string> const& proctorVersion = {});

    /// Get an imported record
    RecordImport getImport(std::string const& importId, std::optional<std::string> const& proctorVersion = {});

    /// Delete a run
    void deleteRun(std::string const& runId, std::optional<std::string> const& proctorVersion = {});

    /// Get a run, or wait for its next change
    Run getRun(std::string const& runId, std::optional<std::string> const& ifNoneMatch = {}, std::optional<std::string> const& prefer = {}, std::optional<std::string> const& proctorVersion = {});

    /// Describe the service
    Service describeService(std::optional<std::string> const& proctorVersion = {});

    /// Flag an entry, or remove its flag
    BoardEntry flagEntry(std::string const& entryId, FlagEntry const& flagEntry, std::optional<std::string> const& proctorVersion = {});

    /// Get a benchmark
    Benchmark getBenchmark(std::string const& benchmarkId, std::optional<std::string> const& proctorVersion = {});

    /// Get the signed checkpoint of the history
    Checkpoint getCheckpoint(std::optional<std::string> const& proctorVersion = {});

    /// Get an entry
    BoardEntry getEntry(std::string const& entryId, std::optional<std::string> const& proctorVersion = {});

    /// Get the ranking of a benchmark
    Ranking getRanking(std::string const& benchmarkId, std::optional<std::string> const& manifestSha256 = {}, std::optional<std::string> const& cursor = {}, std::optional<std::int32_t> const& limit = {}, std::optional<std::string> const& proctorVersion = {});

    /// Get the score of a run
    Score getScore(std::string const& runId, std::optional<std::string> const& proctorVersion = {});

    /// Import a record
    RecordImport importRecord(std::string const& body, std::optional<std::string> const& proctorVersion = {});

    /// List imported records
    RecordImportList listImports(std::optional<std::string> const& cursor = {}, std::optional<std::int32_t> const& limit = {}, std::optional<std::string> const& proctorVersion = {});

    /// List the benchmarks
    BenchmarkList listBenchmarks(std::optional<std::string> const& proctorVersion = {});

    /// List entries of the leaderboard
    BoardEntryList listEntries(std::optional<std::string> const& benchmarkId = {}, std::optional<std::string> const& cursor = {}, std::optional<std::int32_t> const& limit = {}, std::optional<std::string> const& proctorVersion = {});

    /// List the episodes of a run
    EpisodeList listEpisodes(std::string const& runId, std::optional<std::string> const& cursor = {}, std::optional<std::int32_t> const& limit = {}, std::optional<std::string> const& proctorVersion = {});

    /// List the history
    HistoryPage listHistory(std::optional<std::string> const& cursor = {}, std::optional<std::int32_t> const& limit = {}, std::optional<std::string> const& proctorVersion = {});

    /// List the signing keys
    KeyList listKeys(std::optional<std::string> const& proctorVersion = {});

    /// List runs
    RunList listRuns(std::optional<std::string> const& cursor = {}, std::optional<std::int32_t> const& limit = {}, std::optional<std::string> const& proctorVersion = {});

    /// Submit a run
    Run submitRun(SubmitRun const& submitRun, std::optional<std::string> const& idempotencyKey = {}, std::optional<std::string> const& proctorVersion = {});

    /// Prove that the history only grew
    ConsistencyProof proveConsistency(std::string const& oldSize, std::string const& newSize, std::optional<std::string> const& proctorVersion = {});

    /// Prove that a leaf is in the history
    InclusionProof proveInclusion(std::string const& leafIndex, std::string const& treeSize, std::optional<std::string> const& proctorVersion = {});

    /// Publish a run on the leaderboard
    BoardEntry publishEntry(std::string const& runId, PublishEntry const& publishEntry, std::optional<std::string> const& proctorVersion = {});

    /// Withdraw the entry of a run
    BoardEntry withdrawEntry(std::string const& runId, std::optional<std::string> const& proctorVersion = {});

    /// Resume a run
    Run resumeRun(std::string const& runId, std::optional<std::string> const& proctorVersion = {});

    /// Stop a run
    Run stopRun(std::string const& runId, StopRun const& stopRun, std::optional<std::string> const& proctorVersion = {});

private:
    std::shared_ptr<Connection> m_connection;
};

} // namespace proctor
