/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include <string>
#include <map>
#include <vector>
#include "../members.h"

namespace proctor {


struct Lease {
    static constexpr char const* schema_name = "Lease";

    std::string expires_at{}; // When the session ends, unless a request extends it.
    double idle_timeout_s{}; // Length of the lease.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("expires_at", self.expires_at);
        visitor.required("idle_timeout_s", self.idle_timeout_s);
    }
};

} // namespace proctor
