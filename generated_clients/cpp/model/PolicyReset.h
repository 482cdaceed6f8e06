/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include <string>
#include <map>
#include <vector>
#include "../members.h"

namespace proctor {

/// The policy is ready for this attempt and no other.
struct PolicyReset {
    static constexpr char const* schema_name = "PolicyReset";

    std::string session_id{};
    std::string episode_id{};
    std::int32_t attempt{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("session_id", self.session_id);
        visitor.required("episode_id", self.episode_id);
        visitor.required("attempt", self.attempt);
    }
};

} // namespace proctor
