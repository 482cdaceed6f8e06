/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include "ReplayDivergence.h"
#include <string>
#include <map>
#include <vector>
#include "../members.h"

namespace proctor {

/// As in a verdict (record.md); absent before the end of the replay, and where there is none.
struct RecordReplay {
    static constexpr char const* schema_name = "RecordReplay";

    std::string result{}; // `exact`, `outcome` or `diverged`.
    std::int32_t episodes{};
    std::int32_t exact{};
    std::int32_t outcome{};
    std::int32_t diverged{};
    std::optional<ReplayDivergence> first_divergence{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("result", self.result);
        visitor.required("episodes", self.episodes);
        visitor.required("exact", self.exact);
        visitor.required("outcome", self.outcome);
        visitor.required("diverged", self.diverged);
        visitor.optional("first_divergence", self.first_divergence);
    }
};

} // namespace proctor
