/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include <string>
#include <map>
#include <vector>
#include "../members.h"

namespace proctor {


struct Checkpoint {
    static constexpr char const* schema_name = "Checkpoint";

    std::int64_t tree_size{};
    std::string root_sha256{}; // The digest of a [manifest](benchmarks.md#the-manifest), which is all of a benchmark that can change a score. It is the same on every server (BEN-006).
    std::string note{}; // The signed note, which says both as well.
    std::string keyid{}; // Of the key of `list_keys` that signed it.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("tree_size", self.tree_size);
        visitor.required("root_sha256", self.root_sha256);
        visitor.required("note", self.note);
        visitor.required("keyid", self.keyid);
    }
};

} // namespace proctor
