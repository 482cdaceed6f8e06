/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include "CalibrationTask.h"
#include "SuccessRule.h"
#include <vector>
#include "../members.h"

namespace proctor {

/// Only for the benchmark `calibration`, which the submitter shapes.
struct CalibrationOptions {
    static constexpr char const* schema_name = "CalibrationOptions";

    std::optional<std::vector<CalibrationTask>> tasks{}; // One entry per episode, in order; one `score` episode when absent.
    std::optional<std::int32_t> max_steps{}; // 10 when absent.
    std::optional<SuccessRule> success_rule{};
    std::optional<std::int32_t> max_attempts{}; // 3 when absent. For the profile `sessions`.
    std::optional<std::int32_t> max_faults{}; // 3 when absent. For the profile `faults`.
    std::optional<bool> sealed{}; // Whether the seeds of the split `odd` are sealed; false when absent. Only for servers that announce the profile `sealed_seeds`.
    std::optional<double> queue_s{}; // Seconds for which the run stays queued after submit and after resume; 0 when absent. For the profile `control`.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.optional("tasks", self.tasks);
        visitor.optional("max_steps", self.max_steps);
        visitor.optional("success_rule", self.success_rule);
        visitor.optional("max_attempts", self.max_attempts);
        visitor.optional("max_faults", self.max_faults);
        visitor.optional("sealed", self.sealed);
        visitor.optional("queue_s", self.queue_s);
    }
};

} // namespace proctor
