/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include <string>
#include <map>
#include <vector>
#include "../members.h"

namespace proctor {


struct ConsistencyProof {
    static constexpr char const* schema_name = "ConsistencyProof";

    std::int64_t old_size{};
    std::int64_t new_size{};
    std::vector<std::string> hashes{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("old_size", self.old_size);
        visitor.required("new_size", self.new_size);
        visitor.required("hashes", self.hashes);
    }
};

} // namespace proctor
