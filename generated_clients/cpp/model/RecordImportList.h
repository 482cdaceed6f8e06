/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include <string>
#include "RecordImport.h"
#include <map>
#include <vector>
#include "../members.h"

namespace proctor {


struct RecordImportList {
    static constexpr char const* schema_name = "RecordImportList";

    std::vector<RecordImport> imports{};
    std::optional<std::string> next_cursor{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("imports", self.imports);
        visitor.required("next_cursor", self.next_cursor);
    }
};

} // namespace proctor
