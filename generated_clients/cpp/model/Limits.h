/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include <map>
#include <vector>
#include "../members.h"

namespace proctor {


struct Limits {
    using IsMessage = void;

    std::int64_t max_body_bytes{}; // Longest request body that is read.
    std::int32_t max_workers{}; // Most live workers a run may ask for.
    std::int32_t max_chunk{}; // Most actions in one predict; a benchmark may allow fewer.
    double idle_timeout_s_min{};
    double idle_timeout_s_max{};
    std::int32_t wait_s_max{}; // Longest wait that a long-poll is granted.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("max_body_bytes", self.max_body_bytes);
        visitor.required("max_workers", self.max_workers);
        visitor.required("max_chunk", self.max_chunk);
        visitor.required("idle_timeout_s_min", self.idle_timeout_s_min);
        visitor.required("idle_timeout_s_max", self.idle_timeout_s_max);
        visitor.required("wait_s_max", self.wait_s_max);
    }
};

} // namespace proctor
