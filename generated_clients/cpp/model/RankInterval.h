/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include <map>
#include <vector>
#include "../members.h"

namespace proctor {

/// The ranks that an entry may have; absent for an entry that is flagged.
struct RankInterval {
    static constexpr char const* schema_name = "RankInterval";

    std::int32_t low{}; // The best one.
    std::int32_t high{}; // The worst one.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("low", self.low);
        visitor.required("high", self.high);
    }
};

} // namespace proctor
