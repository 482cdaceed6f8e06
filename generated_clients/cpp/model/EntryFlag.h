/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include <string>
#include <map>
#include <vector>
#include "../members.h"

namespace proctor {


struct EntryFlag {
    static constexpr char const* schema_name = "EntryFlag";

    std::string reason{};
    std::string flagged_at{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("reason", self.reason);
        visitor.required("flagged_at", self.flagged_at);
    }
};

} // namespace proctor
