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

    std::string episode_id{};
    std::int32_t index{}; // Position in the manifest.
    std::string task{};
    std::string instruction{};
    std::int32_t attempt{};
    std::int32_t step{};
    std::int32_t max_steps{};

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
