/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include <string>
#include <map>
#include <vector>
#include "../members.h"

namespace proctor {

/// One named vector of numbers, with every convention a policy could get wrong.
struct VectorSpace {
    static constexpr char const* schema_name = "VectorSpace";

    std::int32_t size{};
    std::string unit{}; // `rad`, `m`, `1`, or several joined by commas.
    std::string rotation{};
    std::string frame{}; // `world`, `base`, `tool`, `joint`, or `none`.
    bool relative{}; // True when the values are increments.
    std::optional<double> gripper_open{}; // The value that means fully open.
    std::optional<std::vector<double>> minimum{};
    std::optional<std::vector<double>> maximum{};
    std::string out_of_range{};
    std::optional<std::string> description{}; // What the numbers are.
    std::optional<std::vector<std::string>> tasks{}; // The tasks that have this entry; all of them when absent.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("size", self.size);
        visitor.required("unit", self.unit);
        visitor.required("rotation", self.rotation);
        visitor.required("frame", self.frame);
        visitor.required("relative", self.relative);
        visitor.optional("gripper_open", self.gripper_open);
        visitor.optional("minimum", self.minimum);
        visitor.optional("maximum", self.maximum);
        visitor.required("out_of_range", self.out_of_range);
        visitor.optional("description", self.description);
        visitor.optional("tasks", self.tasks);
    }
};

} // namespace proctor
