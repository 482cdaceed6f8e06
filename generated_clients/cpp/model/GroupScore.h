/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include <map>
#include <vector>
#include "OutcomeCounts.h"
#include "../members.h"

namespace proctor {


struct GroupScore {
    static constexpr char const* schema_name = "GroupScore";

    OutcomeCounts counts{};
    std::optional<double> mean{};
    std::optional<double> success_rate{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("counts", self.counts);
        visitor.required("mean", self.mean);
        visitor.required("success_rate", self.success_rate);
    }
};

} // namespace proctor
