/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include "ProtocolRange.h"
#include <string>
#include <map>
#include <vector>
#include "Assumptions.h"
#include "../members.h"

namespace proctor {

/// What a policy server says of itself.
struct PolicyDescription {
    static constexpr char const* schema_name = "PolicyDescription";

    std::string name{};
    std::optional<std::string> version{};
    ProtocolRange protocol{};
    std::int32_t max_sessions{}; // Most episodes that it plays at a time.
    std::optional<Assumptions> assumes{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("name", self.name);
        visitor.optional("version", self.version);
        visitor.required("protocol", self.protocol);
        visitor.required("max_sessions", self.max_sessions);
        visitor.optional("assumes", self.assumes);
    }
};

} // namespace proctor
