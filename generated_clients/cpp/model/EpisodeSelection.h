/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include <string>
#include <vector>
#include "../members.h"

namespace proctor {

/// The part of a benchmark that is played, all of it where a member is absent; for the profile `subsets`.
struct EpisodeSelection {
    static constexpr char const* schema_name = "EpisodeSelection";

    std::optional<std::vector<std::string>> tasks{};
    std::optional<std::vector<std::string>> splits{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.optional("tasks", self.tasks);
        visitor.optional("splits", self.splits);
    }
};

} // namespace proctor
