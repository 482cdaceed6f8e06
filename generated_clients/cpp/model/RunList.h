/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include <string>
#include <map>
#include "Run.h"
#include <vector>
#include "../members.h"

namespace proctor {


struct RunList {
    static constexpr char const* schema_name = "RunList";

    std::vector<Run> runs{};
    std::optional<std::string> next_cursor{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("runs", self.runs);
        visitor.required("next_cursor", self.next_cursor);
    }
};

} // namespace proctor
