/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include "PartAssumption.h"
#include <string>
#include <map>
#include <vector>
#include "../members.h"

namespace proctor {

/// About a vector. All members but `size` and `parts` are about each of its parts (CONV-004).
struct Assumption {
    static constexpr char const* schema_name = "Assumption";

    std::optional<std::int32_t> size{};
    std::optional<std::string> quantity{}; // A name of registry/quantities.yaml, or an extension.
    std::optional<std::string> unit{};
    std::optional<double> scale{};
    std::optional<std::string> frame{};
    std::optional<std::string> rotation{}; // A name of registry/rotations.yaml, or an extension.
    std::optional<std::string> relative_to{}; // A name of registry/relative_modes.yaml, or an extension.
    std::optional<double> gripper_open{};
    std::optional<double> gripper_closed{};
    std::optional<std::map<std::string, PartAssumption>> parts{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.optional("size", self.size);
        visitor.optional("quantity", self.quantity);
        visitor.optional("unit", self.unit);
        visitor.optional("scale", self.scale);
        visitor.optional("frame", self.frame);
        visitor.optional("rotation", self.rotation);
        visitor.optional("relative_to", self.relative_to);
        visitor.optional("gripper_open", self.gripper_open);
        visitor.optional("gripper_closed", self.gripper_closed);
        visitor.optional("parts", self.parts);
    }
};

} // namespace proctor
