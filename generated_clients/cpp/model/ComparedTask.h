/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include <map>
#include <vector>
#include "../members.h"

namespace proctor {


struct ComparedTask {
    static constexpr char const* schema_name = "ComparedTask";

    std::int32_t paired{};
    std::optional<double> baseline_mean{};
    std::optional<double> mean{};
    std::optional<double> difference{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("paired", self.paired);
        visitor.required("baseline_mean", self.baseline_mean);
        visitor.required("mean", self.mean);
        visitor.required("difference", self.difference);
    }
};

} // namespace proctor
