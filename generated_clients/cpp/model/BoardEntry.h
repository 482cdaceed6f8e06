/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include "EntryScore.h"
#include "EntryFlag.h"
#include "SelectionView.h"
#include "RunPolicy.h"
#include <string>
#include <map>
#include <vector>
#include "../members.h"

namespace proctor {


struct BoardEntry {
    static constexpr char const* schema_name = "BoardEntry";

    std::string entry_id{}; // Names the entry in every path.
    std::string run_id{};
    std::string submitter{}; // Name of the account that submitted the run.
    std::string benchmark_id{};
    std::string benchmark_version{};
    std::string manifest_sha256{}; // The digest of a [manifest](benchmarks.md#the-manifest), which is all of a benchmark that can change a score. It is the same on every server (BEN-006).
    std::optional<SelectionView> select{};
    RunPolicy policy{};
    std::string model_name{};
    bool is_public{};
    std::optional<std::string> model_type{};
    std::optional<std::string> organisation{};
    std::optional<std::string> homepage{};
    std::optional<std::string> code_url{};
    std::optional<std::string> notes{};
    std::string state{};
    std::optional<EntryFlag> flag{};
    std::string level{}; // What is known of the score: `reported` by the server alone; `signed`, for the run has a record that this host signs; `sealed`, for its seeds were drawn after the host was committed to the policy.
    std::int32_t attempts{}; // How many runs of the benchmark the account has submitted until now, published or not.
    EntryScore score{};
    std::string published_at{}; // When the entry was made.
    std::string changed_at{}; // When the description, the state or the flag changed for the last time.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("entry_id", self.entry_id);
        visitor.required("run_id", self.run_id);
        visitor.required("submitter", self.submitter);
        visitor.required("benchmark_id", self.benchmark_id);
        visitor.required("benchmark_version", self.benchmark_version);
        visitor.required("manifest_sha256", self.manifest_sha256);
        visitor.optional("select", self.select);
        visitor.required("policy", self.policy);
        visitor.required("model_name", self.model_name);
        visitor.required("is_public", self.is_public);
        visitor.optional("model_type", self.model_type);
        visitor.optional("organisation", self.organisation);
        visitor.optional("homepage", self.homepage);
        visitor.optional("code_url", self.code_url);
        visitor.optional("notes", self.notes);
        visitor.required("state", self.state);
        visitor.optional("flag", self.flag);
        visitor.required("level", self.level);
        visitor.required("attempts", self.attempts);
        visitor.required("score", self.score);
        visitor.required("published_at", self.published_at);
        visitor.required("changed_at", self.changed_at);
    }
};

} // namespace proctor
