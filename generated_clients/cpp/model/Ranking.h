/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include <string>
#include "RankedEntry.h"
#include <map>
#include <vector>
#include "../members.h"

namespace proctor {

/// See board.md for every number here.
struct Ranking {
    static constexpr char const* schema_name = "Ranking";

    std::string benchmark_id{};
    std::string manifest_sha256{}; // The digest of a [manifest](benchmarks.md#the-manifest), which is all of a benchmark that can change a score. It is the same on every server (BEN-006).
    std::optional<std::int32_t> episodes_total{}; // How many episodes each entry has; null where the manifest has no entry.
    std::int32_t ranked{}; // How many entries have a rank.
    std::int64_t comparisons{}; // How many pairs of them were tested.
    double alpha{}; // How likely it is at most that any two equally good policies are distinguished; 0.05.
    std::optional<std::int32_t> differing_min{}; // Two entries that differ on fewer episodes can never be distinguished; null if the benchmark has fewer episodes.
    std::optional<std::int32_t> differing_enough{}; // Two entries that differ on so many episodes, all to the advantage of one, are distinguished, however the others fared; null if the benchmark has fewer episodes.
    std::vector<RankedEntry> rows{};
    std::optional<std::string> next_cursor{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("benchmark_id", self.benchmark_id);
        visitor.required("manifest_sha256", self.manifest_sha256);
        visitor.required("episodes_total", self.episodes_total);
        visitor.required("ranked", self.ranked);
        visitor.required("comparisons", self.comparisons);
        visitor.required("alpha", self.alpha);
        visitor.required("differing_min", self.differing_min);
        visitor.required("differing_enough", self.differing_enough);
        visitor.required("rows", self.rows);
        visitor.required("next_cursor", self.next_cursor);
    }
};

} // namespace proctor
