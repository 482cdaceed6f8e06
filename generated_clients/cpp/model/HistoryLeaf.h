/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include <string>
#include <map>
#include <vector>
#include "../members.h"

namespace proctor {


struct HistoryLeaf {
    static constexpr char const* schema_name = "HistoryLeaf";

    std::int64_t index{};
    std::string leaf{}; // A JSON text, whose UTF-8 is what the tree has; board.md has its members.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("index", self.index);
        visitor.required("leaf", self.leaf);
    }
};

} // namespace proctor
