/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include <string>
#include <map>
#include <vector>
#include "Episode.h"
#include "../members.h"

namespace proctor {


struct EpisodeList {
    static constexpr char const* schema_name = "EpisodeList";

    std::vector<Episode> episodes{};
    std::optional<std::string> next_cursor{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("episodes", self.episodes);
        visitor.required("next_cursor", self.next_cursor);
    }
};

} // namespace proctor
