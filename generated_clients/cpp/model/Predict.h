/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include <string>
#include "Observe.h"
#include <vector>
#include "Action.h"
#include "../members.h"

namespace proctor {


struct Predict {
    static constexpr char const* schema_name = "Predict";

    std::string session_id{}; // Session of `attach_worker`.
    std::int64_t seq{}; // Number of the turn, 1 for the first one; a repeat has the same number.
    std::vector<Action> actions{};
    std::optional<Observe> observe{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("session_id", self.session_id);
        visitor.required("seq", self.seq);
        visitor.required("actions", self.actions);
        visitor.optional("observe", self.observe);
    }
};

} // namespace proctor
