/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include <string>
#include <map>
#include <vector>
#include "../members.h"

namespace proctor {


struct TensorSpace {
    static constexpr char const* schema_name = "TensorSpace";

    std::string dtype{};
    std::vector<std::int32_t> shape{};
    std::string description{};
    std::optional<std::vector<std::string>> tasks{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("dtype", self.dtype);
        visitor.required("shape", self.shape);
        visitor.required("description", self.description);
        visitor.optional("tasks", self.tasks);
    }
};

} // namespace proctor
