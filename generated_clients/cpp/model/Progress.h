/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include <map>
#include <vector>
#include "../members.h"

namespace proctor {


struct Progress {
    static constexpr char const* schema_name = "Progress";

    std::int32_t episodes_total{}; // How many episodes the run has.
    std::int32_t episodes_scored{}; // Abandoned ones included.
    std::int32_t episodes_in_progress{}; // How many are played now.
    std::int32_t episodes_pending{}; // How many wait to be played.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("episodes_total", self.episodes_total);
        visitor.required("episodes_scored", self.episodes_scored);
        visitor.required("episodes_in_progress", self.episodes_in_progress);
        visitor.required("episodes_pending", self.episodes_pending);
    }
};

} // namespace proctor
