/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include <string>
#include <map>
#include <vector>
#include "../members.h"

namespace proctor {

/// C order, little-endian; a bool is one byte, 0 or 1.
struct Tensor {
    static constexpr char const* schema_name = "Tensor";

    std::string dtype{};
    std::vector<std::int64_t> shape{};
    std::string data{}; // Base64 with padding in JSON; `bin` in MessagePack.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("dtype", self.dtype);
        visitor.required("shape", self.shape);
        visitor.required("data", self.data);
    }
};

} // namespace proctor
