/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include <map>
#include <vector>
#include "../members.h"

namespace proctor {

/// The first state that was another one; absent where every state was met.
struct ReplayDivergence {
    static constexpr char const* schema_name = "ReplayDivergence";

    std::int32_t episode_index{};
    std::int64_t attempt{};
    std::int64_t step{}; // After how many steps of the attempt the state was another one.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("episode_index", self.episode_index);
        visitor.required("attempt", self.attempt);
        visitor.required("step", self.step);
    }
};

} // namespace proctor
