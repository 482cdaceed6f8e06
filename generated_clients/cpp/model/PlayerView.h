/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include <string>
#include <map>
#include <vector>
#include "../members.h"

namespace proctor {

/// The `player` of an `attach_worker`.
struct PlayerView {
    static constexpr char const* schema_name = "PlayerView";

    std::string name{};
    std::optional<std::string> version{};
    std::optional<std::string> client{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("name", self.name);
        visitor.optional("version", self.version);
        visitor.optional("client", self.client);
    }
};

} // namespace proctor
