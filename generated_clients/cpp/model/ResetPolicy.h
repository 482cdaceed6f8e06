/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include "EpisodeView.h"
#include <string>
#include "Benchmark.h"
#include <map>
#include <vector>
#include "../members.h"

namespace proctor {

/// An attempt begins; whatever the policy remembers of this session is over.
struct ResetPolicy {
    static constexpr char const* schema_name = "ResetPolicy";

    std::string session_id{};
    std::optional<std::string> run_id{};
    Benchmark benchmark{};
    EpisodeView episode{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("session_id", self.session_id);
        visitor.optional("run_id", self.run_id);
        visitor.required("benchmark", self.benchmark);
        visitor.required("episode", self.episode);
    }
};

} // namespace proctor
