/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include <string>
#include <map>
#include <vector>
#include "../members.h"

namespace proctor {


struct ImageSpace {
    static constexpr char const* schema_name = "ImageSpace";

    std::int32_t channels{};
    std::string description{};
    std::optional<std::vector<std::string>> tasks{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("channels", self.channels);
        visitor.required("description", self.description);
        visitor.optional("tasks", self.tasks);
    }
};

} // namespace proctor
