/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include <map>
#include <vector>
#include "../members.h"

namespace proctor {


struct ImageSize {
    static constexpr char const* schema_name = "ImageSize";

    std::int32_t width{};
    std::int32_t height{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("width", self.width);
        visitor.required("height", self.height);
    }
};

} // namespace proctor
