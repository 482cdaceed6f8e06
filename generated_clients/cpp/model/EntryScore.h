/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include "GroupScore.h"
#include "SecondJudgements.h"
#include <string>
#include "Interval.h"
#include <map>
#include <vector>
#include "OutcomeCounts.h"
#include "../members.h"

namespace proctor {

/// Of the `get_score` of the run.
struct EntryScore {
    static constexpr char const* schema_name = "EntryScore";

    double score{};
    double success_rate{};
    Interval success_interval{};
    Interval mean_interval{};
    OutcomeCounts counts{};
    std::optional<std::string> judged_by{}; // With the profile `physical`: `people` of the host.
    std::optional<SecondJudgements> second_judge{};
    std::optional<std::map<std::string, GroupScore>> by_task{}; // Absent where the server does not show it, such as for many tasks.
    std::optional<std::map<std::string, GroupScore>> by_split{}; // Absent where the server does not show it, such as for many splits.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("score", self.score);
        visitor.required("success_rate", self.success_rate);
        visitor.required("success_interval", self.success_interval);
        visitor.required("mean_interval", self.mean_interval);
        visitor.required("counts", self.counts);
        visitor.optional("judged_by", self.judged_by);
        visitor.optional("second_judge", self.second_judge);
        visitor.optional("by_task", self.by_task);
        visitor.optional("by_split", self.by_split);
    }
};

} // namespace proctor
