/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include <string>
#include <vector>
#include "../members.h"

namespace proctor {


struct Assumption {
    static constexpr char const* schema_name = "Assumption";

    std::optional<std::int32_t> size{};
    std::optional<std::string> unit{};
    std::optional<std::string> rotation{};
    std::optional<std::string> frame{};
    std::optional<bool> relative{};
    std::optional<double> gripper_open{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.optional("size", self.size);
        visitor.optional("unit", self.unit);
        visitor.optional("rotation", self.rotation);
        visitor.optional("frame", self.frame);
        visitor.optional("relative", self.relative);
        visitor.optional("gripper_open", self.gripper_open);
    }
};

} // namespace proctor
