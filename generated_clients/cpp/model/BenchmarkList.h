/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include "BenchmarkSummary.h"
#include <map>
#include <vector>
#include "../members.h"

namespace proctor {


struct BenchmarkList {
    static constexpr char const* schema_name = "BenchmarkList";

    std::vector<BenchmarkSummary> benchmarks{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("benchmarks", self.benchmarks);
    }
};

} // namespace proctor
