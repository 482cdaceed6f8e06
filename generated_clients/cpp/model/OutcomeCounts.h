/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include <map>
#include <vector>
#include "../members.h"

namespace proctor {


struct OutcomeCounts {
    static constexpr char const* schema_name = "OutcomeCounts";

    std::int32_t total{}; // All episodes.
    std::int32_t success{};
    std::int32_t failure{};
    std::int32_t abandoned{}; // Scored 0, because the last attempt was closed.
    std::int32_t unscored{}; // Without a result so far.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("total", self.total);
        visitor.required("success", self.success);
        visitor.required("failure", self.failure);
        visitor.required("abandoned", self.abandoned);
        visitor.required("unscored", self.unscored);
    }
};

} // namespace proctor
