/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include <string>
#include <vector>
#include "../members.h"

namespace proctor {


struct FlagEntry {
    static constexpr char const* schema_name = "FlagEntry";

    bool flagged{}; // False takes the flag back.
    std::string reason{}; // Shown with the entry.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("flagged", self.flagged);
        visitor.required("reason", self.reason);
    }
};

} // namespace proctor
