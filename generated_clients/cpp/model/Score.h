/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include "GroupScore.h"
#include "SelectionView.h"
#include <string>
#include "RunState.h"
#include "Interval.h"
#include <map>
#include <vector>
#include "OutcomeCounts.h"
#include "../members.h"

namespace proctor {

/// See scoring.md for every number here.
struct Score {
    static constexpr char const* schema_name = "Score";

    std::string run_id{};
    std::string benchmark_id{};
    std::string manifest_sha256{}; // The digest of a [manifest](benchmarks.md#the-manifest), which is all of a benchmark that can change a score. It is the same on every server (BEN-006).
    std::optional<SelectionView> select{};
    RunState state{};
    bool complete{}; // Every episode has a result.
    std::optional<double> score{}; // Null until complete.
    double score_low{}; // The score if every missing episode got 0.
    double score_high{}; // The score if every missing episode got 1.
    OutcomeCounts counts{};
    std::optional<double> success_rate{}; // Successes among the scored episodes.
    Interval success_interval{};
    std::optional<double> mean{}; // Mean over the scored episodes.
    Interval mean_interval{};
    std::map<std::string, GroupScore> by_task{};
    std::map<std::string, GroupScore> by_split{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("run_id", self.run_id);
        visitor.required("benchmark_id", self.benchmark_id);
        visitor.required("manifest_sha256", self.manifest_sha256);
        visitor.optional("select", self.select);
        visitor.required("state", self.state);
        visitor.required("complete", self.complete);
        visitor.required("score", self.score);
        visitor.required("score_low", self.score_low);
        visitor.required("score_high", self.score_high);
        visitor.required("counts", self.counts);
        visitor.required("success_rate", self.success_rate);
        visitor.required("success_interval", self.success_interval);
        visitor.required("mean", self.mean);
        visitor.required("mean_interval", self.mean_interval);
        visitor.required("by_task", self.by_task);
        visitor.required("by_split", self.by_split);
    }
};

} // namespace proctor
