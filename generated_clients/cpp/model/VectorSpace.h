/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include <string>
#include "VectorPart.h"
#include <map>
#include <vector>
#include "../members.h"

namespace proctor {

/// One named vector of numbers, in parts: see [conventions](conventions.md#parts).
struct VectorSpace {
    static constexpr char const* schema_name = "VectorSpace";

    std::int32_t size{};
    std::optional<std::map<std::string, VectorPart>> parts{}; // Name → what these numbers are. Only descriptions of earlier drafts have none.
    std::optional<std::vector<double>> minimum{};
    std::optional<std::vector<double>> maximum{};
    std::string out_of_range{};
    std::optional<std::string> description{}; // What the numbers are.
    std::optional<std::vector<std::string>> tasks{}; // The tasks that have this entry; all of them when absent.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("size", self.size);
        visitor.optional("parts", self.parts);
        visitor.optional("minimum", self.minimum);
        visitor.optional("maximum", self.maximum);
        visitor.required("out_of_range", self.out_of_range);
        visitor.optional("description", self.description);
        visitor.optional("tasks", self.tasks);
    }
};

} // namespace proctor
