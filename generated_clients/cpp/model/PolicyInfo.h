/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include <string>
#include <vector>
#include "../members.h"

namespace proctor {


struct PolicyInfo {
    static constexpr char const* schema_name = "PolicyInfo";

    std::string name{}; // What the policy is called in results.
    std::optional<std::string> version{}; // Which state of it, for example a checkpoint.
    std::optional<std::string> submitter{}; // Who submits it.
    std::optional<std::string> homepage{}; // Where to read about it.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("name", self.name);
        visitor.optional("version", self.version);
        visitor.optional("submitter", self.submitter);
        visitor.optional("homepage", self.homepage);
    }
};

} // namespace proctor
