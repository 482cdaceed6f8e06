/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include <string>
#include <map>
#include <vector>
#include "../members.h"

namespace proctor {


struct ProtocolRange {
    static constexpr char const* schema_name = "ProtocolRange";

    std::string min{}; // Lowest version that is spoken.
    std::string max{}; // Highest version that is spoken.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("min", self.min);
        visitor.required("max", self.max);
    }
};

} // namespace proctor
