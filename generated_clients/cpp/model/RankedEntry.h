/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include "RankInterval.h"
#include <string>
#include "BoardEntry.h"
#include <map>
#include <vector>
#include "../members.h"

namespace proctor {


struct RankedEntry {
    static constexpr char const* schema_name = "RankedEntry";

    BoardEntry entry{};
    std::optional<RankInterval> rank{};
    std::int32_t better{}; // How many entries are significantly better; 0 without a rank.
    std::int32_t worse{}; // How many entries are significantly worse; 0 without a rank.
    std::vector<std::string> letters{}; // Entries that cannot be distinguished have a letter in common, others have none in common; empty without a rank.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("entry", self.entry);
        visitor.optional("rank", self.rank);
        visitor.required("better", self.better);
        visitor.required("worse", self.worse);
        visitor.required("letters", self.letters);
    }
};

} // namespace proctor
