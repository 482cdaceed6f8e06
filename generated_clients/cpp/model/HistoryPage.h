/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include <string>
#include "HistoryLeaf.h"
#include <map>
#include <vector>
#include "../members.h"

namespace proctor {


struct HistoryPage {
    static constexpr char const* schema_name = "HistoryPage";

    std::vector<HistoryLeaf> leaves{};
    std::optional<std::string> next_cursor{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("leaves", self.leaves);
        visitor.required("next_cursor", self.next_cursor);
    }
};

} // namespace proctor
