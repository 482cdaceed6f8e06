/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include <string>
#include "BoardEntry.h"
#include <map>
#include <vector>
#include "../members.h"

namespace proctor {


struct BoardEntryList {
    static constexpr char const* schema_name = "BoardEntryList";

    std::vector<BoardEntry> entries{};
    std::optional<std::string> next_cursor{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("entries", self.entries);
        visitor.required("next_cursor", self.next_cursor);
    }
};

} // namespace proctor
