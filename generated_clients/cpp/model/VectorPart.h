/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include <string>
#include <map>
#include <vector>
#include "../members.h"

namespace proctor {

/// Adjacent numbers of a vector, with every convention a policy could get wrong.
struct VectorPart {
    static constexpr char const* schema_name = "VectorPart";

    std::int32_t start{}; // Index of its first number in the vector.
    std::int32_t size{};
    std::string quantity{}; // A name of registry/quantities.yaml, or an extension.
    std::string unit{}; // A name of registry/units.yaml, or an extension.
    std::optional<double> scale{}; // A number times `scale` is in `unit`; 1 when absent.
    std::string frame{}; // A name of registry/frames.yaml, or an extension.
    std::string rotation{}; // A name of registry/rotations.yaml, or an extension.
    std::string relative_to{}; // A name of registry/relative_modes.yaml, or an extension.
    std::optional<double> gripper_open{}; // The value that means fully open.
    std::optional<double> gripper_closed{}; // The value that means fully closed.
    std::optional<std::string> description{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("start", self.start);
        visitor.required("size", self.size);
        visitor.required("quantity", self.quantity);
        visitor.required("unit", self.unit);
        visitor.optional("scale", self.scale);
        visitor.required("frame", self.frame);
        visitor.required("rotation", self.rotation);
        visitor.required("relative_to", self.relative_to);
        visitor.optional("gripper_open", self.gripper_open);
        visitor.optional("gripper_closed", self.gripper_closed);
        visitor.optional("description", self.description);
    }
};

} // namespace proctor
