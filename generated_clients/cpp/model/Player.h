/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include <string>
#include <vector>
#include "../members.h"

namespace proctor {

/// Who plays, by its own words; for the profile `attribution`.
struct Player {
    static constexpr char const* schema_name = "Player";

    std::string name{}; // Of the policy, as in `policy` of the run.
    std::optional<std::string> version{}; // Of the policy.
    std::optional<std::string> client{}; // The program that attaches and its version.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("name", self.name);
        visitor.optional("version", self.version);
        visitor.optional("client", self.client);
    }
};

} // namespace proctor
