/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include "ImportedPolicy.h"
#include <string>
#include <map>
#include "RecordReplay.h"
#include <vector>
#include "../members.h"

namespace proctor {

/// A record that was handed in, and what is known of it here.
struct RecordImport {
    static constexpr char const* schema_name = "RecordImport";

    std::string import_id{};
    std::string state{}; // `waiting` for simulators, `replaying`, or `finished`.
    std::string level{}; // `reported`: whole, by anyone; `signed` by a key that this server knows; `replayed` here with the same results; `diverged`: the replay came out otherwise.
    std::string level_text{}; // The level with who says it, as REC-031 has it.
    std::optional<std::string> signer{}; // Whose key signed the record, as this server knows it; null for a key that it does not know.
    std::string keyid{}; // Of the key that signed the record.
    std::string archive_sha256{};
    std::string statement_sha256{};
    std::int64_t size_bytes{};
    std::string run_id{}; // In the statement, as are the members below it.
    std::string benchmark_id{};
    std::string benchmark_version{};
    std::string manifest_sha256{};
    ImportedPolicy policy{};
    std::optional<double> score{}; // Null where an episode has no result.
    std::int32_t episodes{};
    std::int32_t episodes_replayed{}; // How many of them were simulated so far.
    std::optional<RecordReplay> replay{};
    std::optional<std::string> reason{}; // Why there is no replay.
    std::string imported_at{};
    std::optional<std::string> finished_at{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("import_id", self.import_id);
        visitor.required("state", self.state);
        visitor.required("level", self.level);
        visitor.required("level_text", self.level_text);
        visitor.required("signer", self.signer);
        visitor.required("keyid", self.keyid);
        visitor.required("archive_sha256", self.archive_sha256);
        visitor.required("statement_sha256", self.statement_sha256);
        visitor.required("size_bytes", self.size_bytes);
        visitor.required("run_id", self.run_id);
        visitor.required("benchmark_id", self.benchmark_id);
        visitor.required("benchmark_version", self.benchmark_version);
        visitor.required("manifest_sha256", self.manifest_sha256);
        visitor.required("policy", self.policy);
        visitor.required("score", self.score);
        visitor.required("episodes", self.episodes);
        visitor.required("episodes_replayed", self.episodes_replayed);
        visitor.optional("replay", self.replay);
        visitor.required("reason", self.reason);
        visitor.required("imported_at", self.imported_at);
        visitor.required("finished_at", self.finished_at);
    }
};

} // namespace proctor
