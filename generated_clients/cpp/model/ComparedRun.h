/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include "ComparedTask.h"
#include <string>
#include <map>
#include <vector>
#include "../members.h"

namespace proctor {

/// One run beside the baseline. A pair is an episode that both have scored.
struct ComparedRun {
    static constexpr char const* schema_name = "ComparedRun";

    std::string run_id{};
    bool complete{}; // Both runs have scored every episode.
    bool release{}; // Complete, and no difference, over all episodes or over those of a task, is beyond the tolerance.
    std::int32_t paired{}; // Number of pairs.
    std::optional<double> baseline_mean{}; // Mean score of the baseline over the pairs.
    std::optional<double> mean{}; // Mean score of the run over the pairs.
    std::optional<double> difference{}; // Baseline minus run: positive when the run is worse.
    std::int32_t wins{}; // Pairs in which the run alone succeeds.
    std::int32_t losses{}; // Pairs in which the baseline alone succeeds.
    std::int32_t ties{}; // Pairs in which both succeed or neither does.
    double p_value{}; // McNemar's exact test, two-sided.
    std::map<std::string, ComparedTask> by_task{}; // Task → the pairs of its episodes.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("run_id", self.run_id);
        visitor.required("complete", self.complete);
        visitor.required("release", self.release);
        visitor.required("paired", self.paired);
        visitor.required("baseline_mean", self.baseline_mean);
        visitor.required("mean", self.mean);
        visitor.required("difference", self.difference);
        visitor.required("wins", self.wins);
        visitor.required("losses", self.losses);
        visitor.required("ties", self.ties);
        visitor.required("p_value", self.p_value);
        visitor.required("by_task", self.by_task);
    }
};

} // namespace proctor
