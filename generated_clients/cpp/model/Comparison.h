/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include "ComparedRun.h"
#include <string>
#include <map>
#include <vector>
#include "../members.h"

namespace proctor {

/// See scoring.md for every number here.
struct Comparison {
    static constexpr char const* schema_name = "Comparison";

    std::string baseline{}; // Id of the run that the others are compared with.
    std::string benchmark_id{};
    std::string manifest_sha256{}; // The digest of a [manifest](benchmarks.md#the-manifest), which is all of a benchmark that can change a score. It is the same on every server (BEN-006).
    double tolerance{};
    std::vector<ComparedRun> runs{}; // One entry per run that was named, in that order.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("baseline", self.baseline);
        visitor.required("benchmark_id", self.benchmark_id);
        visitor.required("manifest_sha256", self.manifest_sha256);
        visitor.required("tolerance", self.tolerance);
        visitor.required("runs", self.runs);
    }
};

} // namespace proctor
