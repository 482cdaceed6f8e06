/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include "Assumption.h"
#include <map>
#include <vector>
#include "../members.h"

namespace proctor {

/// What the policy takes for granted; refused when the benchmark says otherwise (ATT-010). For the profile `conventions`.
struct Assumptions {
    static constexpr char const* schema_name = "Assumptions";

    std::optional<double> control_rate_hz{};
    std::optional<std::map<std::string, Assumption>> action{};
    std::optional<std::map<std::string, Assumption>> state{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.optional("control_rate_hz", self.control_rate_hz);
        visitor.optional("action", self.action);
        visitor.optional("state", self.state);
    }
};

} // namespace proctor
