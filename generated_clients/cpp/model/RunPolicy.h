/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include <string>
#include <map>
#include <vector>
#include "../members.h"

namespace proctor {

/// A `PolicyInfo` as it was submitted. A run of an earlier server may have a homepage of another form.
struct RunPolicy {
    static constexpr char const* schema_name = "RunPolicy";

    std::string name{};
    std::optional<std::string> version{};
    std::optional<std::string> submitter{};
    std::optional<std::string> homepage{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("name", self.name);
        visitor.optional("version", self.version);
        visitor.optional("submitter", self.submitter);
        visitor.optional("homepage", self.homepage);
    }
};

} // namespace proctor
