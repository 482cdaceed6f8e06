/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include <map>
#include <vector>
#include "../members.h"

namespace proctor {


struct Action {
    static constexpr char const* schema_name = "Action";

    std::map<std::string, std::vector<double>> values{}; // Name → vector, exactly the entries of the benchmark's action space.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("values", self.values);
    }
};

} // namespace proctor
