/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include <map>
#include <vector>
#include "../members.h"

namespace proctor {

/// 95 % interval.
struct Interval {
    static constexpr char const* schema_name = "Interval";

    double low{};
    double high{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("low", self.low);
        visitor.required("high", self.high);
    }
};

} // namespace proctor
