/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include "PublicKey.h"
#include <map>
#include <vector>
#include "../members.h"

namespace proctor {


struct KeyList {
    static constexpr char const* schema_name = "KeyList";

    std::vector<PublicKey> keys{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("keys", self.keys);
    }
};

} // namespace proctor
