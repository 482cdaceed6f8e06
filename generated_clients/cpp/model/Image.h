/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include <string>
#include <map>
#include <vector>
#include "../members.h"

namespace proctor {

/// Row 0 on top; raw is height × width × channels bytes. The order of [channels](play.md#numbers-and-pictures).
struct Image {
    static constexpr char const* schema_name = "Image";

    std::string codec{};
    std::int32_t width{};
    std::int32_t height{};
    std::int32_t channels{};
    std::string data{}; // Base64 with padding in JSON; `bin` in MessagePack.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("codec", self.codec);
        visitor.required("width", self.width);
        visitor.required("height", self.height);
        visitor.required("channels", self.channels);
        visitor.required("data", self.data);
    }
};

} // namespace proctor
