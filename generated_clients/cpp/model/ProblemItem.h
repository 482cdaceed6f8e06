/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include <string>
#include <map>
#include <vector>
#include "../members.h"

namespace proctor {


struct ProblemItem {
    static constexpr char const* schema_name = "ProblemItem";

    std::string pointer{}; // JSON pointer into the body, to the faulty member or a part of it; or `query:name`, `header:name`, `path:name`; or `record:name`, with the name of a file in a record, or `archive`.
    std::string detail{}; // What is wrong there.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("pointer", self.pointer);
        visitor.required("detail", self.detail);
    }
};

} // namespace proctor
