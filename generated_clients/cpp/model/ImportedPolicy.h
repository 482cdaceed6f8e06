/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include <string>
#include <map>
#include <vector>
#include "../members.h"

namespace proctor {


struct ImportedPolicy {
    static constexpr char const* schema_name = "ImportedPolicy";

    std::string name{};
    std::optional<std::string> version{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("name", self.name);
        visitor.required("version", self.version);
    }
};

} // namespace proctor
