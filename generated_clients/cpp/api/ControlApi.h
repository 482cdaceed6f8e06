/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <memory>

#include "../connection.h"
#include "../model/Benchmark.h"
#include "../model/BenchmarkList.h"
#include "../model/BoardEntry.h"
#include "../model/BoardEntryList.h"
#include "../model/Checkpoint.h"
#include "../model/Comparison.h"
#include "../model/ConsistencyProof.h"
#include "../model/EpisodeList.h"
#include "../model/FlagEntry.h"
#include "../model/HistoryPage.h"
#include "../model/InclusionProof.h"
#include "../model/KeyList.h"
#include "../model/Problem.h"
#include "../model/PublishEntry.h"
#include "../model/Ranking.h"
#include "../model/RecordImport.h"
#include "../model/RecordImportList.h"
#include "../model/Run.h"
#include "../model/RunList.h"
#include "../model/Score.h"
#include "../model/Service.h"
#include "../model/StopRun.h"
#include "../model/SubmitRun.h"
#include <string>

namespace proctor {

/// Each call throws Refused when the server refuses it, ConnectionError when no answer came, InvalidAnswer
/// when what came is not the message expected.
class ControlApi {
public:
    explicit ControlApi(std::shared_ptr<Connection> connection) : m_connection(std::move(connection)) {}

    /// Runs beside a baseline, episode by episode
    Comparison compareRuns(std::string const& baseline, std::string const& runs, std::optional<double> const& tolerance = {}, std::optional<std::string> const& proctorVersion = {});

    /// Remove a record that was handed in
    void deleteImport(std::string const& importId, std::optional<std::string> const& proctorVersion = {});

    /// What is known here of a record that was handed in
    RecordImport getImport(std::string const& importId, std::optional<std::string> const& proctorVersion = {});

    /// Delete a run that is not in play, with all that is stored of it
    void deleteRun(std::string const& runId, std::optional<std::string> const& proctorVersion = {});

    /// State, progress and the reason for both; can wait for a change
    Run getRun(std::string const& runId, std::optional<std::string> const& ifNoneMatch = {}, std::optional<std::string> const& prefer = {}, std::optional<std::string> const& proctorVersion = {});

    /// What this server is, speaks and allows
    Service describeService(std::optional<std::string> const& proctorVersion = {});

    /// Say of a public entry that something is wrong with it, or take that back
    BoardEntry flagEntry(std::string const& entryId, FlagEntry const& flagEntry, std::optional<std::string> const& proctorVersion = {});

    /// One benchmark with its spaces, conventions and rules
    Benchmark getBenchmark(std::string const& benchmarkId, std::optional<std::string> const& proctorVersion = {});

    /// The size and the root of the history, signed
    Checkpoint getCheckpoint(std::optional<std::string> const& proctorVersion = {});

    /// One entry, withdrawn or not
    BoardEntry getEntry(std::string const& entryId, std::optional<std::string> const& proctorVersion = {});

    /// The public entries of one manifest, ranked
    Ranking getRanking(std::string const& benchmarkId, std::optional<std::string> const& manifestSha256 = {}, std::optional<std::string> const& cursor = {}, std::optional<std::int32_t> const& limit = {}, std::optional<std::string> const& proctorVersion = {});

    /// The score, or its bounds while episodes are missing
    Score getScore(std::string const& runId, std::optional<std::string> const& proctorVersion = {});

    /// Hand in a record of any host, to be verified and replayed here
    RecordImport importRecord(std::string const& body, std::optional<std::string> const& proctorVersion = {});

    /// The records that the account handed in, newest first
    RecordImportList listImports(std::optional<std::string> const& cursor = {}, std::optional<std::int32_t> const& limit = {}, std::optional<std::string> const& proctorVersion = {});

    /// The benchmarks offered here
    BenchmarkList listBenchmarks(std::optional<std::string> const& proctorVersion = {});

    /// Entries of the leaderboard, newest first
    BoardEntryList listEntries(std::optional<std::string> const& benchmarkId = {}, std::optional<std::string> const& cursor = {}, std::optional<std::int32_t> const& limit = {}, std::optional<std::string> const& proctorVersion = {});

    /// Every episode with its result so far, in manifest order
    EpisodeList listEpisodes(std::string const& runId, std::optional<std::string> const& cursor = {}, std::optional<std::int32_t> const& limit = {}, std::optional<std::string> const& proctorVersion = {});

    /// What happened to public entries, oldest first
    HistoryPage listHistory(std::optional<std::string> const& cursor = {}, std::optional<std::int32_t> const& limit = {}, std::optional<std::string> const& proctorVersion = {});

    /// The public keys with which this host signs records
    KeyList listKeys(std::optional<std::string> const& proctorVersion = {});

    /// The caller's runs, newest first
    RunList listRuns(std::optional<std::string> const& cursor = {}, std::optional<std::int32_t> const& limit = {}, std::optional<std::string> const& proctorVersion = {});

    /// Ask for one evaluation of one policy on one benchmark
    Run submitRun(SubmitRun const& submitRun, std::optional<std::string> const& idempotencyKey = {}, std::optional<std::string> const& proctorVersion = {});

    /// Proof that a history of one size begins with that of another
    ConsistencyProof proveConsistency(std::string const& oldSize, std::string const& newSize, std::optional<std::string> const& proctorVersion = {});

    /// Proof that a leaf stands in the history of a size
    InclusionProof proveInclusion(std::string const& leafIndex, std::string const& treeSize, std::optional<std::string> const& proctorVersion = {});

    /// Publish a completed run on the leaderboard, or change what its entry says
    BoardEntry publishEntry(std::string const& runId, PublishEntry const& publishEntry, std::optional<std::string> const& proctorVersion = {});

    /// Take the entry of a run off the leaderboard, for good
    BoardEntry withdrawEntry(std::string const& runId, std::optional<std::string> const& proctorVersion = {});

    /// Go on with the episodes that have no score yet
    Run resumeRun(std::string const& runId, std::optional<std::string> const& proctorVersion = {});

    /// Stop now (abort) or after the episodes in play (drain)
    Run stopRun(std::string const& runId, StopRun const& stopRun, std::optional<std::string> const& proctorVersion = {});

private:
    std::shared_ptr<Connection> m_connection;
};

} // namespace proctor
