/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include <string>
#include <vector>
#include "../members.h"

namespace proctor {

/// Recorded with the result, because it changes the score.
struct ImageChoice {
    static constexpr char const* schema_name = "ImageChoice";

    std::string codec{};
    std::int32_t width{};
    std::int32_t height{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("codec", self.codec);
        visitor.required("width", self.width);
        visitor.required("height", self.height);
    }
};

} // namespace proctor
