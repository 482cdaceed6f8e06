/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include <string>
#include <map>
#include <vector>
#include "../members.h"

namespace proctor {

/// The episode that the observation belongs to.
struct EpisodeView {
    static constexpr char const* schema_name = "EpisodeView";

    std::string episode_id{}; // Names the episode within the run.
    std::int32_t index{}; // Position in the manifest.
    std::string task{}; // What kind of episode it is.
    std::string instruction{}; // What the policy is to do, in words.
    std::int32_t attempt{}; // Number of this playing of it, from 1.
    std::int32_t step{}; // Actions executed in this attempt.
    std::int32_t max_steps{}; // Steps after which it is truncated.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("episode_id", self.episode_id);
        visitor.required("index", self.index);
        visitor.required("task", self.task);
        visitor.required("instruction", self.instruction);
        visitor.required("attempt", self.attempt);
        visitor.required("step", self.step);
        visitor.required("max_steps", self.max_steps);
    }
};

} // namespace proctor
