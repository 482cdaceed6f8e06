/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include <string>
#include <vector>
#include "../members.h"

namespace proctor {


struct Heartbeat {
    static constexpr char const* schema_name = "Heartbeat";

    std::string session_id{}; // Session of `attach_worker`.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("session_id", self.session_id);
    }
};

} // namespace proctor
