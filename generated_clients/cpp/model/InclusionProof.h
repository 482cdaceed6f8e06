/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include <string>
#include <map>
#include <vector>
#include "../members.h"

namespace proctor {


struct InclusionProof {
    static constexpr char const* schema_name = "InclusionProof";

    std::int64_t leaf_index{};
    std::int64_t tree_size{};
    std::vector<std::string> hashes{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("leaf_index", self.leaf_index);
        visitor.required("tree_size", self.tree_size);
        visitor.required("hashes", self.hashes);
    }
};

} // namespace proctor
