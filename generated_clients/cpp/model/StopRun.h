/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include "StopMode.h"
#include <vector>
#include "../members.h"

namespace proctor {


struct StopRun {
    static constexpr char const* schema_name = "StopRun";

    std::optional<StopMode> mode{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.optional("mode", self.mode);
    }
};

} // namespace proctor
