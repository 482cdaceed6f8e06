/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include <string>
#include <map>
#include <vector>
#include "../members.h"

namespace proctor {


struct BenchmarkSummary {
    static constexpr char const* schema_name = "BenchmarkSummary";

    std::string benchmark_id{};
    std::string version{};
    std::string title{};
    std::string manifest_sha256{}; // The digest of a [manifest](benchmarks.md#the-manifest), which is all of a benchmark that can change a score. It is the same on every server (BEN-006).
    std::int32_t episodes_total{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("benchmark_id", self.benchmark_id);
        visitor.required("version", self.version);
        visitor.required("title", self.title);
        visitor.required("manifest_sha256", self.manifest_sha256);
        visitor.required("episodes_total", self.episodes_total);
    }
};

} // namespace proctor
