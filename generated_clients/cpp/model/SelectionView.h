/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include <string>
#include <map>
#include <vector>
#include "../members.h"

namespace proctor {

/// The `select` of a run, as it was submitted.
struct SelectionView {
    static constexpr char const* schema_name = "SelectionView";

    std::optional<std::vector<std::string>> tasks{};
    std::optional<std::vector<std::string>> splits{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.optional("tasks", self.tasks);
        visitor.optional("splits", self.splits);
    }
};

} // namespace proctor
